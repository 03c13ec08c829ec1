//! The bytes of a journal: a first line that says what it is, then frames, each with its length and checksum before it. What a
//! killed process or a power cut leaves of the last frame is not taken for one.

/// The first bytes of a journal.
pub(crate) const HEAD: &[u8] = b"antipode-workshop-journal 1\n";
/// No frame is longer, bytes: a step changes at most every object of a room.
const MOST_FRAME_BYTES: usize = 16 << 20;
const PREFIX_BYTES: usize = 8;

/// Adds a frame to bytes.
pub(crate) fn put(out: &mut Vec<u8>, payload: &[u8]) {
    out.extend((payload.len() as u32).to_le_bytes());
    out.extend(crc32fast::hash(payload).to_le_bytes());
    out.extend(payload);
}

/// The frames of a journal's bytes, until one is not whole.
pub(crate) struct Frames<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Frames<'b> {
    /// None if it is no journal that this version knows.
    pub fn of(bytes: &'b [u8]) -> Option<Self> {
        bytes.starts_with(HEAD).then_some(Self {
            bytes,
            at: HEAD.len(),
        })
    }

    /// Where the next frame begins, or would.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Whether what follows is what a write that did not come to its end leaves: fewer bytes than its first say.
    pub fn is_torn(&self) -> bool {
        let rest = &self.bytes[self.at..];
        prefix(rest).is_none_or(|(length, _)| rest.len() < PREFIX_BYTES + length)
    }
}

impl<'b> Iterator for Frames<'b> {
    type Item = &'b [u8];

    fn next(&mut self) -> Option<&'b [u8]> {
        let rest = &self.bytes[self.at..];
        let (length, sum) = prefix(rest)?;
        if length > MOST_FRAME_BYTES {
            return None;
        }
        let payload = rest.get(PREFIX_BYTES..PREFIX_BYTES + length)?;
        if crc32fast::hash(payload) != sum {
            return None;
        }
        self.at += PREFIX_BYTES + length;
        Some(payload)
    }
}

/// Length and checksum of the frame at the beginning of bytes.
fn prefix(bytes: &[u8]) -> Option<(usize, u32)> {
    let (length, rest) = bytes.split_first_chunk::<4>()?;
    let (sum, _) = rest.split_first_chunk::<4>()?;
    Some((
        u32::from_le_bytes(*length) as usize,
        u32::from_le_bytes(*sum),
    ))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn whole_frames_are_read_and_torn_or_changed_ones_are_not() {
        let mut bytes = HEAD.to_vec();
        put(&mut bytes, b"one");
        let second = bytes.len();
        put(&mut bytes, b"second");
        let all: Vec<_> = Frames::of(&bytes).unwrap().collect();
        assert_eq!(all, [b"one".as_slice(), b"second"]);
        for cut in second..bytes.len() {
            let mut frames = Frames::of(&bytes[..cut]).unwrap();
            assert_eq!(frames.by_ref().count(), 1, "{cut}");
            assert!(frames.at() == second && frames.is_torn(), "{cut}");
        }
        let last = bytes.len() - 1;
        bytes[last] ^= 1;
        let mut frames = Frames::of(&bytes).unwrap();
        assert_eq!(frames.by_ref().count(), 1);
        assert!(!frames.is_torn());
        assert!(Frames::of(b"something else").is_none());
    }
}
