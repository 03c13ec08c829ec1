//! The edits of the world, shared among the workers and the saver.
//!
//! A batch enters whole under one write lock and raises the revision by one; whoever reads takes
//! the revision and the edits under one read lock, so no chunk is ever made from half a batch.
//! The disk is read outside the locks. Edits stay in memory once read (128 kB a chunk) as long as
//! they are among those used last; of the others, what is saved is read again when it is needed.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::error::Error;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};

use antipode_geometry::ChunkCoord;
use antipode_terrain::ChunkEdits;

use crate::range::around;
use crate::vault::{ReadFault, Vault, key_of};

/// Saved chunks of a stored world that stay in memory, those used last: 8 MB of them.
const MOST_SAVED: usize = 64;

/// Edits of a chunk and its neighbours at one revision.
pub(crate) struct Snapshot {
    /// How many batches these edits include.
    pub(crate) revision: u64,
    /// The chunks among the 27 that have edits.
    pub(crate) near: Vec<(ChunkCoord, Arc<ChunkEdits>)>,
}

impl Snapshot {
    /// The edits of one chunk, if it has any.
    pub(crate) fn of(&self, coord: ChunkCoord) -> Option<Arc<ChunkEdits>> {
        self.near
            .iter()
            .find(|(near, _)| *near == coord)
            .map(|(_, edits)| Arc::clone(edits))
    }
}

/// The new edits of a chunk.
pub(crate) struct Change {
    pub(crate) coord: ChunkCoord,
    pub(crate) edits: ChunkEdits,
    /// Does any sample differ from before?
    pub(crate) visible: bool,
}

/// Every edit since the world was made.
pub(crate) struct Book {
    pages: RwLock<Pages>,
    vault: Option<Arc<dyn Vault>>,
    /// Counts uses.
    clock: AtomicU64,
}

/// The edits of a chunk.
struct Page {
    edits: Arc<ChunkEdits>,
    /// When they were last used.
    used: AtomicU64,
}

/// Edits of chunks to be saved, or saved.
pub(crate) type Land = BTreeMap<ChunkCoord, Arc<ChunkEdits>>;

#[derive(Default)]
struct Pages {
    chunks: HashMap<ChunkCoord, Page>,
    /// Stored, but not yet read.
    on_disk: HashSet<ChunkCoord>,
    /// Stored, and told to be out of reach.
    complained: HashSet<ChunkCoord>,
    /// Changed, and not on disk as they are.
    unsaved: Land,
    revision: u64,
    /// How often saved chunks were let go of: what was read from the store before may be older than what is there now.
    evictions: u64,
}

/// A batch that has entered the book.
#[derive(Default)]
pub(crate) struct Entered {
    pub(crate) revision: u64,
    /// What it has changed, to be saved; nothing in a world that is not kept.
    pub(crate) land: Land,
}

impl Book {
    /// A book whose stored chunks are `on_disk`.
    pub(crate) fn new(vault: Option<Arc<dyn Vault>>, on_disk: HashSet<ChunkCoord>) -> Self {
        Self {
            pages: RwLock::new(Pages {
                on_disk,
                ..Pages::default()
            }),
            vault,
            clock: AtomicU64::new(0),
        }
    }

    /// The store, if the world has one.
    pub(crate) fn vault(&self) -> Option<&dyn Vault> {
        self.vault.as_deref()
    }

    /// The edits that the padded block of a chunk needs; reads the store where it must.
    pub(crate) fn snapshot(&self, coord: ChunkCoord, problems: &mut Vec<String>) -> Snapshot {
        let near: Vec<_> = around(coord, -1, 1).collect();
        let pages = self.read_with(&near, problems);
        let near = near
            .into_iter()
            .filter_map(|near| Some((near, self.turn_to(&pages, near)?)))
            .collect();
        Snapshot {
            revision: pages.revision,
            near,
        }
    }

    /// The edits of one chunk, empty if there are none; reads the store where it must. `None` if
    /// the store has some that cannot be read now: to change the chunk would overwrite them.
    pub(crate) fn edits(
        &self,
        coord: ChunkCoord,
        problems: &mut Vec<String>,
    ) -> Option<ChunkEdits> {
        let pages = self.read_with(&[coord], problems);
        let known = self
            .turn_to(&pages, coord)
            .map(|edits| ChunkEdits::clone(&edits));
        known.or_else(|| (!pages.on_disk.contains(&coord)).then(ChunkEdits::default))
    }

    /// Enters a batch. Changes too small to be seen are kept, for they add up, but there is nothing in them to show or
    /// to save.
    pub(crate) fn enter(&self, batch: Vec<Change>) -> Entered {
        let mut pages = self.write();
        let mut land = Land::new();
        if batch.iter().any(|change| change.visible) {
            pages.revision += 1;
        }
        for Change {
            coord,
            edits,
            visible,
        } in batch
        {
            pages.on_disk.remove(&coord);
            let page = self.page(edits);
            if visible && self.vault.is_some() {
                land.insert(coord, Arc::clone(&page.edits));
            }
            pages.chunks.insert(coord, page);
        }
        pages.unsaved.extend(land.clone());
        let revision = pages.revision;
        Entered { revision, land }
    }

    /// Everything that is not saved yet.
    pub(crate) fn unsaved(&self) -> Land {
        self.read().unsaved.clone()
    }

    /// Notes that this is saved.
    pub(crate) fn saved(&self, land: &Land) {
        let mut pages = self.write();
        for (coord, saved) in land {
            let is_last = |last: &Arc<ChunkEdits>| Arc::ptr_eq(last, saved);
            if pages.unsaved.get(coord).is_some_and(is_last) {
                pages.unsaved.remove(coord);
            }
        }
    }

    /// After a commit: lets go of saved chunks that were not used for long. They are read again
    /// when needed; of what adds up within less than a stored unit, nothing is left then.
    pub(crate) fn forget_saved(&self) {
        if self.vault.is_none() {
            return;
        }
        let mut pages = self.write();
        let pages = &mut *pages;
        let is_saved = |coord: &_| !pages.unsaved.contains_key(coord);
        let saved = pages.chunks.iter().filter(|(coord, _)| is_saved(coord));
        let mut uses: Vec<_> = saved
            .map(|(&coord, page)| (page.used.load(Ordering::Relaxed), coord))
            .collect();
        let Some(count) = uses
            .len()
            .checked_sub(MOST_SAVED)
            .filter(|&count| count > 0)
        else {
            return;
        };
        uses.select_nth_unstable(count - 1);
        pages.evictions += 1;
        for &(_, coord) in &uses[..count] {
            pages.chunks.remove(&coord);
            pages.on_disk.insert(coord);
        }
    }

    /// Keeps the book as a worker does that reads it.
    #[cfg(test)]
    pub(crate) fn being_read(&self) -> impl Drop + '_ {
        self.read()
    }

    /// Chunks whose edits are in memory.
    #[cfg(test)]
    pub(crate) fn held(&self) -> usize {
        self.read().chunks.len()
    }

    fn page(&self, edits: ChunkEdits) -> Page {
        Page {
            edits: Arc::new(edits),
            used: AtomicU64::new(self.now()),
        }
    }

    fn turn_to(&self, pages: &Pages, coord: ChunkCoord) -> Option<Arc<ChunkEdits>> {
        let page = pages.chunks.get(&coord)?;
        page.used.store(self.now(), Ordering::Relaxed);
        Some(Arc::clone(&page.edits))
    }

    fn now(&self) -> u64 {
        self.clock.fetch_add(1, Ordering::Relaxed)
    }

    /// The pages with those of the chunks among them that can be had. Between reading the store and taking the lock the
    /// saver may have let go of one again; then it is read once more.
    fn read_with(
        &self,
        coords: &[ChunkCoord],
        problems: &mut Vec<String>,
    ) -> RwLockReadGuard<'_, Pages> {
        loop {
            let unreadable = self.fetch(coords.iter().copied(), problems);
            let pages = self.read();
            let is_lost = |coord: &_| pages.on_disk.contains(coord) && !unreadable.contains(coord);
            if self.vault().is_none() || !coords.iter().any(is_lost) {
                return pages;
            }
        }
    }

    /// Reads those of the chunks that are stored and not read yet, and returns those that could not be reached. One that cannot be had is told
    /// once and the generated chunk used instead. A damaged record is left on disk until the player
    /// edits there; one that could not be reached is tried again whenever it is needed.
    fn fetch(
        &self,
        coords: impl Iterator<Item = ChunkCoord>,
        problems: &mut Vec<String>,
    ) -> Vec<ChunkCoord> {
        let mut unreadable = Vec::new();
        let Some(vault) = self.vault() else {
            return unreadable;
        };
        let (missing, evictions): (Vec<_>, _) = {
            let pages = self.read();
            if pages.on_disk.is_empty() {
                return unreadable;
            }
            let missing = coords.filter(|coord| pages.on_disk.contains(coord));
            (missing.collect(), pages.evictions)
        };
        for coord in missing {
            let found = read_record(vault, coord);
            let mut pages = self.write();
            // Another worker may have read it meanwhile, or a batch replaced it; or it was replaced, saved and let go
            // of, and what was found is what it had been.
            if pages.evictions != evictions || !pages.on_disk.remove(&coord) {
                continue;
            }
            match found {
                Ok(Some(edits)) => {
                    pages.chunks.insert(coord, self.page(edits));
                }
                Ok(None) => {}
                Err(ReadFault::Damaged(why)) => problems.push(not_shown(coord, &*why)),
                Err(ReadFault::Unreadable(why)) => {
                    unreadable.push(coord);
                    pages.on_disk.insert(coord);
                    if pages.complained.insert(coord) {
                        problems.push(not_shown(coord, &*why));
                    }
                }
            }
        }
        unreadable
    }

    // A worker that panics here leaves no half-made page behind: every change is one insertion.
    fn read(&self) -> RwLockReadGuard<'_, Pages> {
        self.pages.read().unwrap_or_else(PoisonError::into_inner)
    }

    fn write(&self) -> RwLockWriteGuard<'_, Pages> {
        self.pages.write().unwrap_or_else(PoisonError::into_inner)
    }
}

fn read_record(vault: &dyn Vault, coord: ChunkCoord) -> Result<Option<ChunkEdits>, ReadFault> {
    let units = vault.chunk(&key_of(coord))?;
    units
        .map(|units| ChunkEdits::from_units(&units))
        .transpose()
        .map_err(|why| ReadFault::Damaged(why.into()))
}

fn not_shown(coord: ChunkCoord, why: &(dyn Error + Send + Sync)) -> String {
    let at = coord.index;
    format!(
        "The terrain of chunk {} {} {} is shown without what you changed there. {why}",
        at.x, at.y, at.z
    )
}

#[cfg(test)]
mod tests;
