//! Reports of the workers and the saver to the game.

use antipode_geometry::ChunkCoord;
use antipode_terrain::{Earth, Stock};

use crate::api::{Chunk, NotUndone};
use crate::edit_store::EditMap;
use crate::plan::Planned;
use crate::saver::Unsaved;
use crate::scheduler::Make;

/// A finished job.
#[expect(
    clippy::large_enum_variant,
    reason = "the large one is what nearly all are"
)]
pub(crate) enum Outcome {
    /// One chunk.
    Loaded(Loaded),
    /// One batch, whole.
    Edited(Edited),
    /// One plan, or why it could not be made.
    Planned(Result<Planned, Vec<String>>),
    /// One commit, and what failed of it.
    Saved(Option<Unsaved>),
}

/// The end of a load.
pub(crate) struct Loaded {
    pub(crate) make: Make,
    /// `None` if it was given up.
    pub(crate) chunk: Option<Chunk>,
    /// The revision of the edits it was made from.
    pub(crate) revision: u64,
    pub(crate) problems: Vec<String>,
}

/// The end of an edit batch.
#[derive(Default)]
pub(crate) struct Edited {
    /// Every chunk of `remeshed` that was to be shown, if complete.
    pub(crate) chunks: Vec<(Make, Chunk)>,
    /// Chunks that own a changed sample.
    pub(crate) touched: Vec<ChunkCoord>,
    /// Those of them that are as nobody had touched them.
    pub(crate) emptied: Vec<ChunkCoord>,
    /// Chunks that look different.
    pub(crate) remeshed: Vec<ChunkCoord>,
    /// Coarse chunks beside them of which only the borders have changed, and so the normals.
    pub(crate) bordering: Vec<ChunkCoord>,
    pub(crate) revision: u64,
    /// What is to be saved.
    pub(crate) land: EditMap,
    /// False if a chunk was given up; then none may be shown.
    pub(crate) complete: bool,
    pub(crate) problems: Vec<String>,
    /// What a press has moved.
    pub(crate) moved: Option<(u64, Earth)>,
    /// What that adds to a stock.
    pub(crate) gathered: Stock,
    pub(crate) undone: Option<Undone>,
}

/// A press that was to be undone, and what it had moved, or why that stays.
pub(crate) type Undone = (u64, Result<Earth, NotUndone>);
