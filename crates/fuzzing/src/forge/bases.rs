//! The stores that forging begins with: of format 6, which kept all but the land in one value, and of format 7. They are
//! kept as files, so that a find means the same for ever; `antipode-fuzzing bases` writes those of today's format anew,
//! after which the finds in them need another look.

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
const FILES: [&[u8]; 4] = [
    include_bytes!("../../bases/closed.lz4"),
    include_bytes!("../../bases/killed.lz4"),
    include_bytes!("../../bases/closed-7.lz4"),
    include_bytes!("../../bases/killed-7.lz4"),
];

/// A world of two commits of everything, as closing or a kill leaves it, of format 7 or 6.
pub fn store(killed: bool, today: bool) -> &'static [u8] {
    static BYTES: [OnceLock<Vec<u8>>; 4] = [const { OnceLock::new() }; 4];
    let which = usize::from(killed) + 2 * usize::from(today);
    BYTES[which]
        .get_or_init(|| lz4_flex::decompress_size_prepended(FILES[which]).unwrap_or_default())
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
        chart: (chunk % 2) as u128,
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
        records: (&state(commit)).into(),
        chunks: (0..CHUNKS)
            .map(|chunk| (key(chunk), samples(chunk, commit)))
            .collect(),
        kinds: std::collections::BTreeMap::new(),
    }
}

/// Writes those of format 7 anew into a directory.
///
/// # Errors
/// Failures of the file system.
pub fn write(into: &Path) -> Result<(), Box<dyn Error>> {
    for close in [true, false] {
        let name = if close {
            "closed-7.lz4"
        } else {
            "killed-7.lz4"
        };
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
