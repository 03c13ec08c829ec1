//! The window: events in, frames out. Everything the game decides is in `game`.

mod background;
mod game;
mod pointer;
mod stage;
mod worldlist;

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use winit::application::ApplicationHandler;
use winit::event::{
    DeviceEvent, DeviceId, ElementState, KeyEvent, MouseButton, MouseScrollDelta, WindowEvent,
};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::{KeyCode, PhysicalKey};
use winit::window::{Window, WindowId};

use crate::bindings::Input;
use crate::cli::Common;
use crate::failure::Failure;
use crate::session::{NewWorld, Worlds};
use game::{Game, Request};
use pointer::Pointer;
use stage::Stage;

/// Shortest time from frame to frame.
const FRAME_TIME: Duration = Duration::from_micros(16_600);
/// Pixels of a touchpad's motion that count as one notch of a wheel.
const PIXELS_PER_NOTCH: f64 = 40.0;

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
    let worlds = Worlds::new(common);
    let first = first_request(start, &worlds)?;
    let events = EventLoop::new().map_err(|e| Failure::NoWindow(e.to_string()))?;
    let mut app = App {
        common: common.clone(),
        worlds,
        first,
        open: None,
        failure: None,
        next_frame: Instant::now(),
    };
    events
        .run_app(&mut app)
        .map_err(|e| Failure::NoWindow(e.to_string()))?;
    app.failure.map_or(Ok(()), Err)
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

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        match &event {
            WindowEvent::RedrawRequested => {
                if let Err(failure) = open.draw() {
                    self.failure = Some(failure);
                    open.game.close_window();
                    events.exit();
                }
            }
            _ => open.handle(&event),
        }
    }

    fn device_event(&mut self, _: &ActiveEventLoop, _: DeviceId, event: DeviceEvent) {
        let (Some(open), DeviceEvent::MouseMotion { delta }) = (&mut self.open, event) else {
            return;
        };
        if let Some((dx, dy)) = open.pointer.raw(delta) {
            open.game.motion(dx, dy);
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        let Some(open) = &mut self.open else { return };
        if open.game.is_over() {
            events.exit();
            return;
        }
        let now = Instant::now();
        if now >= self.next_frame {
            self.next_frame = (self.next_frame + FRAME_TIME).max(now);
            open.stage.window.request_redraw();
        }
        events.set_control_flow(ControlFlow::WaitUntil(self.next_frame));
    }
}

impl App {
    fn open_window(&mut self, events: &ActiveEventLoop) -> Result<Open, Failure> {
        let (width, height) = self.common.size;
        let attributes = Window::default_attributes()
            .with_title("Antipode")
            .with_inner_size(winit::dpi::PhysicalSize::new(width, height))
            .with_min_inner_size(winit::dpi::PhysicalSize::new(320, 200));
        let window = events
            .create_window(attributes)
            .map_err(|e| Failure::NoWindow(e.to_string()))?;
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
        })
    }
}

impl Open {
    fn draw(&mut self) -> Result<(), Failure> {
        self.game.tick(Instant::now());
        if self.game.is_playing() {
            self.pointer.catch(&self.stage.window);
        } else {
            self.pointer.free(&self.stage.window);
        }
        let frame = self.game.frame(self.stage.aspect());
        let input = self.stage.input.take_egui_input(&self.stage.window);
        let game = &mut self.game;
        let mut output = self
            .stage
            .overlay
            .context()
            .run_pass(input, |context| game.interface(context));
        let platform = std::mem::take(&mut output.platform_output);
        if !self.game.is_playing() {
            self.stage
                .input
                .handle_platform_output(&self.stage.window, platform);
        }
        self.stage.draw(frame.as_ref(), output)
    }

    fn handle(&mut self, event: &WindowEvent) {
        match event {
            WindowEvent::CloseRequested => self.game.close_window(),
            WindowEvent::Resized(size) => self.stage.resize(size.width, size.height),
            WindowEvent::Focused(false) => self.game.focus_lost(),
            WindowEvent::KeyboardInput {
                event: key,
                is_synthetic,
                ..
            } => {
                self.key(event, key, *is_synthetic);
                return;
            }
            _ if self.game.is_playing() => {
                self.play(event);
                return;
            }
            _ => {}
        }
        let _ = self.stage.input.on_window_event(&self.stage.window, event);
    }

    /// Keys of the game are routed before the interface sees any, so that Tab cannot give a hidden widget the focus.
    fn key(&mut self, event: &WindowEvent, key: &KeyEvent, synthetic: bool) {
        let PhysicalKey::Code(code) = key.physical_key else {
            return;
        };
        let pressed = key.state == ElementState::Pressed;
        if self.game.is_playing() {
            if !(key.repeat || synthetic && pressed) {
                self.game.input(Input::Key(code), pressed);
            }
        } else if code == KeyCode::Escape {
            if pressed && !key.repeat {
                self.game.escape();
            }
        } else {
            let _ = self.stage.input.on_window_event(&self.stage.window, event);
        }
    }

    fn play(&mut self, event: &WindowEvent) {
        match event {
            WindowEvent::CursorMoved { position, .. } => {
                if let Some((dx, dy)) = self.pointer.moved(&self.stage.window, *position) {
                    self.game.motion(dx, dy);
                }
            }
            WindowEvent::MouseInput { state, button, .. } => {
                let input = match button {
                    MouseButton::Left => Input::MouseLeft,
                    MouseButton::Right => Input::MouseRight,
                    _ => return,
                };
                self.game.input(input, *state == ElementState::Pressed);
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = match delta {
                    MouseScrollDelta::LineDelta(_, lines) => f64::from(*lines),
                    MouseScrollDelta::PixelDelta(pixels) => pixels.y / PIXELS_PER_NOTCH,
                };
                self.game.wheel(notches);
            }
            _ => {
                let _ = self.stage.input.on_window_event(&self.stage.window, event);
            }
        }
    }
}
