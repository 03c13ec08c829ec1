//! What the player does to the game in front of it: keys, mouse, wheel and the keyboard's comings and goings.

use super::game::Game;
use super::layers::Press;
use super::phase::Phase;
use crate::bindings::{Action, Input, wheel_input};

impl Game {
    /// A key or button; while playing only.
    pub fn input(&mut self, input: Input, pressed: bool) {
        if !self.is_playing() {
            return;
        }
        if pressed {
            self.note_device(input);
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
            Action::HitShapes => self.hit_shapes_shown = !self.hit_shapes_shown,
            Action::FrameFigures => self.figures_shown = !self.figures_shown,
            Action::Fullscreen => self.turn_fullscreen(),
            Action::Screenshot => self.take_screenshot(),
            Action::Console => self.open_console(),
            Action::PhotoMode => self.enter_photo_mode(),
            Action::SkipHint => self.skip_hint(),
            Action::Backpack => self.open_backpack(),
            _ => {}
        }
    }

    /// Escape while the menu is open: one level back.
    pub fn escape(&mut self) {
        if self.is_typing() || self.is_photographing() {
            self.console.view.close();
            self.leave_photo_mode();
            return;
        }
        if self.is_packing() {
            self.close_backpack();
            return;
        }
        let running = matches!(self.phase, Phase::Paused(_));
        self.menus.shell.escape(running);
        if running && !self.menus.shell.is_open() {
            self.resume();
        }
    }

    /// Mouse motion in pixels.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        if self.is_playing() {
            self.hints.use_pad(false);
            self.controls.motion(dx, dy);
        }
    }

    /// The wheel, in notches other than none. Whether it is nothing for the interface: in the world it may turn a dial, by
    /// as much as it is turned; elsewhere it is a press like any other.
    pub fn wheel(&mut self, notches: f64) -> bool {
        if !self.is_playing() {
            return !self
                .press(&Press::of(wheel_input(notches), true))
                .is_heard();
        }
        if let Phase::Playing(session) = &self.phase {
            let has_dial = session.scene.lens().range().is_some();
            if let Some(action) = self.controls.wheel(notches, has_dial) {
                self.do_for_shell(action);
            }
        }
        true
    }

    /// The window has got the keyboard, or lost it.
    pub fn focus(&mut self, gained: bool) {
        // Without a window manager nobody gives a window the keyboard, and it is told so at the start.
        if gained || self.focused.is_some() {
            self.focused = Some(gained);
        }
        if gained {
            return;
        }
        if self.is_photographing() {
            // The world stands still there already, and the picture that was being composed is not given up.
            self.controls.release_all();
        } else {
            self.pause();
        }
    }

    /// Whether the player has turned to another window.
    pub(super) fn is_player_elsewhere(&self) -> bool {
        self.focused == Some(false)
    }
}
