//! Records of kinds that this version knows and of others, and how much a commit writes.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::fs;
use std::path::Path;

use super::*;
use crate::codec::Kind;
use crate::schema::SCHEMA_VERSION;
use crate::store::{Put, Store};
use crate::{Batch, ChunkKey, SavesDir, WORLD_FILE, WorldMeta, WorldState, WorldStore};

fn meta() -> WorldMeta {
    WorldMeta {
        name: "Kinds".to_owned(),
        ..WorldMeta::default()
    }
}

fn lamp(id: u32) -> (RecordKey, Option<Record>) {
    let kind = RecordKind::Lamp;
    let lamp = LampRecord {
        chart: (id % 2).into(),
        pos: [f64::from(id), 0.0, 0.0],
    };
    (kind.numbered(id), Some(Record::Lamp(lamp)))
}

/// The record of a kind by its name, as some game has written it.
fn strange(name: &str, id: u64, version: u16, body: &[u8]) -> Put {
    let key = [&[name.len() as u8], name.as_bytes(), &id.to_be_bytes()].concat();
    let bytes = codec::seal(version, Kind::Record, &key, 1, body);
    Put {
        kind: Kind::Record,
        key,
        bytes: Some(bytes),
    }
}

/// What a later game may have left: a kind of its own, a later lamp, and a lamp and land in a chart with a name.
fn later() -> Vec<Put> {
    let chart = [&[20_u8][..], &[7; 20]].concat();
    let far = [&chart[..], &[0; 24]].concat();
    let key = [&chart[..], &[0x80; 12]].concat();
    assert!(ChunkKey::is_of_named_chart(&key) && ChunkKey::from_bytes(&key).is_none());
    let land = codec::seal(SCHEMA_VERSION, Kind::Chunk, &key, 1, b"how it is dug");
    vec![
        strange("portal", 40, 3, b"where it leads"),
        strange("lamp", 41, 2, b"its colour"),
        strange("lamp", 42, 1, &far),
        Put {
            kind: Kind::Chunk,
            key,
            bytes: Some(land),
        },
    ]
}

/// A world that a later game has saved, with two lamps of today.
fn planted() -> (tempfile::TempDir, SavesDir) {
    let root = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(root.path());
    let (_, world) = saves.create(&meta()).unwrap();
    let batch = Batch {
        records: with_state([lamp(1), lamp(2)]),
        ..Batch::default()
    };
    world.commit(&batch).unwrap();
    drop(world);
    let store = Store::open(&root.path().join("kinds").join(WORLD_FILE), "Kinds").unwrap();
    store.write(&later()).unwrap();
    drop(store);
    (root, saves)
}

/// The bodies of the records that this version does not know, in the order of their keys.
fn left(dir: &Path) -> Vec<(u16, Vec<u8>)> {
    let store = Store::open(&dir.join(WORLD_FILE), "Kinds").unwrap();
    let mut found = Vec::new();
    let unknown: Vec<_> = later().into_iter().map(|put| put.key).collect();
    store
        .scan(|raw| {
            if unknown.contains(&raw.key) {
                let record = codec::unseal(&raw.bytes).unwrap();
                found.push((record.version, record.body.to_vec()));
            }
        })
        .unwrap();
    found
}

fn assert_left(dir: &Path, what: &str) {
    let mut expected: Vec<_> = later()
        .iter()
        .map(|put| {
            let bytes = put.bytes.clone().unwrap();
            let record = codec::unseal(&bytes).unwrap();
            (put.key.clone(), (record.version, record.body.to_vec()))
        })
        .collect();
    expected.sort();
    let expected: Vec<_> = expected.into_iter().map(|(_, it)| it).collect();
    assert_eq!(left(dir), expected, "{what}");
}

#[test]
fn what_only_a_later_game_knows_stays_as_it_is_and_is_told() {
    let (root, saves) = planted();
    let dir = root.path().join("kinds");
    let world = saves.open("kinds").unwrap();
    assert_eq!(world.problems(), Vec::<String>::new());
    let records = world.records().unwrap();
    assert_eq!(records.unknown, 3);
    let last = records.last.get(&RecordKind::Lamp);
    assert_eq!(last, Some(&42), "no number is given twice");
    let batch = Batch {
        records: [lamp(2), (lamp(1).0, None)].into(),
        ..Batch::default()
    };
    world.commit(&batch).unwrap();
    assert_eq!(world.state().unwrap().unwrap().lamps.len(), 1);
    drop(world);
    assert_left(&dir, "after commits");
    let double = saves.duplicate("kinds").unwrap();
    assert_left(&root.path().join(double), "in a double");
    let file = root.path().join("kinds.antipode-world");
    saves.export("kinds", &file).unwrap();
    let imported = saves.import(&file).unwrap();
    assert_left(&root.path().join(imported), "imported");
    assert!(saves.verify("kinds").unwrap().is_sound());
}

#[test]
fn a_repair_finds_records_of_all_kinds_in_the_bare_bytes() {
    let (root, saves) = planted();
    let dir = root.path().join("kinds");
    let path = dir.join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    // No index is left.
    bytes[..4096].fill(0);
    fs::write(&path, bytes).unwrap();
    let report = saves.repair("kinds").unwrap();
    assert!(report.has_state, "{report:?}");
    assert_left(&dir, "after a repair");
    let records = saves.open("kinds").unwrap().records().unwrap();
    assert_eq!(records.known.get(&lamp(1).0), lamp(1).1.as_ref());
    assert_eq!(records.known.get(&lamp(2).0), lamp(2).1.as_ref());
}

#[test]
fn a_damaged_thing_costs_itself_alone_and_what_was_taken_away_stays_so() {
    let (root, saves) = planted();
    let world = saves.open("kinds").unwrap();
    let commit = |records: RecordChanges| {
        let batch = Batch {
            records,
            ..Batch::default()
        };
        world.commit(&batch).unwrap();
    };
    // So many that copies of them stay behind on pages that nothing uses any more.
    let many = 100..400;
    commit(many.clone().map(lamp).collect());
    // What lies behind them keeps closing from cutting them off.
    let noise = (0..crate::CHUNK_SAMPLES).map(|at| (at * 7919 % 65_521) as i16);
    let batch = Batch {
        chunks: vec![(ChunkKey::default(), noise.collect())],
        ..Batch::default()
    };
    world.commit(&batch).unwrap();
    commit(many.clone().map(|id| (lamp(id).0, None)).collect());
    commit([lamp(1), (lamp(2).0, None)].into());
    let path = root.path().join("kinds").join(WORLD_FILE);
    drop(world);
    let mut bytes = fs::read(&path).unwrap();
    let mut put = None;
    let store = Store::open(&path, "Kinds").unwrap();
    store
        .scan_records(|raw| {
            if raw.key == lamp(1).0.to_bytes() {
                put = Some(raw.bytes);
            }
        })
        .unwrap();
    drop(store);
    let record = put.unwrap();
    for at in 0..bytes.len() - record.len() {
        if bytes[at..at + record.len()] == record {
            bytes[at + record.len() - 9] ^= 0x40;
        }
    }
    let mut keys = many.map(|id| lamp(id).0.to_bytes());
    assert!(keys.any(|key| bytes.windows(key.len()).any(|at| at == key)));
    fs::write(&path, bytes).unwrap();
    let world = saves.open("kinds").unwrap();
    let problems = world.problems();
    assert!(
        problems.len() == 1 && problems[0].contains("lamp 1"),
        "{problems:?}"
    );
    assert!(!world.records().unwrap().known.contains_key(&lamp(1).0));
    assert!(world.state().unwrap().is_some(), "the player is whole");
    drop(world);
    let report = saves.repair("kinds").unwrap();
    assert!(
        report.losses.iter().any(|loss| loss.contains("lamp 1")),
        "{report:?}"
    );
    let records = saves.open("kinds").unwrap().records().unwrap();
    // Whether an older copy lies on a freed page is the store's affair; the report says which it was.
    let is_older = (report.losses.iter()).any(|loss| loss.contains("lamp 1 is of commit"));
    let expected = lamp(1).1.filter(|_| is_older);
    assert_eq!(records.known.get(&lamp(1).0), expected.as_ref());
    let lamps = (records.known.keys()).filter(|key| key.kind == RecordKind::Lamp);
    let others = lamps.filter(|key| key.id != 1);
    assert_eq!(others.count(), 0, "what was taken away stays so");
}

#[test]
fn a_thing_under_a_damaged_key_is_found_again() {
    let (root, saves) = planted();
    let store = Store::open(&root.path().join("kinds").join(WORLD_FILE), "Kinds").unwrap();
    let mut puts = Vec::new();
    store
        .scan_records(|raw| {
            if raw.key == lamp(1).0.to_bytes() {
                let mut put = Put::from(raw);
                put.key = lamp(9).0.to_bytes();
                puts.push(put);
            }
        })
        .unwrap();
    puts.push(Put {
        kind: Kind::Record,
        key: lamp(1).0.to_bytes(),
        bytes: None,
    });
    store.write(&puts).unwrap();
    drop(store);
    assert!(!saves.verify("kinds").unwrap().is_sound());
    saves.repair("kinds").unwrap();
    let known = saves.open("kinds").unwrap().records().unwrap().known;
    assert_eq!(known.get(&lamp(1).0), lamp(1).1.as_ref());
    assert!(!known.contains_key(&lamp(9).0));
}

#[test]
fn the_keys_of_a_kind_lie_side_by_side_in_the_order_of_their_numbers() {
    for &kind in RecordKind::ALL {
        let bytes = [0, 1, 255, 256, MAX_ID].map(|id| kind.numbered(id).to_bytes());
        assert!(bytes.is_sorted_by(|a, b| a < b));
        let name = 1 + kind.name().len();
        assert!(bytes.iter().all(|key| key[..name] == bytes[0][..name]));
        for key in bytes {
            assert_eq!(KeyParts::of(&key).unwrap().known().unwrap().to_bytes(), key);
        }
    }
    for wrong in [
        &b""[..],
        b"\x04lamp",
        b"\x00\0\0\0\0\0\0\0\0",
        b"\x04la\x80p\0\0\0\0\0\0\0\0",
    ] {
        assert!(KeyParts::of(wrong).is_none(), "{wrong:?}");
    }
}

/// These and a whole state.
fn with_state(records: impl IntoIterator<Item = (RecordKey, Option<Record>)>) -> RecordChanges {
    let mut changes = RecordChanges::from(&WorldState::default());
    changes.extend(records);
    changes
}

/// What a step of walking changes.
fn step(at: u64) -> RecordChanges {
    let state = WorldState {
        simulated_s: at as f64,
        ..WorldState::default()
    };
    let mut changes = RecordChanges::from(&state);
    changes.remove(&RecordKind::View.numbered(0));
    changes
}

/// What the last of some commits of a step wrote in a world with so many lamps: its records, and in how many pages the
/// file differs then.
fn walked(lamps: u32) -> (usize, usize) {
    let dir = tempfile::tempdir().unwrap();
    let world = WorldStore::create(dir.path(), &meta()).unwrap();
    let batch = Batch {
        records: with_state((1..=lamps).map(lamp)),
        ..Batch::default()
    };
    world.commit(&batch).unwrap();
    let commit = |at| {
        let batch = Batch {
            records: step(at),
            ..Batch::default()
        };
        world.commit(&batch).unwrap();
        fs::read(dir.path().join(WORLD_FILE)).unwrap()
    };
    let (_, before, after) = (commit(1), commit(2), commit(3));
    let pages = (before.chunks(4096).zip(after.chunks(4096))).filter(|(a, b)| a != b);
    let changed = pages.count() + before.len().abs_diff(after.len()) / 4096;
    assert_eq!(world.records().unwrap().known.len(), lamps as usize + 3);
    drop(world);
    let store = Store::open(&dir.path().join(WORLD_FILE), "Kinds").unwrap();
    let mut commits = Vec::new();
    store
        .scan(|raw| commits.push(codec::unseal(&raw.bytes).unwrap().sequence))
        .unwrap();
    let last = commits.iter().max().unwrap();
    (commits.iter().filter(|it| *it == last).count(), changed)
}

#[test]
fn a_step_writes_as_much_among_a_hundred_thousand_records_as_among_none() {
    let (none, few_pages) = walked(0);
    let (many, pages) = walked(100_000);
    assert_eq!((none, many), (2, 2), "the player and the time");
    // Two leaves and what leads to them, of an index at most four deep; and the store's own.
    assert!(
        pages <= few_pages + 12,
        "{few_pages} pages among none, {pages} among many"
    );
}
