//! The corpus and every find, replayed: what once broke something stays cured.
#![cfg(unix)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use antipode_fuzzing::watch::{self, MOST_WAIT};
use antipode_fuzzing::{TARGETS, Target};

/// The largest that the corpus may become, bytes.
const MOST_BYTES: u64 = 500_000;

fn fuzz() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz")
}

fn folders(kind: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(fuzz().join(kind)).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// The files of a target under `corpus` or `finds`; none where there is no such folder.
fn files(kind: &str, target: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(fuzz().join(kind).join(target))
        .into_iter()
        .flatten();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// Tries the files with the memory and the time that a target may have.
fn replay(target: &Target, files: &[PathBuf]) {
    let program = Path::new(env!("CARGO_BIN_EXE_antipode-fuzzing"));
    if let Err(said) = watch::replay(program, target.name, files, MOST_WAIT) {
        panic!("{}: {said}", target.name);
    }
}

#[test]
fn the_corpus_holds() {
    for target in TARGETS {
        let corpus = files("corpus", target.name);
        assert!(
            !corpus.is_empty(),
            "{}: `antipode-fuzzing corpus fuzz/corpus` makes one",
            target.name
        );
        replay(target, &corpus);
    }
}

#[test]
fn every_find_is_cured() {
    for target in TARGETS {
        replay(target, &files("finds", target.name));
    }
}

#[test]
fn the_folders_are_those_of_targets_and_stay_small() {
    let targets: BTreeSet<_> = TARGETS
        .iter()
        .map(|target| target.name.to_owned())
        .collect();
    // `cargo xtask fuzz` knows the targets by these.
    assert_eq!(folders("corpus"), targets);
    let finds = folders("finds");
    assert!(!finds.is_empty() && finds.is_subset(&targets), "{finds:?}");
    let all = TARGETS
        .iter()
        .flat_map(|target| [files("corpus", target.name), files("finds", target.name)]);
    let bytes: u64 = all
        .flatten()
        .map(|file| fs::metadata(file).unwrap().len())
        .sum();
    assert!(bytes <= MOST_BYTES, "{bytes} bytes");
}
