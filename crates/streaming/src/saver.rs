//! The thread that owns commits: waiting for the disk must never delay an edit or a load.

use antipode_storage::{Batch, WorldMeta, WorldState};
use crossbeam_channel::{Receiver, Sender};

use crate::outcome::{Outcome, SaveReport};
use crate::shared::Shared;
use crate::vault::key_of;

/// What the game adds to a save; the chunks come from the book.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    pub(crate) meta: Option<WorldMeta>,
    pub(crate) state: Option<WorldState>,
}

impl Parts {
    /// Takes from `older` what is missing here.
    pub(crate) fn or(self, older: Self) -> Self {
        Self { meta: self.meta.or(older.meta), state: self.state.or(older.state) }
    }
}

/// Saves until the game lets go of the channel; then once more, so that a game that ended without
/// closing loses no edit.
pub(crate) fn run(shared: &Shared, jobs: &Receiver<Parts>, results: &Sender<Outcome>) {
    for parts in jobs {
        let report = SaveReport { failed: commit(shared, parts).err() };
        let _ = results.send(Outcome::Saved(report));
    }
    if let Err((why, _)) = commit(shared, Parts::default()) {
        tracing::error!("the last edits of the terrain are not saved: {why}");
    }
}

/// One transaction of the parts and every unsaved chunk; on failure the chunks stay unsaved.
fn commit(shared: &Shared, parts: Parts) -> Result<(), (String, Parts)> {
    let Some(vault) = shared.book.vault() else { return Ok(()) };
    let dirty = shared.book.take_dirty();
    if dirty.is_empty() && parts.meta.is_none() && parts.state.is_none() {
        return Ok(());
    }
    let chunks = dirty.iter().map(|(coord, edits)| (key_of(*coord), edits.to_units())).collect();
    let batch = Batch { meta: parts.meta, state: parts.state, chunks };
    match vault.commit(&batch) {
        Ok(()) => Ok(()),
        Err(why) => {
            shared.book.put_back(dirty.iter().map(|(coord, _)| *coord));
            Err((why.to_string(), Parts { meta: batch.meta, state: batch.state }))
        }
    }
}
