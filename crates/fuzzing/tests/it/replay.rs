//! The corpus and every find, replayed: what once broke something stays cured.
#![cfg(unix)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use antipode_fuzzing::watch::{self, MOST_WAIT};
use antipode_fuzzing::{TARGETS, Target};

/// What once broke the store, and is replayed for ever; whatever is found next comes to these.
const FINDS: [&str; 4] = [
    "renamed-type-of-freed-pages",
    "renamed-type-of-unreachable-pages",
    "sealed-name-that-no-world-can-have",
    "torn-system-tree-over-a-page-of-gigabytes",
];

/// The largest that the corpus may become, bytes.
const MOST_BYTES: u64 = 500_000;

fn fuzz() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz")
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
    let store = files("finds", "store");
    for find in FINDS {
        let there = store.iter().any(|path| path.ends_with(find));
        assert!(there, "{find} is missing");
    }
    for target in TARGETS {
        replay(target, &files("finds", target.name));
    }
}

#[test]
fn every_target_is_known_to_the_fuzzer_and_the_corpus_stays_small() {
    let manifest = fs::read_to_string(fuzz().join("Cargo.toml")).unwrap();
    let names = manifest
        .lines()
        .filter_map(|line| line.strip_prefix("name = \""))
        .skip(1);
    let names: BTreeSet<_> = names.map(|name| name.trim_end_matches('"')).collect();
    assert_eq!(names, TARGETS.iter().map(|target| target.name).collect());
    let all = TARGETS
        .iter()
        .flat_map(|target| [files("corpus", target.name), files("finds", target.name)]);
    let bytes: u64 = all
        .flatten()
        .map(|file| fs::metadata(file).unwrap().len())
        .sum();
    assert!(bytes <= MOST_BYTES, "{bytes} bytes");
}
