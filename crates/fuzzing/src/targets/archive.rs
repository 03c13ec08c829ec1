//! A world as one file, as it comes from others: it is refused, or the world is sound.
//!
//! | bytes | what |
//! |---|---|
//! | 0 | bit 0: blocks get their checksums again; bits 1 to 3: changes to the archive; all bits: a raw archive follows |
//! | then 6 each | where (three), bit 7 for the packed bytes too and how (a byte), with what (two) |
//! | the rest | a [`plan`] of the store in it |

use antipode_storage::{THUMBNAIL_FILE, WORLD_FILE};
use fastrand::Rng;

use super::store::import;
use super::{Seen, Target};
use crate::forge::{container, plan};
use crate::mutation::EDGES;
use crate::world_folder::with_world_folder;

pub(super) const TARGET: Target = Target {
    name: "archive",
    run,
    seeds,
    mutate,
};

const SEAL: u8 = 1;
pub(super) const EDIT: usize = 6;

fn run(input: &[u8]) -> Result<Seen, String> {
    let (bytes, inner_sealed) = archive(input);
    with_world_folder(|folder| {
        folder.empty().map_err(|error| error.to_string())?;
        let file = folder.beside("foreign");
        std::fs::write(&file, &bytes).map_err(|error| error.to_string())?;
        Ok(Seen {
            past_checksums: inner_sealed && container::is_sealed(&bytes),
            taken: import(folder, &file)?,
        })
    })
}

/// The archive that an input describes, and whether the store in it is sealed.
pub fn archive(input: &[u8]) -> (Vec<u8>, bool) {
    let (flags, rest) = match input.split_first() {
        None => return (Vec::new(), false),
        Some((&plan::RAW, raw)) => return (raw.to_vec(), false),
        Some((flags, rest)) => (flags, rest),
    };
    let changes = usize::from(flags >> 1 & 7) * EDIT;
    let (edits, inner) = rest.split_at(changes.min(rest.len()));
    let store = plan::store(inner);
    let inner_sealed = plan::is_sealed(inner, &store);
    let mut bytes = container::pack(&[(WORLD_FILE, &store), (THUMBNAIL_FILE, b"no picture")]);
    for edit in edits.chunks_exact(EDIT) {
        change(&mut bytes, edit);
    }
    if flags & SEAL != 0 {
        container::seal(&mut bytes);
    }
    (bytes, inner_sealed)
}

/// Changes an archive as six bytes say.
pub(super) fn change(bytes: &mut Vec<u8>, edit: &[u8]) {
    let place = usize::from(edit[0]) | usize::from(edit[1]) << 8 | usize::from(edit[2]) << 16;
    let at = if edit[3] & 0x80 != 0 {
        place % bytes.len().max(1)
    } else {
        let heads: Vec<usize> = container::heads(bytes).into_iter().flatten().collect();
        heads.get(place % heads.len().max(1)).copied().unwrap_or(0)
    };
    if at >= bytes.len() {
        return;
    }
    match edit[3] & 7 {
        0 => bytes[at] ^= 1 << (edit[4] % 8),
        1 => bytes[at] = edit[4],
        2 => bytes[at] = bytes[at].wrapping_add(edit[4]),
        3 => bytes.truncate(at),
        4 => drop(bytes.splice(at..at, std::iter::repeat_n(edit[5], usize::from(edit[4])))),
        5 => drop(bytes.drain(at..bytes.len().min(at + usize::from(edit[4])))),
        _ => {
            let width = [1, 2, 4, 8][usize::from(edit[5] % 4)].min(bytes.len() - at);
            let edge = EDGES[usize::from(edit[4]) % EDGES.len()].to_le_bytes();
            bytes[at..at + width].copy_from_slice(&edge[..width]);
        }
    }
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let mut seeds: Vec<_> = plan::seeds()
        .into_iter()
        .map(|(name, plan)| (name, [&[SEAL], plan.as_slice()].concat()))
        .collect();
    seeds.push(("bare".to_owned(), vec![plan::RAW]));
    seeds.push((
        "raw".to_owned(),
        [&[plan::RAW], container::pack(&[]).as_slice()].concat(),
    ));
    seeds
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let inner = plan::mutate(rng, seed.get(1..).unwrap_or_default());
    let seal = u8::from(rng.u8(..16) > 0) * SEAL;
    let changes = if rng.u8(..7) > 0 { 0 } else { rng.u8(1..4) };
    let mut input = vec![seal | changes << 1];
    input.extend(std::iter::repeat_with(|| rng.u8(..)).take(usize::from(changes) * EDIT));
    // Half of the changed archives hold a sound store.
    input.extend(if changes > 0 && rng.bool() {
        vec![0; 4]
    } else {
        inner
    });
    input
}
