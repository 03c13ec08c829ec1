//! A directory shown in the system's own way.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

/// The system's program that shows a directory.
const PROGRAM: &str = if cfg!(target_os = "windows") {
    "explorer"
} else if cfg!(target_os = "macos") {
    "open"
} else {
    "xdg-open"
};
/// Whether that program's exit status tells anything: `explorer` ends with 1 when all is well.
const STATUS_TELLS: bool = !cfg!(target_os = "windows");
/// How long a failure is waited for, in looks.
const LOOKS: u32 = 60;
const LOOK: Duration = Duration::from_millis(50);

/// Why a directory was not shown.
#[derive(Debug, PartialEq)]
pub struct FolderProblem {
    /// The directory.
    pub dir: PathBuf,
    /// Why.
    pub reason: Reason,
}

/// Why a directory was not shown.
#[derive(Debug, PartialEq)]
pub enum Reason {
    /// The system's program for it is not there.
    NoProgram,
    /// The program says that it failed.
    Refused,
    /// What the system said.
    System(String),
}

/// Shows a directory. Waits some seconds for a failure, so not for the main thread; a program that stays is left
/// to itself.
///
/// # Errors
/// When the directory or the program is not there, or the program fails at once.
pub fn open(dir: &Path) -> Result<(), FolderProblem> {
    open_with(PROGRAM, dir)
}

fn open_with(program: &str, dir: &Path) -> Result<(), FolderProblem> {
    let problem = |reason| FolderProblem {
        dir: dir.to_path_buf(),
        reason,
    };
    // In full, or a name that begins with a dash would be taken for an option.
    let whole = dir
        .canonicalize()
        .map_err(|error| problem(Reason::System(error.to_string())))?;
    let child = Command::new(program)
        .arg(&whole)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let child = child.map_err(|error| match error.kind() {
        ErrorKind::NotFound => problem(Reason::NoProgram),
        _ => problem(Reason::System(error.to_string())),
    })?;
    if fails_soon(child) && STATUS_TELLS {
        return Err(problem(Reason::Refused));
    }
    Ok(())
}

/// Whether a program ends with a failure within the wait. One that goes on is waited for elsewhere, as a process
/// that nobody waits for stays in the system's list.
fn fails_soon(mut child: Child) -> bool {
    for _ in 0..LOOKS {
        match child.try_wait() {
            Ok(Some(status)) => return !status.success(),
            Ok(None) => thread::sleep(LOOK),
            Err(_) => return false,
        }
    }
    let waiting = thread::Builder::new().name("antipode-reaper".to_owned());
    let _ = waiting.spawn(move || child.wait());
    false
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn a_folder_that_is_not_shown_is_told_with_the_reason() {
        let dir = tempfile::tempdir().unwrap();
        assert_eq!(open_with("true", dir.path()), Ok(()));
        let reason = |program: &str, dir: &Path| {
            let problem = open_with(program, dir).unwrap_err();
            assert_eq!(problem.dir, dir);
            problem.reason
        };
        assert_eq!(reason("false", dir.path()), Reason::Refused);
        assert_eq!(
            reason("antipode-no-such-program", dir.path()),
            Reason::NoProgram
        );
        let gone = dir.path().join("gone");
        assert!(matches!(reason("true", &gone), Reason::System(_)));
    }
}
