//! The published tests of loops, far tiles and pairs, for any representation, each from a seed.
//!
//! [`Keeping`] says what is kept between moves: coordinates alone, as the published tests have
//! it, or the tile by name and coordinates only within it, which is the camera-relative rule.

use std::f64::consts::PI;

use super::model::{Model, Moves, Pose, Spot};
use super::number::Number;
use super::outcome::{Outcome, within};
use super::reference::{self, Pair, PolarCoords};
use super::tiling::{Tile, Tiling};
use super::wander;
use crate::random::Numbers;

/// The farthest loop, in tiles.
pub const LOOP_LIMIT: u32 = 99;
/// The farthest tile or circle, in tiles or radii.
pub const FAR_LIMIT: u32 = 999;
/// The widest room for coming and going, in tiles.
pub const CLOSE_LIMIT: u32 = 20;
/// Moves from tile to tile in which a point that comes and goes may get lost.
pub const CLOSE_MOVES: u32 = 1000;
/// How far from its tile's centre that point starts, in radii.
const OFFSET: f64 = 1.0 / 8.0;

/// What is kept of where something is while the frame it is seen from moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeping {
    /// Its coordinates in that frame, changed at every move.
    Coordinates,
    /// The tile it is on, and coordinates within that tile, which no move changes. What is seen
    /// is worked out from a shortest path of tiles.
    Tiles,
}

impl Keeping {
    /// The tiles to multiply along, for something that took `path`.
    fn path(self, tiling: &mut Tiling, path: Vec<Tile>) -> Vec<Tile> {
        match (self, path.as_slice()) {
            (Self::Tiles, [first, .., last]) => tiling.path(*first, *last),
            _ => path,
        }
    }
}

/// The distances at which a tile's place is looked at: closely at first, a fifth farther each
/// time later.
fn far_distances() -> impl Iterator<Item = u32> {
    std::iter::successors(Some(1), |i| Some(i + 1 + i / 5)).take_while(|&i| i <= FAR_LIMIT)
}

/// The difference of two angles, within half a turn either way.
fn turned(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference - 2.0 * PI * (difference / (2.0 * PI)).round()
}

/// Whether distance and angle are those of a place.
pub fn agrees<N: Number>(distance: N, angle: N, place: PolarCoords, tolerance: f64) -> bool {
    within(distance.get() - place.distance, tolerance)
        && within(turned(angle.get(), place.angle), tolerance)
}

/// How far from the origin the image of the origin is after an isometry was carried round a loop
/// that reaches `distance` tiles, in radii.
pub fn loop_error<M: Model>(
    keeping: Keeping,
    numbers: &mut Numbers,
    tiling: &mut Tiling,
    distance: u32,
) -> f64 {
    let path = wander::loop_path(numbers, tiling, distance);
    let path = keeping.path(tiling, path);
    let pose = Moves::<M>::new()
        .along(tiling, &path, Pose(M::identity()))
        .0;
    M::distance(&M::apply(&pose, &M::origin())).get()
}

/// An isometry carried round a loop.
pub fn loop_iso<M: Model>(keeping: Keeping, seed: u64, tolerance: f64) -> Outcome {
    let (mut numbers, mut tiling) = (Numbers::new(seed), Tiling::new());
    Outcome::first(0..=LOOP_LIMIT, |distance| {
        let error = loop_error::<M>(keeping, &mut numbers, &mut tiling, distance);
        within(error, tolerance)
    })
}

/// A point carried round a loop.
pub fn loop_any<M: Model>(keeping: Keeping, seed: u64, tolerance: f64) -> Outcome {
    let (mut numbers, mut tiling) = (Numbers::new(seed), Tiling::new());
    let moves = Moves::<M>::new();
    Outcome::first(0..=LOOP_LIMIT, |distance| {
        let path = wander::loop_path(&mut numbers, &mut tiling, distance);
        let path = keeping.path(&mut tiling, path);
        let point = moves.along(&mut tiling, &path, Spot(M::origin())).0;
        within(M::distance(&point).get(), tolerance)
    })
}

/// Distance and direction of the centre of a far tile, at the end of a random path.
pub fn angledist<M: Model>(keeping: Keeping, seed: u64, tolerance: f64) -> Outcome {
    let moves = Moves::<M>::new();
    places(seed, |tiling, path, place| {
        let path = keeping.path(tiling, path);
        let point = moves.along(tiling, &path, Spot(M::origin())).0;
        agrees(M::distance(&point), M::angle(&point), place, tolerance)
    })
}

/// The first distance at which `passes` finds a far tile's place wrong, given a random path to
/// it and where it is.
pub fn places(
    seed: u64,
    mut passes: impl FnMut(&mut Tiling, Vec<Tile>, PolarCoords) -> bool,
) -> Outcome {
    let (mut numbers, mut tiling) = (Numbers::new(seed), Tiling::new());
    Outcome::first(far_distances(), |distance| {
        let path = wander::outwards(&mut numbers, &mut tiling, distance);
        let place = reference::place(&mut tiling, path[path.len() - 1]);
        passes(&mut tiling, path, place)
    })
}

/// The angle between the points of a pair, in the precision at hand.
pub fn pair_angle<N: Number>(pair: Pair, r: u32) -> N {
    let small = (-N::of(f64::from(r))).exp();
    match pair {
        Pair::Similar => small,
        Pair::Opposite => small + N::of(PI),
    }
}

/// The first circle on which `distance` finds the distance of a pair wrong, given the direction
/// of its first point in radians and the circle's radius.
pub fn pairs<N: Number>(
    pair: Pair,
    seed: u64,
    tolerance: f64,
    distance: impl Fn(N, u32) -> N,
) -> Outcome {
    let mut numbers = Numbers::new(seed);
    Outcome::first(1..=FAR_LIMIT, |r| {
        let direction = N::of(numbers.between(0.0, 2.0 * PI));
        let exact = reference::pair_distance(pair, f64::from(r));
        within(distance(direction, r).get() - exact, tolerance)
    })
}

/// The distance of two points on a circle about the origin, in a random direction.
pub fn pair<M: Model>(pair: Pair, seed: u64, tolerance: f64) -> Outcome {
    pairs(pair, seed, tolerance, |direction, r| {
        let turn = M::spin(direction);
        let out = M::push(M::N::of(f64::from(r)));
        let second = M::compose(&M::spin(pair_angle(pair, r)), &out);
        let first = M::apply(&M::compose(&turn, &out), &M::origin());
        let second = M::apply(&M::compose(&turn, &second), &M::origin());
        M::distance(&M::apply(&M::inverse(&M::push_to(&first)), &second))
    })
}

/// Whether a point beside the centre of the first tile is still there each time the frame it is
/// seen from comes home, going out to `room` tiles and home over and over.
fn found_again<M: Model>(keeping: Keeping, room: u32, seed: u64, tolerance: f64) -> bool {
    let (mut numbers, mut tiling) = (Numbers::new(seed), Tiling::new());
    let moves = Moves::<M>::new();
    let start = M::apply(&M::push(M::N::of(OFFSET)), &M::origin());
    let (distance, angle) = (OFFSET, 0.0);
    let home = PolarCoords { distance, angle };
    let (mut point, mut tile) = (Spot(start), Tiling::FIRST);
    let (mut homewards, mut moved) = (false, 0);
    while moved < CLOSE_MOVES {
        let edge = wander::any_edge(&mut numbers);
        let (to, back) = tiling.neighbour(tile, edge);
        let distance = tiling.distance(to);
        if homewards && distance >= tiling.distance(tile) {
            continue;
        }
        homewards = (homewards || distance == room) && distance > 0;
        if keeping == Keeping::Coordinates {
            point = moves.cross(back, edge, &point);
        }
        tile = to;
        moved += 1;
        let seen = (M::distance(&point.0), M::angle(&point.0));
        if tile == Tiling::FIRST && !agrees(seen.0, seen.1, home, tolerance) {
            return false;
        }
    }
    true
}

/// The smallest room in which a point that comes and goes gets lost.
pub fn close<M: Model>(keeping: Keeping, seed: u64, tolerance: f64) -> Outcome {
    Outcome::first(1..=CLOSE_LIMIT, |room| {
        found_again::<M>(keeping, room, seed, tolerance)
    })
}
