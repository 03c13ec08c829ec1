//! Schedules chunks: knows what is to be there of each, what is being made and what is there.

use std::collections::VecDeque;
use std::sync::Arc;

use antipode_geometry::{Atlas, ChunkCoord};
use antipode_terrain::{Content, Field, Level};

use crate::maps::{ChunkMap, ChunkSet};
use crate::plan::{Plan, Request, Target};
use crate::queue::Queue;
use crate::range::{Range, around};
use crate::reaches::Reaches;

mod batches;
mod making;
mod wishing;

pub(crate) use making::Verdict;

#[cfg(test)]
mod tests;

/// A chunk to be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Make {
    pub(crate) coord: ChunkCoord,
    pub(crate) level: Level,
    /// With collider and samples; then the level is the full one.
    pub(crate) solid: bool,
}

/// What is there of a chunk.
#[derive(Clone, Copy, Debug)]
struct Shown {
    level: Level,
    solid: bool,
}

/// A chunk being made.
#[derive(Clone, Copy, Debug)]
struct Flight {
    /// The least revision that may still be shown.
    least: u64,
    level: Level,
}

/// The game's bookkeeping of chunks; it has no threads and no channels.
pub(crate) struct ChunkScheduler {
    field: Arc<Field>,
    strategy: Arc<dyn Atlas>,
    /// The last wish, as the next plan is to be made from it.
    wished: Request,
    plan: Arc<Plan>,
    /// Is `wished` not planned yet?
    plan_due: bool,
    planning: bool,
    /// Targets of chunks that were edited after `plan` was asked for.
    late: ChunkMap<Target>,
    /// Chunks whose target may have changed, still to be looked at.
    unsettled: VecDeque<ChunkCoord>,
    queue: Queue,
    /// Chunks whose turn has come, but whose neighbours do not allow it yet.
    blocked: ChunkSet,
    /// Chunks left out since the last wish does not ask for them; the next plan may again.
    left_out: Vec<ChunkCoord>,
    in_flight: ChunkMap<Flight>,
    /// Chunks of the batch under way.
    batch: ChunkSet,
    /// What is there; never without a target but for chunks that are `unsettled`.
    resident: ChunkMap<Shown>,
    /// Those of `resident` that are solid.
    solid: ChunkSet,
    given_up: ChunkSet,
    /// Chunks that own an edit.
    edited: ChunkSet,
    /// Revision of the last batch shown.
    shown: u64,
}

impl ChunkScheduler {
    /// A scheduler for a world whose stored edits lie in `edited`.
    pub(crate) fn new(field: Arc<Field>, strategy: Arc<dyn Atlas>, edited: ChunkSet) -> Self {
        // The cells of a chunk use its own samples and the first layer of the next ones.
        let near_edits = edited
            .iter()
            .flat_map(|&coord| around(coord, -1, 0))
            .collect();
        let plan = Arc::new(Plan::nothing());
        Self {
            field,
            strategy,
            wished: Request {
                range: Range::Nothing,
                detail: None,
                bodies: Reaches::default(),
                near_edits: Arc::new(near_edits),
                before: Arc::clone(&plan),
            },
            plan,
            plan_due: false,
            planning: false,
            late: ChunkMap::default(),
            unsettled: VecDeque::new(),
            queue: Queue::default(),
            blocked: ChunkSet::default(),
            left_out: Vec::new(),
            in_flight: ChunkMap::default(),
            batch: ChunkSet::default(),
            resident: ChunkMap::default(),
            solid: ChunkSet::default(),
            given_up: ChunkSet::default(),
            edited,
            shown: 0,
        }
    }

    fn target(&self, coord: ChunkCoord) -> Option<Target> {
        let planned = self.plan.targets.get(&coord);
        planned.or_else(|| self.late.get(&coord)).copied()
    }

    /// Can the chunk have a surface? What the plan knows is looked up: to decide it anew takes
    /// microseconds.
    fn needs_mesh(&self, coord: ChunkCoord) -> bool {
        if self.wished.near_edits.contains(&coord) {
            return true;
        }
        !self.plan.bare.contains(&coord) && self.field.content(coord) == Content::Surface
    }

    /// Leaves everything that has not begun.
    pub(crate) fn clear_queue(&mut self) {
        self.queue.clear();
        self.blocked.clear();
        self.unsettled.clear();
        self.plan_due = false;
    }

    /// Wants again what [`clear_queue`](Self::clear_queue) has left.
    pub(crate) fn refill_queue(&mut self) {
        let known = self.plan.targets.keys().chain(self.late.keys());
        self.unsettled.extend(known.chain(self.resident.keys()));
        self.plan_due = true;
    }

    /// Notes what is there of a chunk now.
    fn put(&mut self, coord: ChunkCoord, shown: Shown) {
        self.resident.insert(coord, shown);
        if shown.solid {
            self.solid.insert(coord);
        } else {
            self.solid.remove(&coord);
        }
    }

    /// Is something of the chunk still to come, without which it is not ready?
    pub(crate) fn is_coming(&self, coord: ChunkCoord) -> bool {
        if self.is_ready(coord) {
            return false;
        }
        let known = self.queue.contains(coord) || self.blocked.contains(&coord);
        let planning = self.plan_due || self.planning || !self.unsettled.is_empty();
        let planned = planning && self.wished.range.contains(coord);
        known || self.in_flight.contains_key(&coord) || planned
    }

    /// Is some ground that bodies reach still to come?
    pub(crate) fn is_ground_coming(&self) -> bool {
        match self.wished.bodies.list() {
            Some(chunks) => chunks.into_iter().any(|coord| self.is_coming(coord)),
            None => self.coming() > 0,
        }
    }

    /// Is everything the chunk has there, and solid if a body is near? One without a surface has
    /// nothing to wait for.
    pub(crate) fn is_resident(&self, coord: ChunkCoord) -> bool {
        match self.resident.get(&coord) {
            Some(shown) => shown.solid || !self.wished.bodies.wants(coord),
            None => self.wished.range.contains(coord) && !self.needs_mesh(coord),
        }
    }

    /// Is nothing more to come of the chunk? Then it is there, has no surface or was given up.
    pub(crate) fn is_ready(&self, coord: ChunkCoord) -> bool {
        self.is_resident(coord) || self.given_up.contains(&coord)
    }

    /// May bodies move in the chunk? What is there of it for the picture alone does not tell.
    pub(crate) fn is_firm(&self, coord: ChunkCoord) -> bool {
        let solid = |shown: &Shown| shown.solid || self.given_up.contains(&coord);
        let shown = self.resident.get(&coord);
        shown.map_or_else(|| self.is_ready(coord), solid)
    }

    /// Is the chunk within the view last wished for?
    pub(crate) fn is_wanted(&self, coord: ChunkCoord) -> bool {
        self.wished.range.views(coord)
    }

    /// Is the chunk within the view last wished for, or a chunk beyond?
    pub(crate) fn keeps_in_view(&self, coord: ChunkCoord) -> bool {
        self.wished.range.keeps_view(coord)
    }

    /// Chunks waiting, being made, or still to be looked at after a new plan, and one more while a
    /// plan is due or being made.
    pub(crate) fn coming(&self) -> usize {
        let plan = usize::from(self.plan_due || self.planning);
        let waiting = self.unsettled.len() + self.queue.len() + self.blocked.len();
        waiting + self.in_flight.len() + plan
    }

    /// Chunks with a mesh that are there.
    pub(crate) fn resident_count(&self) -> usize {
        self.resident.len()
    }

    /// Chunks of the world that own an edit.
    pub(crate) fn edited_count(&self) -> usize {
        self.edited.len()
    }

    #[cfg(test)]
    pub(crate) fn level(&self, coord: ChunkCoord) -> Option<Level> {
        self.resident.get(&coord).map(|shown| shown.level)
    }
}
