//! The game around the worlds: menu, opening, playing, pausing, closing. Knows no window and no adapter.

use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use antipode_language::Texts;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::{AUTOSAVE_S, STEP_S};
use antipode_ui::{GeometryChoice, HudModel, Intent, MenuModel, Screen, Shell, ToastKind};

use super::background::Task;
use super::console::Desk;
use super::framerate::FrameRate;
use super::options::Options;
use super::phase::{Next, Phase, Request};
use super::photo::Photographer;
use super::shots::Shots;
use super::worldlist::WorldList;
use crate::bindings::{Action, Input};
use crate::controls::Controls;
use crate::drawn::Drawn;
use crate::hud;
use crate::pad::{Feel, Sticks};
use crate::screenshots::Album;
use crate::session::{NewWorld, Session, Worlds};
use crate::wording;

/// Most steps simulated for one frame; time beyond them is dropped, so a slow moment never snowballs.
const MOST_STEPS: u32 = 6;
/// Time a frame gives to finished chunks.
pub(super) const CHUNK_BUDGET: Duration = Duration::from_millis(2);
/// Shortest time between two saves of a paused world in which the last edits have just ended, in seconds.
const SETTLED_SAVE_S: f64 = 0.2;

/// The game.
pub struct Game {
    pub(super) phase: Phase,
    pub(super) worlds: Worlds,
    pub(super) list: WorldList,
    pub(super) shell: Shell,
    /// The words of the player's language.
    pub(super) texts: Texts,
    pub(super) controls: Controls,
    /// Settings and key bindings.
    pub(super) config: antipode_settings::Config,
    pub(super) options: Options,
    /// The name of the adapter, where it draws in software.
    software: Option<String>,
    display_hidden: bool,
    figures_shown: bool,
    last_tick: Option<Instant>,
    pub(super) owed_s: f64,
    fps: FrameRate,
    pub(super) worlds_opened: u64,
    /// The player has asked for a save and is owed an answer.
    pub(super) saving: bool,
    /// Since the open world was last given to be saved, in seconds of the wall clock.
    pub(super) since_save_s: f64,
    /// Where the player was going when the world could not be saved.
    pub(super) held_up: Option<Next>,
    /// Whether the window has the keyboard; nothing is known before it has had it for the first time.
    focused: Option<bool>,
    /// Nothing can be shown any more, so nothing can be asked either.
    pub(super) unseen: bool,
    pub(super) last_words: Option<String>,
    wants_picture: bool,
    pub(super) console: Desk,
    pub(super) shots: Shots,
    pub(super) photographer: Photographer,
    /// Where the sticks of the gamepads stand.
    pub(super) sticks: Sticks,
    /// Key of the words for a player who hears nothing.
    pub(super) sound_trouble: Option<&'static str>,
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
        let mut shell = Shell::new();
        shell.open(Screen::Main);
        let list = WorldList::new(worlds.clone());
        let album = Album::at(worlds.saves().path().with_file_name("screenshots"));
        let mut game = Self {
            phase: Phase::Menu,
            worlds,
            list,
            shell,
            texts: Texts::default(),
            controls: Controls::default(),
            config: antipode_settings::Config::default(),
            options: Options::default(),
            software,
            display_hidden: false,
            figures_shown: false,
            last_tick: None,
            owed_s: 0.0,
            fps: FrameRate::default(),
            worlds_opened: 0,
            saving: false,
            since_save_s: 0.0,
            held_up: None,
            focused: None,
            unseen: false,
            last_words: None,
            wants_picture: false,
            console: Desk::default(),
            shots: Shots::new(album),
            photographer: Photographer::default(),
            sticks: Sticks::default(),
            sound_trouble: None,
        };
        game.list.refresh();
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
        matches!(self.phase, Phase::Playing(_)) && !self.is_typing() && !self.is_photographing()
    }

    /// What could not be saved when nothing could be shown any more.
    pub fn last_words(&self) -> Option<&str> {
        self.last_words.as_deref()
    }

    /// A key or button; while playing only.
    pub fn input(&mut self, input: Input, pressed: bool) {
        if !self.is_playing() {
            return;
        }
        if pressed {
            self.press_input(input);
        } else {
            self.controls.input(input, false);
        }
    }

    /// Presses an input, whoever asks for it, and does what it asks of the game around the world.
    pub(super) fn press_input(&mut self, input: Input) {
        let session = self.phase.session();
        let has_dial = session.is_some_and(|session| session.scene.lens().range().is_some());
        self.controls.set_has_dial(has_dial);
        if let Some(action) = self.controls.input(input, true) {
            self.do_for_shell(action);
        }
    }

    /// Does what concerns the game around the world.
    fn do_for_shell(&mut self, action: Action) {
        match action {
            Action::Menu => self.pause(),
            Action::HideDisplay => self.display_hidden = !self.display_hidden,
            Action::FrameFigures => self.figures_shown = !self.figures_shown,
            Action::Fullscreen => self.turn_fullscreen(),
            Action::Screenshot => self.take_screenshot(),
            Action::Console => self.open_console(),
            Action::PhotoMode => self.enter_photo_mode(),
            _ => {}
        }
    }

    /// Frames shown in a second of late; 0 while nothing is known.
    pub(super) fn frames_per_second(&self) -> f32 {
        self.fps.value()
    }

    /// Escape while the menu is open: one level back.
    pub fn escape(&mut self) {
        if self.is_typing() || self.is_photographing() {
            self.console.view.close();
            self.leave_photo_mode();
            return;
        }
        let running = matches!(self.phase, Phase::Paused(_));
        self.shell.escape(running);
        if running && !self.shell.is_open() {
            self.resume();
        }
    }

    /// Mouse motion in pixels.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        if self.is_playing() {
            self.controls.motion(dx, dy);
        }
    }

    /// The wheel, in notches.
    pub fn wheel(&mut self, notches: f64) {
        if self.is_typing() || self.is_photographing() {
            return;
        }
        if let Phase::Playing(session) = &self.phase {
            let has_dial = session.scene.lens().range().is_some();
            if let Some(action) = self.controls.wheel(notches, has_dial) {
                self.do_for_shell(action);
            }
        }
    }

    /// The window has got the keyboard, or lost it.
    pub fn focus(&mut self, gained: bool) {
        // Without a window manager nobody gives a window the keyboard, and it is told so at the start.
        if gained || self.focused.is_some() {
            self.focused = Some(gained);
        }
        if !gained {
            self.pause();
        }
    }

    /// Whether the player has turned to another window.
    pub(super) fn is_player_elsewhere(&self) -> bool {
        self.focused == Some(false)
    }

    /// Lets time pass: simulated steps while playing, finished background work in every phase.
    pub fn tick(&mut self, now: Instant) {
        let passed = self
            .last_tick
            .map_or(Duration::ZERO, |last| now.saturating_duration_since(last));
        self.last_tick = Some(now);
        self.watch_options();
        self.list.poll();
        while let Some((words, kind)) = self.list.take_news(&self.texts) {
            self.shell.toast(words, kind);
        }
        self.tell_pictures();
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
        if matches!(self.phase, Phase::Loading(_)) {
            return None;
        }
        let id = self.worlds_opened;
        let photographing = self.is_photographing();
        let session = self.phase.session_mut()?;
        session.scene.set_picture_height_px(height_px);
        if photographing {
            return self.photo_frame(aspect, id);
        }
        let fov_y_rad = session.scene.viewing().fov_y_rad;
        Some(session.scene.frame(fov_y_rad, aspect, id))
    }

    /// A frame was shown.
    pub fn shown(&mut self, now: Instant) {
        self.fps.shown(now);
    }

    /// Whether a picture of the world should be taken for the menu; asked for once.
    pub fn take_wants_picture(&mut self) -> bool {
        std::mem::take(&mut self.wants_picture)
    }

    /// Which of the worlds opened so far is open; none of them has the same number.
    pub fn world_number(&self) -> u64 {
        self.worlds_opened
    }

    /// Keeps a picture of the world with that number if it is still open, and writes it in the background.
    pub fn keep_picture(&mut self, world: u64, picture: image::RgbaImage) {
        if world != self.worlds_opened {
            return;
        }
        if let Some(session) = self.phase.session_mut() {
            let write = session.keep_picture(picture);
            Task::start("picture", write);
        }
    }

    /// Shows display and menu, and does what the player asks for there. `drawn` is what the last frame was drawn
    /// with, and the adapter's own time in milliseconds where it can tell.
    pub fn interface(&mut self, context: &egui::Context, drawn: Option<(Drawn, Option<f64>)>) {
        self.console.drawn = drawn.map(|(drawn, _)| drawn);
        if let Some(model) = self.display(drawn) {
            antipode_ui::show_hud(context, &self.texts, &model);
        }
        if self.shots.is_now() {
            // What is typed is never in a picture, nor with the display hidden is what was told of the last one.
            if (self.display_hidden || self.is_photographing()) && !self.shell.is_open() {
                return;
            }
        } else {
            self.show_console(context);
            self.show_photo_panel(context);
        }
        let running = self.running();
        self.list.show_pictures(context);
        let (rows, files) = if self.shell.is_open() {
            let running = running.as_ref().map(|(slug, _)| slug.as_str());
            (
                self.list.rows(&self.texts, running),
                self.list.files(&self.texts),
            )
        } else {
            Default::default()
        };
        let check = |name: &str| self.list.check_name(&self.texts, name);
        let check_rename = |slug: &str, name: &str| self.list.check_rename(&self.texts, slug, name);
        let notice = self.software.as_ref().map(|adapter| {
            let values = [("adapter", adapter.into())];
            self.texts.say_with("adapter-software", &values)
        });
        let sound_notice = self.sound_trouble.map(|key| self.texts.say(key));
        let model = MenuModel {
            texts: &self.texts,
            running_world: running.as_ref().map(|(_, name)| name.as_str()),
            worlds: &rows,
            config: &self.config,
            check_name: &check,
            check_rename: &check_rename,
            world_files: &files,
            adapter_notice: notice.as_deref(),
            sound_notice: sound_notice.as_deref(),
            version: env!("CARGO_PKG_VERSION"),
        };
        let intents = self.shell.show(context, &model);
        for intent in intents {
            self.follow(intent);
        }
    }

    fn running(&self) -> Option<(String, String)> {
        let session = self.phase.session()?;
        let setup = session.scene.setup();
        let values = [
            ("name", (&setup.name).into()),
            ("seed", setup.seed.to_string().into()),
        ];
        let mut title = self.texts.say_with("running-world", &values);
        if session.scene.cheated() {
            title = format!("{title} · {}", self.texts.say("cheats-used"));
        }
        Some((session.slug.clone(), title))
    }

    fn display(&self, drawn: Option<(Drawn, Option<f64>)>) -> Option<HudModel> {
        match &self.phase {
            Phase::Playing(session) if !self.display_hidden && !self.is_photographing() => {
                let fps = self.fps.value();
                let frame_ms = (fps > 0.0).then(|| 1000.0 / f64::from(fps));
                let figures = drawn.filter(|_| self.figures_shown).map(|(drawn, gpu_ms)| {
                    drawn.figures(&self.texts, &session.scene, frame_ms, gpu_ms)
                });
                Some(hud::model(&self.texts, &session.scene, fps, figures))
            }
            _ => None,
        }
    }

    pub(super) fn follow(&mut self, intent: Intent) {
        match intent {
            Intent::Resume => self.resume(),
            Intent::Save => {
                if let Some(session) = self.phase.session_mut() {
                    session.scene.save();
                    self.since_save_s = 0.0;
                    self.saving = true;
                }
            }
            Intent::SaveAndQuitToMenu => self.leave(Next::Menu),
            Intent::NewGame {
                name,
                geometry,
                seed,
                radius_m,
            } => self.leave(Next::Open(Request::New(NewWorld {
                geometry: geometry_of(geometry),
                name: Some(name),
                seed,
                radius_m,
            }))),
            Intent::Load { slug } => match self.list.work_on(&self.texts, &slug) {
                // It would be called in use by somebody else.
                Some(work) => self.shell.toast(work, ToastKind::State),
                None => self.leave(Next::Open(Request::Load(slug))),
            },
            Intent::Set { id, value } => self.set_option(id, value),
            Intent::ResetSetting(id) => self.reset_option(id),
            Intent::Bind(profiles) => self.bind(*profiles),
            Intent::Delete { slug } => self.list.delete(slug),
            Intent::Worlds(intent) => self.list.follow(intent),
            Intent::Quit => self.leave(Next::Quit),
            Intent::TrySavingAgain => {
                let next = self.held_up.take().unwrap_or(Next::Menu);
                self.leave(next);
            }
            Intent::LeaveUnsaved => self.abandon(),
            Intent::DismissMessage => {
                self.held_up = None;
                if matches!(self.phase, Phase::Paused(_)) && !self.shell.is_open() {
                    self.shell.open(Screen::Main);
                }
            }
        }
    }

    fn pause(&mut self) {
        self.console.leave();
        self.leave_photo_mode();
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Playing(mut session) => {
                self.controls.release_all();
                session.scene.save();
                self.since_save_s = 0.0;
                self.owed_s = 0.0;
                self.wants_picture = true;
                self.list.refresh();
                self.shell.open(Screen::Main);
                Phase::Paused(session)
            }
            other => other,
        };
    }

    fn resume(&mut self) {
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Paused(session) => {
                self.controls.release_all();
                self.shell.open(Screen::Hidden);
                // Closing may have failed while the land was still being made.
                if session.scene.loading_progress() < 1.0 {
                    Phase::Loading(session)
                } else {
                    Phase::Playing(session)
                }
            }
            other => other,
        };
    }

    fn playing(&mut self, mut session: Session, passed: Duration) -> Phase {
        session.scene.pump(CHUNK_BUDGET);
        // Before the steps: they save by simulated time, which never runs ahead of the wall's.
        self.keep_saved(&mut session, passed, false);
        self.owed_s += passed.as_secs_f64();
        let feel = Feel::from(&self.config.settings);
        let mut steps = 0;
        while self.owed_s >= STEP_S && steps < MOST_STEPS {
            let mut actions = self.controls.take();
            self.sticks.add_to(&mut actions, feel, STEP_S);
            session.scene.step(&actions);
            self.console.step(&mut self.controls);
            self.owed_s -= STEP_S;
            steps += 1;
        }
        self.owed_s = self.owed_s.min(STEP_S);
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
                None => self.shell.toast(self.texts.say("saved"), ToastKind::Info),
                // The scene tells a failure that comes again only once, but here somebody has asked.
                Some(problem) if !notices.contains(&problem) => notices.push(problem),
                Some(_) => {}
            }
        }
        for notice in notices {
            let words = wording::notice(&self.texts, &notice);
            self.shell.toast(words, ToastKind::Problem);
        }
        for hint in session.scene.take_hints() {
            let words = wording::hint(&self.texts, &self.config.profiles, hint);
            self.shell.toast(words, ToastKind::State);
        }
    }
}

fn geometry_of(choice: GeometryChoice) -> Geometry {
    match choice {
        GeometryChoice::Hyperbolic => Geometry::Hyperbolic,
        GeometryChoice::Euclidean => Geometry::Euclidean,
        GeometryChoice::Spherical => Geometry::Spherical,
    }
}

fn save_is_due(since_s: f64, settled: bool) -> bool {
    since_s >= if settled { SETTLED_SAVE_S } else { AUTOSAVE_S }
}
