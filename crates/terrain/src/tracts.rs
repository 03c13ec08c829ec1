//! Noise of worlds that have no centre: in tiles, each of which knows only those about it.
//!
//! What is finer than a tile is the noise of all worlds, found in each patch that a place lies in ([`Quilt`]) as if that lay
//! somewhere else in the space of the noise: where, the patch's number and the seed say. The sum of all by their weights, over the root
//! of the sum of the squared weights, has the variance of one everywhere. What is broader than a tile is made of random
//! numbers of the tiles about ([`broad`]).
//!
//! [`Quilt`]: antipode_geometry::tiling::quilt::Quilt

mod broad;
pub(crate) mod fill;

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, OnceLock, RwLock};

use antipode_geometry::tiling::quilt::{MOST_PATCHES, Owner, Patch, tangents_in_patch};
use antipode_geometry::{Atlas, ChartId, NoiseQuilt};
use glam::{DVec2, DVec3, Vec4};

use crate::lattice::stirred;
use broad::{Broad, Fit};

/// Patches lie within so much of the space of the noise along each axis, metres: whole turns of the lattice of the longest waves.
const SPREAD_M: f64 = 65_536.0;
/// Tiles that are remembered: far more than come into a view.
const REMEMBERED: usize = 4096;
/// From chart to chart the tile of a place is found in so few steps.
const MOST_STEPS: usize = 8;

/// The noise of a world in tiles.
#[derive(Debug)]
pub(crate) struct Tracts {
    seed: u64,
    /// Of the broad noise.
    broad_seed: u64,
    /// How many octaves, the longest first, are broader than tiles.
    wide: usize,
    radius_m: f64,
    fit: Arc<Fit>,
    known: Memo<ChartId, Tract>,
    broads: Memo<u64, Broad>,
}

/// What a tile knows of its noise and of that about it.
#[derive(Debug)]
pub(crate) struct Tract {
    pub noise: NoiseQuilt,
    patches: Vec<Lot>,
    /// Whether more octaves than the longest are broader than tiles.
    more: bool,
    /// Where in the space of the noise the patches of all tiles about it lie, in the order of the quilt.
    corners_m: Vec<DVec2>,
}

/// A patch in the space of the noise, and its broad noise.
#[derive(Debug)]
struct Lot {
    corner_m: DVec2,
    broad: Arc<Broad>,
}

/// Where the noise of a column of ground is found.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot {
    count: usize,
    /// Which of the tile's patches, where in the space of the noise, x and z in metres, and the share.
    lots: [(usize, DVec2, f32); MOST_PATCHES],
    /// Of variance 1: heat, humidity, how high land lies and the longest octave, where it is broader than tiles; then the other
    /// octaves that are.
    broad: [Vec4; 2],
}

impl Spot {
    pub(crate) const NOWHERE: Self = Self {
        count: 0,
        lots: [(0, DVec2::ZERO, 0.0); MOST_PATCHES],
        broad: [Vec4::ZERO; 2],
    };

    /// Each patch: its number in the tile, the place, and its share; the squares of the shares add up to 1.
    #[inline]
    pub(crate) fn lots(&self) -> &[(usize, DVec2, f32)] {
        &self.lots[..self.count]
    }

    /// Heat, humidity and how high land lies, of variance 1, and nothing.
    #[inline]
    pub(crate) fn climate(&self) -> Vec4 {
        self.broad[0].with_w(0.0)
    }

    /// The octaves that are broader than tiles, of variance 1, the longest first.
    #[inline]
    pub(crate) fn octaves(&self) -> [f32; 4] {
        let [first, rest] = self.broad;
        [first.w, rest.x, rest.y, rest.z]
    }

    /// Noise about zero at a height, given that at a point of the space of the noise.
    #[inline]
    pub(crate) fn blended(&self, y: f64, mut noise: impl FnMut(DVec3) -> f32) -> f32 {
        let lots = self.lots().iter();
        lots.map(|(_, at, share)| share * noise(DVec3::new(at.x, y, at.y)))
            .sum()
    }
}

/// The tracts of other tiles that columns beside each other belong to: a handful, asked for over and over.
#[derive(Debug, Default)]
pub(crate) struct Met(Vec<(ChartId, Arc<Tract>)>);

impl Met {
    fn tract(&mut self, tracts: &Tracts, space: &dyn Atlas, chart: ChartId) -> Option<Arc<Tract>> {
        if let Some((_, known)) = self.0.iter().find(|(of, _)| *of == chart) {
            return Some(known.clone());
        }
        let tract = tracts.tract(space, chart)?;
        self.0.push((chart, tract.clone()));
        Some(tract)
    }
}

impl Tracts {
    /// Those of a space that is in tiles.
    pub(crate) fn new(seed: u64, broad_seed: u64, space: &dyn Atlas) -> Option<Self> {
        let noise = space.quilt(ChartId::FIRST)?;
        Some(Self {
            seed: stirred(seed),
            broad_seed,
            wide: broad::wide_octaves(noise.radius_m),
            radius_m: noise.radius_m,
            fit: Fit::shared(),
            known: Memo::default(),
            broads: Memo::default(),
        })
    }

    /// The world's radius, metres.
    pub(crate) fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// How many octaves of biomes by climate are in [`Spot::broad`], the longest first.
    pub(crate) fn wide(&self) -> usize {
        self.wide
    }

    /// The tract of a chart's tile; none where there is no such chart.
    pub(crate) fn tract(&self, space: &dyn Atlas, chart: ChartId) -> Option<Arc<Tract>> {
        self.known.value(chart, || {
            let noise = space.quilt(chart)?;
            let corners_m = noise
                .quilt
                .around()
                .iter()
                .map(|it| self.corner_m(it.key()));
            let lot = |patch: &Patch| Lot {
                corner_m: self.corner_m(patch.key()),
                broad: self.broad(patch),
            };
            let patches = noise.quilt.patches().iter().map(lot).collect();
            Some(Arc::new(Tract {
                corners_m: corners_m.collect(),
                more: self.wide > 1,
                patches,
                noise,
            }))
        })
    }

    fn broad(&self, patch: &Patch) -> Arc<Broad> {
        let new = || Arc::new(Broad::new(&self.fit, patch, self.broad_seed, self.wide));
        let broad = self.broads.value(patch.key(), || Some(new()));
        broad.unwrap_or_else(new)
    }

    /// Where a tile's patch lies in the space of the noise.
    pub(crate) fn corner_m(&self, key: u64) -> DVec2 {
        const UNIT: f64 = SPREAD_M / (1_u64 << 32) as f64;
        let at = stirred(key ^ self.seed);
        DVec2::new((at >> 32) as f64, (at & 0xffff_ffff) as f64) * UNIT
    }

    /// The spot at x and z of a chart.
    pub(crate) fn spot(&self, space: &dyn Atlas, chart: ChartId, [x, z]: [f64; 2]) -> Spot {
        let Some(tract) = self.tract(space, chart) else {
            return Spot::NOWHERE;
        };
        let at = DVec2::new(tract.noise.tangent(x), tract.noise.tangent(z));
        self.spot_in(space, &tract, tract.noise.written(at), &mut Met::default())
    }

    /// The spot of a place of a tile, or near it, by X/W and Z/W there.
    pub(crate) fn spot_in(
        &self,
        space: &dyn Atlas,
        tract: &Tract,
        at: DVec2,
        met: &mut Met,
    ) -> Spot {
        let (other, at) = self.owner(space, tract, at, met);
        other.as_deref().unwrap_or(tract).spot(at)
    }

    /// The tract that a place belongs to, if that is another, and X/W and Z/W of it there.
    pub(crate) fn owner(
        &self,
        space: &dyn Atlas,
        tract: &Tract,
        mut at: DVec2,
        met: &mut Met,
    ) -> (Option<Arc<Tract>>, DVec2) {
        let mut other: Option<Arc<Tract>> = None;
        for _ in 0..MOST_STEPS {
            let here = other.as_deref().unwrap_or(tract);
            let (over, there) = match here.noise.quilt.owner(at) {
                Owner::This(there) => return (other, there),
                Owner::Other(over, there) => (over, there),
            };
            let chart = here.noise.charts.get(over).copied().flatten();
            let Some(next) = chart.and_then(|chart| met.tract(self, space, chart)) else {
                return (other, at);
            };
            (other, at) = (Some(next), there);
        }
        (other, at)
    }
}

impl Tract {
    /// The key of a tile about it, its own first.
    pub(crate) fn key(&self, place: usize) -> Option<u64> {
        Some(self.noise.quilt.around().get(place)?.key())
    }

    /// Of a place by X/W and Z/W, the one that the patch of a tile about it has, by that tile's key and its tract.
    pub(crate) fn grounds_of(&self, at: DVec2, key: u64) -> Option<DVec3> {
        let place = self
            .noise
            .quilt
            .around()
            .iter()
            .position(|it| it.key() == key)?;
        self.ground(at, place)
    }

    /// The place on the ground of the space of the noise that the patch of a tile about it has for a place of this one, by X/W
    /// and Z/W; the tile's own is the first.
    pub(crate) fn ground(&self, at: DVec2, place: usize) -> Option<DVec3> {
        let patch = self.noise.quilt.around().get(place)?;
        let at = self.corners_m.get(place)? + patch.place(at) * self.noise.radius_m;
        Some(DVec3::new(at.x, 0.0, at.y))
    }

    /// How many tiles it knows about it, with itself.
    pub(crate) fn count(&self) -> usize {
        self.corners_m.len()
    }

    /// X/W of columns so far apart along x, or Z/W along z, metres.
    pub(crate) fn tangents(&self, first_m: f64, step_m: f64, count: usize) -> Vec<f64> {
        let at = |n: usize| self.noise.tangent(first_m + n as f64 * step_m);
        (0..count).map(at).collect()
    }

    /// X/W and Z/W in the tile of a place on the ground of the space of the noise that its own patch has.
    pub(crate) fn taken(&self, ground: DVec3) -> DVec2 {
        let corner_m = self.corners_m.first().copied().unwrap_or(DVec2::ZERO);
        tangents_in_patch((DVec2::new(ground.x, ground.z) - corner_m) / self.noise.radius_m)
    }

    /// Where in the space of the noise the centre of the tile's patch lies.
    pub(crate) fn centre(&self) -> DVec3 {
        let corner_m = self.corners_m.first().copied().unwrap_or(DVec2::ZERO);
        DVec3::new(corner_m.x, 0.0, corner_m.y)
    }

    /// The spot of a place of the tile.
    fn spot(&self, at: DVec2) -> Spot {
        let radius_m = self.noise.radius_m;
        let mut spot = Spot::NOWHERE;
        let (mut sum, mut squares) = (0.0, 0.0);
        let mut weights = [0.0; MOST_PATCHES];
        self.noise.quilt.each(at, |n, place, weight| {
            let Some(lot) = self.patches.get(n) else {
                return;
            };
            if spot.count < MOST_PATCHES {
                spot.lots[spot.count] = (n, lot.corner_m + place * radius_m, 0.0);
                weights[spot.count] = weight;
                spot.count += 1;
                sum += weight;
                squares += weight * weight;
                lot.broad
                    .add(place, weight as f32, self.more, &mut spot.broad);
            }
        });
        if spot.count > 0 {
            let per = squares.sqrt().recip();
            for (lot, weight) in spot.lots.iter_mut().zip(weights) {
                lot.2 = (weight * per) as f32;
            }
            let whole = (1.0 / sum) as f32;
            spot.broad = spot.broad.map(|broad| broad * whole);
        }
        spot
    }

    /// [`Spot::climate`] in the middle of the tile and of those about it.
    pub(crate) fn middles(&self) -> impl Iterator<Item = Vec4> {
        let middles = self.patches.iter().map(|lot| lot.broad.middle()[0]);
        middles.map(|middle| middle.with_w(0.0))
    }
}

/// Values that are worked out once. Nobody waits for it: who finds it taken works a value out himself.
#[derive(Debug)]
pub(crate) struct Memo<K, V: ?Sized> {
    known: RwLock<HashMap<K, Arc<V>>>,
}

impl<K, V: ?Sized> Default for Memo<K, V> {
    fn default() -> Self {
        Self {
            known: RwLock::default(),
        }
    }
}

impl<K: Copy + Eq + Hash, V: ?Sized> Memo<K, V> {
    pub(crate) fn value(&self, key: K, make: impl FnOnce() -> Option<Arc<V>>) -> Option<Arc<V>> {
        if let Ok(known) = self.known.try_read()
            && let Some(value) = known.get(&key)
        {
            return Some(value.clone());
        }
        let value = make()?;
        if let Ok(mut known) = self.known.try_write() {
            if known.len() >= REMEMBERED {
                known.clear();
            }
            known.insert(key, value.clone());
        }
        Some(value)
    }
}

/// A value of the whole program.
type Once<T> = OnceLock<Arc<T>>;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests fail by panicking")]
mod pictures;
#[cfg(test)]
#[expect(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
mod tests;
