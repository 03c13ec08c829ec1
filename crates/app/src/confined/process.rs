//! The process itself: how it is started, bounded and waited for, and what its end means.

use std::io::{self, Read};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use antipode_storage::SavesDir;

use super::{Answer, Limits, Task};
use crate::failure::Failure;
use crate::failure::{EXIT_FAILED, EXIT_USAGE};

/// How often the other process is asked whether it is done.
const LOOK: Duration = Duration::from_millis(5);
/// Has the allocator ask for memory as it is needed. By default it maps a gigabyte to write to
/// before anything else runs, and a limit set after that is never met.
#[cfg(target_os = "linux")]
const NO_MEMORY_IN_ADVANCE: (&str, &str) = ("MIMALLOC_ARENA_EAGER_COMMIT", "0");
/// The longest answer that is read.
const MOST_ANSWER_BYTES: u64 = 16 << 20;
/// The longest complaints that are read.
const MOST_COMPLAINT_BYTES: u64 = 1 << 20;
/// Exit status of a process that has ended itself because its time was over.
const EXIT_LATE: u8 = 3;

#[cfg(not(test))]
fn program() -> io::Result<PathBuf> {
    std::env::current_exe()
}

/// The game, which stands beside the directory of the tests' own programs.
#[cfg(test)]
fn program() -> io::Result<PathBuf> {
    let test = std::env::current_exe()?;
    let built = test.ancestors().nth(2).map(|dir| dir.join("antipode"));
    built.ok_or_else(|| io::ErrorKind::NotFound.into())
}

/// This program again, to do a task.
pub(super) fn myself(task: &Task, saves: &SavesDir) -> Result<Command, Failure> {
    let program = program().map_err(|error| not_started(task, &error))?;
    let mut command = Command::new(program);
    command.args(task.arguments(saves));
    #[cfg(target_os = "linux")]
    command.env(NO_MEMORY_IN_ADVANCE.0, NO_MEMORY_IN_ADVANCE.1);
    Ok(command)
}

/// Starts a process and waits for its answer, at most for its time.
pub(super) fn answer_of(
    mut command: Command,
    task: &Task,
    limits: Limits,
) -> Result<Answer, Failure> {
    let started = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut child = started.map_err(|error| not_started(task, &error))?;
    // What is cut short or no text is no answer.
    let said = child
        .stdout
        .take()
        .map(|out| listen(out, MOST_ANSWER_BYTES));
    let complaints = child
        .stderr
        .take()
        .map(|out| listen(out, MOST_COMPLAINT_BYTES));
    let status = ended_within(&mut child, limits.time);
    if status.is_none() {
        return Err(End::Late.told(task, limits));
    }
    serde_json::from_slice(&heard(said)).map_err(|_| {
        let complaints = heard(complaints);
        End::of(status, &String::from_utf8_lossy(&complaints)).told(task, limits)
    })
}

/// Reads what a process says, so that it never waits for a reader: the first bytes are kept.
fn listen(mut from: impl Read + Send + 'static, most: u64) -> JoinHandle<Vec<u8>> {
    std::thread::spawn(move || {
        let mut said = Vec::new();
        let _ = from.by_ref().take(most).read_to_end(&mut said);
        let _ = io::copy(&mut from, &mut io::sink());
        said
    })
}

fn heard(thread: Option<JoinHandle<Vec<u8>>>) -> Vec<u8> {
    let said = thread.and_then(|thread| thread.join().ok());
    said.unwrap_or_default()
}

/// How a process has ended that gave no answer.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum End {
    /// It took longer than it may.
    Late,
    /// It wanted more memory than it may have.
    Hungry,
    /// By a signal that somebody else sent, or the system that had no memory left.
    #[cfg(unix)]
    Ended(i32),
    /// It did not begin, for this reason.
    Refused(String),
    /// In a way that nobody has thought of.
    Broken,
}

impl End {
    /// `None` stands for a process that the waiting process has ended.
    pub(super) fn of(status: Option<ExitStatus>, complaints: &str) -> Self {
        let Some(status) = status else {
            return Self::Late;
        };
        #[cfg(unix)]
        {
            use signal_hook::consts::{SIGHUP, SIGINT, SIGKILL, SIGTERM};
            use std::os::unix::process::ExitStatusExt;
            match status.signal() {
                #[cfg(target_os = "linux")]
                Some(signal) if signal == rustix::process::Signal::XCPU.as_raw() => {
                    return Self::Late;
                }
                Some(signal @ (SIGHUP | SIGINT | SIGKILL | SIGTERM)) => return Self::Ended(signal),
                _ => {}
            }
        }
        // The words of the standard library, which has no status of its own for it.
        if complaints.contains("memory allocation of") {
            return Self::Hungry;
        }
        let refused = [EXIT_FAILED, EXIT_USAGE].map(|code| Some(i32::from(code)));
        let words = complaints
            .lines()
            .filter_map(|line| line.strip_prefix("antipode: "))
            .next_back();
        match words {
            _ if status.code() == Some(i32::from(EXIT_LATE)) => Self::Late,
            Some(words) if refused.contains(&status.code()) => Self::Refused(words.to_owned()),
            _ => Self::Broken,
        }
    }

    pub(super) fn told(self, task: &Task, limits: Limits) -> Failure {
        let object = task.object();
        Failure::Runtime(match self {
            Self::Late => format!(
                "{object} took more than {} seconds and was stopped. If the file is sound, the disk may be too slow or too full.",
                limits.time.as_secs()
            ),
            Self::Hungry => format!(
                "{object} needed more memory than it may have, at most {} MB, and was stopped. If the file is sound, please report this.",
                limits.memory_bytes >> 20
            ),
            #[cfg(unix)]
            Self::Ended(signal) => format!(
                "{object} failed: the system or somebody ended the work (signal {signal}), as happens where memory is short. Try again."
            ),
            Self::Refused(words) => format!("{object} failed: {words}"),
            Self::Broken => format!(
                "{object} failed: the file is damaged in a way that the game cannot read. If you have a copy of it, use that."
            ),
        })
    }
}

/// Waits for a process and ends it when the time is over; its status if it ended by itself.
fn ended_within(child: &mut Child, time: Duration) -> Option<ExitStatus> {
    let start = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) if start.elapsed() < time => std::thread::sleep(LOOK),
            _ => {
                // It may have ended meanwhile, which is as good.
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
        }
    }
}

/// Ends this process when the time is over, in case nobody is left who would.
pub(super) fn end_after(time: Duration) -> Result<(), Failure> {
    #[cfg(target_os = "linux")]
    limit(
        rustix::process::Resource::Cpu,
        time.as_secs().saturating_add(1),
    )?;
    let watch = move || {
        std::thread::sleep(time);
        std::process::exit(i32::from(EXIT_LATE));
    };
    let started = std::thread::Builder::new().spawn(watch);
    started.map(drop).map_err(|error| not_limited(&error))
}

#[cfg(target_os = "linux")]
pub(super) fn limit_memory(bytes: u64) -> Result<(), Failure> {
    limit(rustix::process::Resource::Data, bytes)
}

/// Sets a limit on this process, unless it has a lower one.
#[cfg(target_os = "linux")]
fn limit(resource: rustix::process::Resource, most: u64) -> Result<(), Failure> {
    use rustix::process::{Rlimit, getrlimit, setrlimit};
    let least = |known: Option<u64>| Some(known.map_or(most, |known| known.min(most)));
    let before = getrlimit(resource);
    let limit = Rlimit {
        current: least(before.current),
        maximum: least(before.maximum),
    };
    setrlimit(resource, limit).map_err(|error| not_limited(&error))
}

#[cfg(not(target_os = "linux"))]
pub(super) fn limit_memory(_: u64) -> Result<(), Failure> {
    Ok(())
}

fn not_limited(error: &dyn std::fmt::Display) -> Failure {
    Failure::Runtime(format!("Memory and time could not be limited: {error}"))
}

fn not_started(task: &Task, error: &io::Error) -> Failure {
    Failure::Runtime(format!(
        "{} failed: the game could not be started a second time for it ({error}).",
        task.object()
    ))
}
