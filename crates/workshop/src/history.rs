//! The steps that were made, and which of them are made now.

use std::sync::Arc;

use antipode_rooms::Room;

use crate::delta::Delta;
use crate::said::Said;

/// The fewest steps that can be taken back, if so many were made. Older ones are forgotten some at a time.
pub const LEAST_STEPS: usize = 1000;
/// How many there are before the oldest are forgotten.
const MOST_STEPS: usize = LEAST_STEPS + 500;

/// A step: what was done, and the way there and back.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// What was done, in words.
    pub said: Said,
    /// The way from the room before to the room after.
    pub delta: Delta,
}

/// All steps, and how many of them are made.
#[derive(Debug, Clone, Default)]
pub struct History {
    steps: Vec<Arc<Step>>,
    made: usize,
    /// How many older ones were forgotten.
    forgotten: usize,
}

impl History {
    /// Steps of which the first `made` are made.
    pub(crate) fn of(steps: Vec<Arc<Step>>, made: usize) -> Self {
        Self {
            steps,
            made,
            forgotten: 0,
        }
    }

    /// The steps in their order, the oldest first.
    pub fn steps(&self) -> &[Arc<Step>] {
        &self.steps
    }

    /// How many of them are made; those behind were taken back.
    pub fn made(&self) -> usize {
        self.made
    }

    /// How many older steps cannot be taken back any more.
    pub fn forgotten(&self) -> usize {
        self.forgotten
    }

    /// Adds a step that was made; what was taken back is gone.
    pub(crate) fn push(&mut self, step: Arc<Step>) {
        self.steps.truncate(self.made);
        self.steps.push(step);
        if self.steps.len() > MOST_STEPS {
            let old = self.steps.len() - LEAST_STEPS;
            self.steps.drain(..old);
            self.forgotten += old;
        }
        self.made = self.steps.len();
    }

    /// The room when `to` steps are made, of the room as it is. `to` is at most the number of steps.
    pub(crate) fn room_at(&self, room: &Room, to: usize) -> Room {
        let mut room = room.clone();
        if to < self.made {
            self.steps[to..self.made]
                .iter()
                .rev()
                .for_each(|it| it.delta.take_back(&mut room));
        } else {
            self.steps[self.made..to]
                .iter()
                .for_each(|it| it.delta.make(&mut room));
        }
        room
    }

    pub(crate) fn go(&mut self, to: usize) {
        self.made = to.min(self.steps.len());
    }
}
