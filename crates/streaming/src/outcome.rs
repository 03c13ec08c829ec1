//! What workers and saver report to the game's side.

use antipode_geometry::ChunkCoord;

use crate::api::Chunk;
use crate::saver::Parts;

/// A finished job.
pub(crate) enum Outcome {
    /// One chunk.
    Loaded(Loaded),
    /// One batch, whole.
    Edited(Edited),
    /// One commit.
    Saved(SaveReport),
}

/// The end of a load.
pub(crate) struct Loaded {
    pub(crate) coord: ChunkCoord,
    /// `None` if it was given up.
    pub(crate) chunk: Option<Chunk>,
    /// The revision of the edits it was made from.
    pub(crate) revision: u64,
    pub(crate) problems: Vec<String>,
}

/// The end of an edit batch.
#[derive(Default)]
pub(crate) struct Edited {
    /// Every chunk of `remeshed`, if complete.
    pub(crate) chunks: Vec<Chunk>,
    /// Chunks that own a changed sample.
    pub(crate) touched: Vec<ChunkCoord>,
    /// Chunks that look different.
    pub(crate) remeshed: Vec<ChunkCoord>,
    pub(crate) revision: u64,
    /// False if a chunk was given up; then none may be shown.
    pub(crate) complete: bool,
    pub(crate) problems: Vec<String>,
}

/// The end of a commit.
pub(crate) struct SaveReport {
    /// Why it failed, and the parts that are not on disk.
    pub(crate) failed: Option<(String, Parts)>,
}
