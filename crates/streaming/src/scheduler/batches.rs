//! Edit batches: how their chunks are made, and what follows from them.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use antipode_terrain::Level;

use super::{ChunkScheduler, Make, Shown};
use crate::plan::Target;
use crate::range::around;

impl ChunkScheduler {
    /// How the chunks of a batch that is handed over are to be made. Until the batch has ended their
    /// levels stay as they are.
    pub(crate) fn begin_batch(&mut self, coords: impl Iterator<Item = ChunkCoord>) -> Vec<Make> {
        let make = |coord| Make {
            coord,
            level: self.batch_level(coord),
            solid: self.is_solid_ground(coord),
        };
        let makes: Vec<_> = coords.map(make).collect();
        self.batch.extend(makes.iter().map(|make| make.coord));
        makes
    }

    /// By level, the chunks coarser than full that are there, or are being made, beside some chunks.
    pub(crate) fn coarse_beside(
        &self,
        coords: &BTreeSet<ChunkCoord>,
    ) -> BTreeMap<Level, BTreeSet<ChunkCoord>> {
        let mut found = BTreeMap::<_, BTreeSet<_>>::new();
        for coord in coords.iter().flat_map(|&coord| around(coord, -1, 1)) {
            let known = self.resident.contains_key(&coord) || self.in_flight.contains_key(&coord);
            if !known || coords.contains(&coord) {
                continue;
            }
            let level = self.batch_level(coord);
            if level > Level::FULL {
                found.entry(level).or_default().insert(coord);
            }
        }
        found
    }

    fn batch_level(&self, coord: ChunkCoord) -> Level {
        if self.is_solid_ground(coord) {
            return Level::FULL;
        }
        let coming = self.in_flight.get(&coord).map(|flight| flight.level);
        let shown = self.resident.get(&coord).map(|shown| shown.level);
        let planned = self.target(coord).map(|target| target.level);
        let known = coming.or(shown).or(planned);
        known.unwrap_or_else(|| self.wished.level(&self.field, coord))
    }

    /// Takes back a batch that could not be handed over.
    pub(crate) fn batch_not_sent(&mut self) {
        self.end_batch(&[]);
    }

    fn end_batch(&mut self, remeshed: &[ChunkCoord]) {
        let held = std::mem::take(&mut self.batch);
        for coord in held.into_iter().chain(remeshed.iter().copied()) {
            self.enqueue(coord);
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
        for &coord in remeshed {
            if let Some(flight) = self.in_flight.get_mut(&coord) {
                flight.least = revision.max(flight.least);
            }
            if !self.wished.near_edits.contains(&coord) {
                Arc::make_mut(&mut self.wished.near_edits).insert(coord);
                self.plan_due |= self.wished.range.keeps(coord);
            }
            if self.wished.range.keeps(coord) && self.target(coord).is_none() {
                let level = self.wished.level(&self.field, coord);
                let past_edge = self.wished.range.is_past_edge(coord);
                let wanted = self.wished.range.contains(coord)
                    && (!past_edge || self.wished.bodies.wants(coord));
                self.late.insert(coord, Target { level, wanted });
            }
        }
        self.end_batch(remeshed);
    }

    /// Notes chunks that are as nobody had touched them.
    pub(crate) fn emptied(&mut self, chunks: &[ChunkCoord]) {
        for coord in chunks {
            self.edited.remove(coord);
        }
    }

    /// Notes that the borders of chunks have changed with a finished batch, but not their surface.
    pub(crate) fn borders_changed(&mut self, bordering: &[ChunkCoord], revision: u64) {
        for coord in bordering {
            if let Some(flight) = self.in_flight.get_mut(coord) {
                flight.least = revision.max(flight.least);
            }
        }
    }

    /// Notes a chunk that came with a batch; false if it is out of range and not to be shown.
    pub(crate) fn show_edited(&mut self, make: Make) -> bool {
        let Make {
            coord,
            level,
            solid,
        } = make;
        if !self.wished.range.keeps(coord) {
            return false;
        }
        self.put(coord, Shown { level, solid });
        self.given_up.remove(&coord);
        self.queue.remove(coord);
        self.release(coord);
        true
    }
}
