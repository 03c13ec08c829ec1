//! The world or room that is played: its time against the wall's, its saves, and words of what came up in it.

mod passage;

use std::path::PathBuf;
use std::time::Duration;

use antipode_audio::{Heard, PlayState};
use antipode_geometry::HyperbolicMap;
use antipode_scene::Hint;
use antipode_scene::frame::Quality;
use antipode_scene::tuning::AUTOSAVE_S;
use antipode_settings::{Profiles, Settings};
use antipode_ui::{Screen, ToastKind};
use image::RgbaImage;

use super::background::Task;
use super::devices::Devices;
use super::hints::{HintContext, Hints};
use super::menus::Menus;
use super::pace::Pace;
use super::phase::{Next, Phase};
use super::portrait::{Portrait, write_portrait};
use super::veil::Veil;
use super::visit::Visit;
use super::waits::{Part, Waits};
use crate::options;
use crate::pad::Feel;
use crate::session::Worlds;
use crate::wording;

/// Time a frame gives to finished chunks.
pub(super) const CHUNK_BUDGET: Duration = Duration::from_millis(2);
/// Shortest time between two saves of a paused world in which the last edits have just ended, in seconds.
const SETTLED_SAVE_S: f64 = 0.2;

/// What is done with worlds and rooms, and what is open of them.
#[derive(Debug)]
pub struct Play {
    pub(super) phase: Phase,
    pub(super) worlds: Worlds,
    pub(super) pace: Pace,
    pub(super) veil: Veil,
    /// The number of the open world or room among those that were opened.
    pub(super) opened: u64,
    pub(super) portrait: Portrait,
    /// Where the picture of a room goes that is being drawn, and the number of the room among those that were opened.
    room_portrait: Option<(u64, PathBuf)>,
    /// The player has asked for a save and is owed an answer.
    pub(super) saving: bool,
    /// Since the open world was last given to be saved, in seconds of the wall clock.
    since_save_s: f64,
    /// Where the player was going when the world could not be saved.
    pub(super) held_up: Option<Next>,
    /// Nothing can be shown any more, so nothing can be asked either.
    unseen: bool,
    /// What could not be saved when nothing could be shown any more.
    pub(super) last_words: Option<String>,
    /// Whether each step waits for its land, as those of a script do: for tests of what else a frame may change.
    #[cfg(test)]
    pub(super) awaits_land: bool,
}

impl Play {
    /// No world is open.
    pub fn new(worlds: Worlds) -> Self {
        Self {
            phase: Phase::Menu,
            worlds,
            pace: Pace::default(),
            veil: Veil::default(),
            opened: 0,
            portrait: Portrait::default(),
            room_portrait: None,
            saving: false,
            since_save_s: 0.0,
            held_up: None,
            unseen: false,
            last_words: None,
            #[cfg(test)]
            awaits_land: false,
        }
    }

    /// Pauses the world, if one is played.
    pub fn pause(&mut self, menus: &mut Menus) {
        self.phase = match std::mem::take(&mut self.phase) {
            Phase::Playing(mut session) => {
                session.scene.save();
                self.since_save_s = 0.0;
                self.portrait.is_wanted = true;
                menus.open_main();
                Phase::Paused(session)
            }
            Phase::InRoom(visit) => {
                self.room_portrait = visit.portrait_file().map(|file| (self.opened, file));
                self.portrait.is_wanted = self.room_portrait.is_some() && visit.is_drawn;
                menus.open_main();
                Phase::RoomPaused(visit)
            }
            other => other,
        };
    }

    /// Plays on, if the world is paused.
    pub fn resume(&mut self, menus: &mut Menus) {
        self.phase = match std::mem::take(&mut self.phase) {
            Phase::Paused(session) => {
                menus.shell.open(Screen::Hidden);
                // Closing may have failed while the land was still being made.
                if self.veil == Veil::Down {
                    Phase::Loading(session)
                } else {
                    Phase::Playing(session)
                }
            }
            Phase::RoomPaused(visit) => {
                menus.shell.open(Screen::Hidden);
                Phase::InRoom(visit)
            }
            other => other,
        };
    }

    /// Lets time pass in the world: as many steps as are due. `feel`: how the sticks answer, where they are for the world.
    pub fn advance(
        &mut self,
        passed: Duration,
        devices: &mut Devices,
        feel: Option<Feel>,
        mut hints: Option<&mut Hints>,
        waits: &mut Waits,
    ) {
        waits.spent_on(Part::Input);
        if let Some(session) = self.phase.session_mut() {
            session.scene.pump(CHUNK_BUDGET);
        }
        waits.spent_on(Part::Land);
        // Before the steps: they save by simulated time, which never runs ahead of the wall's.
        self.keep_saved(passed, false);
        waits.spent_on(Part::Input);
        let Phase::Playing(session) = &mut self.phase else {
            return;
        };
        let (steps, passed_s) = self.pace.go_on(passed);
        devices.turn(feel, passed_s);
        for left in (0..steps).rev() {
            let mut actions = devices.take(feel);
            if let Some(hints) = &mut hints {
                hints.step(&actions, HintContext::of(&session.scene));
            }
            actions.aimed = Some(session.scene.aim_of_picture());
            let between = &mut session.between;
            between.step(&mut session.scene, &actions, left == 0);
            #[cfg(test)]
            if self.awaits_land {
                session.scene.wait_for_step(Duration::from_mins(2));
            }
            devices.step();
        }
        waits.spent_on(Part::Steps);
        if let Some(dropped_s) = self.pace.take_news() {
            tracing::info!(
                "frames are too slow for the world: {dropped_s:.1} s of its time were left out"
            );
        }
    }

    /// Saves by the wall clock, however slowly the simulation runs, and in a paused world again as soon as the
    /// edits that were under way have ended.
    pub fn keep_saved(&mut self, passed: Duration, paused: bool) {
        let Some(session) = self.phase.session_mut() else {
            return;
        };
        self.since_save_s += passed.as_secs_f64();
        let scene = &mut session.scene;
        let settled = paused && scene.pending() == 0 && scene.save_problem().is_none();
        if save_is_due(self.since_save_s, settled) && scene.needs_save() {
            scene.save();
            self.since_save_s = 0.0;
        }
    }

    /// Saves because the player has asked for it.
    pub fn save(&mut self) {
        if let Some(session) = self.phase.session_mut() {
            session.scene.save();
            self.since_save_s = 0.0;
            self.saving = true;
        }
    }

    /// Tells the player what came up in the scene. The display shows a speaker's words unless it is hidden.
    pub fn tell(&mut self, menus: &mut Menus, profiles: &Profiles, display_hidden: bool) {
        if let Some(visit) = self.phase.visit_mut() {
            for hint in visit.room.scene.take_hints() {
                let words = wording::room_hint(&menus.texts, hint);
                menus.shell.toast(words, ToastKind::State);
            }
        }
        let Some(session) = self.phase.session_mut() else {
            return;
        };
        let mut notices = session.scene.take_notices();
        if self.saving && session.scene.wait_saved(Duration::ZERO) {
            self.saving = false;
            match session.scene.save_problem() {
                None => menus.toast(ToastKind::Info, "saved", &[]),
                // The scene tells a failure that comes again only once, but here somebody has asked.
                Some(problem) if !notices.contains(&problem) => notices.push(problem),
                Some(_) => {}
            }
        }
        for notice in notices {
            let words = wording::notice(&menus.texts, &notice);
            menus.shell.toast(words, ToastKind::Problem);
        }
        for hint in session.scene.take_hints() {
            if display_hidden || !matches!(hint, Hint::Said { .. }) {
                let words = wording::hint(&menus.texts, profiles, hint);
                menus.shell.toast(words, ToastKind::State);
            }
        }
    }

    /// What there was to hear since it was last asked.
    pub fn take_heard(&mut self) -> Heard {
        let play_state = match &self.phase {
            Phase::Playing(_) | Phase::InRoom(_) => PlayState::World,
            Phase::Paused(_) | Phase::RoomPaused(_) => PlayState::Paused,
            _ => PlayState::Menu,
        };
        let Some(session) = self.phase.session_mut() else {
            return Heard {
                play_state,
                surroundings: None,
                events: self
                    .phase
                    .visit_mut()
                    .map(Visit::take_sounds)
                    .unwrap_or_default(),
            };
        };
        Heard {
            play_state,
            surroundings: Some(session.scene.surroundings()),
            events: session.scene.take_sounds(),
        }
    }

    /// Has this and later worlds go by the settings.
    pub fn follow(&mut self, settings: &Settings, quality: Quality, chunks: u32) {
        self.worlds.set_quality(quality);
        self.worlds.set_view_distance(chunks);
        self.worlds.set_map(options::map(settings));
        if let Some(session) = self.phase.session_mut() {
            let scene = &mut session.scene;
            scene.set_quality(quality);
            if scene.view_distance() != chunks {
                scene.set_view_distance(chunks);
            }
            options::fit(scene, settings);
        }
    }

    /// The open world is seen through this map, if it has maps.
    pub fn turn_to(&mut self, wanted: HyperbolicMap) {
        if let Some(session) = self.phase.session_mut()
            && session.scene.lens().map().is_some_and(|map| map != wanted)
        {
            session.scene.turn_map();
        }
    }

    /// A picture of what the game is doing was drawn; `whole`: no land that has been made is missing in it.
    pub fn drawn(&mut self, whole: bool) {
        if let Phase::Loading(session) = &self.phase
            && whole
            && session.scene.loading_progress() >= 1.0
            && self.veil == Veil::Down
        {
            self.veil = Veil::Drawn;
        }
    }

    /// Lifts the veil of a world that is there; what comes after one that was left has none.
    pub fn lift_veil(&mut self, passed: Duration, reduced_motion: bool) {
        let at_once = match self.phase {
            Phase::Playing(_) | Phase::Paused(_) if self.veil != Veil::Down => reduced_motion,
            Phase::Menu | Phase::Over | Phase::InRoom(_) | Phase::RoomPaused(_) => true,
            _ => return,
        };
        self.veil = self.veil.lift(passed, at_once);
    }

    /// Whether nothing moves in a paused world whose land is all there, and no work on it has something to show when it
    /// ends.
    pub fn is_still(&self) -> bool {
        let session = match &self.phase {
            Phase::Paused(session) => session,
            Phase::RoomPaused(visit) => return visit.is_drawn && !self.portrait.is_wanted,
            Phase::InRoom(visit) => return visit.is_drawn && visit.is_built_and_still(),
            _ => return false,
        };
        let lifts = matches!(self.veil, Veil::Drawn | Veil::Lifting(_));
        session.scene.pending() == 0 && !self.saving && !self.portrait.is_wanted && !lifts
    }

    /// The number that a picture for the menu is to come back with, if one is to be taken with the next frame.
    pub fn expect_portrait(&mut self) -> Option<u64> {
        let is_wanted = std::mem::take(&mut self.portrait.is_wanted);
        is_wanted.then(|| self.portrait.expect(self.opened))
    }

    /// Keeps a picture of the world with that number if it is still open, or being closed, and writes it in the
    /// background. That of a room is written wherever the player has gone since.
    pub fn keep_picture(&mut self, world: u64, picture: RgbaImage) {
        let picture = self.portrait.hand_over(world, picture);
        let of_room = self.room_portrait.take_if(|(number, _)| *number == world);
        if let (Some(picture), Some((_, file))) = (&picture, of_room) {
            let picture = picture.clone();
            Task::start("picture", move || write_portrait(&picture, &file));
            return;
        }
        if let (Some(picture), Some(session)) = (picture, self.phase.session_mut())
            && world == self.opened
        {
            Task::start("picture", session.keep_picture(picture));
        }
    }
}

fn save_is_due(since_s: f64, settled: bool) -> bool {
    since_s >= if settled { SETTLED_SAVE_S } else { AUTOSAVE_S }
}
