//! A world's store, through every door that the game has for it.
//!
//! An input is a [`plan`] of a forged store.

use antipode_storage::WorldStore;
use fastrand::Rng;

use super::{Seen, Target, must};
use crate::forge::{bases, plan};
use crate::world_folder::{VICTIM, WorldFolder, with_world_folder};

pub(super) const TARGET: Target = Target {
    name: "store",
    run,
    seeds: plan::seeds,
    mutate,
};

/// Chunks that are read of one world; no base has as many.
const MOST_READ: usize = 100;

fn run(input: &[u8]) -> Result<Seen, String> {
    let bytes = plan::store(input);
    with_world_folder(|folder| {
        let taken = try_every_door(folder, &bytes)?;
        Ok(Seen {
            past_checksums: plan::is_sealed(input, &bytes),
            taken,
        })
    })
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    plan::mutate(rng, seed)
}

/// Lists, verifies, exports, plays and repairs a world with this store; whether it opened.
///
/// # Errors
/// What was broken that must hold for any store.
pub fn try_every_door(folder: &WorldFolder, bytes: &[u8]) -> Result<bool, String> {
    let said = |error: &dyn std::fmt::Display| error.to_string();
    let dir = folder.plant_store(bytes).map_err(|error| said(&error))?;
    let saves = folder.saves();
    let listed = saves.list().map_err(|error| said(&error))?;
    must(listed.len() == 1, || {
        format!("{} worlds are listed", listed.len())
    })?;
    let verified = saves.verify(VICTIM);
    let sound = verified.is_ok_and(|report| report.is_sound());
    let archive = folder.beside("archive");
    if saves.export(VICTIM, &archive).is_ok() {
        let taken = import(folder, &archive)
            .map_err(|sentence| format!("what was exported: {sentence}"))?;
        must(taken, || "what was exported is not taken again".to_owned())?;
    }
    let played = WorldStore::open(&dir)
        .map_err(|error| said(&error))
        .and_then(|world| play(&world));
    if let (true, Err(error)) = (sound, &played) {
        return Err(format!(
            "a world that is called sound cannot be played: {error}"
        ));
    }
    // As it was, since opening may have mended it.
    folder.plant_store(bytes).map_err(|error| said(&error))?;
    if saves.repair(VICTIM).is_ok() {
        let report = saves
            .verify(VICTIM)
            .map_err(|error| format!("after its repair: {error}"))?;
        must(report.is_sound(), || {
            format!("after its repair: {:?}", report.problems)
        })?;
        let world = WorldStore::open(&dir).map_err(|error| format!("after its repair: {error}"))?;
        play(&world).map_err(|error| format!("after its repair it cannot be played: {error}"))?;
    }
    Ok(played.is_ok())
}

/// Reads all there is and goes on playing for three commits.
///
/// # Errors
/// Why those did not go well.
fn play(world: &WorldStore) -> Result<(), String> {
    let _ = world.problems();
    let _ = world.state();
    for key in world
        .edited_chunks()
        .unwrap_or_default()
        .iter()
        .take(MOST_READ)
    {
        let _ = world.chunk(key);
    }
    let mut batch = bases::batch(3);
    batch.chunks.truncate(2);
    batch.meta = Some(world.meta());
    (0..3)
        .try_for_each(|_| world.commit(&batch))
        .map_err(|error| error.to_string())
}

/// Imports a file; whether it was taken for a world, which is sound then.
///
/// # Errors
/// What was imported is damaged.
pub fn import(folder: &WorldFolder, archive: &std::path::Path) -> Result<bool, String> {
    let Ok(slug) = folder.saves().import(archive) else {
        return Ok(false);
    };
    let report = folder
        .saves()
        .verify(&slug)
        .map_err(|error| format!("it was imported, and then {error}"))?;
    must(report.is_sound(), || {
        format!("it was imported, and then {:?}", report.problems)
    })?;
    let world = folder
        .saves()
        .open(&slug)
        .map_err(|error| format!("it was imported, and then {error}"))?;
    play(&world)
        .map_err(|error| format!("it was imported, and then it cannot be played: {error}"))?;
    drop(world);
    folder
        .saves()
        .delete(&slug)
        .map_err(|error| error.to_string())?;
    Ok(true)
}
