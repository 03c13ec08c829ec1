//! Hidden directories for unfinished things, beside the worlds so that a rename
//! can finish them. The list of worlds skips names that begin with a dot.
//!
//! Beside each, `NAME.lock` is locked by its process as long as that lives, whoever
//! kills it. So what is left over can be told from what is at work even where
//! process numbers tell nothing, as across containers that share a directory. The
//! lock is not inside, since a finished directory becomes a world.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use crate::error::StorageError;
use crate::regular::{Entry, FileId};

const DAY: Duration = Duration::from_hours(24);
const PURPOSES: [&str; 6] = [
    ".new-", ".trash-", ".import-", ".repair-", ".copy-", ".export-",
];
const LOCK_SUFFIX: &str = ".lock";

/// A hidden directory for something unfinished.
pub(crate) struct Scratch {
    path: PathBuf,
    lock: PathBuf,
    /// Locked until dropped.
    _held: File,
}

impl Scratch {
    /// A new hidden directory in `saves`, removed with what is in it when dropped.
    /// `purpose` is one of `new`, `trash`, `import`, `repair`, `copy`, `export`.
    pub(crate) fn new(saves: &Path, purpose: &str) -> Result<Self, StorageError> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        fs::create_dir_all(saves).map_err(|error| StorageError::place("Making", saves, error))?;
        sweep(saves);
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let path = saves.join(format!(".{purpose}-{}-{number}", std::process::id()));
            let lock = lock_of(&path);
            // Before the directory: none is ever seen without its lock.
            // A refusal is told of the directory: its hidden names mean nothing to a player.
            let Some(held) = StorageError::at("Making", saves, hold(&lock))? else {
                continue;
            };
            match fs::create_dir(&path) {
                Ok(()) => {
                    return Ok(Self {
                        path,
                        lock,
                        _held: held,
                    });
                }
                Err(error) => {
                    let _ = fs::remove_file(&lock);
                    // Left over from a process of the same number that was killed.
                    if error.kind() != io::ErrorKind::AlreadyExists {
                        return Err(StorageError::io("Making", saves, error));
                    }
                }
            }
        }
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // Gone already if its contents were settled.
        let _ = fs::remove_dir_all(&self.path);
        let _ = fs::remove_file(&self.lock);
    }
}

fn lock_of(scratch: &Path) -> PathBuf {
    let mut name = scratch.as_os_str().to_owned();
    name.push(LOCK_SUFFIX);
    PathBuf::from(name)
}

/// Makes and locks a lock file; `None` if the name is taken or was swept meanwhile.
fn hold(lock: &Path) -> io::Result<Option<File>> {
    let file = match File::create_new(lock) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => return Ok(None),
        Err(error) => return Err(error),
    };
    // Where the file system has no locks, the age of the directory must do.
    if let Err(TryLockError::WouldBlock) = file.try_lock() {
        return Ok(None);
    }
    // A sweep between making and locking has removed the name.
    let is_named = FileId::at(lock)? == Some(FileId::of(&file.metadata()?));
    Ok(is_named.then_some(file))
}

/// Removes what killed processes have left, and nothing of a process that lives.
/// Failing is no matter: the next use of the directory tries again.
pub(crate) fn sweep(saves: &Path) {
    for entry in fs::read_dir(saves).into_iter().flatten().flatten() {
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        if !PURPOSES.iter().any(|purpose| name.starts_with(purpose)) {
            continue;
        }
        let scratch = saves.join(name.strip_suffix(LOCK_SUFFIX).unwrap_or(&name));
        let lock = lock_of(&scratch);
        // Held while removing, so that two sweeps do not meet.
        let Owner::Dead(_held) = owner(&scratch, &lock) else {
            continue;
        };
        let removed = fs::remove_dir_all(&scratch);
        if removed.is_ok() || removed.is_err_and(|error| error.kind() == io::ErrorKind::NotFound) {
            let _ = fs::remove_file(&lock);
        }
    }
}

/// Who may have left a scratch directory.
enum Owner {
    /// A process that is gone. Its lock is taken over, if there is one.
    Dead(Option<File>),
    /// A process that may be at work.
    Alive,
}

fn owner(scratch: &Path, lock: &Path) -> Owner {
    let by_age = || {
        if is_old(scratch) {
            Owner::Dead(None)
        } else {
            Owner::Alive
        }
    };
    match Entry::at(lock) {
        Ok(Entry::File { .. }) => {
            let Ok(file) = File::options().write(true).open(lock) else {
                return Owner::Alive;
            };
            match file.try_lock() {
                Ok(()) => Owner::Dead(Some(file)),
                Err(TryLockError::WouldBlock) => Owner::Alive,
                Err(TryLockError::Error(_)) => by_age(),
            }
        }
        Ok(Entry::Missing) if has_ended(scratch) => Owner::Dead(None),
        Ok(Entry::Missing) => by_age(),
        _ => Owner::Alive,
    }
}

/// Whether a directory without a lock was made long ago.
fn is_old(scratch: &Path) -> bool {
    let modified = fs::metadata(scratch).and_then(|data| data.modified());
    let age = modified.ok().and_then(|modified| modified.elapsed().ok());
    age.is_some_and(|age| age > DAY)
}

/// Whether the process whose number is in the name is known to be gone; false where
/// the system does not list its processes as files.
fn has_ended(scratch: &Path) -> bool {
    let name = scratch.file_name().and_then(|name| name.to_str());
    let process: Option<u32> = name
        .and_then(|name| name.split('-').nth(1))
        .and_then(|number| number.parse().ok());
    let processes = Path::new("/proc");
    process.is_some_and(|process| {
        processes.join("self/stat").exists() && !processes.join(process.to_string()).exists()
    })
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

    fn names(dir: &Path) -> Vec<String> {
        let entries = fs::read_dir(dir).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// A directory with a file in it.
    fn fill(path: &Path) {
        fs::create_dir(path).unwrap();
        fs::write(path.join("file"), b"x").unwrap();
    }

    #[test]
    fn scratch_directories_are_apart_hidden_and_gone_in_the_end() {
        let dir = tempfile::tempdir().unwrap();
        let saves = dir.path().join("saves");
        let [a, b] = [(); 2].map(|()| Scratch::new(&saves, "new").unwrap());
        assert_ne!(a.path(), b.path());
        assert!(names(&saves).iter().all(|name| name.starts_with('.')));
        fs::write(a.path().join("file"), b"x").unwrap();
        drop((a, b));
        assert_eq!(names(&saves), Vec::<String>::new());
    }

    #[test]
    fn what_lives_is_not_swept() {
        let dir = tempfile::tempdir().unwrap();
        let living = ["new", "trash", "import", "repair"]
            .map(|purpose| Scratch::new(dir.path(), purpose).unwrap());
        let before = names(dir.path());
        assert_eq!(before.len(), 8);
        sweep(dir.path());
        assert_eq!(names(dir.path()), before);
        drop(living);
        assert_eq!(names(dir.path()), Vec::<String>::new());
    }

    #[test]
    fn what_nobody_locks_is_swept_with_its_lock() {
        let dir = tempfile::tempdir().unwrap();
        // Of this living process by its number: the lock is what counts.
        let dead = format!(".new-{}-1000000", std::process::id());
        fill(&dir.path().join(&dead));
        fs::write(dir.path().join(format!("{dead}.lock")), b"").unwrap();
        fs::write(dir.path().join(".trash-1-7.lock"), b"").unwrap();
        fs::write(dir.path().join("world.lock"), b"").unwrap();
        sweep(dir.path());
        assert_eq!(names(dir.path()), ["world.lock"]);
    }

    #[test]
    fn without_a_lock_the_process_or_the_age_tells() {
        let dir = tempfile::tempdir().unwrap();
        let own = format!(".new-{}-1000000", std::process::id());
        for name in [&own, ".other-1-0", "world"] {
            fill(&dir.path().join(name));
        }
        let old = dir.path().join(".repair-1-0");
        fs::create_dir(&old).unwrap();
        let past = std::time::UNIX_EPOCH;
        File::open(&old).unwrap().set_modified(past).unwrap();
        // No process has so high a number.
        let gone = ".import-4294967295-0";
        fill(&dir.path().join(gone));
        sweep(dir.path());
        let mut left = vec![own, ".other-1-0".to_owned(), "world".to_owned()];
        if !Path::new("/proc/self/stat").exists() {
            left.push(gone.to_owned());
        }
        left.sort();
        assert_eq!(names(dir.path()), left);
    }
}
