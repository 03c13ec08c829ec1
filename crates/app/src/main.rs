//! The binary: reads the command line, runs what it asks for and turns failures into one line and an exit status.

use std::process::ExitCode;

use antipode::cli::{self, Cli};
use antipode::{ending, failure, output, surroundings};
use clap::Parser;

/// Workers make what the main thread frees, and the other way round. The system's allocator keeps such memory under the
/// lock of the thread that asked for it, and a thread that loses its core while it holds that lock makes the others
/// wait; here memory freed by another thread is handed back without one.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    for (name, value) in surroundings::amended(|name| std::env::var_os(name)) {
        #[expect(
            unsafe_code,
            reason = "libraries take such wishes by the environment alone"
        )]
        // SAFETY: no other thread has been started yet that could read the environment.
        unsafe {
            std::env::set_var(name, value);
        }
    }
    std::panic::set_hook(Box::new(output::complain_of_panic));
    ending::outlive_file_limits();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(mistake) if mistake.use_stderr() => {
            output::complain(&cli::one_line(&mistake));
            return ExitCode::from(failure::EXIT_USAGE);
        }
        // Help and version are answers, not mistakes.
        Err(answer) => {
            return match output::lines(&answer.render().to_string()) {
                Ok(()) => ExitCode::SUCCESS,
                Err(_) => ExitCode::from(failure::EXIT_FAILED),
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
