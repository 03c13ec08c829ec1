//! Translates the window library's keys and buttons into the inputs of key bindings.

use winit::event::MouseButton as WindowButton;
use winit::keyboard::KeyCode;

pub use antipode_settings::{Action, Input, MouseButton};

/// The key as an input; none for keys that bindings do not know.
pub fn key_input(code: KeyCode) -> Option<Input> {
    // The library's names of variants are the names of keys.
    Input::key(&format!("{code:?}"))
}

/// The button as an input; none beyond the fifth.
pub fn button_input(button: WindowButton) -> Option<Input> {
    let button = match button {
        WindowButton::Left => MouseButton::Left,
        WindowButton::Right => MouseButton::Right,
        WindowButton::Middle => MouseButton::Middle,
        WindowButton::Back => MouseButton::Back,
        WindowButton::Forward => MouseButton::Forward,
        WindowButton::Other(_) => return None,
    };
    Some(Input::Mouse(button))
}

/// The wheel as an input, turned away from the player or towards.
pub fn wheel_input(notches: f64) -> Input {
    if notches > 0.0 {
        Input::WheelUp
    } else {
        Input::WheelDown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_called_as_the_window_library_calls_them() {
        for (code, name) in [
            (KeyCode::KeyW, "KeyW"),
            (KeyCode::ShiftLeft, "ShiftLeft"),
            (KeyCode::SuperRight, "SuperRight"),
            (KeyCode::Numpad7, "Numpad7"),
            (KeyCode::F24, "F24"),
        ] {
            assert_eq!(key_input(code).map(Input::name), Some(name));
        }
        assert_eq!(key_input(KeyCode::Power), None);
        assert_eq!(button_input(WindowButton::Other(9)), None);
    }
}
