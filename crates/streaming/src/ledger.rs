//! The game's own books: which chunks are wanted, waiting, being made, there, or given up.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use antipode_geometry::{ChunkCoord, Strategy};
use antipode_terrain::{Content, Field};

use crate::api::Wish;
use crate::queue::Queue;
use crate::range::{Range, around};

/// What to do with a chunk that has been loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It is now there.
    Show,
    /// It includes a batch that is not shown yet: ask again after that.
    Hold,
    /// It is out of date or no longer wanted.
    Drop,
}

/// Bookkeeping of chunks; no threads, no channels.
pub(crate) struct Ledger {
    field: Arc<Field>,
    strategy: Arc<dyn Strategy>,
    range: Range,
    queue: Queue,
    /// Being made, with the least revision that may still be shown.
    in_flight: HashMap<ChunkCoord, u64>,
    resident: HashSet<ChunkCoord>,
    given_up: HashSet<ChunkCoord>,
    /// Chunks that own an edit.
    edited: HashSet<ChunkCoord>,
    /// Chunks that may have a surface because of an edit.
    near_edits: HashSet<ChunkCoord>,
    /// Revision of the last batch shown.
    shown: u64,
}

impl Ledger {
    /// Books of a world whose stored edits lie in `edited`.
    pub(crate) fn new(
        field: Arc<Field>,
        strategy: Arc<dyn Strategy>,
        edited: HashSet<ChunkCoord>,
    ) -> Self {
        // The cells of a chunk use its own samples and the first layer of the next ones.
        let near_edits = edited
            .iter()
            .flat_map(|&coord| around(coord, -1, 0))
            .collect();
        Self {
            field,
            strategy,
            range: Range::Nothing,
            queue: Queue::default(),
            in_flight: HashMap::new(),
            resident: HashSet::new(),
            given_up: HashSet::new(),
            edited,
            near_edits,
            shown: 0,
        }
    }

    /// Moves the range; returns the chunks that are gone.
    pub(crate) fn wish(&mut self, wish: &Wish) -> Vec<ChunkCoord> {
        self.queue.look(wish.centre, wish.front);
        let range = Range::wished(&*self.strategy, wish.centre, wish.view_distance);
        if range == self.range {
            return Vec::new();
        }
        let before = std::mem::replace(&mut self.range, range);
        let range = &self.range;
        self.queue.retain(|coord| range.contains(coord));
        self.given_up.retain(|&coord| range.keeps(coord));
        let mut gone: Vec<_> = self
            .resident
            .extract_if(|&coord| !range.keeps(coord))
            .collect();
        gone.sort_unstable();
        for coord in self.range.all() {
            // What was wanted before is waiting, being made, there or given up already.
            if !before.contains(coord) && self.is_missing(coord) {
                self.queue.push(coord);
            }
        }
        gone
    }

    fn is_missing(&self, coord: ChunkCoord) -> bool {
        let known = self.resident.contains(&coord) || self.in_flight.contains_key(&coord);
        !known && !self.given_up.contains(&coord) && self.needs_mesh(coord)
    }

    fn needs_mesh(&self, coord: ChunkCoord) -> bool {
        self.near_edits.contains(&coord) || self.field.content(coord) == Content::Surface
    }

    /// Takes the next chunk to load, if fewer than `most` are being made.
    pub(crate) fn next_load(&mut self, most: usize) -> Option<ChunkCoord> {
        if self.in_flight.len() >= most {
            return None;
        }
        let coord = self.queue.pop(&*self.strategy)?;
        self.in_flight.insert(coord, 0);
        Some(coord)
    }

    /// Takes back a load that could not be handed over.
    pub(crate) fn not_sent(&mut self, coord: ChunkCoord) {
        self.in_flight.remove(&coord);
        self.queue.push(coord);
    }

    /// Judges a load made from `revision`.
    pub(crate) fn loaded(&mut self, coord: ChunkCoord, revision: u64) -> Verdict {
        if revision > self.shown {
            return Verdict::Hold;
        }
        let least = self.in_flight.remove(&coord).unwrap_or(0);
        if !self.range.keeps(coord) || self.resident.contains(&coord) {
            return Verdict::Drop;
        }
        if revision < least {
            // In the kept ring a chunk is not asked for anew; it is when the range comes back.
            if self.range.contains(coord) {
                self.queue.push(coord);
            }
            return Verdict::Drop;
        }
        self.resident.insert(coord);
        Verdict::Show
    }

    /// Notes that a chunk cannot be made.
    pub(crate) fn give_up(&mut self, coord: ChunkCoord) {
        self.in_flight.remove(&coord);
        if self.range.keeps(coord) {
            self.given_up.insert(coord);
        }
    }

    /// Notes a finished batch, shown or not: from now on nothing older of these chunks will do.
    pub(crate) fn batch_ended(
        &mut self,
        touched: &[ChunkCoord],
        remeshed: &[ChunkCoord],
        revision: u64,
    ) {
        self.shown = self.shown.max(revision);
        self.edited.extend(touched);
        self.near_edits.extend(remeshed);
        for coord in remeshed {
            if let Some(least) = self.in_flight.get_mut(coord) {
                *least = revision.max(*least);
            }
        }
    }

    /// Notes a chunk that came with a batch; false if it is out of range and not to be shown.
    pub(crate) fn show_edited(&mut self, coord: ChunkCoord) -> bool {
        if !self.range.keeps(coord) {
            return false;
        }
        self.resident.insert(coord);
        self.given_up.remove(&coord);
        self.queue.retain(|waiting| waiting != coord);
        true
    }

    /// Leaves everything that has not begun.
    pub(crate) fn clear_queue(&mut self) {
        self.queue.retain(|_| false);
    }

    /// Wants again what [`clear_queue`](Self::clear_queue) has left.
    pub(crate) fn refill_queue(&mut self) {
        for coord in self.range.all() {
            if self.is_missing(coord) && !self.queue.contains(coord) {
                self.queue.push(coord);
            }
        }
    }

    /// Is the chunk waiting or being made?
    pub(crate) fn is_coming(&self, coord: ChunkCoord) -> bool {
        let in_flight = self.in_flight.contains_key(&coord) && !self.resident.contains(&coord);
        in_flight || self.queue.contains(coord)
    }

    /// Is everything the chunk has there? One without a surface has nothing to wait for.
    pub(crate) fn is_resident(&self, coord: ChunkCoord) -> bool {
        self.resident.contains(&coord) || (self.range.contains(coord) && !self.needs_mesh(coord))
    }

    /// Is nothing more to come of the chunk? Then it is there, has no surface or was given up.
    pub(crate) fn is_ready(&self, coord: ChunkCoord) -> bool {
        self.is_resident(coord) || self.given_up.contains(&coord)
    }

    /// Is the chunk within the range last wished for?
    pub(crate) fn is_wanted(&self, coord: ChunkCoord) -> bool {
        self.range.contains(coord)
    }

    /// Chunks waiting or being made.
    pub(crate) fn coming(&self) -> usize {
        self.queue.len() + self.in_flight.len()
    }

    /// Chunks with a mesh that are there.
    pub(crate) fn resident_count(&self) -> usize {
        self.resident.len()
    }

    /// Chunks of the world that own an edit.
    pub(crate) fn edited_count(&self) -> usize {
        self.edited.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use antipode_geometry::{ChartPoint, Geometry, Hemisphere, strategy};
    use glam::{DVec3, IVec3};

    fn ledger(edited: &[ChunkCoord]) -> Ledger {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        let field = Arc::new(Field::new(3, Arc::clone(&space)));
        Ledger::new(field, space, edited.iter().copied().collect())
    }

    fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
        ChunkCoord {
            hemisphere: Hemisphere::A,
            index: IVec3::new(x, y, z),
        }
    }

    fn wish_at(x: f64, view_distance: u32) -> Wish {
        Wish {
            centre: ChartPoint::a(DVec3::new(x, 16.0, 16.0)),
            front: DVec3::X,
            view_distance,
        }
    }

    fn take_all(ledger: &mut Ledger) -> Vec<ChunkCoord> {
        std::iter::from_fn(|| ledger.next_load(usize::MAX)).collect()
    }

    #[test]
    fn going_there_and_back_neither_loses_nor_doubles_a_chunk() {
        let mut ledger = ledger(&[]);
        ledger.wish(&wish_at(16.0, 1));
        let first = take_all(&mut ledger);
        ledger.wish(&wish_at(16.0 + 96.0, 1));
        ledger.wish(&wish_at(16.0, 1));
        assert!(
            take_all(&mut ledger)
                .iter()
                .all(|coord| !first.contains(coord)),
            "a chunk is made twice"
        );
        assert!(
            first
                .iter()
                .all(|&coord| ledger.loaded(coord, 0) == Verdict::Show)
        );
        assert_eq!(ledger.resident_count(), first.len());
    }

    #[test]
    fn one_chunk_beyond_is_kept_and_two_are_not() {
        let mut ledger = ledger(&[]);
        ledger.wish(&wish_at(16.0, 1));
        let first = take_all(&mut ledger);
        for &coord in &first {
            assert_eq!(ledger.loaded(coord, 0), Verdict::Show);
        }
        assert!(ledger.wish(&wish_at(16.0 + 32.0, 1)).is_empty());
        let gone = ledger.wish(&wish_at(16.0 + 64.0, 1));
        let want: Vec<_> = first.iter().filter(|coord| coord.index.x == -1).collect();
        assert!(
            !want.is_empty()
                && gone.len() == want.len()
                && gone.iter().all(|coord| coord.index.x == -1)
        );
    }

    #[test]
    fn a_load_older_than_a_shown_batch_is_made_again() {
        let mut ledger = ledger(&[]);
        ledger.wish(&wish_at(16.0, 1));
        let coord = take_all(&mut ledger)[0];
        ledger.batch_ended(&[coord], &[coord], 1);
        assert_eq!(ledger.loaded(coord, 0), Verdict::Drop);
        assert_eq!(take_all(&mut ledger), [coord]);
        assert_eq!(ledger.loaded(coord, 1), Verdict::Show);
    }

    #[test]
    fn a_load_newer_than_what_is_shown_waits_for_its_batch() {
        let mut ledger = ledger(&[]);
        ledger.wish(&wish_at(16.0, 1));
        let coords = take_all(&mut ledger);
        assert_eq!(ledger.loaded(coords[0], 1), Verdict::Hold);
        ledger.batch_ended(&[coords[1]], &[coords[1]], 1);
        assert_eq!(ledger.loaded(coords[0], 1), Verdict::Show);
    }

    #[test]
    fn a_stored_edit_gives_a_chunk_without_a_surface_a_mesh() {
        let sky = chunk(0, 60, 0);
        let mut plain = ledger(&[]);
        let mut built = ledger(&[sky]);
        let wish = Wish {
            centre: ChartPoint::a(sky.origin()),
            front: DVec3::X,
            view_distance: 2,
        };
        plain.wish(&wish);
        built.wish(&wish);
        assert!(plain.is_resident(sky) && plain.coming() == 0);
        assert!(!built.is_resident(sky));
        // Its own cells, and those of the seven chunks whose last layer uses its first samples.
        assert_eq!(take_all(&mut built).len(), 8);
    }
}
