//! The types that pass between the game and the streamer: wishes in, updates out.

use std::error::Error;
use std::fmt;
use std::sync::Arc;
use std::thread;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, ChunkCube};
use antipode_physics::TerrainCollider;
use antipode_terrain::{ChunkMesh, Earth, Samples, Stock};
use glam::DVec3;

/// Why a save failed: the store's own error, with its sentence.
pub type Cause = Arc<dyn Error + Send + Sync>;

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

/// A box of a chart that a body may be in, or ask about, within the next moments: ground in it is
/// solid, that is, it has its colliders and can be asked for its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The chart.
    pub chart: ChartId,
    /// Least corner in chart metres; may be infinite.
    pub min: DVec3,
    /// Greatest corner in chart metres; may be infinite.
    pub max: DVec3,
}

impl Reach {
    /// All points of a point's chart within `reach_m` of it along each axis.
    pub fn around(point: ChartPoint, reach_m: f64) -> Self {
        Self {
            chart: point.chart,
            min: point.pos - reach_m,
            max: point.pos + reach_m,
        }
    }

    /// All of a chart.
    pub fn whole(chart: ChartId) -> Self {
        Self::around(ChartPoint::new(chart, DVec3::ZERO), f64::INFINITY)
    }
}

/// How large the land is in the picture, which decides at what resolution it is made.
///
/// What is asked about a chunk must hold wherever the eye may go and turn until a wish brings
/// another `Detail`. Asked on the workers.
pub trait Detail: fmt::Debug + Send + Sync {
    /// The most pixels that a metre anywhere in the chunk takes in the picture.
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64;

    /// Pixels from one end of the chunk to the other, as it is seen from here; 0 for what lies
    /// beyond what is drawn.
    fn span_px(&self, coord: ChunkCoord) -> f64;

    /// Errors of so many pixels are let pass; at 0 everything is made in full resolution.
    fn tolerance_px(&self) -> f64;
}

/// What the player needs around them.
#[derive(Clone, Debug)]
pub struct Wish {
    /// Where the player is, chart metres.
    pub centre: ChartPoint,
    /// Chart direction of the view; need not be unit, zero means no preference.
    pub front: DVec3,
    /// Chunks to load in every direction, 1 to 64; a closed world is wholly resident and
    /// ignores it.
    pub view_distance: u32,
    /// Places that are looked at from elsewhere: land within [`Wish::APART_CHUNKS`] of each is loaded, however far off it is.
    pub apart: Vec<ChartPoint>,
    /// Where ground must be solid. Chunks farther off than both `view_distance` and `bodies_distance` are not made for
    /// it.
    pub bodies: Vec<Reach>,
    /// Chunks in every direction in which ground is made where bodies need it, though nothing else be loaded so far
    /// off; up to 64.
    pub bodies_distance: u32,
    /// The chunks about the middle of where bodies move, in a world in tiles: ground is made solid up to `bodies_distance` in it and
    /// about `apart`, and nowhere else. None in other worlds, where `bodies` end there.
    pub bodies_within: Option<ChunkCube>,
    /// How large land is in the picture; without it everything in range is made in full
    /// resolution. The plan is made anew when it is another `Arc`.
    pub detail: Option<Arc<dyn Detail>>,
}

impl Wish {
    /// Chunks in every direction that are loaded about a place that is looked at from elsewhere.
    pub const APART_CHUNKS: u16 = 2;

    /// Everything in range in full resolution, and solid in the first two charts.
    pub fn new(centre: ChartPoint, front: DVec3, view_distance: u32) -> Self {
        Self {
            centre,
            front,
            view_distance,
            apart: Vec::new(),
            bodies_distance: 0,
            bodies_within: None,
            bodies: [ChartId::FIRST, ChartId::SECOND].map(Reach::whole).to_vec(),
            detail: None,
        }
    }
}

/// A finished chunk.
pub struct Chunk {
    /// Which chunk.
    pub coord: ChunkCoord,
    /// Its surface at `mesh.level`, positions in metres from the chunk's origin; may have no
    /// triangles.
    pub mesh: Arc<ChunkMesh>,
    /// The same surface for the physics; `None` where there are no triangles, or no body near.
    pub collider: Option<TerrainCollider>,
    /// The field with the edits applied, for point queries; only near bodies.
    pub samples: Option<Arc<Samples>>,
}

impl Chunk {
    /// Whether it is made for bodies too: then it has samples, and a collider if it has triangles.
    pub fn is_solid(&self) -> bool {
        self.samples.is_some()
    }
}

impl fmt::Debug for Chunk {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Chunk")
            .field("coord", &self.coord)
            .field("level", &self.mesh.level)
            .field("indices", &self.mesh.indices.len())
            .field("collider", &self.collider.is_some())
            .finish_non_exhaustive()
    }
}

/// What became of earlier wishes.
#[derive(Debug)]
pub enum Update {
    /// A chunk to show, in place of what was shown of it.
    Loaded(Chunk),
    /// All chunks that one edit batch has changed, to be shown in one frame. Coarse ones beside them of which only the
    /// normals have changed come with them as [`Update::Loaded`].
    Edited(Vec<Chunk>),
    /// A chunk that is shown has become solid, since a body came near, or is no longer: then both
    /// are `None`.
    Solid {
        /// Which chunk.
        coord: ChunkCoord,
        /// Its collider, if it has triangles.
        collider: Option<TerrainCollider>,
        /// The field with the edits applied.
        samples: Option<Arc<Samples>>,
    },
    /// A chunk to forget.
    Unloaded(ChunkCoord),
    /// Ground that strokes of a press have moved.
    Moved {
        /// The press's number.
        press: u64,
        /// What was dug and built since it was last told.
        earth: Earth,
        /// What that adds to what is gathered, and takes from it.
        gathered: Stock,
    },
    /// The last press is undone, and that is what it had moved; or why it is not.
    Undone(Result<Earth, NotUndone>),
    /// Everything up to the save is on disk.
    Saved,
    /// The save failed, and why. Nothing of it is lost; the next save tries again.
    SaveFailed(Cause),
    /// A sentence for the player: what else went wrong and what they can do.
    Problem(String),
}

/// Why a press of the brush is not undone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotUndone {
    /// There is none, or it was too many ago.
    #[error("There is no stroke left to undo.")]
    NoneLeft,
    /// The land that it changed is not loaded.
    #[error("The last stroke is too far away to be undone. Go back to where you made it.")]
    Away,
    /// Something else has changed the same place.
    #[error("The last stroke stays: its ground has been changed since.")]
    Changed,
    /// What it had gathered is gone.
    #[error("The last stroke stays: the ground that it brought has been used since.")]
    Spent,
    /// The stored edits there cannot be read.
    #[error(
        "The last stroke stays: what is stored of its ground cannot be read now. See that the disk is there and try again."
    )]
    Unreadable,
}

/// What [`Streamer::wait`](crate::Streamer::wait) waits for.
#[derive(Clone, Copy, Debug)]
pub enum Until<'a> {
    /// Every stroke so far is shown.
    Edits,
    /// None of these chunks is still to come. One that is out of range, or was given up, does not
    /// hold the wait up.
    Chunks(&'a [ChunkCoord]),
    /// All ground that the bodies of the last wish reach is there and solid, or was given up.
    Bodies,
    /// Every chunk in range is there at its level, or was given up.
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
    /// The last commit failed.
    #[error("The last changes to the world are not saved. {0}")]
    NotSaved(Cause),
    /// An edit did not finish in time, so it is not in the save.
    #[error(
        "The last change to the terrain or its save did not finish in time; everything saved before is safe."
    )]
    Unfinished,
}
