//! A forged store as few bytes: which store to begin with, and a list of changes to
//! named parts of it, after which records and pages get their checksums again or not.
//!
//! | bytes | what |
//! |---|---|
//! | 0 | bit 0: killed, not closed; 1: seal records; 2: seal pages; 3: cut; 4: lengthen; 5: of format 7, not 6; all bits: a raw store follows |
//! | 1..4 | where to cut, or by how much to lengthen |
//! | then 12 each | what to do and to which part (a byte), where (three), with what (eight) |
//!
//! So a fuzzer that knows nothing of stores reaches every field of them with short inputs.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::OnceLock;

use fastrand::Rng;

use super::pages::{self, Part};
use super::{bases, record};
use crate::mutation::{EDGES, change_bytes};

/// The first byte of an input that is a store as it stands.
pub const RAW: u8 = 0xff;
const KILLED: u8 = 1;
const SEAL_RECORDS: u8 = 2;
const SEAL_PAGES: u8 = 4;
const CUT: u8 = 8;
const LENGTHEN: u8 = 16;
const TODAY: u8 = 32;
const HEAD: usize = 4;
const EDIT: usize = 12;
/// More changes than this are not made.
const MOST_EDITS: usize = 64;

/// A base with the places of its fields, in the order of [`Part::ALL`].
struct Base {
    bytes: &'static [u8],
    parts: [Vec<Range<usize>>; Part::ALL.len()],
    records: Vec<Range<usize>>,
}

/// The base that the first byte of an input names.
fn base(flags: u8) -> &'static Base {
    static BASES: [OnceLock<Base>; 4] = [const { OnceLock::new() }; 4];
    let (killed, today) = (flags & KILLED != 0, flags & TODAY != 0);
    BASES[usize::from(killed) + 2 * usize::from(today)].get_or_init(|| {
        let bytes = bases::store(killed, today);
        let records = record::records(bytes);
        let mut fields = pages::fields(bytes);
        for record in &records {
            let body = record.start + record::HEADER;
            fields.push((Part::RecordHead, record.start..body));
            fields.push((Part::RecordBody, body..record.end));
        }
        let parts = Part::ALL.map(|part| {
            let of_part = fields.iter().filter(|(found, _)| *found == part);
            of_part.map(|(_, range)| range.clone()).collect()
        });
        Base {
            bytes,
            parts,
            records,
        }
    })
}

/// How many bytes of the base a part has: the places that an edit can choose among.
pub fn places(killed: bool, today: bool, part: Part) -> Vec<Range<usize>> {
    let flags = (u8::from(killed) * KILLED) | (u8::from(today) * TODAY);
    let index = Part::ALL.iter().position(|one| *one == part);
    index.map_or_else(Vec::new, |index| base(flags).parts[index].clone())
}

/// The store that an input describes.
pub fn store(input: &[u8]) -> Vec<u8> {
    let Some((&flags, rest)) = input.split_first() else {
        return Vec::new();
    };
    if flags == RAW {
        return rest.to_vec();
    }
    let base = base(flags);
    let mut bytes = base.bytes.to_vec();
    let mut touched = BTreeSet::new();
    let edits = rest.get(HEAD - 1..).unwrap_or_default();
    for edit in edits.chunks_exact(EDIT).take(MOST_EDITS) {
        apply(base, edit, &mut bytes, &mut touched);
    }
    if flags & SEAL_RECORDS != 0 {
        for record in &touched {
            record::seal(&mut bytes[base.records[*record].start..]);
        }
    }
    if flags & SEAL_PAGES != 0 {
        pages::seal(&mut bytes);
    }
    let by = three(rest.get(..HEAD - 1).unwrap_or_default());
    if flags & CUT != 0 {
        bytes.truncate(by % (bytes.len() + 1));
    }
    if flags & LENGTHEN != 0 {
        bytes.resize(bytes.len() + by % 100_000, 0);
    }
    bytes
}

/// Whether an input begins with the store that was killed.
pub fn is_killed(input: &[u8]) -> bool {
    input.first().is_some_and(|flags| flags & KILLED != 0)
}

/// Whether every checksum of a store is right that has the records of a base.
pub fn is_sealed(input: &[u8], store: &[u8]) -> bool {
    let base = base(input.first().copied().unwrap_or_default());
    store.len() >= base.bytes.len()
        && pages::is_sealed(store)
        && base
            .records
            .iter()
            .all(|record| record::is_sealed(&store[record.start..]))
}

fn three(bytes: &[u8]) -> usize {
    bytes
        .iter()
        .rev()
        .fold(0, |sum, byte| sum << 8 | usize::from(*byte))
}

/// Makes one change, and notes the record that it fell into.
fn apply(base: &Base, edit: &[u8], bytes: &mut [u8], touched: &mut BTreeSet<usize>) {
    let fields = &base.parts[usize::from(edit[0] >> 3) % Part::ALL.len()];
    let total: usize = fields.iter().map(Range::len).sum();
    if total == 0 {
        return;
    }
    let mut place = three(&edit[1..4]) % total;
    let Some(field) = fields.iter().find(|field| {
        let inside = place < field.len();
        place -= if inside { 0 } else { field.len() };
        inside
    }) else {
        return;
    };
    let at = field.start + place;
    let value: [u8; 8] = edit[4..].first_chunk().copied().unwrap_or_default();
    let with = u64::from_le_bytes(value);
    let mut put = |at: usize, source: &[u8]| {
        let end = bytes.len().min(at + source.len());
        bytes[at..end].copy_from_slice(&source[..end - at]);
    };
    match edit[0] & 7 {
        0 => bytes[at] ^= 1 << (with % 8),
        1 => bytes[at] = value[0],
        2 => put(at, &value[..2]),
        3 => put(at, &value[..4]),
        4 => put(at, &value),
        5 => bytes[at] = bytes[at].wrapping_add(value[0]),
        6 => {
            let other = &fields[with as usize % fields.len()];
            let length = other.len().min(field.len());
            put(field.start, &base.bytes[other.start..other.start + length]);
        }
        _ => {
            let width = [1, 2, 4, 8][usize::from(value[1] % 4)];
            put(
                at,
                &EDGES[usize::from(value[0]) % EDGES.len()].to_le_bytes()[..width],
            );
        }
    }
    let record = base.records.partition_point(|record| record.end <= at);
    if base
        .records
        .get(record)
        .is_some_and(|record| record.contains(&at))
    {
        touched.insert(record);
    }
}

/// An input that changes so many places of these parts, sealed or not.
pub fn forged(rng: &mut Rng, parts: &[Part], edits: usize, seal: bool) -> Vec<u8> {
    let mut input = vec![
        (u8::from(rng.bool()) * KILLED) | (u8::from(rng.bool()) * TODAY),
        rng.u8(..),
        rng.u8(..),
        rng.u8(..),
    ];
    if seal {
        input[0] |= SEAL_RECORDS | SEAL_PAGES;
    }
    for _ in 0..edits {
        let part = parts[rng.usize(..parts.len())];
        let part = Part::ALL.iter().position(|one| *one == part).unwrap_or(0);
        input.push((part as u8) << 3 | rng.u8(..8));
        input.extend(std::iter::repeat_with(|| rng.u8(..)).take(EDIT - 1));
    }
    input
}

/// A single bit of one of these parts, flipped and not sealed.
pub fn flipped(rng: &mut Rng, parts: &[Part]) -> Vec<u8> {
    let mut input = forged(rng, parts, 1, false);
    input[HEAD] &= !7;
    input
}

/// Parts that a mutation chooses among, those oftener that leave an index which can be
/// followed to its end, and so be sealed.
const LIKELY: [Part; 26] = [
    Part::Header,
    Part::Slot,
    Part::Count,
    Part::Pointer,
    Part::Pointer,
    Part::Offset,
    Part::Key,
    Part::Key,
    Part::Key,
    Part::Table,
    Part::RecordHead,
    Part::RecordHead,
    Part::RecordHead,
    Part::RecordHead,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
    Part::RecordBody,
];

/// Another input like this one.
pub(crate) fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    if rng.u8(..16) == 0 {
        let mut input = seed.to_vec();
        change_bytes(rng, &mut input);
        return input;
    }
    let seal = rng.u8(..16) > 0;
    // Mostly one or two: what is changed in many places is soon refused.
    let edits = 1 + (rng.f64().powi(7) * 10.0) as usize;
    let mut input = forged(rng, &LIKELY, edits, seal);
    match rng.u8(..20) {
        0 => input[0] |= CUT,
        1 => input[0] |= LENGTHEN,
        _ => {}
    }
    input
}

/// Inputs to begin with: every kind of change to every part once, sealed and not.
pub(crate) fn seeds() -> Vec<(String, Vec<u8>)> {
    let mut rng = Rng::with_seed(18);
    let mut seeds = vec![
        ("old".to_owned(), vec![0; HEAD]),
        ("old-killed".to_owned(), vec![KILLED, 0, 0, 0]),
        ("closed".to_owned(), vec![TODAY, 0, 0, 0]),
        ("killed".to_owned(), vec![TODAY | KILLED, 0, 0, 0]),
        ("cut".to_owned(), vec![TODAY | CUT, 0, 80, 0]),
        (
            "longer".to_owned(),
            vec![TODAY | KILLED | LENGTHEN, 0, 16, 0],
        ),
        (
            "foreign".to_owned(),
            [&[RAW], b"GIF89a and no store".as_slice()].concat(),
        ),
    ];
    for part in Part::ALL {
        for seal in [false, true] {
            let input = forged(&mut rng, &[part], 3, seal);
            let how = if seal { "sealed" } else { "flipped" };
            seeds.push((format!("{part:?}-{how}").to_lowercase(), input));
        }
    }
    seeds
}
