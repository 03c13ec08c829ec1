//! A chunk worker: edits before loads, and no panic leaves it.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use crossbeam_channel::{Receiver, Sender, select_biased};

use crate::outcome::{Loaded, Outcome};
use crate::round::{EditBatch, Round};
use crate::shared::{Shared, Step};

/// Times a job is tried before it is given up.
const TRIES: u32 = 2;

/// Work that outranks loading.
pub(crate) enum EditJob {
    /// Apply a batch and see it through.
    Begin(EditBatch),
    /// Help with a batch that another worker has begun.
    Help(Arc<Round>),
}

/// A worker's ends of the channels.
#[derive(Clone)]
pub(crate) struct Desk {
    pub(crate) edits: Receiver<EditJob>,
    /// For calls for help; never waited on.
    pub(crate) call: Sender<EditJob>,
    pub(crate) loads: Receiver<ChunkCoord>,
    pub(crate) results: Sender<Outcome>,
    pub(crate) colleagues: usize,
}

impl Desk {
    /// Works until the game lets go of the load channel. The result channel has room for every job
    /// in flight, so sending never waits; if the game is gone, nobody misses the result.
    pub(crate) fn work(&self, shared: &Shared) {
        while !shared.is_stopped() {
            select_biased! {
                recv(self.edits) -> job => match job {
                    Ok(job) => self.edit(shared, job),
                    Err(_) => return,
                },
                recv(self.loads) -> coord => match coord {
                    Ok(coord) => {
                        let _ = self.results.send(Outcome::Loaded(load(shared, coord)));
                    }
                    Err(_) => return,
                },
            }
        }
    }

    fn edit(&self, shared: &Shared, job: EditJob) {
        let round = match job {
            EditJob::Help(round) => round,
            EditJob::Begin(batch) => {
                let round = Arc::new(Round::begin(shared, &batch));
                for _ in 1..round.len().min(self.colleagues + 1) {
                    // Help that cannot be called is done without.
                    let _ = self.call.try_send(EditJob::Help(Arc::clone(&round)));
                }
                round
            }
        };
        if let Some(edited) = round.help(shared) {
            let _ = self.results.send(Outcome::Edited(edited));
        }
    }
}

fn load(shared: &Shared, coord: ChunkCoord) -> Loaded {
    let mut problems = Vec::new();
    let made = guarded(
        &mut problems,
        &format!("making chunk {}", coord.index),
        || {
            let mut problems = Vec::new();
            let edits = shared.book.snapshot(coord, &mut problems);
            shared.at(Step::Load(coord));
            (shared.make(coord, &edits, false), edits.revision, problems)
        },
    );
    let Some((chunk, revision, more)) = made else {
        problems.push(format!(
            "Chunk {} could not be made and is left out. Walk away and come back, or load the world again.",
            coord.index
        ));
        return Loaded {
            coord,
            chunk: None,
            revision: 0,
            problems,
        };
    };
    problems.extend(more);
    Loaded {
        coord,
        chunk: Some(chunk),
        revision,
        problems,
    }
}

/// Runs a job, once more if it panics; `None` when it is given up. Each panic is a problem.
pub(crate) fn guarded<T>(
    problems: &mut Vec<String>,
    doing: &str,
    job: impl Fn() -> T,
) -> Option<T> {
    for tried in 1..=TRIES {
        match catch_unwind(AssertUnwindSafe(&job)) {
            Ok(done) => return Some(done),
            Err(panic) => {
                let then = if tried < TRIES {
                    "It is tried again"
                } else {
                    "It is given up"
                };
                problems.push(format!(
                    "A chunk worker failed while {doing}: {}. {then}.",
                    reason(&*panic)
                ));
            }
        }
    }
    None
}

/// What a panic said.
pub(crate) fn reason(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no reason given")
}
