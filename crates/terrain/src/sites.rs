//! What the climate makes of the places of a chart. It hardly changes from one metre to the next, so it is worked out at
//! the corners of squares that all chunks and levels have in common, and drawn between them.

use antipode_geometry::ChartPoint;
use glam::Vec4;

use crate::biome::{Biome, Palette};
use crate::climate::Climate;
use crate::field::Field;
use crate::light::linear;

/// Corners are so far apart, as a share of how far the lattice points of the climates are, but no farther than that, metres.
const SPACING_SHARE: f64 = 1.0 / 16.0;
const SPACING_MOST_M: f64 = 8.0;
/// Corners along x and z that are remembered: those of a chunk of an open world do not meet.
const ACROSS: usize = 16;

/// Colours of ground in linear light, and where they begin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Paint {
    pub low: Vec4,
    pub middle: Vec4,
    pub high: Vec4,
    pub rock: Vec4,
    pub strata: Vec4,
    /// Heights where middle and high ground begin, metres.
    pub levels_m: Vec4,
}

impl Paint {
    pub(crate) fn new(palette: &Palette, [middle_m, top_m]: [f32; 2]) -> Self {
        Self {
            low: linear(palette.bottom),
            middle: linear(palette.middle),
            high: linear(palette.top),
            rock: linear(palette.rock),
            strata: linear(palette.strata),
            levels_m: Vec4::new(middle_m, top_m, 0.0, 0.0),
        }
    }

    fn of_biome(biome: &Biome) -> Self {
        Self::new(&biome.palette, biome.levels_m)
    }

    fn map2(&self, other: &Self, f: impl Fn(Vec4, Vec4) -> Vec4) -> Self {
        Self {
            low: f(self.low, other.low),
            middle: f(self.middle, other.middle),
            high: f(self.high, other.high),
            rock: f(self.rock, other.rock),
            strata: f(self.strata, other.strata),
            levels_m: f(self.levels_m, other.levels_m),
        }
    }
}

/// What can be drawn between corners.
pub(crate) trait Site: Copy {
    /// At a climate.
    fn at(paints: &[Paint], climate: &Climate, here: Vec4) -> Self;
    /// Between two.
    fn between(&self, other: &Self, part: f32) -> Self;
}

impl Site for Paint {
    fn at(paints: &[Paint], climate: &Climate, here: Vec4) -> Self {
        let nothing = paints[0].map2(&paints[0], |_, _| Vec4::ZERO);
        let mut sum = nothing;
        climate.colour_shares(here, |n, share| {
            sum = sum.map2(&paints[n], |sum, more| sum + more * share);
        });
        sum
    }

    #[inline]
    fn between(&self, other: &Self, part: f32) -> Self {
        self.map2(other, |a, b| a + part * (b - a))
    }
}

/// The climate itself.
impl Site for Vec4 {
    fn at(_: &[Paint], _: &Climate, here: Vec4) -> Self {
        here
    }

    #[inline]
    fn between(&self, other: &Self, part: f32) -> Self {
        *self + part * (*other - *self)
    }
}

/// Sites of one chart.
#[derive(Debug)]
pub(crate) struct Sites<T> {
    paints: Vec<Paint>,
    spacing_m: f64,
    keys: Vec<Option<[i64; 2]>>,
    found: Vec<T>,
    /// The square that was asked for last, and its corners.
    last: Option<([i64; 2], [T; 4])>,
}

impl<T: Site> Sites<T> {
    pub(crate) fn new(climate: &Climate) -> Self {
        let lands = climate.lands().iter();
        let spacing_m = (climate.spread_m() * SPACING_SHARE).min(SPACING_MOST_M);
        Self {
            paints: lands.map(|land| Paint::of_biome(land.biome)).collect(),
            // A power of two, so that chunks end at corners.
            spacing_m: 2.0_f64.powi(spacing_m.log2().floor() as i32),
            keys: vec![None; ACROSS * ACROSS],
            found: Vec::new(),
            last: None,
        }
    }

    /// At a point of the chart that all questions are about.
    #[inline]
    pub(crate) fn at(&mut self, field: &Field, climate: &Climate, point: ChartPoint) -> T {
        let (x, z) = (point.pos.x / self.spacing_m, point.pos.z / self.spacing_m);
        let (i, k) = (x.floor(), z.floor());
        let square = [i as i64, k as i64];
        let [a, b, c, d] = match self.last {
            Some((known, corners)) if known == square => corners,
            _ => self.enter(field, climate, point, square),
        };
        let (u, w) = ((x - i) as f32, (z - k) as f32);
        a.between(&b, u).between(&c.between(&d, u), w)
    }

    #[cold]
    fn enter(
        &mut self,
        field: &Field,
        climate: &Climate,
        point: ChartPoint,
        [i, k]: [i64; 2],
    ) -> [T; 4] {
        let corners = [[0, 0], [1, 0], [0, 1], [1, 1]];
        let corners = corners.map(|[a, b]| self.corner(field, climate, point, [i + a, k + b]));
        self.last = Some(([i, k], corners));
        corners
    }

    fn corner(&mut self, field: &Field, climate: &Climate, point: ChartPoint, key: [i64; 2]) -> T {
        let wrapped = key.map(|n| n.rem_euclid(ACROSS as i64) as usize);
        let at = wrapped[0] * ACROSS + wrapped[1];
        if self.keys[at] == Some(key) {
            return self.found[at];
        }
        let [x, z] = key.map(|n| n as f64 * self.spacing_m);
        let here = field.climate_at(climate, point.chart, [x, z]);
        let site = T::at(&self.paints, climate, here);
        if self.found.is_empty() {
            self.found = vec![site; self.keys.len()];
        }
        self.keys[at] = Some(key);
        self.found[at] = site;
        site
    }
}
