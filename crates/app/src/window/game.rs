//! The game around the worlds: menu, opening, playing, pausing, closing. Knows no window and no adapter.

use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::{AUTOSAVE_S, FOV_Y_RAD, STEP_S};
use antipode_ui::{GeometryChoice, HudModel, Intent, MenuModel, Screen, Shell, ToastKind};

use super::framerate::FrameRate;
use super::phase::{Next, Phase, Request};
use super::worldlist::WorldList;
use crate::bindings::{Command, Input};
use crate::controls::Controls;
use crate::drawn::Drawn;
use crate::hud;
use crate::session::{NewWorld, Session, Worlds};

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
    pub(super) controls: Controls,
    adapter_notice: Option<String>,
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
}

impl std::fmt::Debug for Game {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Game")
            .field("phase", &self.phase)
            .finish_non_exhaustive()
    }
}

impl Game {
    /// A game that shows the menu, or opens a world at once.
    pub fn new(worlds: Worlds, adapter_notice: Option<String>, first: Option<Request>) -> Self {
        let mut shell = Shell::new();
        shell.open(Screen::Main);
        let list = WorldList::new(worlds.clone());
        let mut game = Self {
            phase: Phase::Menu,
            worlds,
            list,
            shell,
            controls: Controls::default(),
            adapter_notice,
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
        matches!(self.phase, Phase::Playing(_))
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
        match self.controls.input(input, pressed) {
            Some(Command::Menu) => self.pause(),
            Some(Command::HideDisplay) => self.display_hidden = !self.display_hidden,
            Some(Command::FrameFigures) => self.figures_shown = !self.figures_shown,
            _ => {}
        }
    }

    /// Escape while the menu is open: one level back.
    pub fn escape(&mut self) {
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
        if let Phase::Playing(session) = &self.phase {
            self.controls
                .wheel(notches, session.scene.lens().range().is_some());
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
        self.list.poll();
        while let Some(problem) = self.list.take_problem() {
            self.shell.toast(problem, ToastKind::Problem);
        }
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Opening(task) => self.opening(task),
            Phase::Loading(session) => self.loading(session),
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
        let session = self.phase.session_mut()?;
        session.scene.set_picture_height_px(height_px);
        Some(session.scene.frame(FOV_Y_RAD, aspect, id))
    }

    /// A frame was shown.
    pub fn shown(&mut self, now: Instant) {
        self.fps.shown(now);
    }

    /// Whether a picture of the world should be taken for the menu; asked for once.
    pub fn take_wants_picture(&mut self) -> bool {
        std::mem::take(&mut self.wants_picture)
    }

    /// Keeps a picture of the open world.
    pub fn keep_picture(&mut self, picture: image::RgbaImage) {
        if let Some(session) = self.phase.session_mut() {
            session.picture = Some(picture);
        }
    }

    /// Shows display and menu, and does what the player asks for there. `drawn` is what the last frame was drawn
    /// with, and the adapter's own time in milliseconds where it can tell.
    pub fn interface(&mut self, context: &egui::Context, drawn: Option<(Drawn, Option<f64>)>) {
        if let Some(model) = self.display(drawn) {
            antipode_ui::show_hud(context, &model);
        }
        let bindings: Vec<_> = self
            .controls
            .bindings()
            .lines()
            .into_iter()
            .map(|line| antipode_ui::Binding {
                action: line.action,
                keys: line.keys,
                group: line.group.to_owned(),
            })
            .collect();
        let running = self.running();
        let rows = self
            .list
            .rows(running.as_ref().map(|(slug, _)| slug.as_str()));
        let check = |name: &str| self.list.check_name(name);
        let model = MenuModel {
            running_world: running.as_ref().map(|(_, name)| name.as_str()),
            worlds: &rows,
            bindings: &bindings,
            check_name: &check,
            adapter_notice: self.adapter_notice.as_deref(),
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
        let title = format!("{} · seed {}", setup.name, setup.seed);
        Some((session.slug.clone(), title))
    }

    fn display(&self, drawn: Option<(Drawn, Option<f64>)>) -> Option<HudModel> {
        match &self.phase {
            Phase::Playing(session) if !self.display_hidden => {
                let fps = self.fps.value();
                let frame_ms = (fps > 0.0).then(|| 1000.0 / f64::from(fps));
                let figures = drawn
                    .filter(|_| self.figures_shown)
                    .map(|(drawn, gpu_ms)| drawn.figures(&session.scene, frame_ms, gpu_ms));
                Some(hud::model(&session.scene, fps, figures))
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
            Intent::Load { slug } => self.leave(Next::Open(Request::Load(slug))),
            Intent::Delete { slug } => self.list.delete(slug),
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
        let mut steps = 0;
        while self.owed_s >= STEP_S && steps < MOST_STEPS {
            session.scene.step(&self.controls.take());
            self.owed_s -= STEP_S;
            steps += 1;
        }
        self.owed_s = self.owed_s.min(STEP_S);
        self.tell(&mut session);
        Phase::Playing(session)
    }

    /// Saves by the wall clock, however slowly the simulation runs, and in a paused world again as soon as the
    /// edits that were under way have ended.
    fn keep_saved(&mut self, session: &mut Session, passed: Duration, paused: bool) {
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
                None => self.shell.toast("Saved", ToastKind::Info),
                // The scene tells a failure that comes again only once, but here somebody has asked.
                Some(problem) if !notices.contains(&problem) => notices.push(problem),
                Some(_) => {}
            }
        }
        for notice in notices {
            self.shell.toast(notice, ToastKind::Problem);
        }
        for hint in session.scene.take_hints() {
            self.shell.toast(hint, ToastKind::State);
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
