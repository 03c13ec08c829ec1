//! Files that are missing, are no files or are absurdly long: nothing waits, and
//! list, find, verify, repair and open agree.
//!
//! A program of its own: a child that starts has, for a moment, the locks of all files that are open in its parent,
//! and a world that another test has just closed would be in use.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

#[path = "it/common/mod.rs"]
mod common;

use std::fs::{self, File};
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use antipode_storage::{SavesDir, StorageError, THUMBNAIL_FILE, WORLD_FILE};
use common::{batch, meta};
use tempfile::TempDir;

const SUMMARY: &str = "summary.bin";

/// A saves directory with one world, `w`, of three edited chunks.
fn saves() -> (TempDir, SavesDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let (slug, world) = saves.create(&meta("W")).unwrap();
    world.commit(&batch(3, 1)).unwrap();
    let world = dir.path().join(slug);
    (dir, saves, world)
}

fn fifo(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status().unwrap();
    assert!(made.success());
}

/// The ways in which a file can be no file.
fn spoil(path: &Path, how: usize) {
    fs::remove_file(path).unwrap();
    match how {
        0 => {}
        1 => fs::create_dir(path).unwrap(),
        2 => fifo(path),
        3 => symlink("/dev/zero", path).unwrap(),
        _ => symlink("/nowhere/at/all", path).unwrap(),
    }
}

#[test]
fn a_world_without_its_store_is_listed_as_what_repair_does() {
    for how in 0..5 {
        let (_dir, saves, world) = saves();
        spoil(&world.join(WORLD_FILE), how);
        let listed = saves.find("W").unwrap();
        let problem = listed.problem.unwrap();
        assert!(
            problem.contains("`antipode saves repair` makes the world anew"),
            "{how}: {problem}"
        );
        let refusal = saves.open("w").map(drop).unwrap_err();
        assert!(
            matches!(refusal, StorageError::NoStore { .. }),
            "{how}: {refusal}"
        );
        assert_eq!(refusal.to_string(), problem);
        assert_eq!(saves.verify("w").unwrap().problems[0], problem);
        assert_eq!(saves.info("w").unwrap().problems, [problem]);
        let report = saves.repair("w").unwrap();
        assert_eq!(
            (report.chunks, report.has_state, report.kept.is_some()),
            (0, false, how > 0)
        );
        assert!(
            report.losses.iter().any(|loss| loss.contains("All edits")),
            "{how}: {:?}",
            report.losses
        );
        assert_eq!(saves.find("W").unwrap().problem, None);
        assert!(saves.verify("w").unwrap().is_sound());
        assert_eq!(saves.open("w").unwrap().meta(), meta("W"));
    }
}

#[test]
fn a_world_of_which_nothing_tells_what_it_was_is_listed_and_can_be_deleted() {
    for how in 0..5 {
        let (_dir, saves, world) = saves();
        spoil(&world.join(WORLD_FILE), how);
        fs::write(world.join(SUMMARY), b"rubbish").unwrap();
        let problem = saves.find("w").unwrap().problem.unwrap();
        assert!(problem.contains("delete the world"), "{how}: {problem}");
        assert_eq!(saves.verify("w").unwrap().problems[0], problem);
        let refusal = saves.repair("w").unwrap_err();
        assert!(
            matches!(refusal, StorageError::Unsalvageable { .. }),
            "{how}: {refusal}"
        );
        assert_eq!(saves.find("w").unwrap().problem, Some(problem));
        saves.delete("w").unwrap();
        assert_eq!(saves.list().unwrap(), []);
    }
}

#[test]
fn a_summary_that_is_none_is_told_and_mended_and_costs_nothing() {
    for how in 1..6 {
        let (_dir, saves, world) = saves();
        let summary = world.join(SUMMARY);
        if how == 5 {
            // More than any memory: reading it would show.
            File::create(&summary).unwrap().set_len(1 << 40).unwrap();
        } else {
            spoil(&summary, how);
        }
        let listed = saves.find("W").unwrap();
        assert_eq!(listed.meta, Some(meta("W")));
        let problem = listed.problem.unwrap();
        assert!(
            problem.contains("summary.bin cannot be used") && problem.contains("saves repair"),
            "{how}: {problem}"
        );
        let verified = saves.verify("w").unwrap();
        assert_eq!((verified.chunks, verified.problems), (3, vec![problem]));
        assert_eq!(saves.open("w").unwrap().meta(), meta("W"));
        let report = saves.repair("w").unwrap();
        let kept = report.kept.unwrap();
        assert!(kept.ends_with("summary.bin.damaged-1"), "{kept:?}");
        assert_eq!((report.chunks, report.has_state), (3, true));
        assert!(saves.verify("w").unwrap().is_sound());
        assert_eq!(saves.find("W").unwrap().problem, None);
        assert_eq!(saves.open("w").unwrap().edited_chunks().unwrap().len(), 3);
    }
}

#[test]
fn a_picture_that_is_none_is_neither_shown_nor_exported() {
    for how in 1..6 {
        let (dir, saves, world) = saves();
        let picture = world.join(THUMBNAIL_FILE);
        fs::write(&picture, b"png").unwrap();
        if how == 5 {
            File::create(&picture).unwrap().set_len(1 << 40).unwrap();
        } else {
            spoil(&picture, how);
        }
        assert_eq!(saves.find("W").unwrap().thumbnail, None, "{how}");
        let file = dir.path().join("out");
        saves.export("w", &file).unwrap();
        let imported = saves.import(&file).unwrap();
        assert!(!saves.thumbnail_path(&imported).unwrap().exists());
        // A new picture takes the place of all but a directory, and is listed then.
        let world = saves.open("w").unwrap();
        if how != 1 {
            world.write_thumbnail(b"png").unwrap();
            assert_eq!(saves.find("W").unwrap().thumbnail, Some(picture));
        }
    }
}

#[test]
fn what_is_no_file_is_not_imported() {
    let (dir, saves, _) = saves();
    let pipe = dir.path().join("pipe");
    fifo(&pipe);
    for (path, reason) in [
        (pipe.as_path(), "it is a pipe"),
        (dir.path(), "it is a directory"),
        (Path::new("/dev/zero"), "it is a pipe, a socket or a device"),
        (&dir.path().join("none"), "there is no such file"),
    ] {
        let refusal = saves.import(path).unwrap_err();
        assert!(
            matches!(refusal, StorageError::Archive { .. }),
            "{refusal:?}"
        );
        assert!(refusal.to_string().contains(reason), "{refusal}");
    }
    assert_eq!(saves.list().unwrap().len(), 1);
}

#[test]
fn a_file_in_the_place_of_the_saves_directory_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("file");
    fs::write(&file, b"").unwrap();
    for path in [file.clone(), file.join("saves")] {
        let saves = SavesDir::new(&path);
        let refusals = [
            saves.list().map(drop),
            saves.find("w").map(drop),
            saves.create(&meta("W")).map(drop),
            saves.import(&dir.path().join("x")).map(drop),
        ];
        for refusal in refusals.map(Result::unwrap_err) {
            assert!(
                matches!(&refusal, StorageError::NotADirectory { path } if *path == file),
                "{refusal}"
            );
            assert!(refusal.to_string().contains("--saves-dir"), "{refusal}");
        }
    }
    assert!(matches!(
        SavesDir::new(&file).open("w"),
        Err(StorageError::NotADirectory { .. })
    ));
}

/// A reader who could not look is told so. A loop of links is refused to everybody, permissions only to some.
#[cfg(unix)]
#[test]
fn a_world_whose_folder_cannot_be_looked_into_is_listed_and_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    symlink("loop", dir.path().join("loop")).unwrap();
    let listed = saves.list().unwrap();
    assert_eq!(listed.len(), 1);
    assert_eq!(listed[0].name(), "loop");
    assert!(listed[0].problem.is_some(), "{listed:?}");
    assert!(saves.verify("loop").is_err());
}

#[test]
fn a_summary_that_was_never_put_in_place_is_swept_and_nothing_else() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let (slug, world) = saves.create(&meta("W")).unwrap();
    drop(world);
    let at = |name: &str| dir.path().join(&slug).join(name);
    for name in ["summary.bin.4242.tmp", "summary.bin.x.tmp", "notes.1.tmp"] {
        fs::copy(at("summary.bin"), at(name)).unwrap();
    }
    fs::write(at("summary.bin.7.tmp"), b"somebody's own").unwrap();
    drop(saves.open(&slug).unwrap());
    assert!(!at("summary.bin.4242.tmp").exists());
    for name in [
        "summary.bin",
        "summary.bin.x.tmp",
        "summary.bin.7.tmp",
        "notes.1.tmp",
    ] {
        assert!(at(name).exists(), "{name}");
    }
}
