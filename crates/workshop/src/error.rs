//! Why a room cannot be edited so.

use std::path::PathBuf;

use antipode_rooms::RoomError;
use antipode_storage::StorageError;

/// Why something in the workshop cannot be done. The document is as it was.
#[derive(Debug, thiserror::Error)]
pub enum WorkshopError {
    /// The edit makes no sense, or would leave the room unsound.
    #[error(transparent)]
    Room(#[from] RoomError),
    /// What was to be changed is locked.
    #[error("\"{0}\" is locked; unlock it first.")]
    Locked(String),
    /// There is no step to go back or forth to.
    #[error("There is nothing to {0}.")]
    NoStep(&'static str),
    /// Another window, or another game, edits the room.
    #[error("The room in {} is being edited elsewhere. Close it there first.", .0.display())]
    InUse(PathBuf),
    /// The document is kept nowhere.
    #[error("This room is kept nowhere, so it cannot be saved. Give it a name first.")]
    NotKept,
    /// There is no such version.
    #[error("There is no version {0} of this room any more.")]
    NoVersion(String),
    /// The disk refuses.
    #[error(transparent)]
    Storage(#[from] StorageError),
}

/// Refuses a command with a sentence.
pub(crate) fn refuse<T>(sentence: impl Into<String>) -> Result<T, WorkshopError> {
    Err(RoomError::Command(sentence.into()).into())
}

/// There is nothing of that name.
pub(crate) fn missing<T>(name: &str) -> Result<T, WorkshopError> {
    refuse(format!(
        "There is nothing called {} in this room.",
        antipode_rooms::shown(name)
    ))
}

impl From<WorkshopError> for RoomError {
    /// For who knows rooms only: what is not theirs is a sentence.
    fn from(error: WorkshopError) -> Self {
        match error {
            WorkshopError::Room(error) => error,
            WorkshopError::Storage(error) => Self::Storage(error),
            other => Self::Command(other.to_string()),
        }
    }
}
