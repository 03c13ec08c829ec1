//! The program's part in the event loop: opens the window, hands events on, and says when the next frame is due.

use std::sync::Arc;
use std::time::Instant;

use antipode_settings::Opened;
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::window::{Window, WindowId};

use super::After;
use super::game::Game;
use super::injected::Fault;
use super::injected::Injected;
use super::open::Open;
use super::phase::Request;
use super::stage::Stage;
use crate::common::{Adapter, Common};
use crate::ending::Ending;
use crate::failure::Failure;
use crate::screenshots::Album;
use crate::session::Worlds;

/// The program while its event loop runs.
pub struct App {
    common: Common,
    worlds: Worlds,
    first: Option<Request>,
    /// The settings to begin with.
    settings: Option<Opened>,
    /// How the game before this one ended, to be told.
    after: Option<After>,
    injected: Injected,
    open: Option<Open>,
    failure: Option<Failure>,
    ending: Ending,
    next_frame: Instant,
}

impl ApplicationHandler for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.open.is_some() {
            return;
        }
        match self.open_window(events) {
            Ok(open) => self.open = Some(open),
            Err(failure) => {
                self.failure = Some(failure);
                events.exit();
            }
        }
    }

    fn window_event(&mut self, _: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        match &event {
            // With the adapter lost there is nothing to draw on; what is open is still being saved.
            WindowEvent::RedrawRequested if self.failure.is_some() => {}
            WindowEvent::RedrawRequested => {
                self.injected
                    .frame(open.game.shows_world(), &mut open.stage);
                if let Err(failure) = open.draw(self.injected.can_recover()) {
                    tracing::error!("{failure}");
                    self.failure = Some(failure);
                    open.game.end_unseen();
                }
            }
            _ => open.handle(&event),
        }
    }

    fn new_events(&mut self, _: &ActiveEventLoop, _: StartCause) {
        if let Some(open) = &mut self.open {
            open.game.waits.wake();
        }
    }

    fn device_event(&mut self, _: &ActiveEventLoop, _: DeviceId, event: DeviceEvent) {
        let Some(open) = &mut self.open else { return };
        match event {
            DeviceEvent::MouseMotion { delta } => {
                if let Some((dx, dy)) = open.pointer.raw(delta) {
                    open.game.motion(dx, dy);
                }
            }
            DeviceEvent::Button { button, state } => open.wheel.raw_button(button, state),
            _ => {}
        }
    }

    /// The game goes on whether or not its window is asked to draw: a hidden one is not, on some systems.
    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        let Some(open) = &mut self.open else { return };
        let now = Instant::now();
        if now >= self.next_frame {
            if let (Err(stopped), None) = (self.ending.check(), &self.failure) {
                // Whoever asks for the end from outside answers no questions.
                self.failure = Some(stopped);
                open.game.end_unseen();
            }
            open.tick(self.injected.now());
            let draws = self.failure.is_none() && open.is_worth_drawing(now);
            if draws {
                open.stage.window.request_redraw();
                self.next_frame = (self.next_frame + open.game.frame_time()).max(now);
            } else {
                open.game.waits.nothing_to_show();
                self.next_frame = open.next_look(now);
            }
        }
        if open.game.is_over() {
            events.exit();
            return;
        }
        open.game.waits.rest();
        events.set_control_flow(ControlFlow::WaitUntil(self.next_frame));
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        self.finish();
    }
}

impl App {
    /// A program that has no window yet, and begins with `first`, or tells how the one before ended.
    pub fn new(
        common: &Common,
        worlds: Worlds,
        first: Option<Request>,
        after: Option<After>,
        inject: Option<Fault>,
    ) -> Self {
        Self {
            common: common.clone(),
            worlds,
            first,
            settings: Some(crate::options::for_player(common.config.as_deref())),
            after,
            injected: Injected::new(inject),
            open: None,
            failure: None,
            ending: Ending::listen(),
            next_frame: Instant::now(),
        }
    }

    /// Waits until what is open is on disk; why the program ended, and what it could not save.
    pub fn ended(mut self) -> (Option<Failure>, Option<String>) {
        self.finish();
        let open = self.open.as_ref();
        let unsaved = open.and_then(|open| open.game.play.last_words.clone());
        (self.failure, unsaved)
    }

    /// Waits until what is open is on disk, however the end came.
    fn finish(&mut self) {
        if let Some(open) = &mut self.open {
            open.game.finish();
        }
    }

    fn open_window(&mut self, events: &ActiveEventLoop) -> Result<Open, Failure> {
        let (width, height) = self.common.size;
        let attributes = Window::default_attributes()
            .with_title("Antipode")
            .with_window_icon(super::icon::icon())
            .with_inner_size(winit::dpi::PhysicalSize::new(width, height))
            .with_min_inner_size(winit::dpi::PhysicalSize::new(320, 200));
        let window = events
            .create_window(attributes)
            .map_err(|e| Failure::no_window(&e))?;
        let stage = self.open_stage(&Arc::new(window), events)?;
        tracing::info!("drawing with {}", stage.adapter_name());
        let mut game = Game::new(self.worlds.clone(), stage.software(), None);
        game.menus.about = super::about::about(&stage.adapter_info());
        game.backdrop.enable(stage.software().is_some());
        if let Some(opened) = self.settings.take() {
            game.begin_with(opened, &self.common);
        }
        if let Some(request) = self.first.take() {
            game.play.open(request, &mut game.menus);
        }
        match self.after.take() {
            Some(After::Crash(report)) => game.menus.tell_crash(&report),
            Some(After::Graphics(trouble)) => game.menus.tell_graphics(&trouble),
            None => {}
        }
        let album = Album::new(&self.common, self.worlds.saves().path());
        let settings = antipode_settings::config_path(self.common.config.as_deref());
        game.begin_in(stage.adapter_name(), album, settings.as_deref());
        Ok(Open::new(stage, game))
    }

    /// The stage that the command line asks for. After the graphics have failed that is one in software, and where
    /// there is none, any that will do: the player is to be told at least.
    fn open_stage(&self, window: &Arc<Window>, events: &ActiveEventLoop) -> Result<Stage, Failure> {
        let open = |common: &Common| {
            let display = events.owned_display_handle();
            Stage::new(Arc::clone(window), display, common, self.injected.shaders())
        };
        match open(&self.common) {
            Err(why) if matches!(self.after, Some(After::Graphics(_))) => {
                tracing::warn!("{why}");
                open(&Common {
                    adapter: Adapter::Auto,
                    ..self.common.clone()
                })
            }
            opened => opened,
        }
    }
}
