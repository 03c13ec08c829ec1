//! Names of keys as scripts write them: `KeyW`, `ShiftLeft`.

use antipode_settings::Input;

/// The key a script means by `name`; exact, as the window library spells it.
pub fn key_named(name: &str) -> Option<Input> {
    Input::key(name)
}

/// The names of all keys, as scripts write them.
pub fn key_names() -> Vec<String> {
    Input::KEYS.iter().map(|name| (*name).to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn script_names_are_the_window_librarys_own() {
        assert_eq!(key_named("KeyW"), Some(Input::Key("KeyW")));
        assert_eq!(key_named("Digit3"), Some(Input::Key("Digit3")));
        assert_eq!(key_named("keyw"), None);
        assert_eq!(key_named(""), None);
    }
}
