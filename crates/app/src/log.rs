//! The log: one line an event on standard error, at the level asked for.

use std::io::IsTerminal;

use clap::ValueEnum;
use tracing_subscriber::filter::LevelFilter;

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

/// Starts logging for the process. Called again it changes nothing.
pub fn start(level: LogLevel) {
    let filter = match level {
        LogLevel::Off => LevelFilter::OFF,
        LogLevel::Error => LevelFilter::ERROR,
        LogLevel::Warn => LevelFilter::WARN,
        LogLevel::Info => LevelFilter::INFO,
        LogLevel::Debug => LevelFilter::DEBUG,
    };
    let started = tracing_subscriber::fmt()
        .with_max_level(filter)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal())
        // A full disk behind standard error would otherwise end the program from inside the log.
        .log_internal_errors(false)
        .with_target(false)
        .try_init();
    if started.is_err() {
        tracing::debug!("a log is already running");
    }
}
