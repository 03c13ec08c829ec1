//! Plans a frame: which chunks are drawn, and how, so that no error becomes visible.
//!
//! Everything is decided from measured bounds in pixels against the tolerance of the chosen quality.
//! Chunks are taken front to back, so that the skyline of nearer land is known when a farther chunk is
//! looked at; what stays behind it, or rises over it by less than the tolerance, is not drawn.

mod bend;
mod bounds;
mod choice;
mod land;
mod land_index;
mod quality;
mod refine;
mod rings;
mod skyline;
mod stats;
mod subdivider;
#[cfg(test)]
pub mod testing;
#[cfg(test)]
mod tests;
mod way;

use std::sync::Arc;

use antipode_frame::{Frame, Quality};
use antipode_geometry::{Eye, SightCell, Strategy};
pub use bounds::{Affine, Bounds, PictureScale};
pub use choice::{ChunkChoice, DepthMethod, Port};
pub use land::{ChunkLand, Ground};
pub use land_index::LandIndex;
pub use quality::Tolerance;
pub use refine::{RefineKey, RefineRules, unhalved_error_px};
pub use stats::PlanStats;
pub use subdivider::{Refined, Subdivider};

use bend::Bend;
use glam::IVec2;
use rings::Rings;
use skyline::{Grid, Skyline};

/// What rounding takes from a cell at most, in radians, or as a part of a slope or a distance.
const SLACK: f64 = 1e-6;

/// How a frame is drawn.
#[derive(Debug)]
pub struct FramePlan {
    /// The chunks to draw, nearest first, by their place in the list that was planned.
    pub chunks: Vec<ChunkChoice>,
    /// Sizes of errors in this frame.
    pub bounds: Bounds,
    /// What was chosen.
    pub stats: PlanStats,
}

/// A chunk that is in the picture, before it is known whether land hides it.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    place: usize,
    cell: SightCell,
    /// Its column's; 0, which nothing hides, where it has none.
    ring: u32,
    /// Whether its land may be seen, too, and not only what stands on it.
    shows_land: bool,
}

/// Decides what to draw of `land` in a picture `height_px` pixels high.
pub fn plan(frame: &Frame, height_px: u32, land: &[ChunkLand]) -> FramePlan {
    Planner::default().plan(frame, height_px, &LandIndex::new(land.to_vec()))
}

/// Plans one frame after another, and keeps what the next one can use.
#[derive(Debug, Default)]
pub struct Planner {
    bend: Option<Measured>,
}

/// A bend, and what it was measured for.
#[derive(Debug)]
struct Measured {
    strategy: Arc<dyn Strategy>,
    eye: Eye,
    scale: PictureScale,
    bend: Bend,
}

impl Planner {
    /// Decides what to draw of the land in a picture `height_px` pixels high.
    pub fn plan(&mut self, frame: &Frame, height_px: u32, land_index: &LandIndex) -> FramePlan {
        let scale = PictureScale::new(&frame.view.projection, height_px);
        let tolerance = Tolerance::of(frame.view.quality);
        let mut stats = PlanStats::default();
        let mut candidates = if frame.view.is_moved() {
            all(frame, land_index)
        } else {
            candidates(frame, land_index, scale, &tolerance, &mut stats)
        };
        let bounds = Bounds::new(frame, scale, self.bend(frame, scale));
        let mut rings = Rings::of(frame);
        if hides(frame, &mut rings, land_index, &tolerance) {
            for candidate in &mut candidates {
                let coord = land_index.land()[candidate.place].coord;
                let column = IVec2::new(coord.index.x, coord.index.z);
                candidate.ring = rings.ring(coord.chart, column).unwrap_or(0);
            }
            let land = (land_index, &mut rings);
            candidates = unhidden(frame, land, candidates, scale, &tolerance, &mut stats);
        }
        candidates.sort_unstable_by(|a, b| {
            let nearer = a.cell.nearest_m.total_cmp(&b.cell.nearest_m);
            nearer.then(a.place.cmp(&b.place))
        });
        let chunks = candidates
            .iter()
            .map(|candidate| {
                let chunk = &land_index.land()[candidate.place];
                stats.level_error_at_least(chunk.error_m * bounds.metre_px(&candidate.cell));
                let choice = choice::choose(frame, chunk, candidate, &bounds, &tolerance);
                stats.count(&choice, chunk);
                choice
            })
            .collect();
        FramePlan {
            chunks,
            bounds,
            stats,
        }
    }

    /// The bend of a frame's port: the last one's, where nothing that it depends on has changed.
    fn bend(&mut self, frame: &Frame, scale: PictureScale) -> Bend {
        let eye = Bounds::bend_eye(frame);
        if let Some(last) = &self.bend
            && Arc::ptr_eq(&last.strategy, &frame.view.strategy)
            && (last.eye, last.scale) == (eye, scale)
        {
            return last.bend.clone();
        }
        let bend = Bounds::measure_bend(frame, scale);
        self.bend = Some(Measured {
            strategy: Arc::clone(&frame.view.strategy),
            eye,
            scale,
            bend: bend.clone(),
        });
        bend
    }
}

/// Whether land hides land in a frame.
fn hides(
    frame: &Frame,
    rings: &mut Rings<'_>,
    land_index: &LandIndex,
    tolerance: &Tolerance,
) -> bool {
    let space = &frame.view.strategy;
    tolerance.hides
        && !frame.view.is_moved()
        && (space.keeps_azimuths() || space.tiled().is_some())
        && !skyline::is_underground(frame, rings, land_index.columns())
}

/// All chunks: what a view that is moved shows of them is not known.
fn all(frame: &Frame, land_index: &LandIndex) -> Vec<Candidate> {
    let (strategy, eye) = (frame.view.strategy.as_ref(), &frame.view.eye);
    let chunks = land_index.land().iter().enumerate();
    let candidate = |(place, chunk): (usize, &ChunkLand)| Candidate {
        place,
        cell: strategy.sight_cell(eye, chunk.coord.chart, chunk.whole[0], chunk.whole[1]),
        ring: 0,
        shows_land: true,
    };
    chunks.map(candidate).collect()
}

/// The chunks in the picture and before the fog that span more than the tolerance.
fn candidates(
    frame: &Frame,
    land_index: &LandIndex,
    scale: PictureScale,
    tolerance: &Tolerance,
    stats: &mut PlanStats,
) -> Vec<Candidate> {
    let (strategy, eye) = (frame.view.strategy.as_ref(), &frame.view.eye);
    let frustum = strategy.frustum(eye, &frame.view.projection);
    let fog_m = f64::from(frame.view.fog_distance_m);
    let mut seen = Vec::new();
    for group in land_index.groups() {
        let cell = roomy(strategy.sight_cell_of(eye, &group.cylinder));
        if !frustum.sees(&cell) || cell.nearest_m > fog_m {
            stats.triangles_outside += group.triangles;
            continue;
        }
        for place in land_index.chunks(group) {
            let chunk = &land_index.land()[place];
            let chart = chunk.coord.chart;
            let [low, high] = chunk.whole;
            let cell = frustum.cell_seen(strategy, eye, chart, low, high);
            match cell.filter(|cell| cell.nearest_m <= fog_m) {
                Some(cell) if scale.spans_px(&cell) < tolerance.small_px => {
                    stats.triangles_small += chunk.triangles;
                    stats.error_at_least(scale.spans_px(&cell));
                }
                Some(cell) => seen.push(Candidate {
                    place,
                    cell,
                    ring: 0,
                    shows_land: true,
                }),
                None => stats.triangles_outside += chunk.triangles,
            }
        }
    }
    seen
}

/// A cell widened by more than rounding takes from it, so that what is found to be outside of it is outside of all
/// cells that it was made to hold.
fn roomy(mut cell: SightCell) -> SightCell {
    let slack = |value: f64| SLACK * (1.0 + value.abs().min(f64::MAX));
    cell.half_width_rad += SLACK;
    cell.slope[0] -= slack(cell.slope[0]);
    cell.slope[1] += slack(cell.slope[1]);
    cell.nearest_m -= slack(cell.nearest_m);
    cell
}

/// Leaves out what the skyline of nearer land hides, or all but hides.
///
/// A ray leaves the eye's column through columns of ever greater steps in x and z, so columns are taken in
/// rings of equal sums of steps ([`Rings`]). Every column in sight distance raises the skyline, in the picture or not.
fn unhidden(
    frame: &Frame,
    (land_index, rings): (&LandIndex, &mut Rings<'_>),
    mut candidates: Vec<Candidate>,
    scale: PictureScale,
    tolerance: &Tolerance,
    stats: &mut PlanStats,
) -> Vec<Candidate> {
    let mut skyline = Skyline::new(frame, scale);
    for candidate in &candidates {
        skyline.want(&candidate.cell, candidate.ring);
    }
    let columns = land_index.columns();
    let mut grids: Vec<Grid> = Vec::new();
    let mut order: Vec<(u32, u32, u32)> = Vec::with_capacity(columns.len());
    let mut chart = None;
    for (column, at) in columns.iter().zip(0..) {
        if chart.replace(column.chart) != Some(column.chart) {
            grids.push(rings.grid(column.chart));
        }
        let number = grids.len() - 1;
        let ring = rings.ring_of_hiding(column.chart, column.place);
        order.extend(ring.map(|ring| (ring, at, number as u32)));
    }
    order.sort_unstable();
    let mut order = order.into_iter().peekable();
    candidates.sort_unstable_by_key(|candidate| candidate.ring);
    let mut left_out = vec![false; columns.len()];
    candidates.retain_mut(|candidate| {
        while let Some((ring, at, grid)) = order.next_if(|(ring, ..)| *ring < candidate.ring) {
            // Land that was left out hides nothing, or what is left out would add up.
            if !left_out[at as usize] {
                skyline.raise(&columns[at as usize], &grids[grid as usize], ring);
            }
        }
        let over_px = skyline.rises_px(&candidate.cell);
        let chunk = &land_index.land()[candidate.place];
        let triangles = chunk.triangles;
        if over_px <= 0.0 {
            stats.triangles_hidden += triangles;
            return false;
        }
        candidate.shows_land = !chunk.is_outgrown() || {
            let land = land_cell(frame, chunk);
            skyline.rises_px(&land) > 0.0
        };
        if !candidate.shows_land {
            stats.triangles_hidden += triangles;
        }
        let is_small = over_px < tolerance.small_px;
        if is_small {
            if candidate.shows_land {
                stats.triangles_small += triangles;
            }
            if let Some(column) = land_index.column_of(candidate.place) {
                left_out[column] = true;
            }
            stats.error_at_least(over_px);
        }
        !is_small
    });
    candidates
}

/// Where the land of a chunk is seen, without what stands on it.
fn land_cell(frame: &Frame, chunk: &ChunkLand) -> SightCell {
    let eye = &frame.view.eye;
    let strategy = &frame.view.strategy;
    strategy.sight_cell(eye, chunk.coord.chart, chunk.min, chunk.max)
}

/// The bar that a quality keeps a frame's `error_px` under, pixels; `None` where it promises nothing, because
/// edges near the eye are drawn as they are.
pub fn tolerance_px(quality: Quality) -> Option<f64> {
    let tolerance = Tolerance::of(quality);
    let promised = tolerance.small_px.max(tolerance.shape_px);
    (tolerance.halvings > 0).then_some(promised)
}
