//! Whatever is changed in a store, opening and playing on end in words, and what the check lets pass is whole.

use super::*;
use crate::{Record, RecordChanges, RecordKind};

/// A saves directory with one world, of these bytes.
fn planted(bytes: &[u8]) -> (tempfile::TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let world = dir.path().join("victim");
    fs::create_dir(&world).unwrap();
    fs::write(world.join(WORLD_FILE), bytes).unwrap();
    let saves = SavesDir::new(dir.path());
    (dir, saves)
}

/// Whether a world holds exactly what a commit left.
fn holds(saves: &SavesDir, chunks: i32, commit: i16) -> bool {
    let world = saves.open("victim").unwrap();
    assert_eq!(world.meta(), meta());
    let state = world.state();
    let is_of = |x: i32| {
        let last = if x % 7 == 0 { commit } else { 1 };
        matches!(world.chunk(&key(x)), Ok(Some(found)) if found == samples(x, last))
    };
    matches!(&state, Ok(Some(state)) if state.simulated_s == f64::from(commit))
        && (0..chunks).all(is_of)
}

/// A changed world is as it was, or damaged in words; repair finds what there is. One that was
/// not closed may be as the commit before left it, since no one can tell that from a power cut.
fn either_as_it_was_or_damaged(bytes: &[u8], chunks: i32, closed: bool) -> bool {
    let (dir, saves) = planted(bytes);
    let listed = saves.list().unwrap().remove(0);
    assert!(listed.meta.is_none_or(|found| found == meta()));
    let report = saves.verify("victim").unwrap();
    let archive = dir.path().join("a.antipode-world");
    let exported = saves.export("victim", &archive);
    if report.is_sound() {
        assert!(holds(&saves, chunks, 2) || !closed && holds(&saves, chunks, 1));
        exported.unwrap();
        assert_eq!(saves.import(&archive).unwrap(), "victim-2");
    } else {
        assert!(exported.is_err(), "{report:?}");
        match saves.repair("victim") {
            Ok(_) => {
                saves.open("victim").unwrap();
                assert!(saves.verify("victim").unwrap().is_sound());
            }
            Err(error) => assert!(error.to_string().contains("salvaged"), "{error}"),
        }
    }
    report.is_sound()
}

/// The same numbers every time.
fn numbers(mut seed: u64) -> impl FnMut(usize) -> usize {
    move |below| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) as usize) % below
    }
}

/// Plays on in a changed world, which writes to its every leaf.
fn play_on(bytes: &[u8], chunks: i32) {
    let (_dir, saves) = planted(bytes);
    if let Ok(world) = saves.open("victim") {
        let state = Some(WorldState::default());
        let chunks = (0..chunks).map(|x| (key(x), samples(x, 3))).collect();
        let batch = Batch {
            meta: Some(meta()),
            records: state.as_ref().map(RecordChanges::from).unwrap_or_default(),
            chunks,
            kinds: std::collections::BTreeMap::new(),
        };
        // It may fail, but neither end the process nor say what is not so.
        let written = world.commit(&batch).is_ok();
        drop(world);
        assert!(!written || saves.verify("victim").unwrap().is_sound());
    }
}

#[test]
fn every_bit_of_a_leafs_header_is_survived() {
    let store = small(true);
    let forge = Forge::of(store);
    let values = forge.page(forge.table(8, "values").definition + 10).start;
    for page in [forge.pages_of_kind(1)[1], values] {
        for bit in 16..64 {
            let mut forge = Forge::of(store);
            forge.bytes[page + bit / 8] ^= 1 << (bit % 8);
            play_on(&forge.bytes, 40);
            either_as_it_was_or_damaged(&forge.bytes, 40, true);
        }
    }
}

#[test]
fn single_bits_anywhere_are_survived() {
    let mut next = numbers(18);
    for close in [true, false] {
        let store = small(close);
        let used: Vec<usize> = (0..store.len()).filter(|&at| store[at] != 0).collect();
        let mut sound = 0;
        for _ in 0..120 {
            let mut bytes = store.to_vec();
            bytes[used[next(used.len())]] ^= 1 << next(8);
            sound += i32::from(either_as_it_was_or_damaged(&bytes, 40, close));
        }
        assert!((1..120).contains(&sound), "{sound}");
    }
}

#[test]
fn no_change_of_the_index_panics_or_takes_long_whatever_the_checksums_say() {
    let mut next = numbers(5);
    for store in [closed(), killed()] {
        let original = Forge::of(store);
        let slot = original.slot();
        let mut places: Vec<usize> = (slot..slot + 112).chain(9..32).collect();
        for table in [original.chunks(), original.table(8, "values")] {
            places.extend(table.definition..table.definition + 80);
            for number in original.numbers(table) {
                let page = original.page(number);
                places.extend(page.start..page.start + 128);
            }
        }
        for round in 0..1500 {
            let mut forge = original.clone();
            for _ in 0..=next(3) {
                forge.bytes[places[next(places.len())]] ^= 1 << next(8);
            }
            if round % 2 == 0 && forge.slot() == slot {
                let resealed = std::panic::catch_unwind(|| {
                    let mut forge = forge.clone();
                    forge.reseal();
                    forge
                });
                forge = resealed.unwrap_or(forge);
            }
            let _ = check(&forge.bytes);
        }
    }
}

/// Whether the store itself takes a file, and what it finds in it.
fn by_the_store(bytes: &[u8]) -> Option<f64> {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join(WORLD_FILE);
    fs::write(&path, bytes).unwrap();
    crate::guard::guard(Path::new("x"), || {
        let db =
            redb::Database::open(&path).map_err(|e| crate::StorageError::store(&path, "x", e))?;
        let read = redb::ReadableDatabase::begin_read(&db).unwrap();
        let table = read.open_table(crate::store::RECORDS).unwrap();
        let key = RecordKind::Course.numbered(0).to_bytes();
        let value = table.get(key.as_slice()).unwrap().unwrap();
        let record = crate::codec::unseal(value.value()).unwrap();
        match Record::decoded(RecordKind::Course, record.version, record.body) {
            Some(Record::Course(course)) => Ok(course.simulated_s),
            other => panic!("{other:?}"),
        }
    })
    .ok()
}

#[test]
fn a_commit_cut_short_is_taken_or_left_as_the_store_does() {
    let store = small(false);
    let mut next = numbers(77);
    let (mut first, mut second, mut neither) = (0, 0, 0);
    let pages = 1..store.len() / 4096;
    let pages: Vec<usize> = pages
        .filter(|page| store[page * 4096..][..4096].iter().any(|&byte| byte != 0))
        .collect();
    for _ in 0..120 {
        // Some pages of the last commit were never written.
        let mut bytes = store.to_vec();
        for _ in 0..=next(2) {
            let page = pages[next(pages.len())];
            bytes[page * 4096..][..4096].fill(0);
        }
        let found = by_the_store(&bytes);
        assert_eq!(check(&bytes).is_ok(), found.is_some(), "{found:?}");
        match found {
            Some(1.0) => first += 1,
            Some(_) => second += 1,
            None => neither += 1,
        }
    }
    assert!(
        first > 0 && second > 0 && neither > 0,
        "{first} {second} {neither}"
    );
}
