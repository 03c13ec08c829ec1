//! Chooses the chunk that is made next, and decides what happens with a finished one.
//!
//! Chunks that share a face are never more than one level apart, as far as can be: a level is held
//! to what the neighbours have, and to what is being made of them. Since targets differ by one at
//! most, there is always a chunk that may go on: of those to become finer the coarsest, for a
//! neighbour coarser still would have to become finer too, and likewise the other way.

use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use antipode_terrain::Level;

use super::{ChunkScheduler, Flight, Make, Shown};
use crate::levels::{allowed, faces};

/// What to do with a chunk that has been loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It is now there.
    Show,
    /// It was there; now it is solid too.
    Harden,
    /// It includes a batch that is not shown yet: ask again after that.
    Hold,
    /// It is out of date or no longer wanted.
    Drop,
}

/// What a chunk lacks.
enum Need {
    Nothing,
    Made(Make),
    /// Its neighbours, or a batch under way, must come first.
    Later,
}

impl ChunkScheduler {
    pub(super) fn enqueue(&mut self, coord: ChunkCoord) {
        if !matches!(self.need(coord), Need::Nothing) {
            self.blocked.remove(&coord);
            let missing = !self.resident.contains_key(&coord);
            self.queue.push(coord, missing, &*self.strategy);
        }
    }

    /// What a chunk lacks of its target, as far as its neighbours allow.
    fn need(&self, coord: ChunkCoord) -> Need {
        let kept = self.wished.range.keeps(coord) && !self.given_up.contains(&coord);
        let Some(target) = self.target(coord).filter(|_| kept) else {
            return Need::Nothing;
        };
        let shown = self.resident.get(&coord);
        let solid = self.is_solid_ground(coord);
        let level = if solid { Level::FULL } else { target.level };
        let there = match shown {
            Some(shown) => shown.level == level && (shown.solid || !solid),
            None => !target.wanted,
        };
        if there || self.in_flight.contains_key(&coord) {
            return Need::Nothing;
        }
        if self.batch.contains(&coord) {
            return Need::Later;
        }
        // Bodies wait for their ground; nothing may hold it up.
        let level = match (solid, self.allowed(coord)) {
            (false, Some((finest, coarsest))) => level.clamp(finest, coarsest),
            (false, None) if shown.is_some() => return Need::Later,
            _ => level,
        };
        match shown {
            Some(shown) if shown.level == level && !solid => Need::Later,
            _ => Need::Made(Make {
                coord,
                level,
                solid,
            }),
        }
    }

    /// Must the chunk be solid, or stay so?
    pub(super) fn is_solid_ground(&self, coord: ChunkCoord) -> bool {
        let bodies = &self.wished.bodies;
        let shown = self.resident.get(&coord);
        bodies.wants(coord) || (shown.is_some_and(|shown| shown.solid) && bodies.keeps(coord))
    }

    /// The levels that a chunk may have beside what its neighbours have and are about to have.
    fn allowed(&self, coord: ChunkCoord) -> Option<(Level, Level)> {
        let beside = faces(&*self.strategy, coord).flat_map(|next| {
            let shown = self.resident.get(&next).map(|shown| shown.level);
            let coming = self.in_flight.get(&next).map(|flight| flight.level);
            shown.into_iter().chain(coming)
        });
        allowed(beside)
    }

    /// Takes the next chunk to make, if fewer than `most` are being made.
    pub(crate) fn next_load(&mut self, most: usize) -> Option<Make> {
        if self.in_flight.len() >= most {
            return None;
        }
        while let Some(coord) = self.queue.pop(&*self.strategy) {
            match self.need(coord) {
                Need::Nothing => self.left_out.push(coord),
                Need::Made(make) => return Some(self.begin(make)),
                Need::Later => {
                    self.blocked.insert(coord);
                }
            }
        }
        self.unblock()
    }

    /// Chunks that wait for each other for ever, as beside one that was given up, go on all the
    /// same: better an edge in the picture than land that stays as it is.
    fn unblock(&mut self) -> Option<Make> {
        if !self.in_flight.is_empty() || !self.batch.is_empty() {
            return None;
        }
        let coord = *self.blocked.iter().min()?;
        self.blocked.remove(&coord);
        let level = self.target(coord)?.level;
        let solid = self.wished.bodies.wants(coord);
        Some(self.begin(Make {
            coord,
            level: if solid { Level::FULL } else { level },
            solid,
        }))
    }

    fn begin(&mut self, make: Make) -> Make {
        let Make { coord, level, .. } = make;
        self.in_flight.insert(coord, Flight { least: 0, level });
        make
    }

    /// Takes back a load that could not be handed over.
    pub(crate) fn not_sent(&mut self, coord: ChunkCoord) {
        self.in_flight.remove(&coord);
        self.enqueue(coord);
    }

    /// Judges a load made from `revision`.
    pub(crate) fn loaded(&mut self, make: Make, revision: u64) -> Verdict {
        if revision > self.shown {
            return Verdict::Hold;
        }
        let Make {
            coord,
            level,
            solid,
        } = make;
        let least = self
            .in_flight
            .remove(&coord)
            .map_or(0, |flight| flight.least);
        let verdict = self.judge(make, revision < least);
        match verdict {
            Verdict::Drop => self.left_out.push(coord),
            _ => self.put(coord, Shown { level, solid }),
        }
        self.release(coord);
        verdict
    }

    fn judge(&self, make: Make, outdated: bool) -> Verdict {
        let keeps = self.target(make.coord).is_some() && self.wished.range.keeps(make.coord);
        if !keeps || outdated {
            return Verdict::Drop;
        }
        match self.resident.get(&make.coord) {
            // A body has come meanwhile.
            Some(_) if !make.solid && self.is_solid_ground(make.coord) => Verdict::Drop,
            Some(shown) if shown.level == make.level && make.solid && !shown.solid => {
                Verdict::Harden
            }
            Some(shown) if shown.level == make.level => Verdict::Drop,
            _ => Verdict::Show,
        }
    }

    /// A chunk has ended its flight: it, and what has waited for it, may go on.
    pub(super) fn release(&mut self, coord: ChunkCoord) {
        self.enqueue(coord);
        self.release_beside(coord);
    }

    /// What has waited for a chunk may go on.
    pub(super) fn release_beside(&mut self, coord: ChunkCoord) {
        let strategy = Arc::clone(&self.strategy);
        for next in faces(&*strategy, coord) {
            if self.blocked.contains(&next) {
                self.enqueue(next);
            }
        }
    }

    /// Notes that a chunk cannot be made.
    pub(crate) fn give_up(&mut self, coord: ChunkCoord) {
        self.in_flight.remove(&coord);
        if self.target(coord).is_some() {
            self.given_up.insert(coord);
        }
        self.release(coord);
    }
}
