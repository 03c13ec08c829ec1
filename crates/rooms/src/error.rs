//! Everything that can be wrong with a room, each as a sentence.

use std::path::PathBuf;

use antipode_storage::StorageError;

/// What is wrong in a room, without the file that it stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The field, as `objects[3].what.size`.
    pub path: String,
    /// The same in words: `size of "wall"`.
    pub field: String,
    /// What is wrong with it: `is to be ..., and is ...`.
    pub reason: String,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{} {}.", self.field, self.reason)
    }
}

/// Why a room cannot be read, kept or changed.
#[derive(Debug, thiserror::Error)]
pub enum RoomError {
    /// Something in the file is not as it has to be.
    #[error("{file}:{line}: {fault}")]
    Text {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The field, and what is wrong with it.
        fault: Fault,
    },
    /// The file is of a newer game.
    #[error(
        "{file}:{line}: version {found} is of a newer version of the game, which knows up to {}. Update the game.",
        crate::room::VERSION
    )]
    Newer {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The version that it names.
        found: u32,
    },
    /// A file of a room cannot be used.
    #[error("{}: {reason}.", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// A room that is not to be written.
    #[error("The room cannot be kept: {0}")]
    Unsound(Fault),
    /// There is no such room.
    #[error("There is no room \"{room}\" in {}. `antipode rooms list` shows those there are.", dir.display())]
    NotFound {
        /// What was asked for.
        room: String,
        /// Where rooms are kept.
        dir: PathBuf,
    },
    /// The room comes with the game.
    #[error(
        "The room \"{0}\" comes with the game and stays as it is. Make a copy of it, and change that."
    )]
    Shipped(String),
    /// The name cannot be used.
    #[error("{0}")]
    Name(String),
    /// A command that changes a room makes no sense.
    #[error("{0}")]
    Command(String),
    /// The disk refuses, or an archive is none.
    #[error(transparent)]
    Storage(#[from] StorageError),
}
