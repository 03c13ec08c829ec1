//! Many at once in one directory of worlds: no name is given twice.
//!
//! A program of its own: a child that starts has, for a moment, the locks of all files that are open in its parent,
//! and a world that another test has just closed would be in use.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

#[path = "it/common/mod.rs"]
mod common;

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Barrier;

use antipode_storage::{NameError, SavesDir, StorageError};
use common::meta;

/// Set for the child only: the directory in which it should make a world.
const CHILD_SAVES: &str = "ANTIPODE_TEST_CROWD_SAVES";
const PROCESSES: usize = 12;
const THREADS: usize = 8;

/// Not a test of its own: what a child process does, as soon as it is told to.
#[test]
fn child_makes_one_world() {
    let Some(dir) = std::env::var_os(CHILD_SAVES) else {
        return;
    };
    println!("\nready");
    std::io::stdin().read_line(&mut String::new()).unwrap();
    match SavesDir::new(dir).create(&meta("Same")) {
        Ok(_) => println!("\nmade"),
        Err(StorageError::Name(NameError::Taken { .. })) => println!("\ntaken"),
        Err(other) => println!("\n{other}"),
    }
}

fn child(saves: &Path) -> (Child, BufReader<impl Read>) {
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "child_makes_one_world", "--nocapture"])
        .env(CHILD_SAVES, saves)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    while line.trim() != "ready" {
        line.clear();
        assert_ne!(lines.read_line(&mut line).unwrap(), 0, "no child");
    }
    (child, lines)
}

fn names(saves: &SavesDir) -> BTreeSet<String> {
    let worlds = saves.list().unwrap();
    let names: BTreeSet<_> = worlds.iter().map(|w| w.name().to_owned()).collect();
    assert_eq!(names.len(), worlds.len(), "two worlds of one name");
    names
}

#[test]
fn of_many_processes_that_make_one_name_one_succeeds_and_the_others_are_told() {
    let dir = tempfile::tempdir().unwrap();
    let mut children: Vec<_> = (0..PROCESSES).map(|_| child(dir.path())).collect();
    for (child, _) in &mut children {
        child.stdin.take().unwrap().write_all(b"go\n").unwrap();
    }
    let mut said: Vec<_> = children
        .iter_mut()
        .map(|(child, lines)| {
            let mut text = String::new();
            lines.read_to_string(&mut text).unwrap();
            assert!(child.wait().unwrap().success());
            text.lines().find(|it| !it.is_empty()).unwrap().to_owned()
        })
        .collect();
    said.sort();
    let mut wanted = vec!["taken"; PROCESSES];
    wanted[0] = "made";
    assert_eq!(said, wanted);
    assert_eq!(
        names(&SavesDir::new(dir.path())),
        ["Same".to_owned()].into()
    );
}

/// Runs `work` in many threads at one moment.
fn at_once<T: Send>(work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let start = Barrier::new(THREADS);
    let (work, start) = (&work, &start);
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..THREADS)
            .map(|number| {
                scope.spawn(move || {
                    start.wait();
                    work(number)
                })
            })
            .collect();
        threads.into_iter().map(|it| it.join().unwrap()).collect()
    })
}

#[test]
fn of_many_that_rename_to_one_name_one_succeeds() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let made = at_once(|number| {
        saves
            .create(&meta(&format!("World {number}")))
            .map(|it| it.0)
    });
    let slugs: Vec<_> = made.into_iter().map(Result::unwrap).collect();
    let renamed = at_once(|number| saves.rename(&slugs[number], "Same"));
    assert_eq!(renamed.iter().filter(|it| it.is_ok()).count(), 1);
    for refusal in renamed.into_iter().filter_map(Result::err) {
        assert!(
            matches!(&refusal, StorageError::Name(NameError::Taken { .. })),
            "{refusal}"
        );
    }
    assert!(names(&saves).contains("Same"));
}

#[test]
fn what_many_import_gets_a_name_of_its_own_each() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("saves"));
    let (slug, world) = saves.create(&meta("Same")).unwrap();
    drop(world);
    let file = dir.path().join("same.antipode-world");
    saves.export(&slug, &file).unwrap();
    for made in at_once(|_| saves.import(&file)) {
        made.unwrap();
    }
    assert_eq!(names(&saves).len(), 1 + THREADS);
}
