//! Doors: a pair of frames that are put up like flags. What goes into one comes out of the other; a single one leads nowhere.
//!
//! The way through is `antipode_geometry::doorway`. Bodies go by it here, and the picks of the crosshair in `pick`. What has gone
//! through keeps its speed, its height over the ground and its way in the doorway's own axes. Doors stand upright, so the
//! view is level on the other side at once.

use antipode_geometry::{ChartPoint, Crossing, Doorway, Leaf, Passing};
use antipode_items::{Item, Stands};
use glam::DVec3;

use crate::actors::Actors;
use crate::fixture::{self, Behaviour, Fixture};
use crate::ground::height_below;
use crate::notice::Unfit;
use crate::pick::over;
use crate::player::{Body, Look, Position, wrap_angle};
use crate::situation::Situation;
use crate::world::World;

/// Ground on the other side is looked for from so far above a foot, and so far below it, metres.
const STEP_UP_M: f64 = 1.2;
const STEP_DOWN_M: f64 = 1.6;

/// How far aside of the foot the posts stand, and how far the ground below them may lie above or below it, metres: they reach
/// so far into the ground.
const POST_M: f64 = 1.04;
const UNEVEN_M: f64 = 0.55;
/// So far before and behind it there is to be room, metres, in ground that rises or falls no more than this.
const ROOM_M: f64 = 1.0;
const STEP_M: f64 = 0.85;
/// Heights over the foot that are to be free there, and how far aside, metres.
const FREE_UP_M: [f64; 2] = [1.0, 1.8];
const FREE_ASIDE_M: f64 = 0.6;
/// The other door is farther off than this, metres.
const APART_M: f64 = 2.4;

/// What stands in pairs.
pub(crate) struct Paired;

impl Behaviour for Paired {
    /// On any ground: what is against it is told by [`Paired::unfit`].
    fn foot_on(&self, _: &Stands, spot: ChartPoint, _: DVec3) -> Option<ChartPoint> {
        Some(spot)
    }

    fn unfit(&self, now: Situation<'_>, it: &Fixture) -> Option<Unfit> {
        let leaf = leaf_of(it);
        let solid = |x: f64, y: f64, z: f64| {
            let at = leaf.place(DVec3::new(x, y, z));
            now.world.ground.is_solid(at)
        };
        // Ground within a span of a foot's height: rock at its lower end and air at its upper one.
        let is_level = |x: f64, z: f64, span_m: f64| solid(x, -span_m, z) && !solid(x, span_m, z);
        let stands = [-POST_M, 0.0, POST_M].map(|z| is_level(0.0, z, UNEVEN_M));
        let leads_on = [-ROOM_M, ROOM_M].map(|x| is_level(x, 0.0, STEP_M));
        let is_free = |x: f64| {
            FREE_UP_M.iter().all(|y| {
                [-FREE_ASIDE_M, 0.0, FREE_ASIDE_M]
                    .iter()
                    .all(|z| !solid(x, *y, *z))
            })
        };
        if stands.contains(&false) {
            return Some(Unfit::Steep);
        }
        if ![-ROOM_M, -0.5 * ROOM_M, 0.5 * ROOM_M, ROOM_M]
            .into_iter()
            .all(is_free)
        {
            return Some(Unfit::Walled);
        }
        if leads_on.contains(&false) {
            return Some(Unfit::Steep);
        }
        is_crowded(now, &leaf).then_some(Unfit::Crowded)
    }

    fn is_foreseen(&self) -> bool {
        true
    }

    fn replaces_oldest(&self) -> bool {
        true
    }
}

/// Whether the door that stays when one more is put up is too close to it.
fn is_crowded(now: Situation<'_>, leaf: &Leaf) -> bool {
    let others = fixture::map_of(now.actors, Item::Door, |_, it| it.foot.point);
    let stays = others.last();
    stays.is_some_and(|other| {
        let there = over(&*now.world.strategy, leaf.foot, *other);
        there.chart == leaf.foot.chart && there.pos.distance(leaf.foot.pos) < APART_M
    })
}

fn leaf_of(it: &Fixture) -> Leaf {
    Leaf {
        foot: it.foot.point,
        yaw: it.yaw_rad,
    }
}

/// The pair, the older leaf first, if both stand.
pub(crate) fn pair(actors: &Actors) -> Option<Doorway> {
    let leaves = fixture::map_of(actors, Item::Door, |_, it| leaf_of(it));
    match leaves[..] {
        [older, newer] => Some(Doorway {
            leaves: [older, newer],
        }),
        _ => None,
    }
}

impl World {
    /// Where the way between two places goes through a door, and that door's pair.
    pub fn door_between(&self, from: ChartPoint, to: ChartPoint) -> Option<(&Doorway, Passing)> {
        let doors = self.doors.as_ref()?;
        let by = doors.met(&*self.strategy, from, to)?;
        Some((doors, by))
    }

    /// How somebody or something who went from one place to another is to be carried on, if the way led through a door. It
    /// goes on as high over the ground as before, where there is ground at hand.
    pub fn through_door(&self, from: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        let (doors, by) = self.door_between(from, to)?;
        let mut crossing = doors.pass(&*self.strategy, by, to)?;
        let over_m = |at: ChartPoint| {
            let above = at.moved(DVec3::Y * STEP_UP_M);
            let solid = |point: ChartPoint| self.ground.is_solid(point);
            height_below(above, STEP_UP_M + STEP_DOWN_M, solid).map(|y| at.pos.y - y)
        };
        if let (Some(here_m), Some(there_m)) = (over_m(to), over_m(crossing.point)) {
            crossing.point.pos.y += here_m - there_m;
        }
        Some(crossing)
    }
}

/// Carries a body on whose way led through a door; returns whether it did.
pub(crate) fn pass(
    world: &World,
    before: ChartPoint,
    position: &mut Position,
    look: &mut Look,
    body: &mut Body,
) -> bool {
    let Some(crossing) = world.through_door(before, position.0) else {
        return false;
    };
    position.0 = crossing.point;
    body.0.feet = crossing.point.pos;
    look.yaw = wrap_angle(look.yaw - crossing.turn_rad);
    body.0.velocity = crossing.turn_vector(body.0.velocity);
    true
}
