//! The program at work on a script while the test does something to it or to its world.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, ExitStatus, Stdio};

use serde_json::Value;

use crate::program::game;

/// A script that is being run.
#[derive(Debug)]
pub struct Background {
    child: Child,
    lines: BufReader<ChildStdout>,
}

/// How a program has ended.
#[derive(Debug)]
pub struct Ended {
    /// Exit status; none when a signal ended it.
    pub status: Option<i32>,
    /// Standard error.
    pub stderr: String,
}

impl Background {
    /// Begins a script without pictures, of the least view distance.
    pub fn begin(saves: &Path, script: &str) -> Self {
        let mut command = game(saves);
        command.args(["script", "-", "--adapter", "none", "--view-distance", "1"]);
        Self::begin_as(command, script)
    }

    /// Begins a command that reads a script from standard input.
    pub fn begin_as(mut command: Command, script: &str) -> Self {
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let _ = child.stdin.take().unwrap().write_all(script.as_bytes());
        let lines = BufReader::new(child.stdout.take().unwrap());
        Self { child, lines }
    }

    /// The next line it prints; none after the last.
    pub fn next_line(&mut self) -> Option<Value> {
        let mut line = String::new();
        self.lines
            .read_line(&mut line)
            .expect("its output can be read");
        // A killed program may have written a part of a line.
        line.ends_with('\n')
            .then(|| serde_json::from_str(&line).expect("a line of JSON"))
    }

    /// Kills it at once; the lines it had printed, from the next one on.
    pub fn kill(mut self) -> Vec<Value> {
        self.child.kill().expect("the program can be killed");
        self.child.wait().expect("the program can be waited for");
        std::iter::from_fn(|| self.next_line()).collect()
    }

    /// Asks it to end; the lines it had printed, from the next one on, and how it ended.
    pub fn terminate(mut self) -> (Vec<Value>, Ended) {
        signal("TERM", self.child.id());
        let lines = std::iter::from_fn(|| self.next_line()).collect();
        (lines, self.ended())
    }

    /// Waits for its end.
    pub fn ended(mut self) -> Ended {
        let mut rest = Vec::new();
        self.lines
            .read_to_end(&mut rest)
            .expect("its output can be read");
        let output = self.child.wait_with_output().expect("the program ends");
        Ended {
            status: output.status.code(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// Sends a signal to a process.
pub fn signal(name: &str, process: u32) {
    let sent = try_signal(name, process).expect("sh can be run");
    assert!(sent.success(), "{name} could not be sent to {process}");
}

/// The same, where the process may have ended already. By the shell's own `kill`: a small system has no program of that
/// name.
///
/// # Errors
/// When the shell cannot be run.
pub fn try_signal(name: &str, process: u32) -> std::io::Result<ExitStatus> {
    Command::new("sh")
        .args(["-c", &format!("kill -{name} {process}")])
        .status()
}
