//! Wishes and the plans that are made of them.

use std::sync::Arc;

use antipode_geometry::ChunkCoord;

use super::ChunkScheduler;
use crate::api::Wish;
use crate::plan::{Plan, Planned, Request};
use crate::range::Range;
use crate::reaches::Reaches;

/// Chunks looked at in a frame after a new plan: so many, or this share of those that are left. A
/// plan comes every few metres of way, and all at once its chunks would make one frame several
/// times as long as the others.
pub(super) const LEAST_SETTLED: usize = 8;
pub(super) const SETTLED_SHARE: usize = 8;

impl ChunkScheduler {
    /// Takes a wish; returns the chunks that are no longer solid. The first wish is planned at
    /// once, those after it when [`next_plan`](Self::next_plan) has been carried out.
    pub(crate) fn wish(&mut self, wish: &Wish) -> Vec<ChunkCoord> {
        self.queue.look(wish.centre, wish.front);
        let range = Range::after(&self.wished.range, &*self.strategy, wish);
        let bodies = Reaches::of(&wish.bodies).within(range.bodies());
        let same_detail = match (&self.wished.detail, &wish.detail) {
            (Some(before), Some(now)) => Arc::ptr_eq(before, now),
            (None, None) => true,
            _ => false,
        };
        let same_bodies = bodies == self.wished.bodies;
        if range == self.wished.range && same_detail && same_bodies {
            return Vec::new();
        }
        self.wished.range = range;
        self.wished.detail.clone_from(&wish.detail);
        let before = std::mem::replace(&mut self.wished.bodies, bodies);
        self.plan_due = true;
        if self.plan.range == Range::Nothing {
            self.plan_now();
        }
        if same_bodies {
            Vec::new()
        } else {
            self.move_bodies(&before)
        }
    }

    /// Plans the first wish, so that there is something to begin with.
    fn plan_now(&mut self) {
        if let Some(request) = self.next_plan() {
            let planned = request.plan(&self.field);
            self.planned(planned);
            // Nothing can be gone yet.
            self.settle_all();
        }
    }

    /// Ground that bodies have come to is asked for; returns what they have left.
    fn move_bodies(&mut self, before: &Reaches) -> Vec<ChunkCoord> {
        let bodies = &self.wished.bodies;
        let left = self.solid.extract_if(|&coord| !bodies.keeps(coord));
        let mut left: Vec<_> = left.collect();
        left.sort_unstable();
        for coord in &left {
            if let Some(shown) = self.resident.get_mut(coord) {
                shown.solid = false;
            }
        }
        // What was wanted before has been asked for.
        let come = |&coord: &ChunkCoord| bodies.wants(coord) && !before.wants(coord);
        let hollow = |coord: &ChunkCoord| self.resident.get(coord).is_some_and(|it| !it.solid);
        let reached: Vec<_> = match bodies.list() {
            Some(near) => near.into_iter().filter(come).filter(hollow).collect(),
            None => self
                .resident
                .keys()
                .copied()
                .filter(come)
                .filter(hollow)
                .collect(),
        };
        for &coord in reached.iter().chain(&left) {
            self.enqueue(coord);
        }
        left
    }

    /// The plan to be made next, if one is due and none is being made.
    pub(crate) fn next_plan(&mut self) -> Option<Request> {
        if !self.plan_due || self.planning {
            return None;
        }
        self.plan_due = false;
        self.planning = true;
        Some(self.wished.clone())
    }

    /// Takes back a plan that could not be handed over.
    pub(crate) fn plan_not_made(&mut self) {
        self.planning = false;
        self.plan_due = true;
    }

    /// Notes that a plan could not be made; the next wish asks for another.
    pub(crate) fn plan_failed(&mut self) {
        self.planning = false;
    }

    /// Takes a plan over, to be carried out by [`settle_some`](Self::settle_some); returns the one
    /// before, which is large.
    pub(crate) fn planned(&mut self, planned: Planned) -> Arc<Plan> {
        let Planned { plan, changed } = planned;
        self.planning = false;
        self.plan = Arc::new(plan);
        let plan = &*self.plan;
        let late = &mut self.late;
        let settled = late
            .extract_if(|&coord, _| !plan.range.keeps(coord) || plan.targets.contains_key(&coord));
        self.unsettled.extend(settled.map(|(coord, _)| coord));
        self.unsettled.extend(changed);
        self.unsettled
            .append(&mut std::mem::take(&mut self.left_out).into());
        std::mem::replace(&mut self.wished.before, Arc::clone(&self.plan))
    }

    /// Carries out a frame's share of the plan; returns chunks that are gone.
    pub(crate) fn settle_some(&mut self) -> Vec<ChunkCoord> {
        self.settle(LEAST_SETTLED.max(self.unsettled.len() / SETTLED_SHARE))
    }

    /// Carries out the whole plan; returns the chunks that are gone.
    pub(crate) fn settle_all(&mut self) -> Vec<ChunkCoord> {
        self.settle(self.unsettled.len())
    }

    fn settle(&mut self, most: usize) -> Vec<ChunkCoord> {
        let mut gone = Vec::new();
        for _ in 0..most {
            let Some(coord) = self.unsettled.pop_front() else {
                break;
            };
            if self.target(coord).is_some() {
                self.enqueue(coord);
            } else if self.forget(coord) {
                gone.push(coord);
            }
        }
        gone
    }

    /// Lets go of a chunk that has no target any more; true if it was there.
    fn forget(&mut self, coord: ChunkCoord) -> bool {
        self.queue.remove(coord);
        self.blocked.remove(&coord);
        self.given_up.remove(&coord);
        self.solid.remove(&coord);
        let was_there = self.resident.remove(&coord).is_some();
        if was_there {
            self.release_beside(coord);
        }
        was_there
    }
}
