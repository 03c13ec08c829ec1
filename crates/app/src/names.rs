//! Names of keys: as scripts write them (`KeyW`, `ShiftLeft`) and as players read them (`W`, `Left Shift`).

use winit::keyboard::KeyCode;

/// The keys a script can press.
const KEYS: [KeyCode; 82] = [
    KeyCode::KeyA,
    KeyCode::KeyB,
    KeyCode::KeyC,
    KeyCode::KeyD,
    KeyCode::KeyE,
    KeyCode::KeyF,
    KeyCode::KeyG,
    KeyCode::KeyH,
    KeyCode::KeyI,
    KeyCode::KeyJ,
    KeyCode::KeyK,
    KeyCode::KeyL,
    KeyCode::KeyM,
    KeyCode::KeyN,
    KeyCode::KeyO,
    KeyCode::KeyP,
    KeyCode::KeyQ,
    KeyCode::KeyR,
    KeyCode::KeyS,
    KeyCode::KeyT,
    KeyCode::KeyU,
    KeyCode::KeyV,
    KeyCode::KeyW,
    KeyCode::KeyX,
    KeyCode::KeyY,
    KeyCode::KeyZ,
    KeyCode::Digit0,
    KeyCode::Digit1,
    KeyCode::Digit2,
    KeyCode::Digit3,
    KeyCode::Digit4,
    KeyCode::Digit5,
    KeyCode::Digit6,
    KeyCode::Digit7,
    KeyCode::Digit8,
    KeyCode::Digit9,
    KeyCode::F1,
    KeyCode::F2,
    KeyCode::F3,
    KeyCode::F4,
    KeyCode::F5,
    KeyCode::F6,
    KeyCode::F7,
    KeyCode::F8,
    KeyCode::F9,
    KeyCode::F10,
    KeyCode::F11,
    KeyCode::F12,
    KeyCode::ArrowUp,
    KeyCode::ArrowDown,
    KeyCode::ArrowLeft,
    KeyCode::ArrowRight,
    KeyCode::ShiftLeft,
    KeyCode::ShiftRight,
    KeyCode::ControlLeft,
    KeyCode::ControlRight,
    KeyCode::AltLeft,
    KeyCode::AltRight,
    KeyCode::SuperLeft,
    KeyCode::SuperRight,
    KeyCode::Space,
    KeyCode::Tab,
    KeyCode::Enter,
    KeyCode::Escape,
    KeyCode::Backspace,
    KeyCode::Delete,
    KeyCode::Insert,
    KeyCode::Home,
    KeyCode::End,
    KeyCode::PageUp,
    KeyCode::PageDown,
    KeyCode::Backquote,
    KeyCode::Minus,
    KeyCode::Equal,
    KeyCode::BracketLeft,
    KeyCode::BracketRight,
    KeyCode::Backslash,
    KeyCode::Semicolon,
    KeyCode::Quote,
    KeyCode::Comma,
    KeyCode::Period,
    KeyCode::Slash,
];

/// The key a script means by `name`; exact, as the window library spells it.
pub fn key_named(name: &str) -> Option<KeyCode> {
    KEYS.into_iter().find(|code| format!("{code:?}") == name)
}

/// A key's name for the player.
pub fn key_label(code: KeyCode) -> String {
    let name = format!("{code:?}");
    for (side, word) in [("Left", "Left "), ("Right", "Right ")] {
        if let Some(stem) = name.strip_suffix(side)
            && ["Shift", "Control", "Alt", "Super"].contains(&stem)
        {
            return format!("{word}{stem}");
        }
    }
    for prefix in ["Key", "Digit"] {
        if let Some(rest) = name.strip_prefix(prefix) {
            return rest.to_owned();
        }
    }
    name.strip_prefix("Arrow")
        .map_or(name.clone(), |way| format!("Arrow {}", way.to_lowercase()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn script_names_are_the_window_librarys_own() {
        assert_eq!(key_named("KeyW"), Some(KeyCode::KeyW));
        assert_eq!(key_named("Digit3"), Some(KeyCode::Digit3));
        assert_eq!(key_named("keyw"), None);
        assert_eq!(key_named(""), None);
    }

    #[test]
    fn labels_are_words_a_player_reads_on_the_keyboard() {
        assert_eq!(key_label(KeyCode::KeyW), "W");
        assert_eq!(key_label(KeyCode::ShiftLeft), "Left Shift");
        assert_eq!(key_label(KeyCode::ArrowUp), "Arrow up");
        assert_eq!(key_label(KeyCode::Digit0), "0");
    }
}
