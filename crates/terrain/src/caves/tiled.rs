//! The caves of worlds in tiles: those of a tile are laid out in its own patch, and asked for from those about it.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::hall::{Hall, tunnel};
use super::lay::Lay;
use super::layout::{WAY_UP_M, WAYS_UP, chance, either_way};
use super::stretch::{Bounds, Passage, Stretch};
use crate::field::Field;
use crate::lattice::stirred;
use crate::tracts::{Memo, Tract, Tracts};

/// So much land has one hall, but no more and no fewer of all tiles than these, square metres.
const HALL_M2: f64 = 13_000.0;
const FEWEST: f64 = 0.12;
const MOST: f64 = 0.95;
/// Area of a tile, square radii.
const TILE_AREA: f64 = 0.4 * std::f64::consts::PI;
/// Of the pairs of halls in tiles beside each other there is a tunnel.
const TUNNELS: f64 = 0.75;
/// How far from the middle of a tile its hall lies at most along an axis, and how far from the hall a way in begins at most,
/// radii: what belongs to a tile comes near to none that is more than two steps away.
const ASIDE: f64 = 0.25;
const WAY_UP: f64 = 0.6;
/// A circle's chord is so many times its square over the radius from the arc.
const BOW: f64 = 0.125;

/// What is known of tiles.
#[derive(Debug, Default)]
pub(super) struct Tiled {
    seed: u64,
    known: Memo<u64, [Passage]>,
}

/// The caves of one tile that come near something: the place of the tile among those about the one asked.
#[derive(Debug)]
pub(crate) struct Den {
    pub place: usize,
    pub stretches: Vec<Stretch>,
}

impl Tiled {
    pub(super) fn new(seed: u64) -> Self {
        Self {
            seed,
            known: Memo::default(),
        }
    }

    /// The caves that come within `reach_m` metres of a box of places of a tile, by X/W and Z/W of its corners, and its heights.
    pub(super) fn near(
        &self,
        field: &Field,
        (tract, corners): (&Tract, &[DVec2]),
        heights_m: [f64; 2],
        reach_m: f64,
    ) -> Vec<Den> {
        let Some(tracts) = field.tracts() else {
            return Vec::new();
        };
        let mut dens = Vec::new();
        for place in 0..tract.count() {
            let key = tract.key(place).filter(|key| self.has_hall(tract, *key));
            let Some(key) = key else {
                continue;
            };
            let grounds = corners.iter().filter_map(|at| tract.ground(*at, place));
            let (low, high) = grounds.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |all, at| {
                (all.0.min(at), all.1.max(at))
            });
            // Between two corners a straight way bows out by no more than on a circle of the radius.
            let bow_m = BOW * (high - low).length_squared() / tract.noise.radius_m;
            let aside = DVec3::new(1.0, 0.0, 1.0) * (bow_m + reach_m);
            let wanted = Bounds {
                low: low - aside + DVec3::Y * (heights_m[0] - reach_m),
                high: high + aside + DVec3::Y * (heights_m[1] + reach_m),
            };
            let passages = self.passages(field, tracts, tract, (place, key));
            let met = passages.iter().filter(|it| it.bounds.meets(&wanted));
            let stretches = met.flat_map(|it| &it.stretches);
            let stretches = stretches.filter(|it| it.bounds(0.0).meets(&wanted));
            let stretches: Vec<_> = stretches.copied().collect();
            if !stretches.is_empty() {
                dens.push(Den { place, stretches });
            }
        }
        dens
    }

    /// Whether a tile has a hall, by its key.
    fn has_hall(&self, tract: &Tract, key: u64) -> bool {
        let area_m2 = TILE_AREA * tract.noise.radius_m.powi(2);
        let share = (area_m2 / HALL_M2).clamp(FEWEST, MOST);
        chance(stirred(key ^ self.seed), 0) < share
    }

    /// What belongs to a tile about one: its hall, the way up from there, and tunnels to the halls of those beside it which come
    /// after it.
    fn passages(
        &self,
        field: &Field,
        tracts: &Tracts,
        asked: &Tract,
        (place, key): (usize, u64),
    ) -> Arc<[Passage]> {
        let made = || {
            let space = &**field.strategy();
            let chart = asked.noise.charts.get(place).copied().flatten()?;
            let tract = tracts.tract(space, chart)?;
            Some(self.laid_out(field, tracts, &tract).into())
        };
        self.known.value(key, made).unwrap_or_else(|| Arc::new([]))
    }

    fn laid_out(&self, field: &Field, tracts: &Tracts, tract: &Arc<Tract>) -> Vec<Passage> {
        let Some(hall) = self.hall(field, tract) else {
            return Vec::new();
        };
        let lay = Lay::of_tile(field, tract);
        let way_up_m = WAY_UP_M.min(WAY_UP * tract.noise.radius_m);
        let mut found = vec![hall.hollow(&lay)];
        if chance(hall.key, 7) < WAYS_UP {
            found.push(hall.way_up(&lay, way_up_m));
        }
        let own = tract.key(0).unwrap_or(0);
        for over in tract.noise.quilt.over_sides().into_iter().flatten() {
            let Some(key) = tract.key(over).filter(|key| *key > own) else {
                continue;
            };
            let both = stirred(hall.key ^ key);
            if !self.has_hall(tract, key) || chance(both, 10) >= TUNNELS {
                continue;
            }
            let chart = tract.noise.charts.get(over).copied().flatten();
            let space = &**field.strategy();
            let Some(other) = chart.and_then(|chart| tracts.tract(space, chart)) else {
                continue;
            };
            let there = self.hall(field, &other).and_then(|there| {
                let at = other.taken(there.ground);
                Some(there.moved(other.grounds_of(at, own)?))
            });
            if let Some(there) = there {
                found.push(tunnel(&lay, both, [hall, there]));
            }
        }
        found
    }

    /// The hall of a tile.
    fn hall(&self, field: &Field, tract: &Arc<Tract>) -> Option<Hall> {
        let key = stirred(tract.key(0)? ^ self.seed);
        let aside = |n| ASIDE * tract.noise.radius_m * either_way(key, n);
        let ground = tract.centre() + DVec3::new(aside(1), 0.0, aside(2));
        Hall::new(&Lay::of_tile(field, tract), key, ground)
    }
}
