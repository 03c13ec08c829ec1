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
    /// Focal factors sx and sy, near distance in metres, radius in metres (0 where flat).
    pub project: [f32; 4],
    /// Raised and sphere: curvature k per metre, offset h in radii, sinh h, cosh h. Horizon:
    /// kappa per square metre, the eye's height H in metres, S(H) in metres, C(H).
    pub curve: [f32; 4],
    /// How far a chart is drawn: along its ground from the reference, and up and down, in metres; k per metre; and
    /// padding.
    pub edge: [f32; 4],
}

impl SpaceUniform {
    /// `offset` is h in units of the radius, which is infinite or 0 where the space is flat.
    pub(crate) fn new(view: DMat4, projection: &Projection, radius_m: f64, offset: f64) -> Self {
        let (radius, k) = if radius_m.is_finite() && radius_m != 0.0 {
            (radius_m, 1.0 / radius_m)
        } else {
            (0.0, 0.0)
        };
        let project = [projection.sx, projection.sy, projection.near_m, radius];
        let curve = [k, offset, offset.sinh(), offset.cosh()];
        Self {
            view: view.as_mat4().to_cols_array_2d(),
            project: project.map(|x| x as f32),
            curve: curve.map(|x| x as f32),
            edge: [UNLIMITED_M, UNLIMITED_M, k as f32, 0.0],
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
        let curve = [kappa, lift_m, sin_k(kappa, lift_m), cos_k(kappa, lift_m)];
        let within = |x: f64| (x as f32).min(UNLIMITED_M);
        Self {
            curve: curve.map(|x| x as f32),
            edge: [within(edge.level_m), within(edge.upright_m), k as f32, 0.0],
            ..Self::new(view, projection, radius, 0.0)
        }
    }

    /// The same, whose charts are drawn so far along their ground, metres from the reference.
    pub(crate) fn within(self, level_m: f64) -> Self {
        let [_, upright_m, k, padding] = self.edge;
        Self {
            edge: [level_m as f32, upright_m, k, padding],
            ..self
        }
    }
}
