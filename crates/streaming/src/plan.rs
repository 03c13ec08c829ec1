//! The plan: which chunks are to be there and at which level. Made on a worker, since a wide range
//! has tens of thousands of chunks to ask about; only the first is made on the spot.

use std::sync::Arc;

use antipode_geometry::tiled::fits;
use antipode_geometry::{Atlas, CHUNK_CELLS, ChartId, ChunkCoord, Domain};
use antipode_terrain::{Content, Field, Level, RIM_REACH_M};
use glam::{DVec2, I64Vec3, Vec3Swizzles};

use crate::api::Detail;
use crate::levels::{choose, relax};
use crate::maps::{ChunkMap, ChunkSet};
use crate::range::Range;
use crate::reaches::Reaches;

/// Chunks that take fewer pixels than this are not loaded, and those that are there already go
/// below half of it.
const LEAST_SPAN_PX: f64 = 0.5;
const KEPT_SPAN_PX: f64 = LEAST_SPAN_PX / 2.0;

/// Where the charts of a closed world meet, two meshes that do not know of each other end at one
/// line; there only this share of the error is let pass.
const RIM_SHARE: f64 = 0.25;

/// Within [`NEAR_CHUNKS`] of the eye levels are as fine as the quality asks. By that rule alone rough
/// land would be made in full as far as one can see; so a wider range may cost this many times what
/// is near, and what is farther is as coarse as that takes. Less than the two that is promised,
/// since levels do not cost exactly a quarter of each other, and not all ways look over as much land.
const FAR_SHARE: f64 = 1.6;
const NEAR_CHUNKS: i64 = 6;
/// What a closed world may cost, in chunks of full level: about what is near in an open one, twice.
const CLOSED_BUDGET: f64 = 400.0;
/// Where that does not suffice, what is let pass grows by this from step to step, up to a most.
const LENIENCY_STEP: f64 = 1.25;
const MOST_LENIENT: f64 = 32.0;
/// Levels become stricter again where they then stay within this share of the budget.
const SPARE_SHARE: f64 = 0.85;

/// What is planned for a chunk that has a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    pub(crate) level: Level,
    /// To be loaded; else only kept if it is there already.
    pub(crate) wanted: bool,
}

/// How a chunk looks in the picture.
#[derive(Clone, Copy, Debug)]
struct Look {
    errors_px: [f64; Level::ALL.len()],
    wanted: bool,
}

/// Targets of every chunk with a surface in range and a little beyond.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) targets: ChunkMap<Target>,
    /// Chunks near bodies that untouched ground does not come into: the game asks about them in
    /// every frame.
    pub(crate) bare: ChunkSet,
    pub(crate) range: Range,
    /// How many times what the quality lets pass the levels were allowed to be off.
    pub(crate) leniency: f64,
}

impl Plan {
    /// Nothing is to be there.
    pub(crate) fn nothing() -> Self {
        Self {
            targets: ChunkMap::default(),
            bare: ChunkSet::default(),
            range: Range::Nothing,
            leniency: 1.0,
        }
    }
}

/// What a plan is made from.
#[derive(Clone, Debug)]
pub(crate) struct Request {
    pub(crate) range: Range,
    pub(crate) detail: Option<Arc<dyn Detail>>,
    pub(crate) bodies: Reaches,
    /// Chunks that may have a surface because of an edit.
    pub(crate) near_edits: Arc<ChunkSet>,
    pub(crate) before: Arc<Plan>,
}

/// A plan, and what it changes.
#[derive(Debug)]
pub(crate) struct Planned {
    pub(crate) plan: Plan,
    /// Chunks with another target than before, among them those that had or have none; in the order
    /// in which to look at them.
    pub(crate) changed: Vec<ChunkCoord>,
}

impl Request {
    /// Makes the plan.
    pub(crate) fn plan(&self, field: &Field) -> Planned {
        let (looks, bare) = self.looks(field);
        let (levels, leniency) = self.affordable(&**field.strategy(), &looks);
        let target = |(coord, level)| {
            let wanted = looks.get(&coord).is_some_and(|look| look.wanted);
            (coord, Target { level, wanted })
        };
        let targets: ChunkMap<_> = levels.into_iter().map(target).collect();
        let changed = self.changed(&targets);
        Planned {
            changed,
            plan: Plan {
                targets,
                bare,
                range: self.range.clone(),
                leniency,
            },
        }
    }

    /// The chunks that are gone, in their order, and then those with another target than before, or
    /// none before: nearest first, since they are looked at some each frame.
    fn changed(&self, targets: &ChunkMap<Target>) -> Vec<ChunkCoord> {
        let before = &self.before.targets;
        let gone = before.keys().filter(|coord| !targets.contains_key(coord));
        let mut changed: Vec<_> = gone.copied().collect();
        changed.sort_unstable();
        let differs = |(coord, target): &(&ChunkCoord, &Target)| before.get(coord) != Some(target);
        let differing = targets.iter().filter(differs).map(|(&coord, _)| coord);
        let mut differing: Vec<_> = differing.collect();
        differing.sort_unstable_by_key(|&coord| (self.apart2(coord), coord));
        changed.append(&mut differing);
        changed
    }

    /// Squared distance from the middle of the range in chunks; 0 in a closed world, which has none.
    fn apart2(&self, coord: ChunkCoord) -> i64 {
        let apart = self.range.apart(coord);
        apart.map_or(0, I64Vec3::length_squared)
    }

    /// Every chunk with a surface that is large enough to be there, and those near bodies that
    /// have none.
    fn looks(&self, field: &Field) -> (ChunkMap<Look>, ChunkSet) {
        let (mut looks, mut bare) = (ChunkMap::default(), ChunkSet::default());
        let past_edges = self.range.past_edges(&self.bodies);
        for coord in self.range.kept().into_iter().chain(past_edges) {
            if !self.near_edits.contains(&coord) && field.content(coord) != Content::Surface {
                if self.bodies.keeps(coord) {
                    bare.insert(coord);
                }
                continue;
            }
            if !self.range.keeps_view(coord) && !self.bodies.keeps(coord) {
                continue;
            }
            let span_px = self.span_px(coord);
            if span_px < KEPT_SPAN_PX {
                continue;
            }
            let look = Look {
                errors_px: self.errors_px(field, coord),
                wanted: span_px >= LEAST_SPAN_PX && self.is_to_be_loaded(coord),
            };
            looks.insert(coord, look);
        }
        (looks, bare)
    }

    fn is_to_be_loaded(&self, coord: ChunkCoord) -> bool {
        let viewed = self.range.views(coord);
        viewed || self.range.contains(coord) && self.bodies.wants(coord)
    }

    /// The levels, and how many times what the quality lets pass they had to be allowed, so that
    /// the whole stays within what may be drawn. Of two that would do it is the one before, unless
    /// the stricter has room to spare.
    fn affordable(&self, atlas: &dyn Atlas, looks: &ChunkMap<Look>) -> (ChunkMap<Level>, f64) {
        let strict = self.levels(atlas, looks, 1.0);
        let exact = self.detail.as_ref().is_none_or(|d| d.tolerance_px() <= 0.0);
        if exact {
            return (strict, 1.0);
        }
        let affordable = self.budget(atlas, looks, &strict);
        let mut levels = strict;
        let mut leniency = 1.0;
        while leniency < MOST_LENIENT {
            let share = if leniency < self.before.leniency {
                SPARE_SHARE
            } else {
                1.0
            };
            if cost(atlas, &levels, |coord| looks[&coord].wanted) <= affordable * share {
                break;
            }
            leniency *= LENIENCY_STEP;
            levels = self.levels(atlas, looks, leniency);
        }
        (levels, leniency)
    }

    /// What may be drawn, in chunks of full level.
    fn budget(&self, atlas: &dyn Atlas, looks: &ChunkMap<Look>, strict: &ChunkMap<Level>) -> f64 {
        if matches!(self.range, Range::Whole(_)) {
            return CLOSED_BUDGET;
        }
        let disc_m = near_disc_m(atlas);
        FAR_SHARE
            * cost(atlas, strict, |coord| {
                self.is_near(disc_m, coord) && looks[&coord].wanted
            })
    }

    /// Whether the chunk is so near that nothing but the quality tells its level. Where land grows faster than in flat space, near
    /// is as much of it as there: the disc of radius `disc_m`.
    fn is_near(&self, disc_m: Option<f64>, coord: ChunkCoord) -> bool {
        let apart = self.range.apart(coord);
        apart.is_some_and(|it| {
            let away_m = it.xz().as_dvec2().length() * f64::from(CHUNK_CELLS);
            let is_in_disc = disc_m.is_none_or(|disc_m| away_m <= disc_m);
            it.abs().max_element() <= NEAR_CHUNKS && is_in_disc
        })
    }

    fn levels(&self, atlas: &dyn Atlas, looks: &ChunkMap<Look>, leniency: f64) -> ChunkMap<Level> {
        let tolerance_px = self.detail.as_ref().map_or(0.0, |d| d.tolerance_px());
        let disc_m = near_disc_m(atlas);
        let level = |(&coord, look): (&ChunkCoord, &Look)| {
            let before = self.before.targets.get(&coord).map(|target| target.level);
            let let_pass = if self.is_near(disc_m, coord) {
                1.0
            } else {
                leniency
            };
            let level = choose(&look.errors_px, 1.0, tolerance_px * let_pass, before);
            (coord, level)
        };
        let mut levels = looks.iter().map(level).collect();
        relax(atlas, &mut levels);
        levels
    }

    /// The level of a chunk as such, whatever its neighbours have.
    pub(crate) fn level(&self, field: &Field, coord: ChunkCoord) -> Level {
        let tolerance_px = self.detail.as_ref().map_or(0.0, |d| d.tolerance_px());
        let before = self.before.targets.get(&coord).map(|target| target.level);
        let errors_px = self.errors_px(field, coord);
        choose(&errors_px, 1.0, tolerance_px * self.before.leniency, before)
    }

    /// What each level of a chunk is off by in the picture; without one, and near bodies, anything
    /// but the full level is off without bound.
    fn errors_px(&self, field: &Field, coord: ChunkCoord) -> [f64; Level::ALL.len()] {
        let Some(detail) = self.detail.as_ref().filter(|_| !self.bodies.keeps(coord)) else {
            return Level::ALL.map(|level| match level {
                Level::FULL => 0.0,
                _ => f64::INFINITY,
            });
        };
        let share = if meets_rim(&**field.strategy(), coord) {
            RIM_SHARE
        } else {
            1.0
        };
        let pixels_per_metre = detail.pixels_per_metre(coord);
        errors_m(field, self.near_edits.contains(&coord))
            .map(|error_m| error_m * pixels_per_metre / share)
    }

    /// Pixels that a chunk takes from one end to the other; ground near bodies always counts.
    fn span_px(&self, coord: ChunkCoord) -> f64 {
        match &self.detail {
            Some(detail) if !self.bodies.keeps(coord) => detail.span_px(coord),
            _ => f64::INFINITY,
        }
    }
}

/// How far what is near goes in a world in tiles, metres: as much is meshed there as flat space has within [`NEAR_CHUNKS`]. Where edges
/// run through chunks, tiles are meshed past them, too.
fn near_disc_m(atlas: &dyn Atlas) -> Option<f64> {
    let tiled = atlas.tiled()?;
    let side_m = (2.0 * NEAR_CHUNKS as f64 + 1.0) * f64::from(CHUNK_CELLS);
    let half_m = atlas.domain(ChartId::FIRST).half_width_m();
    let made = if fits(atlas, ChartId::FIRST) {
        1.0
    } else {
        1.0 + RIM_REACH_M / half_m
    };
    Some(tiled.disc_m((side_m / made).powi(2)))
}

/// What the chunks that count cost, in chunks of full level: half the resolution has a quarter of
/// the triangles. Of a chunk that an edge runs through counts what is made of it.
fn cost(atlas: &dyn Atlas, levels: &ChunkMap<Level>, counts: impl Fn(ChunkCoord) -> bool) -> f64 {
    let is_tiled = atlas.tiled().is_some();
    let own = |(&coord, level): (&ChunkCoord, &Level)| {
        let share = if is_tiled {
            made_share(atlas, coord)
        } else {
            1.0
        };
        share * 0.25_f64.powi(level.index() as i32)
    };
    levels
        .iter()
        .filter(|&(&coord, _)| counts(coord))
        .map(own)
        .sum()
}

/// The part of a chunk's ground plan that is meshed, 0 to 1.
fn made_share(atlas: &dyn Atlas, coord: ChunkCoord) -> f64 {
    let Domain::Rectangle { low, high } = atlas.domain(coord.chart) else {
        return 1.0;
    };
    let first = coord.min().xz().max(low - RIM_REACH_M);
    let last = coord.max().xz().min(high + RIM_REACH_M);
    let sides = (last - first).max(DVec2::ZERO) / f64::from(CHUNK_CELLS);
    sides.x * sides.y
}

/// What each level may be off by, in metres. What was dug or built may be as thin as a cell of any
/// level, and is wholly lost then.
fn errors_m(field: &Field, edited: bool) -> [f64; Level::ALL.len()] {
    Level::ALL.map(|level| match level {
        Level::FULL => 0.0,
        _ if edited => f64::from(level.step_m()),
        _ => field.level_error_m(level),
    })
}

/// Does the chunk touch the line where its chart's domain ends, and is what lies beyond no chunk that shares its face there?
fn meets_rim(strategy: &dyn Atlas, coord: ChunkCoord) -> bool {
    let (low, high) = (coord.min().xz(), coord.max().xz());
    let domain = strategy.domain(coord.chart);
    let touches =
        domain.least_outside_m(low, high) <= RIM_REACH_M && domain.most_outside_m(low, high) >= 0.0;
    touches && !fits(strategy, coord.chart)
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod tile_tests;
