//! A directory of folders, each something with a name of its own: how one is made, named and thrown away so that nobody
//! ever finds half of it. Worlds lie in one such directory, rooms in another.

use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::error::StorageError;
use crate::scratch::{self, Scratch};
use crate::slug::{numbered, slug_or};
use crate::turn::Turn;
use crate::{atomic_file, regular};

/// A directory of folders. Need not exist until something is made in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFolders {
    path: PathBuf,
}

impl NamedFolders {
    /// The directory `path`.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into() }
    }

    /// The directory.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Waits until nobody else gives names here. They wait until what is returned is dropped.
    ///
    /// # Errors
    /// [`StorageError::Busy`], failures of the file system.
    pub fn turn(&self) -> Result<Turn, StorageError> {
        Turn::wait(&self.path)
    }

    /// A hidden folder here for something unfinished, which is gone when it is dropped. The directory is made if need
    /// be; `purpose` is one word of small letters.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn scratch(&self, purpose: &str) -> Result<Scratch, StorageError> {
        let made = fs::create_dir_all(&self.path);
        made.map_err(|error| StorageError::place("Making", &self.path, error))?;
        Scratch::new(&self.path, purpose)
    }

    /// Moves what is finished in a hidden folder to the first free folder name for `name`, which is returned; `other`
    /// is for names without a letter that file systems agree on.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn settle(
        &self,
        scratch: &Scratch,
        name: &str,
        other: &str,
    ) -> Result<String, StorageError> {
        let base = slug_or(name, other);
        let mut number = 1;
        loop {
            let slug = numbered(&base, number);
            let target = self.path.join(&slug);
            // The check keeps an empty directory; the rename refuses a full one made meanwhile.
            if !target.exists() {
                match fs::rename(scratch.path(), &target) {
                    Ok(()) => {
                        atomic_file::sync_dir(&self.path);
                        return Ok(slug);
                    }
                    Err(_) if target.exists() => {}
                    Err(error) => return Err(StorageError::io("Making", &target, error)),
                }
            }
            number += 1;
        }
    }

    /// Throws a folder away for good: aside first, so that half of it is never found; what cannot be removed is put back.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn discard(&self, slug: &str) -> Result<(), StorageError> {
        let aside = self.scratch("trash")?;
        let (dir, moved) = (self.path.join(slug), aside.path().join(slug));
        let said = |error| StorageError::io("Deleting", &dir, error);
        fs::rename(&dir, &moved).map_err(said)?;
        atomic_file::sync_dir(&self.path);
        fs::remove_dir_all(&moved).map_err(|error| {
            // Failing, it stays in the hidden directory, which the next sweep tries to remove.
            let _ = fs::rename(&moved, &dir);
            said(error)
        })
    }

    /// The folders here that have a regular file of that name, in the order of their names; what killed processes have
    /// left unfinished is removed. Folders behind links are not among them.
    ///
    /// # Errors
    /// If the directory cannot be read; a missing one is empty.
    pub fn folders_with(&self, file: &str) -> Result<Vec<String>, StorageError> {
        scratch::sweep(&self.path);
        let entries = match fs::read_dir(&self.path) {
            Ok(entries) => entries,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(StorageError::place("Reading", &self.path, error)),
        };
        let mut found = Vec::new();
        for entry in entries {
            let entry = StorageError::at("Reading", &self.path, entry)?;
            let is_dir = entry.file_type().is_ok_and(|kind| kind.is_dir());
            let Ok(name) = entry.file_name().into_string() else {
                continue;
            };
            let has_file =
                fs::symlink_metadata(entry.path().join(file)).is_ok_and(|data| data.is_file());
            if is_dir && has_file && !name.starts_with('.') {
                found.push(name);
            }
        }
        found.sort();
        Ok(found)
    }
}

/// Reads a regular file of at most `limit` bytes, not through a link.
///
/// # Errors
/// As the system has them; [`ErrorKind::InvalidInput`] and [`ErrorKind::InvalidData`], in words, for what is no such file.
pub fn read_file(path: &Path, limit: u64) -> std::io::Result<Vec<u8>> {
    regular::read_own(path, limit)
}

/// Replaces a file by one of `bytes`: a reader finds the old or the new, never a part.
///
/// # Errors
/// Failures of the file system.
pub fn replace_file(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    StorageError::at("Writing", path, atomic_file::replace(path, bytes))
}

/// Makes the file `file`, which must not exist, whole or not at all: `write` has the place to write it first.
///
/// # Errors
/// [`StorageError::Exists`], what `write` says, failures of the file system.
pub fn make_file(
    file: &Path,
    write: impl FnOnce(&Scratch, &Path) -> Result<(), StorageError>,
) -> Result<(), StorageError> {
    if fs::symlink_metadata(file).is_ok() {
        let path = file.to_path_buf();
        return Err(StorageError::Exists { path });
    }
    let beside = match file.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    // Where there is no directory none is made: it is more likely a slip of the pen.
    StorageError::at("Writing to", beside, fs::metadata(beside))?;
    // There and not where things are kept: that disk may be full, and this the way to make room.
    let scratch = Scratch::new(beside, "export")?;
    let finished = scratch.path().join("archive");
    write(&scratch, &finished)?;
    put(&finished, file)?;
    atomic_file::sync_dir(beside);
    Ok(())
}

/// Gives a finished file its name, which must be free. A link is made in one step and
/// never over another file; a file system without links gets the check and a rename.
fn put(finished: &Path, file: &Path) -> Result<(), StorageError> {
    let exists = || StorageError::Exists {
        path: file.to_path_buf(),
    };
    match fs::hard_link(finished, file) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == ErrorKind::AlreadyExists => Err(exists()),
        Err(_) if fs::symlink_metadata(file).is_ok() => Err(exists()),
        Err(_) => StorageError::at("Writing", file, fs::rename(finished, file)),
    }
}

/// Makes a new file with these bytes, and the folders that it lies in.
///
/// # Errors
/// Failures of the file system.
pub fn new_file(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    use std::io::Write;
    if let Some(parent) = path.parent() {
        StorageError::at("Making", parent, fs::create_dir_all(parent))?;
    }
    let mut file = StorageError::at("Making", path, File::create_new(path))?;
    let written = file.write_all(bytes).and_then(|()| file.sync_all());
    StorageError::at("Writing", path, written)
}
