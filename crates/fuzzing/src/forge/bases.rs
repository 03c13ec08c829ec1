//! The stores that forging begins with. They are kept as files, so that a find means the
//! same for ever; `antipode-fuzzing bases` writes them anew, after which the old finds
//! need another look.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use antipode_storage::{
    Batch, BotRecord, CHUNK_SAMPLES, CarRecord, ChunkKey, LampRecord, SlotRecord, WORLD_FILE,
    WorldMeta, WorldState, WorldStore,
};

/// Chunks in each, in two or three leaves under one branch.
pub const CHUNKS: i32 = 16;
const CLOSED: &[u8] = include_bytes!("../../bases/closed.lz4");
const KILLED: &[u8] = include_bytes!("../../bases/killed.lz4");

/// A world that was closed: two commits of everything.
pub fn closed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| lz4_flex::decompress_size_prepended(CLOSED).unwrap_or_default())
}

/// The same as a kill leaves it.
pub fn killed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| lz4_flex::decompress_size_prepended(KILLED).unwrap_or_default())
}

/// What the worlds are.
pub fn meta() -> WorldMeta {
    WorldMeta {
        name: "Victim".to_owned(),
        seed: 7,
        geometry: "spherical".to_owned(),
        radius_m: 32.0,
        ..WorldMeta::default()
    }
}

/// The state of a commit: one of everything.
pub fn state(commit: i32) -> WorldState {
    WorldState {
        inventory: vec![SlotRecord {
            slot: 1,
            item: "lamp".to_owned(),
            count: 3,
        }],
        map: "raised".to_owned(),
        simulated_s: f64::from(commit),
        lamps: vec![LampRecord::default()],
        bots: vec![BotRecord::default()],
        cars: vec![CarRecord::default()],
        driving: Some(0),
        ..WorldState::default()
    }
}

/// The key of one of the chunks, half of them in each hemisphere.
pub fn key(chunk: i32) -> ChunkKey {
    ChunkKey {
        hemisphere: (chunk % 2) as u8,
        x: chunk - 8,
        y: -1,
        z: 3,
    }
}

/// The edits of a chunk in a commit.
pub fn samples(chunk: i32, commit: i32) -> Vec<i16> {
    let sample = |i: usize| {
        if i / 64 == 9 {
            (chunk * 31 + commit * 7) as i16
        } else {
            0
        }
    };
    (0..CHUNK_SAMPLES).map(sample).collect()
}

/// A batch of everything.
pub fn batch(commit: i32) -> Batch {
    Batch {
        meta: None,
        state: Some(state(commit)),
        chunks: (0..CHUNKS)
            .map(|chunk| (key(chunk), samples(chunk, commit)))
            .collect(),
    }
}

/// Writes both anew into a directory.
///
/// # Errors
/// Failures of the file system.
pub fn write(into: &Path) -> Result<(), Box<dyn Error>> {
    for close in [true, false] {
        let name = if close { "closed.lz4" } else { "killed.lz4" };
        let dir = into.join("making");
        let world = WorldStore::create(&dir, &meta())?;
        world.commit(&batch(1))?;
        world.commit(&batch(2))?;
        let path = dir.join(WORLD_FILE);
        let open = (!close).then_some(world);
        let bytes = fs::read(&path)?;
        drop(open);
        fs::write(into.join(name), lz4_flex::compress_prepend_size(&bytes))?;
        fs::remove_dir_all(&dir)?;
    }
    Ok(())
}
