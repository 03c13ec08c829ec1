//! Time in a world: steps while playing, saves, and words of what came up.

use std::time::Duration;

use antipode_scene::Hint;
use antipode_scene::tuning::{AUTOSAVE_S, STEP_S};
use antipode_ui::{Screen, ToastKind};

use super::game::{CHUNK_BUDGET, Game};
use super::phase::Phase;
use super::veil::Veil;
use super::waits::Part;
use crate::pad::Feel;
use crate::session::Session;
use crate::wording;

/// Shortest time between two saves of a paused world in which the last edits have just ended, in seconds.
const SETTLED_SAVE_S: f64 = 0.2;

impl Game {
    pub(super) fn pause(&mut self) {
        self.console.leave();
        self.leave_photo_mode();
        self.close_backpack();
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Playing(mut session) => {
                self.controls.release_all();
                session.scene.save();
                self.since_save_s = 0.0;
                self.wants_picture = true;
                self.menus.open_main();
                Phase::Paused(session)
            }
            other => other,
        };
    }

    pub(super) fn resume(&mut self) {
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Paused(session) => {
                self.controls.release_all();
                self.menus.shell.open(Screen::Hidden);
                // Closing may have failed while the land was still being made.
                if self.veil == Veil::Down {
                    Phase::Loading(session)
                } else {
                    Phase::Playing(session)
                }
            }
            other => other,
        };
    }

    pub(super) fn playing(&mut self, mut session: Session, passed: Duration) -> Phase {
        self.waits.spent_on(Part::Input);
        session.scene.pump(CHUNK_BUDGET);
        self.waits.spent_on(Part::Land);
        // Before the steps: they save by simulated time, which never runs ahead of the wall's.
        self.keep_saved(&mut session, passed, false);
        self.waits.spent_on(Part::Input);
        let feel = Feel::from(&self.config.settings);
        // The sticks belong to what is up over the world, as the keys do.
        let by_sticks = !self.is_elsewhere();
        let share = self.pace.share();
        let steps = self.pace.steps(passed);
        if by_sticks {
            let passed_s = (f64::from(steps) + self.pace.share() - share) * STEP_S;
            let turn = self.sticks.turn(feel, passed_s);
            if turn != (0.0, 0.0) {
                self.hints.use_pad(true);
            }
            self.controls.turn(turn);
        }
        for left in (0..steps).rev() {
            let mut actions = self.controls.take();
            let by_keys = actions;
            if by_sticks {
                self.sticks.add_to(&mut actions, feel);
            }
            if actions != by_keys {
                self.hints.use_pad(true);
            }
            self.step_hints(&actions, &session.scene);
            actions.aimed = Some(session.scene.aim_of_picture());
            session
                .between
                .step(&mut session.scene, &actions, left == 0);
            self.console.step(&mut self.controls);
        }
        self.waits.spent_on(Part::Steps);
        if let Some(dropped_s) = self.pace.take_news() {
            tracing::info!(
                "frames are too slow for the world: {dropped_s:.1} s of its time were left out"
            );
        }
        self.tell(&mut session);
        Phase::Playing(session)
    }

    /// Saves by the wall clock, however slowly the simulation runs, and in a paused world again as soon as the
    /// edits that were under way have ended.
    pub(super) fn keep_saved(&mut self, session: &mut Session, passed: Duration, paused: bool) {
        self.since_save_s += passed.as_secs_f64();
        let scene = &mut session.scene;
        let settled = paused && scene.pending() == 0 && scene.save_problem().is_none();
        if save_is_due(self.since_save_s, settled) && scene.needs_save() {
            scene.save();
            self.since_save_s = 0.0;
        }
    }

    /// Tells the player what came up in the scene.
    pub(super) fn tell(&mut self, session: &mut Session) {
        let mut notices = session.scene.take_notices();
        if self.saving && session.scene.wait_saved(Duration::ZERO) {
            self.saving = false;
            match session.scene.save_problem() {
                None => self.menus.toast(ToastKind::Info, "saved", &[]),
                // The scene tells a failure that comes again only once, but here somebody has asked.
                Some(problem) if !notices.contains(&problem) => notices.push(problem),
                Some(_) => {}
            }
        }
        for notice in notices {
            let words = wording::notice(&self.menus.texts, &notice);
            self.menus.shell.toast(words, ToastKind::Problem);
        }
        for hint in session.scene.take_hints() {
            // Who speaks is seen to do so, but with the display hidden.
            if matches!(hint, Hint::Said { .. }) && !self.display_hidden {
                continue;
            }
            let words = wording::hint(&self.menus.texts, &self.config.profiles, hint);
            self.menus.shell.toast(words, ToastKind::State);
        }
    }
}

fn save_is_due(since_s: f64, settled: bool) -> bool {
    since_s >= if settled { SETTLED_SAVE_S } else { AUTOSAVE_S }
}
