//! The player's devices: keys, mouse and sticks, and whether this window has the keyboard.

use antipode_scene::Actions;

use crate::bindings::Input;
use crate::controls::Controls;
use crate::pad::{Feel, Sticks};

/// The devices of the player.
#[derive(Debug, Default)]
pub struct Devices {
    pub(super) controls: Controls,
    /// Where the sticks of the gamepads stand.
    pub(super) sticks: Sticks,
    /// Whether the player last used a gamepad.
    pub(super) by_pad: bool,
    /// What a command holds, for so many more steps.
    timed: Vec<(Input, u64)>,
    /// Whether the window has the keyboard; nothing is known before it has had it for the first time.
    focused: Option<bool>,
}

impl Devices {
    /// The window has got the keyboard, or lost it.
    pub fn focus(&mut self, gained: bool) {
        // Without a window manager nobody gives a window the keyboard, and it is told so at the start.
        if gained || self.focused.is_some() {
            self.focused = Some(gained);
        }
    }

    /// Whether the player has turned to another window.
    pub fn lost_focus(&self) -> bool {
        self.focused == Some(false)
    }

    /// The mouse has moved by so many pixels.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        self.by_pad = false;
        self.controls.motion(dx, dy);
    }

    /// Turns the view as the sticks have stood for `passed_s` seconds, if they are for it.
    pub fn turn(&mut self, feel: Option<Feel>, passed_s: f64) {
        let Some(feel) = feel else { return };
        let turn = self.sticks.turn(feel, passed_s);
        self.by_pad |= !turn.is_none();
        self.controls.turn(turn);
    }

    /// What is asked of the next step, of the sticks where they are for it.
    pub fn take(&mut self, feel: Option<Feel>) -> Actions {
        let mut actions = self.controls.take();
        if let Some(feel) = feel {
            let by_keys = actions;
            self.sticks.add_to(&mut actions, feel);
            self.by_pad |= actions != by_keys;
        }
        actions
    }

    /// Lets go of what is held down after so many steps.
    pub fn hold_for(&mut self, input: Input, steps: u64) {
        self.timed.push((input, steps));
    }

    /// A step has passed: what was held long enough is let go.
    pub fn step(&mut self) {
        self.timed.retain_mut(|(input, steps)| {
            *steps = steps.saturating_sub(1);
            if *steps == 0 {
                self.controls.input(*input, false);
            }
            *steps > 0
        });
    }

    /// Lets go of everything.
    pub fn release_all(&mut self) {
        self.timed.clear();
        self.controls.release_all();
    }
}
