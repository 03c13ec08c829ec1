//! The binary: reads the command line, runs what it asks for and turns failures into one line and an exit status.

use std::process::ExitCode;

use antipode::cli::{self, Cli};
use antipode::output;
use clap::Parser;

/// Workers make what the main thread frees, and the other way round. The system's allocator keeps such memory under the
/// lock of the thread that asked for it, and a thread that loses its core while it holds that lock makes the others
/// wait; here memory freed by another thread is handed back without one.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(mistake) if mistake.use_stderr() => {
            output::complain(&cli::one_line(&mistake));
            return ExitCode::from(cli::EXIT_USAGE);
        }
        // Help and version are answers, not mistakes.
        Err(answer) => {
            return match answer.print() {
                Ok(()) => ExitCode::SUCCESS,
                Err(_) => ExitCode::from(cli::EXIT_FAILED),
            };
        }
    };
    // Commands leave no traces beside what they were asked for.
    let _log = antipode::log::start(cli.log_level(), cli.command.is_none());
    match cli::run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            output::complain(&failure.to_string());
            ExitCode::from(failure.exit_status())
        }
    }
}
