//! The edits of the world, shared among the workers and the saver.
//!
//! A batch enters whole under one write lock and raises the revision by one; whoever reads takes
//! the revision and the edits under one read lock, so no chunk is ever made from half a batch.
//! The disk is read outside the locks. Edits stay in memory once read (128 kB a chunk).

use std::collections::{HashMap, HashSet};
use std::error::Error;
use std::sync::{Arc, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};

use antipode_geometry::ChunkCoord;
use antipode_terrain::ChunkEdits;

use crate::range::around;
use crate::vault::{ReadFault, Vault, key_of};

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
}

#[derive(Default)]
struct Pages {
    chunks: HashMap<ChunkCoord, Arc<ChunkEdits>>,
    /// Stored, but not yet read.
    on_disk: HashSet<ChunkCoord>,
    /// Stored, and told to be out of reach.
    complained: HashSet<ChunkCoord>,
    dirty: HashSet<ChunkCoord>,
    revision: u64,
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
        }
    }

    /// The store, if the world has one.
    pub(crate) fn vault(&self) -> Option<&dyn Vault> {
        self.vault.as_deref()
    }

    /// The edits that the padded block of a chunk needs; reads the store where it must.
    pub(crate) fn snapshot(&self, coord: ChunkCoord, problems: &mut Vec<String>) -> Snapshot {
        self.fetch(around(coord, -1, 1), problems);
        let pages = self.read();
        let near = around(coord, -1, 1)
            .filter_map(|near| Some((near, Arc::clone(pages.chunks.get(&near)?))))
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
        self.fetch(std::iter::once(coord), problems);
        let pages = self.read();
        let known = pages
            .chunks
            .get(&coord)
            .map(|edits| ChunkEdits::clone(edits));
        known.or_else(|| (!pages.on_disk.contains(&coord)).then(ChunkEdits::default))
    }

    /// Enters a batch and returns its revision. Changes too small to be seen are kept, for they
    /// add up, but there is nothing in them to show or to save.
    pub(crate) fn enter(&self, batch: Vec<Change>) -> u64 {
        let mut pages = self.write();
        if batch.iter().any(|change| change.visible) {
            pages.revision += 1;
        }
        for Change {
            coord,
            edits,
            visible,
        } in batch
        {
            pages.chunks.insert(coord, Arc::new(edits));
            if visible {
                pages.dirty.insert(coord);
            }
        }
        pages.revision
    }

    /// Takes everything that is not saved yet; whole batches only.
    pub(crate) fn take_dirty(&self) -> Vec<(ChunkCoord, Arc<ChunkEdits>)> {
        let mut pages = self.write();
        let dirty = std::mem::take(&mut pages.dirty);
        let mut taken: Vec<_> = dirty
            .into_iter()
            .filter_map(|coord| Some((coord, Arc::clone(pages.chunks.get(&coord)?))))
            .collect();
        taken.sort_unstable_by_key(|(coord, _)| *coord);
        taken
    }

    /// Marks chunks as unsaved again, after a commit that failed.
    pub(crate) fn put_back(&self, coords: impl Iterator<Item = ChunkCoord>) {
        self.write().dirty.extend(coords);
    }

    /// Reads those of the chunks that are stored and not read yet. One that cannot be had is told
    /// once and the generated chunk used instead. A damaged record is left on disk until the player
    /// edits there; one that could not be reached is tried again whenever it is needed.
    fn fetch(&self, coords: impl Iterator<Item = ChunkCoord>, problems: &mut Vec<String>) {
        let Some(vault) = self.vault() else { return };
        let missing: Vec<_> = {
            let pages = self.read();
            if pages.on_disk.is_empty() {
                return;
            }
            coords
                .filter(|coord| pages.on_disk.contains(coord))
                .collect()
        };
        for coord in missing {
            let found = read_record(vault, coord);
            let mut pages = self.write();
            // Another worker may have read it meanwhile, or a batch replaced it.
            if !pages.on_disk.remove(&coord) {
                continue;
            }
            match found {
                Ok(Some(edits)) => {
                    pages.chunks.insert(coord, Arc::new(edits));
                }
                Ok(None) => {}
                Err(ReadFault::Damaged(why)) => problems.push(not_shown(coord, &*why)),
                Err(ReadFault::Unreadable(why)) => {
                    pages.on_disk.insert(coord);
                    if pages.complained.insert(coord) {
                        problems.push(not_shown(coord, &*why));
                    }
                }
            }
        }
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
