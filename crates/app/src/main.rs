//! The binary: reads the command line, runs what it asks for and turns failures into one line and an exit status.

use std::process::ExitCode;

use antipode::cli::{self, Cli};
use clap::Parser;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version are answers, not mistakes; clap sends them to stdout with status 0.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() {
                cli::EXIT_USAGE
            } else {
                0
            });
        }
    };
    antipode::log::start(cli.common.log);
    match cli::run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("antipode: {failure}");
            ExitCode::from(failure.exit_status())
        }
    }
}
