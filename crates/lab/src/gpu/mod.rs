//! What only a graphics card can tell, in five minutes: what triangles and pixels cost, how long frames of the three spaces
//! take, whether the game's pictures are the expected ones, and how exact the shader's functions are.
//!
//! It is run wherever a card is at hand, by players too, so a report always has the same sections: what could not be
//! measured says why in its place, and again at the top. Nothing takes another adapter's place unsaid.

mod adapter;
mod amount;
mod blocks;
mod clock;
mod cost;
mod fit;
mod pictures;
mod run;
mod spread;
pub mod suite;
mod told;
mod worlds;

use std::path::{Path, PathBuf};

use antipode_render::AdapterChoice;

pub use blocks::{Block, difference, worst_block};
pub use fit::{Cost, Fit, Load};
pub use run::run;

use crate::{Effort, LabError, Report, Section};

/// What the identities of these sections begin with.
pub const PREFIX: &str = "gpu-";
/// What the identity of the section about what is missing is.
pub const MISSING: &str = "gpu-missing";

/// What is to be measured.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How thoroughly.
    pub effort: Effort,
    /// What draws.
    pub adapter: AdapterChoice,
    /// The game's program, for the image suite.
    pub game: PathBuf,
    /// The folder of the suite's scripts and expected pictures.
    pub scenes: PathBuf,
}

/// What a run came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Everything that was found.
    pub report: Report,
    /// What could not be measured, in sentences.
    pub lacks: Vec<String>,
}

/// What is told while it runs.
#[derive(Clone, Copy, Debug)]
pub enum News<'a> {
    /// What the report's head says.
    Head(&'a [(String, String)]),
    /// Something that a reader of the figures must know.
    Warning(&'a str),
    /// What is measured now.
    Begun(&'a str),
    /// A section is done.
    Done(&'a Section),
}

/// Who is told.
pub type Listener<'a> = dyn FnMut(News<'_>) -> Result<(), LabError> + 'a;

/// The file name of a program on this system.
pub fn program(name: &str) -> String {
    [name, std::env::consts::EXE_SUFFIX].concat()
}

/// What lies beside a program: the game and the folder of scenes of the archive.
pub fn beside(laboratory: &Path) -> [PathBuf; 2] {
    let folder = laboratory.parent().unwrap_or(Path::new("."));
    [program("antipode"), "scenes".to_owned()].map(|name| folder.join(name))
}
