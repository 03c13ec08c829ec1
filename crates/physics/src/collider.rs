//! Terrain as the physics sees it: a triangle mesh with its bounding-volume tree.
//!
//! Building the tree is the costly part, so a collider is built on a chunk worker and then only
//! handed over: it is `Send + Sync` and a clone shares the mesh.

use glam::Vec3;
use rapier3d::parry::bounding_volume::Aabb;
use rapier3d::parry::shape::{SharedShape, TriMesh};

/// Triangles with less than twice this area (m^2) are points or lines to the physics.
const LEAST_DOUBLE_AREA_M2: f32 = 1e-9;

/// The collision mesh of one chunk, in metres from the chunk's origin. Cheap to clone.
#[derive(Clone)]
pub struct TerrainCollider {
    shape: SharedShape,
    bounds: Aabb,
    triangles: usize,
}

impl TerrainCollider {
    /// Builds a collider from vertices in metres (local to the chunk) and triangles that index
    /// them, counter-clockwise seen from the air: the character stands on that side only.
    ///
    /// Degenerate triangles, and those with an index out of range or a vertex that is not finite,
    /// are left out. Returns `None` when no triangle remains.
    pub fn build(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Self> {
        let vertices: Vec<Vec3> = positions.iter().copied().map(Vec3::from_array).collect();
        let kept: Vec<[u32; 3]> = triangles
            .iter()
            .copied()
            .filter(|&triangle| is_sound(&vertices, triangle))
            .collect();
        // A vertex that no kept triangle uses still counts in no bound: the tree holds triangles.
        let mesh = TriMesh::new(vertices, kept).ok()?;
        let bounds = mesh.local_aabb();
        let triangles = mesh.num_triangles();
        Some(Self {
            shape: SharedShape::new(mesh),
            bounds,
            triangles,
        })
    }

    /// How many triangles the mesh holds.
    pub fn triangle_count(&self) -> usize {
        self.triangles
    }

    pub(crate) fn shape(&self) -> &SharedShape {
        &self.shape
    }

    pub(crate) fn mesh(&self) -> Option<&TriMesh> {
        self.shape.as_trimesh()
    }

    pub(crate) fn bounds(&self) -> &Aabb {
        &self.bounds
    }
}

impl std::fmt::Debug for TerrainCollider {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TerrainCollider")
            .field("triangles", &self.triangles)
            .finish_non_exhaustive()
    }
}

fn is_sound(vertices: &[Vec3], triangle: [u32; 3]) -> bool {
    let [Some(a), Some(b), Some(c)] = triangle.map(|index| vertices.get(index as usize)) else {
        return false;
    };
    let double_area = (*b - *a).cross(*c - *a).length();
    double_area.is_finite() && double_area > LEAST_DOUBLE_AREA_M2
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    const SQUARE: [[f32; 3]; 4] = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
    ];

    #[test]
    fn a_collider_crosses_threads_and_shares_its_mesh() {
        fn crosses<T: Send + Sync + Clone + 'static>(_: &T) {}
        let collider = TerrainCollider::build(&SQUARE, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        crosses(&collider);
        let copy = collider.clone();
        assert!(std::ptr::addr_eq(
            copy.shape().0.as_ref(),
            collider.shape().0.as_ref()
        ));
        assert_eq!(copy.triangle_count(), 2);
    }

    #[test]
    fn unsound_triangles_are_left_out() {
        let mut points = SQUARE.to_vec();
        points.push([f32::NAN, 0.0, 0.0]);
        let triangles = [[0, 1, 2], [0, 0, 1], [0, 1, 4], [0, 1, 99]];
        assert_eq!(
            TerrainCollider::build(&points, &triangles)
                .unwrap()
                .triangle_count(),
            1
        );
    }

    #[test]
    fn nothing_to_stand_on_is_no_collider() {
        assert!(TerrainCollider::build(&[], &[]).is_none());
        assert!(TerrainCollider::build(&SQUARE, &[[1, 1, 1]]).is_none());
    }
}
