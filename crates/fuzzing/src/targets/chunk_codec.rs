//! The edits of a chunk: bytes that are taken for some come back as the same edits.
//!
//! The first byte of an input says what follows: packed bytes, or runs (a length of two
//! bytes and a value each) of what packing packs, and then changes to what comes out
//! (two bytes of place, one to combine with).

use antipode_storage::{CHUNK_SAMPLES, pack_chunk, unpack_chunk};
use fastrand::Rng;

use super::{Seen, Target, must};
use crate::mutation::{change_bytes, some};

pub(super) const TARGET: Target = Target {
    name: "chunk_codec",
    run,
    seeds,
    mutate,
};

/// Bytes of planes that a chunk has.
const PLANES: usize = 2 * CHUNK_SAMPLES;

fn run(input: &[u8]) -> Result<Seen, String> {
    let packed = match input.split_first() {
        Some((0, rest)) => rest.to_vec(),
        Some((changes, rest)) => of_runs(usize::from(*changes) - 1, rest),
        None => Vec::new(),
    };
    // Nothing else guards it than the checksum of the record that it stands in.
    let past_checksums = true;
    let Ok(samples) = unpack_chunk(&packed) else {
        return Ok(Seen {
            past_checksums,
            taken: false,
        });
    };
    must(samples.len() == CHUNK_SAMPLES, || {
        format!("{} samples were unpacked", samples.len())
    })?;
    let again = pack_chunk(&samples)?;
    must(unpack_chunk(&again) == Ok(samples), || {
        "edits are not what they were".to_owned()
    })?;
    Ok(Seen {
        past_checksums,
        taken: true,
    })
}

/// Planes made of runs and packed, then changed in so many places.
fn of_runs(changes: usize, rest: &[u8]) -> Vec<u8> {
    let (changing, runs) = rest.split_at(rest.len().min(3 * changes));
    let mut planes = Vec::with_capacity(PLANES);
    for run in runs.chunks_exact(3) {
        let length = usize::from(u16::from_le_bytes([run[0], run[1]]));
        planes.extend(std::iter::repeat_n(
            run[2],
            length.min(PLANES - planes.len()),
        ));
    }
    planes.resize(PLANES, 0);
    let mut packed = lz4_flex::block::compress(&planes);
    for change in changing.chunks_exact(3) {
        let at = usize::from(u16::from_le_bytes([change[0], change[1]])) % packed.len();
        packed[at] ^= change[2];
    }
    packed
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let samples: Vec<i16> = (0..CHUNK_SAMPLES)
        .map(|i| (i * i % 41) as i16 - 20)
        .collect();
    let packed =
        [samples, vec![0; CHUNK_SAMPLES]].map(|samples| pack_chunk(&samples).unwrap_or_default());
    let [busy, empty] = packed.map(|packed| [vec![0], packed].concat());
    let runs = vec![1, 200, 0, 7, 255, 255, 0, 9, 0, 255];
    let changed = vec![2, 3, 0, 255, 9, 1, 4, 100, 0, 3];
    [
        ("busy", busy),
        ("empty", empty),
        ("runs", runs),
        ("changed", changed),
    ]
    .map(|(name, bytes)| (name.to_owned(), bytes))
    .into()
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    if rng.bool() {
        let changes = if rng.bool() { 0 } else { rng.u8(..4) };
        let triples = usize::from(changes) + rng.usize(..40);
        let bytes = std::iter::repeat_with(|| rng.u8(..)).take(3 * triples);
        return std::iter::once(1 + changes)
            .chain(bytes.collect::<Vec<_>>())
            .collect();
    }
    let mut bytes = seed.to_vec();
    for _ in 0..some(rng) {
        change_bytes(rng, &mut bytes);
    }
    bytes
}
