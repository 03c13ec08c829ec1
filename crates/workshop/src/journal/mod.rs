//! What is kept of a document beside `room.ron`, in the folder [`FOLDER`] of its room: the journal of all edits, older versions
//! and a lock. Whatever else lies there is left alone.

mod frames;
mod keeper;
mod opening;
mod record;
mod replay;
mod worker;

use std::path::{Path, PathBuf};

pub(crate) use keeper::{Keeper, News, Note};
pub use opening::{Opened, Pace, is_in_use};

/// The folder within a room's own.
pub const FOLDER: &str = "workshop";
const JOURNAL: &str = "journal";
const LOCK: &str = "lock";
pub(crate) const VERSIONS: &str = "versions";

/// A file or folder of the workshop within a room's folder.
pub(crate) fn in_folder(dir: &Path, name: &str) -> PathBuf {
    dir.join(FOLDER).join(name)
}
