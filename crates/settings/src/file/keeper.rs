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
    state: Mutex<WriterState>,
    called: Condvar,
}

#[derive(Debug, Default)]
struct WriterState {
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
            state: Mutex::new(WriterState::default()),
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
        shared.state().next = Some(config.clone());
        if self.thread.is_some() {
            shared.called.notify_one();
        } else {
            shared.write_next();
        }
    }

    /// Why the last save failed; each reason is told once until a save goes well.
    pub fn take_problem(&self) -> Option<SaveProblem> {
        let mut state = self.shared.as_ref()?.state();
        let problem = state
            .problem
            .clone()
            .filter(|now| state.told.as_ref() != Some(now))?;
        state.told = Some(problem.clone());
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
            .and_then(|shared| shared.state().problem.take());
        problem.map_or(Ok(()), Err)
    }

    fn close(&mut self) {
        if let (Some(shared), Some(thread)) = (&self.shared, self.thread.take()) {
            shared.state().closing = true;
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
    fn state(&self) -> MutexGuard<'_, WriterState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn work(&self) {
        loop {
            let state = self.state();
            let idle = |state: &mut WriterState| state.next.is_none() && !state.closing;
            let state = self
                .called
                .wait_while(state, idle)
                .unwrap_or_else(PoisonError::into_inner);
            // Others may follow; whoever waits for the end does not wait for them.
            let (state, _) = self
                .called
                .wait_timeout_while(state, QUIET, |state| !state.closing)
                .unwrap_or_else(PoisonError::into_inner);
            let ends = state.closing;
            drop(state);
            self.write_next();
            if ends {
                return;
            }
        }
    }

    fn write_next(&self) {
        let Some(config) = self.state().next.take() else {
            return;
        };
        let written = write(&config)
            .and_then(|text| replace(&self.path, &text).map_err(|error| error.to_string()));
        let mut state = self.state();
        match written {
            Ok(()) => (state.problem, state.told) = (None, None),
            Err(why) => {
                let problem = SaveProblem {
                    path: self.path.clone(),
                    why,
                };
                tracing::warn!("{problem}");
                state.problem = Some(problem);
            }
        }
    }
}
