//! The field of worlds in tiles, whose noise knows no centre ([`crate::tracts`]).

use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec2, DVec3};

use super::Field;
use super::land::HEIGHT_TRIES;
use crate::climate::Climate;
use crate::form::Form;
use crate::relief::Ground;
use crate::tracts::{Met, Spot, Tract, Tracts, fill};
use crate::upright::Grid;

/// Standard deviation of an octave's noise, which is in -1..=1: what is broader than tiles has it, too.
const OCTAVE_DEVIATION: f32 = 0.312;

impl Field {
    /// Where the noise of the column over `(x, z)` is found, of a world in tiles.
    pub(crate) fn spot(&self, chart: ChartId, x: f64, z: f64) -> Option<Spot> {
        let tracts = self.tracts.as_ref()?;
        Some(tracts.spot(&*self.strategy, chart, [x, z]))
    }

    /// Noise at a point, given that at places of the space of the noise, which goes up and down about a middle: in a world in tiles
    /// that of all patches about the point is blended.
    pub fn blended(
        &self,
        point: ChartPoint,
        middle: f32,
        mut noise: impl FnMut(DVec3) -> f32,
    ) -> f32 {
        let ChartPoint { chart, pos } = point;
        match self.spot(chart, pos.x, pos.z) {
            Some(spot) => middle + spot.blended(pos.y, |place| noise(place) - middle),
            None => noise(self.strategy.noise_point(point)),
        }
    }

    /// The tracts of a world in tiles.
    pub(crate) fn tracts(&self) -> Option<&Tracts> {
        self.tracts.as_deref()
    }

    /// [`Field::land`] over a spot.
    pub(super) fn land_over(&self, spot: &Spot, y: f64) -> f32 {
        let form = self.form_over(spot);
        let sum = fill::sum_at(&self.lattice, &self.octaves, &form, spot, y);
        self.relief.value(y, sum)
    }

    /// What the column over a spot makes of the octaves: those broader than tiles are the same at all heights, and so part of how
    /// far the ground lies below the middle.
    fn form_over(&self, spot: &Spot) -> Form {
        let Some(climate) = &self.climate else {
            return Form::PLAIN;
        };
        let mut form = climate.form(Climate::at_spot(spot));
        let wide = self.tracts.as_ref().map_or(0, |tracts| tracts.wide());
        let broad = spot.octaves();
        for (n, octave) in self.octaves.iter().enumerate().take(wide.min(4)) {
            let noise = (broad[n] * OCTAVE_DEVIATION).clamp(-1.0, 1.0);
            form.fall_m += form.waves[n] * octave.half_m() * noise;
            form.waves[n] = 0.0;
        }
        form
    }

    /// [`Field::fill_grid`] of a chart of a world in tiles.
    pub(super) fn fill_tiled(&self, tracts: &Tracts, chart: ChartId, grid: &Grid, out: &mut [f32]) {
        let spots = self.spots(tracts, chart, grid);
        let forms: Vec<_> = spots.iter().map(|spot| self.form_over(spot)).collect();
        let Grid {
            first,
            step_m,
            counts,
        } = *grid;
        let rows = self.rows(forms.iter(), (first.y, step_m.y, counts[1]));
        if rows.open[0] == rows.open[1] {
            return rows.fill_closed(counts[1], out);
        }
        let ground = Ground {
            relief: &self.relief,
            rows: &rows,
        };
        let columns = (&spots[..], &forms[..]);
        fill::fill(&self.lattice, &self.octaves, ground, grid, columns, out);
    }

    /// The spots of a grid's columns, by `i * counts[2] + k`.
    fn spots(&self, tracts: &Tracts, chart: ChartId, grid: &Grid) -> Vec<Spot> {
        let [width, _, depth] = grid.counts;
        let Some(tract) = tracts.tract(&*self.strategy, chart) else {
            return vec![Spot::NOWHERE; width * depth];
        };
        let xs = tract.tangents(grid.first.x, grid.step_m.x, width);
        let zs = tract.tangents(grid.first.z, grid.step_m.z, depth);
        let mut met = Met::default();
        let mut spot = |x: f64, z: f64, tract: &Tract| {
            let at = tract.noise.written(DVec2::new(x, z));
            tracts.spot_in(&*self.strategy, tract, at, &mut met)
        };
        let all = xs.iter().flat_map(|x| zs.iter().map(|z| (*x, *z)));
        all.map(|(x, z)| spot(x, z, &tract)).collect()
    }

    /// About how high land lies over a spot, metres, caves or not.
    pub(crate) fn land_height_over(&self, spot: &Spot) -> f64 {
        let form = self.form_over(spot);
        self.height_tried(|y| fill::sum_at(&self.lattice, &self.octaves, &form, spot, y))
    }

    /// About how high land lies over `(x, z)`, metres, caves or not.
    pub(crate) fn land_height_at(&self, chart: ChartId, x: f64, z: f64) -> f64 {
        match self.spot(chart, x, z) {
            Some(spot) => self.land_height_over(&spot),
            None => self.land_height(self.ground_place(chart, x, z)),
        }
    }

    /// The height that noise asks for which is in turn that at this height, as far as some tries find it, metres.
    pub(super) fn height_tried(&self, sum_at: impl Fn(f64) -> f32) -> f64 {
        let mut height_m = self.relief.middle_m();
        for n in 0..HEIGHT_TRIES {
            let found_m = self.relief.height_m(sum_at(height_m));
            height_m = if n == 0 {
                found_m
            } else {
                f64::midpoint(height_m, found_m)
            };
        }
        height_m
    }
}
