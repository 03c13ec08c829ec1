//! Waiting for the workers: for scripts, which replay exactly, and for the end of a game.

use std::time::{Duration, Instant};

use antipode_storage::RecordChanges;
use crossbeam_channel::RecvTimeoutError;

use crate::api::{StreamingError, Until, Update};
use crate::streamer::Streamer;

/// Longest sleep between two looks at what could not be handed over before.
const LOOK_AGAIN: Duration = Duration::from_millis(20);

/// How long closing waits for the last edits and for the disk, each.
const CLOSE_LIMIT: Duration = Duration::from_mins(1);

impl Streamer {
    /// Waits until `what` holds or `timeout` has passed, and returns everything that happened
    /// meanwhile, as [`poll`](Self::poll) does. For scripts and loading screens, never for a frame.
    pub fn wait(&mut self, what: Until<'_>, timeout: Duration) -> Vec<Update> {
        let end = Instant::now() + timeout;
        let mut updates = self.take_ready();
        loop {
            // What is finished is taken even if nothing has to be waited for; else a game that only
            // ever waits would neither load nor learn that it is saved.
            while let Ok(outcome) = self.worker_pool.results().try_recv() {
                self.take(outcome, &mut updates);
            }
            updates.extend(
                self.scheduler
                    .settle_all()
                    .into_iter()
                    .map(Update::Unloaded),
            );
            self.feed();
            if self.holds(what) {
                return updates;
            }
            let left = end.saturating_duration_since(Instant::now());
            match self
                .worker_pool
                .results()
                .recv_timeout(left.min(LOOK_AGAIN))
            {
                Ok(outcome) => self.take(outcome, &mut updates),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return updates,
            }
            if left.is_zero() {
                return updates;
            }
        }
    }

    fn holds(&self, what: Until<'_>) -> bool {
        match what {
            Until::Edits => !self.is_editing(),
            Until::Chunks(coords) => !coords.iter().any(|&coord| self.scheduler.is_coming(coord)),
            Until::Bodies => !self.scheduler.is_ground_coming(),
            Until::Loads => self.scheduler.coming() == 0,
            Until::Saved => self.saves_in_flight() == 0,
            Until::Idle => self.pending() == 0 && self.saves_in_flight() == 0,
        }
    }

    /// Finishes the edits, commits everything, and joins every thread. When it fails, nothing is
    /// lost and the streamer goes on as before: make room on the disk, say, and close it again.
    /// After it has succeeded the streamer does nothing any more.
    ///
    /// # Errors
    /// [`StreamingError::NotSaved`] if the last commit failed, [`StreamingError::Unfinished`] if an edit
    /// or the commit took too long to wait for.
    pub fn close(&mut self) -> Result<(), StreamingError> {
        self.scheduler.clear_queue();
        let mut updates = self.wait(Until::Edits, CLOSE_LIMIT);
        self.save(None, RecordChanges::new());
        updates.extend(self.wait(Until::Saved, CLOSE_LIMIT));
        let failed = match &self.saves.last_failure {
            Some(why) => Some(StreamingError::NotSaved(why.clone())),
            None if self.is_editing() || self.saves_in_flight() > 0 => {
                Some(StreamingError::Unfinished)
            }
            None => None,
        };
        if let Some(error) = failed {
            self.keep_ready(updates);
            self.scheduler.refill_queue();
            return Err(error);
        }
        for update in updates {
            if let Update::Problem(problem) = update {
                tracing::warn!("{problem}");
            }
        }
        // Everything is on disk by now: a thread that does not end can lose nothing.
        self.worker_pool.leave();
        Ok(())
    }
}
