//! Hollows caves out of the land.
//!
//! A cave is taken from the land as if somebody had dug there: what a wall is made of and how dark it is follows from how deep
//! below the land's surface it lies, not from how far behind the cave's.

use antipode_geometry::{ChartId, ChartPoint, NoiseFrame};
use glam::{DVec3, Vec4};

use crate::caves::{Bounds, STRAY_M, Stretch};
use crate::field::{FIELD_BAND_M, Field};
use crate::kind::{Kind, sky_left};
use crate::lattice::{Cell, LatticeCoord, SCALE, blend, fade};

mod tiled;

/// Waves of the walls per metre.
const WAVES_PER_M: f64 = 0.19;
/// Within so much of a wall it strays, metres.
const NEAR_WALL_M: f64 = 3.0;
/// Where a hall's wall stands out by more than this of the waves, it is crystal; that far behind it.
const CRYSTAL: f32 = 0.22;
const CRUST_M: f32 = 3.0;
/// So deep below the land a cave has begun, metres.
const DARK_M: f32 = 3.0;
/// How far from a cave its field is felt, metres.
const REACH_M: f64 = FIELD_BAND_M as f64 + STRAY_M;
/// Charts that only say where columns stand make no metre longer than this.
const UPRIGHT_STRETCH: f64 = 2.0;

/// What a cave makes of a sample.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hollow {
    /// The field that the cave would have in solid land: below zero is solid.
    pub value: f32,
    /// The number of the kind that only grows there; 0 where none does.
    pub grown: u8,
}

impl Field {
    /// Calls `take` with the place of each sample of a grid as [`Self::fill_grid`] has them, by its index, which caves may
    /// have changed, and what they make of it.
    pub(crate) fn carve(
        &self,
        chart: ChartId,
        first: DVec3,
        step_m: u32,
        counts: [usize; 3],
        mut take: impl FnMut(usize, Hollow),
    ) {
        let Some(caves) = self.caves() else {
            return;
        };
        if let Some(tracts) = self.tracts() {
            return self.carve_tiled(caves, tracts, (chart, first, step_m), counts, take);
        }
        let [width, height, depth] = counts;
        let step_m = f64::from(step_m);
        let last = first
            + DVec3::new(width as f64 - 1.0, height as f64 - 1.0, depth as f64 - 1.0) * step_m;
        let mut stretches = Vec::new();
        let bounds = self.noise_bounds(chart, first, last);
        caves.near(self, &bounds, REACH_M, |stretch| stretches.push(*stretch));
        if stretches.is_empty() {
            return;
        }
        let mut within = Vec::with_capacity(stretches.len());
        for i in 0..width {
            for k in 0..depth {
                let at = first + step_m * DVec3::new(i as f64, 0.0, k as f64);
                let ground = self.ground_place(chart, at.x, at.z);
                let ends = [first.y, last.y].map(|y| self.risen(ground, y));
                let column = Bounds {
                    low: ends[0].min(ends[1]),
                    high: ends[0].max(ends[1]),
                };
                within.clear();
                let near = stretches
                    .iter()
                    .filter(|it| it.bounds(REACH_M).meets(&column));
                within.extend(near.copied());
                if within.is_empty() {
                    continue;
                }
                for j in 0..height {
                    let y = first.y + j as f64 * step_m;
                    let mut here = Here::new(self, self.risen(ground, y), y);
                    for stretch in &within {
                        here.meet(stretch);
                    }
                    if let Some(hollow) = here.found {
                        take((i * depth + k) * height + j, hollow);
                    }
                }
            }
        }
    }

    /// The field at a point, given that of the land there.
    pub(crate) fn hollowed(&self, point: ChartPoint, land: f32) -> f32 {
        let Some(caves) = self.caves().filter(|_| land < FIELD_BAND_M) else {
            return land;
        };
        let ChartPoint { chart, pos } = point;
        if let Some(tracts) = self.tracts() {
            let found = self.hollow_tiled(caves, tracts, point);
            return found.map_or(land, |hollow| land.max(hollow.value));
        }
        let place = self.risen(self.ground_place(chart, pos.x, pos.z), pos.y);
        let bounds = Bounds {
            low: place,
            high: place,
        };
        let mut here = Here::new(self, place, pos.y);
        caves.near(self, &bounds, REACH_M, |stretch| here.meet(stretch));
        here.found.map_or(land, |hollow| land.max(hollow.value))
    }

    /// Whether a point lies in a cave, so deep below untouched land that little of the sky is left.
    pub fn is_cave(&self, point: ChartPoint) -> bool {
        let land = self.land(point);
        land < -DARK_M && self.hollowed(point, land) > 0.0
    }

    /// How much of the sky is left at a point for the untouched land over it, 0 to 1.
    pub fn sky_left(&self, point: ChartPoint) -> f32 {
        sky_left(-self.land(point))
    }

    /// Whether any sample of a block may lie in a cave.
    pub(crate) fn is_hollow(&self, chart: ChartId, first: DVec3, last: DVec3) -> bool {
        let mut any = false;
        if let (Some(caves), Some(tracts)) = (self.caves(), self.tracts()) {
            let dens = self.dens_about(caves, tracts, chart, [first, last], STRAY_M);
            any = !dens.is_empty();
        } else if let Some(caves) = self.caves() {
            let bounds = self.noise_bounds(chart, first, last);
            caves.near(self, &bounds, STRAY_M, |_| any = true);
        }
        any
    }

    /// How far a wall stands out at a place, -1 to 1.
    fn wall_wave(&self, place: DVec3) -> f32 {
        let [x, y, z] = (place * WAVES_PER_M).to_array().map(LatticeCoord::new);
        let cell = Cell::new(self.lattice(), [x.low, y.low, z.low]);
        let corners = cell.corners(x.part, y.part, z.part, fade(z.part));
        let (u, v) = (Vec4::splat(fade(x.part)), Vec4::splat(fade(y.part)));
        (blend([corners; 4], u, v).x * SCALE).clamp(-1.0, 1.0)
    }

    /// A box of noise space that holds a box of a chart.
    fn noise_bounds(&self, chart: ChartId, first: DVec3, last: DVec3) -> Bounds {
        let place = |pos: DVec3| self.risen(self.ground_place(chart, pos.x, pos.z), pos.y);
        let [low, high] = match self.strategy().noise_frame(chart) {
            NoiseFrame::Square(_) => {
                let ends = [first, last].map(place);
                [ends[0].min(ends[1]), ends[0].max(ends[1])]
            }
            frame => {
                // No way is longer on the ground of noise space than in a chart, and ways above are as much longer as that is
                // nearer to the middle.
                let wider = match frame {
                    NoiseFrame::Radial { radius_m } => 1.0 + last.y.max(0.0) / radius_m,
                    _ => UPRIGHT_STRETCH,
                };
                let middle = place(first.midpoint(last));
                let reach = 0.5 * first.distance(last) * wider;
                [middle - reach, middle + reach]
            }
        };
        Bounds { low, high }
    }
}

/// What the caves near a place make of it.
struct Here<'a> {
    field: &'a Field,
    place: DVec3,
    height_m: f64,
    /// [`Field::wall_wave`], as soon as some wall is near.
    wave: Option<f32>,
    found: Option<Hollow>,
}

impl<'a> Here<'a> {
    fn new(field: &'a Field, place: DVec3, height_m: f64) -> Self {
        Self {
            field,
            place,
            height_m,
            wave: None,
            found: None,
        }
    }

    fn meet(&mut self, stretch: &Stretch) {
        let [mut hollow, floor] = stretch.depths(self.place, self.height_m);
        let near = 1.0 - hollow.abs() / NEAR_WALL_M;
        let mut stands_out = false;
        if near > 0.0 {
            let wave = *self
                .wave
                .get_or_insert_with(|| self.field.wall_wave(self.place));
            hollow -= STRAY_M * near * f64::from(wave);
            stands_out = wave > CRYSTAL;
        }
        let value = hollow.min(floor) as f32;
        let most = self.found.map_or(-FIELD_BAND_M, |found| found.value);
        if value > most {
            let is_crystal = stretch.is_hall && stands_out && value > -CRUST_M && hollow < floor;
            self.found = Some(Hollow {
                value: value.min(FIELD_BAND_M),
                grown: if is_crystal { Kind::Crystal.byte() } else { 0 },
            });
        }
    }
}
