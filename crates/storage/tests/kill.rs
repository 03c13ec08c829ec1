//! `kill -9` at any moment, and two processes at one world.
//!
//! A program of its own: a child that starts has, for a moment, the locks of all files that are open in its parent,
//! and a world that another test has just closed would be in use.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

#[path = "it/common/mod.rs"]
mod common;

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};

use antipode_storage::{SavesDir, StorageError, WorldStore};
use common::{batch, key, meta, samples, state};

/// Set for the child only: the world it should play.
const CHILD_WORLD: &str = "ANTIPODE_TEST_CHILD_WORLD";
const CHUNKS: i32 = 6;

/// Not a test of its own: what the child process does, until it is killed.
#[test]
fn child_commits_until_killed() {
    let Some(dir) = std::env::var_os(CHILD_WORLD) else {
        return;
    };
    let world = WorldStore::open(Path::new(&dir)).unwrap();
    let mut out = std::io::stdout();
    let first = world
        .state()
        .unwrap()
        .map_or(0, |state| state.simulated_s as i32);
    for commit in first + 1.. {
        world.commit(&batch(CHUNKS, commit)).unwrap();
        // The parent counts what is durable by these lines.
        writeln!(out, "committed {commit}").unwrap();
        out.flush().unwrap();
    }
}

fn spawn(dir: &Path) -> (Child, BufReader<ChildStdout>) {
    spawn_as("child_commits_until_killed", CHILD_WORLD, dir)
}

fn spawn_as(test: &str, variable: &str, dir: &Path) -> (Child, BufReader<ChildStdout>) {
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", test, "--nocapture", "--test-threads=1"])
        .env(variable, dir)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let lines = BufReader::new(child.stdout.take().unwrap());
    (child, lines)
}

/// Set for the child only: the directory in which it should make and delete worlds.
const CHILD_SAVES: &str = "ANTIPODE_TEST_CHILD_SAVES";

/// Not a test of its own: what the other child process does, until it is killed.
#[test]
fn child_makes_and_deletes_until_killed() {
    let Some(dir) = std::env::var_os(CHILD_SAVES) else {
        return;
    };
    let saves = SavesDir::new(dir);
    let mut out = std::io::stdout();
    for round in 1.. {
        let (slug, world) = saves.create(&meta("Brief")).unwrap();
        drop(world);
        saves.delete(&slug).unwrap();
        writeln!(out, "committed {round}").unwrap();
        out.flush().unwrap();
    }
}

/// Reads until the child has said `count` times that a commit is durable; the last number.
fn wait_for(lines: &mut BufReader<ChildStdout>, count: usize) -> i32 {
    let mut last = 0;
    let mut seen = 0;
    while seen < count {
        let mut line = String::new();
        assert_ne!(
            lines.read_line(&mut line).unwrap(),
            0,
            "the child ended by itself"
        );
        // The test harness writes to the same line before the first.
        if let Some((_, number)) = line.trim().rsplit_once("committed ") {
            last = number.parse().unwrap();
            seen += 1;
        }
    }
    last
}

#[test]
fn killed_at_any_moment_every_commit_is_whole() {
    let dir = tempfile::tempdir().unwrap();
    drop(WorldStore::create(dir.path(), &meta("Mortal")).unwrap());
    for commits in [1, 2, 3, 5, 8, 13, 4, 1] {
        let (mut child, mut lines) = spawn(dir.path());
        let durable = wait_for(&mut lines, commits);
        child.kill().unwrap();
        child.wait().unwrap();
        let world = WorldStore::open(dir.path()).unwrap();
        assert!(world.problems().is_empty(), "{:?}", world.problems());
        let found = world.state().unwrap().unwrap().simulated_s as i32;
        assert!(
            found >= durable,
            "commit {durable} was durable, {found} was found"
        );
        assert_eq!(world.state().unwrap(), Some(state(f64::from(found))));
        for x in 0..CHUNKS {
            assert_eq!(
                world.chunk(&key(x)).unwrap(),
                Some(samples(x, found)),
                "chunk {x} of {found}"
            );
        }
        assert_eq!(world.meta(), meta("Mortal"));
    }
}

#[test]
fn a_second_process_is_refused_while_the_first_plays() {
    let dir = tempfile::tempdir().unwrap();
    drop(WorldStore::create(dir.path(), &meta("Single")).unwrap());
    let (mut child, mut lines) = spawn(dir.path());
    wait_for(&mut lines, 1);
    let refusal = WorldStore::open(dir.path()).map(drop).unwrap_err();
    wait_for(&mut lines, 1);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(matches!(refusal, StorageError::InUse { .. }), "{refusal}");
    assert!(refusal.to_string().contains("\"Single\" is in use"));
    assert!(
        WorldStore::open(dir.path()).is_ok(),
        "the lock goes with the process"
    );
}

#[test]
fn nothing_hidden_stays_of_a_process_killed_while_it_makes_and_deletes() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let hidden = || {
        let entries = std::fs::read_dir(dir.path()).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        // The lock of the directory stays.
        names
            .filter(|name| name.starts_with('.') && name != ".antipode.lock")
            .count()
    };
    for rounds in [1, 2, 3, 1, 4, 2] {
        let test = "child_makes_and_deletes_until_killed";
        let (mut child, mut lines) = spawn_as(test, CHILD_SAVES, dir.path());
        wait_for(&mut lines, rounds);
        // While it lives, nobody takes its directories away: it would end with a panic.
        for _ in 0..20 {
            saves.list().unwrap();
        }
        wait_for(&mut lines, rounds);
        child.kill().unwrap();
        child.wait().unwrap();
        for world in saves.list().unwrap() {
            assert_eq!(world.problem, None);
            saves.delete(&world.slug).unwrap();
        }
        assert_eq!(hidden(), 0);
    }
}
