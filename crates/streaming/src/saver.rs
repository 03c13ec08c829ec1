//! The thread that owns commits: waiting for the disk must never delay an edit or a load.

use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};

use antipode_storage::{Batch, WorldMeta, WorldState};
use crossbeam_channel::{Receiver, Sender};

use crate::api::Cause;
use crate::outcome::Outcome;
use crate::shared::Shared;
use crate::vault::key_of;
use crate::worker::reason;

/// What the game adds to a save; the chunks come from the book.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub(crate) meta: Option<WorldMeta>,
    pub(crate) state: Option<WorldState>,
}

impl Parts {
    /// Takes from `older` what is missing here.
    pub(crate) fn or(self, older: Self) -> Self {
        Self {
            meta: self.meta.or(older.meta),
            state: self.state.or(older.state),
        }
    }
}

/// A commit that failed.
pub(crate) struct Unsaved {
    pub(crate) why: Cause,
    /// What is not on disk; the chunks are unsaved in the book again.
    pub(crate) parts: Parts,
}

/// Saves until the game lets go of the channel; then once more, so that a game that ended without
/// closing loses no edit.
pub(crate) fn run(shared: &Shared, jobs: &Receiver<Box<Parts>>, results: &Sender<Outcome>) {
    for parts in jobs {
        let _ = results.send(Outcome::Saved(commit(shared, *parts)));
    }
    if let Some(Unsaved { why, .. }) = commit(shared, Parts::default()) {
        tracing::error!("The last changes to the terrain are not saved. {why}");
    }
}

/// One transaction of the parts and every unsaved chunk.
fn commit(shared: &Shared, parts: Parts) -> Option<Unsaved> {
    let vault = shared.book.vault()?;
    let dirty = shared.book.take_dirty();
    let chunks = dirty
        .iter()
        .map(|(coord, edits)| (key_of(*coord), edits.to_units()))
        .collect();
    let batch = Batch {
        meta: parts.meta,
        state: parts.state,
        chunks,
    };
    if batch.is_empty() {
        return None;
    }
    let why = match catch_unwind(AssertUnwindSafe(|| vault.commit(&batch))) {
        Ok(Ok(())) => {
            shared.book.forget_saved();
            return None;
        }
        Ok(Err(why)) => Cause::from(why),
        Err(panic) => {
            Box::<dyn Error + Send + Sync>::from(format!("The store failed: {}.", reason(&*panic)))
                .into()
        }
    };
    shared.book.put_back(dirty.iter().map(|(coord, _)| *coord));
    Some(Unsaved {
        why,
        parts: Parts {
            meta: batch.meta,
            state: batch.state,
        },
    })
}
