//! What a world may be called.

use serde::{Deserialize, Serialize};

/// The longest name, in Unicode scalar values.
pub const MAX_NAME_CHARS: usize = 40;

/// Why a name cannot be used, in words for the New Game form.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
pub enum NameError {
    /// Nothing was typed.
    #[error("Give the world a name.")]
    Empty,
    /// Only blanks were typed.
    #[error("The name needs at least one character that can be seen.")]
    Blank,
    /// Too many characters.
    #[error("The name has {chars} characters; at most {MAX_NAME_CHARS} fit.")]
    TooLong {
        /// How many there are.
        chars: usize,
    },
    /// A character that cannot be printed.
    #[error("The name contains a character that cannot be shown ({}).", .0.escape_unicode())]
    Unprintable(
        /// The first such character.
        char,
    ),
    /// There is a world of that name, differing at most in case.
    #[error("A world called \"{existing}\" exists already.")]
    Taken {
        /// The name of that world, as it is written.
        existing: String,
    },
}

/// Checks a name by itself; whether it is taken is for the directory to say.
pub(crate) fn check(name: &str) -> Result<(), NameError> {
    if name.is_empty() {
        return Err(NameError::Empty);
    }
    let chars = name.trim().chars().count();
    if chars > MAX_NAME_CHARS {
        return Err(NameError::TooLong { chars });
    }
    if let Some(bad) = name.chars().find(|&c| is_unprintable(c)) {
        return Err(NameError::Unprintable(bad));
    }
    if name.chars().all(|c| c.is_whitespace() || is_joiner(c)) {
        return Err(NameError::Blank);
    }
    Ok(())
}

/// What a name from outside leaves of itself without what no name may have, at most as long as one may be; a word for
/// a world where that is nothing.
pub(crate) fn usable(name: &str) -> String {
    let shown: String = name.chars().filter(|&c| !is_unprintable(c)).collect();
    let kept: String = shown.trim().chars().take(MAX_NAME_CHARS).collect();
    let kept = kept.trim_end();
    if check(kept).is_ok() { kept } else { "World" }.to_owned()
}

/// What two names have in common if they may not both be used.
pub(crate) fn folded(name: &str) -> String {
    // By way of upper case, so that `ß` meets `SS` and both sigmas meet.
    name.trim().to_uppercase().to_lowercase()
}

/// Controls, line ends, and the invisible characters that turn the order of text
/// round or make two names look the same. Text from outside that holds one is not to be
/// printed as it is.
pub fn is_unprintable(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
            | '\u{fff0}'..='\u{fffb}' | '\u{e000}'..='\u{f8ff}' | '\u{e0000}'..='\u{10ffff}')
        || (c as u32) & 0xfffe == 0xfffe
}

/// The two invisible characters that scripts and emoji need between visible ones.
fn is_joiner(c: char) -> bool {
    matches!(c, '\u{200c}' | '\u{200d}')
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;

    #[test]
    fn printable_names_are_good() {
        for name in [
            "a",
            "My world",
            "Мир №1",
            "世界",
            "CON",
            "../..",
            "a/b",
            "👩‍🚀",
            &"é".repeat(40),
        ] {
            assert_eq!(check(name), Ok(()), "{name}");
        }
    }

    #[test]
    fn a_name_from_outside_leaves_one_that_may_be_used() {
        for (name, left) in [
            (" My world ", "My world"),
            ("a\u{202e}b\n", "ab"),
            ("Vic\u{14}im", "Vicim"),
            ("\0\u{200b}", "World"),
            ("", "World"),
            (&"é".repeat(41), &"é".repeat(40)),
        ] {
            assert_eq!(usable(name), left, "{name:?}");
            assert_eq!(check(&usable(name)), Ok(()));
        }
    }

    #[test]
    fn others_are_refused_with_a_reason() {
        assert_eq!(check(""), Err(NameError::Empty));
        assert_eq!(check("   \u{3000}"), Err(NameError::Blank));
        assert_eq!(check("\u{200d}"), Err(NameError::Blank));
        assert_eq!(
            check(&"é".repeat(41)),
            Err(NameError::TooLong { chars: 41 })
        );
        for bad in [
            '\n',
            '\0',
            '\u{7f}',
            '\u{202e}',
            '\u{200b}',
            '\u{2028}',
            '\u{e001}',
            '\u{1ffff}',
        ] {
            assert_eq!(check(&format!("a{bad}b")), Err(NameError::Unprintable(bad)));
        }
        assert!(
            check(&"x".repeat(41))
                .unwrap_err()
                .to_string()
                .contains("at most 40")
        );
    }

    #[test]
    fn case_and_blanks_around_do_not_make_a_new_name() {
        assert_eq!(folded(" Straße "), folded("STRASSE"));
        assert_eq!(folded("ΟΔΟΣ"), folded("οδος"));
        assert_ne!(folded("a b"), folded("ab"));
    }
}
