//! Doors: a pair of frames that are put up like flags. What goes into one comes out of the other; a single one leads nowhere.
//!
//! The way through is `antipode_geometry::doorway`. Bodies go by it here, and the picks of the crosshair in `pick`. What has gone
//! through keeps its speed in the space, its height over the ground and its way in the doorway's own axes. Doors stand upright, so the
//! view is level on the other side at once.

use antipode_geometry::doorway::{HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{ChartPoint, Crossing, Doorway, Leaf, Passing, pace};
use antipode_items::{Item, Stands};
use antipode_terrain::{Gate, Part, Stroke};
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
/// No body's middle is farther from a leaf than this when a part of it has gone through, metres.
const REACHES_M: f64 = 3.0;

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

    /// How a thing that flew from one place to another is to be carried on, and its velocity, if the way led through a door.
    /// It goes on as high over the ground as before, where there is ground at hand.
    pub fn through_door(
        &self,
        from: ChartPoint,
        to: ChartPoint,
        velocity: DVec3,
    ) -> Option<(Crossing, DVec3)> {
        let (crossing, _) = self.led_through(from, to)?;
        let velocity = pace::carried(&*self.strategy, to, &crossing, velocity);
        Some((crossing, velocity))
    }

    /// Where somebody who is so near to a leaf that he may reach through it would be on the other side.
    pub fn beyond_door(&self, at: ChartPoint) -> Option<ChartPoint> {
        let doors = self.doors.as_ref()?;
        let space = &*self.strategy;
        let near = (0..2).find(|leaf| {
            let leaf = &doors.leaves[*leaf];
            let there = space.carry_near(at, leaf.foot);
            there.is_some_and(|it| leaf.local(it.point.pos).length() < REACHES_M)
        })?;
        Some(doors.carry(space, near, at)?.point)
    }

    /// How a body is to be carried on that stands on the ground of both sides: as it is.
    pub fn through_door_whole(&self, from: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        let (doors, by) = self.door_between(from, to)?;
        doors.pass(&*self.strategy, by, to)
    }

    /// How somebody who walks is to be carried on, and by how much he is lifted besides, metres, to be as high over the ground as before.
    fn led_through(&self, from: ChartPoint, to: ChartPoint) -> Option<(Crossing, f64)> {
        let (doors, by) = self.door_between(from, to)?;
        let mut crossing = doors.pass(&*self.strategy, by, to)?;
        let over_m = |at: ChartPoint| {
            let above = at.moved(DVec3::Y * STEP_UP_M);
            let solid = |point: ChartPoint| self.ground.is_solid(point);
            height_below(above, STEP_UP_M + STEP_DOWN_M, solid).map(|y| at.pos.y - y)
        };
        let heights = over_m(to).zip(over_m(crossing.point));
        let lifted_m = heights.map_or(0.0, |(here_m, there_m)| here_m - there_m);
        crossing.point.pos.y += lifted_m;
        Some((crossing, lifted_m))
    }
}

/// The parts of a stroke whose ball reaches over a leaf: what is before the leaf, and what is reached through it, where that comes
/// out of the other one. Of two leaves in its reach it goes through the nearer one.
pub(crate) fn parted(world: &World, whole: Stroke) -> Vec<Stroke> {
    let space = &*world.strategy;
    let gate = |leaf: &Leaf, middle: ChartPoint| {
        let crossing = space.carry_near(leaf.foot, middle)?;
        let way = crossing.turn_vector(leaf.through());
        Some(Gate {
            foot: crossing.point.pos,
            heading_rad: way.z.atan2(way.x),
            half_width_m: HALF_WIDTH_M,
            height_m: HEIGHT_M,
        })
    };
    let away_m = |leaf: &Leaf| {
        let at = leaf.local(space.carry_near(whole.centre, leaf.foot)?.point.pos);
        let aside_m = (at.z.abs() - HALF_WIDTH_M).max(0.0);
        let off_m = at.x.hypot(aside_m);
        (off_m < whole.radius_m).then_some(off_m)
    };
    let parts = world.doors.as_ref().and_then(|doors| {
        let reached = (0..2).filter_map(|at| Some((at, away_m(&doors.leaves[at])?)));
        let (leaf, _) = reached.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let there = doors.carry(space, leaf, whole.centre)?.point;
        let (own, far) = (doors.leaves[leaf], doors.leaves[1 - leaf]);
        let before = Stroke {
            part: Part::Before(gate(&own, whole.centre)?),
            ..whole
        };
        let through = Stroke {
            centre: there,
            part: Part::Through(gate(&far, there)?),
            ..whole
        };
        Some(vec![before, through])
    });
    parts.unwrap_or_else(|| vec![whole])
}

/// Carries a body on whose way led through a door; returns by how much it was lifted besides, metres, if it did.
pub(crate) fn pass(
    world: &World,
    before: ChartPoint,
    position: &mut Position,
    look: &mut Look,
    body: &mut Body,
) -> Option<f64> {
    let (crossing, lifted_m) = world.led_through(before, position.0)?;
    let pace = pace::share(&*world.strategy, position.0, &crossing, body.0.velocity);
    position.0 = crossing.point;
    body.0.feet = crossing.point.pos;
    look.yaw = wrap_angle(look.yaw - crossing.turn_rad);
    body.0.velocity = crossing.turn_vector(body.0.velocity) * pace;
    Some(lifted_m)
}
