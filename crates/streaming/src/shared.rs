//! What the workers share, and how one chunk is made.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use antipode_geometry::{ChunkCoord, Strategy};
use antipode_physics::TerrainCollider;
use antipode_terrain::{ChunkMesh, Field, Samples, apply_edits, march};

use crate::api::Chunk;
use crate::bases::Bases;
use crate::book::{Book, Snapshot};

/// A point in a worker's course, told to the test that watches it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// About to apply a batch of strokes.
    Apply,
    /// A batch has entered the book; its meshes are still to be made.
    Entered,
    /// A load has taken its snapshot of the edits.
    Load(ChunkCoord),
    /// About to make a chunk of a batch anew.
    Remesh(ChunkCoord),
}

/// A test's look into the workers: it may wait, or panic in their place.
pub(crate) type Watch = Arc<dyn Fn(Step) + Send + Sync>;

/// Everything a worker needs besides its channels.
pub(crate) struct Shared {
    pub(crate) field: Arc<Field>,
    pub(crate) strategy: Arc<dyn Strategy>,
    pub(crate) book: Book,
    pub(crate) bases: Bases,
    pub(crate) watch: Option<Watch>,
    stopped: AtomicBool,
}

impl Shared {
    /// State for a new crew.
    pub(crate) fn new(
        field: Arc<Field>,
        strategy: Arc<dyn Strategy>,
        book: Book,
        bases: Bases,
        watch: Option<Watch>,
    ) -> Self {
        Self {
            field,
            strategy,
            book,
            bases,
            watch,
            stopped: AtomicBool::new(false),
        }
    }

    /// Tells the workers to leave what they have not begun.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::Release);
    }

    /// Have the workers been told to leave?
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Acquire)
    }

    /// Tells a watching test where the worker is.
    pub(crate) fn at(&self, step: Step) {
        if let Some(watch) = &self.watch {
            watch(step);
        }
    }

    /// Makes mesh and collider of a chunk with the given edits. `again` says that the chunk is
    /// being edited, so that its generated samples are worth keeping.
    pub(crate) fn make(&self, coord: ChunkCoord, edits: &Snapshot, again: bool) -> Chunk {
        let base = self.base(coord, again || !edits.near.is_empty());
        let samples = if edits.near.is_empty() {
            base
        } else {
            let mut samples = Samples::clone(&base);
            apply_edits(&mut samples, coord, |near| edits.of(near));
            Arc::new(samples)
        };
        let mesh = march(&samples, &self.field, coord);
        let collider = collider(&mesh);
        Chunk {
            coord,
            mesh: Arc::new(mesh),
            collider,
            samples,
        }
    }

    fn base(&self, coord: ChunkCoord, keep: bool) -> Arc<Samples> {
        let base = self
            .bases
            .get(coord)
            .unwrap_or_else(|| Arc::new(self.field.samples(coord)));
        if keep {
            self.bases.keep(coord, &base);
        } else {
            self.bases.note(coord, &base);
        }
        base
    }
}

fn collider(mesh: &ChunkMesh) -> Option<TerrainCollider> {
    TerrainCollider::build(&mesh.positions(), mesh.triangles())
}
