//! The window: events in, frames out. Everything the game decides is in `game`.

mod background;
mod framerate;
mod game;
mod passage;
mod phase;
mod pointer;
mod stage;
#[cfg(test)]
mod tests;
mod wheel;
mod worldlist;

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, ElementState, KeyEvent, MouseButton, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::{KeyCode, PhysicalKey};
use winit::window::{Window, WindowId};

use crate::bindings::Input;
use crate::cli::{Adapter, Common};
use crate::failure::Failure;
use crate::session::{NewWorld, Worlds};
use game::Game;
use phase::Request;
use pointer::Pointer;
use stage::Stage;
use wheel::Wheel;

/// Shortest time from frame to frame.
const FRAME_TIME: Duration = Duration::from_micros(16_600);

/// How the game begins.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    /// In the main menu.
    Menu,
    /// In a new world.
    New {
        /// Its space.
        geometry: Geometry,
        /// Its seed; random when left out.
        seed: Option<u64>,
        /// Its name; a free one when left out.
        name: Option<String>,
        /// Its radius, for a spherical world.
        radius_m: Option<f64>,
    },
    /// In a saved world.
    Load {
        /// Its name.
        name: String,
    },
}

/// Opens the window and plays until it is closed.
///
/// # Errors
/// When no window can be opened, or the adapter fails.
pub fn run(start: Start, common: &Common) -> Result<(), Failure> {
    if common.adapter == Adapter::None {
        return Err(Failure::Usage(
            "The game in its window needs an adapter; --adapter none is for scripts".to_owned(),
        ));
    }
    let worlds = Worlds::new(common);
    let first = first_request(start, &worlds)?;
    let events = EventLoop::new().map_err(|e| Failure::no_window(&e))?;
    let mut app = App {
        common: common.clone(),
        worlds,
        first,
        open: None,
        failure: None,
        next_frame: Instant::now(),
    };
    let ended = events.run_app(&mut app);
    app.finish();
    let unsaved = app.open.as_ref().and_then(|open| open.game.last_words());
    match (app.failure, unsaved) {
        (Some(failure), Some(unsaved)) => Err(Failure::Runtime(format!("{failure} {unsaved}"))),
        (Some(failure), None) => Err(failure),
        (None, Some(unsaved)) => Err(Failure::Runtime(unsaved.to_owned())),
        (None, None) => ended.map_err(|e| Failure::no_window(&e)),
    }
}

fn first_request(start: Start, worlds: &Worlds) -> Result<Option<Request>, Failure> {
    Ok(match start {
        Start::Menu => None,
        Start::New {
            geometry,
            seed,
            name,
            radius_m,
        } => {
            let name = name.unwrap_or_else(|| worlds.free_name());
            Some(Request::New(NewWorld {
                geometry,
                name: Some(name),
                seed,
                radius_m,
            }))
        }
        Start::Load { name } => Some(Request::Load(worlds.saves().find(&name)?.slug)),
    })
}

struct Open {
    stage: Stage,
    game: Game,
    pointer: Pointer,
    wheel: Wheel,
    occluded: bool,
    minimised: bool,
}

struct App {
    common: Common,
    worlds: Worlds,
    first: Option<Request>,
    open: Option<Open>,
    failure: Option<Failure>,
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
                if let Err(failure) = open.draw() {
                    self.failure = Some(failure);
                    open.game.end_unseen();
                }
            }
            _ => open.handle(&event),
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
            self.next_frame = (self.next_frame + FRAME_TIME).max(now);
            open.tick(now);
            if self.failure.is_none() && !open.is_hidden() {
                open.stage.window.request_redraw();
            }
        }
        if open.game.is_over() {
            events.exit();
            return;
        }
        events.set_control_flow(ControlFlow::WaitUntil(self.next_frame));
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        self.finish();
    }
}

impl App {
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
            .with_inner_size(winit::dpi::PhysicalSize::new(width, height))
            .with_min_inner_size(winit::dpi::PhysicalSize::new(320, 200));
        let window = events
            .create_window(attributes)
            .map_err(|e| Failure::no_window(&e))?;
        let stage = Stage::new(
            Arc::new(window),
            events.owned_display_handle(),
            &self.common,
        )?;
        tracing::info!("drawing with {}", stage.adapter_name());
        let game = Game::new(self.worlds.clone(), stage.notice(), self.first.take());
        Ok(Open {
            stage,
            game,
            pointer: Pointer::default(),
            wheel: Wheel::default(),
            occluded: false,
            minimised: false,
        })
    }
}

impl Open {
    fn is_hidden(&self) -> bool {
        self.occluded || self.minimised
    }

    fn tick(&mut self, now: Instant) {
        self.game.tick(now);
        if !self.game.is_playing() {
            self.pointer.free(&self.stage.window);
        } else if self.pointer.catch(&self.stage.window) {
            self.wheel = Wheel::default();
        }
    }

    fn draw(&mut self) -> Result<(), Failure> {
        // Without something to draw on, the chunks that a frame brings stay where they are.
        let Some(texture) = self.stage.next_texture()? else {
            return Ok(());
        };
        if self.game.take_wants_picture() {
            self.take_picture();
        }
        let frame = self.game.frame(self.stage.aspect(), self.stage.height_px());
        let input = self.stage.input.take_egui_input(&self.stage.window);
        let game = &mut self.game;
        let drawn = self.stage.drawn();
        let mut output = self
            .stage
            .overlay
            .context()
            .run_pass(input, |context| game.interface(context, drawn));
        let platform = std::mem::take(&mut output.platform_output);
        if !self.game.is_playing() {
            self.stage
                .input
                .handle_platform_output(&self.stage.window, platform);
        }
        self.stage.show(texture, frame.as_ref(), output)?;
        self.game.shown(Instant::now());
        Ok(())
    }

    /// Takes a picture of the open world for the menu.
    fn take_picture(&mut self) {
        let picture = self
            .game
            .frame(16.0 / 9.0, self.stage.height_px())
            .and_then(|frame| self.stage.thumbnail(&frame));
        if let Some(picture) = picture {
            self.game.keep_picture(picture);
        }
    }

    fn handle(&mut self, event: &WindowEvent) {
        match event {
            WindowEvent::CloseRequested => {
                if self.game.is_playing() {
                    self.take_picture();
                }
                self.game.close_window();
            }
            WindowEvent::Resized(size) => {
                self.minimised = size.width == 0 || size.height == 0;
                self.stage.resize(size.width, size.height);
            }
            WindowEvent::Occluded(occluded) => self.occluded = *occluded,
            WindowEvent::Focused(gained) => self.game.focus(*gained),
            WindowEvent::KeyboardInput {
                event: key,
                is_synthetic,
                ..
            } => {
                self.key(event, key, *is_synthetic);
                return;
            }
            WindowEvent::CursorMoved { position, .. } => {
                if let Some((dx, dy)) = self.pointer.moved(&self.stage.window, *position) {
                    self.game.motion(dx, dy);
                }
                if self.game.is_playing() {
                    return;
                }
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = self.wheel.notches(*delta);
                self.game.wheel(notches);
                if self.game.is_playing() || notches == 0.0 {
                    return;
                }
            }
            WindowEvent::MouseInput { state, button, .. } if self.game.is_playing() => {
                self.button(*button, *state == ElementState::Pressed);
                return;
            }
            _ => {}
        }
        let _ = self.stage.input.on_window_event(&self.stage.window, event);
    }

    fn button(&mut self, button: MouseButton, pressed: bool) {
        match button {
            MouseButton::Left => self.game.input(Input::MouseLeft, pressed),
            MouseButton::Right => self.game.input(Input::MouseRight, pressed),
            _ => {}
        }
    }

    /// Keys of the game are routed before the interface sees any, so that Tab cannot give a hidden widget the focus.
    fn key(&mut self, event: &WindowEvent, key: &KeyEvent, synthetic: bool) {
        let PhysicalKey::Code(code) = key.physical_key else {
            return;
        };
        let pressed = key.state == ElementState::Pressed;
        // The interface hears of every key that comes up: one that went down in a menu would stay down there.
        let mut for_interface = !pressed;
        if self.game.is_playing() {
            if !(key.repeat || synthetic && pressed) {
                self.game.input(Input::Key(code), pressed);
            }
        } else if code != KeyCode::Escape {
            for_interface = true;
        } else if pressed && !key.repeat {
            self.game.escape();
        }
        if for_interface {
            let _ = self.stage.input.on_window_event(&self.stage.window, event);
        }
    }
}
