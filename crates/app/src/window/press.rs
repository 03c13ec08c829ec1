//! Presses of keys, buttons and the wheel, and what a layer makes of them.

use std::collections::HashSet;

use winit::keyboard::KeyCode;

use crate::bindings::Input;

/// The key that leads back, whatever is bound to it.
pub(super) const ESCAPE: Input = Input::Key("Escape");

/// Whether it is a key of the keyboard.
pub(super) fn is_key(input: Input) -> bool {
    matches!(input, Input::Key(_))
}

/// Something that a hand does: a key, a button or a notch of the wheel goes down or comes up.
#[derive(Clone, Copy, Debug)]
pub struct Press {
    /// What; none for a key that bindings do not know.
    pub input: Option<Input>,
    pub down: bool,
    /// It is held, and the system tells it again.
    pub repeats: bool,
    /// The system tells it because the keyboard came or went, and no hand did it.
    pub synthetic: bool,
    /// A field of the interface takes text.
    pub into_text: bool,
}

impl Press {
    /// A press by hand.
    pub fn of(input: impl Into<Option<Input>>, down: bool) -> Self {
        Self {
            input: input.into(),
            down,
            repeats: false,
            synthetic: false,
            into_text: false,
        }
    }

    /// What it is, where it goes down just now.
    pub fn fresh(&self) -> Option<Input> {
        self.input
            .filter(|_| self.down && !self.repeats && !self.synthetic)
    }

    /// As [`Press::fresh`], where it is a key.
    pub fn fresh_key(&self) -> Option<Input> {
        self.fresh().filter(|input| is_key(*input))
    }

    /// What it is, where somebody did it.
    pub fn by_hand(&self) -> Option<Input> {
        self.input.filter(|_| !(self.synthetic && self.down))
    }
}

/// What a layer makes of a press.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taken {
    /// It is nobody else's.
    Wholly,
    /// The interface hears of it, too: of a key that comes up, since one that went down in a menu would stay down there.
    AndHeard,
    /// It is for those below, and for the interface if it is nobody's.
    Not,
}

impl Taken {
    /// Wholly, or not.
    pub fn if_true(taken: bool) -> Self {
        if taken { Self::Wholly } else { Self::Not }
    }

    /// Whether the interface hears of it.
    pub fn is_heard(self) -> bool {
        self != Self::Wholly
    }
}

/// Keys that are down, as far as this window has been told.
#[derive(Debug, Default)]
pub struct Down {
    keys: HashSet<KeyCode>,
}

impl Down {
    /// A key is told to be down or up, and that it repeats itself or not. Whether it does: by the system's word, or
    /// because it is down already. A key that is held while a window gets the keyboard is told twice.
    pub fn repeats(&mut self, key: KeyCode, pressed: bool, told: bool) -> bool {
        if !pressed {
            self.keys.remove(&key);
            return false;
        }
        !self.keys.insert(key) || told
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_that_is_told_twice_without_coming_up_is_pressed_once() {
        let mut down = Down::default();
        assert!(!down.repeats(KeyCode::Escape, true, false));
        assert!(down.repeats(KeyCode::Escape, true, false));
        assert!(!down.repeats(KeyCode::KeyP, true, false));
        assert!(!down.repeats(KeyCode::Escape, false, false));
        assert!(!down.repeats(KeyCode::Escape, true, false));
        assert!(!down.repeats(KeyCode::Escape, false, false));
        assert!(down.repeats(KeyCode::Escape, true, true), "held before");
    }
}
