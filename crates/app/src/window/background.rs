//! Work that may wait for the disk, done off the main thread: opening, closing, listing and deleting worlds.

use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use crossbeam_channel::{Receiver, TryRecvError, bounded};

/// Work on its way to a thread.
type Job = Box<dyn FnOnce() + Send>;

/// A piece of work on a thread of its own, asked for its result once a frame.
#[derive(Debug)]
pub struct Task<T> {
    result: Receiver<T>,
}

/// What a task has come to.
#[derive(Debug)]
pub enum Progress<T> {
    /// Still at work.
    Running,
    /// Finished.
    Done(T),
    /// Its thread ended without a result.
    Died,
}

impl<T: Send + 'static> Task<T> {
    /// Starts work on a named thread. Where the system gives no more threads the work is done here and now: a
    /// moment's standstill is better than a world that cannot be saved.
    pub fn start(name: &str, work: impl FnOnce() -> T + Send + 'static) -> Self {
        Self::start_by(work, |job| {
            thread::Builder::new()
                .name(format!("antipode-{name}"))
                .spawn(job)
                .is_ok()
        })
    }

    fn start_by(
        work: impl FnOnce() -> T + Send + 'static,
        spawn: impl FnOnce(Job) -> bool,
    ) -> Self {
        let (sender, result) = bounded(1);
        let job: Job = Box::new(move || {
            // The asker may have gone; then nobody wants the result.
            let _ = sender.send(work());
        });
        // A thread that is refused swallows what it was to do, so the work is only lent to it.
        let lent = Arc::new(Mutex::new(Some(job)));
        let kept = Arc::clone(&lent);
        let take =
            |job: &Mutex<Option<Job>>| job.lock().unwrap_or_else(PoisonError::into_inner).take();
        let started = spawn(Box::new(move || {
            if let Some(job) = take(&lent) {
                job();
            }
        }));
        if !started && let Some(job) = take(&kept) {
            tracing::warn!("the system gives no more threads; the game stands still for a moment");
            job();
        }
        Self { result }
    }

    /// Looks whether the work is finished. Never blocks.
    pub fn poll(&self) -> Progress<T> {
        match self.result.try_recv() {
            Ok(result) => Progress::Done(result),
            Err(TryRecvError::Empty) => Progress::Running,
            Err(TryRecvError::Disconnected) => Progress::Died,
        }
    }

    /// Waits for the result; none when the thread died.
    pub fn finish(self) -> Option<T> {
        self.result.recv().ok()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn a_result_arrives_and_a_death_is_noticed() {
        let task = Task::start("test", || 7);
        assert_eq!(task.finish(), Some(7));
        let task: Task<()> = Task::start("test", || panic!("on purpose"));
        assert_eq!(task.finish(), None);
    }

    #[test]
    fn without_a_thread_the_work_is_done_at_once() {
        let task = Task::start_by(
            || 7,
            |job| {
                drop(job);
                false
            },
        );
        assert!(matches!(task.poll(), Progress::Done(7)));
    }

    #[test]
    fn a_task_at_work_does_not_block_the_asker() {
        let (go, wait) = bounded::<()>(0);
        let task = Task::start("test", move || wait.recv().is_ok());
        assert!(matches!(task.poll(), Progress::Running));
        go.send(()).unwrap();
        assert_eq!(task.finish(), Some(true));
    }
}
