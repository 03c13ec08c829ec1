//! What a field makes of its biomes: which there are, and what columns make of the octaves.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, NoiseFrame};
use glam::{DVec3, Vec4};

use super::Field;
use crate::biome::Biome;
use crate::caves::Caves;
use crate::climate::Climate;
use crate::form::Form;
use crate::fractal::Octave;
use crate::generator::Generator;
use crate::light::{LightTables, linear};
use crate::relief::Rows;
use crate::tilted;
use crate::upright::Grid;

/// Frequency of the longest wave of the ground that biomes by climate have in common; frequencies double from octave to
/// octave.
const FIRST_FREQUENCY: f64 = 0.05;
/// No flat ground of those is lower, metres: just over the border between two layers of chunks and their borders.
pub(super) const LOWEST_M: f64 = 1.5;
/// How many there are.
const OCTAVES: i32 = 4;
/// After so many tries of a height it is within centimetres of land's, where that is no cliff.
pub(super) const HEIGHT_TRIES: u32 = 5;
/// Room for the rounding of what is between forms, metres.
const ROUNDING_M: f32 = 1e-3;

impl Field {
    /// Which generator makes it.
    pub fn generator(&self) -> Generator {
        self.generator
    }

    /// The seed of its world.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// The biome of the land at a point.
    pub fn biome_at(&self, point: ChartPoint) -> &'static Biome {
        let Some(climate) = &self.climate else {
            return self.alone;
        };
        let here = self.climate_at(climate, point.chart, [point.pos.x, point.pos.z]);
        climate.lands()[climate.nearest(here)].biome
    }

    /// Colours of low, middle and high ground at a point, sRGB: between biomes, between theirs.
    pub fn ground_colours(&self, point: ChartPoint) -> [[u8; 3]; 3] {
        let Some(climate) = &self.climate else {
            return self.alone.ground_colours();
        };
        let here = self.climate_at(climate, point.chart, [point.pos.x, point.pos.z]);
        let mut sums = [Vec4::ZERO; 3];
        climate.colour_shares(here, |n, share| {
            let colours = climate.lands()[n].biome.ground_colours();
            for (sum, colour) in sums.iter_mut().zip(colours) {
                *sum += linear(colour) * share;
            }
        });
        sums.map(|sum| {
            let [r, g, b, _] = LightTables::get().bytes(sum);
            [r, g, b]
        })
    }

    /// The climate over `(x, z)`.
    pub(crate) fn climate_at(&self, climate: &Climate, chart: ChartId, [x, z]: [f64; 2]) -> Vec4 {
        match self.spot(chart, x, z) {
            Some(spot) => Climate::at_spot(&spot),
            None => climate.at(self.ground_place(chart, x, z)),
        }
    }

    /// The caves of a world that has some.
    pub(crate) fn caves(&self) -> Option<&Caves> {
        self.caves.as_deref()
    }

    /// The biome of a world of one.
    pub(crate) fn alone(&self) -> &'static Biome {
        self.alone
    }

    /// The climates of a world of several.
    pub(crate) fn climate(&self) -> Option<&Arc<Climate>> {
        self.climate.as_ref()
    }

    /// A height `y` is `(y - offset) * scale` in the heights that biomes tell theirs in: metres of flat worlds, over their
    /// lowest ground where it is that of one biome, and else over the middle.
    pub(crate) fn own_heights(&self) -> (f64, f64) {
        let relief = &self.relief;
        match self.climate {
            None => (relief.range_m().0, relief.stretch().recip()),
            Some(_) => (relief.middle_m(), relief.steepness().recip()),
        }
    }

    /// Where in noise space the ground at `(x, z)` is.
    pub(crate) fn ground_place(&self, chart: ChartId, x: f64, z: f64) -> DVec3 {
        let ground = ChartPoint::new(chart, DVec3::new(x, 0.0, z));
        self.strategy.noise_point(ground)
    }

    /// Radius of a closed world, metres.
    pub(crate) fn closed_radius_m(&self) -> Option<f64> {
        match self.strategy.noise_frame(ChartId::FIRST) {
            NoiseFrame::Radial { radius_m } => Some(radius_m),
            NoiseFrame::Square(_) | NoiseFrame::Upright => None,
        }
    }

    /// The same land without its caves.
    #[must_use]
    pub fn without_caves(&self) -> Self {
        Self {
            caves: None,
            ..self.clone()
        }
    }

    /// The place of noise space at a height over one on the ground.
    pub(crate) fn risen(&self, ground: DVec3, height_m: f64) -> DVec3 {
        match self.strategy.noise_frame(ChartId::FIRST) {
            NoiseFrame::Radial { radius_m } => ground * (1.0 + height_m / radius_m),
            NoiseFrame::Square(_) | NoiseFrame::Upright => ground + DVec3::Y * height_m,
        }
    }

    /// About how high land lies over a place on the ground of noise space, metres, caves or not: as far as some tries find the
    /// height that its own noise asks for.
    pub(crate) fn land_height(&self, ground: DVec3) -> f64 {
        let column = self.column_over(ChartId::FIRST, ground);
        self.height_tried(|y| tilted::sum_at(&self.lattice, &self.octaves, &column, y))
    }

    /// What the column at a place of noise space on the ground makes of the octaves.
    pub(super) fn form(&self, place: DVec3) -> Form {
        let formed = |climate: &Arc<Climate>| climate.form(climate.at(place));
        self.climate.as_ref().map_or(Form::PLAIN, formed)
    }

    /// Half of how high each octave is.
    fn halves(&self) -> Vec4 {
        let mut halves = [0.0; 4];
        for (half, octave) in halves.iter_mut().zip(&self.octaves) {
            *half = octave.half_m();
        }
        Vec4::from(halves)
    }

    /// Rows for columns of these forms.
    pub(super) fn rows<'a>(
        &self,
        forms: impl Iterator<Item = &'a Form>,
        (first_m, step_m, count): (f64, f64, usize),
    ) -> Rows {
        if self.climate.is_none() {
            return self.relief.rows(first_m, step_m, count);
        }
        let halves = self.halves();
        let mut sums = [f32::INFINITY, f32::NEG_INFINITY];
        for form in forms {
            let [least, most] = form.sums(halves);
            sums = [sums[0].min(least), sums[1].max(most)];
        }
        self.relief.rows_within(sums, first_m, step_m, count)
    }

    /// The forms of a grid's columns in noise space, by `i * counts[2] + k`.
    pub(super) fn forms(
        &self,
        &Grid {
            first,
            step_m,
            counts,
        }: &Grid,
    ) -> Vec<Form> {
        let [width, _, depth] = counts;
        let at =
            |n: usize| first + step_m * DVec3::new((n / depth) as f64, 0.0, (n % depth) as f64);
        (0..width * depth).map(|n| self.form(at(n))).collect()
    }
}

/// The octaves that all columns of biomes by climate have in common, each as high as its forms say.
pub(super) fn common_octaves() -> Vec<Octave> {
    let octave = |n: i32| Octave {
        frequency: FIRST_FREQUENCY * 2.0_f64.powi(n),
        amplitude_m: 2.0,
    };
    (0..OCTAVES).map(octave).collect()
}

/// The least and the greatest sum of any form, metres.
pub(super) fn all_sums_m() -> [f32; 2] {
    let forms = Biome::all().iter().map(Biome::form);
    let sums = forms.map(|form| form.sums(Vec4::ONE));
    sums.fold([-ROUNDING_M, ROUNDING_M], |[least, most], sums| {
        [
            least.min(sums[0] - ROUNDING_M),
            most.max(sums[1] + ROUNDING_M),
        ]
    })
}
