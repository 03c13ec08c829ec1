//! What can end the program, as sentences, each with its exit status.

use antipode_render::RenderError;
use antipode_scene::{CloseFailure, SceneError};
use antipode_storage::StorageError;
use antipode_streaming::StreamingError;
use thiserror::Error;

use crate::cli::{EXIT_FAILED, EXIT_USAGE};

/// Why the program stops.
#[derive(Debug, Error)]
pub enum Failure {
    /// A save could not be read or written.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// A world could not be opened.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The chunk workers failed.
    #[error(transparent)]
    Streaming(#[from] StreamingError),
    /// The graphics adapter failed.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The window system failed.
    #[error(
        "No window could be opened ({0}). Without a display, `antipode tour` and `antipode script FILE` work and make pictures."
    )]
    NoWindow(String),
    /// A script has a mistake.
    #[error("{0}")]
    Script(String),
    /// The command line asks for something that does not exist.
    #[error("{0}")]
    Usage(String),
    /// Something failed while running, in words.
    #[error("{0}")]
    Runtime(String),
}

impl From<CloseFailure> for Failure {
    fn from(failure: CloseFailure) -> Self {
        Self::Streaming(failure.error)
    }
}

impl Failure {
    /// The process's exit status: 2 for wrong usage, 1 for a failure at run time.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Script(_) | Self::Usage(_) => EXIT_USAGE,
            _ => EXIT_FAILED,
        }
    }
}
