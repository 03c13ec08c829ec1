//! The order in which the layers of the game are asked about a press, the topmost first. Each takes the press or passes it
//! on; what all pass is for the interface.

use antipode_settings::Value;
use antipode_ui::{ToastKind, first_input_label};

use super::game::Game;
use super::hints::HintContext;
use super::phase::Phase;
use super::press::{ESCAPE, Press, Taken, is_key};
use crate::bindings::{Action, Input, wheel_input};

type Layer = fn(&mut Game, &Press) -> Taken;

/// All layers, the topmost first, each with what it needs of the game.
const LAYERS: [Layer; 9] = [
    |game, press| game.menus.press_to_bind(press),
    everywhere,
    |game, press| game.overlays.console.press(press, &game.devices.controls),
    |game, press| game.overlays.naming.press(press),
    |game, press| {
        game.overlays
            .backpack
            .press(press, &mut game.devices, &mut game.play)
    },
    |game, press| {
        let photo = &mut game.overlays.photo;
        photo.press(press, &mut game.devices, &mut game.play, &mut game.menus)
    },
    Game::press_in_workshop,
    world,
    menu,
];

impl Game {
    /// Gives a press to the topmost layer that takes it.
    pub fn press(&mut self, press: &Press) -> Taken {
        let mut taken = LAYERS.iter().map(|layer| layer(self, press));
        taken
            .find(|taken| *taken != Taken::Not)
            .unwrap_or(Taken::Not)
    }

    /// Presses an input, whoever asks for it, and does what it asks of the game around the world.
    pub(super) fn press_input(&mut self, input: Input) {
        let controls = &mut self.devices.controls;
        controls.set_has_dial(self.play.phase.has_dial());
        if let Some(action) = controls.input(input, true) {
            self.act(action);
        }
    }

    /// Does what concerns the game around the world.
    pub(super) fn act(&mut self, action: Action) {
        let display = &mut self.display;
        match action {
            Action::Menu => self.pause(),
            Action::HideDisplay => display.hidden = !display.hidden,
            Action::HitShapes => match self.play.phase.visit_mut() {
                Some(visit) => visit.room.outlines = visit.room.outlines.next(),
                None => display.hit_shapes = !display.hit_shapes,
            },
            Action::PhotoMode | Action::FrameFigures | Action::LargeMap
                if self.play.phase.visit().is_some() =>
            {
                self.say_for_worlds(action);
            }
            Action::LargeMap => display.large_map = !display.large_map,
            Action::FrameFigures => display.figures = !display.figures,
            Action::Fullscreen => {
                let value = !self.options.config.settings.fullscreen;
                self.set_option("fullscreen", Value::Switch(value));
            }
            Action::Screenshot => self.shots.want_of(&self.play.phase),
            Action::Workshop => self.toggle_workshop(),
            Action::Console => {
                self.devices.release_all();
                self.overlays.console.open(self.play.opened);
            }
            Action::PhotoMode => {
                self.hints.use_action(action);
                let shutter = self.shutter();
                if let Phase::Playing(session) = &mut self.play.phase {
                    self.overlays.photo.enter(session, shutter);
                    self.devices.release_all();
                }
            }
            Action::SkipHint => self.hints.skip(HintContext::in_phase(&self.play.phase)),
            Action::Backpack if self.play.phase.session().is_some() => {
                self.hints.use_action(action);
                self.overlays.backpack.open(&mut self.devices);
            }
            _ => {}
        }
    }

    /// Says in a room of what is done in worlds only that it is.
    fn say_for_worlds(&mut self, action: Action) {
        let profiles = &self.options.config.profiles;
        let key = first_input_label(&self.menus.texts, profiles, action);
        let values = [("key", key.into())];
        self.menus
            .toast(ToastKind::State, "room-hint-for-worlds", &values);
    }

    /// Escape while the world is not played: one level back.
    pub fn escape(&mut self) {
        let (devices, play) = (&mut self.devices, &mut self.play);
        if self.overlays.escape(devices, play, &mut self.menus) {
            return;
        }
        let running = self.play.phase.is_paused();
        self.menus.shell.escape(running);
        if running && !self.menus.shell.is_open() {
            self.resume();
        }
    }

    /// Mouse motion in pixels.
    pub fn motion(&mut self, dx: f64, dy: f64) {
        if self.is_playing() {
            self.devices.motion(dx, dy);
        }
    }

    /// The wheel, in notches other than none. Whether it is nothing for the interface: in the world it may turn a dial, by
    /// as much as it is turned; elsewhere it is a press like any other.
    pub fn wheel(&mut self, notches: f64) -> bool {
        if !self.is_playing() {
            let press = Press::of(wheel_input(notches), true);
            return !self.press(&press).is_heard();
        }
        let has_dial = self.play.phase.has_dial();
        if let Some(action) = self.devices.controls.wheel(notches, has_dial) {
            self.act(action);
        }
        true
    }
}

/// The keys that mean the same in menus as in the world.
fn everywhere(game: &mut Game, press: &Press) -> Taken {
    let elsewhere = !game.is_playing() && !game.menus.shell.wants_input();
    let Some(key) = press.fresh_key().filter(|_| elsewhere) else {
        return Taken::Not;
    };
    let does = |action| game.devices.controls.does(key, action);
    let typing = press.into_text || game.overlays.is_typing();
    if does(Action::Fullscreen) && !typing {
        game.act(Action::Fullscreen);
    } else if does(Action::Screenshot) {
        game.act(Action::Screenshot);
    } else {
        return Taken::Not;
    }
    Taken::Wholly
}

fn world(game: &mut Game, press: &Press) -> Taken {
    if !game.is_playing() {
        return Taken::Not;
    }
    match press.by_hand().filter(|_| !press.repeats) {
        Some(input) if press.down => {
            game.devices.by_pad = matches!(input, Input::Pad(_));
            game.press_input(input);
        }
        Some(input) => {
            game.devices.controls.input(input, false);
        }
        None => {}
    }
    if press.down || !press.input.is_none_or(is_key) {
        Taken::Wholly
    } else {
        Taken::AndHeard
    }
}

/// Escape leads one level back; all else is the interface's.
fn menu(game: &mut Game, press: &Press) -> Taken {
    if press.input != Some(ESCAPE) || !press.down {
        return Taken::Not;
    }
    if press.fresh().is_some() {
        game.escape();
    }
    Taken::Wholly
}
