//! Limits on time and memory of a process that tries inputs. A watching process ends it when it takes more.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// Most memory, bytes.
pub const MOST_BYTES: u64 = 512 << 20;
/// Most that one input may take of the processor, seconds.
pub const MOST_SECONDS: f64 = 5.0;
/// Most that one input may take of anybody's time. What waits for ever takes nothing of the
/// processor; where others keep that busy, five seconds of it may take many.
pub const MOST_WAIT: Duration = Duration::from_mins(1);
/// Ticks of the processor's clock in `/proc`, which have been this many for all of Linux's life.
const TICKS_PER_S: f64 = 100.0;

/// A command that starts `program` with no more memory than [`MOST_BYTES`].
pub fn bounded(program: &Path) -> Command {
    // Nothing in this crate may ask the system for a limit, and the shell can.
    let limit = format!(
        "ulimit -c 0; ulimit -d {}; exec \"$0\" \"$@\"",
        MOST_BYTES >> 10
    );
    let mut command = Command::new("sh");
    command.args(["-c", &limit]).arg(program);
    command
}

/// Tries files one after another in a process of `program`; what it says, with what each has come to.
///
/// # Errors
/// When one breaks its promise, takes more than `wait` or the process ends early, with what it has said.
pub fn replay(
    program: &Path,
    name: &str,
    files: &[PathBuf],
    wait: Duration,
) -> Result<String, String> {
    let mut child = bounded(program)
        .args(["replay", name])
        .args(files)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("{} cannot be started: {error}", program.display()))?;
    let output = child.stdout.take().ok_or("the process has no output")?;
    let (sender, lines) = mpsc::channel();
    thread::spawn(move || {
        let lines = BufReader::new(output).lines();
        lines
            .map_while(Result::ok)
            .try_for_each(|line| sender.send(line))
    });
    let mut said = String::new();
    loop {
        match lines.recv_timeout(wait) {
            Ok(line) => said.extend([line.as_str(), "\n"]),
            Err(RecvTimeoutError::Disconnected) => break,
            Err(RecvTimeoutError::Timeout) => {
                stop(&mut child);
                return Err(format!("{said}{}", waited(wait)));
            }
        }
    }
    match child.wait() {
        Ok(status) if status.success() => Ok(said),
        Ok(status) => Err(format!("{said}{status}")),
        Err(error) => Err(format!("{said}{error}")),
    }
}

/// How a process that was watched has ended.
#[derive(Debug)]
pub(crate) enum Ended {
    /// By itself.
    With(ExitStatus),
    /// By who watched, for this reason.
    Stopped(String),
}

fn waited(wait: Duration) -> String {
    format!("nothing came of it for {} s", wait.as_secs_f32())
}

/// It may have ended meanwhile, which is as good.
fn stop(child: &mut Child) {
    let _ = child.kill();
    let _ = child.wait();
}

/// Waits for the process, which is ended where one input takes too much of the processor, or more than `wait`.
pub(crate) fn watch(child: &mut Child, progress: &Path, wait: Duration) -> Result<Ended, String> {
    let mut since = (u64::MAX, 0.0, Instant::now());
    loop {
        if let Some(status) = child.try_wait().map_err(|error| error.to_string())? {
            return Ok(Ended::With(status));
        }
        let (number, used) = (at(progress), used_s(child.id()).unwrap_or(0.0));
        let why = if number != since.0 {
            since = (number, used, Instant::now());
            None
        } else if used - since.1 > MOST_SECONDS {
            Some(format!("more than {MOST_SECONDS} s of the processor"))
        } else if since.2.elapsed() > wait {
            Some(waited(wait))
        } else {
            None
        };
        if let Some(why) = why {
            stop(child);
            return Ok(Ended::Stopped(why));
        }
        thread::sleep(Duration::from_millis(50));
    }
}

/// The number of the input that the process is at.
fn at(progress: &Path) -> u64 {
    let text = fs::read_to_string(progress).unwrap_or_default();
    text.split_whitespace()
        .next()
        .and_then(|number| number.parse().ok())
        .unwrap_or(0)
}

/// What a process has used of the processor, seconds; `None` where there is no `/proc`.
fn used_s(process: u32) -> Option<f64> {
    let text = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    let mut fields = text.rsplit_once(')')?.1.split_whitespace().skip(11);
    let ticks: u64 = fields.next()?.parse().ok()?;
    let of_system: u64 = fields.next()?.parse().ok()?;
    Some((ticks + of_system) as f64 / TICKS_PER_S)
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    /// A program that waits for ever and takes nothing of the processor.
    fn blocked(dir: &Path) -> PathBuf {
        use std::os::unix::fs::PermissionsExt;
        let path = dir.join("blocked");
        fs::write(&path, "#!/bin/sh\necho one\nexec sleep 600\n").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        path
    }

    #[test]
    fn an_input_that_only_waits_is_a_find() {
        let dir = tempfile::tempdir().unwrap();
        let progress = dir.path().join("progress");
        fs::write(&progress, "7").unwrap();
        let mut child = bounded(&blocked(dir.path()))
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let ended = watch(&mut child, &progress, Duration::from_millis(300)).unwrap();
        assert!(
            matches!(&ended, Ended::Stopped(why) if why.contains("nothing came of it")),
            "{ended:?}"
        );
    }

    #[test]
    fn a_replay_that_only_waits_ends_and_says_at_which_file() {
        let dir = tempfile::tempdir().unwrap();
        let program = blocked(dir.path());
        let said = replay(&program, "store", &[], Duration::from_millis(500)).unwrap_err();
        assert!(
            said.starts_with("one\n") && said.contains("nothing came of it"),
            "{said}"
        );
    }
}
