//! Sun, moon and stars: those of a sky, and the two that stand in a closed world.

use std::f32::consts::TAU;

use antipode_frame::Sky;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, RenderPass, RenderPipeline};

use crate::draw_list::DrawCount;

/// Stars over the whole sphere.
const STARS: u32 = 2600;
/// Stars fainter than this share are not drawn.
pub const FAINTEST: f32 = 0.01;
/// Sun and moon.
const ORBS: u32 = 2;
/// Corners of a patch.
const CORNERS: u32 = 6;

/// A star; the attributes of celestial.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Star {
    /// Unit direction when the sun rises.
    pub direction: [f32; 3],
    /// Linear light, and half the width in pixels.
    pub light: [f32; 4],
}

impl Star {
    /// Attributes from location 0 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 2] =
        wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x4];
}

/// The pipelines of the three.
#[derive(Debug)]
pub struct CelestialPipelines {
    /// The sun.
    pub sun: RenderPipeline,
    /// The moon.
    pub moon: RenderPipeline,
    /// All stars.
    pub star: RenderPipeline,
    /// Sun and moon of a closed world.
    pub orb: RenderPipeline,
}

/// The stars on the adapter.
#[derive(Debug)]
pub struct Celestial {
    stars: Buffer,
}

impl Celestial {
    /// Uploads the stars.
    pub fn new(device: &Device) -> Self {
        let stars: Vec<Star> = (0..STARS).map(star).collect();
        let stars = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("stars"),
            contents: bytemuck::cast_slice(&stars),
            usage: BufferUsages::VERTEX,
        });
        Self { stars }
    }

    /// Draws what is up; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        sky: &Sky,
        pipelines: &CelestialPipelines,
    ) -> DrawCount {
        if sky.orbs.is_some() {
            pass.set_pipeline(&pipelines.orb);
            pass.draw(0..CORNERS, 0..ORBS);
            return DrawCount {
                triangles: (ORBS * CORNERS / 3) as usize,
                draws: 1,
            };
        }
        let mut patches = 0;
        let mut draws = 0;
        let mut patch = |pass: &mut RenderPass<'_>, pipeline: &RenderPipeline, count: u32| {
            pass.set_pipeline(pipeline);
            pass.draw(0..CORNERS, 0..count);
            patches += count as usize;
            draws += 1;
        };
        if sky.stars > FAINTEST {
            pass.set_vertex_buffer(0, self.stars.slice(..));
            patch(pass, &pipelines.star, STARS);
        }
        patch(pass, &pipelines.moon, 1);
        patch(pass, &pipelines.sun, 1);
        DrawCount {
            triangles: patches * CORNERS as usize / 3,
            draws,
        }
    }
}

/// The same stars every time, by hashing their numbers.
fn star(index: u32) -> Star {
    let height = 2.0 * scatter(index, 0x9e37_79b1) - 1.0;
    let turn = TAU * scatter(index, 0x85eb_ca77);
    let level = (1.0 - height * height).max(0.0).sqrt();
    let direction = Vec3::new(level * turn.cos(), height, level * turn.sin());
    // Few are bright: brightness falls with a high power of an even share.
    let bright = scatter(index, 0xc2b2_ae3d).powi(9);
    let warmth = scatter(index, 0x27d4_eb2f) - 0.5;
    let light = Vec3::new(0.92 + 0.16 * warmth, 0.94, 1.0 - 0.22 * warmth) * (0.10 + 1.5 * bright);
    Star {
        direction: direction.into(),
        light: light.extend(0.85 + 1.25 * bright.sqrt()).into(),
    }
}

/// An even share from 0 to 1 of an index, by integer hashing (C. Wellons' lowbias32).
fn scatter(index: u32, salt: u32) -> f32 {
    let mut h = index.wrapping_mul(0x9e37_79b9) ^ salt;
    h = (h ^ (h >> 16)).wrapping_mul(0x7feb_352d);
    h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
    ((h ^ (h >> 16)) >> 8) as f32 / (1 << 24) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stars_are_spread_evenly_and_few_are_bright() {
        let stars: Vec<Star> = (0..STARS).map(star).collect();
        let mean = stars.iter().map(|s| Vec3::from(s.direction)).sum::<Vec3>() / STARS as f32;
        assert!(mean.length() < 0.05, "{mean}");
        assert!(
            stars
                .iter()
                .all(|s| (Vec3::from(s.direction).length() - 1.0).abs() < 1e-5)
        );
        let bright = stars.iter().filter(|s| s.light[1] > 0.6).count();
        assert!((40..400).contains(&bright), "{bright}");
    }

    #[test]
    fn stars_stand_where_they_stood() {
        assert_eq!(star(7), star(7));
        assert_ne!(star(7).direction, star(8).direction);
    }
}
