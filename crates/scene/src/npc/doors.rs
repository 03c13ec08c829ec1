//! Doors as figures know them: what is seen through them, how near things are by way of them, and the ways that lead through.

use antipode_geometry::{ChartPoint, Doorway, Eye, Leaf, Strategy};
use antipode_physics::PhysicsWorld;
use glam::DVec3;

use super::bearing::{ahead, any_heading, apart_m, toward, way};
use super::figure::Npc;
use super::senses::Around;
use crate::pick::{over, segment_hit};
use crate::world::World;

/// A way through a door is taken only if it is shorter by this, metres.
const GAIN_M: f64 = 2.0;
/// From how far before a leaf one goes straight through it, and to how far behind it, metres.
const BEFORE_M: f64 = 1.0;
const BEYOND_M: f64 = 0.8;
/// Nearer before the leaf than this, and not farther aside than this, one goes straight on, metres.
const AT_HAND_M: f64 = 1.5;
const ASIDE_M: f64 = 0.6;
/// How often one who sets out near a door goes through it, how near that is, and how far beyond it goes, metres.
const VISITS: f64 = 0.4;
const VISITS_M: f64 = 25.0;
const BEYOND_DOOR_M: f64 = 4.0;
/// Length of a tested piece of a line of sight, in metres.
const SEGMENT_M: f64 = 1.0;

/// A way through a door.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Detour {
    /// Where one stands before the leaf; none for one who does already.
    pub before: Option<ChartPoint>,
    /// A place behind the leaf, on this side of the door: who goes there goes through.
    pub beyond: ChartPoint,
}

impl Around<'_> {
    /// How far apart two places are in the space, by way of a door where that is shorter, metres.
    pub fn felt_m(&self, a: ChartPoint, b: ChartPoint) -> f64 {
        felt_m(self.world, a, b)
    }

    /// The way through a door from one place to another, where that is shorter than the way over the ground.
    pub fn detour(&self, from: ChartPoint, to: ChartPoint) -> Option<Detour> {
        let doors = self.world.doors.as_ref()?;
        let space = self.strategy();
        let straight_m = way(space, from, to).level_m;
        let length_m = |leaf: usize| {
            let [near, far] = [leaf, 1 - leaf].map(|at| doors.leaves[at].foot);
            way(space, from, near).level_m + way(space, far, to).level_m
        };
        let [first_m, second_m] = [0, 1].map(length_m);
        let (leaf, door_m) = if first_m <= second_m {
            (0, first_m)
        } else {
            (1, second_m)
        };
        // Also where no way over the ground is known at all.
        let is_shorter = door_m + GAIN_M < straight_m || straight_m.is_nan();
        is_shorter.then(|| {
            let leaf = &doors.leaves[leaf];
            let at = leaf.local(over(space, leaf.foot, from).pos);
            let side = if at.x < 0.0 { -1.0 } else { 1.0 };
            let is_at_hand = at.x.abs() < AT_HAND_M && at.z.abs() < ASIDE_M;
            Detour {
                before: (!is_at_hand).then(|| leaf.place(DVec3::X * (side * BEFORE_M))),
                beyond: leaf.place(DVec3::X * (-side * BEYOND_M)),
            }
        })
    }
}

/// How far apart two places of a world are, by way of a door where that is shorter, metres.
pub(super) fn felt_m(world: &World, a: ChartPoint, b: ChartPoint) -> f64 {
    let space = &*world.strategy;
    let straight_m = apart_m(space, a, b);
    let by_door = |doors: &Doorway| {
        let ways = [0, 1].map(|leaf| {
            let [near, far] = [leaf, 1 - leaf].map(|at| doors.leaves[at].foot);
            apart_m(space, a, near) + apart_m(space, far, b)
        });
        ways[0].min(ways[1])
    };
    let doors = world.doors.as_ref();
    doors.map_or(straight_m, |doors| straight_m.min(by_door(doors)))
}

impl Npc<'_> {
    /// A place on the other side of a door that is near, for who feels like it.
    pub fn beyond_a_door(&mut self, around: &Around<'_>) -> Option<ChartPoint> {
        let doors = around.world.doors.as_ref()?;
        let feels_like_it = self.mind.dice.unit() < VISITS;
        let thrown = self.mind.dice.heading();
        let near = |leaf: &&Leaf| around.apart_m(self.position.0, leaf.foot) < VISITS_M;
        let leaf = doors.leaves.iter().position(|leaf| near(&leaf))?;
        let far = doors.leaves[1 - leaf].foot;
        let heading = toward(any_heading(around.strategy(), far.chart, thrown));
        feels_like_it.then(|| ahead(around.strategy(), far, heading, BEYOND_DOOR_M))
    }
}

/// What may lie in a line of sight.
pub(crate) struct Sight<'a> {
    strategy: &'a dyn Strategy,
    physics: &'a PhysicsWorld,
    doors: Option<&'a Doorway>,
}

impl<'a> Sight<'a> {
    /// What lies in a world, in a picture of it.
    pub fn of(strategy: &'a dyn Strategy, world: &'a World) -> Self {
        Self {
            strategy,
            physics: &world.physics,
            doors: world.doors.as_ref(),
        }
    }

    /// Whether nothing lies between an eye and a place, but for the last `last_m`, metres; a door in between does, too.
    pub fn is_clear_straight(&self, eye: &Eye, place: ChartPoint, last_m: f64) -> bool {
        self.leads(eye, place, None, last_m)
    }

    /// Whether nothing lies between an eye and a place, but for the last `last_m`, metres: straight, or through one door.
    pub fn is_clear(&self, eye: &Eye, place: ChartPoint, last_m: f64) -> bool {
        if self.leads(eye, place, None, last_m) {
            return true;
        }
        self.doors.is_some_and(|doors| {
            [0, 1].into_iter().any(|leaf| {
                let image = doors.pictured(self.strategy, 1 - leaf, eye, place);
                self.leads(eye, image, Some(leaf), last_m)
            })
        })
    }

    /// Whether the geodesic to a place meets nothing but that leaf, and that.
    fn leads(&self, eye: &Eye, place: ChartPoint, into: Option<usize>, last_m: f64) -> bool {
        let space = self.strategy;
        let view = space.view_point(eye, place);
        let away_m = space.eye_distance_m(eye, view);
        let direction = view.truncate().normalize_or_zero();
        if away_m.is_nan() || away_m >= space.sight_limit_m(eye) || direction == DVec3::ZERO {
            return false;
        }
        let end_m = away_m - last_m;
        let count = (end_m / SEGMENT_M).ceil().max(1.0) as u32;
        let (mut eye, mut through) = (*eye, None);
        let mut near = eye.point;
        let mut near_m = 0.0;
        for index in 1..=count {
            let far_m = end_m * f64::from(index) / f64::from(count);
            let mut far = space.along(&eye, direction, far_m);
            let met = self
                .doors
                .and_then(|doors| Some((doors, doors.met(space, near, far)?)));
            if let Some((doors, by)) = met {
                if through.is_some() || into != Some(by.leaf) {
                    return false;
                }
                let leaf_m = near_m + by.share * (far_m - near_m);
                let at = space.along(&eye, direction, leaf_m);
                if segment_hit(space, self.physics, near, at).is_some() {
                    return false;
                }
                through = Some(by.leaf);
                eye = doors.eye(space, by.leaf, &eye);
                near = space.along(&eye, direction, leaf_m);
                far = space.along(&eye, direction, far_m);
            }
            if segment_hit(space, self.physics, near, far).is_some() {
                return false;
            }
            (near, near_m) = (far, far_m);
        }
        through == into
    }
}
