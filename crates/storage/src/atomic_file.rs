//! Files written so that a reader sees the old or the new, never a part.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use crate::regular;
use crate::scratch::Scratch;

/// Replaces `path` by a file of `bytes`.
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    put(path, |whole| whole.write_all(bytes))
}

/// Puts a copy of the file `from` at `path`; when this returns, a power cut leaves it there.
pub(crate) fn copy(from: &Path, path: &Path) -> io::Result<()> {
    let (mut from, _) = regular::open(from)?;
    put(path, |whole| {
        io::copy(&mut from, whole)?;
        whole.set_permissions(from.metadata()?.permissions())
    })?;
    path.parent().into_iter().for_each(sync_dir);
    Ok(())
}

/// Has a file written elsewhere and puts it at `path` when it is whole and on the disk. What a killed
/// process leaves of it [`crate::scratch::sweep`] removes from the directory that it is in.
fn put(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let dir = path.parent().ok_or(io::ErrorKind::InvalidInput)?;
    let scratch = Scratch::make(dir, "file")?;
    let whole = scratch.path().join("whole");
    let mut file = File::create_new(&whole)?;
    write(&mut file)?;
    file.sync_all()?;
    fs::rename(&whole, path)
}

/// Makes the names in a directory durable, where the system can.
pub(crate) fn sync_dir(dir: &Path) {
    // Windows cannot open a directory as a file; there, names are journalled anyway.
    if let Ok(dir) = File::open(dir) {
        let _ = dir.sync_all();
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
    #[cfg(unix)]
    use crate::scratch;

    #[test]
    fn replacing_leaves_one_file_with_the_new_bytes() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.bin");
        replace(&path, b"old").unwrap();
        replace(&path, b"newer").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"newer");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_failure_leaves_what_was_there() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("taken");
        fs::create_dir(&path).unwrap();
        assert!(replace(&path, b"x").is_err());
        assert_eq!(
            fs::read_dir(dir.path()).unwrap().count(),
            1,
            "no temporary file stays"
        );
    }

    /// Set for the child only: the directory where it copies.
    #[cfg(unix)]
    const COPYING_CHILD: &str = "ANTIPODE_TEST_COPYING_CHILD";

    /// Not a test of its own: what the child process does, which may write less than that.
    #[cfg(unix)]
    #[test]
    fn child_copies_more_than_it_may() {
        if let Some(dir) = std::env::var_os(COPYING_CHILD) {
            let dir = Path::new(&dir);
            let error = copy(&dir.join("long"), &dir.join("copy")).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::FileTooLarge);
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_copy_that_finds_no_room_halfway_leaves_nothing() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("long"), [1; 9999]).unwrap();
        // As on a full disk: the first part is written, the next write is refused.
        let ended = std::process::Command::new("sh")
            .args(["-c", "trap '' XFSZ; ulimit -f 8; exec \"$0\" \"$@\""])
            .arg(std::env::current_exe().unwrap())
            .args([
                "--exact",
                "atomic_file::tests::child_copies_more_than_it_may",
            ])
            .env(COPYING_CHILD, dir.path())
            .output()
            .unwrap();
        assert!(ended.status.success(), "{ended:?}");
        let left: Vec<_> = fs::read_dir(dir.path()).unwrap().flatten().collect();
        assert!(left.len() == 1 && left[0].file_name() == "long", "{left:?}");
        copy(&dir.path().join("long"), &dir.path().join("copy")).unwrap();
        assert_eq!(fs::read(dir.path().join("copy")).unwrap(), [1; 9999]);
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 2);
    }

    /// Set for the child only: where it writes.
    #[cfg(unix)]
    const CHILD: &str = "ANTIPODE_TEST_KILLED_WRITER";

    /// Not a test of its own: what the child process does.
    #[cfg(unix)]
    #[test]
    fn child_writes_more_than_it_may() {
        if let Some(dir) = std::env::var_os(CHILD) {
            let _ = replace(&Path::new(&dir).join("thumbnail.png"), &[1; 9999]);
        }
    }

    #[cfg(unix)]
    #[test]
    fn what_a_process_killed_while_writing_leaves_is_swept() {
        let dir = tempfile::tempdir().unwrap();
        // The signal that comes with the limit kills it in the middle of writing.
        let ended = std::process::Command::new("sh")
            .args(["-c", "ulimit -f 0; ulimit -c 0; exec \"$0\" \"$@\""])
            .arg(std::env::current_exe().unwrap())
            .args([
                "--exact",
                "atomic_file::tests::child_writes_more_than_it_may",
            ])
            .env(CHILD, dir.path())
            .output()
            .unwrap();
        assert_eq!(ended.status.code(), None, "{ended:?}");
        let left = || fs::read_dir(dir.path()).unwrap().count();
        assert_eq!(left(), 1, "killed before it began");
        scratch::sweep(dir.path());
        assert_eq!(left(), 0);
    }
}
