//! Colours of the ground.
//!
//! Heights give the biome's low, middle and high ground, with borders that wander; steep
//! faces show rock with strata. Colours are mixed in linear light and stored as sRGB.

use antipode_geometry::ChartPoint;
use glam::{FloatExt, Vec3};

use crate::biome::Palette;
use crate::field::Field;

/// Half width of the border between two kinds of ground, metres of height.
const BLEND_M: f32 = 2.5;
/// How far noise moves the borders up and down, metres.
const WANDER_M: f32 = 2.0;
/// Frequency of the wandering, in the noise's own units: waves of 8 to 13 m.
const WANDER_FREQUENCY: f64 = 0.8;
/// Frequency of the mottling: waves of 2 to 4 m.
const MOTTLE_FREQUENCY: f64 = 3.1;
/// Mottling lightens and darkens by this share.
const MOTTLE_SHARE: f32 = 0.10;
/// `1 - normal.y` where rock begins to show and where it is all there is: 46 and 67 degrees.
const STEEP: (f32, f32) = (0.30, 0.60);
/// Strata, radians per metre of height: a bed every 2.6 m.
const STRATA_RAD_PER_M: f32 = 2.4;
/// How far wandering bends the strata, radians.
const STRATA_BEND_RAD: f32 = 2.0;

/// Paints the ground of one field.
#[derive(Debug)]
pub(crate) struct Painter<'a> {
    field: &'a Field,
    low: Vec3,
    middle: Vec3,
    high: Vec3,
    rock: Vec3,
    strata: Vec3,
    /// A height becomes `(y - offset_m) * scale` in the biome's own heights.
    offset_m: f64,
    scale: f64,
}

impl<'a> Painter<'a> {
    pub(crate) fn new(field: &'a Field) -> Self {
        let Palette {
            bottom,
            middle,
            top,
            rock,
            strata,
        } = field.biome().palette;
        let (lowest, highest) = field.ground_range_m();
        Self {
            field,
            low: linear(bottom),
            middle: linear(middle),
            high: linear(top),
            rock: linear(rock),
            strata: linear(strata),
            offset_m: lowest,
            scale: 2.0 * field.biome().max_amplitude_m() / (highest - lowest),
        }
    }

    pub(crate) fn rim_m(&self) -> Option<f64> {
        self.field.rim_m()
    }

    /// The colour of ground at a point with a unit normal: sRGB and 255.
    pub(crate) fn paint(&self, point: ChartPoint, normal: Vec3) -> [u8; 4] {
        let place = self.field.strategy().noise_point(point);
        let lattice = self.field.lattice();
        let wander = lattice.at(place, WANDER_FREQUENCY);
        let mottle = lattice.at(place, MOTTLE_FREQUENCY);
        let height = ((point.pos.y - self.offset_m) * self.scale) as f32;

        let level = height + WANDER_M * wander;
        let biome = self.field.biome();
        let above = |border: f64| rises(border as f32 - BLEND_M, border as f32 + BLEND_M, level);
        let ground = self
            .low
            .lerp(self.middle, above(biome.middle_m()))
            .lerp(self.high, above(biome.top_m()));

        let wave = (height * STRATA_RAD_PER_M + wander * STRATA_BEND_RAD).sin();
        let rock = self.rock.lerp(self.strata, rises(-0.2, 0.8, wave));
        let steepness = rises(STEEP.0, STEEP.1, 1.0 - normal.y + 0.1 * mottle);
        encoded(ground.lerp(rock, steepness) * (1.0 + MOTTLE_SHARE * mottle))
    }
}

/// 0 up to `from`, 1 after `to`, smooth between.
fn rises(from: f32, to: f32, x: f32) -> f32 {
    let t = x.remap(from, to, 0.0, 1.0).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// sRGB to linear light (IEC 61966-2-1).
fn linear(srgb: [u8; 3]) -> Vec3 {
    Vec3::from(srgb.map(|c| {
        let c = f32::from(c) / 255.0;
        if c <= 0.040_45 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    }))
}

/// Linear light to sRGB, and 255.
fn encoded(linear: Vec3) -> [u8; 4] {
    let [r, g, b] = linear.to_array().map(|c| {
        let srgb = if c <= 0.003_130_8 {
            c * 12.92
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        };
        (srgb * 255.0).round() as u8
    });
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_linear_light() {
        for c in 0..=255 {
            assert_eq!(encoded(linear([c, 0, 255 - c])), [c, 0, 255 - c, 255]);
        }
    }

    #[test]
    fn borders_rise_smoothly_and_once() {
        assert_eq!(rises(10.0, 15.0, 9.9), 0.0);
        assert_eq!(rises(10.0, 15.0, 15.1), 1.0);
        let values: Vec<_> = (0..50)
            .map(|n| rises(10.0, 15.0, 10.0 + 0.1 * n as f32))
            .collect();
        assert!(values.is_sorted());
        assert!((values[25] - 0.5).abs() < 1e-5);
    }
}
