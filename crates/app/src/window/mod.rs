//! The window: events in, frames out. Everything the game decides is in `game`.

mod background;
mod console;
mod framerate;
mod game;
mod hearing;
mod options;
mod pads;
mod passage;
mod phase;
mod photo;
mod pointer;
mod shots;
mod stage;
#[cfg(test)]
mod tests;
mod wheel;
mod worldlist;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use antipode_geometry::Geometry;
use antipode_settings::{Opened, Settings};
use winit::application::ApplicationHandler;
use winit::event::{DeviceEvent, DeviceId, ElementState, KeyEvent, MouseButton, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::{KeyCode, PhysicalKey};
use winit::window::{Window, WindowId};

use crate::bindings::{Input, button_input, key_input, wheel_input};
use crate::cli::{Adapter, Common, Fault};
use crate::ending::Ending;
use crate::failure::Failure;
use crate::screenshots::Album;
use crate::session::{NewWorld, Worlds};
use game::Game;
use hearing::Ears;
use pads::Pads;
use phase::Request;
use pointer::Pointer;
use stage::Stage;
use wheel::Wheel;

/// Frames before a fault that is asked for.
const FRAMES_TO_FAULT: u64 = 120;

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
    /// In the main menu, with words about a crash before.
    AfterCrash {
        /// The crash's report.
        report: PathBuf,
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
pub fn run(start: Start, common: &Common, inject: Option<Fault>) -> Result<(), Failure> {
    if common.adapter == Adapter::None {
        return Err(Failure::Usage(
            "The game in its window needs an adapter; --adapter none is for scripts".to_owned(),
        ));
    }
    let worlds = Worlds::new(common);
    let crash = match &start {
        Start::AfterCrash { report } => Some(report.clone()),
        _ => None,
    };
    let first = first_request(start, &worlds)?;
    let events = EventLoop::new().map_err(|e| Failure::no_window(&e))?;
    let mut app = App {
        common: common.clone(),
        worlds,
        first,
        settings: Some(crate::options::for_player(common.config.as_deref())),
        crash,
        inject,
        drawn: 0,
        open: None,
        failure: None,
        ending: Ending::listen(),
        next_frame: Instant::now(),
    };
    let ended = events.run_app(&mut app);
    app.finish();
    let unsaved = app.open.as_ref().and_then(|open| open.game.last_words());
    match (app.failure, unsaved) {
        (None | Some(Failure::Stopped(_)), Some(unsaved)) => {
            Err(Failure::Runtime(unsaved.to_owned()))
        }
        (Some(failure), Some(unsaved)) => Err(Failure::Runtime(format!("{failure} {unsaved}"))),
        (Some(failure), None) => Err(failure),
        (None, None) => ended.map_err(|e| Failure::no_window(&e)),
    }
}

#[allow(clippy::panic, reason = "somebody has asked for it")]
fn break_on_purpose() {
    std::panic::panic_any("the fault that was asked for");
}

fn first_request(start: Start, worlds: &Worlds) -> Result<Option<Request>, Failure> {
    Ok(match start {
        Start::Menu | Start::AfterCrash { .. } => None,
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
    ears: Ears,
    pads: Pads,
    pointer: Pointer,
    wheel: Wheel,
    occluded: bool,
    minimised: bool,
    /// The settings that the stage goes by.
    followed: Option<Settings>,
}

struct App {
    common: Common,
    worlds: Worlds,
    first: Option<Request>,
    /// The settings to begin with.
    settings: Option<Opened>,
    /// The report of a crash to tell of.
    crash: Option<PathBuf>,
    inject: Option<Fault>,
    drawn: u64,
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
                self.drawn += 1;
                if self.inject == Some(Fault::Panic) && self.drawn > FRAMES_TO_FAULT {
                    break_on_purpose();
                }
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
            let frame_time = crate::options::frame_time(&open.game.config.settings);
            self.next_frame = (self.next_frame + frame_time).max(now);
            if let (Err(stopped), None) = (self.ending.check(), &self.failure) {
                // Whoever asks for the end from outside answers no questions.
                self.failure = Some(stopped);
                open.game.end_unseen();
            }
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
        let mut game = Game::new(self.worlds.clone(), stage.software(), None);
        if let Some(opened) = self.settings.take() {
            game.begin_with(opened, &self.common);
        }
        if let Some(request) = self.first.take() {
            game.open(request);
        }
        if let Some(report) = self.crash.take() {
            game.tell_crash(&report);
        }
        let album = Album::new(&self.common, self.worlds.saves().path());
        let settings = antipode_settings::config_path(self.common.config.as_deref());
        game.begin_in(stage.adapter_name(), album, settings.as_deref());
        let ears = Ears::new(&game.config.settings);
        Ok(Open {
            stage,
            game,
            ears,
            pads: Pads::new(crate::pad::system()),
            pointer: Pointer::default(),
            wheel: Wheel::default(),
            occluded: false,
            minimised: false,
            followed: None,
        })
    }
}

impl Open {
    fn is_hidden(&self) -> bool {
        self.occluded || self.minimised
    }

    fn tick(&mut self, now: Instant) {
        let keys = self.pads.poll(&mut self.game, now);
        self.stage.input.egui_input_mut().events.extend(keys);
        self.game.tick(now);
        self.follow_settings();
        self.ears.listen(&mut self.game);
        if !self.game.is_playing() {
            self.pointer.free(&self.stage.window);
        } else if self.pointer.catch(&self.stage.window) {
            self.wheel = Wheel::default();
        }
    }

    /// Has the stage go by the settings, where they have changed.
    fn follow_settings(&mut self) {
        let settings = &self.game.config.settings;
        if self.followed.as_ref() == Some(settings) {
            return;
        }
        self.followed = Some(settings.clone());
        if let Err(why) = self.stage.follow(settings) {
            self.game.tell_not_applied(&why);
        }
    }

    fn draw(&mut self) -> Result<(), Failure> {
        // Without something to draw on, the chunks that a frame brings stay where they are.
        let Some(texture) = self.stage.next_texture()? else {
            return Ok(());
        };
        if self.game.take_wants_picture() {
            self.begin_picture();
        }
        while let Some(picture) = self.stage.finished_screenshot() {
            self.game.keep_screenshot(picture);
        }
        if let Some((world, picture)) = self.stage.finished_thumbnail() {
            self.game.keep_picture(world, picture);
        }
        self.game
            .set_canvas(self.stage.size(), self.stage.largest_side());
        if let Some(tile) = self.stage.finished_tile() {
            self.game.keep_tile(tile);
        }
        if let Some((frame, tile, size)) = self.game.next_tile() {
            self.stage.begin_tile(frame, tile, size);
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
        if self.game.config.settings.high_contrast {
            antipode_ui::heighten_contrast(&mut output.shapes);
        }
        let platform = std::mem::take(&mut output.platform_output);
        if !self.game.is_playing() {
            self.ears.interface(&platform.events);
            self.stage
                .input
                .handle_platform_output(&self.stage.window, platform);
        }
        let keeps = self.game.begin_screenshot();
        self.stage.show(texture, frame.as_ref(), output, keeps)?;
        self.game.shown(Instant::now());
        Ok(())
    }

    /// Has a picture of the open world drawn for the menu.
    fn begin_picture(&mut self) {
        let world = self.game.world_number();
        if let Some(frame) = self.game.frame(16.0 / 9.0, self.stage.height_px()) {
            self.stage.begin_thumbnail(world, &frame);
        }
    }

    /// The same, and waits for it: at the end there is no next frame to take it over in.
    fn take_picture(&mut self) {
        self.begin_picture();
        if let Some((world, picture)) = self.stage.awaited_thumbnail() {
            self.game.keep_picture(world, picture);
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
                let turned = (notches != 0.0).then(|| wheel_input(notches));
                if self.game.is_playing() || notches == 0.0 || self.take_for_binding(turned) {
                    return;
                }
            }
            WindowEvent::MouseInput { state, button, .. } if self.game.is_playing() => {
                self.button(*button, *state == ElementState::Pressed);
                return;
            }
            WindowEvent::MouseInput {
                state: ElementState::Pressed,
                button,
                ..
            } if self.take_for_binding(button_input(*button)) => return,
            _ => {}
        }
        let _ = self.stage.input.on_window_event(&self.stage.window, event);
    }

    fn button(&mut self, button: MouseButton, pressed: bool) {
        if let Some(input) = button_input(button) {
            self.game.input(input, pressed);
        }
    }

    /// Gives an input to an action that waits for one. Whether there was an input, and an action that waited.
    fn take_for_binding(&mut self, input: Option<Input>) -> bool {
        match input {
            Some(input) if self.game.shell.wants_input() => {
                self.game.shell.take_input(input);
                true
            }
            _ => false,
        }
    }

    /// Keys of the game are routed before the interface sees any, so that Tab cannot give a hidden widget the focus.
    fn key(&mut self, event: &WindowEvent, key: &KeyEvent, synthetic: bool) {
        let PhysicalKey::Code(code) = key.physical_key else {
            return;
        };
        let pressed = key.state == ElementState::Pressed;
        let input = key_input(code);
        let fresh = pressed && !key.repeat && !synthetic;
        if self.take_for_binding(input.filter(|_| fresh && code != KeyCode::Escape)) {
            return;
        }
        let typing = self.game.is_typing() || self.stage.overlay.context().text_edit_focused();
        if fresh && !self.game.is_playing() && !typing && self.game.is_fullscreen(input) {
            self.game.turn_fullscreen();
            return;
        }
        if let Some(input) = input
            && !(synthetic && pressed)
            && self.game.take_key(input, pressed, key.repeat)
        {
            return;
        }
        // The interface hears of every key that comes up: one that went down in a menu would stay down there.
        let mut for_interface = !pressed;
        if self.game.is_playing() {
            if let Some(input) = input.filter(|_| !(key.repeat || synthetic && pressed)) {
                self.game.input(input, pressed);
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
