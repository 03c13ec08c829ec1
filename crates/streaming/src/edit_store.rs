//! The edits of the world, shared among the workers and the saver.
//!
//! A batch enters whole under one lock and raises the revision by one. A reader takes the revision and the edits under
//! one lock, too, so that no chunk is ever made from half a batch.
//! The disk is read outside the locks. Edits stay in memory once read (128 kB a chunk) as long as
//! they are among those used last; of the others, what is saved is read again when it is needed.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::error::Error;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use antipode_geometry::{ChartId, ChunkCoord};
use antipode_plants::left_of;
use antipode_terrain::{ChunkEdits, FIRST_PLANTED, Thing};
use lru::LruCache;

use crate::edit_backend::{EditBackend, ReadFault, Stored, key_of};
use crate::range::around;
use crate::strokes::ThingChange;

/// Saved chunks of a stored world that stay in memory, those used last: 8 MB of them.
const MOST_SAVED: usize = 64;

/// Said once of a world.
const UNKNOWN_KINDS: &str = "Somebody has built with a kind of ground that only a later version of the game knows. It is shown \
                             as soil here, and stays in the world as it is.";

/// Edits of a chunk and its neighbours at one revision.
pub(crate) struct Snapshot {
    /// How many batches these edits include.
    pub(crate) revision: u64,
    /// The chunks among the 27 that have edits.
    pub(crate) near: Vec<(ChunkCoord, Arc<ChunkEdits>)>,
    /// What was felled in the chunk's column, a bit for each slot.
    pub(crate) felled: u128,
    /// What somebody planted on the chunk.
    pub(crate) planted: Vec<Thing>,
}

impl Snapshot {
    /// Whether a thing on the chunk was not felled.
    pub(crate) fn keeps(&self, thing: &Thing) -> bool {
        self.felled.unbounded_shr(thing.slot.into()) & 1 == 0
    }

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
    /// Those that it had.
    pub(crate) before: Arc<ChunkEdits>,
    pub(crate) edits: Arc<ChunkEdits>,
    /// Does any sample differ from before?
    pub(crate) visible: bool,
}

impl Change {
    /// None yet of a chunk that has these edits.
    pub(crate) fn of(coord: ChunkCoord, before: Arc<ChunkEdits>) -> Self {
        Self {
            coord,
            edits: Arc::clone(&before),
            before,
            visible: false,
        }
    }

    /// The edits, to change them.
    pub(crate) fn edits_mut(&mut self) -> &mut ChunkEdits {
        Arc::make_mut(&mut self.edits)
    }

    /// Whether nothing is left of all edits of the chunk.
    pub(crate) fn is_undone(&self) -> bool {
        self.edits.is_untouched()
    }

    /// The edits before and after.
    pub(crate) fn states(&self) -> (ChunkCoord, [Arc<ChunkEdits>; 2]) {
        let states = [&self.before, &self.edits];
        (self.coord, states.map(Arc::clone))
    }
}

/// Every edit since the world was made.
pub(crate) struct EditStore {
    state: Mutex<State>,
    backend: Option<Arc<dyn EditBackend>>,
}

/// Chunks over each other: their chart, and their index along x and z.
pub type Column = (ChartId, [i32; 2]);

/// The column of a chunk.
pub fn column_of(coord: ChunkCoord) -> Column {
    (coord.chart, [coord.index.x, coord.index.z])
}

/// Edits of chunks to be saved, or saved.
pub(crate) type EditMap = BTreeMap<ChunkCoord, Arc<ChunkEdits>>;

struct State {
    /// Edits in memory, in the order of their use. What is unsaved stays, so that the cache has no bound of its own.
    chunks: LruCache<ChunkCoord, Arc<ChunkEdits>>,
    /// Stored, but not yet read.
    on_disk: HashSet<ChunkCoord>,
    /// Stored, and told to be out of reach.
    complained: HashSet<ChunkCoord>,
    /// Whether it was told that there are kinds of ground of a later game.
    told: bool,
    /// Changed, and not on disk as they are.
    unsaved: EditMap,
    /// What was felled of each column of chunks, a bit for each slot. Whoever fells it keeps it.
    felled: HashMap<Column, u128>,
    /// What somebody planted on each chunk. Whoever planted it keeps it.
    planted: HashMap<ChunkCoord, Vec<Thing>>,
    revision: u64,
    /// How often saved chunks were let go of: what was read from the store before may be older than what is there now.
    evictions: u64,
}

impl State {
    /// Has a thing stand in its slot.
    fn plant(&mut self, coord: ChunkCoord, thing: Thing) {
        let planted = self.planted.entry(coord).or_default();
        planted.retain(|it| it.slot != thing.slot);
        planted.push(thing);
    }

    /// Leaves of what was planted in a slot what is left of such a thing.
    fn fell_planted(&mut self, coord: ChunkCoord, slot: u8) {
        let planted = self.planted.entry(coord).or_default();
        let left = |it: Thing| {
            if it.slot == slot {
                left_of(&it)
            } else {
                Some(it)
            }
        };
        *planted = planted.drain(..).filter_map(left).collect();
    }
}

/// A batch that has entered the edit store.
#[derive(Default)]
pub(crate) struct Entered {
    pub(crate) revision: u64,
    /// What it has changed, to be saved; nothing in a world that is not kept.
    pub(crate) land: EditMap,
}

impl EditStore {
    /// A store whose chunks on disk are `on_disk`.
    pub(crate) fn new(backend: Option<Arc<dyn EditBackend>>, on_disk: HashSet<ChunkCoord>) -> Self {
        Self {
            state: Mutex::new(State {
                chunks: LruCache::unbounded(),
                on_disk,
                complained: HashSet::new(),
                told: false,
                unsaved: EditMap::new(),
                felled: HashMap::new(),
                planted: HashMap::new(),
                revision: 0,
                evictions: 0,
            }),
            backend,
        }
    }

    /// Where edits are kept on disk, if the world has a save.
    pub(crate) fn backend(&self) -> Option<&dyn EditBackend> {
        self.backend.as_deref()
    }

    /// The edits that the padded block of a chunk needs; reads the store where it must.
    pub(crate) fn snapshot(&self, coord: ChunkCoord, problems: &mut Vec<String>) -> Snapshot {
        let near: Vec<_> = around(coord, -1, 1).collect();
        let mut state = self.lock_with(&near, problems);
        let near = near
            .into_iter()
            .filter_map(|near| Some((near, Arc::clone(state.chunks.get(&near)?))))
            .collect();
        Snapshot {
            revision: state.revision,
            near,
            felled: state
                .felled
                .get(&column_of(coord))
                .copied()
                .unwrap_or_default(),
            planted: state.planted.get(&coord).cloned().unwrap_or_default(),
        }
    }

    /// The edits of one chunk, empty if there are none; reads the store where it must. `None` if
    /// the store has some that cannot be read now: to change the chunk would overwrite them.
    pub(crate) fn edits(
        &self,
        coord: ChunkCoord,
        problems: &mut Vec<String>,
    ) -> Option<Arc<ChunkEdits>> {
        let (known, is_lost) = {
            let mut state = self.lock_with(&[coord], problems);
            let known = state.chunks.get(&coord).cloned();
            (known, state.on_disk.contains(&coord))
        };
        match known {
            Some(edits) => Some(edits),
            None => (!is_lost).then(Arc::default),
        }
    }

    /// Enters a batch. Changes too small to be seen are kept, for they add up, but there is nothing in them to show or
    /// to save.
    pub(crate) fn enter(&self, batch: Vec<Change>) -> Entered {
        let mut state = self.lock();
        let mut land = EditMap::new();
        if batch.iter().any(|change| change.visible) {
            state.revision += 1;
        }
        for Change {
            coord,
            edits,
            visible,
            ..
        } in batch
        {
            state.on_disk.remove(&coord);
            if visible && self.backend.is_some() {
                land.insert(coord, Arc::clone(&edits));
            }
            state.chunks.put(coord, edits);
        }
        state.unsaved.extend(land.clone());
        let revision = state.revision;
        Entered { revision, land }
    }

    /// Enters a change of a thing, as a batch.
    pub(crate) fn change(&self, coord: ChunkCoord, change: &ThingChange) -> Entered {
        let mut state = self.lock();
        state.revision += 1;
        match *change {
            ThingChange::Felled(slot) if slot < FIRST_PLANTED => {
                let slots = state.felled.entry(column_of(coord)).or_default();
                *slots |= 1_u128 << slot;
            }
            ThingChange::Felled(slot) => state.fell_planted(coord, slot),
            ThingChange::Planted(thing) => state.plant(coord, thing),
            ThingChange::Gone(slot) => {
                let planted = state.planted.entry(coord).or_default();
                planted.retain(|it| it.slot != slot);
            }
        }
        Entered {
            revision: state.revision,
            land: EditMap::new(),
        }
    }

    /// What was felled of a column, a bit for each slot.
    pub(crate) fn felled(&self, column: Column) -> u128 {
        self.lock().felled.get(&column).copied().unwrap_or_default()
    }

    /// Takes over what was felled of a column in earlier visits, before anything is made.
    pub(crate) fn remember_felled(&self, column: Column, slots: u128) {
        *self.lock().felled.entry(column).or_default() |= slots;
    }

    /// Takes over what was planted on a chunk in earlier visits, before anything is made.
    pub(crate) fn remember_planted(&self, coord: ChunkCoord, thing: Thing) {
        self.lock().plant(coord, thing);
    }

    /// Everything that is not saved yet.
    pub(crate) fn unsaved(&self) -> EditMap {
        self.lock().unsaved.clone()
    }

    /// Notes that this is saved.
    pub(crate) fn saved(&self, land: &EditMap) {
        let mut state = self.lock();
        for (coord, saved) in land {
            let is_last = |last: &Arc<ChunkEdits>| Arc::ptr_eq(last, saved);
            if state.unsaved.get(coord).is_some_and(is_last) {
                state.unsaved.remove(coord);
            }
        }
    }

    /// After a commit: lets go of saved chunks that were not used for long. They are read again
    /// when needed; of what adds up within less than a stored unit, nothing is left then.
    pub(crate) fn forget_saved(&self) {
        if self.backend.is_none() {
            return;
        }
        let mut state = self.lock();
        let state = &mut *state;
        let is_saved = |coord: &ChunkCoord| !state.unsaved.contains_key(coord);
        let by_use = state.chunks.iter().map(|(coord, _)| *coord);
        let forgotten: Vec<_> = by_use.filter(is_saved).skip(MOST_SAVED).collect();
        if forgotten.is_empty() {
            return;
        }
        state.evictions += 1;
        for coord in forgotten {
            state.chunks.pop(&coord);
            state.on_disk.insert(coord);
        }
    }

    /// Locks the store as a worker that reads it does.
    #[cfg(test)]
    pub(crate) fn being_read(&self) -> impl Drop + '_ {
        self.lock()
    }

    /// Chunks whose edits are in memory.
    #[cfg(test)]
    pub(crate) fn held(&self) -> usize {
        self.lock().chunks.len()
    }

    /// The state, with those of the chunks read that can be had. Between reading the store and taking the lock the
    /// saver may have let go of one again; then it is read once more.
    fn lock_with(
        &self,
        coords: &[ChunkCoord],
        problems: &mut Vec<String>,
    ) -> MutexGuard<'_, State> {
        loop {
            let unreadable = self.fetch(coords.iter().copied(), problems);
            let state = self.lock();
            let is_lost = |coord: &_| state.on_disk.contains(coord) && !unreadable.contains(coord);
            if self.backend().is_none() || !coords.iter().any(is_lost) {
                return state;
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
        let Some(backend) = self.backend() else {
            return unreadable;
        };
        let (missing, evictions): (Vec<_>, _) = {
            let state = self.lock();
            if state.on_disk.is_empty() {
                return unreadable;
            }
            let missing = coords.filter(|coord| state.on_disk.contains(coord));
            (missing.collect(), state.evictions)
        };
        for coord in missing {
            let found = read_record(backend, coord);
            let mut state = self.lock();
            // Another worker may have read it meanwhile, or a batch replaced it; or it was replaced, saved and let go
            // of, and what was found is what it had been.
            if state.evictions != evictions || !state.on_disk.remove(&coord) {
                continue;
            }
            match found {
                Ok(Some(edits)) => {
                    if edits.has_unknown_kinds() && !std::mem::replace(&mut state.told, true) {
                        problems.push(UNKNOWN_KINDS.to_owned());
                    }
                    state.chunks.put(coord, Arc::new(edits));
                }
                Ok(None) => {}
                Err(ReadFault::Damaged(why)) => problems.push(not_shown(coord, &*why)),
                Err(ReadFault::Unreadable(why)) => {
                    unreadable.push(coord);
                    state.on_disk.insert(coord);
                    if state.complained.insert(coord) {
                        problems.push(not_shown(coord, &*why));
                    }
                }
            }
        }
        unreadable
    }

    // A worker that panics here leaves nothing half-made behind: every change is one insertion.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn read_record(
    backend: &dyn EditBackend,
    coord: ChunkCoord,
) -> Result<Option<ChunkEdits>, ReadFault> {
    let units = backend.chunk(&key_of(coord))?;
    let edits = |(units, kinds): Stored| ChunkEdits::from_units(&units)?.with_kind_bytes(&kinds);
    units
        .map(edits)
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
