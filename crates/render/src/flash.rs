//! The flash at the gun's muzzle: a star of thin spikes, the longest of them ahead.

use std::f32::consts::TAU;

use glam::Vec3;

use crate::models::{ModelVertex, Shape, Switch};

/// Spikes around the barrel.
const SPIKES: usize = 7;
/// Half the width of a spike where it begins, metres.
const HALF_WIDTH_M: f32 = 0.024;
/// Length of the spike ahead, metres.
const AHEAD_M: f32 = 0.26;
/// Lengths of the others by turns, metres.
const AROUND_M: [f32; 2] = [0.14, 0.09];
/// How far the others lean ahead, as a slope.
const LEAN: f32 = 0.55;
const COLOUR: [u8; 4] = [255, 214, 128, 0];

/// The star about the muzzle, which points along x.
pub fn shape() -> Shape {
    let mut shape = Shape::default();
    spike(&mut shape, Vec3::X * AHEAD_M, 2.0);
    for i in 0..SPIKES {
        let (sin, cos) = (TAU * i as f32 / SPIKES as f32).sin_cos();
        let way = Vec3::new(LEAN, sin, cos).normalize();
        spike(&mut shape, way * AROUND_M[i % AROUND_M.len()], 1.0);
    }
    shape
}

/// A pyramid of three sides from the middle to a tip.
fn spike(shape: &mut Shape, tip: Vec3, width: f32) {
    let (a, b) = tip.normalize().any_orthonormal_pair();
    let corner = |i: usize| {
        let (sin, cos) = (TAU * i as f32 / 3.0).sin_cos();
        (a * cos + b * sin) * (HALF_WIDTH_M * width)
    };
    for i in 0..3 {
        let corners = [corner(i), corner(i + 1), tip];
        let normal = (corners[1] - corners[0])
            .cross(corners[2] - corners[0])
            .normalize();
        for position in corners {
            shape.solid.push(shape.vertices.len() as u16);
            let [x, y, z] = (normal * f32::from(i16::MAX)).round().to_array();
            shape.vertices.push(ModelVertex {
                position: position.into(),
                normal: [x as i16, y as i16, z as i16, i16::MAX],
                colour: COLOUR,
                switch: Switch::Always as u32,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_side_of_a_spike_faces_outwards() {
        let shape = shape();
        for corners in shape.solid.chunks_exact(3) {
            let at = |i: usize| Vec3::from(shape.vertices[usize::from(corners[i])].position);
            let (a, b, tip) = (at(0), at(1), at(2));
            let outwards = (a + b) / 2.0;
            assert!((b - a).cross(tip - a).dot(outwards) > 0.0, "{a} {b} {tip}");
        }
    }
}
