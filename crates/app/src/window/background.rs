//! Work that may wait for the disk, done off the main thread: opening, closing, listing and deleting worlds.

use std::thread;

use crossbeam_channel::{Receiver, TryRecvError, bounded};

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
    /// Starts work on a named thread.
    ///
    /// # Errors
    /// When the system gives no more threads.
    pub fn start(name: &str, work: impl FnOnce() -> T + Send + 'static) -> std::io::Result<Self> {
        let (sender, result) = bounded(1);
        thread::Builder::new()
            .name(format!("antipode-{name}"))
            .spawn(move || {
                // The asker may have gone; then nobody wants the result.
                let _ = sender.send(work());
            })?;
        Ok(Self { result })
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
        let task = Task::start("test", || 7).unwrap();
        assert_eq!(task.finish(), Some(7));
        let task: Task<()> = Task::start("test", || panic!("on purpose")).unwrap();
        assert_eq!(task.finish(), None);
    }

    #[test]
    fn a_task_at_work_does_not_block_the_asker() {
        let (go, wait) = bounded::<()>(0);
        let task = Task::start("test", move || wait.recv().is_ok()).unwrap();
        assert!(matches!(task.poll(), Progress::Running));
        go.send(()).unwrap();
        assert_eq!(task.finish(), Some(true));
    }
}
