//! Doors: a pair of frames that are put up like flags. What goes into one comes out of the other; a single one leads nowhere.
//!
//! The way through is `antipode_geometry::doorway`. Bodies go by it here, and the picks of the crosshair in `pick`. What has gone
//! through keeps its speed in the space, its height over the ground and its way in the doorway's own axes. Doors stand upright, so the
//! view is level on the other side at once.

use antipode_geometry::doorway::{HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{Atlas, ChartPoint, Crossing, Doorway, Eye, Leaf, Passing, Strategy};
use antipode_items::Item;
use antipode_terrain::{Gate, Part, Shape, Stroke};
use glam::DVec3;

use crate::actors::Actors;
use crate::fixture::{self, Fixture};
use crate::ground::height_below;
use crate::player::{Body, Look, Position};
use crate::world::World;

/// Ground on the other side is looked for from so far above a foot, and so far below it, metres.
const STEP_UP_M: f64 = 1.2;
const STEP_DOWN_M: f64 = 1.6;

/// No body's middle is farther from a leaf than this when a part of it has gone through, metres.
const REACHES_M: f64 = 3.0;

pub(crate) fn leaf_of(space: &dyn Strategy, it: &Fixture) -> Leaf {
    Leaf::at(space, it.foot.point, it.yaw_rad)
}

/// The pair, the older leaf first, if both stand.
pub(crate) fn pair(space: &dyn Strategy, actors: &Actors) -> Option<Doorway> {
    let leaves = fixture::map_of(actors, Item::Door, |_, it| leaf_of(space, it));
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

    /// How a thing that flew from one place to another is to be carried on, if the way led through a door.
    /// It goes on as high over the ground as before, where there is ground at hand.
    pub fn through_door(&self, from: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        Some(self.led_through(from, to)?.0)
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
/// out of the other one. Where it reaches over both leaves, it is before neither, and goes on through each.
pub(crate) fn parted(world: &World, whole: Stroke) -> Vec<Stroke> {
    let Some(doors) = &world.doors else {
        return vec![whole];
    };
    let space = &*world.strategy;
    let is_reached = |leaf: &usize| is_in_reach(space, &doors.leaves[*leaf], &whole);
    let gates = |leaf: usize| {
        let there = doors.carry(space, leaf, whole.centre)?.point;
        let own = gate(space, &doors.leaves[leaf], whole.centre)?;
        let far = gate(space, &doors.leaves[1 - leaf], there)?;
        Some((own, far, there))
    };
    let passed: Vec<_> = (0..2).filter(is_reached).filter_map(gates).collect();
    let before = match passed[..] {
        [] => return vec![whole],
        [(own, ..)] => Part::Before(own),
        [(a, ..), (b, ..), ..] => Part::BeforeBoth([a, b]),
    };
    let through = passed.iter().map(|(_, far, there)| Stroke {
        centre: *there,
        part: Part::Through(*far),
        ..whole
    });
    let before = Stroke {
        part: before,
        ..whole
    };
    std::iter::once(before).chain(through).collect()
}

/// Whether the ball of a stroke reaches over a leaf.
fn is_in_reach(space: &dyn Atlas, leaf: &Leaf, stroke: &Stroke) -> bool {
    let near = space.carry_near(stroke.centre, leaf.foot);
    near.is_some_and(|it| {
        let at = leaf.local(it.point.pos);
        let aside_m = (at.z.abs() - HALF_WIDTH_M).max(0.0);
        at.x.hypot(aside_m) < stroke.radius_m
    })
}

/// A leaf's opening in the chart of a stroke's middle.
fn gate(space: &dyn Strategy, leaf: &Leaf, middle: ChartPoint) -> Option<Gate> {
    let crossing = space.carry_near(leaf.foot, middle)?;
    let (way, metre) = leaf.plane(space, &crossing);
    Some(Gate {
        foot: crossing.point.pos,
        heading_rad: way.z.atan2(way.x),
        half_width_m: HALF_WIDTH_M * metre,
        height_m: HEIGHT_M,
    })
}

/// Where a picture from some eye shows the ring about what is dug: at its middle, or, of a ring that reaches over a leaf, where
/// that is taken through it, if it is nearer there.
pub(crate) fn ring_seen(
    space: &dyn Strategy,
    doors: &Doorway,
    eye: &Eye,
    middle: ChartPoint,
    radius_m: f64,
) -> ChartPoint {
    let whole = Stroke {
        centre: middle,
        radius_m,
        amount: 0.0,
        part: Part::Whole,
        kind: None,
        shape: Shape::default(),
        power: None,
    };
    let reached = (0..2).filter(|leaf| is_in_reach(space, &doors.leaves[*leaf], &whole));
    let others = reached.map(|leaf| doors.pictured(space, leaf, eye, middle));
    let away_m = |at: &ChartPoint| space.eye_distance_m(eye, space.view_point(eye, *at));
    let all = std::iter::once(middle).chain(others);
    all.min_by(|a, b| away_m(a).total_cmp(&away_m(b)))
        .unwrap_or(middle)
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
    position.0 = crossing.point;
    body.0.feet = crossing.point.pos;
    look.follow(crossing.turn_rad);
    body.0.velocity = crossing.turn_vector(body.0.velocity);
    Some(lifted_m)
}
