//! Hidden directories for unfinished things, on the file system where they are to end,
//! so that a rename can finish them. The list of worlds skips names that begin with a dot.
//!
//! One is `.antipode-PURPOSE-PROCESS-NUMBER/`. In it are `contents/`, which is worked in, and
//! the game's mark, `antipode-scratch.lock`, which its process keeps locked as long as that
//! lives, whoever kills it. So what is left over can be told from what is at work even where
//! process numbers tell nothing, as across containers that share a directory, and
//! from whatever else has such a name: without the mark nothing is removed but an empty
//! directory, which is what a process leaves that was killed before it made the mark.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use crate::error::StorageError;
use crate::regular::is_named;

const PREFIX: &str = ".antipode-";
const MARK: &str = "antipode-scratch.lock";
const CONTENTS: &str = "contents";
/// How many names are tried. What killed processes of the same number have left may have some of them.
const MOST_TRIES: u32 = 1000;

/// A hidden directory for something unfinished.
#[derive(Debug)]
pub struct Scratch {
    dir: PathBuf,
    contents: PathBuf,
    /// The mark, locked until dropped.
    _held: File,
}

impl Scratch {
    /// A new hidden directory in `parent`, removed with what is in it when dropped.
    /// `purpose` is one word of small letters.
    pub(crate) fn new(parent: &Path, purpose: &str) -> Result<Self, StorageError> {
        // A refusal is told of the parent: hidden names mean nothing to a player.
        StorageError::at("Making", parent, Self::make(parent, purpose))
    }

    /// The same, with a refusal as the system gives it.
    pub(crate) fn make(parent: &Path, purpose: &str) -> io::Result<Self> {
        Self::make_held_by(hold, parent, purpose)
    }

    fn make_held_by(
        hold: impl Fn(&Path) -> io::Result<File>,
        parent: &Path,
        purpose: &str,
    ) -> io::Result<Self> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        for _ in 0..MOST_TRIES {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let dir = parent.join(format!("{PREFIX}{purpose}-{}-{number}", std::process::id()));
            match fs::create_dir(&dir) {
                Ok(()) => {}
                // Left over from a process of the same number that was killed, or somebody's own.
                Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
                Err(error) => return Err(error),
            }
            let contents = dir.join(CONTENTS);
            match hold(&dir.join(MARK)).and_then(|held| fs::create_dir(&contents).map(|()| held)) {
                Ok(held) => {
                    return Ok(Self {
                        dir,
                        contents,
                        _held: held,
                    });
                }
                Err(error) => {
                    remove(&dir);
                    // Otherwise a sweep came between making and locking.
                    let swept = matches!(error.kind(), ErrorKind::NotFound | ErrorKind::WouldBlock);
                    if !swept || !parent.exists() {
                        return Err(error);
                    }
                }
            }
        }
        Err(io::Error::other(
            "whatever the game makes there for unfinished work is taken away at once",
        ))
    }

    /// Where to work. It may be moved away as a whole.
    pub fn path(&self) -> &Path {
        &self.contents
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        remove(&self.dir);
    }
}

/// Makes and locks the mark; [`ErrorKind::WouldBlock`] if it was swept meanwhile.
fn hold(mark: &Path) -> io::Result<File> {
    let file = File::create_new(mark)?;
    // Where the file system has no locks nobody sweeps.
    if let Err(TryLockError::WouldBlock) = file.try_lock() {
        return Err(ErrorKind::WouldBlock.into());
    }
    if is_named(&file, mark) {
        Ok(file)
    } else {
        Err(ErrorKind::WouldBlock.into())
    }
}

/// Removes what killed processes have left in `parent`: directories with the mark of none that
/// lives, and empty ones of such names. Failing is no matter: the next sweep tries again.
pub fn sweep(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let is_dir = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if !is_dir || !entry.file_name().to_str().is_some_and(is_name) {
            continue;
        }
        let dir = entry.path();
        match abandoned_mark(&dir.join(MARK)) {
            // Locked while removing, so that two sweeps do not meet.
            Ok(Some(_held)) => remove(&dir),
            // Killed before the mark was made, or after it was removed: then it is empty, and
            // anything else stays.
            Ok(None) => drop(fs::remove_dir(&dir)),
            Err(_) => {}
        }
    }
}

/// Removes a directory whose mark this process has: the mark as the last thing in it, so that
/// another sweep can go on where this one ends, and nothing that the game did not make.
fn remove(dir: &Path) {
    let removed = fs::remove_dir_all(dir.join(CONTENTS));
    // Gone already if the contents were settled.
    if removed.is_ok() || removed.is_err_and(|error| error.kind() == ErrorKind::NotFound) {
        let _ = fs::remove_file(dir.join(MARK));
        let _ = fs::remove_dir(dir);
    }
}

/// Whether a name is one that [`Scratch::new`] gives.
fn is_name(name: &str) -> bool {
    let Some(rest) = name.strip_prefix(PREFIX) else {
        return false;
    };
    let parts: Vec<_> = rest.split('-').collect();
    let [purpose, process, number] = parts[..] else {
        return false;
    };
    !purpose.is_empty()
        && purpose.bytes().all(|byte| byte.is_ascii_lowercase())
        && [process, number].iter().all(|it| it.parse::<u32>().is_ok())
}

/// The mark, locked, if its process is gone; `None` if there is none. Any error says that
/// it is somebody's at work, or not the game's.
fn abandoned_mark(mark: &Path) -> io::Result<Option<File>> {
    match fs::symlink_metadata(mark) {
        Ok(data) if data.is_file() => {}
        Ok(_) => return Err(ErrorKind::InvalidInput.into()),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    }
    let file = File::options().write(true).open(mark)?;
    file.try_lock()?;
    if is_named(&file, mark) {
        Ok(Some(file))
    } else {
        Err(ErrorKind::WouldBlock.into())
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
        fs::create_dir_all(path).unwrap();
        fs::write(path.join("file"), b"x").unwrap();
    }

    /// What a process that was killed leaves.
    fn abandon(parent: &Path, name: &str) -> PathBuf {
        let dir = parent.join(name);
        fill(&dir.join(CONTENTS));
        fs::write(dir.join(MARK), b"").unwrap();
        dir
    }

    #[test]
    fn scratch_directories_are_apart_hidden_and_gone_in_the_end() {
        let dir = tempfile::tempdir().unwrap();
        let [a, b] = [(); 2].map(|()| Scratch::new(dir.path(), "new").unwrap());
        assert_ne!(a.path(), b.path());
        assert!(names(dir.path()).iter().all(|name| name.starts_with('.')));
        fs::write(a.path().join("file"), b"x").unwrap();
        fs::rename(b.path(), dir.path().join("settled")).unwrap();
        drop((a, b));
        assert_eq!(names(dir.path()), ["settled"]);
    }

    #[test]
    fn where_none_can_be_kept_it_is_said_and_none_is_left() {
        let dir = tempfile::tempdir().unwrap();
        // As where a mark is another file whenever the system is asked which it is.
        let lost = |mark: &Path| -> io::Result<File> {
            File::create_new(mark)?;
            Err(ErrorKind::WouldBlock.into())
        };
        let refusal = Scratch::make_held_by(lost, dir.path(), "new").map(drop);
        let said = StorageError::at("Making", dir.path(), refusal);
        let said = said.unwrap_err().to_string();
        assert!(
            said.contains("taken away at once. Check the disk"),
            "{said}"
        );
        assert_eq!(names(dir.path()), Vec::<String>::new());
    }

    #[test]
    fn what_lives_is_not_swept() {
        let dir = tempfile::tempdir().unwrap();
        let living = ["new", "trash", "import", "repair"]
            .map(|purpose| Scratch::new(dir.path(), purpose).unwrap());
        let before = names(dir.path());
        assert_eq!(before.len(), 4);
        sweep(dir.path());
        assert_eq!(names(dir.path()), before);
        assert!(living.iter().all(|scratch| scratch.path().is_dir()));
        drop(living);
        assert_eq!(names(dir.path()), Vec::<String>::new());
    }

    #[test]
    fn what_nobody_locks_is_swept_whatever_its_process() {
        let dir = tempfile::tempdir().unwrap();
        abandon(
            dir.path(),
            &format!(".antipode-new-{}-1000000", std::process::id()),
        );
        abandon(dir.path(), ".antipode-trash-1-7");
        // Killed at the first step of making it, and in the middle of a sweep.
        fs::create_dir(dir.path().join(".antipode-new-1-0")).unwrap();
        let half = abandon(dir.path(), ".antipode-copy-1-1");
        fs::remove_dir_all(half.join(CONTENTS)).unwrap();
        sweep(dir.path());
        assert_eq!(names(dir.path()), Vec::<String>::new());
    }

    #[test]
    fn what_somebody_put_into_an_abandoned_one_stays() {
        let dir = tempfile::tempdir().unwrap();
        let found = abandon(dir.path(), ".antipode-new-1-0");
        fs::write(found.join("letter"), b"x").unwrap();
        sweep(dir.path());
        sweep(dir.path());
        assert_eq!(names(&found), ["letter"]);
    }

    #[test]
    fn without_the_mark_nothing_is_removed_however_old_and_whatever_its_name() {
        let dir = tempfile::tempdir().unwrap();
        let strangers = [
            ".copy-2024-thesis",
            ".new-1-0",
            ".export-4294967295-0",
            ".antipode-new-1-0",
            ".antipode-copy-1-0",
            ".antipode-copy-2024-thesis",
            ".antipode-new-1-0-1",
            ".antipode-1-0",
            "world",
        ];
        for name in strangers {
            fill(&dir.path().join(name));
            // Somebody's own lock, beside it and in it.
            fs::write(dir.path().join(format!("{name}.lock")), b"").unwrap();
            fs::write(dir.path().join(name).join(".lock"), b"").unwrap();
            fs::create_dir(dir.path().join(name).join(CONTENTS)).unwrap();
            let past = std::time::UNIX_EPOCH;
            let open = File::open(dir.path().join(name)).unwrap();
            open.set_modified(past).unwrap();
        }
        // A mark under a name that the game does not give is none.
        fs::write(dir.path().join("world").join(MARK), b"").unwrap();
        // Nor is a directory in its place.
        fs::create_dir(dir.path().join(".antipode-new-1-0").join(MARK)).unwrap();
        let before = names(dir.path());
        sweep(dir.path());
        assert_eq!(names(dir.path()), before);
        for name in strangers {
            assert!(dir.path().join(name).join("file").exists(), "{name}");
            assert!(dir.path().join(name).join(CONTENTS).exists(), "{name}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_are_neither_followed_nor_removed() {
        use std::os::unix::fs::symlink;
        let dir = tempfile::tempdir().unwrap();
        let elsewhere = tempfile::tempdir().unwrap();
        let real = abandon(elsewhere.path(), "real");
        let saves = dir.path();
        // The directory itself, its mark, or its contents.
        symlink(&real, saves.join(".antipode-new-1-0")).unwrap();
        fill(&saves.join(".antipode-new-1-1").join(CONTENTS));
        symlink(real.join(MARK), saves.join(".antipode-new-1-1").join(MARK)).unwrap();
        let third = abandon(saves, ".antipode-new-1-2");
        fs::remove_dir_all(third.join(CONTENTS)).unwrap();
        symlink(real.join(CONTENTS), third.join(CONTENTS)).unwrap();
        sweep(saves);
        assert_eq!(
            names(saves),
            [".antipode-new-1-0", ".antipode-new-1-1"],
            "only the link in the third was the game's"
        );
        assert!(real.join(CONTENTS).join("file").exists());
        let second = saves.join(".antipode-new-1-1").join(CONTENTS);
        assert!(second.join("file").exists());
    }
}
