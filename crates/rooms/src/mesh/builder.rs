//! Putting a shape together, face by face.

use glam::{DVec2, DVec3};

use super::Shape;

/// A shape that is being made.
#[derive(Default)]
pub(super) struct Builder {
    pub shape: Shape,
}

impl Builder {
    /// A corner; its number.
    pub fn corner(&mut self, position: DVec3, normal: DVec3, uv: DVec2) -> u32 {
        self.shape.positions.push(position);
        self.shape.normals.push(normal);
        self.shape.uvs.push(uv);
        (self.shape.positions.len() - 1) as u32
    }

    /// A triangle of corners that are there.
    pub fn triangle(&mut self, corners: [u32; 3]) {
        self.shape.triangles.push(corners);
    }

    /// A flat convex face, its corners anticlockwise from outside. What has no area is left out. Metres along it count
    /// from the origin, so that the pattern of neighbouring faces in one plane goes on.
    pub fn face(&mut self, corners: &[DVec3]) {
        let Some(normal) = normal(corners) else {
            return;
        };
        let (across, up) = directions(normal);
        let numbers: Vec<u32> = corners
            .iter()
            .map(|it| self.corner(*it, normal, DVec2::new(it.dot(across), it.dot(up))))
            .collect();
        for pair in numbers[1..].windows(2) {
            self.triangle([numbers[0], pair[0], pair[1]]);
        }
    }
}

/// The normal of a polygon (M. E. Newell's sum); nothing without an area.
fn normal(corners: &[DVec3]) -> Option<DVec3> {
    let after = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(after)
        .map(|(a, b)| a.cross(*b))
        .sum::<DVec3>()
        .try_normalize()
}

/// Two directions along a face: level to the right as one looks at it, and up; on the level, along x and against z.
fn directions(normal: DVec3) -> (DVec3, DVec3) {
    let across = DVec3::Y.cross(normal).try_normalize().unwrap_or(DVec3::X);
    (across, normal.cross(across))
}
