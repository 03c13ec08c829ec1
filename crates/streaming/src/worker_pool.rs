//! The threads and the game's ends of their channels.

use std::any::Any;
use std::convert::Infallible;
use std::io;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use antipode_geometry::ChunkCoord;
use antipode_terrain::Thing;
use crossbeam_channel::{Receiver, RecvTimeoutError, Sender, bounded};

use crate::batch_job::EditBatch;
use crate::edit_store::Column;
use crate::outcome::Outcome;
use crate::plan::Request;
use crate::saver::{self, Parts};
use crate::scheduler::Make;
use crate::shared::Shared;
use crate::worker::{UrgentJob, WorkerChannels};

/// Loads handed to each worker at a time: enough to keep it busy for a frame, a slow one of a software
/// adapter too, few enough that the order can still change.
const LOADS_PER_WORKER: usize = 10;

/// Things that wait for a worker to drop them; what is too much is dropped at once.
const MOST_DISCARDED: usize = 256;

/// How long a stopped worker pool may take before it is left alone; a job takes some ten milliseconds and
/// a commit is the disk's business.
const LEAVE_LIMIT: Duration = Duration::from_secs(10);

/// The running threads.
pub(crate) struct WorkerPool {
    shared: Arc<Shared>,
    ends: Option<Ends>,
    results: Receiver<Outcome>,
    /// Closes once every thread has ended.
    alive: Receiver<Infallible>,
    threads: Vec<JoinHandle<()>>,
    most_loads: usize,
}

struct Ends {
    loads: Sender<Make>,
    urgent: Sender<UrgentJob>,
    saves: Sender<Box<Parts>>,
    /// Nobody waits at its other end, so that sending wakes nobody.
    discarded: Sender<Box<dyn Any + Send>>,
}

impl WorkerPool {
    /// Starts the workers (at least one) and the saver.
    pub(crate) fn start(shared: Arc<Shared>, workers: usize) -> io::Result<Self> {
        let workers = workers.max(1);
        let most_loads = workers * LOADS_PER_WORKER;
        let (loads, load_jobs) = bounded(most_loads);
        // One batch, one plan, and calls for help to everybody else.
        let (urgent, urgent_jobs) = bounded(workers + 2);
        let (saves, save_jobs) = bounded(1);
        // Room for every load, the batch, the plan and the save that can be in flight.
        let (send_results, results) = bounded(most_loads + 3);
        let (discarded, to_drop) = bounded(MOST_DISCARDED);
        let (living, alive) = bounded(0);
        let mut worker_pool = Self {
            shared: Arc::clone(&shared),
            ends: Some(Ends {
                loads,
                urgent: urgent.clone(),
                saves,
                discarded,
            }),
            results,
            alive,
            threads: Vec::with_capacity(workers + 1),
            most_loads,
        };
        let channels = WorkerChannels {
            urgent: urgent_jobs,
            call: urgent,
            loads: load_jobs,
            results: send_results.clone(),
            discarded: to_drop,
            colleagues: workers - 1,
        };
        worker_pool.hire(workers, &channels, living, move || {
            saver::run(&shared, &save_jobs, &send_results);
        })?;
        Ok(worker_pool)
    }

    /// Takes `living` by value: were it still there when a refused thread ends the start, the
    /// others would be waited for in vain.
    fn hire(
        &mut self,
        workers: usize,
        channels: &WorkerChannels,
        living: Sender<Infallible>,
        saver: impl FnOnce() + Send + 'static,
    ) -> io::Result<()> {
        for number in 1..=workers {
            let (channels, shared) = (channels.clone(), Arc::clone(&self.shared));
            self.spawn(
                format!("antipode-chunk-{number}"),
                living.clone(),
                move || channels.work(&shared),
            )?;
        }
        self.spawn("antipode-save".to_owned(), living, saver)
    }

    fn spawn(
        &mut self,
        name: String,
        living: Sender<Infallible>,
        job: impl FnOnce() + Send + 'static,
    ) -> io::Result<()> {
        let thread = thread::Builder::new().name(name).spawn(move || {
            job();
            drop(living);
        })?;
        self.threads.push(thread);
        Ok(())
    }

    /// What the workers go by.
    #[cfg(test)]
    pub(crate) fn shared(&self) -> Arc<Shared> {
        Arc::clone(&self.shared)
    }

    /// Loads that may be in flight at once.
    pub(crate) fn most_loads(&self) -> usize {
        self.most_loads
    }

    /// Hands over a load; false if there is no room.
    pub(crate) fn load(&self, make: Make) -> bool {
        self.ends
            .as_ref()
            .is_some_and(|ends| ends.loads.try_send(make).is_ok())
    }

    /// Hands over a plan to be made; false if there is no room.
    pub(crate) fn plan(&self, request: Request) -> bool {
        let job = UrgentJob::Plan(Box::new(request));
        self.ends
            .as_ref()
            .is_some_and(|ends| ends.urgent.try_send(job).is_ok())
    }

    /// See [`crate::Streamer::remember_felled`].
    pub(crate) fn remember_felled(&self, column: Column, slots: u128) {
        self.shared.edit_store.remember_felled(column, slots);
    }

    /// See [`crate::Streamer::remember_planted`].
    pub(crate) fn remember_planted(&self, coord: ChunkCoord, thing: Thing) {
        self.shared.edit_store.remember_planted(coord, thing);
    }

    /// Hands over a batch, or gives it back if there is no room.
    pub(crate) fn edit(&self, batch: EditBatch) -> Result<(), EditBatch> {
        let Some(ends) = &self.ends else {
            return Err(batch);
        };
        ends.urgent
            .try_send(UrgentJob::Begin(batch))
            .or_else(|refused| match refused.into_inner() {
                UrgentJob::Begin(batch) => Err(batch),
                UrgentJob::Help(_) | UrgentJob::Plan(_) => Ok(()),
            })
    }

    /// Hands over a save, or gives it back if there is no room.
    pub(crate) fn save(&self, parts: Box<Parts>) -> Result<(), Box<Parts>> {
        let Some(ends) = &self.ends else {
            return Err(parts);
        };
        ends.saves
            .try_send(parts)
            .map_err(crossbeam_channel::TrySendError::into_inner)
    }

    /// Hands over what a worker is to drop after its next job.
    pub(crate) fn discard(&self, thing: Box<dyn Any + Send>) {
        if let Some(ends) = &self.ends {
            // If there is no room it is dropped here.
            let _ = ends.discarded.try_send(thing);
        }
    }

    /// Finished jobs.
    pub(crate) fn results(&self) -> &Receiver<Outcome> {
        &self.results
    }

    /// Stops and joins every thread; the saver commits what is unsaved. A thread that does not end
    /// in time is left alone.
    pub(crate) fn leave(&mut self) {
        self.shared.stop();
        self.ends = None;
        let left = self.alive.recv_timeout(LEAVE_LIMIT);
        if !matches!(left, Err(RecvTimeoutError::Disconnected)) {
            tracing::error!("a chunk worker or the saver did not end in time");
            self.threads.clear();
        }
        for thread in self.threads.drain(..) {
            // A panic outside the guarded jobs has been printed already; nothing is left to mend.
            let _ = thread.join();
        }
    }
}

impl Drop for WorkerPool {
    fn drop(&mut self) {
        self.leave();
    }
}
