//! From keys, buttons, motion and wheel to the actions of one step. Window and script go through the same door.

use std::collections::HashSet;

use antipode_scene::Actions;

use crate::bindings::{Bindings, Command, Input};

/// Turn of the view per pixel of mouse motion, in radians.
pub const LOOK_RAD_PER_PIXEL: f64 = 0.12 * std::f64::consts::PI / 180.0;

/// What is held and what has happened since the last step.
#[derive(Debug, Default)]
pub struct Controls {
    bindings: Bindings,
    held: HashSet<Command>,
    /// What went down since the last step: a press shorter than a step still acts in one.
    pressed: HashSet<Command>,
    events: Actions,
    /// Parts of a notch that wait for the rest; touchpads and fine wheels tell the wheel in fractions.
    slot_notches: f64,
}

impl Controls {
    /// The bindings in use.
    pub fn bindings(&self) -> &Bindings {
        &self.bindings
    }

    /// An input went down or up. Returns the command if it went down and is one for the shell (menu, display).
    pub fn input(&mut self, input: Input, pressed: bool) -> Option<Command> {
        let command = self.bindings.command(input)?;
        if !pressed {
            self.held.remove(&command);
            return None;
        }
        self.held.insert(command);
        self.pressed.insert(command);
        match command {
            Command::Slot(slot) => self.events.slot = Some(slot),
            Command::BrushLarger => self.events.brush_step += 1,
            Command::BrushSmaller => self.events.brush_step -= 1,
            Command::Camera => self.events.toggle_camera = !self.events.toggle_camera,
            Command::OtherMap => self.events.turn_map = !self.events.turn_map,
            Command::Menu | Command::HideDisplay | Command::FrameFigures => return Some(command),
            _ => {}
        }
        None
    }

    /// The mouse moved by pixels, right and down positive.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        self.events.look_yaw += dx * LOOK_RAD_PER_PIXEL;
        self.events.look_pitch -= dy * LOOK_RAD_PER_PIXEL;
    }

    /// The wheel turned by notches, away from the player positive. `has_dial`: whether the picture has a dial now.
    pub fn wheel(&mut self, notches: f64, has_dial: bool) {
        if has_dial && !self.held.contains(&Command::WheelSlots) {
            self.events.dial += notches;
        } else {
            self.slot_notches += notches;
            let whole = self.slot_notches.trunc();
            self.slot_notches -= whole;
            self.events.slot_step -= whole as i32;
        }
    }

    /// The actions of the next step; what is an event happens once.
    pub fn take(&mut self) -> Actions {
        let pressed = std::mem::take(&mut self.pressed);
        let held = |command| self.held.contains(&command) || pressed.contains(&command);
        let axis = |plus, minus| f64::from(i8::from(held(plus)) - i8::from(held(minus)));
        let actions = Actions {
            forward: axis(Command::Forward, Command::Backward),
            strafe: axis(Command::Right, Command::Left),
            sprint: held(Command::Sprint),
            jump: held(Command::Jump),
            sink: held(Command::Sink),
            primary: held(Command::Use),
            secondary: held(Command::SecondUse),
            ..self.events
        };
        self.events = Actions::default();
        actions
    }

    /// Lets go of everything, as when the menu opens or the window loses focus.
    pub fn release_all(&mut self) {
        self.held.clear();
        self.pressed.clear();
        self.events = Actions::default();
        self.slot_notches = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use winit::keyboard::KeyCode;

    use super::*;

    fn key(controls: &mut Controls, code: KeyCode, pressed: bool) -> Option<Command> {
        controls.input(Input::Key(code), pressed)
    }

    #[test]
    fn a_held_key_acts_until_it_is_let_go() {
        let mut c = Controls::default();
        key(&mut c, KeyCode::KeyW, true);
        assert_eq!(c.take().forward, 1.0);
        assert_eq!(c.take().forward, 1.0);
        key(&mut c, KeyCode::KeyS, true);
        assert_eq!(c.take().forward, 0.0);
        key(&mut c, KeyCode::KeyW, false);
        assert_eq!(c.take().forward, -1.0);
    }

    #[test]
    fn an_event_happens_once_however_many_steps_a_frame_has() {
        let mut c = Controls::default();
        key(&mut c, KeyCode::Tab, true);
        key(&mut c, KeyCode::KeyH, true);
        c.motion(10.0, -5.0);
        let first = c.take();
        assert!(first.turn_map);
        assert!(first.toggle_camera && first.look_yaw > 0.0 && first.look_pitch > 0.0);
        assert_eq!(c.take(), Actions::default());
    }

    #[test]
    fn the_wheel_turns_curvature_where_there_is_some_and_slots_elsewhere() {
        let mut c = Controls::default();
        c.wheel(2.0, true);
        assert_eq!(c.take().dial, 2.0);
        c.wheel(1.0, false);
        assert_eq!(c.take().slot_step, -1);
        key(&mut c, KeyCode::AltLeft, true);
        c.wheel(-1.0, true);
        let actions = c.take();
        assert_eq!((actions.dial, actions.slot_step), (0.0, 1));
    }

    #[test]
    fn a_press_shorter_than_a_step_still_acts_in_one() {
        let mut c = Controls::default();
        c.input(Input::MouseLeft, true);
        c.input(Input::MouseLeft, false);
        assert!(c.take().primary);
        assert!(!c.take().primary);
        key(&mut c, KeyCode::Space, true);
        key(&mut c, KeyCode::Space, false);
        c.release_all();
        assert!(!c.take().jump);
    }

    #[test]
    fn fractions_of_a_notch_add_up() {
        let mut c = Controls::default();
        for _ in 0..5 {
            c.wheel(0.25, false);
        }
        assert_eq!(c.take().slot_step, -1);
        c.wheel(0.75, false);
        assert_eq!(c.take().slot_step, -1);
        c.wheel(-0.5, false);
        c.wheel(-0.5, false);
        assert_eq!(c.take().slot_step, 1);
    }

    #[test]
    fn letting_go_of_everything_leaves_no_stuck_key_and_no_late_click() {
        let mut c = Controls::default();
        key(&mut c, KeyCode::KeyW, true);
        c.input(Input::MouseLeft, true);
        c.motion(500.0, 0.0);
        c.release_all();
        assert_eq!(c.take(), Actions::default());
    }

    #[test]
    fn the_menu_key_is_handed_to_the_shell_on_the_way_down_only() {
        let mut c = Controls::default();
        assert_eq!(key(&mut c, KeyCode::Escape, true), Some(Command::Menu));
        assert_eq!(key(&mut c, KeyCode::Escape, false), None);
        assert_eq!(key(&mut c, KeyCode::F4, true), Some(Command::FrameFigures));
    }
}
