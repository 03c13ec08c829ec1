//! What only the system can do to a game: deny it something, or give it a small disk.
#![cfg(unix)]
#![allow(
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use antipode_testing::may_skip;

use crate::program::binary;

/// Nobody's number, on every system that has one.
const NOBODY: u32 = 65_534;

/// Whether no permission binds this user.
pub fn is_root() -> bool {
    // A directory that was just made belongs to whoever this is.
    let made = tempfile::tempdir().unwrap();
    fs::metadata(made.path()).unwrap().uid() == 0
}

/// The game as a user whom permissions bind: root is bound by none, so then as nobody. `None` where that cannot be had.
pub fn unprivileged(saves: &Path) -> Option<Command> {
    let mut command = if is_root() {
        let nobody = ["--reuid=65534", "--regid=65534", "--clear-groups"];
        let tried = Command::new("setpriv")
            .args(nobody)
            .arg("true")
            .stderr(Stdio::null())
            .status();
        if !tried.is_ok_and(|status| status.success()) {
            may_skip("an unprivileged user (this is root, and setpriv does not work)");
            return None;
        }
        let mut command = Command::new("setpriv");
        command.args(nobody).arg(binary());
        command
    } else {
        Command::new(binary())
    };
    command
        .env_remove("ANTIPODE_SAVES")
        .current_dir("/")
        .arg("--saves-dir")
        .arg(saves);
    Some(command)
}

/// Sets the permissions of a file or directory.
pub fn permit(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
}

/// Gives everything to the unprivileged user, where that is another.
pub fn give_away(saves: &Path) {
    permit(saves, 0o755);
    if !is_root() {
        return;
    }
    let mut all = vec![saves.to_path_buf()];
    while let Some(path) = all.pop() {
        if path.is_dir() {
            let entries = fs::read_dir(&path).unwrap();
            all.extend(entries.map(|entry| entry.unwrap().path()));
        }
        chown(&path, Some(NOBODY), Some(NOBODY)).unwrap();
    }
}

/// A file system in memory.
#[derive(Debug)]
pub struct SmallDisk(TempDir);

impl SmallDisk {
    /// Makes one with these options of `mount`; `None` where none may be made.
    pub fn new(options: &str) -> Option<Self> {
        let dir = tempfile::tempdir().unwrap();
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", options, "antipode-test"])
            .arg(dir.path())
            .stderr(Stdio::null())
            .status();
        if mounted.is_ok_and(|status| status.success()) {
            return Some(Self(dir));
        }
        may_skip("the right to mount a small file system");
        None
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg("-l").arg(self.0.path()).status();
    }
}
