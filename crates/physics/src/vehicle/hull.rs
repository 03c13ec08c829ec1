//! The body of a vehicle as the physics sees it: one convex hull, and the box that must be free where it is put.

use glam::{DQuat, DVec3, Vec3};
use rapier3d::parry::shape::SharedShape;

/// The hull's corners on the right-hand side, metres in the vehicle's axes; the left is its mirror image. Nose and tail
/// are cut up so that slopes are driven onto; the sides stand as far out as the mudguards.
const CORNERS_M: [[f32; 3]; 12] = [
    [1.15, 0.30, 0.45],
    [-1.15, 0.30, 0.45],
    [1.52, 0.52, 0.50],
    [-1.52, 0.52, 0.50],
    [1.30, 0.50, 0.70],
    [-1.30, 0.50, 0.70],
    [1.30, 0.78, 0.70],
    [-1.30, 0.78, 0.70],
    [1.52, 0.76, 0.40],
    [-1.52, 0.80, 0.40],
    [0.36, 1.49, 0.46],
    [-0.80, 1.49, 0.46],
];
/// Rounding of the hull's edges, in metres.
const ROUND_M: f32 = 0.02;
/// Half of the box that holds body and wheels, and its middle above the ground, in metres.
const HALF_BOX_M: Vec3 = Vec3::new(1.54, 0.70, 0.74);
const BOX_MIDDLE_M: f32 = 0.82;

/// The hull and what is made of it once.
#[derive(Clone)]
pub(super) struct Hull {
    pub shape: SharedShape,
    /// The box that must be free of ground where a vehicle is put.
    pub free_box: SharedShape,
    corners: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

impl Hull {
    /// Of a car.
    pub fn new() -> Self {
        let corners: Vec<Vec3> = CORNERS_M
            .into_iter()
            .flat_map(|[x, y, z]| [Vec3::new(x, y, z), Vec3::new(x, y, -z)])
            .collect();
        // The corners are ours and span a body; a box is as good for corners that would not.
        let half = HALF_BOX_M - Vec3::splat(ROUND_M);
        let shape = SharedShape::convex_hull(&corners)
            .unwrap_or_else(|| SharedShape::cuboid(half.x, half.y, half.z));
        let (corners, triangles) = shape
            .as_convex_polyhedron()
            .map(rapier3d::parry::shape::ConvexPolyhedron::to_trimesh)
            .unwrap_or_default();
        Self {
            shape,
            free_box: SharedShape::cuboid(HALF_BOX_M.x, HALF_BOX_M.y, HALF_BOX_M.z),
            corners: corners.into_iter().map(Vec3::as_dvec3).collect(),
            triangles,
        }
    }

    /// Where the middle of the free box is for a vehicle at `place`.
    pub fn box_middle(place: DVec3, turn: DQuat) -> DVec3 {
        place + turn * (DVec3::Y * f64::from(BOX_MIDDLE_M))
    }

    /// The hull's triangles with a vehicle at `place` (m), counter-clockwise seen from outside.
    pub fn triangles(&self, place: DVec3, turn: DQuat) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        self.triangles
            .iter()
            .map(move |corners| corners.map(|corner| place + turn * self.corners[corner as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_is_closed_and_faces_outwards() {
        let hull = Hull::new();
        assert!(hull.triangles.len() >= 12, "{}", hull.triangles.len());
        let middle = DVec3::Y * 0.8;
        for [a, b, c] in hull.triangles(DVec3::ZERO, DQuat::IDENTITY) {
            let outwards = (b - a).cross(c - a).dot(a - middle);
            assert!(outwards > 0.0, "{a} {b} {c}");
        }
    }
}
