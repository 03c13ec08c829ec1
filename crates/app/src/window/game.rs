//! The game around the worlds: menu, opening, playing, pausing, closing. Knows no window and no adapter.

use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::{FOV_Y_RAD, STEP_S};
use antipode_ui::{GeometryChoice, HudModel, Intent, MenuModel, Screen, Shell};

use super::background::{Progress, Task};
use super::worldlist::WorldList;
use crate::bindings::{Command, Input};
use crate::controls::Controls;
use crate::failure::Failure;
use crate::hud;
use crate::session::{NewWorld, Session, Worlds};

/// Most steps simulated for one frame; time beyond them is dropped, so a slow moment never snowballs.
const MOST_STEPS: u32 = 6;
/// Time a frame gives to finished chunks.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);

/// A world to open.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Make a new one.
    New(NewWorld),
    /// Open a saved one, by name or slug.
    Load(String),
}

/// What follows when a world has been closed.
#[derive(Debug)]
enum Next {
    Menu,
    Open(Request),
    Quit,
}

#[derive(Debug)]
enum Phase {
    Menu,
    Opening(Task<Result<Session, Failure>>),
    Loading(Session),
    Playing(Session),
    Paused(Session),
    Closing(Task<Result<(), Failure>>, Next),
    Over,
}

/// The game.
pub struct Game {
    phase: Phase,
    worlds: Worlds,
    list: WorldList,
    shell: Shell,
    controls: Controls,
    adapter_notice: Option<String>,
    display_hidden: bool,
    last_tick: Option<Instant>,
    owed_s: f64,
    fps: FrameRate,
    worlds_opened: u64,
    saving: bool,
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
            last_tick: None,
            owed_s: 0.0,
            fps: FrameRate::default(),
            worlds_opened: 0,
            saving: false,
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

    /// A key or button; while playing only.
    pub fn input(&mut self, input: Input, pressed: bool) {
        if !self.is_playing() {
            return;
        }
        match self.controls.input(input, pressed) {
            Some(Command::Menu) => self.pause(),
            Some(Command::HideDisplay) => self.display_hidden = !self.display_hidden,
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
                .wheel(notches, session.scene.dial().range().is_some());
        }
    }

    /// The window lost the keyboard.
    pub fn focus_lost(&mut self) {
        self.pause();
    }

    /// The player closes the window: what is open is committed first.
    pub fn close_window(&mut self) {
        match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.close(session, Next::Quit);
            }
            Phase::Closing(task, _) => self.phase = Phase::Closing(task, Next::Quit),
            Phase::Opening(task) => {
                // A world being opened is closed again as soon as it is there; nothing of it is lost.
                let waiting = Task::start("close", move || match task.finish() {
                    Some(Ok(session)) => session.scene.close().map_err(Failure::from),
                    _ => Ok(()),
                });
                if let Ok(task) = waiting {
                    self.phase = Phase::Closing(task, Next::Quit);
                }
            }
            Phase::Menu | Phase::Over => {}
        }
    }

    /// Lets time pass: simulated steps while playing, finished background work in every phase.
    pub fn tick(&mut self, now: Instant) {
        let passed = self
            .last_tick
            .map_or(Duration::ZERO, |last| now.saturating_duration_since(last));
        self.last_tick = Some(now);
        self.fps.frame(passed);
        self.list.poll();
        if let Some(problem) = self.list.take_problem() {
            self.shell.toast(problem, antipode_ui::ToastKind::Problem);
        }
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Opening(task) => self.opening(task),
            Phase::Loading(session) => self.loading(session),
            Phase::Playing(session) => self.playing(session, passed),
            Phase::Paused(mut session) => {
                session.scene.pump(CHUNK_BUDGET);
                self.tell(&mut session);
                Phase::Paused(session)
            }
            Phase::Closing(task, next) => self.closing(task, next),
            other => other,
        };
    }

    /// The picture to draw, if a world is open.
    pub fn frame(&mut self, aspect: f64) -> Option<Frame> {
        let id = self.worlds_opened;
        self.session_mut()
            .map(|session| session.scene.frame(FOV_Y_RAD, aspect, id))
    }

    /// Shows display and menu, and does what the player asks for there.
    pub fn interface(&mut self, context: &egui::Context) {
        if let Some(model) = self.display() {
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
        match &self.phase {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => Some((
                session.slug.clone(),
                format!(
                    "{} · seed {}",
                    session.scene.setup().name,
                    session.scene.setup().seed
                ),
            )),
            _ => None,
        }
    }

    fn session_mut(&mut self) -> Option<&mut Session> {
        match &mut self.phase {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                Some(session)
            }
            _ => None,
        }
    }

    fn display(&self) -> Option<HudModel> {
        match &self.phase {
            Phase::Playing(session) if !self.display_hidden => {
                Some(hud::model(&session.scene, self.fps.value(), None))
            }
            _ => None,
        }
    }

    fn follow(&mut self, intent: Intent) {
        match intent {
            Intent::Resume => self.resume(),
            Intent::Save => {
                if let Some(session) = self.session_mut() {
                    session.scene.save();
                    self.saving = true;
                }
            }
            Intent::SaveAndQuitToMenu => self.leave(Next::Menu),
            Intent::NewGame {
                name,
                geometry,
                seed,
                radius_m,
            } => {
                let geometry = match geometry {
                    GeometryChoice::Hyperbolic => Geometry::Hyperbolic,
                    GeometryChoice::Euclidean => Geometry::Euclidean,
                    GeometryChoice::Spherical => Geometry::Spherical,
                };
                self.leave(Next::Open(Request::New(NewWorld {
                    geometry,
                    name: Some(name),
                    seed,
                    radius_m,
                })));
            }
            Intent::Load { slug } => self.leave(Next::Open(Request::Load(slug))),
            Intent::Delete { slug } => self.list.delete(slug),
            Intent::Quit => self.leave(Next::Quit),
            Intent::DismissMessage => {}
        }
    }

    fn pause(&mut self) {
        self.phase = match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Playing(mut session) => {
                self.controls.release_all();
                session.scene.save();
                self.owed_s = 0.0;
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
                Phase::Playing(session)
            }
            other => other,
        };
    }

    /// Closes what is open, then goes on.
    fn leave(&mut self, next: Next) {
        match std::mem::replace(&mut self.phase, Phase::Menu) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.close(session, next);
            }
            Phase::Menu => self.go_on(next),
            other => self.phase = other,
        }
    }

    fn close(&mut self, session: Session, next: Next) {
        self.controls.release_all();
        self.busy("Saving", None, "Your world is written to disk.");
        match Task::start("close", move || {
            session.scene.close().map_err(Failure::from)
        }) {
            Ok(task) => self.phase = Phase::Closing(task, next),
            Err(error) => self.fail(
                "The world could not be saved",
                &format!("The system gives no more threads: {error}"),
            ),
        }
    }

    fn go_on(&mut self, next: Next) {
        match next {
            Next::Menu => {
                self.phase = Phase::Menu;
                self.list.refresh();
                self.shell.open(Screen::Main);
            }
            Next::Open(request) => self.open(request),
            Next::Quit => self.phase = Phase::Over,
        }
    }

    fn open(&mut self, request: Request) {
        let worlds = self.worlds.clone();
        self.busy("Opening", None, "The world is read from disk.");
        let work = move || match request {
            Request::New(wanted) => worlds.create(&wanted),
            Request::Load(name) => worlds.load(&name),
        };
        match Task::start("open", work) {
            Ok(task) => self.phase = Phase::Opening(task),
            Err(error) => self.fail(
                "The world could not be opened",
                &format!("The system gives no more threads: {error}"),
            ),
        }
    }

    fn opening(&mut self, task: Task<Result<Session, Failure>>) -> Phase {
        match task.poll() {
            Progress::Running => Phase::Opening(task),
            Progress::Done(Ok(session)) => {
                self.worlds_opened += 1;
                self.loading(session)
            }
            Progress::Done(Err(failure)) => {
                self.fail("The world could not be opened", &failure.to_string());
                Phase::Menu
            }
            Progress::Died => {
                self.fail(
                    "The world could not be opened",
                    "Something failed while it was read; the log has the rest.",
                );
                Phase::Menu
            }
        }
    }

    fn loading(&mut self, mut session: Session) -> Phase {
        session.scene.pump(CHUNK_BUDGET * 4);
        self.tell(&mut session);
        let progress = session.scene.loading_progress();
        if progress < 1.0 {
            self.busy(
                "Making the land",
                Some(progress),
                &session.scene.setup().name.clone(),
            );
            return Phase::Loading(session);
        }
        self.shell.open(Screen::Hidden);
        self.owed_s = 0.0;
        Phase::Playing(session)
    }

    fn playing(&mut self, mut session: Session, passed: Duration) -> Phase {
        session.scene.pump(CHUNK_BUDGET);
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

    fn closing(&mut self, task: Task<Result<(), Failure>>, next: Next) -> Phase {
        match task.poll() {
            Progress::Running => return Phase::Closing(task, next),
            Progress::Done(Ok(())) => self.go_on(next),
            Progress::Done(Err(failure)) => {
                self.fail("The world could not be saved", &failure.to_string());
                return Phase::Menu;
            }
            Progress::Died => {
                self.fail(
                    "The world could not be saved",
                    "Something failed while it was written; the log has the rest.",
                );
                return Phase::Menu;
            }
        }
        std::mem::replace(&mut self.phase, Phase::Over)
    }

    /// Tells the player what came up in the scene.
    fn tell(&mut self, session: &mut Session) {
        for notice in session.scene.take_notices() {
            self.shell.toast(notice, antipode_ui::ToastKind::Problem);
        }
        if self.saving && session.scene.is_saved() {
            self.saving = false;
            self.shell
                .toast("Saved".to_owned(), antipode_ui::ToastKind::Info);
        }
    }

    fn busy(&mut self, title: &str, progress: Option<f32>, detail: &str) {
        self.shell.open(Screen::Busy {
            title: title.to_owned(),
            progress,
            detail: detail.to_owned(),
        });
    }

    fn fail(&mut self, title: &str, text: &str) {
        tracing::error!("{title}: {text}");
        self.list.refresh();
        self.shell.open(Screen::Message {
            title: title.to_owned(),
            text: text.to_owned(),
        });
    }
}

/// Frames a second, smoothed over about half a second.
#[derive(Debug, Default)]
struct FrameRate {
    mean_s: f64,
}

impl FrameRate {
    fn frame(&mut self, passed: Duration) {
        let passed = passed.as_secs_f64();
        if passed <= 0.0 {
            return;
        }
        let share = (passed / 0.5).clamp(0.02, 1.0);
        self.mean_s = if self.mean_s == 0.0 {
            passed
        } else {
            self.mean_s + (passed - self.mean_s) * share
        };
    }

    fn value(&self) -> f32 {
        if self.mean_s > 0.0 {
            (1.0 / self.mean_s) as f32
        } else {
            0.0
        }
    }
}
