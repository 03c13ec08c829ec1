//! The failures that end the program: each is a sentence and has an exit status.

use antipode_rays::RaysError;
use antipode_render::RenderError;
use antipode_rooms::RoomError;
use antipode_scene::{CloseFailure, SceneError};
use antipode_storage::StorageError;
use antipode_streaming::StreamingError;
use thiserror::Error;

/// Exit status of a failure at run time.
pub const EXIT_FAILED: u8 = 1;
/// Exit status of wrong usage.
pub const EXIT_USAGE: u8 = 2;

/// Why the program stops.
#[derive(Debug, Error)]
pub enum Failure {
    /// A save could not be read or written.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// A room could not be read, kept or found.
    #[error(transparent)]
    Room(#[from] RoomError),
    /// A world could not be opened.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The chunk workers failed.
    #[error(transparent)]
    Streaming(#[from] StreamingError),
    /// The graphics adapter failed.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A room could not be drawn.
    #[error(transparent)]
    Rays(#[from] RaysError),
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
    /// The system or the terminal has asked for the end, by this signal.
    #[error("The program was asked to stop (signal {0}); what was open is saved.")]
    Stopped(i32),
    /// The game itself broke.
    #[error(
        "The game has crashed, and is sorry. The world is as it was last saved, at most a few seconds ago. What is known is in {report}."
    )]
    Crashed {
        /// The report's file.
        report: String,
    },
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
    /// No window could be opened: what the window system says, without the place in its source code.
    pub fn no_window(said: &impl std::fmt::Display) -> Self {
        let said = said.to_string();
        let words = said
            .strip_prefix("os error at ")
            .and_then(|rest| rest.split_once(".rs:"))
            .and_then(|(_, rest)| rest.split_once(": "))
            .map_or(said.as_str(), |(_, words)| words);
        Self::NoWindow(words.trim_end_matches('.').to_owned())
    }

    /// The process's exit status: 2 for wrong usage, 1 for a failure at run time.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Script(_) | Self::Usage(_) => EXIT_USAGE,
            // As shells tell the end by a signal.
            Self::Stopped(signal) => u8::try_from(128 + signal).unwrap_or(EXIT_FAILED),
            _ => EXIT_FAILED,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_systems_words_lose_the_place_in_its_source_code() {
        let said =
            "os error at /home/me/.cargo/winit/src/linux/mod.rs:765: neither A nor B is set.";
        let words = Failure::no_window(&said).to_string();
        assert!(words.contains("(neither A nor B is set)"), "{words}");
        let plain = Failure::no_window(&"exit: 3").to_string();
        assert!(plain.contains("(exit: 3)"), "{plain}");
    }
}
