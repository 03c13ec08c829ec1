//! Power cuts and torn copies: every write to a store's file is recorded, and the file is
//! put together again as it may be found after the power went, or as a program copied it
//! that did not wait. `ANTIPODE_TEST_CUTS=250` and `ANTIPODE_TEST_TORN=300` are the long forms.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod disk;

use std::fs;
use std::path::Path;

use proptest::prelude::RngExt as _;
use proptest::test_runner::{RngAlgorithm, TestRng};

use crate::batch::{sealed_chunk, sealed_meta, sealed_record};
use crate::schema::{ChunkKey, WorldMeta, WorldState};
use crate::store::Store;
use crate::world::WorldStore;
use crate::{CHUNK_SAMPLES, SavesDir, WORLD_FILE, pack_chunk};
use disk::{Disk, Event};

const CHUNKS: i32 = 24;
/// Chunks that one commit changes.
const CHANGED: i32 = 5;
const COMMITS: i32 = 40;
/// Writes that happen while 64 KiB are copied: there are about 20 in a commit, and as
/// many reads in a copy.
const MOST_PACE: f64 = 1.5;

fn meta() -> WorldMeta {
    WorldMeta {
        name: "Cut".to_owned(),
        ..WorldMeta::default()
    }
}

fn state(commit: i32) -> WorldState {
    WorldState {
        simulated_s: f64::from(commit),
        ..WorldState::default()
    }
}

fn key(chunk: i32) -> ChunkKey {
    ChunkKey {
        x: chunk,
        ..ChunkKey::default()
    }
}

/// Which chunks a commit changes: others each time, and all by the fifth.
fn changed(commit: i32) -> impl Iterator<Item = i32> {
    (0..CHANGED).map(move |n| (commit * CHANGED + n) % CHUNKS)
}

/// The last commit up to this one that changed a chunk, if any did.
fn last_change(chunk: i32, commit: i32) -> Option<i32> {
    (1..=commit)
        .rev()
        .find(|commit| changed(*commit).any(|one| one == chunk))
}

/// Edits whose packed length differs with chunk and commit.
fn samples(chunk: i32, commit: i32) -> Vec<i16> {
    let busy = 200 + 90 * ((chunk * 7 + commit * 3) % 40) as usize;
    let sample = |i: usize| {
        if i < busy {
            (i * i) as i16 ^ (commit as i16)
        } else {
            chunk as i16
        }
    };
    (0..CHUNK_SAMPLES).map(sample).collect()
}

/// Everything that a game of so many commits has written, and where each was durable.
fn played() -> Vec<Event> {
    let disk = Disk::default();
    let log = disk.log();
    let path = Path::new("recorded");
    let db = redb::Builder::new().create_with_backend(disk).unwrap();
    let store = Store::of(path, "Cut", db);
    for commit in 1..=COMMITS {
        let sequence = commit as u64;
        let mut puts = vec![sealed_meta(&meta(), sequence, "Cut").unwrap()];
        for (key, record) in state(commit).to_records() {
            puts.push(sealed_record(key, Some(&record), sequence, "Cut").unwrap());
        }
        puts.extend(changed(commit).map(|chunk| {
            let body = pack_chunk(&samples(chunk, commit)).unwrap();
            sealed_chunk(key(chunk), sequence, &body)
        }));
        store.write(&puts).unwrap();
        log.lock().unwrap().push(Event::Committed(commit));
    }
    drop(store);
    let log = log.lock().unwrap();
    log.clone()
}

/// The last commit that was durable before an event.
fn durable(log: &[Event], before: usize) -> Option<i32> {
    log[..before].iter().rev().find_map(|event| match event {
        Event::Committed(commit) => Some(*commit),
        _ => None,
    })
}

/// A world with this file.
fn planted(bytes: &[u8]) -> (tempfile::TempDir, SavesDir) {
    let root = tempfile::tempdir().unwrap();
    fs::create_dir(root.path().join("cut")).unwrap();
    fs::write(root.path().join("cut").join(WORLD_FILE), bytes).unwrap();
    let summary = sealed_meta(&meta(), 1, "Cut").unwrap().bytes.unwrap();
    crate::summary::replace(&root.path().join("cut"), &summary).unwrap();
    let saves = SavesDir::new(root.path());
    (root, saves)
}

/// What a world holds that was opened without a complaint: all of one commit, whose number it is.
fn whole_commit(world: &WorldStore) -> i32 {
    assert_eq!(world.problems(), Vec::<String>::new());
    assert_eq!(world.meta(), meta());
    let found = world.state().unwrap().unwrap().simulated_s as i32;
    for chunk in 0..CHUNKS {
        let expected = last_change(chunk, found).map(|commit| samples(chunk, commit));
        assert_eq!(
            world.chunk(&key(chunk)).unwrap(),
            expected,
            "chunk {chunk} of commit {found}"
        );
    }
    found
}

fn asked_for(variable: &str, usual: usize) -> usize {
    std::env::var(variable).map_or(usual, |count| count.parse().unwrap())
}

fn dice() -> TestRng {
    TestRng::from_seed(RngAlgorithm::ChaCha, &[18; 32])
}

#[test]
fn a_power_cut_at_any_moment_leaves_the_last_commit() {
    let log = played();
    let first = log
        .iter()
        .position(|event| *event == Event::Committed(1))
        .unwrap()
        + 1;
    let mut dice = dice();
    for cut in 0..asked_for("ANTIPODE_TEST_CUTS", 30) {
        let at = dice.random_range(first..=log.len());
        let bytes = disk::after_a_cut(&log[..at], &mut dice);
        let durable = durable(&log, at).unwrap();
        let (_root, saves) = planted(&bytes);
        let world = saves
            .open("cut")
            .unwrap_or_else(|error| panic!("cut {cut} at {at}: {error}"));
        let found = whole_commit(&world);
        assert!(
            (durable..=durable + 1).contains(&found),
            "cut {cut} at {at}: {durable} was durable, {found} is found"
        );
        let next = crate::Batch {
            records: (&state(found + 1)).into(),
            ..Default::default()
        };
        world.commit(&next).unwrap();
        drop(world);
        assert!(saves.verify("cut").unwrap().is_sound(), "cut {cut} at {at}");
    }
}

#[test]
fn a_copy_made_while_the_game_writes_is_a_world() {
    let log = played();
    let mut dice = dice();
    let (mut opened, mut lost) = (0, Vec::new());
    let copies = asked_for("ANTIPODE_TEST_TORN", 30);
    for copy in 0..copies {
        let begin = dice.random_range(log.len() / 4..log.len());
        // From front to back while the game commits once or twice.
        let pace = dice.random_range(0.0..MOST_PACE);
        let bytes = disk::torn_copy(&log, begin, pace);
        let durable = durable(&log, begin).unwrap();
        let (_root, saves) = planted(&bytes);
        if saves.verify("cut").unwrap().is_sound() {
            let found = whole_commit(&saves.open("cut").unwrap());
            assert!(
                found >= durable,
                "copy {copy}: {durable} was durable, {found} is found"
            );
            opened += 1;
            continue;
        }
        saves
            .repair("cut")
            .unwrap_or_else(|error| panic!("copy {copy} from {begin} at {pace}: {error}"));
        assert!(saves.verify("cut").unwrap().is_sound());
        let world = saves.open("cut").unwrap();
        assert_eq!(world.meta(), meta());
        for chunk in 0..CHUNKS {
            let Some(expected) = last_change(chunk, durable) else {
                continue;
            };
            let found = world.chunk(&key(chunk)).unwrap();
            if !(expected..=COMMITS).any(|commit| found == Some(samples(chunk, commit))) {
                lost.push((copy, chunk));
            }
        }
    }
    println!(
        "{copies} torn copies: {opened} opened as they were, the others were repaired; lost (copy, chunk): {lost:?}"
    );
    assert_eq!(lost, []);
}
