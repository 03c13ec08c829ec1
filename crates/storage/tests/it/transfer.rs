//! Worlds exported and imported.

use std::fs;
use std::path::Path;

use crate::common::two::{assert_is_foo, entries, two};
use crate::common::{batch, meta};
use antipode_storage::{
    ARCHIVE_EXTENSION, Batch, SavesDir, StorageError, THUMBNAIL_FILE, WORLD_FILE, WorldStore,
    archives_in,
};

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
        out.extend(crc32fast::hash(&again).to_le_bytes());
        out.extend(again);
        at += 12 + packed;
        done += raw as u64;
    }
    out.extend(&archive[at..]);
    let changed = file.with_file_name("changed.antipode-world");
    fs::write(&changed, out).unwrap();
    changed
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
fn a_world_whose_name_no_world_can_have_is_imported_under_what_is_left_of_it() {
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
    let names = [(); 2].map(|()| {
        let slug = saves.import(&file).unwrap();
        saves.open(&slug).unwrap().meta().name
    });
    assert_eq!(names, ["ab", "ab 2"]);
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
    let found = archives_in(dir.path(), ARCHIVE_EXTENSION);
    let names: Vec<_> = found
        .iter()
        .map(|file| file.path.file_name().unwrap())
        .collect();
    assert_eq!(names, ["a.Antipode-World", "b.Antipode-World"]);
    assert!(found.iter().all(|file| file.size_bytes > 100));
    assert_eq!(archives_in(&dir.path().join("none"), ARCHIVE_EXTENSION), []);
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
    assert_eq!(saves.edited_chunks("foo").unwrap(), None);
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
