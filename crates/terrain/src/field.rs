//! The scalar field of a world's untouched ground.
//!
//! Of [`Generator::Climates`] each column has a form of its own ([`crate::form`]), which goes over into its neighbours', and
//! the field is `y - middle + fall + terraces * wave(y) + sum_i waves_i noise_i`. [`Generator::OneBiome`] has one biome:
//!
//! `value = y + sum_i (noise_i - 0.5) a_i - relief`, solid below zero, with noise in 0..=1
//! and `relief = sum_i a_i / 2`: ground lies between 0 and twice the relief. On the sphere
//! the sum is squeezed, smoothly and strictly, between the space's lowest and highest ground.
//!
//! Values are held to [`FIELD_BAND_M`] on either side of the surface. That changes no surface,
//! and it lets a pickaxe work at any depth: the unheld field grows with depth without bound,
//! and neither patience nor a bounded edit would ever catch up with it.

mod land;
mod tiled;

use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Domain, NoiseFrame, SquareFrame};
use glam::DVec3;

use crate::biome::Biome;
use crate::caves::Caves;
use crate::climate::Climate;
use crate::fractal::{Column, Octave};
use crate::generator::Generator;
use crate::lattice::Lattice;
use crate::relief::{BLOCK, Ground, Relief};
use crate::tilted::{self, Heights};
use crate::tracts::Tracts;
use crate::upright::{self, Grid};

/// Field values lie within this of zero, metres.
pub const FIELD_BAND_M: f32 = 8.0;
/// Ground is meshed this far past the domain of a chart, metres, for colliders.
pub const RIM_REACH_M: f64 = 8.0;
/// Share of the sphere's range of heights that ground may use.
const SPHERE_SHARE: f64 = 0.98;
/// Half range of ground on large spheres, metres: that of a radius of 64 m. The noise is as fine on
/// all of them, and stretched higher it would tear off rocks that float.
const SPHERE_MOST_M: f64 = 11.0;

/// The ground of a world before any edit: a pure function of seed and space.
#[derive(Debug, Clone)]
pub struct Field {
    generator: Generator,
    seed: u64,
    strategy: Arc<dyn Atlas>,
    lattice: Arc<Lattice>,
    /// The biome of a world of one.
    alone: &'static Biome,
    climate: Option<Arc<Climate>>,
    /// Where the noise of a world in tiles is found.
    tracts: Option<Arc<Tracts>>,
    caves: Option<Arc<Caves>>,
    octaves: Vec<Octave>,
    relief: Relief,
}

impl Field {
    /// The field of a new world with this seed in this space.
    pub fn new(seed: u64, strategy: Arc<dyn Atlas>) -> Self {
        Self::made_by(Generator::default(), seed, strategy)
    }

    /// The field of the world with this seed in this space that was begun with this generator.
    pub fn made_by(generator: Generator, seed: u64, strategy: Arc<dyn Atlas>) -> Self {
        let bounds = strategy.limits().map(|limits| {
            let middle = f64::midpoint(limits.ground_min_m, limits.ground_max_m);
            let half = (limits.ground_max_m - limits.ground_min_m) / 2.0;
            (middle, (half * SPHERE_SHARE).min(SPHERE_MOST_M))
        });
        let alone = Biome::from_seed(seed);
        let climate = generator
            .has_climates()
            .then(|| Arc::new(Climate::new(seed, &*strategy)));
        let (octaves, sums_m, lowest_m) = match &climate {
            None => {
                let most_m = alone.max_amplitude_m();
                (alone.octaves(), [-most_m, most_m], 0.0)
            }
            Some(_) => (
                land::common_octaves(),
                land::all_sums_m().map(f64::from),
                land::LOWEST_M,
            ),
        };
        let tracts = climate.as_ref().map_or_else(
            || Tracts::new(seed, seed, &*strategy).map(Arc::new),
            |climate| climate.tracts().cloned(),
        );
        let mut field = Self {
            generator,
            seed,
            tracts,
            lattice: Arc::new(Lattice::new(seed)),
            relief: Relief::new(sums_m, lowest_m, bounds),
            alone,
            climate,
            caves: None,
            octaves,
            strategy,
        };
        // They follow the land above them.
        if field.climate.is_some() {
            field.caves = Some(Arc::new(Caves::new(seed, &field)));
        }
        field
    }

    /// The space this field lives in.
    pub fn strategy(&self) -> &Arc<dyn Atlas> {
        &self.strategy
    }

    pub(crate) fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    pub(crate) fn octaves(&self) -> &[Octave] {
        &self.octaves
    }

    pub(crate) fn relief(&self) -> &Relief {
        &self.relief
    }

    pub(crate) fn domain(&self, chart: ChartId) -> Domain {
        self.strategy.domain(chart)
    }

    /// Lowest and highest height that untouched ground can have, metres.
    pub fn ground_range_m(&self) -> (f64, f64) {
        self.relief.range_m()
    }

    /// The field at a point: below zero is solid, within [`FIELD_BAND_M`] of zero, and finite
    /// wherever the point is.
    pub fn sample(&self, point: ChartPoint) -> f32 {
        self.hollowed(point, self.land(point))
    }

    /// [`Self::sample`] as if there were no caves.
    pub fn land(&self, point: ChartPoint) -> f32 {
        let ChartPoint { chart, pos } = point;
        if let Some(spot) = self.spot(chart, pos.x, pos.z) {
            return self.land_over(&spot, pos.y);
        }
        let sum = match self.strategy.noise_frame(chart) {
            NoiseFrame::Square(frame) => return self.land_square(frame.placed(pos)),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => {
                let column = self.column(chart, pos.x, pos.z);
                tilted::sum_at(&self.lattice, &self.octaves, &column, pos.y)
            }
        };
        self.relief.value(pos.y, sum)
    }

    /// [`Self::land`] at a place of noise space, where charts are square with that.
    pub(crate) fn land_square(&self, place: DVec3) -> f32 {
        let sum = upright::sum_at(&self.lattice, &self.octaves, &self.form(place), place);
        self.relief.value(place.y, sum)
    }

    /// [`Self::land`] at the points `first + step_m * (i, j, k)`, with `(i, j, k)` below `counts`,
    /// into `out` by `(i * counts[2] + k) * counts[1] + j`: columns along y are contiguous.
    ///
    /// The value at a point with whole coordinates is the same bit for bit, whatever grid it
    /// is asked for in. What `out` has no room for is left out.
    pub(crate) fn fill_grid(
        &self,
        chart: ChartId,
        first: DVec3,
        step_m: u32,
        counts: [usize; 3],
        out: &mut [f32],
    ) {
        let [_, height, depth] = counts;
        if height > BLOCK || depth > BLOCK {
            return self.fill_blocks(chart, first, step_m, counts, out);
        }
        let step_m = f64::from(step_m);
        let rows = self.relief.rows(first.y, step_m, height);
        if rows.open[0] == rows.open[1] {
            return rows.fill_closed(height, out);
        }
        let grid = Grid {
            first,
            step_m: DVec3::splat(step_m),
            counts,
        };
        if let Some(tracts) = &self.tracts {
            return self.fill_tiled(tracts, chart, &grid, out);
        }
        match self.strategy.noise_frame(chart) {
            NoiseFrame::Square(frame) => self.fill_square(frame, &grid, out),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => self.fill_tilted(chart, &grid, out),
        }
    }

    /// [`Self::fill_grid`] where columns stand upright in the lattice: as the grid lies in the lattice's own axes, and
    /// from there to its places.
    fn fill_square(&self, frame: SquareFrame, grid: &Grid, out: &mut [f32]) {
        let Grid {
            first,
            step_m,
            counts,
        } = *grid;
        let fill = |first, counts, out: &mut [f32]| {
            let turned = Grid {
                first,
                step_m,
                counts,
            };
            let forms = self.forms(&turned);
            let rows = self.rows(forms.iter(), (first.y, step_m.y, counts[1]));
            if rows.open[0] == rows.open[1] {
                return rows.fill_closed(counts[1], out);
            }
            let ground = Ground {
                relief: &self.relief,
                rows: &rows,
            };
            upright::fill(&self.lattice, &self.octaves, ground, &turned, &forms, out);
        };
        let [width, height, depth] = counts;
        let last = first + DVec3::new(width as f64 - 1.0, 0.0, depth as f64 - 1.0) * step_m;
        let [from, to] = [first, last].map(|corner| frame.placed(corner));
        let corner = from.min(to);
        if frame.quarter_turns.is_multiple_of(4) {
            return fill(corner, counts, out);
        }
        let [across, along] = if frame.quarter_turns.is_multiple_of(2) {
            [width, depth]
        } else {
            [depth, width]
        };
        let mut turned = vec![0.0; across * height * along];
        fill(corner, [across, height, along], &mut turned);
        for (n, column) in out.chunks_exact_mut(height).enumerate() {
            let at = DVec3::new((n / depth) as f64, 0.0, (n % depth) as f64) * step_m;
            let place = (frame.placed(first + at) - corner) / step_m;
            let from = (place.x as usize * along + place.z as usize) * height;
            column.copy_from_slice(&turned[from..from + height]);
        }
    }

    /// By how many quarter turns a chart is turned against the space.
    pub(crate) fn quarter_turns(&self, chart: ChartId) -> usize {
        usize::from(self.strategy.noise_frame(chart).quarter_turns())
    }

    /// Height of the topmost surface of untouched ground over `(x, z)`, metres.
    pub fn surface_height(&self, chart: ChartId, x: f64, z: f64) -> f64 {
        const STEP_M: f64 = 0.5;
        const HALVINGS: u32 = 24;
        let at = |y| self.sample(ChartPoint::new(chart, DVec3::new(x, y, z)));
        let (low, high) = self.ground_range_m();
        let mut air = high + STEP_M;
        while air > low && at(air - STEP_M) >= 0.0 {
            air -= STEP_M;
        }
        let mut ground = air - STEP_M;
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(air, ground);
            if at(middle) < 0.0 {
                ground = middle;
            } else {
                air = middle;
            }
        }
        air
    }

    /// [`Self::fill_grid`] where columns slant through the lattice.
    fn fill_tilted(&self, chart: ChartId, grid: &Grid, out: &mut [f32]) {
        let Grid { first, step_m, .. } = *grid;
        let [width, height, depth] = grid.counts;
        let heights = Heights {
            first_m: first.y,
            step_m: step_m.y,
            count: height,
        };
        let block = (BLOCK * depth * height).max(1);
        for (from, out) in (0..width).step_by(BLOCK).zip(out.chunks_mut(block)) {
            let mut columns = Vec::with_capacity(BLOCK * depth);
            for i in from..width.min(from + BLOCK) {
                for k in 0..depth {
                    let at = first + step_m * DVec3::new(i as f64, 0.0, k as f64);
                    let (x, z) = (at.x, at.z);
                    columns.push(self.column(chart, x, z));
                }
            }
            let forms = columns.iter().map(|column: &Column| &column.form);
            let rows = self.rows(forms, (first.y, step_m.y, height));
            let ground = Ground {
                relief: &self.relief,
                rows: &rows,
            };
            tilted::fill(&self.lattice, &self.octaves, ground, &columns, heights, out);
        }
    }

    /// [`Self::fill_grid`] of grids with longer columns and rows than are filled at once.
    fn fill_blocks(
        &self,
        chart: ChartId,
        first: DVec3,
        step_m: u32,
        [width, height, depth]: [usize; 3],
        out: &mut [f32],
    ) {
        let mut block = vec![0.0; width * BLOCK * BLOCK];
        for j in (0..height).step_by(BLOCK) {
            for k in (0..depth).step_by(BLOCK) {
                let (rows, deep) = (BLOCK.min(height - j), BLOCK.min(depth - k));
                let corner = first + DVec3::new(0.0, j as f64, k as f64) * f64::from(step_m);
                let block = &mut block[..width * rows * deep];
                self.fill_grid(chart, corner, step_m, [width, rows, deep], block);
                for (n, column) in block.chunks_exact(rows).enumerate() {
                    let at = ((n / deep) * depth + k + n % deep) * height + j;
                    out[at..at + rows].copy_from_slice(column);
                }
            }
        }
    }

    fn column(&self, chart: ChartId, x: f64, z: f64) -> Column {
        self.column_over(chart, self.ground_place(chart, x, z))
    }

    /// A column in the lattice of the first octave, over a place on the ground of noise space. Where that is radial about
    /// the sphere's centre, the height stretches the place.
    fn column_over(&self, chart: ChartId, place: DVec3) -> Column {
        let frequencies = self.octaves.first().map_or(DVec3::ONE, |o| o.frequencies());
        let base = place * frequencies;
        let slope = match self.strategy.noise_frame(chart) {
            NoiseFrame::Radial { radius_m } => base / radius_m,
            NoiseFrame::Square(_) | NoiseFrame::Upright => DVec3::Y * frequencies,
        };
        Column {
            base,
            slope,
            form: self.form(place),
        }
    }
}

/// Lowest and highest height of samples that edits change. One sample inside the limits:
/// the surface between the last solid sample and the first that can be dug then lies above
/// bedrock, wherever between them it is.
pub(crate) fn editable_y_m(strategy: &dyn Atlas) -> (f64, f64) {
    strategy
        .limits()
        .map_or((f64::NEG_INFINITY, f64::INFINITY), |limits| {
            (limits.bedrock_m + 1.0, limits.ceiling_m - 1.0)
        })
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, strategy};

    use super::*;

    #[test]
    fn grids_of_any_step_and_size_hold_what_single_samples_do() {
        for geometry in [Geometry::Euclidean, Geometry::Spherical] {
            let field = Field::new(4, strategy(geometry, 32.0));
            for (first, step_m, counts) in [
                (DVec3::new(-20.0, -9.0, 3.0), 1, [38, 40, 41]),
                (DVec3::new(-8.0, -8.0, -8.0), 8, [7, 7, 7]),
                (DVec3::new(0.0, 11.0, -2.0), 2, [37, 1, 39]),
                (DVec3::new(5.0, 0.0, 4.0), 4, [1, 37, 2]),
                (DVec3::new(5.0, 0.0, 4.0), 1, [3, 0, 2]),
            ] {
                let [width, height, depth] = counts;
                let mut out = vec![0.0; width * height * depth];
                field.fill_grid(ChartId::SECOND, first, step_m, counts, &mut out);
                for (n, found) in out.into_iter().enumerate() {
                    let (column, j) = (n / height, n % height);
                    let steps = [column / depth, j, column % depth].map(|c| c as f64);
                    let p = first + DVec3::from(steps) * f64::from(step_m);
                    let single = field.land(ChartPoint::new(ChartId::SECOND, p));
                    assert_eq!(found, single, "{geometry:?} {step_m} {p}");
                }
            }
        }
    }
}
