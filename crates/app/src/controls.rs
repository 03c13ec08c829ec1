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
        if self.turns_brush(notches) {
            return None;
        }
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

    /// Goes through the shapes of the brush, or the kinds of ground, while their key is held; says whether it is.
    fn turns_brush(&mut self, notches: f64) -> bool {
        let (shape, kind) = (
            self.is_held(Action::BrushShape),
            self.is_held(Action::GroundKind),
        );
        if !shape && !kind {
            return false;
        }
        self.notches += notches;
        let whole = self.notches.trunc();
        self.notches -= whole;
        // Towards the player is the next, as along the hotbar.
        let steps = if shape {
            &mut self.events.shape_step
        } else {
            &mut self.events.kind_step
        };
        *steps = steps.saturating_sub(whole as i32);
        true
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
            Action::BrushShape => self.events.shape_step += 1,
            Action::GroundKind => self.events.kind_step += 1,
            Action::TakeKind => self.events.take_kind = true,
            Action::UndoStroke => self.events.undo = true,
            Action::Flashlight => self.events.toggle_light = !self.events.toggle_light,
            Action::EnterCar => self.events.enter_car = true,
            Action::LeaveCar => self.events.leave_car = true,
            Action::FlipCar => self.events.flip_car = true,
            Action::Horn => self.events.horn = true,
            Action::Talk => self.events.talk = true,
            Action::Backpack => {
                self.events.grasp = true;
                return Some(action);
            }
            Action::Menu
            | Action::HideDisplay
            | Action::HitShapes
            | Action::FrameFigures
            | Action::LargeMap
            | Action::Fullscreen
            | Action::Screenshot
            | Action::PhotoMode
            | Action::SkipHint
            | Action::Workshop
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
mod tests;
