//! Errors of this program: each is one sentence that says what to do.

use std::fmt;
use std::io;
use std::path::PathBuf;

/// A failure of a task.
#[derive(Debug)]
pub enum Error {
    /// The command line makes no sense; what is wrong with it.
    Usage(String),
    /// A program could not be started at all.
    Start { program: String, source: io::Error },
    /// A step ran and failed; what it ran is a line to try by hand.
    Step { name: String, command: String },
    /// A part of the checkout could not be read.
    Unreadable { path: PathBuf, source: io::Error },
    /// A directory or file for the tests could not be made.
    Scratch { path: PathBuf, source: io::Error },
    /// Xvfb started and gave no display; its last words.
    NoDisplay(String),
    /// openbox started and manages nothing; where its words are.
    NoWindowManager(PathBuf),
    /// apt would have to run as root, and there is no sudo.
    NotRoot { command: String },
    /// What was packed is too large to be sent.
    TooLarge {
        path: PathBuf,
        bytes: u64,
        most_bytes: u64,
    },
    /// apt did not install the packages.
    Install { command: String },
}

impl Error {
    /// The exit status: 2 for wrong usage, 1 for a failure at run time.
    pub fn status(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            _ => 1,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(problem) => {
                write!(f, "{problem}; these are the commands:\n\n{}", super::USAGE)
            }
            Self::Start { program, source } => {
                write!(
                    f,
                    "`{program}` could not be started ({source}); is it installed and on the PATH?"
                )
            }
            Self::Step { name, command } => {
                write!(
                    f,
                    "the step \"{name}\" failed; its messages are above, and `{command}` runs it alone"
                )
            }
            Self::Unreadable { path, source } => write!(
                f,
                "`{}` of the checkout could not be read ({source}); check it out anew",
                path.display()
            ),
            Self::Scratch { path, source } => write!(
                f,
                "the tests need `{}`, which could not be made ({source}); set TMPDIR to a writable directory",
                path.display()
            ),
            Self::NoDisplay(words) => write!(
                f,
                "Xvfb gave no display for the window tests; try `Xvfb -displayfd 1` by hand. It said: {words}"
            ),
            Self::NoWindowManager(log) => write!(
                f,
                "openbox did not come up on the display for the window tests; its words are in `{}`",
                log.display()
            ),
            Self::NotRoot { command } => write!(
                f,
                "installing needs root and there is no sudo; run `{command}` as root, or go on without with --no-install"
            ),
            Self::TooLarge {
                path,
                bytes,
                most_bytes,
            } => write!(
                f,
                "`{}` has {:.1} MB, and at most {:.0} MB may be sent; look with `tar -tvzf` at what has grown",
                path.display(),
                *bytes as f64 * 1e-6,
                *most_bytes as f64 * 1e-6
            ),
            Self::Install { command } => write!(
                f,
                "`{command}` failed; its messages are above. Mend that, or go on without with --no-install"
            ),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Start { source, .. } | Self::Scratch { source, .. } => Some(source),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_names_the_command_to_try_by_hand() {
        let error = Error::Step {
            name: "lints".into(),
            command: "cargo clippy".into(),
        };
        assert_eq!(error.status(), 1);
        assert!(error.to_string().contains("`cargo clippy`"));
    }
}
