//! Which halls a world has, and what leads from each to where.

use glam::DVec3;

use super::hall::{Hall, tunnel};
use super::lay::Lay;
use super::stretch::Passage;
use crate::field::Field;
use crate::lattice::stirred;

/// Edge of the squares of open worlds, metres.
const SQUARE_M: f64 = 210.0;
/// Of closed worlds' surface, how much there is for each hall, square metres, and the fewest halls.
const CLOSED_M2: f64 = 12_000.0;
const FEWEST: usize = 3;
/// Tries of a place for a hall of a closed world.
const TRIES: u64 = 12;
/// Halls of closed worlds further from each other have no tunnel, metres.
const FARTHEST_M: f64 = 170.0;
/// Of these parts of all squares there is a hall, of the halls a way up, of the pairs beside each other a tunnel.
const HALLS: f64 = 0.95;
pub(super) const WAYS_UP: f64 = 0.65;
const TUNNELS: f64 = 0.75;
/// Halls of closed worlds nearer than this to one with a way up have none of their own, metres.
const WAYS_APART_M: f64 = 250.0;
/// How far from its hall a way in begins, metres, and no further than that of the radius of closed worlds.
pub(super) const WAY_UP_M: f64 = 52.0;
const WAY_UP_SHARE: f64 = 0.9;

/// Chance by a key, each number another: 0 to 1.
pub(super) fn chance(key: u64, n: u64) -> f64 {
    const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
    (stirred(key ^ n.wrapping_mul(0x2545_f491_4f6c_dd1d)) >> 11) as f64 * UNIT
}

/// The same, -1 to 1.
pub(super) fn either_way(key: u64, n: u64) -> f64 {
    2.0 * chance(key, n) - 1.0
}

/// The square that a place of an open world lies in.
pub(super) fn square_of(place: DVec3) -> [i64; 2] {
    [place.x, place.z].map(|c| (c / SQUARE_M).floor() as i64)
}

/// The caves of an open world.
pub(super) struct Open<'a> {
    pub seed: u64,
    pub field: &'a Field,
}

impl Open<'_> {
    fn key(&self, i: i64, k: i64) -> u64 {
        stirred(stirred(self.seed ^ i.cast_unsigned()) ^ k.cast_unsigned())
    }

    /// Where in a square a hall lies, if there is one.
    fn place(&self, i: i64, k: i64) -> Option<(u64, DVec3)> {
        let key = self.key(i, k);
        let at = |n, square: i64| (square as f64 + 0.5 + 0.32 * either_way(key, n)) * SQUARE_M;
        let place = DVec3::new(at(1, i), 0.0, at(2, k));
        (chance(key, 0) < HALLS).then_some((key, place))
    }

    /// What comes into a square. What belongs to one leaves that and the next by less than a square.
    pub(super) fn within(&self, [i, k]: [i64; 2]) -> Vec<Passage> {
        let near = (-1..=1).flat_map(|di| (-1..=1).map(move |dk| [i + di, k + dk]));
        let mut found: Vec<_> = near.flat_map(|square| self.passages(square)).collect();
        found.retain(|passage| {
            let [low, high] = [passage.bounds.low, passage.bounds.high].map(square_of);
            (low[0]..=high[0]).contains(&i) && (low[1]..=high[1]).contains(&k)
        });
        found
    }

    /// What belongs to a square: its hall, the way up from there, and tunnels to the next two squares' halls.
    pub(super) fn passages(&self, [i, k]: [i64; 2]) -> Vec<Passage> {
        let field = &Lay::of_world(self.field);
        let hall = |i, k| {
            let (key, place) = self.place(i, k)?;
            Hall::new(field, key, place)
        };
        let Some(here) = hall(i, k) else {
            return Vec::new();
        };
        let mut found = vec![here.hollow(field)];
        if chance(here.key, 7) < WAYS_UP {
            found.push(here.way_up(field, WAY_UP_M));
        }
        for (n, (di, dk)) in [(1, 0), (0, 1)].into_iter().enumerate() {
            if chance(here.key, 10 + n as u64) < TUNNELS
                && let Some(other) = hall(i + di, k + dk)
            {
                found.push(tunnel(field, here.key ^ n as u64, [here, other]));
            }
        }
        found
    }
}

/// All caves of a closed world.
pub(super) fn closed(seed: u64, field: &Field, radius_m: f64) -> Vec<Passage> {
    let count = (4.0 * std::f64::consts::PI * radius_m * radius_m / CLOSED_M2).round() as usize;
    let field = &Lay::of_world(field);
    let mut halls: Vec<Hall> = Vec::new();
    for n in 0..count.max(FEWEST) as u64 {
        let key = stirred(seed ^ n);
        let tries = (0..TRIES).map(|n| direction(stirred(key ^ n)) * radius_m);
        let nearest = |hall: &Hall| {
            let far = halls
                .iter()
                .map(|it| it.ground.distance_squared(hall.ground));
            far.fold(f64::INFINITY, f64::min)
        };
        let fitting = tries.filter_map(|place| Hall::new(field, key, place));
        halls.extend(fitting.max_by(|a, b| nearest(a).total_cmp(&nearest(b))));
    }
    let mut found = Vec::new();
    let mut ways: Vec<DVec3> = Vec::new();
    for (n, hall) in halls.iter().enumerate() {
        found.push(hall.hollow(field));
        if ways
            .iter()
            .all(|other| other.distance(hall.ground) >= WAYS_APART_M)
        {
            ways.push(hall.ground);
            found.push(hall.way_up(field, WAY_UP_M.min(WAY_UP_SHARE * radius_m)));
        }
        let far = |other: &&Hall| other.ground.distance(hall.ground);
        let mut others: Vec<&Hall> = halls.iter().skip(n + 1).collect();
        others.retain(|other| far(other) < FARTHEST_M);
        others.sort_by(|a, b| far(a).total_cmp(&far(b)));
        for (other, n) in others.into_iter().take(2).zip(0..) {
            if chance(hall.key, 10 + n) < TUNNELS {
                found.push(tunnel(field, hall.key ^ n, [*hall, *other]));
            }
        }
    }
    found
}

/// A unit vector by a key, all as likely: a place in the ball, as long as it is not near the middle.
pub(super) fn direction(key: u64) -> DVec3 {
    let at = |n: u64| DVec3::from([0, 1, 2].map(|axis| either_way(key, 3 * n + axis)));
    let tries = (0..16).map(at);
    let mut within = tries.filter(|at| (0.01..1.0).contains(&at.length_squared()));
    within.next().unwrap_or(DVec3::Y).normalize()
}
