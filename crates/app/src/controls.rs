//! Turns keys, buttons, mouse motion and wheel into the actions of one step. The window and scripts both use it.

use std::collections::HashSet;

use antipode_scene::{Actions, LookTurn};
use antipode_settings::{Action, Config, Input, Profile, Settings};

use crate::bindings::wheel_input;

/// Uses of what is in hand: one step begins one of them only.
const USES: [Action; 2] = [Action::Use, Action::SecondUse];
/// Of these every press counts, however long a frame takes.
const COUNTED: [Action; 5] = [
    Action::Use,
    Action::SecondUse,
    Action::Drop,
    Action::Camera,
    Action::OtherMap,
];
/// So many presses of one of them are remembered.
const MOST_PRESSES: usize = 8;

/// What is held and what has happened since the last step.
#[derive(Debug)]
pub struct Controls {
    profile: Profile,
    look_rad_per_px: f64,
    /// 1, or -1 where moving the mouse away looks down.
    look_up: f64,
    curvature_step: f64,
    held: HashSet<Input>,
    /// What went down since the last step, in order: a press shorter than a step still acts in one. Where each press counts,
    /// those after the first wait for steps of their own.
    pressed: Vec<Action>,
    /// Uses of what is in hand that the last step took for held.
    used: Vec<Action>,
    events: Actions,
    /// How far the view is turned since the last step.
    turned: LookTurn,
    /// How much of that a picture has shown.
    shown: LookTurn,
    /// Whether the picture has a dial now.
    has_dial: bool,
    /// Parts of a notch that wait for the rest; touchpads and fine wheels tell the wheel in fractions.
    notches: f64,
}

impl Default for Controls {
    fn default() -> Self {
        let Config {
            settings, profiles, ..
        } = Config::default();
        let mut controls = Self {
            profile: profiles.chosen().clone(),
            look_rad_per_px: 0.0,
            look_up: 1.0,
            curvature_step: 1.0,
            held: HashSet::new(),
            pressed: Vec::new(),
            used: Vec::new(),
            events: Actions::default(),
            turned: LookTurn::default(),
            shown: LookTurn::default(),
            has_dial: false,
            notches: 0.0,
        };
        controls.follow(&settings);
        controls
    }
}

impl Controls {
    /// Goes by these settings and bindings from now on; what is held is let go where the bindings differ.
    pub fn set_config(&mut self, config: &Config) {
        self.follow(&config.settings);
        let profile = config.profiles.chosen();
        if self.profile != *profile {
            self.profile = profile.clone();
            self.release_all();
        }
    }

    fn follow(&mut self, settings: &Settings) {
        self.look_rad_per_px = settings.mouse_sensitivity_deg_per_px.to_radians();
        self.look_up = if settings.invert_look { -1.0 } else { 1.0 };
        self.curvature_step = settings.curvature_step;
    }

    /// Whether an input does an action.
    pub fn does(&self, input: Input, action: Action) -> bool {
        self.profile.inputs(action).contains(&input)
    }

    /// An input went down or up. Returns the action if it went down and does one for the shell (menu, display).
    pub fn input(&mut self, input: Input, pressed: bool) -> Option<Action> {
        if !pressed {
            self.held.remove(&input);
            return None;
        }
        self.held.insert(input);
        let actions: Vec<_> = self.profile.actions(input).collect();
        let turns_dial = self.turns_dial(&actions);
        let mut for_shell = None;
        for action in actions {
            if is_slot_step(action) && turns_dial {
                continue;
            }
            for_shell = for_shell.or(self.act(action));
            match action {
                Action::DialUp => self.events.dial += self.curvature_step,
                Action::DialDown => self.events.dial -= self.curvature_step,
                _ => {}
            }
        }
        for_shell
    }

    /// The mouse moved by pixels, right and down positive.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        self.turn(LookTurn {
            right_rad: dx * self.look_rad_per_px,
            up_rad: -dy * self.look_rad_per_px * self.look_up,
        });
    }

    /// Turns the view.
    pub fn turn(&mut self, by: LookTurn) {
        self.turned.right_rad += by.right_rad;
        self.turned.up_rad += by.up_rad;
    }

    /// How far the next step will turn the view, to be shown at once.
    pub fn show_turn(&mut self) -> LookTurn {
        self.shown = self.turned;
        self.shown
    }

    /// Tells whether the picture has a dial now: what turns both, turns it and not the hotbar.
    pub fn set_has_dial(&mut self, has_dial: bool) {
        self.has_dial = has_dial;
    }

    /// The wheel turned by notches, away from the player positive. `has_dial`: whether the picture has a dial now.
    /// Returns an action for the shell, as [`Controls::input`] does.
    pub fn wheel(&mut self, notches: f64, has_dial: bool) -> Option<Action> {
        self.has_dial = has_dial;
        let actions: Vec<_> = self.profile.actions(wheel_input(notches)).collect();
        let turns_dial = self.turns_dial(&actions);
        let turned = notches.abs() * self.curvature_step;
        let mut by_notch = Vec::new();
        for action in actions {
            match action {
                Action::DialUp if turns_dial => self.events.dial += turned,
                Action::DialDown if turns_dial => self.events.dial -= turned,
                Action::DialUp | Action::DialDown => {}
                _ if is_slot_step(action) && turns_dial => {}
                _ => by_notch.push(action),
            }
        }
        if by_notch.is_empty() {
            return None;
        }
        self.notches += notches;
        let whole = self.notches.trunc();
        self.notches -= whole;
        let mut for_shell = None;
        for _ in 0..whole.abs() as u32 {
            for action in &by_notch {
                for_shell = for_shell.or(self.act(*action));
            }
        }
        for_shell
    }

    /// The actions of the next step; what is an event happens once.
    pub fn take(&mut self) -> Actions {
        self.shown = LookTurn::default();
        let turned = std::mem::take(&mut self.turned);
        Actions {
            look_yaw: turned.right_rad,
            look_pitch: turned.up_rad,
            ..self.take_keys()
        }
    }

    /// As [`Controls::take`], but that the view does not turn: while the world stands still.
    pub fn take_keys(&mut self) -> Actions {
        let (pressed, lets_go) = self.take_pressed();
        let held = |action| {
            !lets_go.contains(&action) && (self.is_held(action) || pressed.contains(&action))
        };
        let axis = |plus, minus| f64::from(i8::from(held(plus)) - i8::from(held(minus)));
        let actions = Actions {
            forward: axis(Action::Forward, Action::Backward),
            strafe: axis(Action::Right, Action::Left),
            sprint: held(Action::Sprint),
            jump: held(Action::Jump),
            sink: held(Action::Sink),
            primary: held(Action::Use),
            secondary: held(Action::SecondUse),
            drop_one: pressed.contains(&Action::Drop),
            toggle_camera: pressed.contains(&Action::Camera),
            turn_map: pressed.contains(&Action::OtherMap),
            ..self.events
        };
        self.used = USES.into_iter().filter(|action| held(*action)).collect();
        self.events = Actions::default();
        actions
    }

    /// What the next step takes of what went down, and which uses of what is in hand it takes for let go: a button that was down
    /// in the last step has to come up before it goes down again, and of both uses that went down the later waits.
    fn take_pressed(&mut self) -> (Vec<Action>, Vec<Action>) {
        let (mut now, mut lets_go) = (Vec::new(), Vec::new());
        for action in std::mem::take(&mut self.pressed) {
            let is_use = USES.contains(&action);
            let comes_up = is_use && self.used.contains(&action);
            let waits = is_use && now.iter().any(|it| USES.contains(it));
            if comes_up || waits || now.contains(&action) {
                self.pressed.push(action);
                // Of one that has just gone down, only the presses after it wait.
                if is_use && !now.contains(&action) {
                    lets_go.push(action);
                }
            } else {
                now.push(action);
            }
        }
        (now, lets_go)
    }

    /// Lets go of everything, as when the menu opens or the window loses focus. What a picture has shown of a turn is
    /// not taken back.
    pub fn release_all(&mut self) {
        self.held.clear();
        self.pressed.clear();
        self.used.clear();
        self.events = Actions::default();
        self.turned = self.shown;
        self.notches = 0.0;
    }

    fn is_held(&self, action: Action) -> bool {
        let mut inputs = self.profile.inputs(action).iter();
        inputs.any(|input| self.held.contains(input))
    }

    /// Whether these actions of one input turn the dial now.
    fn turns_dial(&self, actions: &[Action]) -> bool {
        let dial = |action: &Action| matches!(action, Action::DialUp | Action::DialDown);
        self.has_dial && !self.is_held(Action::WheelSlots) && actions.iter().any(dial)
    }

    /// Does once what an action does once.
    fn act(&mut self, action: Action) -> Option<Action> {
        let known = self.pressed.iter().filter(|it| **it == action).count();
        let most = if COUNTED.contains(&action) {
            MOST_PRESSES
        } else {
            1
        };
        if known < most {
            self.pressed.push(action);
        }
        match action {
            Action::Slot(slot) => self.events.slot = Some(slot),
            Action::PreviousSlot => self.events.slot_step -= 1,
            Action::NextSlot => self.events.slot_step += 1,
            Action::BrushLarger => self.events.brush_step += 1,
            Action::BrushSmaller => self.events.brush_step -= 1,
            Action::Flashlight => self.events.toggle_light = !self.events.toggle_light,
            Action::EnterCar => self.events.enter_car = true,
            Action::LeaveCar => self.events.leave_car = true,
            Action::FlipCar => self.events.flip_car = true,
            Action::Horn => self.events.horn = true,
            Action::Talk => self.events.talk = true,
            Action::Menu
            | Action::HideDisplay
            | Action::HitShapes
            | Action::FrameFigures
            | Action::Fullscreen
            | Action::Screenshot
            | Action::PhotoMode
            | Action::SkipHint
            | Action::Backpack
            | Action::Console => return Some(action),
            _ => {}
        }
        None
    }
}

fn is_slot_step(action: Action) -> bool {
    matches!(action, Action::PreviousSlot | Action::NextSlot)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_settings::MouseButton;

    use super::*;

    const LEFT: Input = Input::Mouse(MouseButton::Left);
    const RIGHT: Input = Input::Mouse(MouseButton::Right);

    fn key(controls: &mut Controls, name: &str, pressed: bool) -> Option<Action> {
        controls.input(Input::key(name).unwrap(), pressed)
    }

    #[test]
    fn a_held_key_acts_until_it_is_let_go() {
        let mut c = Controls::default();
        key(&mut c, "KeyW", true);
        assert_eq!(c.take().forward, 1.0);
        assert_eq!(c.take().forward, 1.0);
        key(&mut c, "KeyS", true);
        assert_eq!(c.take().forward, 0.0);
        key(&mut c, "KeyW", false);
        assert_eq!(c.take().forward, -1.0);
    }

    /// How often something is so in the steps that follow, where it was not so in the one before.
    fn times(c: &mut Controls, is_so: impl Fn(&Actions) -> bool) -> usize {
        let seen: Vec<_> = (0..20).map(|_| is_so(&c.take())).collect();
        let first = usize::from(seen[0]);
        first + seen.windows(2).filter(|it| it[1] && !it[0]).count()
    }

    #[test]
    fn every_press_within_a_slow_frame_counts() {
        let mut c = Controls::default();
        for name in ["KeyH", "Tab", "KeyQ"] {
            for _ in 0..3 {
                key(&mut c, name, true);
                key(&mut c, name, false);
            }
        }
        let steps: Vec<_> = (0..20).map(|_| c.take()).collect();
        let count = |is_so: fn(&Actions) -> bool| steps.iter().filter(|it| is_so(it)).count();
        assert_eq!(count(|it| it.turn_map), 3);
        assert_eq!(count(|it| it.toggle_camera), 3);
        assert_eq!(count(|it| it.drop_one), 3);
        for (button, is_so) in [
            (LEFT, (|it| it.primary) as fn(&Actions) -> bool),
            (RIGHT, |it| it.secondary),
        ] {
            for _ in 0..3 {
                c.input(button, true);
                c.input(button, false);
            }
            assert_eq!(times(&mut c, is_so), 3, "{button:?}");
            // One that is down is let go and pressed again within a step.
            c.input(button, true);
            assert!(is_so(&c.take()));
            c.input(button, false);
            c.input(button, true);
            assert!(!is_so(&c.take()), "it comes up");
            assert!(is_so(&c.take()) && is_so(&c.take()), "and stays down");
            c.input(button, false);
            assert!(!is_so(&c.take()));
        }
    }

    #[test]
    fn an_event_happens_once_however_many_steps_a_frame_has() {
        let mut c = Controls::default();
        key(&mut c, "Tab", true);
        key(&mut c, "KeyH", true);
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
        key(&mut c, "AltLeft", true);
        c.wheel(-1.0, true);
        let actions = c.take();
        assert_eq!((actions.dial, actions.slot_step), (0.0, 1));
    }

    #[test]
    fn a_press_shorter_than_a_step_still_acts_in_one() {
        let mut c = Controls::default();
        c.input(LEFT, true);
        c.input(LEFT, false);
        assert!(c.take().primary);
        assert!(!c.take().primary);
        key(&mut c, "Space", true);
        key(&mut c, "Space", false);
        c.release_all();
        assert!(!c.take().jump);
    }

    #[test]
    fn both_buttons_pressed_in_one_slow_frame_act_one_after_the_other() {
        for (first, second) in [(LEFT, RIGHT), (RIGHT, LEFT)] {
            let mut c = Controls::default();
            for button in [first, second] {
                c.input(button, true);
                c.input(button, false);
            }
            let steps = [c.take(), c.take(), c.take()].map(|it| (it.primary, it.secondary));
            let left_first = [(true, false), (false, true), (false, false)];
            let right_first = [(false, true), (true, false), (false, false)];
            assert_eq!(
                steps,
                if first == LEFT {
                    left_first
                } else {
                    right_first
                }
            );
        }
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
        key(&mut c, "KeyW", true);
        c.input(LEFT, true);
        c.motion(500.0, 0.0);
        c.release_all();
        assert_eq!(c.take(), Actions::default());
    }

    #[test]
    fn the_menu_key_is_handed_to_the_shell_on_the_way_down_only() {
        let mut c = Controls::default();
        assert_eq!(key(&mut c, "Escape", true), Some(Action::Menu));
        assert_eq!(key(&mut c, "Escape", false), None);
        assert_eq!(key(&mut c, "F4", true), Some(Action::FrameFigures));
    }

    #[test]
    fn the_mouse_goes_by_the_settings() {
        let turned = |settings: &dyn Fn(&mut Settings)| {
            let mut config = Config::default();
            settings(&mut config.settings);
            let mut c = Controls::default();
            c.set_config(&config);
            c.motion(100.0, 100.0);
            let actions = c.take();
            (
                actions.look_yaw.to_degrees(),
                actions.look_pitch.to_degrees(),
            )
        };
        let near =
            |(a, b): (f64, f64), (x, y): (f64, f64)| (a - x).abs() < 1e-9 && (b - y).abs() < 1e-9;
        assert!(near(turned(&|_| {}), (12.0, -12.0)));
        assert!(near(
            turned(&|own| own.mouse_sensitivity_deg_per_px = 0.5),
            (50.0, -50.0)
        ));
        assert!(near(turned(&|own| own.invert_look = true), (12.0, 12.0)));
    }

    #[test]
    fn the_dial_goes_by_its_step() {
        let mut config = Config::default();
        config.settings.curvature_step = 0.25;
        let mut c = Controls::default();
        c.set_config(&config);
        c.wheel(-2.0, true);
        assert_eq!(c.take().dial, -0.5);
    }

    #[test]
    fn bindings_change_at_once_and_two_keys_of_an_action_do_not_disturb_each_other() {
        let mut config = Config::default();
        let own = config.profiles.chosen_mut();
        own.bind(Action::Forward, Input::key("KeyI").unwrap())
            .unwrap();
        own.bind(Action::Jump, Input::WheelUp).unwrap();
        own.rebind(Action::DialUp, Input::WheelUp, Input::key("KeyR").unwrap())
            .unwrap();
        let mut c = Controls::default();
        key(&mut c, "KeyW", true);
        c.set_config(&config);
        assert_eq!(c.take().forward, 0.0, "what was held is let go");
        key(&mut c, "KeyW", true);
        key(&mut c, "KeyI", true);
        key(&mut c, "KeyW", false);
        assert_eq!(c.take().forward, 1.0, "the other key is still held");
        c.wheel(1.0, true);
        let first = c.take();
        assert!(
            first.jump && first.slot_step == -1 && first.dial == 0.0,
            "{first:?}"
        );
        assert!(!c.take().jump, "a notch is no hold");
        key(&mut c, "KeyR", true);
        assert_eq!(c.take().dial, 1.0);
    }
}
