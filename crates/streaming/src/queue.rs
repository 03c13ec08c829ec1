//! The order in which chunks are loaded: what the player stands on, then what they see, then the
//! rest; nearest first in each. Chunks that are there at another level come after all that are not.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartPoint, ChunkCoord};
use glam::DVec3;

use crate::maps::ChunkMap;

/// Chunks whose centres are this near come first wherever the player looks, for the ground under
/// their feet is among them: less than two chunks.
const AT_HAND_M: f64 = 1.75 * CHUNK_CELLS as f64;

/// Cosine of the angle off the view's axis within which a chunk counts as seen; wide enough for
/// the corners of a picture and the chunk's own size.
const SEEN_COS: f64 = 0.5;

/// Cosine of the turn of the view after which the order is made anew: 15 degrees.
const TURNED_COS: f64 = 0.966;

/// Where from and where to the player looks.
#[derive(Clone, Copy, Debug)]
struct Aim {
    centre: ChartPoint,
    front: DVec3,
}

/// Group and distance in micrometres: the smaller the sooner.
type Rank = (u8, u64);

/// Chunks waiting to be handed to a worker.
#[derive(Debug, Default)]
pub(crate) struct Queue {
    /// The chunks that wait, and whether nothing of them is there yet.
    waiting: ChunkMap<bool>,
    /// Best first. Also holds chunks that wait no more; what waits is at least once in it.
    order: BinaryHeap<Reverse<(Rank, ChunkCoord)>>,
    aim: Option<Aim>,
    /// Is `order` made for `aim`?
    ordered: bool,
}

impl Queue {
    /// Looks from `centre` to `front` from now on; the order is made anew only if that can matter.
    pub(crate) fn look(&mut self, centre: ChartPoint, front: DVec3) {
        let front = front.try_normalize().unwrap_or(DVec3::ZERO);
        let same = self.aim.is_some_and(|aim| {
            let turned = aim.front != front && aim.front.dot(front) < TURNED_COS;
            ChunkCoord::containing(aim.centre) == ChunkCoord::containing(centre) && !turned
        });
        if !same {
            self.aim = Some(Aim { centre, front });
            self.ordered = false;
        }
    }

    /// Adds a chunk; `missing` says that nothing of it is there yet.
    pub(crate) fn push(&mut self, coord: ChunkCoord, missing: bool, strategy: &dyn Atlas) {
        let before = self.waiting.insert(coord, missing);
        if self.ordered && before != Some(missing) {
            let rank = rank(strategy, self.aim, coord, missing);
            self.order.push(Reverse((rank, coord)));
        }
    }

    /// Lets a chunk go that may be waiting.
    pub(crate) fn remove(&mut self, coord: ChunkCoord) {
        self.waiting.remove(&coord);
    }

    /// Lets all chunks go.
    pub(crate) fn clear(&mut self) {
        self.waiting.clear();
        self.order.clear();
    }

    /// Is the chunk waiting?
    pub(crate) fn contains(&self, coord: ChunkCoord) -> bool {
        self.waiting.contains_key(&coord)
    }

    /// How many chunks wait.
    pub(crate) fn len(&self) -> usize {
        self.waiting.len()
    }

    /// Takes the chunk that matters most.
    pub(crate) fn pop(&mut self, strategy: &dyn Atlas) -> Option<ChunkCoord> {
        if !self.ordered {
            let aim = self.aim;
            let ranked = self
                .waiting
                .iter()
                .map(|(&coord, &missing)| Reverse((rank(strategy, aim, coord, missing), coord)));
            self.order = ranked.collect();
            self.ordered = true;
        }
        while let Some(Reverse((_, coord))) = self.order.pop() {
            if self.waiting.remove(&coord).is_some() {
                return Some(coord);
            }
        }
        None
    }
}

/// At hand 0; seen 1 and unseen 2 while missing; 3 and 4 else.
fn rank(strategy: &dyn Atlas, aim: Option<Aim>, coord: ChunkCoord, missing: bool) -> Rank {
    let Some(aim) = aim else { return (0, 0) };
    let half = DVec3::splat(f64::from(CHUNK_CELLS) / 2.0);
    let middle = ChartPoint::new(coord.chart, coord.origin() + half);
    let way = strategy.way_m(aim.centre, middle);
    let to = way.unwrap_or(middle.pos - aim.centre.pos);
    let distance_m = to.length();
    let seen = to.dot(aim.front) >= SEEN_COS * distance_m;
    let group = match (distance_m < AT_HAND_M, missing, seen) {
        (true, _, _) => 0,
        (false, true, true) => 1,
        (false, true, false) => 2,
        (false, false, true) => 3,
        (false, false, false) => 4,
    };
    (group, (distance_m * 1e6) as u64)
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]
    use std::sync::Arc;

    use super::*;
    use antipode_geometry::{ChartId, Geometry, strategy};
    use glam::IVec3;

    fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
        ChunkCoord {
            chart: ChartId::FIRST,
            index: IVec3::new(x, y, z),
        }
    }

    fn flat() -> Arc<dyn Atlas> {
        strategy(Geometry::Euclidean, f64::INFINITY)
    }

    fn drain(queue: &mut Queue) -> Vec<ChunkCoord> {
        std::iter::from_fn(|| queue.pop(&*flat())).collect()
    }

    #[test]
    fn at_hand_then_seen_then_the_rest_each_nearest_first() {
        let mut queue = Queue::default();
        queue.look(ChartPoint::a(DVec3::splat(16.0)), DVec3::X);
        for coord in [
            chunk(-3, 0, 0),
            chunk(4, 0, 0),
            chunk(0, -1, 0),
            chunk(3, 0, 0),
            chunk(0, 0, 0),
            chunk(-2, 0, 0),
        ] {
            queue.push(coord, true, &*flat());
        }
        let want = [
            chunk(0, 0, 0),
            chunk(0, -1, 0),
            chunk(3, 0, 0),
            chunk(4, 0, 0),
            chunk(-2, 0, 0),
            chunk(-3, 0, 0),
        ];
        assert_eq!(drain(&mut queue), want);
    }

    #[test]
    fn turning_round_changes_the_order_and_a_small_turn_does_not() {
        let mut queue = Queue::default();
        let here = ChartPoint::a(DVec3::splat(16.0));
        queue.look(here, DVec3::X);
        queue.push(chunk(5, 0, 0), true, &*flat());
        assert_eq!(queue.pop(&*flat()), Some(chunk(5, 0, 0)));
        queue.push(chunk(3, 0, 0), true, &*flat());
        queue.push(chunk(-3, 0, 0), true, &*flat());
        queue.look(here, DVec3::new(1.0, 0.1, 0.0));
        assert!(queue.ordered);
        queue.look(here, DVec3::NEG_X);
        assert_eq!(drain(&mut queue), [chunk(-3, 0, 0), chunk(3, 0, 0)]);
    }

    #[test]
    fn over_the_equator_is_as_near_as_it_is_in_the_space() {
        let space = strategy(Geometry::Spherical, 32.0);
        let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
        let mut queue = Queue::default();
        queue.look(ChartPoint::a(DVec3::new(0.0, 8.0, rim - 1.0)), DVec3::ZERO);
        let across = space.images(
            ChartPoint::a(DVec3::new(0.0, 8.0, rim + 4.0)),
            f64::INFINITY,
        )[0]
        .point;
        let near = ChunkCoord::containing(across);
        let far = ChunkCoord {
            chart: near.chart,
            index: IVec3::new(near.index.x, near.index.y, -1 - near.index.z),
        };
        queue.push(near, true, &*space);
        queue.push(far, true, &*space);
        assert_eq!(queue.pop(&*space), Some(near));
    }

    #[test]
    fn what_is_not_there_at_all_comes_before_what_is_to_change() {
        let mut queue = Queue::default();
        queue.look(ChartPoint::a(DVec3::splat(16.0)), DVec3::X);
        queue.push(chunk(3, 0, 0), false, &*flat());
        queue.push(chunk(-6, 0, 0), true, &*flat());
        queue.push(chunk(9, 0, 0), true, &*flat());
        queue.push(chunk(1, 0, 0), false, &*flat());
        let want = [
            chunk(1, 0, 0),
            chunk(9, 0, 0),
            chunk(-6, 0, 0),
            chunk(3, 0, 0),
        ];
        assert_eq!(drain(&mut queue), want);
    }

    #[test]
    fn a_chunk_waits_once_however_often_it_is_added_and_removed() {
        let mut queue = Queue::default();
        queue.look(ChartPoint::a(DVec3::splat(16.0)), DVec3::X);
        queue.push(chunk(4, 0, 0), true, &*flat());
        assert_eq!(queue.pop(&*flat()), Some(chunk(4, 0, 0)));
        for missing in [true, false, true] {
            queue.push(chunk(3, 0, 0), missing, &*flat());
            queue.push(chunk(2, 0, 0), missing, &*flat());
            queue.remove(chunk(2, 0, 0));
        }
        assert_eq!(queue.len(), 1);
        assert_eq!(drain(&mut queue), [chunk(3, 0, 0)]);
    }
}
