//! The check of a file by its name, while nobody writes to it.

use std::fs::File;
use std::io;
use std::ops::Bound;
use std::path::Path;

use redb::backends::FileBackend;
use redb::{BackendError, StorageBackend};

use super::find::{self, Look};
use super::pages::Pages;
use super::{Checked, Fault, NO_SAVE, whole};
use crate::error::StorageError;
use crate::regular::{self, FileId};

/// Checks every page of the store in `path`, of the world called `world`.
///
/// # Errors
/// [`StorageError::Unreadable`] if the store must not be opened, [`StorageError::InUse`],
/// failures of the file system.
pub(crate) fn check(path: &Path, world: &str) -> Result<Checked, StorageError> {
    with_pages(path, world, whole::whole)
}

/// Whether a world's store, the file at `path`, can be trusted: every page is read, as before
/// each opening, but nothing is opened or changed. To see what that takes.
///
/// # Errors
/// [`StorageError::Unreadable`] if the store must not be opened, [`StorageError::InUse`],
/// failures of the file system.
pub fn check_pages(path: &Path) -> Result<(), StorageError> {
    check(path, &path.display().to_string()).map(drop)
}

/// Reads what the list of worlds tells of a store without opening it; `None` if it was not
/// closed.
///
/// # Errors
/// As [`check`], for the pages that lead there.
pub(crate) fn look(path: &Path, world: &str) -> Result<Option<Look>, StorageError> {
    with_pages(path, world, find::look)
}

/// A store's file that nobody opens for writing until this is dropped. Others may read it.
pub(crate) struct Held {
    file: File,
    id: FileId,
    _lock: FileBackend,
}

impl Held {
    /// Which file it is, wherever it is now.
    pub(crate) fn id(&self) -> FileId {
        self.id
    }
}

/// Keeps everybody from writing to the store in `path`, of the world called `world`.
///
/// # Errors
/// [`StorageError::InUse`] if somebody has it open for that, failures of the file system.
pub(crate) fn hold(path: &Path, world: &str) -> Result<Held, StorageError> {
    let reading = |error: io::Error| fault(path, Fault::Io(error));
    let (file, _) = regular::open(path).map_err(reading)?;
    let id = FileId::of(&file.metadata().map_err(reading)?);
    let lock = FileBackend::new(file.try_clone().map_err(reading)?)
        .map_err(|error| StorageError::store(path, world, error))?;
    match lock.try_lock_shared_range(Bound::Unbounded, Bound::Unbounded) {
        Ok(false) => Err(StorageError::InUse {
            world: world.to_owned(),
        }),
        // Where the file system has no locks, the store goes without, too.
        Ok(true) | Err(BackendError::Unsupported) => Ok(Held {
            file,
            id,
            _lock: lock,
        }),
        Err(BackendError::Io(error)) => Err(reading(error)),
        Err(error) => Err(reading(io::Error::other(error.to_string()))),
    }
}

/// Runs `work` while no process has the store open for writing.
fn with_pages<T>(
    path: &Path,
    world: &str,
    work: impl FnOnce(&mut Pages<File>) -> Result<T, Fault>,
) -> Result<T, StorageError> {
    let held = hold(path, world)?;
    let file = held.file.try_clone().map_err(Fault::Io);
    file.and_then(Pages::new)
        .and_then(|mut pages| work(&mut pages))
        .map_err(|error| fault(path, error))
}

/// A fault as a sentence.
fn fault(path: &Path, fault: Fault) -> StorageError {
    match fault {
        Fault::Torn(reason) | Fault::Wrong(reason) => StorageError::unreadable(path, reason),
        Fault::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            StorageError::unreadable(path, NO_SAVE)
        }
        Fault::Io(error) => StorageError::io("Reading", path, error),
    }
}
