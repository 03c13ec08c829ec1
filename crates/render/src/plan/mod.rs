//! What a frame requires: which chunks are drawn, and how, so that no error reaches a visible size.
//!
//! Everything is decided from measured bounds in pixels against the tolerance of the chosen quality.
//! Chunks are taken front to back, so that the skyline of nearer land is known when a farther chunk is
//! looked at; what stays behind it, or rises over it by less than the tolerance, is not drawn.

mod bend;
mod bounds;
mod choice;
mod halver;
mod land;
mod quality;
mod refine;
mod skyline;
mod stats;

use std::collections::HashSet;

use antipode_geometry::{CHUNK_CELLS, ChunkCoord, SightCell};
use antipode_scene::frame::{Frame, Quality};
pub use bounds::{Affine, Bounds, PictureScale};
pub use choice::{ChunkChoice, DepthMethod, Port};
pub use halver::{Halver, Refined};
pub use land::ChunkLand;
pub use quality::Tolerance;
pub use refine::{RefineKey, RefineRules, unhalved_error_px};
pub use stats::PlanStats;

use skyline::Skyline;

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
struct Candidate {
    place: usize,
    cell: SightCell,
    ring: u32,
}

/// Decides what to draw of `land` in a picture `height_px` pixels high.
pub fn plan(frame: &Frame, height_px: u32, land: &[ChunkLand]) -> FramePlan {
    let scale = PictureScale::new(&frame.projection, height_px);
    let tolerance = Tolerance::of(frame.quality);
    let mut stats = PlanStats::default();
    let candidates = candidates(frame, land, scale, &tolerance, &mut stats);
    let bounds = Bounds::measure(frame, scale);
    let hides =
        tolerance.hides && frame.strategy.keeps_azimuths() && !skyline::is_underground(frame, land);
    let kept = if hides {
        unhidden(frame, land, candidates, scale, &tolerance, &mut stats)
    } else {
        candidates
    };
    let mut chunks: Vec<_> = kept
        .into_iter()
        .map(|candidate| {
            let chunk = &land[candidate.place];
            // A metre takes about as many pixels as the chunk has, over its side.
            let metre_px = scale.spans_px(&candidate.cell) / f64::from(CHUNK_CELLS);
            stats.level_error_at_least(chunk.error_m * metre_px);
            choice::choose(
                frame,
                chunk,
                candidate.place,
                &candidate.cell,
                &bounds,
                &tolerance,
            )
        })
        .collect();
    chunks.sort_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
    for chunk in &chunks {
        stats.count(chunk, &land[chunk.place]);
    }
    FramePlan {
        chunks,
        bounds,
        stats,
    }
}

/// The chunks in the picture and before the fog that span more than the tolerance.
fn candidates(
    frame: &Frame,
    land: &[ChunkLand],
    scale: PictureScale,
    tolerance: &Tolerance,
    stats: &mut PlanStats,
) -> Vec<Candidate> {
    let (strategy, eye) = (frame.strategy.as_ref(), &frame.eye);
    let frustum = strategy.frustum(eye, &frame.projection);
    let home = ChunkCoord::containing(eye.point).index;
    let fog_m = f64::from(frame.fog_distance_m);
    let mut seen = Vec::with_capacity(land.len());
    for (place, chunk) in land.iter().enumerate() {
        let hemisphere = chunk.coord.hemisphere;
        let cell = frustum.cell_seen(strategy, eye, hemisphere, chunk.min, chunk.max);
        match cell.filter(|cell| cell.nearest_m <= fog_m) {
            Some(cell) if scale.spans_px(&cell) < tolerance.small_px => {
                stats.triangles_small += chunk.triangles;
                stats.error_at_least(scale.spans_px(&cell));
            }
            Some(cell) => {
                let steps = chunk.coord.index - home;
                let ring = steps.x.unsigned_abs() + steps.z.unsigned_abs();
                seen.push(Candidate { place, cell, ring });
            }
            None => stats.triangles_outside += chunk.triangles,
        }
    }
    seen
}

/// Leaves out what the skyline of nearer land hides, or all but hides.
///
/// A ray leaves the eye's column through columns of ever greater steps in x and z, so columns are taken in
/// rings of equal sums of steps. Every column in sight distance raises the skyline, in the picture or not.
fn unhidden(
    frame: &Frame,
    land: &[ChunkLand],
    candidates: Vec<Candidate>,
    scale: PictureScale,
    tolerance: &Tolerance,
    stats: &mut PlanStats,
) -> Vec<Candidate> {
    let mut skyline = Skyline::new(frame, scale);
    let mut columns = skyline::columns(frame, land);
    columns.sort_by_key(|column| column.ring);
    let mut columns = columns.into_iter().peekable();
    let mut order = candidates;
    order.sort_by_key(|candidate| candidate.ring);
    let mut left_out = HashSet::new();
    let mut kept = Vec::with_capacity(order.len());
    for candidate in order {
        while let Some(column) = columns.next_if(|column| column.ring < candidate.ring) {
            // Land that was left out hides nothing, or what is left out would add up.
            if !left_out.contains(&column.place) {
                skyline.raise(&column);
            }
        }
        let over_px = skyline.rises_px(&candidate.cell);
        let triangles = land[candidate.place].triangles;
        if over_px <= 0.0 {
            stats.triangles_hidden += triangles;
        } else if over_px < tolerance.small_px {
            stats.triangles_small += triangles;
            left_out.insert(skyline::place_of(&land[candidate.place]));
            stats.error_at_least(over_px);
        } else {
            kept.push(candidate);
        }
    }
    kept
}

/// The bar that a quality keeps a frame's `error_px` under, pixels; `None` where it promises nothing, because
/// edges near the eye are drawn as they are.
pub fn tolerance_px(quality: Quality) -> Option<f64> {
    let tolerance = Tolerance::of(quality);
    let promised = tolerance.small_px.max(tolerance.shape_px);
    (tolerance.halvings > 0).then_some(promised)
}
