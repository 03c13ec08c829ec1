//! The program as a child process: scripts in, probes out.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// What a script run came to.
#[derive(Debug)]
pub struct Run {
    /// Exit status; none when it was killed.
    pub status: Option<i32>,
    /// The lines of standard output, parsed.
    pub lines: Vec<Value>,
    /// Standard error.
    pub stderr: String,
}

impl Run {
    /// The n-th printed line; the run must have succeeded.
    pub fn probe(&self, n: usize) -> &Value {
        assert_eq!(self.status, Some(0), "the script failed: {}", self.stderr);
        &self.lines[n]
    }
}

/// The built game, which stands beside the directory of the tests' own binaries.
///
/// # Panics
/// When it is not there: tests are run over the whole workspace so that it is.
pub fn binary() -> PathBuf {
    let test = std::env::current_exe().expect("the test knows its own path");
    let path = test
        .parent()
        .and_then(Path::parent)
        .expect("tests live in target/PROFILE/deps")
        .join("antipode");
    assert!(
        path.exists(),
        "{} is missing; run the tests of the whole workspace (--workspace)",
        path.display()
    );
    path
}

/// The game with a saves directory of its own and nothing of this machine's configuration.
pub fn game(saves: &Path) -> Command {
    let mut command = Command::new(binary());
    command
        .env_remove("ANTIPODE_SAVES")
        .arg("--saves-dir")
        .arg(saves)
        .current_dir(saves);
    command
}

/// Runs a script without pictures.
pub fn run(saves: &Path, script: &str) -> Run {
    run_with(saves, script, &["--adapter", "none"])
}

/// Runs a script with options of the command line.
///
/// # Panics
/// When the program cannot be started or prints what is not JSON.
pub fn run_with(saves: &Path, script: &str, options: &[&str]) -> Run {
    let mut child = game(saves)
        .args(["script", "-"])
        .args(options)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // A program that ends early closes the pipe; its status and stderr tell why.
    let _ = child.stdin.take().unwrap().write_all(script.as_bytes());
    let output = child.wait_with_output().expect("the program ends");
    let stdout = String::from_utf8(output.stdout).expect("standard output is UTF-8");
    let lines = stdout
        .lines()
        .map(|line| serde_json::from_str(line).unwrap_or_else(|e| panic!("not JSON ({e}): {line}")))
        .collect();
    Run {
        status: output.status.code(),
        lines,
        stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// A number in a probe, by a path such as `player.pos.1`.
///
/// # Panics
/// When there is no number there.
pub fn number(probe: &Value, path: &str) -> f64 {
    field(probe, path)
        .as_f64()
        .unwrap_or_else(|| panic!("{path} is no number in {probe}"))
}

/// A value in a probe, by a path such as `player.pos.1`.
///
/// # Panics
/// When there is none.
pub fn field<'a>(probe: &'a Value, path: &str) -> &'a Value {
    let pointer = format!("/{}", path.replace('.', "/"));
    probe
        .pointer(&pointer)
        .unwrap_or_else(|| panic!("no {path} in {probe}"))
}

/// A probe without the fields in which two runs of one script may differ.
pub fn comparable(probe: &Value) -> Value {
    let mut probe = probe.clone();
    if let Some(fields) = probe.as_object_mut() {
        for name in ["t", "fps", "memory_mb", "chunks", "adapter"] {
            fields.remove(name);
        }
        // What is in the air and pressed into the ground, and what is counted over a visit, no save keeps.
        fields.remove("particles");
        fields.remove("marks");
        if let Some(terrain) = fields.get_mut("terrain").and_then(Value::as_object_mut) {
            terrain.remove("dug");
            terrain.remove("built");
        }
        // It is of the land that a picture has of it, which the view distance and the pace of workers bound.
        if let Some(plants) = fields.get_mut("plants").and_then(Value::as_object_mut) {
            plants.remove("in_view");
        }
    }
    probe
}
