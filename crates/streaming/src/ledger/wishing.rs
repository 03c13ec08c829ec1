//! Wishes and the plans that are made of them.

use std::sync::Arc;

use antipode_geometry::ChunkCoord;

use super::Ledger;
use crate::api::Wish;
use crate::plan::{Planned, Request};
use crate::range::Range;
use crate::reaches::Reaches;

impl Ledger {
    /// Takes a wish; returns the chunks that are no longer solid. The first wish is planned at
    /// once, those after it when [`next_plan`](Self::next_plan) has been carried out.
    pub(crate) fn wish(&mut self, wish: &Wish) -> Vec<ChunkCoord> {
        self.queue.look(wish.centre, wish.front);
        let range = Range::wished(&*self.strategy, wish.centre, wish.view_distance);
        let bodies = Reaches::of(&wish.bodies);
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
        self.wished.bodies = bodies;
        self.plan_due = true;
        if self.plan.range == Range::Nothing {
            self.plan_now();
        }
        if same_bodies {
            Vec::new()
        } else {
            self.move_bodies()
        }
    }

    /// Plans the first wish, so that there is something to begin with.
    fn plan_now(&mut self) {
        if let Some(request) = self.next_plan() {
            let planned = request.plan(&self.field);
            self.planned(planned);
        }
    }

    /// Ground that bodies have come to is asked for; returns what they have left.
    fn move_bodies(&mut self) -> Vec<ChunkCoord> {
        let bodies = &self.wished.bodies;
        let mut left = Vec::new();
        let mut reached = Vec::new();
        for (&coord, shown) in &mut self.resident {
            if shown.solid && !bodies.keeps(coord) {
                shown.solid = false;
                left.push(coord);
            } else if !shown.solid && bodies.wants(coord) {
                reached.push(coord);
            }
        }
        left.sort_unstable();
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
        self.wished.before = Arc::clone(&self.plan);
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

    /// Takes a plan over; returns the chunks that are gone.
    pub(crate) fn planned(&mut self, planned: Planned) -> Vec<ChunkCoord> {
        let Planned { plan, changed } = planned;
        self.planning = false;
        self.plan = Arc::new(plan);
        let plan = &*self.plan;
        self.late
            .retain(|&coord, _| plan.range.keeps(coord) && !plan.targets.contains_key(&coord));
        let late = &self.late;
        let stays = |coord| plan.targets.contains_key(&coord) || late.contains_key(&coord);
        self.queue.retain(stays);
        self.blocked.retain(|&coord| stays(coord));
        self.given_up.retain(|&coord| stays(coord));
        let mut gone: Vec<_> = self
            .resident
            .extract_if(|&coord, _| !stays(coord))
            .map(|(coord, _)| coord)
            .collect();
        gone.sort_unstable();
        let left_out = std::mem::take(&mut self.left_out);
        for coord in changed.into_iter().chain(left_out) {
            self.enqueue(coord);
        }
        gone
    }
}
