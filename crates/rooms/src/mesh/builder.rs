//! Putting a shape together, face by face.

use glam::{DVec2, DVec3};

use super::Shape;

/// A shape that is being made.
#[derive(Default)]
pub(super) struct Builder {
    pub shape: Shape,
    /// Half the lengths of a solid along its axes: pictures on it begin at its edges. Zero lets them begin at its middle.
    pub half: DVec3,
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
    /// from the upper left edge of the whole solid, to the right and down as pixels do, so that the pattern of neighbouring faces in one plane goes on.
    pub fn face(&mut self, corners: &[DVec3]) {
        let Some(normal) = normal(corners) else {
            return;
        };
        let (across, up) = directions(normal);
        // Of a box about the origin x . w is least at -h . |w|.
        let along = |at: DVec3, way: DVec3| at.dot(way) + self.half.dot(way.abs());
        let uv = |at: &DVec3| DVec2::new(along(*at, across), along(*at, -up));
        let uvs: Vec<_> = corners.iter().map(uv).collect();
        let all = corners.iter().zip(uvs);
        let numbers: Vec<u32> = all.map(|(it, uv)| self.corner(*it, normal, uv)).collect();
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
