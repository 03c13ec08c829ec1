//! Worlds in files, by the command line: out, in, and refused.

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

/// Everything in a directory, hidden or not, but the lock that stays among worlds.
fn entries(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name != ".antipode.lock")
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

#[test]
fn hidden_folders_of_others_are_left_alone_beside_an_export_and_among_the_worlds() {
    let dir = dug();
    let documents = tempfile::tempdir().unwrap();
    let strangers = [
        ".copy-2024-thesis",
        ".new-1-0",
        ".trash-4294967295-0",
        ".antipode-new-1-0",
        ".antipode-export-1-0",
    ];
    for place in [dir.path(), documents.path()] {
        for name in strangers {
            let folder = place.join(name);
            fs::create_dir(&folder).unwrap();
            fs::write(folder.join("chapter"), b"x").unwrap();
            // Somebody's own lock beside it, as older games had theirs.
            fs::write(place.join(format!("{name}.lock")), b"").unwrap();
            let past = std::time::UNIX_EPOCH;
            let open = fs::File::open(&folder).unwrap();
            open.set_modified(past).unwrap();
        }
    }
    // With the game's own mark, but in a folder that is not the game's.
    let marked = documents.path().join(".antipode-export-1-1");
    fs::create_dir(&marked).unwrap();
    fs::write(marked.join("antipode-scratch.lock"), b"").unwrap();
    let before = [dir.path(), documents.path()].map(entries);

    let file = documents.path().join("o.antipode-world");
    for arguments in [
        &["list"][..],
        &["export", "Kept", file.to_str().unwrap()],
        &["info", "Kept"],
        &["repair", "Kept"],
        &["verify", "Kept"],
    ] {
        let (status, _, mistake) = saves(dir.path(), arguments);
        assert_eq!(status, Some(0), "{arguments:?}: {mistake}");
    }
    fs::remove_file(file).unwrap();
    assert_eq!([dir.path(), documents.path()].map(entries), before);
    for place in [dir.path(), documents.path()] {
        for name in strangers {
            assert!(place.join(name).join("chapter").exists(), "{name}");
        }
    }
}

#[test]
fn a_damaged_world_is_repaired_and_a_forged_file_refused_by_a_process_of_its_own() {
    let dir = dug();
    let file = exported(&dir);
    let store = dir.path().join("kept").join("world.redb");
    let mut bytes = fs::read(&store).unwrap();
    // The header, without which nothing leads anywhere.
    bytes[..4096].fill(0xff);
    fs::write(&store, &bytes).unwrap();
    let (status, said, _) = saves(dir.path(), &["verify", "Kept"]);
    assert_eq!(status, Some(1), "{said}");
    let (status, said, mistake) = saves(dir.path(), &["repair", "Kept"]);
    assert_eq!(status, Some(0), "{mistake}");
    assert!(
        said.contains("changed chunks rescued") && said.contains("world.redb.damaged-1"),
        "{said}"
    );
    let (status, ..) = saves(dir.path(), &["verify", "Kept"]);
    assert_eq!(status, Some(0));

    let mut archive = fs::read(&file).unwrap();
    let middle = archive.len() / 2;
    archive[middle] ^= 1;
    let forged = dir.path().join("forged.antipode-world");
    fs::write(&forged, archive).unwrap();
    let (status, said, mistake) = saves(dir.path(), &["import", forged.to_str().unwrap()]);
    assert_eq!((status, said.as_str()), (Some(1), ""));
    assert!(
        mistake.contains("forged.antipode-world cannot be imported"),
        "{mistake}"
    );
    let hidden = entries(dir.path())
        .iter()
        .filter(|name| name.starts_with('.') && *name != ".antipode.lock")
        .count();
    assert_eq!(hidden, 0);
}
