//! Bounds on text that comes from outside: how much of it is read, and how much is quoted.

use std::io::Read;

/// Most bytes of a script or of settings.
const LONGEST_BYTES: u64 = 1 << 20;

/// Reads all that is there, if that is no longer than anything that people write by hand: a device has no end.
///
/// # Errors
/// When there is more, in words, or the system refuses.
pub fn read_short(from: impl Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(LONGEST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST_BYTES {
        return Err(std::io::Error::other("it is longer than 1 MB"));
    }
    Ok(bytes)
}

/// The text, or its beginning if it has more than `most` characters.
pub fn shortened(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
