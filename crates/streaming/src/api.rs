//! What passes between the game and the streamer: wishes in, updates out.

use std::error::Error;
use std::fmt;
use std::sync::Arc;
use std::thread;

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_physics::TerrainCollider;
use antipode_terrain::{ChunkMesh, Samples};
use glam::DVec3;

/// How many threads and how much memory the streamer may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// Number of chunk workers; at least one is started.
    pub workers: usize,
    /// Generated chunks (about 170 kB each) kept so that digging need not make the noise again.
    pub kept_samples: usize,
}

impl Default for Config {
    /// One worker per core but the main thread's, and 96 kept chunks.
    fn default() -> Self {
        let cores = thread::available_parallelism().map_or(2, std::num::NonZero::get);
        Self {
            workers: cores.saturating_sub(1).max(1),
            kept_samples: 96,
        }
    }
}

/// What the player needs around them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wish {
    /// Where the player is, chart metres.
    pub centre: ChartPoint,
    /// Chart direction of the view; need not be unit, zero means no preference.
    pub front: DVec3,
    /// Chunks to load in every direction, 1 to 64; a spherical world is wholly resident and
    /// ignores it.
    pub view_distance: u32,
}

/// A finished chunk.
pub struct Chunk {
    /// Which chunk.
    pub coord: ChunkCoord,
    /// Its surface, positions in metres from the chunk's origin; may have no triangles.
    pub mesh: Arc<ChunkMesh>,
    /// The same surface for the physics; `None` where there are no triangles.
    pub collider: Option<TerrainCollider>,
    /// The field with the edits applied, for point queries.
    pub samples: Arc<Samples>,
}

impl fmt::Debug for Chunk {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Chunk")
            .field("coord", &self.coord)
            .field("indices", &self.mesh.indices.len())
            .field("collider", &self.collider.is_some())
            .finish_non_exhaustive()
    }
}

/// What became of earlier wishes.
#[derive(Debug)]
pub enum Update {
    /// A chunk to show.
    Loaded(Chunk),
    /// All chunks of one edit batch, to be shown in one frame.
    Edited(Vec<Chunk>),
    /// A chunk to forget.
    Unloaded(ChunkCoord),
    /// Everything up to the save is on disk.
    Saved,
    /// A sentence for the player: the save failed, and why. Nothing of it is lost; the next save
    /// tries again.
    SaveFailed(String),
    /// A sentence for the player: what else went wrong and what they can do.
    Problem(String),
}

/// What [`Streamer::wait`](crate::Streamer::wait) waits for.
#[derive(Clone, Copy, Debug)]
pub enum Until<'a> {
    /// Every stroke so far is shown.
    Edits,
    /// None of these chunks is still to come. One that is out of range, or was given up, does not
    /// hold the wait up.
    Chunks(&'a [ChunkCoord]),
    /// Every chunk in range is there or was given up.
    Loads,
    /// Every save asked for so far has succeeded or failed.
    Saved,
    /// Nothing at all is under way.
    Idle,
}

/// Why streaming could not start or end as it should.
#[derive(Debug, thiserror::Error)]
pub enum StreamingError {
    /// The system refused a thread.
    #[error("The chunk workers could not be started: {0}. Close other programs and try again.")]
    Threads(#[source] std::io::Error),
    /// The list of edited chunks could not be read; the store's own sentence.
    #[error("{0}")]
    Store(#[source] Box<dyn Error + Send + Sync>),
    /// The last commit failed; the store's own sentence.
    #[error("The last changes to the world are not saved. {0}")]
    NotSaved(String),
    /// An edit did not finish in time, so it is not in the save.
    #[error(
        "The last change to the terrain or its save did not finish in time; everything saved before is safe."
    )]
    Unfinished,
}
