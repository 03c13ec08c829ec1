//! Attacks on saves that must not cost anything: forged and damaged stores like those of
//! the targets, of one kind each, and what was committed is asked for afterwards.

use std::collections::BTreeMap;
use std::path::PathBuf;

use antipode_storage::{Record, RecordKey, WorldStore};

use crate::forge::pages::Part;
use crate::forge::{bases, plan, record};
use crate::targets::store::try_every_door;
use crate::targets::{Seen, Target, target};
use crate::world_folder::{VICTIM, WorldFolder, with_world_folder};

/// Where the index of a store is.
const INDEX: [Part; 5] = [
    Part::Count,
    Part::Pointer,
    Part::Offset,
    Part::Key,
    Part::Table,
];

/// The kind of a record that says what the world is.
const META: u8 = 1;

/// Every attack.
pub static ATTACKS: &[Target] = &[
    Target {
        name: "index-bits",
        run: nothing_is_lost,
        seeds: none,
        mutate: |rng, _| plan::flipped(rng, &INDEX),
    },
    Target {
        name: "bits",
        run: no_wrong_value,
        seeds: none,
        mutate: |rng, _| plan::flipped(rng, &Part::ALL),
    },
    Target {
        name: "forged-records",
        run: every_door,
        seeds: none,
        mutate: |rng, _| {
            let edits = 1 + rng.usize(..4);
            plan::forged(
                rng,
                &[Part::RecordHead, Part::RecordHead, Part::RecordBody],
                edits,
                true,
            )
        },
    },
    Target {
        name: "child-pointers",
        run: every_door,
        seeds: none,
        mutate: |rng, _| {
            let edits = 1 + rng.usize(..3);
            let seal = rng.bool();
            plan::forged(rng, &[Part::Pointer], edits, seal)
        },
    },
];

/// The attack or target of that name.
pub fn attack(name: &str) -> Option<&'static Target> {
    ATTACKS
        .iter()
        .find(|attack| attack.name == name)
        .or_else(|| target(name))
}

fn none() -> Vec<(String, Vec<u8>)> {
    vec![("sound".to_owned(), vec![0; 4])]
}

fn every_door(input: &[u8]) -> Result<Seen, String> {
    let bytes = plan::store(input);
    let taken = with_world_folder(|folder| try_every_door(folder, &bytes))?;
    Ok(Seen {
        past_checksums: plan::is_sealed(input, &bytes),
        taken,
    })
}

/// Leaves the victim with this store and the summary that every world has beside it.
fn plant(folder: &WorldFolder, bytes: &[u8]) -> Result<PathBuf, String> {
    let dir = folder
        .plant_store(bytes)
        .map_err(|error| error.to_string())?;
    let base = bases::store(false, true);
    let mut records = record::records(base).into_iter().map(|range| &base[range]);
    let meta = records
        .find(|record| record[4] == META)
        .ok_or("the base has no meta record")?;
    std::fs::write(dir.join("summary.bin"), meta).map_err(|error| error.to_string())?;
    Ok(dir)
}

/// A world with a damaged index is there as it was committed, at once or after a repair.
fn nothing_is_lost(input: &[u8]) -> Result<Seen, String> {
    let seen = every_door(input)?;
    let bytes = plan::store(input);
    with_world_folder(|folder| {
        let dir = plant(folder, &bytes)?;
        if what_lacks(input, &WorldStore::open(&dir)).is_none() {
            return Ok(());
        }
        plant(folder, &bytes)?;
        folder
            .saves()
            .repair(VICTIM)
            .map_err(|error| format!("it is not repaired: {error}"))?;
        match what_lacks(input, &WorldStore::open(&dir)) {
            None => Ok(()),
            Some(lack) => Err(format!("after its repair {lack}")),
        }
    })?;
    Ok(seen)
}

/// Which commit a world may be found as: a store that was killed cannot tell a damaged
/// last commit from one that never came to its end, and has the one before it then.
fn may_be(input: &[u8]) -> &'static [i32] {
    if plan::is_killed(input) {
        &[2, 1]
    } else {
        &[2]
    }
}

/// A damaged world may lack something; it never has anything that was not committed.
fn no_wrong_value(input: &[u8]) -> Result<Seen, String> {
    let seen = every_door(input)?;
    let bytes = plan::store(input);
    with_world_folder(|folder| {
        let dir = plant(folder, &bytes)?;
        committed_only(&dir)?;
        plant(folder, &bytes)?;
        let repaired = folder
            .saves()
            .repair(VICTIM)
            .map_err(|error| error.to_string());
        committed_only(&dir)?;
        repaired.map_err(|error| format!("one bit, and it is not repaired: {error}"))?;
        still_there(folder, may_be(input))
    })?;
    Ok(seen)
}

fn committed_only(dir: &std::path::Path) -> Result<(), String> {
    let Ok(world) = WorldStore::open(dir) else {
        return Ok(());
    };
    if world.meta() != bases::meta() {
        return Err(format!("it is called another world: {:?}", world.meta()));
    }
    let committed = [1, 2].map(things);
    let found = world.records().unwrap_or_default().known;
    if let Some((key, _)) = found
        .iter()
        .find(|(key, found)| committed.iter().all(|all| all.get(key) != Some(found)))
    {
        return Err(format!("{key} was never committed so"));
    }
    for chunk in 0..bases::CHUNKS {
        if let Ok(Some(found)) = world.chunk(&bases::key(chunk))
            && ![1, 2]
                .map(|commit| bases::samples(chunk, commit))
                .contains(&found)
        {
            return Err(format!("the edits of chunk {chunk} were never committed"));
        }
    }
    Ok(())
}

/// One bit costs one record at most, of which an older one comes back if there is one.
fn still_there(folder: &WorldFolder, commits: &[i32]) -> Result<(), String> {
    let world = folder
        .saves()
        .open(VICTIM)
        .map_err(|error| error.to_string())?;
    let found = world.records().map_err(|error| error.to_string())?.known;
    let lost = |commit: i32| {
        let chunks = (0..bases::CHUNKS).filter(|chunk| !is_of(&world, *chunk, commit));
        let things = things(commit);
        let gone = things.iter().filter(|(key, it)| found.get(key) != Some(it));
        chunks.count() + gone.count()
    };
    match commits.iter().map(|commit| lost(*commit)).min() {
        Some(0 | 1) => Ok(()),
        lost => Err(format!(
            "one bit, and {lost:?} records are not as they were"
        )),
    }
}

/// The records of a commit but for the land.
fn things(commit: i32) -> BTreeMap<RecordKey, Record> {
    bases::state(commit).to_records().collect()
}

fn is_of(world: &WorldStore, chunk: i32, commit: i32) -> bool {
    matches!(world.chunk(&bases::key(chunk)), Ok(Some(found)) if found == bases::samples(chunk, commit))
}

/// What an opened world lacks of its last commit, if anything.
fn what_lacks<E: std::fmt::Display>(input: &[u8], world: &Result<WorldStore, E>) -> Option<String> {
    let world = match world {
        Ok(world) => world,
        Err(error) => return Some(format!("it does not open: {error}")),
    };
    if let Some(problem) = world.problems().first() {
        return Some(problem.clone());
    }
    if world.meta() != bases::meta() {
        return Some("it is another world".to_owned());
    }
    let Ok(Some(state)) = world.state() else {
        return Some("it has no state".to_owned());
    };
    let Some(commit) = may_be(input)
        .iter()
        .find(|commit| bases::state(**commit) == state)
    else {
        return Some(format!("its state is that of {} s", state.simulated_s));
    };
    (0..bases::CHUNKS)
        .find(|chunk| !is_of(world, *chunk, *commit))
        .map(|chunk| format!("chunk {chunk} is not as in commit {commit}"))
}
