//! How long chunks take to pack and unpack, a commit to become durable, the check of every
//! page that goes before each opening, and the list of worlds.
#![allow(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::fs;
use std::path::Path;

use antipode_storage::{
    Batch, CHUNK_SAMPLES, ChunkKey, LampRecord, Record, RecordChanges, RecordKind, SavesDir,
    WORLD_FILE, WorldMeta, WorldState, WorldStore, check_pages, pack_chunk, unpack_chunk,
};

fn main() {
    divan::main();
}

/// A chunk with one stroke of the default brush in its middle.
fn edited() -> Vec<i16> {
    let sample = |index: usize| {
        let offset = |i: usize| i as f64 - 15.6;
        let d2 = offset(index % 32).powi(2)
            + offset(index / 32 % 32).powi(2)
            + offset(index / 1024).powi(2);
        if d2 <= 25.0 {
            (2048.0 * (-0.1 * d2).exp()) as i16
        } else {
            0
        }
    };
    (0..CHUNK_SAMPLES).map(sample).collect()
}

fn meta(name: &str) -> WorldMeta {
    WorldMeta {
        name: name.to_owned(),
        ..WorldMeta::default()
    }
}

fn key(x: i32) -> ChunkKey {
    ChunkKey {
        x,
        ..ChunkKey::default()
    }
}

fn batch(chunks: i32) -> Batch {
    Batch {
        chunks: (0..chunks).map(|x| (key(x), edited())).collect(),
        ..Batch::default()
    }
}

#[divan::bench]
fn pack(bencher: divan::Bencher<'_, '_>) {
    let samples = edited();
    bencher.bench_local(|| pack_chunk(divan::black_box(&samples)).unwrap());
}

#[divan::bench]
fn unpack(bencher: divan::Bencher<'_, '_>) {
    let packed = pack_chunk(&edited()).unwrap();
    bencher.bench_local(|| unpack_chunk(divan::black_box(&packed)).unwrap());
}

#[divan::bench(args = [1, 8, 64], sample_count = 20)]
fn commit(bencher: divan::Bencher<'_, '_>, chunks: i32) {
    let dir = tempfile::tempdir().unwrap();
    let world = WorldStore::create(&dir.path().join("bench"), &meta("Bench")).unwrap();
    let batch = batch(chunks);
    bencher.bench_local(|| world.commit(&batch).unwrap());
}

#[divan::bench(args = [100, 2000], sample_count = 10)]
fn open(bencher: divan::Bencher<'_, '_>, chunks: i32) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("bench");
    WorldStore::create(&path, &meta("Bench"))
        .unwrap()
        .commit(&batch(chunks))
        .unwrap();
    bencher.bench_local(|| WorldStore::open(&path).unwrap().meta());
}

/// A step of walking, which changes the player and the time, in a world with so many lamps.
#[divan::bench(args = [0, 100_000], sample_count = 100)]
fn commit_step_among(bencher: divan::Bencher<'_, '_>, lamps: u32) {
    let dir = tempfile::tempdir().unwrap();
    let world = WorldStore::create(&dir.path().join("bench"), &meta("Bench")).unwrap();
    let lamp = |id| {
        let lamp = Record::Lamp(LampRecord::default());
        (RecordKind::Lamp.numbered(id), Some(lamp))
    };
    let state = RecordChanges::from(&WorldState::default());
    world
        .commit(&Batch {
            records: state.into_iter().chain((0..lamps).map(lamp)).collect(),
            ..Batch::default()
        })
        .unwrap();
    let mut step = 0_i32;
    bencher.bench_local(|| {
        step += 1;
        let mut records = RecordChanges::from(&WorldState {
            simulated_s: f64::from(step),
            ..WorldState::default()
        });
        records.remove(&RecordKind::View.numbered(0));
        let batch = Batch {
            records,
            ..Batch::default()
        };
        world.commit(&batch).unwrap();
    });
}

/// How a chunk was dug, which decides how many pages a store of one length has.
#[derive(Debug, Clone, Copy)]
enum Dug {
    /// One stroke in each chunk: records of some kilobytes.
    Little,
    /// Every sample changed by an amount of its own: the longest records there are.
    Wholly,
}

/// A closed world whose file is at least so many megabytes long.
fn long_world(dir: &Path, megabytes: u64, dug: Dug) {
    let mut rng: u64 = 1;
    let mut noise = || {
        rng = rng
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (rng >> 48) as i16
    };
    let mut chunk = || match dug {
        Dug::Little => edited(),
        Dug::Wholly => (0..CHUNK_SAMPLES).map(|_| noise()).collect(),
    };
    let world = WorldStore::create(dir, &meta("Long")).unwrap();
    let mut x = 0;
    while fs::metadata(dir.join(WORLD_FILE)).unwrap().len() < megabytes << 20 {
        let chunks = (0..200).map(|_| {
            x += 1;
            (key(x), chunk())
        });
        let batch = Batch {
            chunks: chunks.collect(),
            ..Batch::default()
        };
        world.commit(&batch).unwrap();
    }
}

/// The bar is half a second for a file of 100 MB; that no page is read twice is a test.
#[divan::bench(args = [Dug::Little, Dug::Wholly], sample_count = 20)]
fn check_100_mb(bencher: divan::Bencher<'_, '_>, dug: Dug) {
    let dir = tempfile::tempdir().unwrap();
    long_world(dir.path(), 100, dug);
    let path = dir.path().join(WORLD_FILE);
    bencher.bench_local(|| check_pages(&path).unwrap());
}

/// The check, opening, and the look at every record: what a player waits for.
#[divan::bench(args = [Dug::Little, Dug::Wholly], sample_count = 10)]
fn open_100_mb(bencher: divan::Bencher<'_, '_>, dug: Dug) {
    let dir = tempfile::tempdir().unwrap();
    long_world(dir.path(), 100, dug);
    bencher.bench_local(|| WorldStore::open(dir.path()).unwrap().meta());
}

/// The bar is half a second; how little is read of each is a test.
#[divan::bench(sample_count = 20)]
fn list_200_worlds(bencher: divan::Bencher<'_, '_>) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    for number in 0..200 {
        let world = dir.path().join(format!("world-{number}"));
        let world = WorldStore::create(&world, &meta(&format!("World {number}"))).unwrap();
        world.commit(&batch(100)).unwrap();
    }
    bencher.bench_local(|| assert_eq!(saves.list().unwrap().len(), 200));
}
