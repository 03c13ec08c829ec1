//! Small changes to bytes and to text, as fuzzers make them.

use fastrand::Rng;

/// Numbers at which arithmetic breaks.
pub(crate) const EDGES: [u64; 16] = [
    0,
    1,
    0x7f,
    0x80,
    0xff,
    0x7fff,
    0x8000,
    0xffff,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
    0xa0,
    i64::MAX as u64,
    1 << 63,
    u64::MAX - 1,
    u64::MAX,
];

/// No input of a campaign is longer.
const MOST_BYTES: usize = 300 << 10;

/// Between one and a dozen changes, few being likelier.
pub(crate) fn some(rng: &mut Rng) -> usize {
    1 + (rng.f64() * rng.f64() * 12.0) as usize
}

/// Changes bytes in one way.
pub(crate) fn change_bytes(rng: &mut Rng, bytes: &mut Vec<u8>) {
    if bytes.is_empty() {
        bytes.push(rng.u8(..));
        return;
    }
    let at = rng.usize(..bytes.len());
    let end = bytes.len().min(at + 1 + rng.usize(..32));
    match rng.u8(..9) {
        0 | 1 => bytes[at] ^= 1 << rng.u8(..8),
        2 => bytes[at] = rng.u8(..),
        3 => {
            let edge = EDGES[rng.usize(..EDGES.len())].to_le_bytes();
            let width = [1, 2, 4, 8][rng.usize(..4)].min(bytes.len() - at);
            bytes[at..at + width].copy_from_slice(&edge[..width]);
        }
        4 => drop(bytes.drain(at..end)),
        5 => {
            let piece = bytes[at..end].to_vec();
            let to = rng.usize(..=bytes.len());
            bytes.splice(to..to, piece);
        }
        6 => bytes.truncate(at),
        7 => bytes[at] = bytes[at].wrapping_add(rng.u8(..)),
        _ => {
            let piece = std::iter::repeat_n(rng.u8(..), 1 + rng.usize(..16));
            bytes.splice(at..at, piece);
        }
    }
    bytes.truncate(MOST_BYTES);
}

/// Changes a text in one way: a word, a line or a few bytes of it.
pub(crate) fn change_text(rng: &mut Rng, text: &mut Vec<u8>, words: &[&str]) {
    let word = words[rng.usize(..words.len())].as_bytes();
    match rng.u8(..8) {
        0..=2 => {
            let place = a_word(rng, text);
            text.splice(place, word.iter().copied());
        }
        3 => {
            let at = rng.usize(..=text.len());
            text.splice(at..at, word.iter().copied());
        }
        4 => {
            let times = 1 << rng.u8(..12);
            let at = rng.usize(..=text.len());
            text.splice(at..at, word.repeat(times).into_iter().take(MOST_BYTES));
        }
        5 => {
            let mut lines: Vec<_> = text.split(|byte| *byte == b'\n').collect();
            let (from, to) = (rng.usize(..lines.len()), rng.usize(..lines.len()));
            let line = lines[from];
            lines.insert(to, line);
            *text = lines.join(&b'\n');
        }
        _ => change_bytes(rng, text),
    }
    text.truncate(MOST_BYTES);
}

/// Where a word of a text stands.
fn a_word(rng: &mut Rng, text: &[u8]) -> std::ops::Range<usize> {
    let at = rng.usize(..=text.len());
    let part = |byte: &u8| byte.is_ascii_alphanumeric() || b"-.=_\"".contains(byte);
    let before = text[..at]
        .iter()
        .rev()
        .take_while(|byte| part(byte))
        .count();
    let after = text[at..].iter().take_while(|byte| part(byte)).count();
    at - before..at + after
}
