//! Worlds renamed and doubled.

use std::fs;

use crate::common::two::{assert_is_foo, entries, names, two};
use crate::common::{batch, key, meta, samples, state};
use antipode_storage::{Batch, NameError, SavesDir, StorageError, WORLD_FILE};

#[test]
fn a_world_gets_another_name_and_keeps_its_directory() {
    let (_dir, saves) = two();
    saves.rename("foo", "  Żółw 7 ").unwrap();
    assert_eq!(names(&saves), ["Bar", "Żółw 7"]);
    assert_is_foo(&saves, "foo", "Żółw 7");
    assert_eq!(saves.find("żółw 7").unwrap().slug, "foo");
    // Its own name in another case is free to it.
    saves.rename("foo", "ŻÓŁW 7").unwrap();
    assert_eq!(names(&saves), ["Bar", "ŻÓŁW 7"]);
    // The name it had is free for others.
    let (slug, _) = saves.create(&meta("Foo")).unwrap();
    assert_eq!(slug, "foo-2");
}

#[test]
fn names_that_will_not_do_change_nothing() {
    let (_dir, saves) = two();
    for (name, reason) in [
        (
            "bar",
            NameError::Taken {
                existing: "Bar".to_owned(),
            },
        ),
        ("", NameError::Empty),
        ("a\nb", NameError::Unprintable('\n')),
        (&"x".repeat(41), NameError::TooLong { chars: 41 }),
    ] {
        let refusal = saves.rename("foo", name).unwrap_err();
        assert!(
            matches!(&refusal, StorageError::Name(why) if *why == reason),
            "{refusal}"
        );
    }
    let elsewhere = saves.rename("../foo", "x").unwrap_err();
    assert!(matches!(elsewhere, StorageError::NotFound { .. }));
    assert_eq!(names(&saves), ["Bar", "Foo"]);
}

#[test]
fn a_world_that_is_open_is_neither_renamed_nor_doubled_nor_exported() {
    let (dir, saves) = two();
    let held = saves.open("foo").unwrap();
    let file = dir.path().join("foo.antipode-world");
    let refusals = [
        saves.rename("foo", "x"),
        saves.duplicate("foo").map(drop),
        saves.export("foo", &file),
    ];
    for refusal in refusals.map(Result::unwrap_err) {
        assert!(matches!(refusal, StorageError::InUse { .. }), "{refusal}");
    }
    drop(held);
    assert_eq!(entries(saves.path()), ["bar", "foo"]);
    assert_eq!(entries(dir.path()), ["saves"]);
}

#[test]
fn a_double_is_a_world_of_its_own() {
    let (_dir, saves) = two();
    assert_eq!(saves.duplicate("foo").unwrap(), "foo-2");
    assert_eq!(saves.duplicate("foo-2").unwrap(), "foo-3");
    assert_eq!(names(&saves), ["Bar", "Foo", "Foo 2", "Foo 3"]);
    assert_eq!(entries(saves.path()), ["bar", "foo", "foo-2", "foo-3"]);
    assert_is_foo(&saves, "foo-2", "Foo 2");
    let world = saves.open("foo-3").unwrap();
    world.commit(&batch(1, 9)).unwrap();
    drop(world);
    assert_is_foo(&saves, "foo", "Foo");
}

#[test]
fn a_double_of_a_world_that_was_never_closed_holds_its_last_commit() {
    let (dir, saves) = two();
    let world = saves.open("foo").unwrap();
    world.commit(&batch(2, 8)).unwrap();
    // As a kill leaves it.
    let killed = fs::read(saves.path().join("foo").join(WORLD_FILE)).unwrap();
    drop(world);
    fs::write(saves.path().join("foo").join(WORLD_FILE), killed).unwrap();
    let slug = saves.duplicate("foo").unwrap();
    let double = saves.open(&slug).unwrap();
    assert_eq!(double.state().unwrap(), Some(state(8.0)));
    assert_eq!(double.chunk(&key(1)).unwrap(), Some(samples(1, 8)));
    assert_eq!(double.chunk(&key(3)).unwrap(), Some(samples(3, 3)));
    drop(dir);
}

#[test]
fn a_double_of_thousands_of_chunks_is_whole() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let (_, world) = saves.create(&meta("Large")).unwrap();
    // Noise does not pack, so several batches are written.
    let noise = |x: i32| {
        let mut seed = x as u32;
        let mut chunk = samples(x, 1);
        for sample in &mut chunk {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *sample = (seed >> 16) as i16;
        }
        chunk
    };
    let chunks = (0..150).map(|x| (key(x), noise(x))).collect();
    world
        .commit(&Batch {
            chunks,
            ..Batch::default()
        })
        .unwrap();
    drop(world);
    let double = saves.open(&saves.duplicate("large").unwrap()).unwrap();
    assert_eq!(double.edited_chunks().unwrap().len(), 150);
    for x in [0, 63, 64, 149] {
        assert_eq!(double.chunk(&key(x)).unwrap(), Some(noise(x)), "chunk {x}");
    }
}

#[test]
fn damaged_records_stay_damaged_in_a_double_and_the_rest_is_whole() {
    let (_dir, saves) = two();
    let path = saves.path().join("foo").join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    // The body of every record of chunk 2 begins behind its key.
    let stored = [
        &[0_u8][..],
        &[0x80, 0, 0, 2],
        &[0x7f, 0xff, 0xff, 0xff],
        &[0x80, 0, 0, 3],
    ]
    .concat();
    let starts: Vec<_> = (22..bytes.len() - 20)
        .filter(|&at| bytes[at..].starts_with(&stored) && bytes[at - 20..at - 18] == *b"Ap")
        .collect();
    assert!(!starts.is_empty());
    for at in starts {
        bytes[at + stored.len() + 5] ^= 0x10;
    }
    fs::write(&path, bytes).unwrap();
    let double = saves.open(&saves.duplicate("foo").unwrap()).unwrap();
    assert!(matches!(
        double.chunk(&key(2)),
        Err(StorageError::Damaged { .. })
    ));
    assert_eq!(double.chunk(&key(1)).unwrap(), Some(samples(1, 3)));
}
