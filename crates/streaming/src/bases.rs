//! Generated samples that are still around, so that digging need not make the noise again, and the
//! colliders of what is being dug, of which most parts stay the same.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use antipode_geometry::ChunkCoord;
use antipode_physics::TerrainCollider;
use antipode_terrain::Samples;

/// Names of dropped chunks tolerated before they are cleared out.
const MOST_NAMES: usize = 4096;

/// Colliders kept: all that one brush reaches, with their neighbours. One takes some 400 kB.
const MOST_COLLIDERS: usize = 27;

/// The chunks most recently dug, and every unedited chunk that the game itself still holds: its
/// samples are the generated ones, so remembering them costs nothing.
pub(crate) struct Bases {
    inner: Mutex<Inner>,
    most_kept: usize,
}

#[derive(Default)]
struct Inner {
    kept: HashMap<ChunkCoord, (u64, Arc<Samples>)>,
    elsewhere: HashMap<ChunkCoord, Weak<Samples>>,
    colliders: HashMap<ChunkCoord, (u64, TerrainCollider)>,
    clock: u64,
}

impl Bases {
    /// Keeps at most `most_kept` chunks alive by itself.
    pub(crate) fn new(most_kept: usize) -> Self {
        Self {
            inner: Mutex::default(),
            most_kept: most_kept.max(1),
        }
    }

    /// The generated samples, if anyone still has them.
    pub(crate) fn get(&self, coord: ChunkCoord) -> Option<Arc<Samples>> {
        let mut inner = self.lock();
        inner.clock += 1;
        let now = inner.clock;
        if let Some((used, samples)) = inner.kept.get_mut(&coord) {
            *used = now;
            return Some(Arc::clone(samples));
        }
        inner.elsewhere.get(&coord).and_then(Weak::upgrade)
    }

    /// Remembers samples for as long as somebody else holds them.
    pub(crate) fn note(&self, coord: ChunkCoord, samples: &Arc<Samples>) {
        let mut inner = self.lock();
        if inner.elsewhere.len() >= MOST_NAMES {
            inner
                .elsewhere
                .retain(|_, samples| samples.strong_count() > 0);
        }
        inner.elsewhere.insert(coord, Arc::downgrade(samples));
    }

    /// Keeps samples alive until `most_kept` others have been used since.
    pub(crate) fn keep(&self, coord: ChunkCoord, samples: &Arc<Samples>) {
        let mut inner = self.lock();
        inner.clock += 1;
        let now = inner.clock;
        inner.kept.insert(coord, (now, Arc::clone(samples)));
        drop_oldest(&mut inner.kept, self.most_kept);
    }

    /// The last collider of a chunk that is being edited.
    pub(crate) fn collider(&self, coord: ChunkCoord) -> Option<TerrainCollider> {
        let inner = self.lock();
        inner
            .colliders
            .get(&coord)
            .map(|(_, collider)| collider.clone())
    }

    /// Keeps the collider of a chunk that is being edited.
    pub(crate) fn keep_collider(&self, coord: ChunkCoord, collider: Option<TerrainCollider>) {
        let mut inner = self.lock();
        inner.clock += 1;
        let now = inner.clock;
        match collider {
            Some(collider) => _ = inner.colliders.insert(coord, (now, collider)),
            None => _ = inner.colliders.remove(&coord),
        }
        drop_oldest(&mut inner.colliders, MOST_COLLIDERS);
    }

    // A worker that panics here leaves nothing half-made: every change is one insertion.
    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Drops what was used longest ago, if there is more than `most`.
fn drop_oldest<T>(kept: &mut HashMap<ChunkCoord, (u64, T)>, most: usize) {
    if kept.len() > most {
        let oldest = kept.iter().min_by_key(|(_, (used, _))| *used);
        if let Some(oldest) = oldest.map(|(coord, _)| *coord) {
            kept.remove(&oldest);
        }
    }
}
