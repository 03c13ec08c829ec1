//! The thread that owns commits: waiting for the disk must never delay an edit or a load.

use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};

use antipode_storage::{Batch, RecordChanges, WorldMeta};
use antipode_terrain::ChunkEdits;
use crossbeam_channel::{Receiver, Sender};

use crate::api::Cause;
use crate::edit_backend::key_of;
use crate::edit_store::EditMap;
use crate::outcome::Outcome;
use crate::shared::Shared;
use crate::worker::reason;

/// What a save holds, all of one moment.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) meta: Option<WorldMeta>,
    /// Records that changed, and those of what is gone.
    pub(crate) records: RecordChanges,
    pub(crate) land: EditMap,
}

impl Parts {
    /// Adds what `older` has and this has no newer one of.
    pub(crate) fn or(self, older: Self) -> Self {
        let mut land = older.land;
        land.extend(self.land);
        let mut records = older.records;
        records.extend(self.records);
        Self {
            land,
            meta: self.meta.or(older.meta),
            records,
        }
    }
}

/// A commit that failed.
pub(crate) struct Unsaved {
    pub(crate) why: Cause,
    /// What is not on disk.
    pub(crate) parts: Parts,
}

/// Saves until the game lets go of the channel; then once more, so that a game that ended without
/// closing loses no edit.
pub(crate) fn run(shared: &Shared, jobs: &Receiver<Box<Parts>>, results: &Sender<Outcome>) {
    for parts in jobs {
        let _ = results.send(Outcome::Saved(commit(shared, *parts)));
    }
    let last = Parts {
        land: shared.edit_store.unsaved(),
        ..Parts::default()
    };
    if let Some(Unsaved { why, .. }) = commit(shared, last) {
        tracing::error!("The last changes to the terrain are not saved. {why}");
    }
}

/// The edits of a chunk as they are stored; none of one of which nothing is left, whose record goes.
fn units(edits: &ChunkEdits) -> Vec<i16> {
    if edits.is_untouched() {
        Vec::new()
    } else {
        edits.to_units()
    }
}

/// One transaction of all the parts.
fn commit(shared: &Shared, parts: Parts) -> Option<Unsaved> {
    let backend = shared.edit_store.backend()?;
    let Parts {
        meta,
        records,
        land,
    } = parts;
    let chunks = land
        .iter()
        .map(|(coord, edits)| (key_of(*coord), units(edits)))
        .collect();
    let laid = |edits: &ChunkEdits| Some(edits.kind_bytes().to_vec()).filter(|it| !it.is_empty());
    let kinds = (land.iter())
        .filter_map(|(coord, edits)| Some((key_of(*coord), laid(edits)?)))
        .collect();
    let batch = Batch {
        meta,
        records,
        chunks,
        kinds,
    };
    if batch.is_empty() {
        return None;
    }
    let why = match catch_unwind(AssertUnwindSafe(|| backend.commit(&batch))) {
        Ok(Ok(())) => {
            shared.edit_store.saved(&land);
            shared.edit_store.forget_saved();
            return None;
        }
        Ok(Err(why)) => Cause::from(why),
        Err(panic) => {
            Box::<dyn Error + Send + Sync>::from(format!("The store failed: {}.", reason(&*panic)))
                .into()
        }
    };
    Some(Unsaved {
        why,
        parts: Parts {
            meta: batch.meta,
            records: batch.records,
            land,
        },
    })
}
