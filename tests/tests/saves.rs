//! Worlds in files, by the command line: out, in, and refused.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::fs;
use std::path::{Path, PathBuf};

use antipode_tests::program::{comparable, game, run};
use tempfile::TempDir;

/// A saves directory with a dug world called Kept.
fn dug() -> TempDir {
    let saves = tempfile::tempdir().unwrap();
    let made = run(
        saves.path(),
        "new spherical seed=11 name=Kept\naim 0 -60\ntap Digit4\nhold LEFT 1\nwait 1\nsave",
    );
    assert_eq!(made.status, Some(0), "{}", made.stderr);
    saves
}

/// What `antipode saves` came to: its status, and what it said on standard output and standard error.
fn saves(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = game(dir).arg("saves").args(arguments).output().unwrap();
    (
        output.status.code(),
        String::from_utf8(output.stdout).unwrap(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

fn exported(dir: &TempDir) -> PathBuf {
    let file = dir.path().join("kept.antipode-world");
    let (status, said, mistake) = saves(dir.path(), &["export", "Kept", file.to_str().unwrap()]);
    assert_eq!(status, Some(0), "{mistake}");
    assert!(said.contains("kept.antipode-world"), "{said}");
    file
}

/// Everything in a directory, hidden or not.
fn entries(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_world_travels_in_one_file_and_is_the_same_elsewhere() {
    let dir = dug();
    let file = exported(&dir);
    let (status, _, mistake) = saves(dir.path(), &["export", "Kept", file.to_str().unwrap()]);
    assert_eq!(status, Some(1));
    assert!(mistake.contains("exists already"), "{mistake}");

    let other = tempfile::tempdir().unwrap();
    let (status, _, mistake) = saves(other.path(), &["import", file.to_str().unwrap()]);
    assert_eq!(status, Some(0), "{mistake}");
    let (here, there) = (
        run(dir.path(), "load Kept\nprobe"),
        run(other.path(), "load Kept\nprobe"),
    );
    assert_eq!(comparable(here.probe(0)), comparable(there.probe(0)));
    assert_eq!(
        here.probe(0)["chunks"]["edited"],
        there.probe(0)["chunks"]["edited"]
    );
    // Where the name is taken it gets a number, and nothing is overwritten.
    let (status, ..) = saves(other.path(), &["import", file.to_str().unwrap()]);
    assert_eq!(status, Some(0));
    assert_eq!(entries(other.path()), ["kept", "kept-2"]);
    let (_, listed, _) = saves(other.path(), &["list"]);
    assert!(listed.contains("Kept 2"), "{listed}");
}

#[test]
fn files_that_are_no_whole_worlds_are_refused_in_one_line_and_leave_nothing() {
    let dir = dug();
    let good = fs::read(exported(&dir)).unwrap();
    let flipped = |at: usize, bits: u8| {
        let mut bytes = good.clone();
        bytes[at] ^= bits;
        bytes
    };
    let mut led_out = good.clone();
    // The name of the first file stands behind the header of 11 bytes and its own length.
    led_out[12..22].copy_from_slice(b"../world.r");
    let cases = [
        (
            "foreign",
            b"PK\x03\x04 a zip archive of something else".to_vec(),
            "no exported world",
        ),
        ("empty", Vec::new(), "missing"),
        ("truncated", good[..good.len() / 2].to_vec(), "missing"),
        ("flipped", flipped(good.len() / 2, 4), "damaged"),
        ("newer", flipped(8, 0x40), "newer version"),
        ("led out", led_out, "which no world has"),
        (
            "lengthened",
            [good.as_slice(), b"x"].concat(),
            "end where it should",
        ),
    ];
    for (what, bytes, reason) in cases {
        let other = tempfile::tempdir().unwrap();
        let file = other.path().join("file.antipode-world");
        fs::write(&file, bytes).unwrap();
        let (status, said, mistake) = saves(other.path(), &["import", file.to_str().unwrap()]);
        assert_eq!((status, said.as_str()), (Some(1), ""), "{what}: {mistake}");
        assert_eq!(mistake.trim().lines().count(), 1, "{what}: {mistake}");
        assert!(
            mistake.contains(reason) && mistake.contains("file.antipode-world"),
            "{what}: {mistake}"
        );
        assert_eq!(entries(other.path()), ["file.antipode-world"], "{what}");
    }
}

#[test]
fn a_world_in_play_is_not_exported() {
    let dir = dug();
    let mut playing =
        antipode_tests::background::Background::begin(dir.path(), "load Kept\nprobe\nwait 80000");
    playing.next_line().unwrap();
    let file = dir.path().join("file");
    let (status, _, mistake) = saves(dir.path(), &["export", "Kept", file.to_str().unwrap()]);
    playing.kill();
    assert_eq!(status, Some(1));
    assert!(mistake.contains("\"Kept\" is in use"), "{mistake}");
    assert_eq!(entries(dir.path()), ["kept"]);
}
