//! What the shaders are told about the space: the only place where `f64` becomes `f32`.

use bytemuck::{Pod, Zeroable};
use glam::DMat4;

use crate::Projection;
use crate::scalar::{cos_k, sin_k};

/// Where the picture has no edge, in metres: farther than anything, and squared still in `f32`.
const UNLIMITED_M: f32 = 1e18;

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
    /// Horizon: farthest level distance and greatest height that are shown, in metres; k per
    /// metre; and padding.
    pub edge: [f32; 4],
    /// First number: 0 flat, 1 raised hyperbolic, 2 sphere, 3 horizon; the rest is padding.
    pub kind: [u32; 4],
}

impl SpaceUniform {
    pub(crate) const FLAT: u32 = 0;
    pub(crate) const RAISED: u32 = 1;
    /// `kind[0]` of a closed world.
    pub const SPHERE: u32 = 2;
    /// The number of the horizon map in `kind`.
    pub const HORIZON: u32 = 3;

    /// `offset` is h in units of the radius.
    pub(crate) fn new(
        kind: u32,
        view: DMat4,
        projection: &Projection,
        radius_m: f64,
        offset: f64,
    ) -> Self {
        let (radius, k) = if kind == Self::FLAT || radius_m == 0.0 {
            (0.0, 0.0)
        } else {
            (radius_m, 1.0 / radius_m)
        };
        let project = [projection.sx, projection.sy, projection.near_m, radius];
        let curve = [k, offset, offset.sinh(), offset.cosh()];
        Self {
            view: view.as_mat4().to_cols_array_2d(),
            project: project.map(|x| x as f32),
            curve: curve.map(|x| x as f32),
            edge: [UNLIMITED_M, UNLIMITED_M, k as f32, 0.0],
            kind: [kind, 0, 0, 0],
        }
    }

    /// The horizon map at a curvature per square metre, from `lift_m` metres over its sheet.
    pub(crate) fn level(
        view: DMat4,
        projection: &Projection,
        kappa: f64,
        lift_m: f64,
        (level_m, upright_m): (f64, f64),
    ) -> Self {
        let k = kappa.abs().sqrt();
        let radius = if k > 0.0 { 1.0 / k } else { 0.0 };
        let curve = [kappa, lift_m, sin_k(kappa, lift_m), cos_k(kappa, lift_m)];
        let within = |x: f64| (x as f32).min(UNLIMITED_M);
        Self {
            curve: curve.map(|x| x as f32),
            edge: [within(level_m), within(upright_m), k as f32, 0.0],
            ..Self::new(Self::HORIZON, view, projection, radius, 0.0)
        }
    }
}
