//! A disk with no room left, played by a limit on the size of files.
//!
//! A program of its own: a child that starts has, for a moment, the locks of all files that are open in its parent,
//! and a world that another test has just closed would be in use.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

#[path = "it/common/mod.rs"]
mod common;

use std::path::Path;
use std::process::Command;

use antipode_storage::{StorageError, WorldStore};
use common::{batch, key, meta, samples, state};

/// Set for the child only: the world it should fill.
const CHILD_WORLD: &str = "ANTIPODE_TEST_FULL_WORLD";

/// Not a test of its own: what the child process does under the limit.
#[test]
fn child_writes_past_the_limit() {
    let Some(dir) = std::env::var_os(CHILD_WORLD) else {
        return;
    };
    let world = WorldStore::open(Path::new(&dir)).unwrap();
    world.commit(&batch(2, 1)).unwrap();
    let error = world.commit(&batch(2000, 2)).unwrap_err();
    assert!(matches!(error, StorageError::DiskFull { .. }), "{error}");
    let said = error.to_string();
    assert!(
        said.contains("no space left") && said.contains("\"Full\""),
        "{said}"
    );
    // The world goes on as it was, and a batch that fits is taken again.
    assert_eq!(world.chunk(&key(1)).unwrap(), Some(samples(1, 1)));
    world.commit(&batch(1, 3)).unwrap();
}

#[test]
fn a_full_disk_is_said_and_loses_nothing() {
    let dir = tempfile::tempdir().unwrap();
    drop(WorldStore::create(dir.path(), &meta("Full")).unwrap());
    // `trap ''` makes a write past the limit an error instead of a signal; 4096 blocks are 2 MiB
    // in a POSIX shell, 4 MiB in some; the batch of 2000 chunks is larger than both.
    let status = Command::new("sh")
        .args([
            "-c",
            "trap '' XFSZ; ulimit -f 4096; exec \"$0\" --exact child_writes_past_the_limit",
        ])
        .arg(std::env::current_exe().unwrap())
        .env(CHILD_WORLD, dir.path())
        .output()
        .unwrap();
    assert!(
        status.status.success(),
        "{}",
        String::from_utf8_lossy(&status.stdout)
    );
    let world = WorldStore::open(dir.path()).unwrap();
    assert!(world.problems().is_empty());
    assert_eq!(world.state().unwrap(), Some(state(3.0)));
    assert_eq!(world.chunk(&key(0)).unwrap(), Some(samples(0, 3)));
    assert_eq!(world.chunk(&key(1)).unwrap(), Some(samples(1, 1)));
    assert_eq!(world.edited_chunks().unwrap().len(), 2);
}
