//! What the shaders are told about the space: the only place where `f64` becomes `f32`.

use bytemuck::{Pod, Zeroable};
use glam::DMat4;

use crate::Projection;

/// `struct Space` of `shaders/geometry.wgsl`, byte for byte.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SpaceUniform {
    /// Columns of the matrix applied to a ported point (xyz in metres, w without unit).
    pub view: [[f32; 4]; 4],
    /// Focal factors sx and sy, near distance in metres, radius in metres (0 where flat).
    pub project: [f32; 4],
    /// Curvature k per metre, offset h in radii, sinh h, cosh h.
    pub curve: [f32; 4],
    /// First number: 0 flat, 1 raised hyperbolic, 2 sphere; the rest is padding.
    pub kind: [u32; 4],
}

impl SpaceUniform {
    pub(crate) const FLAT: u32 = 0;
    pub(crate) const RAISED: u32 = 1;
    pub(crate) const SPHERE: u32 = 2;

    /// `offset` is h in units of the radius.
    pub(crate) fn new(
        kind: u32,
        view: DMat4,
        projection: &Projection,
        radius_m: f64,
        offset: f64,
    ) -> Self {
        let (radius, k) = if kind == Self::FLAT {
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
            kind: [kind, 0, 0, 0],
        }
    }
}
