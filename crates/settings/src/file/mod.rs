//! The file: RON, read field by field, written whole and off the main thread.
//!
//! Whatever is wrong with it costs only what is wrong: a bad value its field, a torn file its lines. Before anything
//! is written over a file that was not understood in full, that file is put aside under another name.

mod disk;
mod keeper;
mod notice;
mod raw;
mod take;
mod text;

use std::path::{Path, PathBuf};

pub use disk::{Opened, open};
pub use keeper::Keeper;
pub use notice::{Notice, SaveProblem};
pub use take::{Condition, Reading, read};
pub use text::write;

/// The schema that is written. Files without a number are of schema 0.
pub(crate) const SCHEMA: u32 = 1;
/// A longer file is no settings file, and is not read as a whole.
pub(crate) const MAX_BYTES: u64 = 256 << 10;

/// Where the file is: what the command line says, or `settings.ron` in the platform's directory of configurations;
/// `None` where the system names no such directory.
pub fn config_path(given: Option<&Path>) -> Option<PathBuf> {
    given.map(Path::to_owned).or_else(|| {
        directories::ProjectDirs::from("", "", "antipode")
            .map(|dirs| dirs.config_dir().join("settings.ron"))
    })
}
