//! A world that is repaired and played at once: what is saved stays saved.

use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use crate::common::{batch, key, meta, samples};
use antipode_storage::{Batch, SavesDir, StorageError, WORLD_FILE};

/// Enough that a repair takes longer than opening waits.
const CHUNKS: i32 = 1000;

/// A saves directory whose world `w` opens, though one of its chunks is damaged.
fn damaged() -> (tempfile::TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let (slug, world) = saves.create(&meta("W")).unwrap();
    world.commit(&batch(CHUNKS, 1)).unwrap();
    drop(world);
    let path = dir.path().join(slug).join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    let mark = bytes.windows(3).rposition(|at| at == b"Ap\x03").unwrap();
    // In the body, behind a header of 22 bytes whose mark is its third, and the key.
    bytes[mark + 50] ^= 1;
    fs::write(&path, bytes).unwrap();
    (dir, saves)
}

#[test]
fn what_is_saved_while_a_repair_runs_is_there_after_it() {
    let (_dir, saves) = damaged();
    let over = AtomicBool::new(false);
    let saved = thread::scope(|scope| {
        let player = scope.spawn(|| {
            let mut saved = 0;
            while !over.load(Ordering::Relaxed) {
                let world = match saves.open("w") {
                    Ok(world) => world,
                    Err(StorageError::InUse { .. }) => continue,
                    Err(error) => panic!("{error}"),
                };
                let next = Batch {
                    chunks: vec![(key(CHUNKS + saved), samples(saved, 2))],
                    ..Batch::default()
                };
                // The file in the place of the opened one is told of; nothing was saved then.
                saved += i32::from(world.commit(&next).is_ok());
            }
            saved
        });
        while matches!(saves.repair("w"), Err(StorageError::InUse { .. })) {}
        over.store(true, Ordering::Relaxed);
        player.join().unwrap()
    });
    let world = saves.open("w").unwrap();
    let lost: Vec<_> = (0..saved)
        .filter(|&x| world.chunk(&key(CHUNKS + x)).ok().flatten().is_none())
        .collect();
    assert!(lost.is_empty(), "{lost:?} of {saved} commits are lost");
}

#[test]
fn a_world_in_use_is_not_repaired() {
    let (dir, saves) = damaged();
    let world = saves.open("w").unwrap();
    let refusal = saves.repair("w").unwrap_err();
    assert!(matches!(refusal, StorageError::InUse { .. }), "{refusal}");
    assert!(!dir.path().join("w/world.redb.damaged-1").exists());
    drop(world);
    let report = saves.repair("w").unwrap();
    assert_eq!(report.chunks + report.losses.len(), CHUNKS as usize);
    assert!(saves.verify("w").unwrap().is_sound());
}
