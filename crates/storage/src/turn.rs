//! Whose turn it is to give worlds their names.
//!
//! Between the look whether a name is free and the world of that name others may do the
//! same, in this process or another. So whoever names a world holds the lock of the
//! directory of worlds meanwhile, and others wait for a bounded time. The lock's file
//! stays; what is in it is of no matter.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::time::{Duration, Instant};

use crate::error::StorageError;
use crate::regular::{Entry, is_named};

const LOCK_FILE: &str = ".antipode.lock";
/// A turn lasts as long as a few commits; one of so many seconds is stuck.
const PATIENCE: Duration = Duration::from_secs(10);
/// Between two looks whether the turn has come.
const PAUSE: Duration = Duration::from_millis(5);

/// The turn, until it is dropped.
#[derive(Debug)]
pub struct Turn {
    _held: File,
}

impl Turn {
    /// Waits for the turn in the directory `saves`, which is made if need be.
    pub(crate) fn wait(saves: &Path) -> Result<Self, StorageError> {
        Self::wait_for(saves, PATIENCE)
    }

    fn wait_for(saves: &Path, patience: Duration) -> Result<Self, StorageError> {
        fs::create_dir_all(saves).map_err(|error| StorageError::place("Making", saves, error))?;
        let began = Instant::now();
        let mut file = open(saves)?;
        loop {
            match Self::take(file, saves)? {
                Ok(turn) => return Ok(turn),
                Err(others) if began.elapsed() < patience => file = others,
                Err(_) => {
                    let dir = saves.to_path_buf();
                    return Err(StorageError::Busy { dir });
                }
            }
            std::thread::sleep(PAUSE);
        }
    }

    /// Takes the turn by the lock's file, or gives back the file to try next.
    fn take(file: File, saves: &Path) -> Result<Result<Self, File>, StorageError> {
        match file.try_lock() {
            Ok(()) if is_named(&file, &saves.join(LOCK_FILE)) => Ok(Ok(Self { _held: file })),
            // Deleted while somebody had it: others go by the one that has come in its place.
            Ok(()) => Ok(Err(open(saves)?)),
            Err(TryLockError::WouldBlock) => Ok(Err(file)),
            // A file system without locks is no reason to play without worlds.
            Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {
                tracing::warn!(saves = %saves.display(), "this disk has no locks: two games at once may give one name twice");
                Ok(Ok(Self { _held: file }))
            }
            Err(TryLockError::Error(error)) => Err(StorageError::io("Locking", saves, error)),
        }
    }
}

/// Opens the lock's file, which is made if need be.
fn open(saves: &Path) -> Result<File, StorageError> {
    // A refusal is told of the directory: hidden names mean nothing to a player.
    StorageError::at("Writing to", saves, open_lock(&saves.join(LOCK_FILE)))
}

fn open_lock(path: &Path) -> io::Result<File> {
    match Entry::at(path)? {
        Entry::Missing | Entry::File { .. } => {
            let made = File::options()
                .create(true)
                .truncate(false)
                .write(true)
                .open(path);
            match made {
                // Another user's lock in a directory of both: reading is enough to take it.
                Err(error) if error.kind() == ErrorKind::PermissionDenied => {
                    File::open(path).map_err(|_| error)
                }
                made => made,
            }
        }
        Entry::Other(kind) => Err(io::Error::new(
            ErrorKind::InvalidInput,
            format!("{LOCK_FILE} in it is {kind}, not a file"),
        )),
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;

    #[test]
    fn one_turn_at_a_time_and_the_wait_for_it_ends_in_a_sentence() {
        let dir = tempfile::tempdir().unwrap();
        let saves = dir.path().join("saves");
        let turn = Turn::wait(&saves).unwrap();
        let refusal = Turn::wait_for(&saves, Duration::ZERO).map(drop);
        let sentence = refusal.unwrap_err().to_string();
        assert!(
            sentence.contains("Another game") && sentence.contains("Try again"),
            "{sentence}"
        );
        drop(turn);
        assert!(Turn::wait_for(&saves, Duration::ZERO).is_ok());
    }

    #[test]
    fn a_lock_that_was_deleted_gives_nobody_the_turn() {
        let dir = tempfile::tempdir().unwrap();
        // One waits with the old file open, which is deleted, and another has the new one.
        let old = open(dir.path()).unwrap();
        fs::remove_file(dir.path().join(LOCK_FILE)).unwrap();
        let turn = Turn::wait(dir.path()).unwrap();
        let next = Turn::take(old, dir.path()).unwrap().map(drop).unwrap_err();
        let next = Turn::take(next, dir.path()).unwrap().map(drop).unwrap_err();
        drop(turn);
        assert!(Turn::take(next, dir.path()).unwrap().is_ok());
    }

    #[test]
    fn something_else_in_the_place_of_the_lock_is_refused_without_waiting() {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join(LOCK_FILE)).unwrap();
        let sentence = Turn::wait(dir.path()).map(drop).unwrap_err().to_string();
        assert!(sentence.contains("is a directory"), "{sentence}");
    }

    /// Whoever may write everything, as root may, is refused nothing here.
    #[cfg(unix)]
    #[test]
    fn a_lock_that_somebody_else_made_is_no_hindrance() {
        use std::os::unix::fs::PermissionsExt;
        let dir = tempfile::tempdir().unwrap();
        let lock = dir.path().join(LOCK_FILE);
        fs::write(&lock, b"").unwrap();
        fs::set_permissions(&lock, fs::Permissions::from_mode(0o444)).unwrap();
        let turn = Turn::wait(dir.path()).unwrap();
        assert!(Turn::wait_for(dir.path(), Duration::ZERO).is_err());
        drop(turn);
        assert!(Turn::wait_for(dir.path(), Duration::ZERO).is_ok());
    }
}
