//! Gamepads in the window: in the world they do what keys do, in menus they move the focus and press.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use antipode_settings::{Input, PadButton};
use antipode_ui::ToastKind;
use egui::{Event, Key, Modifiers};

use super::game::Game;
use super::menus::Menus;
use super::press::{Press, Taken};
use crate::pad::{Direction, PadEvent, PadSource, Sticks};

/// Time a direction is held in a menu until it goes on by itself, and from then on between two lines.
const REPEAT: (Duration, Duration) = (Duration::from_millis(400), Duration::from_millis(110));

/// The gamepads, all of which act as one.
pub(super) struct Pads {
    source: Box<dyn PadSource>,
    sticks: Sticks,
    held: BTreeSet<PadButton>,
    /// The direction held in a menu, and when it goes on by itself.
    walking: Option<(Direction, Instant)>,
}

impl Pads {
    /// Gamepads of a source.
    pub fn new(source: Box<dyn PadSource>) -> Self {
        Self {
            source,
            sticks: Sticks::default(),
            held: BTreeSet::new(),
            walking: None,
        }
    }

    /// Takes in what happened. Returns the keys that the menus are to be given.
    pub fn poll(&mut self, game: &mut Game, now: Instant) -> Vec<Event> {
        let mut keys = Vec::new();
        while let Some(event) = self.source.next() {
            match event {
                PadEvent::Connected { name } => tell(&mut game.menus, "pad-connected", &name),
                PadEvent::Disconnected { name } => {
                    self.let_go(game);
                    tell(&mut game.menus, "pad-disconnected", &name);
                }
                // Pads are told to everybody, whichever window has the keyboard.
                PadEvent::Button { pressed: true, .. } | PadEvent::Stick { .. }
                    if game.devices.lost_focus() => {}
                PadEvent::Button { button, pressed } => {
                    self.button(game, button, pressed, &mut keys);
                }
                PadEvent::Stick { axis, value } => self.sticks.set(axis, value),
            }
        }
        if game.devices.lost_focus() {
            self.let_go(game);
        }
        game.devices.sticks = self.sticks;
        self.walk(game, now, &mut keys);
        keys
    }

    fn button(&mut self, game: &mut Game, button: PadButton, pressed: bool, keys: &mut Vec<Event>) {
        if pressed {
            self.held.insert(button);
        } else {
            self.held.remove(&button);
        }
        let taken = game.press(&Press::of(Input::Pad(button), pressed));
        if taken == Taken::Not && pressed {
            in_interface(game, button, keys);
        }
    }

    /// Moves through a menu: at once, and again and again while it is held.
    fn walk(&mut self, game: &Game, now: Instant, keys: &mut Vec<Event>) {
        let held = self.direction().filter(|_| !game.is_playing());
        let (first, again) = REPEAT;
        let wait = match (held, self.walking) {
            (None, _) => {
                self.walking = None;
                return;
            }
            (Some(held), Some((last, at))) if held == last => {
                if now < at {
                    return;
                }
                again
            }
            (Some(_), _) => first,
        };
        if let Some(held) = held {
            self.walking = Some((held, now + wait));
            tap(key(held), Modifiers::NONE, keys);
        }
    }

    fn direction(&self) -> Option<Direction> {
        let cross = [
            (PadButton::Up, Direction::Up),
            (PadButton::Down, Direction::Down),
            (PadButton::Left, Direction::Left),
            (PadButton::Right, Direction::Right),
        ];
        let pressed = cross
            .into_iter()
            .find(|(button, _)| self.held.contains(button));
        pressed
            .map(|(_, direction)| direction)
            .or_else(|| self.sticks.direction())
    }

    /// A pad that has gone holds nothing any more.
    fn let_go(&mut self, game: &mut Game) {
        self.sticks = Sticks::default();
        for button in std::mem::take(&mut self.held) {
            game.devices.controls.input(Input::Pad(button), false);
        }
    }
}

fn tell(menus: &mut Menus, key: &str, name: &str) {
    menus.toast(ToastKind::Info, key, &[("name", name.into())]);
}

fn key(direction: Direction) -> Key {
    match direction {
        Direction::Up => Key::ArrowUp,
        Direction::Down => Key::ArrowDown,
        Direction::Left => Key::ArrowLeft,
        Direction::Right => Key::ArrowRight,
    }
}

/// What no layer of the game takes walks through the interface: the buttons under the right thumb press, and in the
/// backpack take half and send on, too, or lead back.
fn in_interface(game: &mut Game, button: PadButton, keys: &mut Vec<Event>) {
    let packing = game.overlays.is_packing();
    match button {
        PadButton::South => tap(Key::Enter, Modifiers::NONE, keys),
        PadButton::West if packing => tap(Key::Enter, Modifiers::CTRL, keys),
        PadButton::North if packing => tap(Key::Enter, Modifiers::SHIFT, keys),
        PadButton::East | PadButton::Start => game.escape(),
        PadButton::LeftBumper => tap(Key::Tab, Modifiers::SHIFT, keys),
        PadButton::RightBumper => tap(Key::Tab, Modifiers::NONE, keys),
        _ => {
            let backpack = &mut game.overlays.backpack;
            backpack.input(Input::Pad(button), &mut game.devices, &mut game.play);
        }
    }
}

/// Down and up again.
fn tap(key: Key, modifiers: Modifiers, keys: &mut Vec<Event>) {
    for pressed in [true, false] {
        keys.push(Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers,
        });
    }
}

#[cfg(test)]
mod tests;
