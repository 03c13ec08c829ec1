//! Colours of the ground.
//!
//! Heights give the biome's low, middle and high ground, with borders that wander; steep
//! faces show rock with strata. Over that lies the tint of the kind of ground. Colours are mixed in linear light and
//! stored as sRGB.

use std::cell::RefCell;

use antipode_geometry::ChartPoint;
use glam::{Vec3, Vec4};

use crate::climate::Climate;
use crate::field::Field;
use crate::light::LightTables;
use crate::memo::{Places, Waves};
use crate::sites::{Paint, Sites};
use crate::tint::{self, tint_of};

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
/// Strata, radians per metre of height: a bed every 2.6 m. Closer beds would fall between vertices, which are a metre
/// apart, and show as patches.
const STRATA_RAD_PER_M: f32 = 2.4;
/// How far wandering bends the strata, radians.
const STRATA_BEND_RAD: f32 = 2.0;

/// What hollows keep of the light from all around, which is most of what an eye goes by at noon: they are darker by so much per
/// 1/m of the Laplacian, at most by so much, and ridges lighter at most by so much.
const HOLLOW_SHARE_M: f32 = 0.28;
const HOLLOW_MOST: f32 = 0.32;
const RIDGE_MOST: f32 = 0.14;

/// Paints the ground of one field.
#[derive(Debug)]
pub(crate) struct Painter<'a> {
    field: &'a Field,
    light: &'static LightTables,
    /// Of all land, if it is of one biome; what places are like is in the memo else.
    paint: Paint,
    climate: Option<&'a Climate>,
    /// A height becomes `(y - offset_m) * scale` in the biome's own heights.
    offset_m: f64,
    scale: f64,
    /// Strata, radians per metre of the biome's own heights.
    strata_rad_per_m: f32,
    /// Neighbouring vertices need nearly the same.
    memo: RefCell<Memo>,
}

#[derive(Debug)]
struct Memo {
    places: Places,
    waves: Waves,
    sites: Option<Sites<Paint>>,
}

/// How much of each kind of ground shows at a point, 0 to 1, and the noise that decided it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shares {
    paint: Paint,
    /// In the biome's own heights, metres.
    height: f32,
    wander: f32,
    mottle: f32,
    /// Of middle ground over low ground.
    pub middle: f32,
    /// Of high ground over both.
    pub high: f32,
    /// Of rock over all.
    pub rock: f32,
    /// Of what the skin shows where it is steep.
    steep: f32,
}

impl<'a> Painter<'a> {
    pub(crate) fn new(field: &'a Field) -> Self {
        let climate = field.climate().map(|it| &**it);
        let (offset_m, scale) = field.own_heights();
        Self {
            field,
            light: LightTables::get(),
            paint: Paint::new(&field.alone().palette, field.alone().levels_alone_m()),
            climate,
            offset_m,
            scale,
            strata_rad_per_m: STRATA_RAD_PER_M / scale as f32,
            memo: RefCell::new(Memo {
                places: Places::new(),
                waves: Waves::new([WANDER_FREQUENCY, MOTTLE_FREQUENCY]),
                sites: climate.map(Sites::new),
            }),
        }
    }

    /// The colour of ground at a point with a unit normal, of a kind as the fourth byte of vertices says it and so hollow, 1/m:
    /// sRGB, and that byte.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    pub(crate) fn paint(&self, point: ChartPoint, normal: Vec3, kind: u8, hollow: f32) -> [u8; 4] {
        let at = self.shares(point, normal);
        let paint = &at.paint;
        let ground = paint
            .low
            .lerp(paint.middle, at.middle)
            .lerp(paint.high, at.high);
        let colour = if at.rock > 0.0 {
            let wave = sine(at.height * self.strata_rad_per_m + at.wander * STRATA_BEND_RAD);
            let rock = paint.rock.lerp(paint.strata, rises(-0.2, 1.0, wave));
            ground.lerp(rock, at.rock)
        } else {
            ground
        };
        let biome = colour * (1.0 + MOTTLE_SHARE * at.mottle);
        let tint = tint_of(kind, at.steep);
        let worn = 1.0 - (HOLLOW_SHARE_M * hollow).clamp(-RIDGE_MOST, HOLLOW_MOST);
        let [r, g, b, _] = self.light.bytes((biome * (1.0 - tint.w) + tint) * worn);
        [r, g, b, kind]
    }

    /// How much of each kind of ground shows at a point with a unit normal.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    pub(crate) fn shares(&self, point: ChartPoint, normal: Vec3) -> Shares {
        let Memo {
            places,
            waves,
            sites,
        } = &mut *self.memo.borrow_mut();
        let paint = match (sites, self.climate) {
            (Some(sites), Some(climate)) => sites.at(self.field, climate, point),
            _ => self.paint,
        };
        let lattice = self.field.lattice();
        let [wander, mottle] = match self.field.spot(point.chart, point.pos.x, point.pos.z) {
            Some(spot) => waves.over(lattice, &spot, point.pos.y),
            None => waves.at(lattice, places.at(self.field, point)),
        };
        let height = ((point.pos.y - self.offset_m) * self.scale) as f32;

        let level = height + WANDER_M * wander;
        let steepness = 1.0 - normal.y;
        let x = Vec4::new(level, level, steepness + 0.1 * mottle, steepness);
        let from = paint.levels_m - FROM;
        let shown = rise(from, RISE, x);
        Shares {
            paint,
            height,
            wander,
            mottle,
            middle: shown.x,
            high: shown.y,
            rock: shown.z,
            steep: shown.w,
        }
    }
}

/// By how much middle and high ground begin to show below their levels, and less than nothing where rock and the steep tint
/// begin to show, `1 - normal.y`.
const FROM: Vec4 = Vec4::new(BLEND_M, BLEND_M, -STEEP.0, -tint::STEEP);
/// By how much more of each nothing else shows, one over that: see [`FROM`].
const RISE: Vec4 = Vec4::new(
    0.5 / BLEND_M,
    0.5 / BLEND_M,
    1.0 / (STEEP.1 - STEEP.0),
    tint::PER_STEEPER,
);

/// 0 up to `from`, 1 from `1 / slope` after it on, smooth between; of four.
#[inline]
fn rise(from: Vec4, slope: Vec4, x: Vec4) -> Vec4 {
    let t = ((x - from) * slope).clamp(Vec4::ZERO, Vec4::ONE);
    t * t * (3.0 - 2.0 * t)
}

/// 0 up to `from`, 1 from `1 / slope` after it on, smooth between.
#[inline]
fn rises(from: f32, slope: f32, x: f32) -> f32 {
    let t = ((x - from) * slope).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The sine, to a thousandth: whole turns off, then a parabola for each half turn and its own
/// square to bend it right.
#[inline]
fn sine(radians: f32) -> f32 {
    /// Adding this to a number of turns leaves no room for a fraction.
    const ROUNDS: f32 = 12_582_912.0;
    let turns = radians * (0.5 * std::f32::consts::FRAC_1_PI);
    let t = turns - ((turns + ROUNDS) - ROUNDS);
    let wave = t * (8.0 - 16.0 * t.abs());
    wave * (0.776 + 0.224 * wave.abs())
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};
    use glam::DVec3;
    use noise::{NoiseFn, Perlin};

    use super::*;
    use crate::fractal::AXIS_FREQUENCY;
    use crate::generator::Generator;
    use crate::lattice::table_seed;
    use crate::light::linear;

    #[test]
    fn the_quick_sine_is_a_sine() {
        for n in -4000..4000 {
            let x = n as f32 * 0.037;
            assert!((sine(x) - x.sin()).abs() < 1.2e-3, "{x}");
        }
    }

    #[test]
    fn borders_rise_smoothly_and_once() {
        assert_eq!(rises(10.0, 0.2, 9.9), 0.0);
        assert_eq!(rises(10.0, 0.2, 15.1), 1.0);
        let values: Vec<_> = (0..50)
            .map(|n| rises(10.0, 0.2, 10.0 + 0.1 * n as f32))
            .collect();
        assert!(values.is_sorted());
        assert!((values[25] - 0.5).abs() < 1e-5);
    }

    /// The painting written down plainly, with exact functions and the noise crate's noise.
    fn plainly(field: &Field, seed: u64, point: ChartPoint, normal: Vec3) -> [f32; 3] {
        let perlin = Perlin::new(table_seed(seed));
        let place = field.strategy().noise_point(point) * AXIS_FREQUENCY;
        let noise = |frequency: f64| perlin.get((place * frequency).to_array()) as f32;
        let (wander, mottle) = (noise(0.8), noise(3.1));
        let biome = field.alone();
        let (lowest, highest) = field.ground_range_m();
        let scale = 2.0 * biome.max_amplitude_m() / (highest - lowest);
        let height = ((point.pos.y - lowest) * scale) as f32;
        let smooth = |from: f32, to: f32, x: f32| {
            let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        };
        let level = height + 2.0 * wander;
        let above = |border: f64| smooth(border as f32 - 2.5, border as f32 + 2.5, level);
        let palette = &biome.palette;
        let ground = linear(palette.bottom)
            .lerp(
                linear(palette.middle),
                above(f64::from(biome.levels_alone_m()[0])),
            )
            .lerp(
                linear(palette.top),
                above(f64::from(biome.levels_alone_m()[1])),
            );
        let above_lowest_m = (point.pos.y - lowest) as f32;
        let beds = smooth(-0.2, 0.8, (above_lowest_m * 2.4 + wander * 2.0).sin());
        let rock = linear(palette.rock).lerp(linear(palette.strata), beds);
        let steep = smooth(0.30, 0.60, 1.0 - normal.y + 0.1 * mottle);
        let light = ground.lerp(rock, steep) * (1.0 + 0.1 * mottle);
        let [r, g, b, _] = light.to_array().map(|c| {
            let srgb = 1.055 * c.powf(1.0 / 2.4) - 0.055;
            255.0 * if c <= 0.003_130_8 { c * 12.92 } else { srgb }
        });
        [r, g, b]
    }

    #[test]
    fn colours_are_the_plain_formulas_to_a_255th() {
        for seed in 0..5 {
            for (geometry, radius_m) in [
                (Geometry::Euclidean, 20.0),
                (Geometry::Spherical, 16.0),
                (Geometry::Spherical, 32.0),
                (Geometry::Spherical, 256.0),
            ] {
                let field = Field::made_by(Generator::OneBiome, seed, strategy(geometry, radius_m));
                let painter = Painter::new(&field);
                let (low, high) = field.ground_range_m();
                for n in 0..4000 {
                    let t = f64::from(n);
                    let y = low + (high - low) * (t * 0.618).fract();
                    let pos = DVec3::new((t * 0.0117).sin() * 23.0, y, t * 0.006 - 12.0);
                    let chart = [ChartId::FIRST, ChartId::SECOND][n as usize % 2];
                    let point = ChartPoint::new(chart, pos);
                    let normal = Vec3::new(0.3, (t * 0.37).fract() as f32, 0.1).normalize();
                    let found = painter.paint(point, normal, 0, 0.0);
                    let exact = plainly(&field, seed, point, normal);
                    for (found, exact) in found.into_iter().zip(exact) {
                        let off = (f32::from(found) - exact).abs();
                        assert!(off < 1.5, "{seed} {geometry:?} {pos}: {found} {exact}");
                    }
                }
            }
        }
    }

    #[test]
    fn beds_of_rock_are_no_thinner_where_a_closed_world_squeezes_its_heights() {
        for (geometry, radius_m) in [
            (Geometry::Euclidean, 20.0),
            (Geometry::Spherical, 16.0),
            (Geometry::Spherical, 32.0),
            (Geometry::Spherical, 256.0),
        ] {
            let field = Field::made_by(Generator::OneBiome, 1, strategy(geometry, radius_m));
            let painter = Painter::new(&field);
            let (low, high) = field.ground_range_m();
            let is_bed = |n: u32| {
                let pos = DVec3::new(3.0, low + 0.05 * f64::from(n), -8.0);
                let [_, green, ..] = painter.paint(ChartPoint::a(pos), Vec3::X, 0, 0.0);
                green > 120
            };
            let steps = ((high - low) / 0.05) as u32;
            let beds = (1..steps).filter(|n| is_bed(*n) && !is_bed(n - 1)).count();
            let expected = (high - low) / 2.6;
            let off = beds as f64 - expected;
            assert!(
                off.abs() < 2.5,
                "{geometry:?} {radius_m}: {beds}, not {expected}"
            );
        }
    }
}
