//! The results of jobs with saved worlds and rooms, to be told to the player.

use std::path::PathBuf;

use super::folder::FolderProblem;
use crate::failure::Failure;

/// What there is to tell of such work.
#[derive(Debug)]
pub enum News {
    /// The name as it can be shown, as of the next ones.
    Renamed(String),
    Duplicated(String),
    Exported(PathBuf),
    Imported(String),
    Failed(Failure),
    Folder(FolderProblem),
    /// The thread that read the list has ended without a result.
    ListDied,
    /// The thread that did something else has ended without a result.
    WorkDied,
}
