//! From what the player types as a seed to the number: digits are taken as they
//! are, words are hashed so that the same words make the same world everywhere.

use antipode_language::Texts;
use thiserror::Error;

/// The longest seed text, in characters.
const LONGEST: usize = 64;

/// Why a text cannot be a seed; its text is English, [`SeedError::say`] the player's.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SeedError {
    /// A number beyond 64 bits.
    #[error("Too large: the largest seed is 18446744073709551615.")]
    TooLarge,
    /// A number with a sign, a point or a comma.
    #[error("A number must be whole and not negative: digits only.")]
    NotWhole,
    /// More than 64 characters.
    #[error("Too long: at most 64 characters.")]
    TooLong,
    /// Something that cannot be seen or typed again.
    #[error("Only printable characters, please.")]
    Unprintable,
}

impl SeedError {
    /// The reason in the player's language.
    pub fn say(self, texts: &Texts) -> String {
        texts.say(match self {
            Self::TooLarge => "seed-too-large",
            Self::NotWhole => "seed-not-whole",
            Self::TooLong => "seed-too-long",
            Self::Unprintable => "seed-unprintable",
        })
    }
}

/// The seed that `text` stands for; `None` when it is blank (a random one).
///
/// # Errors
/// See [`SeedError`].
pub fn parse_seed(text: &str) -> Result<Option<u64>, SeedError> {
    let text = text.trim();
    if text.is_empty() {
        return Ok(None);
    }
    if text.chars().count() > LONGEST {
        return Err(SeedError::TooLong);
    }
    if text.chars().any(char::is_control) {
        return Err(SeedError::Unprintable);
    }
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return text.parse().map(Some).map_err(|_| SeedError::TooLarge);
    }
    let numeric = |c: char| c.is_ascii_digit() || "+-.,".contains(c);
    if text.chars().all(numeric) && text.chars().any(|c| c.is_ascii_digit()) {
        return Err(SeedError::NotWhole);
    }
    Ok(Some(fnv_1a(text.as_bytes())))
}

/// FNV-1a, 64 bits (Fowler, Noll, Vo): fixed by its definition, so a seed in
/// words never changes its world between versions, unlike the standard hasher.
fn fnv_1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_taken_as_they_are() {
        assert_eq!(parse_seed("  42 "), Ok(Some(42)));
        assert_eq!(parse_seed("18446744073709551615"), Ok(Some(u64::MAX)));
        assert_eq!(parse_seed(" \t"), Ok(None));
    }

    #[test]
    fn words_hash_as_published() {
        // Test vector of the authors' reference code.
        assert_eq!(parse_seed("foobar"), Ok(Some(0x8594_4171_f739_67e8)));
    }

    #[test]
    fn what_is_neither_is_said() {
        assert_eq!(parse_seed("18446744073709551616"), Err(SeedError::TooLarge));
        assert_eq!(parse_seed("-3"), Err(SeedError::NotWhole));
        assert_eq!(parse_seed("1.5"), Err(SeedError::NotWhole));
        assert_eq!(parse_seed(&"a".repeat(65)), Err(SeedError::TooLong));
        assert_eq!(parse_seed("a\u{7}b"), Err(SeedError::Unprintable));
    }
}
