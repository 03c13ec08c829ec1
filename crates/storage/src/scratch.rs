//! Hidden directories for unfinished things, beside the worlds so that a rename
//! can finish them. The list of worlds skips names that begin with a dot.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use crate::error::StorageError;

const DAY: Duration = Duration::from_hours(24);

/// A hidden directory for something unfinished.
pub(crate) struct Scratch {
    path: PathBuf,
}

impl Scratch {
    /// A new hidden directory in `saves`, removed with what is in it when dropped.
    pub(crate) fn new(saves: &Path, purpose: &str) -> Result<Self, StorageError> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        StorageError::at("Making", saves, fs::create_dir_all(saves))?;
        sweep(saves);
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let path = saves.join(format!(".{purpose}-{}-{number}", std::process::id()));
            match fs::create_dir(&path) {
                Ok(()) => return Ok(Self { path }),
                // Left over from a process of the same number that was killed.
                Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(StorageError::io("Making", &path, error)),
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
    }
}

/// Removes what killed processes have left: a deleted world at once, anything else
/// after a day, since it may belong to a process at work. Failing is no matter.
fn sweep(saves: &Path) {
    for entry in fs::read_dir(saves).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let Some(name) = name.to_str() else { continue };
        let deleted = name.starts_with(".trash-");
        let unfinished = [".new-", ".import-", ".repair-"]
            .iter()
            .any(|purpose| name.starts_with(purpose));
        let modified = entry.metadata().and_then(|data| data.modified());
        let age = modified.ok().and_then(|modified| modified.elapsed().ok());
        if deleted || (unfinished && age.is_some_and(|age| age > DAY)) {
            let _ = fs::remove_dir_all(entry.path());
        }
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
    fn scratch_directories_are_apart_hidden_and_gone_in_the_end() {
        let dir = tempfile::tempdir().unwrap();
        let saves = dir.path().join("saves");
        let (a, b) = (
            Scratch::new(&saves, "new").unwrap(),
            Scratch::new(&saves, "new").unwrap(),
        );
        assert_ne!(a.path(), b.path());
        assert!(
            a.path()
                .file_name()
                .unwrap()
                .to_str()
                .unwrap()
                .starts_with('.')
        );
        fs::write(a.path().join("file"), b"x").unwrap();
        drop((a, b));
        assert_eq!(fs::read_dir(&saves).unwrap().count(), 0);
    }

    #[test]
    fn what_a_killed_process_left_is_swept_but_not_what_is_at_work() {
        let dir = tempfile::tempdir().unwrap();
        for name in [".trash-1-0", ".new-1-0", ".other", "world"] {
            fs::create_dir(dir.path().join(name)).unwrap();
            fs::write(dir.path().join(name).join("file"), b"x").unwrap();
        }
        let old = dir.path().join(".repair-1-0");
        fs::create_dir(&old).unwrap();
        fs::File::open(&old)
            .unwrap()
            .set_modified(std::time::UNIX_EPOCH)
            .unwrap();
        sweep(dir.path());
        let mut left: Vec<_> = fs::read_dir(dir.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        left.sort();
        assert_eq!(left, [".new-1-0", ".other", "world"]);
    }
}
