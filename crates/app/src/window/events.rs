//! Window events on their way to the game, the interface, or an action that waits for its key.

use std::time::Instant;

use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::keyboard::PhysicalKey;

use super::open::Open;
use super::press::{Down, Press};
use crate::bindings::{button_input, key_input};

impl Open {
    /// The window may be on another monitor, with other pixels.
    fn fit(&mut self) {
        #[expect(
            clippy::disallowed_methods,
            reason = "no event tells it, and windows are seldom moved"
        )]
        let size = self.stage.window.inner_size();
        self.minimised = size.width == 0 || size.height == 0;
        if (size.width, size.height) != self.stage.size() {
            self.stage.resize(size.width, size.height);
        }
    }

    /// Draws a frame with which the menu's picture is taken.
    fn draw_last(&mut self) {
        self.game.play.portrait.is_wanted = true;
        if let Err(error) = self.draw(false) {
            tracing::info!("no picture for the menu: {error}");
        }
    }

    /// Takes an event of the window.
    pub fn handle(&mut self, event: &WindowEvent) {
        self.redraw.touch(Instant::now());
        match event {
            WindowEvent::CloseRequested => {
                if self.game.is_playing() {
                    self.draw_last();
                }
                self.game.close_window();
            }
            WindowEvent::Resized(size) => {
                self.minimised = size.width == 0 || size.height == 0;
                self.stage.resize(size.width, size.height);
            }
            WindowEvent::ScaleFactorChanged { .. } | WindowEvent::Moved(_) => self.fit(),
            WindowEvent::DroppedFile(path) => self.game.dropped(path),
            WindowEvent::Occluded(occluded) => self.occluded = *occluded,
            WindowEvent::Focused(gained) => self.focus(*gained),
            WindowEvent::KeyboardInput {
                event: key,
                is_synthetic,
                ..
            } => {
                self.key(event, key, *is_synthetic);
                return;
            }
            WindowEvent::CursorMoved { position, .. } => {
                if let Some((dx, dy)) =
                    self.pointer
                        .moved(&self.stage.window, self.stage.size(), *position)
                {
                    self.game.motion(dx, dy);
                }
                if self.game.is_playing() {
                    return;
                }
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = self.wheel.notches(*delta);
                if notches == 0.0 || self.game.wheel(notches) {
                    return;
                }
            }
            WindowEvent::MouseInput { state, button, .. } => {
                let down = *state == ElementState::Pressed;
                let press = Press::of(button_input(*button), down);
                if !self.game.press(&press).is_heard() {
                    return;
                }
            }
            _ => {}
        }
        let _ = self.stage.input.on_window_event(&self.stage.window, event);
    }

    fn focus(&mut self, gained: bool) {
        if !gained {
            // What comes up elsewhere is not told everywhere.
            self.down = Down::default();
        }
        self.game.focus(gained);
    }

    /// Keys of the game are routed before the interface sees any, so that Tab cannot give a hidden widget the focus.
    fn key(&mut self, event: &WindowEvent, key: &KeyEvent, synthetic: bool) {
        let PhysicalKey::Code(code) = key.physical_key else {
            return;
        };
        let down = key.state == ElementState::Pressed;
        let press = Press {
            input: key_input(code),
            down,
            repeats: self.down.repeats(code, down, key.repeat),
            synthetic,
            into_text: self.stage.overlay.context().text_edit_focused(),
        };
        if self.game.press(&press).is_heard() {
            let _ = self.stage.input.on_window_event(&self.stage.window, event);
        }
    }
}
