//! A unit sphere as triangles.

use std::f32::consts::{PI, TAU};

/// Corners of `rings` by `sides` patches from pole to pole and around, and three indices for each triangle,
/// counter-clockwise seen from outside.
pub fn ball(rings: u16, sides: u16) -> (Vec<[f32; 3]>, Vec<u16>) {
    let mut corners = Vec::new();
    let mut indices = Vec::new();
    for ring in 0..=rings {
        let latitude = PI * (f32::from(ring) / f32::from(rings) - 0.5);
        let level = latitude.cos().max(0.0);
        for side in 0..=sides {
            // The seam's two copies must be the same to the last bit.
            let (sin, cos) = (TAU * f32::from(side % sides) / f32::from(sides)).sin_cos();
            corners.push([level * cos, latitude.sin(), level * sin]);
        }
    }
    for ring in 0..rings {
        for side in 0..sides {
            let a = ring * (sides + 1) + side;
            let b = a + sides + 1;
            if ring > 0 {
                indices.extend([a, b, a + 1]);
            }
            if ring + 1 < rings {
                indices.extend([a + 1, b, b + 1]);
            }
        }
    }
    (corners, indices)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn its_corners_are_on_the_sphere_and_its_triangles_face_outwards() {
        let (corners, indices) = ball(8, 12);
        let at = |i: u16| Vec3::from(corners[usize::from(i)]);
        assert!(
            corners
                .iter()
                .all(|c| (Vec3::from(*c).length() - 1.0).abs() < 1e-6)
        );
        assert_eq!(indices.len(), 3 * 12 * (2 * 8 - 2));
        for t in indices.chunks_exact(3) {
            let (a, b, c) = (at(t[0]), at(t[1]), at(t[2]));
            assert!((b - a).cross(c - a).dot(a + b + c) > 0.0, "{t:?}");
        }
    }
}
