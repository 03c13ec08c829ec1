//! Checks the names of worlds.

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
///
/// # Errors
/// Why it cannot be one.
pub fn check(name: &str) -> Result<(), NameError> {
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

/// What a name from outside leaves of itself without what no name may have, at most as long as one may be; `other` where
/// that is nothing.
pub(crate) fn usable(name: &str, other: &str) -> String {
    let shown: String = name.chars().filter(|&c| !is_unprintable(c)).collect();
    let kept: String = shown.trim().chars().take(MAX_NAME_CHARS).collect();
    let kept = kept.trim_end();
    if check(kept).is_ok() { kept } else { other }.to_owned()
}

/// A name like `wanted` that none of `taken` is: that itself, or with a number in the place of the one it may have.
/// What no name may have is left out of it, and `other` takes the place of a name of which nothing is left.
pub fn free_name(wanted: &str, other: &str, taken: &[&str]) -> String {
    let wanted = usable(wanted, other);
    let stem = without_number(&wanted);
    let taken: Vec<String> = taken.iter().map(|it| folded(it)).collect();
    let mut number = 1;
    let mut candidate = wanted.clone();
    while taken.contains(&folded(&candidate)) {
        number += 1;
        candidate = numbered_name(stem, number);
    }
    candidate
}

/// The name without the number at its end, if it has one.
fn without_number(name: &str) -> &str {
    match name.rsplit_once(' ') {
        Some((stem, number))
            if !stem.trim().is_empty()
                && !number.is_empty()
                && number.bytes().all(|digit| digit.is_ascii_digit()) =>
        {
            stem.trim_end()
        }
        _ => name,
    }
}

/// The name with a number, shortened so that both fit.
fn numbered_name(stem: &str, number: u32) -> String {
    let suffix = format!(" {number}");
    let room = MAX_NAME_CHARS.saturating_sub(suffix.len());
    let stem: String = stem.chars().take(room).collect();
    format!("{}{suffix}", stem.trim_end())
}

/// What two names have in common if they may not both be used.
pub fn folded(name: &str) -> String {
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
            assert_eq!(usable(name, "World"), left, "{name:?}");
            assert_eq!(check(&usable(name, "World")), Ok(()));
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

    #[test]
    fn a_number_takes_the_place_of_a_number() {
        for (name, stem) in [
            ("Foo", "Foo"),
            ("Foo 2", "Foo"),
            ("World 12", "World"),
            ("7", "7"),
            (" 7", " 7"),
            ("Foo 2b", "Foo 2b"),
            ("Foo ", "Foo "),
            ("Foo ٢", "Foo ٢"),
        ] {
            assert_eq!(without_number(name), stem, "{name}");
        }
        assert_eq!(numbered_name("Foo", 2), "Foo 2");
        let long = numbered_name(&"é".repeat(40), 17);
        assert_eq!(long.chars().count(), 40);
        assert!(long.ends_with("é 17"), "{long}");
    }
}
