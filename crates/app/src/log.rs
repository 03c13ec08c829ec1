//! The log: one line an event on standard error, at the level asked for, and the game's in files as well.

use clap::ValueEnum;
use tracing_appender::non_blocking::{NonBlocking, WorkerGuard};
use tracing_subscriber::Layer;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;

use crate::log_file::{self, RotatingFile};
use crate::output::{self, Escaping};

/// How much the log says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LogLevel {
    /// Nothing.
    Off,
    /// Failures.
    Error,
    /// Failures and what is suspicious.
    Warn,
    /// What happens.
    Info,
    /// Everything, for developers.
    Debug,
}

impl LogLevel {
    fn filter(self) -> LevelFilter {
        match self {
            Self::Off => LevelFilter::OFF,
            Self::Error => LevelFilter::ERROR,
            Self::Warn => LevelFilter::WARN,
            Self::Info => LevelFilter::INFO,
            Self::Debug => LevelFilter::DEBUG,
        }
    }
}

/// All of that level, but of the window system what goes wrong: its lines hold the window's icon, a megabyte each.
fn spoken(level: LevelFilter) -> Targets {
    Targets::new()
        .with_default(level)
        .with_target("winit", level.min(LevelFilter::WARN))
}

/// What is to be kept while the log runs: dropped, it writes what still waits.
#[must_use]
#[derive(Debug, Default)]
pub struct LogGuard {
    _file: Option<WorkerGuard>,
}

/// Starts logging for the process, and into files where `to_files`. Called again it changes nothing.
///
/// A thread of its own writes the files; lines that come faster than the disk takes them are left out, and nobody
/// waits.
pub fn start(level: LogLevel, to_files: bool) -> LogGuard {
    let opened = log_file::folder().filter(|_| to_files);
    let opened = opened.map(|folder| RotatingFile::open(&folder));
    let (files, guard, problem) = match opened {
        Some(Ok(file)) => {
            let (writer, guard) = tracing_appender::non_blocking(file);
            // What went wrong is of use later even when nobody asked for it now.
            let filter = spoken(level.filter().max(LevelFilter::INFO));
            (
                Some(file_layer(writer).with_filter(filter)),
                Some(guard),
                None,
            )
        }
        Some(Err(problem)) => (None, None, Some(problem)),
        None => (None, None, None),
    };
    let terminal = tracing_subscriber::fmt::layer()
        .with_writer(output::log_to_terminal())
        .with_ansi(false)
        // A full disk behind standard error would otherwise end the program from inside the log.
        .log_internal_errors(false)
        .with_target(false)
        .with_filter(spoken(level.filter()));
    let log = tracing_subscriber::registry().with(terminal).with(files);
    if log.try_init().is_err() {
        tracing::debug!("a log is already running");
    }
    if let Some(problem) = problem {
        tracing::warn!("the log is not kept in files: {problem}");
    }
    LogGuard { _file: guard }
}

fn file_layer<S>(writer: NonBlocking) -> impl Layer<S>
where
    S: tracing::Subscriber + for<'a> tracing_subscriber::registry::LookupSpan<'a>,
{
    tracing_subscriber::fmt::layer()
        .with_writer(Escaping(writer))
        .with_ansi(false)
        .log_internal_errors(false)
}
