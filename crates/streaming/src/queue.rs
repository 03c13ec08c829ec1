//! The order in which chunks are loaded: what the player stands on, then what they see, then the
//! rest; nearest first in each.

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord, Strategy};
use glam::DVec3;

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

/// Chunks waiting to be handed to a worker.
#[derive(Debug, Default)]
pub(crate) struct Queue {
    /// Worst first, so that the best is taken off the end.
    order: Vec<ChunkCoord>,
    aim: Option<Aim>,
    sorted: bool,
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
            self.sorted = false;
        }
    }

    /// Adds a chunk that is not in the queue.
    pub(crate) fn push(&mut self, coord: ChunkCoord) {
        self.order.push(coord);
        self.sorted = false;
    }

    /// Keeps only the chunks for which `keep` holds; the order stays.
    pub(crate) fn retain(&mut self, keep: impl Fn(ChunkCoord) -> bool) {
        self.order.retain(|&coord| keep(coord));
    }

    /// Is the chunk waiting?
    pub(crate) fn contains(&self, coord: ChunkCoord) -> bool {
        self.order.contains(&coord)
    }

    /// How many chunks wait.
    pub(crate) fn len(&self) -> usize {
        self.order.len()
    }

    /// Takes the chunk that matters most.
    pub(crate) fn pop(&mut self, strategy: &dyn Strategy) -> Option<ChunkCoord> {
        if !self.sorted {
            self.sort(strategy);
        }
        self.order.pop()
    }

    fn sort(&mut self, strategy: &dyn Strategy) {
        self.sorted = true;
        let Some(aim) = self.aim else { return };
        let mut ranked: Vec<_> = self
            .order
            .iter()
            .map(|&coord| (rank(strategy, aim, coord), coord))
            .collect();
        ranked.sort_unstable_by(|((group_a, far_a), a), ((group_b, far_b), b)| {
            group_b
                .cmp(group_a)
                .then(far_b.total_cmp(far_a))
                .then(b.cmp(a))
        });
        self.order.clear();
        self.order
            .extend(ranked.into_iter().map(|(_, coord)| coord));
    }
}

/// Group (0 at hand, 1 seen, 2 the rest) and distance in metres: the smaller the sooner.
fn rank(strategy: &dyn Strategy, aim: Aim, coord: ChunkCoord) -> (u8, f64) {
    let half = DVec3::splat(f64::from(CHUNK_CELLS) / 2.0);
    let mut middle = ChartPoint::new(coord.hemisphere, coord.origin() + half);
    if middle.hemisphere != aim.centre.hemisphere
        && let Some(crossing) = strategy.carry(middle)
    {
        middle = crossing.point;
    }
    let to = middle.pos - aim.centre.pos;
    let distance_m = to.length();
    let group = if distance_m < AT_HAND_M {
        0
    } else if to.dot(aim.front) >= SEEN_COS * distance_m {
        1
    } else {
        2
    };
    (group, distance_m)
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]
    use super::*;
    use antipode_geometry::{Geometry, Hemisphere, strategy};
    use glam::IVec3;

    fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
        ChunkCoord {
            hemisphere: Hemisphere::A,
            index: IVec3::new(x, y, z),
        }
    }

    fn drain(queue: &mut Queue) -> Vec<ChunkCoord> {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        std::iter::from_fn(|| queue.pop(&*space)).collect()
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
            queue.push(coord);
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
        queue.push(chunk(3, 0, 0));
        queue.push(chunk(-3, 0, 0));
        queue.sort(&*strategy(Geometry::Euclidean, f64::INFINITY));
        queue.look(here, DVec3::new(1.0, 0.1, 0.0));
        assert!(queue.sorted);
        queue.look(here, DVec3::NEG_X);
        assert_eq!(drain(&mut queue), [chunk(-3, 0, 0), chunk(3, 0, 0)]);
    }

    #[test]
    fn over_the_equator_is_as_near_as_it_is_in_the_space() {
        let space = strategy(Geometry::Spherical, 32.0);
        let rim = space.rim_m().unwrap();
        let mut queue = Queue::default();
        queue.look(ChartPoint::a(DVec3::new(0.0, 8.0, rim - 1.0)), DVec3::ZERO);
        let across = space
            .carry(ChartPoint::a(DVec3::new(0.0, 8.0, rim + 4.0)))
            .unwrap()
            .point;
        let near = ChunkCoord::containing(across);
        let far = ChunkCoord {
            hemisphere: near.hemisphere,
            index: IVec3::new(near.index.x, near.index.y, -1 - near.index.z),
        };
        queue.push(near);
        queue.push(far);
        assert_eq!(queue.pop(&*space), Some(near));
    }
}
