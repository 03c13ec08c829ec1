//! Rounded solids as triangles: everything that is not land is put together from them.

use std::f32::consts::{PI, TAU};

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// A vertex of a model; the attributes of figure.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct ModelVertex {
    /// Metres; x ahead, y up from the feet, z to the right.
    pub position: [f32; 3],
    /// Unit normal, signed normalised; the last is how much it glows, 0 to 1.
    pub normal: [i16; 4],
    /// sRGB, then gloss.
    pub colour: [u8; 4],
    /// Height of the joint it swings about in metres, and its signed share of the swing.
    pub swing: [f32; 2],
}

impl ModelVertex {
    /// Attributes from location 0 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 4] =
        wgpu::vertex_attr_array![0 => Float32x3, 1 => Snorm16x4, 2 => Unorm8x4, 3 => Float32x2];
}

/// Triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default)]
pub struct Solid {
    /// Vertices.
    pub vertices: Vec<ModelVertex>,
    /// Three indices for each triangle.
    pub indices: Vec<u16>,
}

/// How a part of a model looks and moves.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Middle, metres.
    pub centre: Vec3,
    /// Half extents, metres.
    pub radii: Vec3,
    /// 1 is an ellipsoid; towards 0 it becomes a box with rounded edges.
    pub roundness: f32,
    /// sRGB, then gloss.
    pub colour: [u8; 4],
    /// Height of the joint in metres, and the signed share of the swing.
    pub swing: [f32; 2],
    /// How much it shines by itself, 0 to 1.
    pub glow: f32,
}

impl Solid {
    /// Adds a superellipsoid of `rings` by `sides` patches (A. Barr, "Superquadrics and angle-preserving
    /// transformations", 1981): the sphere's sines and cosines raised to the roundness, with Barr's normals.
    pub fn add(&mut self, part: &Part, rings: u16, sides: u16) {
        let first = self.vertices.len() as u16;
        for ring in 0..=rings {
            let latitude = PI * (f32::from(ring) / f32::from(rings) - 0.5);
            for side in 0..=sides {
                // The seam's two copies must be the same to the last bit.
                let longitude = TAU * f32::from(side % sides) / f32::from(sides);
                self.vertices.push(patch_corner(part, latitude, longitude));
            }
        }
        for ring in 0..rings {
            for side in 0..sides {
                let a = first + ring * (sides + 1) + side;
                let b = a + sides + 1;
                if ring > 0 {
                    self.indices.extend([a, b, a + 1]);
                }
                if ring + 1 < rings {
                    self.indices.extend([a + 1, b, b + 1]);
                }
            }
        }
    }
}

/// `|x|^e` with the sign of x.
fn signed_power(x: f32, exponent: f32) -> f32 {
    x.abs().powf(exponent).copysign(x)
}

fn patch_corner(part: &Part, latitude: f32, longitude: f32) -> ModelVertex {
    let shape = |exponent: f32| {
        let level = signed_power(latitude.cos().max(0.0), exponent);
        Vec3::new(
            level * signed_power(longitude.cos(), exponent),
            signed_power(latitude.sin(), exponent),
            level * signed_power(longitude.sin(), exponent),
        )
    };
    let normal = (shape(2.0 - part.roundness) / part.radii).normalize_or(Vec3::Y);
    let snorm = |x: f32| (x * f32::from(i16::MAX)).round() as i16;
    ModelVertex {
        position: (part.centre + part.radii * shape(part.roundness)).into(),
        normal: [
            snorm(normal.x),
            snorm(normal.y),
            snorm(normal.z),
            snorm(part.glow),
        ],
        colour: part.colour,
        swing: part.swing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solid(roundness: f32) -> Solid {
        let mut solid = Solid::default();
        let part = Part {
            centre: Vec3::new(0.5, 1.0, -2.0),
            radii: Vec3::new(0.3, 0.8, 0.5),
            roundness,
            colour: [1, 2, 3, 4],
            swing: [0.0, 0.0],
            glow: 0.0,
        };
        solid.add(&part, 8, 12);
        solid
    }

    #[test]
    fn triangles_and_normals_face_outwards() {
        for roundness in [1.0, 0.4] {
            let solid = solid(roundness);
            let at = |i: u16| Vec3::from(solid.vertices[i as usize].position);
            for t in solid.indices.chunks_exact(3) {
                let (a, b, c) = (at(t[0]), at(t[1]), at(t[2]));
                let face = (b - a).cross(c - a);
                let middle = (a + b + c) / 3.0 - Vec3::new(0.5, 1.0, -2.0);
                assert!(face.dot(middle) > 0.0, "{roundness}: {t:?}");
                let [x, y, z, _] = solid.vertices[t[0] as usize].normal.map(f32::from);
                assert!(Vec3::new(x, y, z).dot(a - Vec3::new(0.5, 1.0, -2.0)) > 0.0);
            }
        }
    }

    #[test]
    fn it_fills_its_box_and_no_more() {
        let solid = solid(0.4);
        let least = solid
            .vertices
            .iter()
            .map(|v| Vec3::from(v.position))
            .reduce(Vec3::min)
            .unwrap_or_default();
        let most = solid
            .vertices
            .iter()
            .map(|v| Vec3::from(v.position))
            .reduce(Vec3::max)
            .unwrap_or_default();
        assert!(
            (least - Vec3::new(0.2, 0.2, -2.5)).length() < 1e-4,
            "{least}"
        );
        assert!((most - Vec3::new(0.8, 1.8, -1.5)).length() < 1e-4, "{most}");
    }
}
