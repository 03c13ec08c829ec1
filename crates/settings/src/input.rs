//! What can be pressed or turned, by the names that stand in the file: keys as the window library calls them
//! (`KeyW`, `ShiftLeft`; they are places on the keyboard, not letters), `Mouse1` to `Mouse5`, `WheelUp` and
//! `WheelDown`, and the buttons of a gamepad (`pad-south`).

use std::fmt;

use crate::choice::words;
use crate::pad::PadButton;

words! {
    /// A button of the mouse, by its name in the file.
    MouseButton {
        /// The left one.
        Left = "Mouse1",
        /// The right one.
        Right = "Mouse2",
        /// The middle one, or the wheel pressed down.
        Middle = "Mouse3",
        /// The first at the side.
        Back = "Mouse4",
        /// The second at the side.
        Forward = "Mouse5",
    }
}

/// A key, a button or a way to turn the wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// A key by its name, one of [`Input::KEYS`].
    Key(&'static str),
    /// A button of the mouse.
    Mouse(MouseButton),
    /// A notch of the wheel, away from the player.
    WheelUp,
    /// A notch of the wheel, towards the player.
    WheelDown,
    /// A button of a gamepad.
    Pad(PadButton),
}

impl Input {
    /// The names of all keys.
    pub const KEYS: &'static [&'static str] = &KEYS;

    /// The key of that name, exactly as the window library spells it.
    pub fn key(name: &str) -> Option<Self> {
        KEYS.iter()
            .find(|key| **key == name)
            .map(|key| Self::Key(key))
    }

    /// The input of that name.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "WheelUp" => Some(Self::WheelUp),
            "WheelDown" => Some(Self::WheelDown),
            _ => MouseButton::from_id(name)
                .map(Self::Mouse)
                .or_else(|| PadButton::from_id(name).map(Self::Pad))
                .or_else(|| Self::key(name)),
        }
    }

    /// Its name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Key(name) => name,
            Self::Mouse(button) => button.id(),
            Self::WheelUp => "WheelUp",
            Self::WheelDown => "WheelDown",
            Self::Pad(button) => button.id(),
        }
    }

    /// The letter, digit or number printed on it, where that is its name in every language (`W`, `3`, `F11`).
    pub fn printed(self) -> Option<&'static str> {
        let Self::Key(name) = self else { return None };
        let rest = name
            .strip_prefix("Key")
            .or_else(|| name.strip_prefix("Digit"));
        let is_function = name
            .strip_prefix('F')
            .is_some_and(|number| number.parse::<u8>().is_ok());
        rest.or_else(|| is_function.then_some(name)).or(match name {
            "Minus" => Some("-"),
            "Equal" => Some("="),
            "BracketLeft" => Some("["),
            "BracketRight" => Some("]"),
            "Backslash" => Some("\\"),
            "Semicolon" => Some(";"),
            "Quote" => Some("'"),
            "Comma" => Some(","),
            "Period" => Some("."),
            "Slash" => Some("/"),
            "Backquote" => Some("`"),
            _ => None,
        })
    }
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The keys of keyboards that are sold, named as in the W3C's UI Events `code` values but for `Super`, which winit
/// calls what they call `Meta`. Keys that switch the machine off, or that the system keeps, are left out.
static KEYS: [&str; 138] = [
    "Backquote",
    "Backslash",
    "BracketLeft",
    "BracketRight",
    "Comma",
    "Digit0",
    "Digit1",
    "Digit2",
    "Digit3",
    "Digit4",
    "Digit5",
    "Digit6",
    "Digit7",
    "Digit8",
    "Digit9",
    "Equal",
    "IntlBackslash",
    "IntlRo",
    "IntlYen",
    "KeyA",
    "KeyB",
    "KeyC",
    "KeyD",
    "KeyE",
    "KeyF",
    "KeyG",
    "KeyH",
    "KeyI",
    "KeyJ",
    "KeyK",
    "KeyL",
    "KeyM",
    "KeyN",
    "KeyO",
    "KeyP",
    "KeyQ",
    "KeyR",
    "KeyS",
    "KeyT",
    "KeyU",
    "KeyV",
    "KeyW",
    "KeyX",
    "KeyY",
    "KeyZ",
    "Minus",
    "Period",
    "Quote",
    "Semicolon",
    "Slash",
    "AltLeft",
    "AltRight",
    "Backspace",
    "CapsLock",
    "ContextMenu",
    "ControlLeft",
    "ControlRight",
    "Enter",
    "SuperLeft",
    "SuperRight",
    "ShiftLeft",
    "ShiftRight",
    "Space",
    "Tab",
    "Convert",
    "KanaMode",
    "Lang1",
    "Lang2",
    "NonConvert",
    "Delete",
    "End",
    "Help",
    "Home",
    "Insert",
    "PageDown",
    "PageUp",
    "ArrowDown",
    "ArrowLeft",
    "ArrowRight",
    "ArrowUp",
    "NumLock",
    "Numpad0",
    "Numpad1",
    "Numpad2",
    "Numpad3",
    "Numpad4",
    "Numpad5",
    "Numpad6",
    "Numpad7",
    "Numpad8",
    "Numpad9",
    "NumpadAdd",
    "NumpadComma",
    "NumpadDecimal",
    "NumpadDivide",
    "NumpadEnter",
    "NumpadEqual",
    "NumpadMultiply",
    "NumpadParenLeft",
    "NumpadParenRight",
    "NumpadSubtract",
    "Escape",
    "PrintScreen",
    "ScrollLock",
    "Pause",
    "BrowserBack",
    "BrowserForward",
    "BrowserHome",
    "BrowserRefresh",
    "BrowserSearch",
    "MediaPlayPause",
    "MediaStop",
    "MediaTrackNext",
    "MediaTrackPrevious",
    "F1",
    "F2",
    "F3",
    "F4",
    "F5",
    "F6",
    "F7",
    "F8",
    "F9",
    "F10",
    "F11",
    "F12",
    "F13",
    "F14",
    "F15",
    "F16",
    "F17",
    "F18",
    "F19",
    "F20",
    "F21",
    "F22",
    "F23",
    "F24",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back_and_are_each_their_own() {
        let buttons = MouseButton::ALL.into_iter().map(Input::Mouse);
        let wheel = [Input::WheelUp, Input::WheelDown];
        let keys = KEYS.iter().map(|name| Input::Key(name));
        let pad = PadButton::ALL.into_iter().map(Input::Pad);
        let all: Vec<_> = buttons.chain(wheel).chain(keys).chain(pad).collect();
        for (place, input) in all.iter().enumerate() {
            assert_eq!(Input::named(input.name()), Some(*input));
            assert!(
                all[place + 1..]
                    .iter()
                    .all(|other| other.name() != input.name())
            );
        }
        for wrong in ["", "w", "keyw", "Mouse0", "Mouse6", "Wheel", "KeyW "] {
            assert_eq!(Input::named(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn what_is_printed_on_a_key_is_its_name_where_something_is() {
        let printed = |name: &str| Input::named(name).and_then(Input::printed);
        assert_eq!(printed("KeyW"), Some("W"));
        assert_eq!(printed("Digit0"), Some("0"));
        assert_eq!(printed("F11"), Some("F11"));
        assert_eq!(printed("Backquote"), Some("`"));
        for named in ["Space", "ShiftLeft", "Numpad1", "Mouse1", "WheelUp"] {
            assert_eq!(printed(named), None, "{named}");
        }
    }
}
