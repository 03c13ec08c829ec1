//! Worlds renamed, doubled, exported and imported.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

mod common;

use std::fs;
use std::path::Path;

use antipode_storage::{
    Batch, NameError, SavesDir, StorageError, THUMBNAIL_FILE, WORLD_FILE, WorldStore, archives_in,
};
use common::{batch, key, meta, samples, state};
use tempfile::TempDir;

/// A directory with the worlds Foo, of four edited chunks and a picture, and Bar.
fn two() -> (TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("saves"));
    let (_, world) = saves.create(&meta("Foo")).unwrap();
    world.commit(&batch(4, 3)).unwrap();
    world.write_thumbnail(b"png").unwrap();
    drop(world);
    drop(saves.create(&meta("Bar")).unwrap());
    (dir, saves)
}

fn names(saves: &SavesDir) -> Vec<String> {
    let worlds = saves.list().unwrap();
    let mut names: Vec<_> = worlds.iter().map(|world| world.name().to_owned()).collect();
    names.sort();
    names
}

/// Everything in a directory, hidden or not.
fn entries(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        // The lock of the directory of worlds stays.
        .filter(|name| name != ".antipode.lock")
        .collect();
    names.sort();
    names
}

/// What Foo holds, wherever it is and whatever it is called.
fn assert_is_foo(saves: &SavesDir, slug: &str, name: &str) {
    let world = saves.open(slug).unwrap();
    assert_eq!(world.meta(), meta(name));
    assert_eq!(world.problems(), Vec::<String>::new());
    assert_eq!(world.state().unwrap(), Some(state(3.0)));
    for x in 0..4 {
        assert_eq!(world.chunk(&key(x)).unwrap(), Some(samples(x, 3)));
    }
    let picture = fs::read(saves.thumbnail_path(slug).unwrap()).unwrap();
    assert_eq!(picture, b"png");
    drop(world);
    assert!(saves.verify(slug).unwrap().is_sound());
}

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

#[test]
fn what_verify_calls_damaged_is_neither_exported_nor_imported() {
    let (dir, saves) = two();
    let file = dir.path().join("foo.antipode-world");
    saves.export("foo", &file).unwrap();
    let path = saves.path().join("foo").join(WORLD_FILE);
    let whole = fs::read(&path).unwrap();
    let archive = fs::read(&file).unwrap();
    let records = |bytes: &[u8]| -> Vec<usize> {
        let starts = (0..bytes.len() - 30).filter(|&at| bytes[at + 2..].starts_with(b"Ap\x03\x0d"));
        starts.collect()
    };
    for at in records(&whole) {
        let mut bytes = whole.clone();
        bytes[at + 45] ^= 0x10;
        fs::write(&path, &bytes).unwrap();
        let report = saves.verify("foo").unwrap();
        let to = dir.path().join("damaged.antipode-world");
        let exported = saves.export("foo", &to);
        // A record on a freed page is no part of the world.
        assert_eq!(exported.is_ok(), report.is_sound(), "{report:?}");
        let _ = fs::remove_file(&to);
    }
    // The same done to what is packed in the archive.
    let elsewhere = SavesDir::new(dir.path().join("other"));
    let refusal = elsewhere
        .import(&repacked(&archive, &file, 0x10))
        .unwrap_err()
        .to_string();
    assert!(
        refusal.contains("chunk A") && refusal.contains("checksum"),
        "{refusal}"
    );
    assert_eq!(entries(elsewhere.path()), Vec::<String>::new());
    assert_eq!(
        elsewhere.import(&repacked(&archive, &file, 0)).unwrap(),
        "foo"
    );
}

/// An archive like `archive` at `file`, in which a byte of each chunk's record is changed by
/// these bits and everything around is right again.
fn repacked(archive: &[u8], file: &Path, bits: u8) -> std::path::PathBuf {
    // Magic, version, number of files; then name and length of the store, and its blocks.
    let mut at = 11 + 1 + WORLD_FILE.len() + 8;
    let mut out = archive[..at].to_vec();
    let length = u64::from_le_bytes(archive[at - 8..at].try_into().unwrap());
    let mut done = 0;
    while done < length {
        let number = |n: usize| u32::from_le_bytes(archive[at + 4 * n..][..4].try_into().unwrap());
        let (raw, packed) = (number(0) as usize, number(1) as usize);
        let block = lz4_flex::block::decompress(&archive[at + 12..][..packed], raw);
        let mut block = block.unwrap();
        for start in 0..block.len() - 60 {
            if block[start + 2..].starts_with(b"Ap\x03\x0d") {
                block[start + 45] ^= bits;
            }
        }
        let again = lz4_flex::block::compress(&block);
        out.extend((raw as u32).to_le_bytes());
        out.extend((again.len() as u32).to_le_bytes());
        out.extend(crc32(&again).to_le_bytes());
        out.extend(again);
        at += 12 + packed;
        done += raw as u64;
    }
    out.extend(&archive[at..]);
    let changed = file.with_file_name("changed.antipode-world");
    fs::write(&changed, out).unwrap();
    changed
}

/// CRC-32 (IEEE 802.3), bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 };
    !bytes
        .iter()
        .fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

#[test]
fn an_export_is_one_file_and_nothing_else_stays() {
    let (dir, saves) = two();
    let file = dir.path().join("foo.antipode-world");
    saves.export("foo", &file).unwrap();
    assert_eq!(entries(dir.path()), ["foo.antipode-world", "saves"]);
    let bytes = fs::read(&file).unwrap();
    let refusal = saves.export("bar", &file).unwrap_err();
    assert!(matches!(refusal, StorageError::Exists { .. }), "{refusal}");
    assert_eq!(fs::read(&file).unwrap(), bytes);
    let nowhere = saves
        .export("foo", &dir.path().join("none/foo"))
        .unwrap_err()
        .to_string();
    assert!(nowhere.contains("none"), "{nowhere}");
    assert_eq!(entries(dir.path()), ["foo.antipode-world", "saves"]);
    let elsewhere = SavesDir::new(dir.path().join("other"));
    assert_eq!(elsewhere.import(&file).unwrap(), "foo");
    assert_is_foo(&elsewhere, "foo", "Foo");
}

#[test]
fn free_pages_are_left_behind() {
    let (dir, saves) = two();
    let world = saves.open("foo").unwrap();
    for commit in 4..40 {
        world.commit(&batch(60, commit)).unwrap();
    }
    drop(world);
    let length = |slug: &str| {
        fs::metadata(saves.path().join(slug).join(WORLD_FILE))
            .unwrap()
            .len()
    };
    let double = saves.duplicate("foo").unwrap();
    assert!(
        length(&double) <= length("foo"),
        "{} {}",
        length(&double),
        length("foo")
    );
    drop(dir);
}

/// An archive whose store was changed before it was packed.
fn archive_of(dir: &Path, change: impl FnOnce(&WorldStore)) -> std::path::PathBuf {
    let saves = SavesDir::new(dir.join("source"));
    let (slug, world) = saves.create(&meta("Odd")).unwrap();
    change(&world);
    drop(world);
    let file = dir.join("odd.antipode-world");
    saves.export(&slug, &file).unwrap();
    file
}

#[test]
fn a_name_that_no_world_can_have_is_not_imported() {
    let dir = tempfile::tempdir().unwrap();
    let file = archive_of(dir.path(), |world| {
        let meta = Some(meta("a\u{202e}b\n"));
        world
            .commit(&Batch {
                meta,
                ..Batch::default()
            })
            .unwrap();
    });
    let saves = SavesDir::new(dir.path().join("saves"));
    let refusal = saves.import(&file).unwrap_err();
    assert!(
        matches!(refusal, StorageError::Archive { .. }),
        "{refusal:?}"
    );
    assert!(
        refusal.to_string().contains("name that no world can have"),
        "{refusal}"
    );
    assert_eq!(entries(saves.path()), Vec::<String>::new());
}

#[test]
fn a_picture_that_is_none_costs_only_the_picture() {
    let dir = tempfile::tempdir().unwrap();
    let file = archive_of(dir.path(), |world| {
        world.write_thumbnail(&[0xff; 1000]).unwrap();
    });
    let saves = SavesDir::new(dir.path().join("saves"));
    let slug = saves.import(&file).unwrap();
    assert!(saves.path().join(&slug).join(THUMBNAIL_FILE).is_file());
    assert_eq!(saves.open(&slug).unwrap().meta(), meta("Odd"));
}

#[test]
fn exported_worlds_are_found_newest_first_and_nothing_else() {
    let (dir, saves) = two();
    for (n, name) in ["b", "a"].into_iter().enumerate() {
        let path = dir.path().join(format!("{name}.Antipode-World"));
        saves.export("foo", &path).unwrap();
        let modified = std::time::UNIX_EPOCH + std::time::Duration::from_secs(n as u64 * 9);
        fs::File::options()
            .write(true)
            .open(path)
            .unwrap()
            .set_modified(modified)
            .unwrap();
    }
    fs::write(dir.path().join("notes.txt"), b"x").unwrap();
    fs::create_dir(dir.path().join("d.antipode-world")).unwrap();
    let found = archives_in(dir.path());
    let names: Vec<_> = found
        .iter()
        .map(|file| file.path.file_name().unwrap())
        .collect();
    assert_eq!(names, ["a.Antipode-World", "b.Antipode-World"]);
    assert!(found.iter().all(|file| file.size_bytes > 100));
    assert_eq!(archives_in(&dir.path().join("none")), []);
}

/// A store as a process that was killed leaves it: to be recovered by whoever opens it.
fn unclosed(saves: &SavesDir, slug: &str) -> Vec<u8> {
    let file = saves.path().join(slug).join(WORLD_FILE);
    let world = saves.open(slug).unwrap();
    world.commit(&batch(4, 3)).unwrap();
    let bytes = fs::read(&file).unwrap();
    drop(world);
    fs::write(&file, &bytes).unwrap();
    bytes
}

#[test]
fn a_look_through_a_world_and_an_export_change_nothing_in_it() {
    let (dir, saves) = two();
    let bytes = unclosed(&saves, "foo");
    let before = entries(&saves.path().join("foo"));
    assert!(saves.verify("foo").unwrap().is_sound());
    let file = dir.path().join("foo.antipode-world");
    saves.export("foo", &file).unwrap();
    assert!(saves.list().unwrap().iter().all(|it| it.problem.is_none()));
    let after = fs::read(saves.path().join("foo").join(WORLD_FILE)).unwrap();
    assert!(after == bytes, "the store was written to");
    assert_eq!(entries(&saves.path().join("foo")), before);
    let slug = saves.import(&file).unwrap();
    assert_is_foo(&saves, &slug, "Foo 2");
}

#[test]
fn a_world_in_play_is_neither_looked_through_nor_exported() {
    let (dir, saves) = two();
    let world = saves.open("foo").unwrap();
    let file = dir.path().join("file");
    for refusal in [saves.verify("foo").map(drop), saves.export("foo", &file)] {
        assert!(matches!(refusal, Err(StorageError::InUse { .. })));
    }
    drop(world);
    assert!(saves.verify("foo").unwrap().is_sound());
}

#[cfg(unix)]
#[test]
fn a_link_in_the_place_of_the_picture_is_not_followed_into_an_archive() {
    let (dir, saves) = two();
    let secret = dir.path().join("secret");
    fs::write(&secret, b"a secret").unwrap();
    let picture = saves.path().join("foo").join(THUMBNAIL_FILE);
    fs::remove_file(&picture).unwrap();
    std::os::unix::fs::symlink(&secret, &picture).unwrap();
    let file = dir.path().join("foo.antipode-world");
    saves.export("foo", &file).unwrap();
    let copies = [
        saves.import(&file).unwrap(),
        saves.duplicate("foo").unwrap(),
    ];
    for slug in copies {
        assert!(!saves.path().join(&slug).join(THUMBNAIL_FILE).exists());
    }
    assert_eq!(saves.find("Foo").unwrap().thumbnail, None);
}
