//! The way back from the last presses of the brush: what they changed, and what they were worth.
//!
//! While a press goes on it costs nothing but the edits that the store would drop: those before its first batch. Once it
//! has ended, or reaches over many chunks, only the samples that it has changed are kept.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use antipode_geometry::ChunkCoord;
use antipode_terrain::{ChunkEdits, Earth, SampleChange, Stock};

/// Presses that can be undone.
pub(crate) const MOST_PRESSES: usize = 20;
/// Chunks of which the edits before a press are kept whole.
const MOST_WHOLE: usize = 48;
/// Samples kept of all presses, 20 bytes each; beyond them the oldest press is forgotten.
const MOST_SAMPLES: usize = 1_000_000;

/// The last presses by their numbers.
#[derive(Debug, Default)]
pub(crate) struct History {
    presses: Mutex<BTreeMap<u64, Press>>,
}

/// What a press has done.
#[derive(Debug, Default)]
pub(crate) struct Press {
    pub(crate) earth: Earth,
    pub(crate) gathered: Stock,
    /// Edits before it, and those that it made of them.
    whole: BTreeMap<ChunkCoord, [Arc<ChunkEdits>; 2]>,
    /// What it changed, in order.
    layers: Vec<(ChunkCoord, Box<[SampleChange]>)>,
}

impl Press {
    /// Keeps only what differs.
    fn pack(&mut self) {
        for (coord, [before, after]) in std::mem::take(&mut self.whole) {
            let changes = before.changes_to(&after);
            self.layers.push((coord, changes.into_boxed_slice()));
        }
    }

    fn samples(&self) -> usize {
        self.layers.iter().map(|(_, changes)| changes.len()).sum()
    }

    /// What it changed, the last first.
    pub(crate) fn back(&mut self) -> impl Iterator<Item = (ChunkCoord, &[SampleChange])> {
        self.pack();
        let layers = self.layers.iter().rev();
        layers.map(|(coord, changes)| (*coord, &**changes))
    }
}

impl History {
    /// Notes what a batch of a press has done to chunks: their edits before and after. Older presses than the last
    /// [`MOST_PRESSES`] are forgotten.
    pub(crate) fn note(
        &self,
        press: u64,
        earth: &Earth,
        gathered: &Stock,
        chunks: impl Iterator<Item = (ChunkCoord, [Arc<ChunkEdits>; 2])>,
    ) {
        let mut presses = self.lock();
        if !presses.contains_key(&press) {
            presses.values_mut().for_each(Press::pack);
        }
        let done = presses.entry(press).or_default();
        done.earth.add(earth);
        done.gathered.add_all(gathered);
        for (coord, [before, after]) in chunks {
            let whole = done.whole.entry(coord);
            whole
                .and_modify(|known| known[1] = Arc::clone(&after))
                .or_insert([before, after]);
        }
        if done.whole.len() > MOST_WHOLE {
            done.pack();
        }
        let kept = |presses: &BTreeMap<u64, Press>| {
            let samples: usize = presses.values().map(Press::samples).sum();
            presses.len() <= MOST_PRESSES && samples <= MOST_SAMPLES
        };
        while presses.len() > 1 && !kept(&presses) {
            presses.pop_first();
        }
    }

    /// Takes a press out.
    pub(crate) fn take(&self, press: u64) -> Option<Press> {
        self.lock().remove(&press)
    }

    /// Puts a press back that was not undone.
    pub(crate) fn put_back(&self, press: u64, done: Press) {
        self.lock().insert(press, done);
    }

    // Whoever panics here leaves a press that is whole, or is gone.
    fn lock(&self) -> MutexGuard<'_, BTreeMap<u64, Press>> {
        self.presses.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
