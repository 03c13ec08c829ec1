//! The game around the worlds: menu, opening, playing, pausing, closing. Knows no window and no adapter.

use std::time::{Duration, Instant};

use antipode_scene::Shutter;
use antipode_scene::frame::Frame;
use antipode_ui::Backpack;

use super::backdrop::Backdrop;
use super::console::Desk;
use super::framerate::FrameRate;
use super::hints::Hints;
use super::menus::Menus;
use super::options::Options;
use super::pace::Pace;
use super::phase::{Next, Phase, Request};
use super::photo::Photographer;
use super::portrait::LastPicture;
use super::shots::Shots;
use super::veil::Veil;
use super::waits::Waits;
use crate::controls::Controls;
use crate::navigator::Navigator;
use crate::pad::Sticks;
use crate::screenshots::Album;
use crate::session::Worlds;

/// Time a frame gives to finished chunks.
pub(super) const CHUNK_BUDGET: Duration = Duration::from_millis(2);

/// The game.
pub struct Game {
    pub(super) phase: Phase,
    pub(super) worlds: Worlds,
    pub(super) menus: Menus,
    pub(super) controls: Controls,
    /// Settings and key bindings.
    pub(super) config: antipode_settings::Config,
    pub(super) options: Options,
    pub(super) display_hidden: bool,
    pub(super) figures_shown: bool,
    pub(super) hit_shapes_shown: bool,
    pub(super) navigator: Navigator,
    last_tick: Option<Instant>,
    pub(super) pace: Pace,
    pub(super) fps: FrameRate,
    pub(super) worlds_opened: u64,
    /// The player has asked for a save and is owed an answer.
    pub(super) saving: bool,
    /// Since the open world was last given to be saved, in seconds of the wall clock.
    pub(super) since_save_s: f64,
    /// Where the player was going when the world could not be saved.
    pub(super) held_up: Option<Next>,
    /// Whether the window has the keyboard; nothing is known before it has had it for the first time.
    pub(super) focused: Option<bool>,
    /// Nothing can be shown any more, so nothing can be asked either.
    pub(super) unseen: bool,
    pub(super) last_words: Option<String>,
    pub(super) wants_picture: bool,
    /// The picture that is being drawn for the menu.
    pub(super) last_picture: Option<LastPicture>,
    pub(super) console: Desk,
    pub(super) backpack: Backpack,
    pub(super) shots: Shots,
    pub(super) photographer: Photographer,
    /// Where the sticks of the gamepads stand.
    pub(super) sticks: Sticks,
    pub(super) backdrop: Backdrop,
    pub(super) veil: Veil,
    pub(super) hints: Hints,
    pub(super) waits: Waits,
}

impl std::fmt::Debug for Game {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Game")
            .field("phase", &self.phase)
            .finish_non_exhaustive()
    }
}

impl Game {
    /// A game that shows the menu, or opens a world at once. `software` names the adapter if it draws in software.
    pub fn new(worlds: Worlds, software: Option<String>, first: Option<Request>) -> Self {
        let album = Album::at(worlds.saves().path().with_file_name("screenshots"));
        let mut game = Self {
            phase: Phase::Menu,
            menus: Menus::new(worlds.clone(), software),
            worlds,
            controls: Controls::default(),
            config: antipode_settings::Config::default(),
            options: Options::default(),
            display_hidden: false,
            figures_shown: false,
            hit_shapes_shown: false,
            navigator: Navigator::default(),
            last_tick: None,
            pace: Pace::default(),
            fps: FrameRate::default(),
            worlds_opened: 0,
            saving: false,
            since_save_s: 0.0,
            held_up: None,
            focused: None,
            unseen: false,
            last_words: None,
            wants_picture: false,
            last_picture: None,
            console: Desk::default(),
            backpack: Backpack::default(),
            shots: Shots::new(album),
            photographer: Photographer::default(),
            sticks: Sticks::default(),
            backdrop: Backdrop::default(),
            veil: Veil::default(),
            hints: Hints::default(),
            waits: Waits::default(),
        };
        if let Some(request) = first {
            game.open(request);
        }
        game
    }

    /// Whether the game has ended and the window may go.
    pub fn is_over(&self) -> bool {
        matches!(self.phase, Phase::Over)
    }

    /// Whether the mouse turns the view and keys act in the world.
    pub fn is_playing(&self) -> bool {
        matches!(self.phase, Phase::Playing(_)) && !self.is_elsewhere()
    }

    /// Whether keys and pointer are for something that is up over the open world.
    pub(super) fn is_elsewhere(&self) -> bool {
        self.is_typing() || self.is_photographing() || self.is_packing()
    }

    /// What could not be saved when nothing could be shown any more.
    pub fn last_words(&self) -> Option<&str> {
        self.last_words.as_deref()
    }

    /// Frames shown in a second of late; 0 while nothing is known.
    pub(super) fn frames_per_second(&self) -> f32 {
        self.fps.value()
    }

    /// Lets time pass: simulated steps while playing, finished background work in every phase.
    pub fn tick(&mut self, now: Instant) {
        let passed = self
            .last_tick
            .map_or(Duration::ZERO, |last| now.saturating_duration_since(last));
        self.last_tick = Some(now);
        self.watch_options();
        self.menus.tick();
        self.tell_pictures();
        self.watch_hints();
        self.tick_backdrop(passed);
        self.lift_veil(passed);
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Opening(task) => self.opening(task),
            Phase::Loading(session) => self.loading(session),
            Phase::Playing(session) if self.is_photographing() => {
                self.photographing(session, passed)
            }
            Phase::Playing(session) => self.playing(session, passed),
            Phase::Paused(mut session) => {
                session.scene.pump(CHUNK_BUDGET);
                self.keep_saved(&mut session, passed, true);
                self.tell(&mut session);
                Phase::Paused(session)
            }
            Phase::Closing(task, next) => self.closing(task, next),
            other => other,
        };
    }

    /// The picture to draw, if a world is open.
    pub fn frame(&mut self, aspect: f64, height_px: u32) -> Option<Frame> {
        // Behind the loading screen nothing is seen; what drawing would cost goes into making the land.
        if let Phase::Loading(session) = &self.phase
            && session.scene.loading_progress() < 1.0
        {
            return None;
        }
        if matches!(self.phase, Phase::Menu) {
            return self.backdrop_frame(aspect, height_px);
        }
        let id = self.worlds_opened;
        let photographing = self.is_photographing();
        let shutter = self.shutter();
        let session = self.phase.session_mut()?;
        session.scene.set_picture_height_px(height_px);
        if photographing {
            return self.photo_frame(aspect, id);
        }
        let fov_y_rad = session.scene.viewing().fov_y_rad;
        let scene = &mut session.scene;
        let mut frame = session.between.frame(scene, shutter, fov_y_rad, aspect, id);
        if self.display_hidden {
            (frame.hand, frame.marker) = (None, None);
        }
        if self.hit_shapes_shown {
            frame.hit_shapes = session.scene.hit_shapes();
        }
        Some(frame)
    }

    /// What of the last step the next picture shows, and of the next one's turn.
    pub(super) fn shutter(&mut self) -> Shutter {
        Shutter {
            share: self.pace.share(),
            turned_rad: self.controls.show_turn(),
        }
    }

    /// A frame was shown.
    pub fn shown(&mut self, now: Instant) {
        self.fps.shown(now);
    }
}
