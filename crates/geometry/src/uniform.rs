//! What the shaders are told about the space: the only place where `f64` becomes `f32`.

use bytemuck::{Pod, Zeroable};
use glam::DMat4;

use crate::Projection;
use crate::scalar::{cos_k, sin_k};

/// Where the picture has no edge, in metres: farther than anything, and squared still in `f32`.
const UNLIMITED_M: f32 = 1e18;

/// How far a picture reaches, in metres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PictureEdge {
    /// Farthest level distance.
    pub level_m: f64,
    /// Greatest height.
    pub upright_m: f64,
}

/// `struct Space` of `shaders/geometry.wgsl`, byte for byte.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SpaceUniform {
    /// Columns of the matrix applied to a ported point (xyz in metres, w without unit).
    pub view: [[f32; 4]; 4],
    /// Focal factor of the picture's width.
    pub focal_x: f32,
    /// Focal factor of its height.
    pub focal_y: f32,
    /// Near distance.
    pub near_m: f32,
    /// Radius, 0 where flat.
    pub radius_m: f32,
    /// Curvature per square metre, negative where hyperbolic.
    pub kappa: f32,
    /// How high the eye's map lies over its sheet: h in radii on the raised map, H in metres on the horizon.
    pub lift: f32,
    /// sinh h, or S(H) in metres.
    pub lift_sine: f32,
    /// cosh h, or C(H).
    pub lift_cosine: f32,
    /// How far a chart is drawn along its ground from the reference.
    pub level_m: f32,
    /// How far it is drawn up and down.
    pub upright_m: f32,
    /// Root of the amount of the curvature.
    pub k_per_m: f32,
    /// A multiple of 16 bytes is asked for.
    pub padding: f32,
    /// Where the reference lies in its chart, for maps that depend on it; all zero of others.
    pub origin: [f32; 4],
}

impl SpaceUniform {
    /// `sign` is the curvature's, and `offset` h in units of the radius, which is infinite or 0 where the space is flat.
    pub(crate) fn new(
        view: DMat4,
        projection: &Projection,
        radius_m: f64,
        sign: f64,
        offset: f64,
    ) -> Self {
        let (radius, k) = if radius_m.is_finite() && radius_m != 0.0 {
            (radius_m, 1.0 / radius_m)
        } else {
            (0.0, 0.0)
        };
        Self {
            view: view.as_mat4().to_cols_array_2d(),
            focal_x: projection.sx as f32,
            focal_y: projection.sy as f32,
            near_m: projection.near_m as f32,
            radius_m: radius as f32,
            kappa: (sign * k * k) as f32,
            lift: offset as f32,
            lift_sine: offset.sinh() as f32,
            lift_cosine: offset.cosh() as f32,
            level_m: UNLIMITED_M,
            upright_m: UNLIMITED_M,
            k_per_m: k as f32,
            padding: 0.0,
            origin: [0.0; 4],
        }
    }

    /// The horizon map at a curvature per square metre, from `lift_m` metres over its sheet.
    pub(crate) fn level(
        view: DMat4,
        projection: &Projection,
        kappa: f64,
        lift_m: f64,
        edge: PictureEdge,
    ) -> Self {
        let k = kappa.abs().sqrt();
        let radius = if k > 0.0 { 1.0 / k } else { 0.0 };
        let within = |x: f64| (x as f32).min(UNLIMITED_M);
        Self {
            kappa: kappa as f32,
            lift: lift_m as f32,
            lift_sine: sin_k(kappa, lift_m) as f32,
            lift_cosine: cos_k(kappa, lift_m) as f32,
            level_m: within(edge.level_m),
            upright_m: within(edge.upright_m),
            k_per_m: k as f32,
            ..Self::new(view, projection, radius, kappa.signum(), 0.0)
        }
    }

    /// The same, whose charts are drawn so far along their ground, metres from the reference.
    pub(crate) fn within(self, level_m: f64) -> Self {
        Self {
            level_m: level_m as f32,
            ..self
        }
    }
}
