//! Where caves run: halls, the tunnels between them, and the ways in.
//!
//! An open world has a hall in most squares of [`SQUARE_M`], a closed one as many as its size asks for, as far from each other
//! as tries find. From hall to hall run tunnels, and from most a way leads up to the surface where that lies lowest about.
//! All follow the land above: how high that is, is worked out from its noise. So where caves are is a pure function of seed
//! and place, and which can reach into a box is known before any of them is laid out.
//!
//! Places are those of noise space; the height of a place is that of its column in the chart.

mod hall;
mod lay;
mod layout;
mod over_ground;
mod stretch;
#[cfg(test)]
#[expect(clippy::expect_used, reason = "tests fail by panicking")]
mod tests;
mod tiled;

use std::collections::HashMap;
use std::sync::{Arc, RwLock};

use glam::{DVec2, DVec3};

use crate::field::Field;
use crate::lattice::stirred;
use crate::tracts::Tract;
use layout::{Open, square_of};
use stretch::Passage;
pub(crate) use stretch::{Bounds, STRAY_M, Stretch};
pub(crate) use tiled::Den;
use tiled::Tiled;

/// Open worlds have no caves beyond this, metres: nobody comes there, and squares have their numbers.
const FARTHEST: DVec3 = DVec3::splat(1e9);
/// Caves are by other numbers than the land and its climates.
const OTHER_SEED: u64 = 0x6361_7665_7300;
/// Squares that are remembered: those of some kilometres about.
const REMEMBERED: usize = 400;

/// The caves of a world.
#[derive(Debug)]
pub(crate) struct Caves {
    seed: u64,
    /// All of a closed world's.
    closed: Option<Vec<Passage>>,
    /// Of an open one's those that come into squares which somebody has asked for. Nobody waits for it: who finds it taken
    /// lays them out himself.
    squares: RwLock<HashMap<[i64; 2], Arc<[Passage]>>>,
    /// Of worlds in tiles.
    tiled: Tiled,
}

impl Caves {
    /// Those of a world whose land this is.
    pub(crate) fn new(seed: u64, field: &Field) -> Self {
        let seed = stirred(seed ^ OTHER_SEED);
        Self {
            seed,
            closed: field
                .closed_radius_m()
                .map(|radius_m| layout::closed(seed, field, radius_m)),
            squares: RwLock::default(),
            tiled: Tiled::new(seed),
        }
    }

    /// In a world in tiles, the caves that come within `reach_m` metres of a box of places of a tile, by X/W and Z/W of its
    /// corners, and its heights.
    pub(crate) fn dens(
        &self,
        field: &Field,
        corners: (&Tract, &[DVec2]),
        heights_m: [f64; 2],
        reach_m: f64,
    ) -> Vec<Den> {
        self.tiled.near(field, corners, heights_m, reach_m)
    }

    /// Calls `take` with each stretch that comes within `reach_m` of a box.
    pub(crate) fn near(
        &self,
        field: &Field,
        bounds: &Bounds,
        reach_m: f64,
        mut take: impl FnMut(&Stretch),
    ) {
        let wanted = bounds.widened(reach_m);
        let mut taken = |passages: &[Passage]| {
            for passage in passages.iter().filter(|it| it.bounds.meets(&wanted)) {
                let near = passage.stretches.iter();
                near.filter(|it| it.bounds(0.0).meets(&wanted))
                    .for_each(&mut take);
            }
        };
        if let Some(all) = &self.closed {
            return taken(all);
        }
        let is_far = wanted.low.abs().max(wanted.high.abs()).cmpge(FARTHEST);
        if is_far.any() || wanted.low.is_nan() || wanted.high.is_nan() {
            return;
        }
        let [first, last] = [wanted.low, wanted.high].map(square_of);
        for i in first[0]..=last[0] {
            for k in first[1]..=last[1] {
                taken(&self.within(field, [i, k]));
            }
        }
    }

    /// What comes into a square of an open world.
    fn within(&self, field: &Field, square: [i64; 2]) -> Arc<[Passage]> {
        if let Ok(known) = self.squares.try_read()
            && let Some(passages) = known.get(&square)
        {
            return passages.clone();
        }
        let seed = self.seed;
        let passages: Arc<[Passage]> = Open { seed, field }.within(square).into();
        if let Ok(mut known) = self.squares.try_write() {
            if known.len() >= REMEMBERED {
                known.clear();
            }
            known.insert(square, passages.clone());
        }
        passages
    }
}
