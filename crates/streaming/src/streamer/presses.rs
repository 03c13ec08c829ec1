//! Presses of the brush: where the last of them have changed the land, and how they are undone.

use std::collections::BTreeSet;

use antipode_geometry::{CHUNK_CELLS, ChunkCoord};
use antipode_terrain::Stroke;
use glam::Vec3Swizzles;

use super::Streamer;
use crate::api::{NotUndone, Update};
use crate::history::MOST_PRESSES;
use crate::outcome::Edited;

/// Where a press has changed the land.
pub(super) struct Pressed {
    pub(super) number: u64,
    /// Chunks that own a changed sample.
    touched: BTreeSet<ChunkCoord>,
    /// Chunks that look different for it.
    pub(super) remeshed: BTreeSet<ChunkCoord>,
}

impl Streamer {
    /// As [`edit`](Self::edit), of a press: [`Update::Moved`] tells what it has moved, and it can be undone. Numbers of
    /// presses rise.
    pub fn edit_in(&mut self, press: Option<u64>, stroke: Stroke) {
        self.strokes.add(stroke, press);
        self.saves.stale |= !self.strokes.is_empty();
        self.feed();
    }

    /// Undoes the last press that has changed anything, after every stroke made so far; [`Update::Undone`] tells the end.
    pub fn undo(&mut self) {
        self.strokes.undo();
        self.saves.stale = true;
        self.feed();
    }

    /// The press that would be undone.
    pub(super) fn last_press(&self) -> Result<&Pressed, NotUndone> {
        let last = self.presses.back().ok_or(NotUndone::NoneLeft)?;
        // What lies past its chart's edge is the next chart's land, and wanted there.
        let is_land = |coord: &ChunkCoord| {
            let domain = self.strategy.domain(coord.chart);
            let low = coord.origin().xz();
            domain.least_outside_m(low, low + f64::from(CHUNK_CELLS)) < 0.0
        };
        let mut touched = last.touched.iter().filter(|coord| is_land(coord));
        if touched.all(|coord| self.scheduler.is_wanted(*coord)) {
            Ok(last)
        } else {
            Err(NotUndone::Away)
        }
    }

    /// Notes where a press has changed the land, or that it is undone, and tells what it moved.
    pub(super) fn take_press(&mut self, edited: &Edited, updates: &mut Vec<Update>) {
        if let Some((press, earth)) = edited.moved {
            if !edited.touched.is_empty() {
                if self.presses.back().is_none_or(|last| last.number != press) {
                    self.presses.push_back(Pressed {
                        number: press,
                        touched: BTreeSet::new(),
                        remeshed: BTreeSet::new(),
                    });
                }
                if let Some(last) = self.presses.back_mut() {
                    last.touched.extend(&edited.touched);
                    last.remeshed.extend(&edited.remeshed);
                }
            }
            if self.presses.len() > MOST_PRESSES {
                self.presses.pop_front();
            }
            if !earth.is_nothing() {
                updates.push(Update::Moved {
                    press,
                    earth,
                    gathered: edited.gathered,
                });
            }
        }
        if let Some((press, end)) = edited.undone {
            if !matches!(end, Err(NotUndone::Unreadable | NotUndone::Spent)) {
                self.presses.retain(|it| it.number != press);
            }
            updates.push(Update::Undone(end));
        }
    }
}
