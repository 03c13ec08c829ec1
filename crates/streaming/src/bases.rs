//! Generated samples that are still around, so that digging need not make the noise again, and the
//! colliders of what is being dug, of which most parts stay the same.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use antipode_geometry::ChunkCoord;
use antipode_physics::TerrainCollider;
use antipode_terrain::Samples;
use lru::LruCache;

/// Names of dropped chunks tolerated before they are cleared out.
const MOST_NAMES: usize = 4096;

/// Colliders kept: all that one brush reaches, with their neighbours. One takes some 400 kB.
const MOST_COLLIDERS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(26);

/// The chunks most recently dug, and every unedited chunk that the game itself still holds: its
/// samples are the generated ones, so remembering them costs nothing.
pub(crate) struct Bases {
    inner: Mutex<Inner>,
}

struct Inner {
    kept: LruCache<ChunkCoord, Arc<Samples>>,
    elsewhere: HashMap<ChunkCoord, Weak<Samples>>,
    colliders: LruCache<ChunkCoord, TerrainCollider>,
}

impl Bases {
    /// Keeps at most `most_kept` chunks alive by itself.
    pub(crate) fn new(most_kept: usize) -> Self {
        let most_kept = NonZeroUsize::new(most_kept).unwrap_or(NonZeroUsize::MIN);
        Self {
            inner: Mutex::new(Inner {
                kept: LruCache::new(most_kept),
                elsewhere: HashMap::new(),
                colliders: LruCache::new(MOST_COLLIDERS),
            }),
        }
    }

    /// The generated samples, if anyone still has them.
    pub(crate) fn get(&self, coord: ChunkCoord) -> Option<Arc<Samples>> {
        let mut inner = self.lock();
        let kept = inner.kept.get(&coord).cloned();
        kept.or_else(|| inner.elsewhere.get(&coord).and_then(Weak::upgrade))
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
        self.lock().kept.put(coord, Arc::clone(samples));
    }

    /// The last collider of a chunk that is being edited.
    pub(crate) fn collider(&self, coord: ChunkCoord) -> Option<TerrainCollider> {
        self.lock().colliders.get(&coord).cloned()
    }

    /// Keeps the collider of a chunk that is being edited.
    pub(crate) fn keep_collider(&self, coord: ChunkCoord, collider: Option<TerrainCollider>) {
        let mut inner = self.lock();
        match collider {
            Some(collider) => inner.colliders.put(coord, collider),
            None => inner.colliders.pop(&coord),
        };
    }

    // A worker that panics here leaves nothing half-made: every change is one insertion.
    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
