//! What can end a run of the laboratory, as sentences.

use std::path::PathBuf;

use antipode_render::RenderError;
use thiserror::Error;

/// Why nothing was measured, or nothing written.
#[derive(Debug, Error)]
pub enum LabError {
    /// The adapter failed.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The adapter is open but does not compute.
    #[error(
        "The adapter {adapter} could not do a measurement: {why}. Try --adapter software, or --adapter none to leave it out."
    )]
    Compute {
        /// The adapter's name.
        adapter: String,
        /// What went wrong, in words.
        why: String,
    },
    /// The scene of a measurement could not be made.
    #[error("The scene to measure could not be made: {0}")]
    Scene(String),
    /// The image suite could not be drawn, in words.
    #[error("{0}")]
    Suite(String),
    /// A file could not be written.
    #[error("{} cannot be written: {source}", path.display())]
    Write {
        /// The file or directory.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// A file could not be read.
    #[error("{} cannot be read: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// A file is no report.
    #[error("{} is not a report of the laboratory ({why}); make one with `antipode-lab all --json FILE`", path.display())]
    NoReport {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// Standard output is full or closed.
    #[error("Standard output cannot be written: {0}")]
    Output(std::io::Error),
    /// Bars were not met, in words.
    #[error("{0}")]
    Failed(String),
    /// The document's template asks for what cannot be filled in.
    #[error("The template of the document has a mistake: {0}.")]
    Template(String),
}
