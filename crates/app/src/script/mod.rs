//! Scripts: the commands of the console, one a line, in simulated time.

mod commands;
mod host;
mod in_room;
mod measure;
mod parse;
mod room_orders;
mod run;
mod say;

use std::path::{Path, PathBuf};

pub use commands::{Argument, COMMANDS, CommandInfo, SETTINGS, command_named};
pub use host::{Host, obey};
pub use parse::{Line, Order, ROOM_ACTS, RoomOrder, Setting, Spawned, parse, parse_line};
pub use run::Runner;
pub(crate) use run::steps_in;
pub(crate) use say::{probe_text, room_probe_text};

use crate::common::Common;
use crate::ending::Ending;
use crate::failure::Failure;
use crate::options;
use crate::text::read_short;

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
    // Not earlier: who waits for a script on standard input is ended by a signal at once.
    let mut config = options::for_script(common.config.as_deref())?;
    if let Some(preset) = common.preset {
        config.settings.preset = preset;
    }
    let mut runner = Runner::new(common.clone(), shooting, Ending::listen(), &config);
    let outcome = runner.run(&lines);
    match (outcome, runner.close()) {
        // Nothing may be called saved that is not.
        (Err(Failure::Stopped(_)), Err(unsaved)) => Err(unsaved),
        (outcome, closed) => outcome.and(closed),
    }
}

fn read(file: &Path) -> Result<String, Failure> {
    let (what, text) = if file == Path::new("-") {
        let text = read_short(std::io::stdin());
        ("The script on standard input".to_owned(), text)
    } else {
        let text = std::fs::File::open(file).and_then(read_short);
        (format!("The script {}", file.display()), text)
    };
    text.and_then(|bytes| String::from_utf8(bytes).map_err(std::io::Error::other))
        .map_err(|error| Failure::Usage(format!("{what} cannot be read: {error}")))
}
