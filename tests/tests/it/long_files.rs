//! A world whose file pretends to be as long as a disk: its repair ends, and fills none.
#![cfg(unix)]

use std::fs::{self, File};
use std::os::unix::fs::MetadataExt;
use std::path::Path;
use std::process::Command;

use antipode_storage::{
    Batch, CHUNK_SAMPLES, ChunkKey, SavesDir, WORLD_FILE, WorldMeta, pack_chunk,
};
use antipode_testing::may_skip;
use antipode_tests::program::binary;

const LONG_BYTES: u64 = 10 << 30;

/// Edits of a chunk.
fn edits(of: i16) -> Vec<i16> {
    (0..CHUNK_SAMPLES)
        .map(|i| of.wrapping_mul(i as i16))
        .collect()
}

/// Makes the world First of three chunks, of which one is damaged; where its file is.
fn damaged(dir: &Path) -> std::path::PathBuf {
    let meta = WorldMeta {
        name: "First".to_owned(),
        geometry: "euclidean".to_owned(),
        ..WorldMeta::default()
    };
    let (slug, world) = SavesDir::new(dir).create(&meta).unwrap();
    let chunk = |x: i16| {
        let key = ChunkKey {
            x: i32::from(x),
            ..ChunkKey::default()
        };
        (key, edits(x + 3))
    };
    let batch = Batch {
        chunks: (0..3).map(chunk).collect(),
        ..Batch::default()
    };
    world.commit(&batch).unwrap();
    drop(world);
    let path = dir.join(slug).join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    let packed = pack_chunk(&edits(4)).unwrap();
    let at = bytes.windows(packed.len()).position(|it| it == packed);
    bytes[at.unwrap() + packed.len() / 2] ^= 1;
    fs::write(&path, bytes).unwrap();
    path
}

/// What `antipode saves` says where no file may grow beyond 128 MB, and whether it has succeeded.
fn saves(dir: &Path, verb: &str) -> (bool, String) {
    let output = Command::new("sh")
        .args(["-c", "ulimit -f 131072; exec \"$@\"", "sh"])
        .arg(binary())
        .env_remove("ANTIPODE_SAVES")
        .arg("--saves-dir")
        .arg(dir)
        .args(["saves", verb, "First"])
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(said).unwrap())
}

#[test]
fn the_repair_of_ten_gigabytes_of_holes_ends_and_fills_no_disk() {
    let dir = tempfile::tempdir().unwrap();
    let path = damaged(dir.path());
    let file = File::options().write(true).open(&path).unwrap();
    let is_long = file.set_len(LONG_BYTES).is_ok();
    if !is_long || file.metadata().unwrap().blocks() * 512 > LONG_BYTES / 2 {
        may_skip("a file system that keeps holes");
        return;
    }
    drop(file);
    let (sound, said) = saves(dir.path(), "verify");
    // It is opened, and not given up from the first.
    assert!(
        !sound && said.contains("2 changed chunks are whole"),
        "{said}"
    );
    // It has ten minutes, after which it would be stopped.
    let (repaired, said) = saves(dir.path(), "repair");
    assert!(
        repaired && said.contains("2 changed chunks rescued"),
        "{said}"
    );
    let used = |path: &Path| fs::metadata(path).unwrap().blocks() * 512;
    let entries = fs::read_dir(path.parent().unwrap()).unwrap();
    let used_bytes: u64 = entries.map(|entry| used(&entry.unwrap().path())).sum();
    assert!(used_bytes < 16 << 20, "{used_bytes} bytes");
    let (sound, said) = saves(dir.path(), "verify");
    assert!(sound, "{said}");
}
