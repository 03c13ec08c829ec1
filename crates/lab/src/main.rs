//! The program `antipode-lab`: reads the command line, measures, and turns a failure into one line and an exit status.

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

mod command;
mod gpu_command;

/// The game's allocator, so that what is timed is what the game does.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    // A mistake on the command line ends the program here with status 2, as in the game.
    match command::run(&command::Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // Where even that cannot be written, the exit status must do.
            let _ = writeln!(std::io::stderr().lock(), "antipode-lab: {failure}");
            ExitCode::FAILURE
        }
    }
}
