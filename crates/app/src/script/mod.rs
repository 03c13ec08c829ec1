//! Scripts: the commands of the console, one a line, in simulated time.

mod measure;
mod parse;
mod run;
mod say;

use std::io::Read;
use std::path::{Path, PathBuf};

pub use parse::{Line, Order, parse};
pub use run::Runner;

use crate::cli::Common;
use crate::failure::Failure;

/// Where a script's pictures go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shooting {
    /// Relative to the current directory, as the script says.
    Here,
    /// Into this directory.
    Into(PathBuf),
}

/// Runs the script in a file, or standard input for `-`.
///
/// # Errors
/// When it cannot be read, has a mistake, or something fails while it runs; a mistake names its line.
pub fn run_file(file: &Path, common: &Common, shooting: Shooting) -> Result<(), Failure> {
    let text = read(file)?;
    run_text(&text, common, shooting)
}

/// Runs the script in a text.
///
/// # Errors
/// As [`run_file`].
pub fn run_text(text: &str, common: &Common, shooting: Shooting) -> Result<(), Failure> {
    let lines = parse(text).map_err(|mistake| Failure::Script(mistake.to_string()))?;
    let mut runner = Runner::new(common.clone(), shooting);
    let outcome = runner.run(&lines);
    let closed = runner.close();
    outcome.and(closed)
}

fn read(file: &Path) -> Result<String, Failure> {
    if file == Path::new("-") {
        let mut text = String::new();
        return match std::io::stdin().read_to_string(&mut text) {
            Ok(_) => Ok(text),
            Err(error) => Err(Failure::Usage(format!(
                "The script on standard input cannot be read: {error}"
            ))),
        };
    }
    std::fs::read_to_string(file).map_err(|error| {
        Failure::Usage(format!(
            "The script {} cannot be read: {error}",
            file.display()
        ))
    })
}
