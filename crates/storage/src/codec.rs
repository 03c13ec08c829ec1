//! Encodes values as bytes: the body of a value, and the sealed record around it.
//!
//! A record is, little-endian:
//!
//! | bytes | what |
//! |---|---|
//! | 0..2 | version of the body: of the schema, or of the record's kind |
//! | 2..4 | mark `Ap` |
//! | 4 | kind |
//! | 5 | length of the key |
//! | 6..10 | length of the body |
//! | 10..18 | number of the commit that wrote it |
//! | 18..22 | CRC-32 of all the other bytes |
//! | 22.. | key, then body |
//!
//! This layout is the one thing that never changes, whatever the version: so an
//! older game can tell a newer world from a damaged one. The key is repeated
//! inside so that a record found in the wrong place, or anywhere in a file whose
//! index is lost, still says whose it is.
//!
//! bincode is used here and nowhere else.

use std::ops::ControlFlow;

use serde::Serialize;
use serde::de::DeserializeOwned;

/// Bytes before the key.
pub(crate) const HEADER_BYTES: usize = 22;
/// The largest number of a commit that can be true: one every millisecond for 8900 years.
/// A larger one is damage, or somebody's joke: counting on from near 2^64 would overflow.
pub(crate) const MAX_COMMIT: u64 = 1 << 48;
const MARK: [u8; 2] = *b"Ap";
/// No body is near this long; a longer one is a damaged length.
const MAX_BODY_BYTES: usize = 1 << 20;
/// The longest record: its key's length is one byte.
pub(crate) const MAX_RECORD_BYTES: usize = HEADER_BYTES + u8::MAX as usize + MAX_BODY_BYTES;

/// What a record holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(crate) enum Kind {
    /// What the world is.
    Meta = 1,
    /// What changed while it was played, up to version 6.
    State = 2,
    /// The edits of one chunk.
    Chunk = 3,
    /// One thing, by a kind and a version of its own; see [`crate::record`].
    Record = 4,
}

impl Kind {
    fn from_byte(byte: u8) -> Option<Self> {
        [Self::Meta, Self::State, Self::Chunk, Self::Record]
            .into_iter()
            .find(|kind| *kind as u8 == byte)
    }
}

/// An intact record, borrowed from its bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Record<'a> {
    /// Schema version of the body.
    pub version: u16,
    /// What it holds.
    pub kind: Kind,
    /// The key it is stored under.
    pub key: &'a [u8],
    /// Number of the commit that wrote it.
    pub sequence: u64,
    /// The value, not decoded.
    pub body: &'a [u8],
}

/// Why bytes are not an intact value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Fault {
    /// Too short, or too long, for what it says it is.
    #[error("its length is wrong")]
    Length,
    /// No record of ours.
    #[error("it does not begin as a stored value does")]
    Mark,
    /// Bits have changed.
    #[error("its checksum does not match its bytes")]
    Checksum,
    /// The number of its commit is larger than any can be.
    #[error("it says that it was saved a number of times that nobody can")]
    Commit,
    /// The bytes are whole but make no value of this type.
    #[error("its contents make no sense")]
    Contents,
}

/// Wraps a body into a record. Keys are at most 255 bytes long.
pub(crate) fn seal(version: u16, kind: Kind, key: &[u8], sequence: u64, body: &[u8]) -> Vec<u8> {
    debug_assert!(u8::try_from(key.len()).is_ok(), "keys are short");
    let mut record = Vec::with_capacity(HEADER_BYTES + key.len() + body.len());
    record.extend(version.to_le_bytes());
    record.extend(MARK);
    record.extend([kind as u8, key.len() as u8]);
    record.extend((body.len() as u32).to_le_bytes());
    record.extend(sequence.to_le_bytes());
    record.extend([0; 4]);
    record.extend(key);
    record.extend(body);
    let sum = record_checksum(&record);
    record[18..22].copy_from_slice(&sum.to_le_bytes());
    record
}

/// The number of the commit after `last`. It stops at [`MAX_COMMIT`], which only a forged
/// world starts near to: saving goes on there, and of two copies either counts as the newer.
pub(crate) fn next_commit(last: u64) -> u64 {
    last.saturating_add(1).min(MAX_COMMIT)
}

/// Reads the record that fills `bytes` exactly.
pub(crate) fn unseal(bytes: &[u8]) -> Result<Record<'_>, Fault> {
    let (record, rest) = unseal_prefix(bytes)?;
    if rest.is_empty() {
        Ok(record)
    } else {
        Err(Fault::Length)
    }
}

/// Reads the record that `bytes` begin with, and returns what follows it.
pub(crate) fn unseal_prefix(bytes: &[u8]) -> Result<(Record<'_>, &[u8]), Fault> {
    let end = record_bytes(bytes)?;
    let (record, rest) = bytes.split_at_checked(end).ok_or(Fault::Length)?;
    Ok((unseal_whole(record)?, rest))
}

/// How long the record is that `bytes` begin with, by what its header says.
fn record_bytes(bytes: &[u8]) -> Result<usize, Fault> {
    let header = bytes.first_chunk::<HEADER_BYTES>().ok_or(Fault::Length)?;
    if header[2..4] != MARK {
        return Err(Fault::Mark);
    }
    Kind::from_byte(header[4]).ok_or(Fault::Mark)?;
    let key_len = header[5] as usize;
    let body_len = u32::from_le_bytes([header[6], header[7], header[8], header[9]]) as usize;
    if body_len > MAX_BODY_BYTES {
        return Err(Fault::Length);
    }
    Ok(HEADER_BYTES + key_len + body_len)
}

/// Reads a record of the length that [`record_bytes`] tells.
fn unseal_whole(record: &[u8]) -> Result<Record<'_>, Fault> {
    let header = record.first_chunk::<HEADER_BYTES>().ok_or(Fault::Length)?;
    let sum = u32::from_le_bytes([header[18], header[19], header[20], header[21]]);
    if sum != record_checksum(record) {
        return Err(Fault::Checksum);
    }
    let rest = &record[HEADER_BYTES..];
    let (key, body) = rest
        .split_at_checked(header[5] as usize)
        .ok_or(Fault::Length)?;
    let mut sequence = [0; 8];
    sequence.copy_from_slice(&header[10..18]);
    let sequence = u64::from_le_bytes(sequence);
    if sequence > MAX_COMMIT {
        return Err(Fault::Commit);
    }
    Ok(Record {
        version: u16::from_le_bytes([header[0], header[1]]),
        kind: Kind::from_byte(header[4]).ok_or(Fault::Mark)?,
        key,
        sequence,
        body,
    })
}

/// Hands over every intact record in `bytes`, wherever it begins: what is left of a store
/// without its index, stale copies on freed pages included.
///
/// `budget` is how many bytes may still be checksummed: forged headers can stand a few bytes
/// apart and each ask for the longest record. Breaks with where it was spent.
pub(crate) fn carve(
    bytes: &[u8],
    budget: &mut u64,
    mut each: impl FnMut(&Record<'_>),
) -> ControlFlow<usize> {
    let mut at = 0;
    while let Some(offset) = bytes
        .get(at + 2..)
        .and_then(|rest| rest.windows(2).position(|pair| pair == MARK))
    {
        let start = at + offset;
        at = start + 1;
        let Ok(length) = record_bytes(&bytes[start..]) else {
            continue;
        };
        let Some(record) = bytes.get(start..start + length) else {
            continue;
        };
        let Some(left) = budget.checked_sub(length as u64) else {
            return ControlFlow::Break(start);
        };
        *budget = left;
        if let Ok(record) = unseal_whole(record) {
            each(&record);
            at = start + length;
        }
    }
    ControlFlow::Continue(())
}

/// The CRC-32 of a record but for the four bytes that hold it.
fn record_checksum(record: &[u8]) -> u32 {
    let mut crc = crc32fast::Hasher::new();
    crc.update(&record[..18]);
    crc.update(&record[HEADER_BYTES..]);
    crc.finalize()
}

fn config() -> impl bincode::config::Config {
    // The limit keeps a wrong length from asking for gigabytes.
    bincode::config::standard().with_limit::<MAX_BODY_BYTES>()
}

/// The body of a value: its fields in order, integers as varints, floats as eight bytes.
pub(crate) fn encode<T: Serialize>(value: &T) -> Result<Vec<u8>, Fault> {
    let body = bincode::serde::encode_to_vec(value, config()).map_err(|_| Fault::Contents)?;
    if body.len() <= MAX_BODY_BYTES {
        Ok(body)
    } else {
        Err(Fault::Length)
    }
}

/// The inverse of [`encode`]; every byte must be used.
pub(crate) fn decode<T: DeserializeOwned>(body: &[u8]) -> Result<T, Fault> {
    let (value, used) =
        bincode::serde::decode_from_slice(body, config()).map_err(|_| Fault::Contents)?;
    if used == body.len() {
        Ok(value)
    } else {
        Err(Fault::Contents)
    }
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
    use proptest::prelude::*;

    #[test]
    fn the_checksum_is_the_standard_one() {
        assert_eq!(
            crc32fast::hash(b"123456789"),
            0xCBF4_3926,
            "the check value of CRC-32/ISO-HDLC"
        );
    }

    /// The keys and commits of what is found.
    fn carved(bytes: &[u8]) -> Vec<(Vec<u8>, u64)> {
        let mut found = Vec::new();
        let all = carve(bytes, &mut 1000, |record| {
            found.push((record.key.to_vec(), record.sequence));
        });
        assert!(all.is_continue());
        found
    }

    #[test]
    fn carving_ends_where_its_budget_is_spent() {
        let first = seal(1, Kind::Chunk, b"k", 5, b"body");
        let file = [first.as_slice(), &first].concat();
        for (budget, end) in [
            (2 * first.len(), ControlFlow::Continue(())),
            (2 * first.len() - 1, ControlFlow::Break(first.len())),
            (0, ControlFlow::Break(0)),
        ] {
            assert_eq!(carve(&file, &mut (budget as u64), |_| {}), end);
        }
    }

    #[test]
    fn carving_finds_records_between_rubbish() {
        let first = seal(1, Kind::Chunk, b"k1", 5, b"ApApAp body");
        let second = seal(1, Kind::State, b"k2", 6, b"");
        let mut cut = seal(1, Kind::Meta, b"k3", 7, b"cut short");
        cut.truncate(25);
        let file = [
            b"Ap\0rubbish".as_slice(),
            &first,
            &cut,
            b"A",
            &second,
            b"Ap",
        ]
        .concat();
        assert_eq!(carved(&file), [(b"k1".to_vec(), 5), (b"k2".to_vec(), 6)]);
    }

    #[test]
    fn numbers_of_commits_end_where_they_could_overflow() {
        let sealed = |sequence| seal(1, Kind::State, b"state", sequence, b"");
        for sequence in [MAX_COMMIT + 1, u64::MAX - 4, u64::MAX] {
            assert_eq!(unseal(&sealed(sequence)), Err(Fault::Commit));
            assert_eq!(carved(&sealed(sequence)), []);
        }
        assert_eq!(
            unseal(&sealed(MAX_COMMIT)).map(|found| found.sequence),
            Ok(MAX_COMMIT)
        );
        assert_eq!(next_commit(0), 1);
        // What is written is read again, however often one saves.
        for last in [MAX_COMMIT - 1, MAX_COMMIT, u64::MAX] {
            assert_eq!(next_commit(last), MAX_COMMIT);
        }
    }

    proptest! {
        #[test]
        fn sealed_records_come_back(
            version: u16, sequence in 0..=MAX_COMMIT,
            key in prop::collection::vec(any::<u8>(), 0..20),
            body in prop::collection::vec(any::<u8>(), 0..300),
        ) {
            let bytes = seal(version, Kind::Chunk, &key, sequence, &body);
            let expected = Record { version, kind: Kind::Chunk, key: &key, sequence, body: &body };
            prop_assert_eq!(unseal(&bytes), Ok(expected));
        }

        #[test]
        fn every_flipped_bit_and_every_cut_is_noticed(
            body in prop::collection::vec(any::<u8>(), 0..40), bit: prop::sample::Index, cut: prop::sample::Index,
        ) {
            let bytes = seal(1, Kind::State, b"state", 3, &body);
            let mut flipped = bytes.clone();
            let bit = bit.index(bytes.len() * 8);
            flipped[bit / 8] ^= 1 << (bit % 8);
            prop_assert!(unseal(&flipped).is_err());
            prop_assert!(unseal(&bytes[..cut.index(bytes.len())]).is_err());
        }

        #[test]
        fn rubbish_never_decodes_by_accident_or_panics(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            prop_assert!(unseal(&bytes).is_err());
            let _ = decode::<Vec<String>>(&bytes);
            prop_assert_eq!(carved(&bytes), []);
        }
    }
}
