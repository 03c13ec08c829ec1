//! What a journal keeps, as JSON; rooms and objects in it are text as in `room.ron`, so that there is one format of them.

use std::collections::BTreeSet;
use std::sync::Arc;

use antipode_rooms::{Room, read_so_far, write_so_far};
use serde::{Deserialize, Serialize};

use crate::delta::{Delta, frame};
use crate::history::Step;
use crate::said::Said;

/// One entry of a journal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) enum Record {
    /// The text of the room that the journal begins with.
    Base(String),
    /// A step that was made after the first `at` of all; those behind were gone then.
    Step { at: usize, step: Written },
    /// What a drag has done so far; the next record takes its place.
    Held { at: usize, step: Written },
    /// The first `to` steps were made from then on.
    Go { to: usize },
    /// What was hidden and locked from then on.
    Marks {
        hidden: BTreeSet<String>,
        locked: BTreeSet<String>,
    },
    /// A text with that mark is about to be the file of the room.
    Saving(String),
}

/// A step as it is written: what it leads to. What it leads back to is told by the room before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Written {
    said: Said,
    /// Places of what was taken out.
    out: Vec<usize>,
    /// Places of what was put in, the first of the room's objects.
    put: Vec<usize>,
    /// Places of what was changed, the rest of them.
    set: Vec<usize>,
    /// The text of a room with what was put in and changed, and its own fields as they are after.
    room: String,
}

impl Written {
    /// Of a step, and the room as it is behind it.
    pub fn of(step: &Step, after: &Room) -> Self {
        let delta = &step.delta;
        let mut room = frame(after);
        let put = delta.inserted.iter().map(|(_, it)| it);
        let set = delta.changed.iter().map(|(_, _, it)| it);
        room.objects = put.chain(set).cloned().collect();
        Self {
            said: step.said.clone(),
            out: delta.removed.iter().map(|it| it.0).collect(),
            put: delta.inserted.iter().map(|it| it.0).collect(),
            set: delta.changed.iter().map(|it| it.0).collect(),
            room: write_so_far(&room),
        }
    }

    /// The step, of the room before it. None if it does not fit that.
    pub fn step(&self, before: &Room) -> Option<Arc<Step>> {
        let mut read = read_so_far("journal", self.room.as_bytes()).ok()?;
        let mut objects = std::mem::take(&mut read.objects).into_iter();
        let out = self
            .out
            .iter()
            .map(|index| Some((*index, before.objects.get(*index)?.clone())));
        let mut delta = Delta {
            removed: out.collect::<Option<_>>()?,
            inserted: Vec::new(),
            changed: Vec::new(),
            frame: None,
        };
        let put = self.put.iter().map(|index| Some((*index, objects.next()?)));
        delta.inserted = put.collect::<Option<_>>()?;
        let was = frame(before);
        if was != read {
            delta.frame = Some(Box::new((was, read)));
        }
        // What was changed is told by its place after, so by a room in which all the rest is done.
        let mut moved = before.clone();
        delta
            .is_in_order(before.objects.len())
            .then(|| delta.make(&mut moved))?;
        let set = self
            .set
            .iter()
            .map(|index| Some((*index, moved.objects.get(*index)?.clone(), objects.next()?)));
        delta.changed = set.collect::<Option<_>>()?;
        Some(Arc::new(Step {
            said: self.said.clone(),
            delta,
        }))
    }
}

/// A mark of a file's bytes, by which it is known again.
pub(crate) fn mark_of(bytes: &[u8]) -> String {
    format!("{:032x}", twox_hash::XxHash3_128::oneshot(bytes))
}
