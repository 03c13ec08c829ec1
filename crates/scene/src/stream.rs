//! Between the scene and the chunk workers: wishes out, finished chunks in, and what a script waits for.

use std::time::Duration;

use antipode_streaming::{Until, Update, Wish};

use crate::ground::chunks_near;
use crate::scene::Scene;
use crate::tuning::AUTOSAVE_S;

/// Ground within this distance of the player stands before a world counts as playable, in metres.
const PLAYABLE_AROUND_M: f64 = 24.0;
/// Ground within this distance can be seen by a step, in metres: the tool's reach and the camera behind it.
const STEP_SEES_M: f64 = 30.0;

impl Scene {
    /// Tells the workers what is wanted now. Cheap; called every frame.
    pub fn request_ground(&mut self) {
        let head = self.head();
        let wish = Wish {
            centre: head.point,
            front: head.front(),
            view_distance: self.setup.view_distance,
        };
        self.streamer.wish(&wish);
    }

    /// Takes finished work in until `budget` is used up. Never blocks.
    pub fn pump(&mut self, budget: Duration) {
        self.request_ground();
        let updates = self.streamer.poll(budget);
        self.apply(updates);
    }

    /// Blocks until every edit made so far shows and the ground around the player stands, or `limit` has passed.
    /// Scripts call this after each step so that the same script always gives the same world.
    /// Returns false when the limit passed first.
    pub fn wait_for_step(&mut self, limit: Duration) -> bool {
        self.request_ground();
        let updates = self.streamer.wait(Until::Edits, limit);
        self.apply(updates);
        let needed = chunks_near(&*self.strategy, self.feet(), STEP_SEES_M);
        if !needed.iter().all(|c| self.streamer.is_resident(*c)) {
            let updates = self.streamer.wait(Until::Chunks(&needed), limit);
            self.apply(updates);
        }
        self.is_ground_ready()
    }

    /// Blocks until no chunk work is pending, or `limit` has passed; returns false when it did.
    pub fn settle(&mut self, limit: Duration) -> bool {
        self.request_ground();
        let updates = self.streamer.wait(Until::Idle, limit);
        self.apply(updates);
        self.update_marker();
        self.streamer.pending() == 0
    }

    /// How much of the ground around a new arrival stands, 0 to 1; at 1 the world can be played.
    pub fn loading_progress(&self) -> f32 {
        let needed = chunks_near(&*self.strategy, self.feet(), PLAYABLE_AROUND_M);
        let there = needed
            .iter()
            .filter(|c| self.streamer.is_resident(**c))
            .count();
        there as f32 / needed.len().max(1) as f32
    }

    /// Work the chunk workers have not finished.
    pub fn pending(&self) -> usize {
        self.streamer.pending()
    }

    /// Commits in the background what changed, if the last commit is [`AUTOSAVE_S`] old.
    pub(crate) fn autosave(&mut self) {
        if self.stored && self.simulated_s - self.saved_at_s >= AUTOSAVE_S {
            self.save();
        }
    }

    /// Commits everything in the background; a notice tells when it failed.
    pub fn save(&mut self) {
        if !self.stored {
            return;
        }
        self.saved_at_s = self.simulated_s;
        let (meta, state) = self.records();
        self.streamer.save(Some(meta), Some(state));
    }

    /// Commits everything, waits until it is on disk and ends the chunk workers.
    ///
    /// # Errors
    /// When the last commit failed; the sentence says why.
    pub fn close(mut self) -> Result<(), antipode_streaming::StreamingError> {
        self.save();
        self.streamer.close()
    }

    /// Whether the world is kept on disk at all.
    pub fn is_kept(&self) -> bool {
        self.stored
    }

    /// Whether everything saved so far is on disk.
    pub fn is_saved(&self) -> bool {
        self.streamer.saves_in_flight() == 0
    }

    /// Why the last commit failed, if it did.
    pub fn save_problem(&self) -> Option<String> {
        self.save_problem.clone()
    }

    /// Blocks until what was saved so far is on disk, or `limit` has passed; returns false when it was not.
    pub fn wait_saved(&mut self, limit: Duration) -> bool {
        let updates = self.streamer.wait(Until::Saved, limit);
        let done = updates.iter().any(|u| matches!(u, Update::Saved));
        self.apply(updates);
        done || self.streamer.saves_in_flight() == 0
    }

    fn apply(&mut self, updates: Vec<Update>) {
        let mut edited = false;
        for update in updates {
            match update {
                Update::Loaded(chunk) => self.ground.put(chunk, &mut self.physics),
                Update::Edited(chunks) => {
                    edited = true;
                    for chunk in chunks {
                        self.ground.put(chunk, &mut self.physics);
                    }
                }
                Update::Unloaded(coord) => self.ground.remove(coord, &mut self.physics),
                Update::Saved => self.save_problem = None,
                Update::Problem(sentence) => {
                    if self.streamer.saves_in_flight() == 0 {
                        self.save_problem = Some(sentence.clone());
                    }
                    self.notices.push(sentence);
                }
            }
        }
        if edited {
            self.lift_player_out();
        }
    }
}
