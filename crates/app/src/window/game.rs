//! The game: what it is made of, and the order of things in a frame. Knows no window and no adapter.

use std::path::Path;
use std::time::{Duration, Instant};

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_scene::Shutter;
use antipode_scene::frame::Frame;
use antipode_settings::{Config, Keeper, Opened, Value};
use antipode_ui::Screen;

use super::backdrop::Backdrop;
use super::devices::Devices;
use super::display::Display;
use super::hints::Hints;
use super::menus::Menus;
use super::options::Options;
use super::overlays::Overlays;
use super::phase::{Next, Phase, Request};
use super::play::{CHUNK_BUDGET, Play};
use super::portrait::{PortraitView, portrait_of, room_portrait_of};
use super::shots::Shots;
use super::visit::RoomId;
use super::waits::Waits;
use crate::common::Common;
use crate::pad::Feel;
use crate::room_picture::RoomView;
use crate::screenshots::Album;
use crate::session::Worlds;

/// Shortest time between two pictures of the menu where the processor draws them.
const SOFTWARE_FRAME: Duration = Duration::from_millis(50);
/// The same while the player is at another window.
const UNWATCHED_FRAME: Duration = Duration::from_millis(200);

/// The game.
pub struct Game {
    /// Worlds, and the one that is open.
    pub(super) play: Play,
    /// What can be up over the open world.
    pub(super) overlays: Overlays,
    pub(super) menus: Menus,
    /// Settings and key bindings.
    pub(super) options: Options,
    pub(super) devices: Devices,
    pub(super) display: Display,
    pub(super) hints: Hints,
    pub(super) shots: Shots,
    /// The world behind the menu.
    pub(super) backdrop: Backdrop,
    pub(super) waits: Waits,
    last_tick: Option<Instant>,
}

impl Game {
    /// A game that shows the menu, or opens a world at once. `software` names the adapter if it draws in software.
    pub fn new(worlds: Worlds, software: Option<String>, first: Option<Request>) -> Self {
        let album = Album::at(worlds.saves().path().with_file_name("screenshots"));
        let is_software = software.is_some();
        let mut game = Self {
            menus: Menus::new(worlds.clone(), software),
            play: Play::new(worlds),
            overlays: Overlays::default(),
            options: Options::new(Config::default(), Keeper::idle(), None, is_software),
            devices: Devices::default(),
            display: Display::default(),
            hints: Hints::default(),
            shots: Shots::new(album),
            backdrop: Backdrop::default(),
            waits: Waits::default(),
            last_tick: None,
        };
        if let Some(request) = first {
            game.play.open(request, &mut game.menus);
        }
        game
    }

    /// Takes over what only the window knows: the adapter's name, and where pictures go.
    /// And what was entered in the console before, which lies beside the settings.
    pub fn begin_in(&mut self, adapter: &str, album: Album, settings: Option<&Path>) {
        let console = &mut self.overlays.console;
        adapter.clone_into(&mut console.adapter);
        if let Some(settings) = settings {
            console.remember_in(settings.with_file_name("console-history.txt"));
        }
        self.shots.album = album;
    }

    /// Takes over the settings to begin with, and tells what there is to tell of their file.
    pub fn begin_with(&mut self, opened: Opened, common: &Common) {
        let software = self.options.software;
        self.options = Options::new(opened.config, opened.keeper, Some(common), software);
        let config = &self.options.config;
        self.hints.go_on(&config.learnt);
        self.menus.texts = crate::options::texts(&config.settings);
        let controls = &mut self.devices.controls;
        self.options.apply(controls, &mut self.play);
        self.menus.tell_settings(&opened.notices);
    }

    /// Whether the game has ended and the window may go.
    pub fn is_over(&self) -> bool {
        matches!(self.play.phase, Phase::Over)
    }

    /// Whether the mouse turns the view and keys act in the world.
    pub fn is_playing(&self) -> bool {
        self.play.phase.is_played() && !self.overlays.are_up()
    }

    /// Whether what is drawn is an open world or room.
    pub fn shows_world(&self) -> bool {
        self.play.phase.is_played() || self.play.phase.is_paused()
    }

    /// Whether nothing moves until somebody does something: a paused world, or a menu that no world flies by behind, and
    /// no work is under way that has something to show when it ends.
    pub fn is_still(&self) -> bool {
        let rests = match self.play.phase {
            Phase::Menu => !self.wants_backdrop(),
            _ => self.play.is_still(),
        };
        rests && self.menus.are_lists_idle() && self.shots.is_idle()
    }

    /// Shortest time from frame to frame. Where the processor draws, a menu leaves it something to do besides.
    pub fn frame_time(&self) -> Duration {
        let wanted = crate::options::frame_time(&self.options.config.settings);
        let least = match self.play.phase {
            Phase::Menu if self.menus.software.is_none() => Duration::ZERO,
            Phase::Menu if self.devices.lost_focus() => UNWATCHED_FRAME,
            Phase::Menu => SOFTWARE_FRAME,
            _ => Duration::ZERO,
        };
        wanted.max(least)
    }

    /// The window has got the keyboard, or lost it.
    pub fn focus(&mut self, gained: bool) {
        self.devices.focus(gained);
        if !gained && self.overlays.is_photographing() {
            // The world stands still there already, and the picture that was being composed is not given up.
            self.devices.release_all();
        } else if !gained && self.play.phase.is_built() {
            // Nothing happens there that would have to wait.
            self.devices.release_all();
        } else if !gained {
            self.pause();
        }
    }

    /// Pauses the world, if one is played.
    pub(super) fn pause(&mut self) {
        self.close_overlays();
        self.play.pause(&mut self.menus);
    }

    /// Plays on, if the world is paused.
    pub(super) fn resume(&mut self) {
        self.devices.release_all();
        self.play.resume(&mut self.menus);
    }

    /// Begins anew in the open room.
    pub(super) fn begin_anew(&mut self) {
        if let Some(visit) = self.play.phase.visit_mut() {
            visit.begin_anew();
            self.resume();
        }
    }

    /// Closes what is open, then goes on.
    pub(super) fn leave(&mut self, next: Next) {
        self.close_overlays();
        self.play.leave(next, &mut self.menus);
    }

    /// The player closes the window: what is open is committed first.
    pub fn close_window(&mut self) {
        self.leave(Next::Quit);
    }

    /// Nothing can be shown any more: saves what is open and ends without asking.
    pub fn end_unseen(&mut self) {
        self.close_overlays();
        self.play.end_unseen(&mut self.menus);
    }

    /// Ends at once, but not before what is open is on disk.
    pub fn finish(&mut self) {
        self.end_unseen();
        self.overlays.console.keep_history();
        self.shots.finish();
        self.play.finish();
    }

    /// The world is left or paused: nothing is held, and nothing is up over it.
    fn close_overlays(&mut self) {
        let (devices, play) = (&mut self.devices, &mut self.play);
        self.overlays.close_all(devices, play, &mut self.menus);
        self.devices.release_all();
    }

    /// Lets time pass: simulated steps while playing, finished background work in every phase.
    pub fn tick(&mut self, now: Instant) {
        let last = self.last_tick.replace(now).unwrap_or(now);
        let passed = now.saturating_duration_since(last);
        self.options.watch(&mut self.menus);
        self.menus.tick();
        self.shots.tell(&mut self.menus);
        self.watch_hints();
        self.go_on_reading();
        let wants_backdrop = self.wants_backdrop();
        self.backdrop.tick(passed, wants_backdrop);
        let settings = &self.options.config.settings;
        self.play.lift_veil(passed, settings.reduced_motion);
        match &mut self.play.phase {
            Phase::Playing(session) if self.overlays.is_photographing() => {
                let photo = &mut self.overlays.photo;
                photo.fly(session, &mut self.devices, passed);
                self.play.keep_saved(passed, true);
            }
            Phase::Playing(_) => {
                // The sticks belong to what is up over the world, as the keys do.
                let feel = (!self.overlays.are_up()).then(|| Feel::from(settings));
                let hints = settings.hints.then_some(&mut self.hints);
                let (devices, waits) = (&mut self.devices, &mut self.waits);
                self.play.advance(passed, devices, feel, hints, waits);
            }
            Phase::InRoom(visit) if visit.workshop.is_some() => self.tick_workshop(passed),
            Phase::InRoom(visit) if visit.is_drawn => {
                let feel = (!self.overlays.are_up()).then(|| Feel::from(settings));
                visit.advance(passed, &mut self.play.pace, &mut self.devices, feel);
                self.watch_lesson();
            }
            Phase::InRoom(_) | Phase::RoomPaused(_) => {}
            Phase::Paused(session) => {
                session.scene.pump(CHUNK_BUDGET);
                self.play.keep_saved(passed, true);
            }
            _ => {
                let elsewhere = self.devices.lost_focus();
                self.play.poll(&mut self.menus, settings, elsewhere);
            }
        }
        let profiles = &self.options.config.profiles;
        self.play
            .tell(&mut self.menus, profiles, self.display.hidden);
    }

    fn watch_hints(&mut self) {
        self.hints.use_pad(self.devices.by_pad);
        let shown = self.options.config.settings.hints;
        if self.hints.watch(shown, &self.play.phase) {
            self.set_option("hints", Value::Switch(false));
        }
        self.options.keep_learnt(self.hints.learnt());
    }

    /// Whether the player looks at menus with no world open, and wants things to move.
    fn wants_backdrop(&self) -> bool {
        matches!(self.play.phase, Phase::Menu)
            && !self.options.config.settings.reduced_motion
            && !matches!(self.menus.shell.screen(), Screen::Busy { .. })
    }

    /// The picture to draw, if a world is open.
    pub fn frame(&mut self, aspect: f64, height_px: u32) -> Option<Frame> {
        if matches!(self.play.phase, Phase::Menu) {
            let wanted = self.wants_backdrop();
            return wanted.then(|| self.backdrop.frame(aspect, height_px))?;
        }
        let (id, shutter) = (self.play.opened, self.shutter());
        let is_loading = matches!(self.play.phase, Phase::Loading(_));
        let is_played = matches!(self.play.phase, Phase::Playing(_));
        let session = self.play.phase.session_mut()?;
        let scene = &mut session.scene;
        // Behind the loading screen nothing is seen; what drawing would cost goes into making the land.
        if is_loading && scene.loading_progress() < 1.0 {
            return None;
        }
        scene.set_picture_height_px(height_px);
        if self.overlays.is_photographing() {
            return self.overlays.photo.frame(&mut self.play, aspect);
        }
        let fov_y_rad = scene.viewing().fov_y_rad;
        let mut frame = session.between.frame(scene, shutter, fov_y_rad, aspect, id);
        let software = self.menus.software.is_some();
        crate::options::fit_mirror(&mut frame, &self.options.of_pictures(), software);
        self.display.apply_to(&mut frame, &session.scene, is_played);
        Some(frame)
    }

    /// What a picture of that width over height is of, if a room is open.
    pub fn room_view(&mut self, aspect: f64) -> Option<RoomView> {
        let (shutter, quality) = (self.shutter(), self.play.worlds.quality());
        let with_hand = !self.display.hidden;
        let is_paused = self.play.phase.is_paused();
        let visit = self.play.phase.visit_mut()?;
        visit.aspect = aspect;
        visit.room.fit(&self.options.config.settings);
        if let Some(view) = visit.workshop_view(is_paused.then_some(aspect)) {
            return Some(view);
        }
        Some(visit.view(shutter, quality, with_hand))
    }

    /// The open room, with what tells its picture from others, and the words for what is read in it.
    pub fn room(&mut self) -> Option<(RoomId, &RoomScene, &Texts)> {
        let texts = &self.menus.texts;
        let visit = self.play.phase.visit_mut()?;
        visit.speak(texts.language());
        Some((visit.id(), visit.scene(), texts))
    }

    /// The view of the picture of the open world for the menu, if one is to be taken with a frame: the world, and nothing
    /// that the player is told of it. The picture is to come back with the world's number.
    pub fn portrait(&mut self, frame: &Frame) -> Option<(u64, PortraitView)> {
        let number = self.play.expect_portrait()?;
        Some((number, PortraitView::World(portrait_of(frame))))
    }

    /// The same of the open room.
    pub fn room_portrait(&mut self, view: &RoomView) -> Option<(u64, PortraitView)> {
        let number = self.play.expect_portrait()?;
        Some((number, PortraitView::Room(room_portrait_of(view))))
    }

    /// What of the last step the next picture shows, and of the next one's turn.
    pub(super) fn shutter(&mut self) -> Shutter {
        Shutter {
            share: self.play.pace.share(),
            turned: self.devices.controls.show_turn(),
        }
    }
}
