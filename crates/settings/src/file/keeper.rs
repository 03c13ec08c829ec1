//! Writes settings on a thread of its own; of changes that follow each other closely only the last is written.

use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::disk::replace;
use super::notice::SaveProblem;
use super::text::write;
use crate::Config;

/// How long a change waits for the next one. Dragging a slider is one change.
const QUIET: Duration = Duration::from_millis(300);

/// What writes settings. Dropping it waits until the last change is on disk.
#[derive(Debug)]
pub struct Keeper {
    shared: Option<Arc<Shared>>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Debug)]
struct Shared {
    path: PathBuf,
    desk: Mutex<Desk>,
    called: Condvar,
}

#[derive(Debug, Default)]
struct Desk {
    /// The settings to write next.
    next: Option<Config>,
    closing: bool,
    /// Why the last save failed, if it did.
    problem: Option<SaveProblem>,
    /// The problem that was told last; it is told again only after a save that went well.
    told: Option<SaveProblem>,
}

impl Keeper {
    /// Writes to that file from now on.
    pub(super) fn new(path: PathBuf) -> Self {
        let shared = Arc::new(Shared {
            path,
            desk: Mutex::new(Desk::default()),
            called: Condvar::new(),
        });
        let own = Arc::clone(&shared);
        let thread = thread::Builder::new()
            .name("antipode-settings".to_owned())
            .spawn(move || own.work());
        if let Err(error) = &thread {
            tracing::warn!("settings are written on the main thread: {error}");
        }
        Self {
            shared: Some(shared),
            thread: thread.ok(),
        }
    }

    /// Writes nothing at all.
    pub fn idle() -> Self {
        Self {
            shared: None,
            thread: None,
        }
    }

    /// Whether changes are written.
    pub fn is_active(&self) -> bool {
        self.shared.is_some()
    }

    /// Takes settings to be written. Never waits for the disk, but where the system gave no thread.
    pub fn save(&self, config: &Config) {
        let Some(shared) = &self.shared else { return };
        shared.desk().next = Some(config.clone());
        if self.thread.is_some() {
            shared.called.notify_one();
        } else {
            shared.write_next();
        }
    }

    /// Why the last save failed; each reason is told once until a save goes well.
    pub fn take_problem(&self) -> Option<SaveProblem> {
        let mut desk = self.shared.as_ref()?.desk();
        let problem = desk
            .problem
            .clone()
            .filter(|now| desk.told.as_ref() != Some(now))?;
        desk.told = Some(problem.clone());
        Some(problem)
    }

    /// Writes what is still to be written, and ends.
    ///
    /// # Errors
    /// [`SaveProblem`] when the last change is not on disk.
    pub fn finish(mut self) -> Result<(), SaveProblem> {
        self.close();
        let problem = self
            .shared
            .as_ref()
            .and_then(|shared| shared.desk().problem.take());
        problem.map_or(Ok(()), Err)
    }

    fn close(&mut self) {
        if let (Some(shared), Some(thread)) = (&self.shared, self.thread.take()) {
            shared.desk().closing = true;
            shared.called.notify_one();
            if thread.join().is_err() {
                tracing::error!("the thread that writes the settings has died");
            }
        }
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.close();
    }
}

impl Shared {
    fn desk(&self) -> MutexGuard<'_, Desk> {
        self.desk.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn work(&self) {
        loop {
            let desk = self.desk();
            let idle = |desk: &mut Desk| desk.next.is_none() && !desk.closing;
            let desk = self
                .called
                .wait_while(desk, idle)
                .unwrap_or_else(PoisonError::into_inner);
            // Others may follow; whoever waits for the end does not wait for them.
            let (desk, _) = self
                .called
                .wait_timeout_while(desk, QUIET, |desk| !desk.closing)
                .unwrap_or_else(PoisonError::into_inner);
            let ends = desk.closing;
            drop(desk);
            self.write_next();
            if ends {
                return;
            }
        }
    }

    fn write_next(&self) {
        let Some(config) = self.desk().next.take() else {
            return;
        };
        let written = write(&config)
            .and_then(|text| replace(&self.path, &text).map_err(|error| error.to_string()));
        let mut desk = self.desk();
        match written {
            Ok(()) => (desk.problem, desk.told) = (None, None),
            Err(why) => {
                let problem = SaveProblem {
                    path: self.path.clone(),
                    why,
                };
                tracing::warn!("{problem}");
                desk.problem = Some(problem);
            }
        }
    }
}
