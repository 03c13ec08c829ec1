//! The published walk: two walkers on one straight line, half a step apart, until they part.
//!
//! Each is kept in the frame of the tile it is on, so no coordinate is ever far. But a straight
//! line forgets nothing: whatever the last bit gets wrong about a walker's heading moves it
//! sideways by `exp d`, and two walkers that round each for themselves part after about 16 steps
//! for every factor e of precision, in any representation. Keeping the second one relative to the
//! first, as a game does with everything beside its camera, leaves no second rounding: the two
//! share a heading, so the turn between them is exactly none, and no product makes it anything
//! else.

use std::f64::consts::PI;

use super::disk::Disk;
use super::model::{Model, Moves, Pose, Spot};
use super::number::Number;
use super::outcome::{Outcome, within};
use super::tiling::{EDGES, Tile, Tiling};
use crate::random::Numbers;

/// The longest walk, in steps.
pub const WALK_LIMIT: u32 = 10_000;
/// A step, in radii.
pub const STEP: f64 = 1.0 / 16.0;
/// A walker changes to a neighbour's frame if that one's centre is no farther than this past its
/// own, in radii.
const MARGIN: f64 = 1.0 / 256.0;

/// When two walkers have parted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parting {
    /// When their tiles are three or more apart: the published test.
    Tiles,
    /// When their distance is wrong by this, in radii.
    Distance(f64),
}

/// One that walks, in the frame of the tile it is on.
#[derive(Clone, Debug)]
struct Walker<M: Model> {
    tile: Tile,
    pose: M::Isometry,
}

fn centre_distance<M: Model>(pose: &M::Isometry) -> f64 {
    M::distance(&M::apply(pose, &M::origin())).get()
}

impl<M: Model> Walker<M> {
    /// One step straight on.
    fn step(&mut self, tiling: &mut Tiling, moves: &Moves<M>, forward: &M::Isometry) {
        self.pose = M::compose(&self.pose, forward);
        self.settle(tiling, moves, MARGIN);
    }

    /// Into the frame of the first neighbour whose centre is nearer than its own and `margin`;
    /// whether there was one.
    fn settle(&mut self, tiling: &mut Tiling, moves: &Moves<M>, margin: f64) -> bool {
        let here = centre_distance::<M>(&self.pose) + margin;
        for edge in 0..EDGES {
            let (tile, back) = tiling.neighbour(self.tile, edge);
            let pose = moves.cross(back, edge, &Pose(self.pose.clone())).0;
            if centre_distance::<M>(&pose) < here {
                (self.tile, self.pose) = (tile, pose);
                return true;
            }
        }
        false
    }

    fn is_lost(&self) -> bool {
        !centre_distance::<M>(&self.pose).is_finite()
    }
}

fn heading<M: Model>(seed: u64) -> M::Isometry {
    M::spin(M::N::of(Numbers::new(seed).between(0.0, 2.0 * PI)))
}

/// Two walkers that round each for themselves.
pub fn apart<M: Model>(parting: Parting, seed: u64) -> Outcome {
    let (mut tiling, moves) = (Tiling::new(), Moves::<M>::new());
    let forward = M::push(M::N::of(STEP));
    let pose = heading::<M>(seed);
    let ahead = M::compose(&pose, &M::push(M::N::of(0.5 * STEP)));
    let tile = Tiling::FIRST;
    let mut walkers = [pose, ahead].map(|pose| Walker::<M> { tile, pose });
    Outcome::first(1..=WALK_LIMIT, |_| {
        for walker in &mut walkers {
            walker.step(&mut tiling, &moves, &forward);
        }
        let [a, b] = &walkers;
        let Some(path) = tiling.short_path(a.tile, b.tile) else {
            return false;
        };
        if a.is_lost() || b.is_lost() {
            return false;
        }
        let Parting::Distance(tolerance) = parting else {
            return true;
        };
        let second = M::apply(&b.pose, &M::origin());
        let second = moves.along(&mut tiling, &path, Spot(second)).0;
        let first = M::push_to(&M::apply(&a.pose, &M::origin()));
        let between = M::distance(&M::apply(&M::inverse(&first), &second)).get();
        within(between - 0.5 * STEP, tolerance)
    })
}

/// The second walker kept relative to the first, which is the camera.
pub fn beside<N: Number>(parting: Parting, seed: u64) -> Outcome {
    let (mut tiling, moves) = (Tiling::new(), Moves::<Disk<N>>::new());
    let forward = Disk::push(N::of(STEP));
    let backward = Disk::inverse(&forward);
    let mut camera = Walker::<Disk<N>> {
        tile: Tiling::FIRST,
        pose: heading::<Disk<N>>(seed),
    };
    let mut relative = Disk::push(N::of(0.5 * STEP));
    Outcome::first(1..=WALK_LIMIT, |_| {
        camera.step(&mut tiling, &moves, &forward);
        camera.pose = camera.pose.renormalised();
        // Both go forward: the camera's step comes off in front, the other's is added behind.
        let moved = Disk::compose(&relative, &forward);
        relative = Disk::compose(&backward, &moved).renormalised();
        match parting {
            Parting::Distance(tolerance) => within(
                centre_distance::<Disk<N>>(&relative) - 0.5 * STEP,
                tolerance,
            ),
            Parting::Tiles => {
                let mut other = Walker::<Disk<N>> {
                    tile: camera.tile,
                    pose: Disk::compose(&camera.pose, &relative),
                };
                while other.settle(&mut tiling, &moves, -MARGIN) {}
                let together = tiling.short_path(camera.tile, other.tile).is_some();
                together && !other.is_lost() && !camera.is_lost()
            }
        }
    })
}
