//! From the bytes of a journal to what it tells: the room it began with, all steps, and which of them are made.

use std::collections::BTreeSet;
use std::sync::Arc;

use antipode_rooms::{Room, read_so_far};

use super::frames::Frames;
use super::record::{Record, Written, mark_of};
use crate::history::Step;

/// What a journal tells.
#[derive(Debug)]
pub(crate) struct Told {
    /// The text that it began with, and the room of that.
    pub base_text: String,
    pub base: Room,
    /// All steps from there, and how many of them are made.
    pub steps: Vec<Arc<Step>>,
    pub made: usize,
    /// The room with these.
    pub room: Room,
    pub hidden: BTreeSet<String>,
    pub locked: BTreeSet<String>,
    /// Marks of what the file of the room may have, the last first.
    pub saved: [String; 2],
    /// A drag had not ended.
    pub(super) held: Option<Written>,
    /// The step that such a drag is now, and after how many.
    pub ended: Option<(usize, Written)>,
    /// How many bytes of the journal tell that.
    pub good: usize,
    /// Whether what follows is more than a last entry that was not written to its end.
    pub is_damaged: bool,
}

/// Reads a journal; none if it is none.
pub(crate) fn replay(bytes: &[u8]) -> Option<Told> {
    let mut frames = Frames::of(bytes)?;
    let first = serde_json::from_slice(frames.next()?).ok()?;
    let Record::Base(base_text) = first else {
        return None;
    };
    let base = read_so_far("journal", base_text.as_bytes()).ok()?;
    let mark = mark_of(base_text.as_bytes());
    let mut told = Told {
        room: base.clone(),
        base,
        steps: Vec::new(),
        made: 0,
        hidden: BTreeSet::new(),
        locked: BTreeSet::new(),
        saved: [mark.clone(), mark],
        held: None,
        ended: None,
        base_text,
        good: frames.at(),
        is_damaged: false,
    };
    let mut is_read = true;
    while let Some(payload) = frames.next() {
        is_read = serde_json::from_slice(payload).is_ok_and(|it| told.take(it).is_some());
        if !is_read {
            break;
        }
        told.good = frames.at();
    }
    told.is_damaged = told.good < bytes.len() && (!is_read || !frames.is_torn());
    told.end_drag();
    Some(told)
}

impl Told {
    /// Takes an entry; none if it does not fit those before.
    fn take(&mut self, record: Record) -> Option<()> {
        self.held = None;
        match record {
            Record::Base(_) => return None,
            Record::Step { at, step } => {
                self.go(at)?;
                let step = step.step(&self.room)?;
                self.push(step);
            }
            Record::Held { at, step } => {
                self.go(at)?;
                self.held = Some(step);
            }
            Record::Go { to } => self.go(to)?,
            Record::Marks { hidden, locked } => (self.hidden, self.locked) = (hidden, locked),
            Record::Saving(mark) => {
                let [last, _] = std::mem::take(&mut self.saved);
                self.saved = [mark, last];
            }
        }
        Some(())
    }

    fn go(&mut self, to: usize) -> Option<()> {
        let steps = self.steps.get(to.min(self.made)..to.max(self.made))?;
        if to < self.made {
            steps
                .iter()
                .rev()
                .for_each(|it| it.delta.take_back(&mut self.room));
        } else {
            for it in steps {
                it.delta.make(&mut self.room);
            }
        }
        self.made = to;
        Some(())
    }

    pub(super) fn push(&mut self, step: Arc<Step>) {
        step.delta.make(&mut self.room);
        self.steps.truncate(self.made);
        self.steps.push(step);
        self.made += 1;
    }

    /// A drag that had not ended is a step.
    fn end_drag(&mut self) {
        let Some(written) = self.held.take() else {
            return;
        };
        if let Some(step) = written.step(&self.room) {
            self.ended = Some((self.made, written));
            self.push(step);
        }
    }
}
