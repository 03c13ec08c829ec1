//! Small files written so that a reader sees the old or the new, never a part.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use crate::scratch::Scratch;

/// Replaces `path` by a file of `bytes`. What a killed process leaves of it [`crate::scratch::sweep`]
/// removes from the directory that it is in.
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let dir = path.parent().ok_or(io::ErrorKind::InvalidInput)?;
    let scratch = Scratch::make(dir, "file")?;
    let whole = scratch.path().join("whole");
    let mut file = File::create_new(&whole)?;
    file.write_all(bytes)?;
    file.sync_data()?;
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
