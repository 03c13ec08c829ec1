//! Truncated, flipped and foreign files: always a world or a sentence, never a
//! panic and never a wrong value.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use crate::common::{batch, key, meta, samples, state};
use antipode_storage::{ChunkKey, SavesDir, StorageError, WORLD_FILE, WorldStore};
use proptest::prelude::*;
use tempfile::TempDir;

const CHUNKS: i32 = 12;

/// The bytes of a closed world of two commits.
fn closed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| made(true))
}

/// The bytes of a world as a kill leaves it.
fn killed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| made(false))
}

fn made(close: bool) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let world = WorldStore::create(dir.path(), &meta("Victim")).unwrap();
    world.commit(&batch(CHUNKS, 1)).unwrap();
    world.commit(&batch(CHUNKS, 2)).unwrap();
    let path = dir.path().join(WORLD_FILE);
    if close {
        drop(world);
    }
    fs::read(path).unwrap()
}

/// A saves directory that holds one world, `victim`, with these bytes for its store.
fn planted(bytes: &[u8]) -> (TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let world = dir.path().join("victim");
    fs::create_dir(&world).unwrap();
    fs::write(world.join(WORLD_FILE), bytes).unwrap();
    let saves = SavesDir::new(dir.path());
    (dir, saves)
}

/// Uses a damaged world in every way; whatever it yields must be what was
/// committed, once or the other time.
fn use_it(saves: &SavesDir) {
    for summary in saves.list().unwrap() {
        assert!(summary.meta.is_none_or(|found| found == meta("Victim")));
    }
    read_it(&saves.path().join("victim"), false);
    let verified = saves.verify("victim");
    assert!(verified.is_ok(), "{verified:?}");
    if saves.repair("victim").is_ok() {
        let after = saves.verify("victim").unwrap();
        assert!(after.is_sound(), "{after:?}");
        read_it(&saves.path().join("victim"), true);
    }
}

/// Every record is as it was committed, once or the other time. What is damaged is left out, and told until it is
/// repaired; of what is not, all is of one commit.
fn read_it(dir: &Path, repaired: bool) {
    let Ok(world) = WorldStore::open(dir) else {
        return;
    };
    assert_eq!(world.meta(), meta("Victim"));
    let committed = [1.0, 2.0].map(|at| state(at).to_records().collect::<Vec<_>>());
    for found in world.records().into_iter().flat_map(|it| it.known) {
        assert!(
            committed.iter().any(|all| all.contains(&found)),
            "{found:?}"
        );
    }
    if let (Ok(Some(found)), true, false) = (world.state(), world.problems().is_empty(), repaired) {
        assert!([state(1.0), state(2.0)].contains(&found));
    }
    for x in 0..CHUNKS {
        if let Ok(Some(found)) = world.chunk(&key(x)) {
            assert!([samples(x, 1), samples(x, 2)].contains(&found), "chunk {x}");
        }
    }
    // Going on playing may fail, but not with a panic.
    let _ = world.commit(&batch(2, 2));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_world_cut_anywhere_gives_a_sentence(at: prop::sample::Index, close: bool) {
        let bytes = if close { closed() } else { killed() };
        let (_dir, saves) = planted(&bytes[..at.index(bytes.len())]);
        use_it(&saves);
    }

    #[test]
    fn a_world_with_flipped_bits_gives_its_values_or_a_sentence(
        bits in prop::collection::vec(any::<prop::sample::Index>(), 1..4), close: bool, used_only: bool,
    ) {
        let mut bytes = if close { closed() } else { killed() }.to_vec();
        // Most of a small store is unused; half of the cases hit what is not zero.
        let used: Vec<usize> = (0..bytes.len()).filter(|&i| !used_only || bytes[i] != 0).collect();
        for bit in bits {
            let bit = bit.index(used.len() * 8);
            bytes[used[bit / 8]] ^= 1 << (bit % 8);
        }
        let (_dir, saves) = planted(&bytes);
        use_it(&saves);
    }

    #[test]
    fn a_world_with_a_part_overwritten_gives_a_sentence(
        at: prop::sample::Index, rubbish in prop::collection::vec(any::<u8>(), 1..6000), close: bool,
    ) {
        let mut bytes = if close { closed() } else { killed() }.to_vec();
        let at = at.index(bytes.len());
        let end = bytes.len().min(at + rubbish.len());
        bytes[at..end].copy_from_slice(&rubbish[..end - at]);
        let (_dir, saves) = planted(&bytes);
        use_it(&saves);
    }

    #[test]
    fn a_foreign_file_gives_a_sentence(rubbish in prop::collection::vec(any::<u8>(), 0..9000), header: bool) {
        let mut bytes = rubbish;
        if header {
            bytes.splice(0..0, closed()[..64].iter().copied());
        }
        let (_dir, saves) = planted(&bytes);
        use_it(&saves);
    }
}

/// The beginnings of all records of a key in a closed store.
fn records<'a>(bytes: &'a [u8], stored_key: &[u8]) -> impl Iterator<Item = &'a [u8]> {
    let positions = bytes.windows(stored_key.len()).enumerate();
    let found = positions.filter(move |(at, window)| {
        *window == stored_key && *at >= 22 && bytes[at - 20..at - 18] == *b"Ap"
    });
    found.map(|(at, _)| &bytes[at - 20..at + 40])
}

/// Flips a bit in the middle of the newest record of `key` in a closed store.
fn flip_in_record(bytes: &mut [u8], stored_key: &[u8]) {
    let positions = bytes.windows(stored_key.len()).enumerate();
    let found: Vec<usize> = positions
        .filter(|(_, window)| *window == stored_key)
        .map(|(at, _)| at)
        .collect();
    assert!(!found.is_empty());
    for at in found {
        // Inside a record the key stands 22 bytes after its start; the index has no such mark.
        if at >= 22 && bytes[at - 20..at - 18] == *b"Ap" {
            bytes[at + stored_key.len() + 5] ^= 0x10;
        }
    }
}

/// A chunk key as stored: hemisphere, then x, y, z big-endian with the sign flipped.
fn stored(key: ChunkKey) -> Vec<u8> {
    let words = [key.x, key.y, key.z].map(|index| ((index as u32) ^ 0x8000_0000).to_be_bytes());
    [&[key.chart as u8][..], words.as_flattened()].concat()
}

#[test]
fn a_damaged_chunk_is_told_and_the_rest_goes_on() {
    let mut bytes = closed().to_vec();
    flip_in_record(&mut bytes, &stored(key(4)));
    let (_dir, saves) = planted(&bytes);
    let world = saves.open("victim").unwrap();
    let error = world.chunk(&key(4)).unwrap_err();
    assert!(matches!(error, StorageError::Damaged { .. }));
    assert!(
        error
            .to_string()
            .contains("\"Victim\" chunk A (4, -1, 3) is damaged"),
        "{error}"
    );
    assert_eq!(world.problems(), [error.to_string()]);
    assert_eq!(world.chunk(&key(5)).unwrap(), Some(samples(5, 2)));
    assert_eq!(world.edited_chunks().unwrap().len(), CHUNKS as usize);
    // Editing it again makes it whole.
    let edit = |n| antipode_storage::Batch {
        chunks: vec![(key(n), samples(n, 9))],
        ..Default::default()
    };
    let kept = world.dir().join("world.redb.damaged-1");
    world.commit(&edit(5)).unwrap();
    assert!(!kept.exists());
    world.commit(&edit(4)).unwrap();
    assert_eq!(world.chunk(&key(4)).unwrap(), Some(samples(4, 9)));
    assert!(world.problems().is_empty());
    // What was there before is not lost: its record is in the file that was kept, as it was.
    let old = fs::read(&kept).unwrap();
    let damaged: Vec<_> = records(&bytes, &stored(key(4))).collect();
    assert!(!damaged.is_empty());
    for record in damaged {
        assert!(old.windows(record.len()).any(|window| window == record));
    }
    world.commit(&edit(4)).unwrap();
    assert!(!world.dir().join("world.redb.damaged-2").exists());
}

#[test]
fn repair_keeps_the_damaged_file_and_everything_else() {
    let mut bytes = closed().to_vec();
    flip_in_record(&mut bytes, &stored(key(4)));
    let (dir, saves) = planted(&bytes);
    assert!(!saves.verify("victim").unwrap().is_sound());
    let damaged = fs::read(dir.path().join("victim").join(WORLD_FILE)).unwrap();
    let report = saves.repair("victim").unwrap();
    let kept = report.kept.unwrap();
    assert!(kept.ends_with("world.redb.damaged-1"));
    assert_eq!(fs::read(kept).unwrap().len(), damaged.len());
    assert_eq!(
        (report.chunks, report.has_state, report.losses.len()),
        (CHUNKS as usize - 1, true, 1)
    );
    assert!(
        report.losses[0].contains("chunk A (4, -1, 3)"),
        "{:?}",
        report.losses
    );
    let world = saves.open("victim").unwrap();
    assert_eq!(world.chunk(&key(4)).unwrap(), None);
    assert_eq!(world.chunk(&key(5)).unwrap(), Some(samples(5, 2)));
    assert_eq!(world.state().unwrap(), Some(state(2.0)));
}

#[test]
fn a_store_without_its_index_is_salvaged_record_by_record() {
    let mut bytes = closed().to_vec();
    bytes[..4096].fill(0xff);
    let (dir, saves) = planted(&bytes);
    let problem = saves.open("victim").map(drop).unwrap_err().to_string();
    assert!(problem.contains("saves repair"), "{problem}");
    let report = saves.repair("victim").unwrap();
    assert_eq!((report.chunks, report.has_state), (CHUNKS as usize, true));
    let world = saves.open("victim").unwrap();
    for x in 0..CHUNKS {
        assert_eq!(world.chunk(&key(x)).unwrap(), Some(samples(x, 2)));
    }
    assert_eq!(world.meta(), meta("Victim"));
    drop(world);
    let entries = fs::read_dir(dir.path()).unwrap();
    // The lock of the directory stays.
    let names = entries.map(|entry| entry.unwrap().file_name());
    let names: Vec<_> = names.filter(|name| name != ".antipode.lock").collect();
    assert_eq!(names, ["victim"], "no scratch directory stays");
}

#[test]
fn a_file_with_nothing_of_ours_is_left_alone() {
    let (dir, saves) = planted(&[7; 5000]);
    let error = saves.repair("victim").unwrap_err();
    assert!(
        matches!(error, StorageError::Unsalvageable { .. }),
        "{error}"
    );
    assert_eq!(
        fs::read(dir.path().join("victim").join(WORLD_FILE)).unwrap(),
        [7; 5000]
    );
}
