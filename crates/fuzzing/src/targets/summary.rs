//! `summary.bin`, the one file of a world that is read for every world of a list.
//!
//! The first byte of an input says whether the rest is given its checksum.

use antipode_storage::{WorldMeta, WorldStore};
use fastrand::Rng;

use super::{Seen, Target, must};
use crate::forge::{bases, record};
use crate::mutation::{change_bytes, some};
use crate::world_folder::{VICTIM, WorldFolder, with_world_folder};

pub(super) const TARGET: Target = Target {
    name: "summary",
    run,
    seeds,
    mutate,
};

const FILE: &str = "summary.bin";
/// One in so many is repaired, too: that makes a store.
const REPAIRED: u32 = 256;

fn run(input: &[u8]) -> Result<Seen, String> {
    let mut bytes = input.get(1..).unwrap_or_default().to_vec();
    if input.first().is_some_and(|flags| flags & 1 != 0) {
        record::seal(&mut bytes);
    }
    with_world_folder(|folder| {
        folder
            .plant(FILE, &bytes)
            .map_err(|error| error.to_string())?;
        let listed = folder.saves().list().map_err(|error| error.to_string())?;
        let [world] = listed.as_slice() else {
            return Err(format!("{} worlds are listed", listed.len()));
        };
        must(world.problem.is_some(), || {
            "a world without a store is called sound".to_owned()
        })?;
        let taken = world.meta.is_some();
        let _ = folder.saves().verify(VICTIM);
        if crc32fast::hash(&bytes).is_multiple_of(REPAIRED) {
            repair(folder, world.meta.as_ref())?;
        }
        Ok(Seen {
            past_checksums: record::length(&bytes) == Some(bytes.len())
                && record::is_sealed(&bytes),
            taken,
        })
    })
}

/// A world of which only the summary is left is made anew from it.
fn repair(folder: &WorldFolder, meta: Option<&WorldMeta>) -> Result<(), String> {
    match (folder.saves().repair(VICTIM), meta) {
        (Ok(_), Some(meta)) => {
            let report = folder
                .saves()
                .verify(VICTIM)
                .map_err(|error| error.to_string())?;
            must(report.is_sound(), || {
                format!("after its repair: {:?}", report.problems)
            })?;
            let world = folder
                .saves()
                .open(VICTIM)
                .map_err(|error| error.to_string())?;
            // A number that is none is never equal to itself.
            must(format!("{:?}", world.meta()) == format!("{meta:?}"), || {
                "another world was made".to_owned()
            })
        }
        (Err(_), None) => Ok(()),
        (Ok(_), None) => Err("a world was made of nothing".to_owned()),
        (Err(error), Some(_)) => Err(format!("what is listed was not repaired: {error}")),
    }
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let now = with_world_folder(|folder| {
        folder.empty().map_err(|error| error.to_string())?;
        let dir = folder.saves().path().join(VICTIM);
        drop(WorldStore::create(&dir, &bases::meta()).map_err(|error| error.to_string())?);
        std::fs::read(dir.join(FILE)).map_err(|error| error.to_string())
    });
    let now = now.unwrap_or_default();
    let versions = [0_u16, 1, 2, 3, 4, 5, 6, 7, u16::MAX];
    let mut seeds: Vec<_> = versions
        .iter()
        .map(|version| {
            let mut bytes = [&[1], now.as_slice()].concat();
            bytes[1..3].copy_from_slice(&version.to_le_bytes());
            (format!("version-{version}"), bytes)
        })
        .collect();
    seeds.push(("now".to_owned(), [&[0], now.as_slice()].concat()));
    // The state, a chunk and a thing in the place of the meta record.
    let bases = [false, true].map(|today| bases::store(false, today));
    let others = bases.iter().flat_map(|base| {
        let records = record::records(base).into_iter();
        records.map(|range| &base[range])
    });
    for kind in 1..=4 {
        if let Some(other) = others.clone().find(|record| record[4] == kind) {
            seeds.push((format!("kind-{kind}"), [&[1], other].concat()));
        }
    }
    seeds
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let mut input = seed.to_vec();
    // Most changes are to the body, so that the record stays one.
    let keep = if rng.u8(..4) > 0 {
        1 + record::HEADER
    } else {
        1
    };
    let mut changed = input.split_off(keep.min(input.len()));
    let before = changed.len();
    for _ in 0..some(rng) {
        change_bytes(rng, &mut changed);
    }
    if keep > 1 && before > 0 && input.len() == keep {
        let key = usize::from(input[6]);
        let body = changed.len().saturating_sub(key) as u32;
        input[7..11].copy_from_slice(&body.to_le_bytes());
    }
    input.extend(changed);
    if let Some(flags) = input.first_mut() {
        *flags = u8::from(rng.u8(..5) > 0);
    }
    input
}
