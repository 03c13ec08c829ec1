//! Generated samples that are still around, so that digging need not make the noise again.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use antipode_geometry::ChunkCoord;
use antipode_terrain::Samples;

/// Names of dropped chunks tolerated before they are cleared out.
const MOST_NAMES: usize = 4096;

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
        let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
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
        let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        if inner.elsewhere.len() >= MOST_NAMES {
            inner
                .elsewhere
                .retain(|_, samples| samples.strong_count() > 0);
        }
        inner.elsewhere.insert(coord, Arc::downgrade(samples));
    }

    /// Keeps samples alive until `most_kept` others have been used since.
    pub(crate) fn keep(&self, coord: ChunkCoord, samples: &Arc<Samples>) {
        let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        inner.clock += 1;
        let now = inner.clock;
        inner.kept.insert(coord, (now, Arc::clone(samples)));
        if inner.kept.len() > self.most_kept {
            let oldest = inner
                .kept
                .iter()
                .min_by_key(|(_, (used, _))| *used)
                .map(|(coord, _)| *coord);
            if let Some(oldest) = oldest {
                inner.kept.remove(&oldest);
            }
        }
    }
}
