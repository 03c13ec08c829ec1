//! How long chunks take to pack and unpack, and a commit to become durable.
#![allow(clippy::unwrap_used, reason = "a bench fails by panicking")]

use antipode_storage::{
    Batch, CHUNK_SAMPLES, ChunkKey, WorldMeta, WorldStore, pack_chunk, unpack_chunk,
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
    let meta = WorldMeta {
        name: "Bench".to_owned(),
        ..WorldMeta::default()
    };
    let world = WorldStore::create(&dir.path().join("bench"), &meta).unwrap();
    let keys = (0..chunks).map(|x| ChunkKey {
        x,
        ..ChunkKey::default()
    });
    let batch = Batch {
        chunks: keys.map(|key| (key, edited())).collect(),
        ..Batch::default()
    };
    bencher.bench_local(|| world.commit(&batch).unwrap());
}

#[divan::bench(args = [100, 2000], sample_count = 10)]
fn open(bencher: divan::Bencher<'_, '_>, chunks: i32) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("bench");
    let meta = WorldMeta {
        name: "Bench".to_owned(),
        ..WorldMeta::default()
    };
    let keys = (0..chunks).map(|x| ChunkKey {
        x,
        ..ChunkKey::default()
    });
    let batch = Batch {
        chunks: keys.map(|key| (key, edited())).collect(),
        ..Batch::default()
    };
    WorldStore::create(&path, &meta)
        .unwrap()
        .commit(&batch)
        .unwrap();
    bencher.bench_local(|| WorldStore::open(&path).unwrap().meta());
}
