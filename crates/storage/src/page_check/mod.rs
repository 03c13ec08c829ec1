//! Checks from a file's bytes alone whether the embedded store can be trusted with it.
//!
//! The store believes what its file says: how long a page is, where its children are,
//! how many entries a leaf has. So a flipped bit, or somebody's forged archive, makes it
//! panic, ask for gigabytes, or walk one page a billion times. Every page that it could
//! ever come to is therefore read here first, in bounded time and memory.
//!
//! # Layout
//!
//! As redb 4 writes it (file format 3, `docs/design.md` in its source), little-endian.
//! Page 0 is the header; from byte 4096 on pages of 4096 bytes follow. 2^20 of them are
//! a region; regions follow one another without a gap and only the last may be shorter.
//!
//! | bytes of the header | what |
//! |---|---|
//! | 0..9 | magic `redb` 1A 0A A9 0D 0A |
//! | 9 | the *god byte*: bit 0 which commit slot is in force, bit 1 not closed, bit 2 written in two phases |
//! | 12..16 | page size, 4096 |
//! | 16..20 | pages of a region's own header, 0 since format 3 |
//! | 20..24 | pages of a region, 2^20 |
//! | 24..28, 28..32 | full regions; pages of the last one |
//! | 64..192, 192..320 | the two commit slots |
//!
//! | bytes of a slot | what |
//! |---|---|
//! | 0 | format, 3 |
//! | 1, 2 | whether there are a user and a system tree |
//! | 8..40, 40..72 | their roots: page number u64, checksum u128, entries u64 |
//! | 104..112 | transaction number |
//! | 112..128 | XXH3-128 of bytes 0..112 |
//!
//! A page number has in bits 0..20 the index in units of the page's own size, in 20..40
//! the region, in 59..64 the order: such a page is 2^order pages long.
//!
//! | a leaf | | a branch of n keys | |
//! |---|---|---|---|
//! | 0 | 1 | 0 | 2 |
//! | 2..4 | entries n | 2..4 | n |
//! | 4.. | n ends of keys, u32 | 8.. | n + 1 checksums of children, u128 |
//! | | n ends of values, u32 | | n + 1 page numbers, u64 |
//! | | keys, then values | | n ends of keys, u32; then keys |
//!
//! Ends count from the page's beginning and are left out where all are of one width. A
//! page's checksum covers it to its last end, and stands in its parent: a Merkle tree.
//! A child's keys lie above the key before it and not above the one behind it.
//!
//! The user tree leads from names to [`table`] definitions, which hold the roots of the
//! tables. The system tree does so for the store's own: pages freed but kept for readers,
//! and what is free, written when the store closes ([`free`]).
//!
//! # Which commit is in force
//!
//! As the store chooses (`header.rs` and `db.rs` of its source), so that whatever a
//! `kill -9` or a power cut leaves is taken as it would be: [`header::Header::chosen`]
//! and [`whole`].

mod claims;
mod file;
mod find;
mod free;
mod header;
mod node;
mod order;
mod pages;
mod table;
mod walk;
mod whole;

#[cfg(test)]
mod tests;

use std::io;

pub use file::check_pages;
pub(crate) use file::{Held, check, hold, look};

/// What checking a whole file has found, if it can be trusted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Checked {
    /// Leaves of records whose checksum is wrong though they are well formed: the seals of
    /// the records in them tell which of these to believe.
    pub(crate) torn_leaves: u64,
}

/// Why a file cannot be trusted.
#[derive(Debug)]
pub(crate) enum Fault {
    /// Bytes are not those that were written: a checksum says so. Where a commit was cut
    /// short, the one before it may be whole.
    Torn(&'static str),
    /// The bytes are as they were written, or nobody can tell, and contradict themselves.
    Wrong(&'static str),
    /// The file could not be read.
    Io(io::Error),
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// What a foreign, empty or shortened file is.
const NO_SAVE: &str = "it is no save of this game, or a part of it is missing";

/// Reads a little-endian u16 at `at`.
fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    let bytes = bytes.get(at..)?.first_chunk()?;
    Some(u16::from_le_bytes(*bytes))
}

/// Reads a little-endian u32 at `at`.
fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..)?.first_chunk()?;
    Some(u32::from_le_bytes(*bytes))
}

/// Reads a little-endian u64 at `at`.
fn u64_at(bytes: &[u8], at: usize) -> Option<u64> {
    let bytes = bytes.get(at..)?.first_chunk()?;
    Some(u64::from_le_bytes(*bytes))
}

/// Reads a little-endian u128 at `at`.
fn u128_at(bytes: &[u8], at: usize) -> Option<u128> {
    let bytes = bytes.get(at..)?.first_chunk()?;
    Some(u128::from_le_bytes(*bytes))
}

/// The checksum that the store keeps of a page.
fn checksum(bytes: &[u8]) -> u128 {
    twox_hash::XxHash3_128::oneshot(bytes)
}
