//! A chunk worker: edits and plans before loads, and no panic leaves it.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crossbeam_channel::{Receiver, Sender, select_biased};

use crate::batch_job::{BatchJob, EditBatch};
use crate::outcome::{Loaded, Outcome};
use crate::plan::{Planned, Request};
use crate::scheduler::Make;
use crate::shared::{Shared, Step};

/// Times a job is tried before it is given up.
const TRIES: u32 = 2;

/// Work that outranks loading.
pub(crate) enum UrgentJob {
    /// Apply a batch and see it through.
    Begin(EditBatch),
    /// Help with a batch that another worker has begun.
    Help(Arc<BatchJob>),
    /// Say what is to be there.
    Plan(Box<Request>),
}

/// A worker's ends of the channels.
#[derive(Clone)]
pub(crate) struct WorkerChannels {
    pub(crate) urgent: Receiver<UrgentJob>,
    /// For calls for help; never waited on.
    pub(crate) call: Sender<UrgentJob>,
    pub(crate) loads: Receiver<Make>,
    pub(crate) results: Sender<Outcome>,
    /// What the game needs no more: freeing a chunk's memory takes as long as all else that a frame
    /// does, and longer where the allocator's lock is a worker's.
    pub(crate) discarded: Receiver<Box<dyn Any + Send>>,
    pub(crate) colleagues: usize,
}

impl WorkerChannels {
    /// Works until the game lets go of the load channel. The result channel has room for every job
    /// in flight, so sending never waits; if the game is gone, nobody misses the result.
    pub(crate) fn work(&self, shared: &Shared) {
        while !shared.is_stopped() {
            select_biased! {
                recv(self.urgent) -> job => match job {
                    Ok(job) => self.hurry(shared, job),
                    Err(_) => return,
                },
                recv(self.loads) -> make => match make {
                    Ok(make) => {
                        let _ = self.results.send(Outcome::Loaded(load(shared, make)));
                    }
                    Err(_) => return,
                },
            }
            self.discarded.try_iter().for_each(drop);
        }
    }

    fn hurry(&self, shared: &Shared, job: UrgentJob) {
        let job = match job {
            UrgentJob::Help(job) => job,
            UrgentJob::Begin(batch) => self.begin(shared, &batch),
            UrgentJob::Plan(request) => {
                let _ = self.results.send(Outcome::Planned(plan(shared, &request)));
                return;
            }
        };
        if let Some(edited) = job.help(shared) {
            let _ = self.results.send(Outcome::Edited(edited));
        }
    }

    fn begin(&self, shared: &Shared, batch: &EditBatch) -> Arc<BatchJob> {
        let job = Arc::new(BatchJob::begin(shared, batch));
        for _ in 1..job.len().min(self.colleagues + 1) {
            // Help that cannot be called is done without.
            let _ = self.call.try_send(UrgentJob::Help(Arc::clone(&job)));
        }
        job
    }
}

fn plan(shared: &Shared, request: &Request) -> Result<Planned, Vec<String>> {
    let mut problems = Vec::new();
    let planned = guarded(&mut problems, "planning which land is to be there", |_| {
        request.plan(&shared.field)
    });
    planned.ok_or(problems)
}

fn load(shared: &Shared, make: Make) -> Loaded {
    let coord = make.coord;
    let mut problems = Vec::new();
    let doing = format!("making chunk {}", coord.index);
    let made = guarded(&mut problems, &doing, |problems| {
        let edits = shared.edit_store.snapshot(coord, problems);
        shared.at(Step::Load(coord));
        (shared.make(make, &edits, false), edits.revision)
    });
    if made.is_none() {
        problems.push(format!(
            "Chunk {} could not be made and is left out. Walk away and come back, or load the world again.",
            coord.index
        ));
    }
    let (chunk, revision) = made.unzip();
    Loaded {
        make,
        chunk,
        revision: revision.unwrap_or_default(),
        problems,
    }
}

/// Runs a job, once more if it panics; `None` when it is given up. Each panic is a problem, and so is what the job has
/// found by its end.
pub(crate) fn guarded<T>(
    problems: &mut Vec<String>,
    doing: &str,
    job: impl Fn(&mut Vec<String>) -> T,
) -> Option<T> {
    for tried in 1..=TRIES {
        let mut found = Vec::new();
        match catch_unwind(AssertUnwindSafe(|| job(&mut found))) {
            Ok(done) => {
                problems.append(&mut found);
                return Some(done);
            }
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
