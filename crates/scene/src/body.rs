//! Keeps the player's body within the world and out of the ground.

use antipode_geometry::{Atlas, ChartId, ChartPoint};
use antipode_physics::Character;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

use crate::actors::Actors;
use crate::car::doors::get_out;
use crate::player::{Body, Player, Position};
use crate::tuning::FARTHEST_M;
use crate::world::World;

/// A body that is put down at rest, no higher than this above the ground, stands there at once, in metres.
const SET_DOWN_M: f64 = 0.75;
/// Gap left below the feet of a body that is put on the surface, in metres.
const CLEARANCE_M: f64 = 0.15;

/// Height over the feet from which ground is looked for below, and how far below the untouched surface it makes a hole, metres.
const HEAD_M: f64 = 1.5;
const FALL_M: f64 = 2.0;
/// Nor may there be one so far from the feet, metres.
const BRINK_M: f64 = 1.5;
/// Where firm ground is looked for beside a hole: so many rings so far apart, metres, in so many ways each.
const FIRM_RINGS: u32 = 12;
const RING_M: f64 = 3.0;
const WAYS: u32 = 8;

/// What of the player is moved.
type Parts<'a> = (&'a mut Position, &'a mut Body);

/// Puts the player's body somewhere, within the world; one in rock leads to the free ground above as soon as that is
/// loaded.
pub(crate) fn place(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    point: ChartPoint,
    velocity: DVec3,
    grounded: bool,
) {
    let point = within_world(&*world.strategy, point);
    if let Ok((position, body)) = actors.ecs.query_one_mut::<Parts<'_>>(actors.player) {
        position.0 = point;
        body.0 = Character::at(point.pos);
        body.0.velocity = velocity;
        body.0.grounded = grounded;
    }
    player.body_unchecked = true;
}

/// Puts the player's body at rest somewhere, out of a car.
pub(crate) fn teleport(world: &World, actors: &mut Actors, player: &mut Player, point: ChartPoint) {
    get_out(actors, &mut player.gaze);
    place(world, actors, player, point, DVec3::ZERO, false);
}

/// Lifts a walking body that is stuck: any overlap with the ground after it was put somewhere, a body whose
/// middle is in rock at any time. To be called when the ground around the body is there.
/// Returns whether the body was moved.
pub(crate) fn free(world: &World, actors: &mut Actors, player: &mut Player) -> bool {
    let is_afoot = !player.flying && !actors.cars.is_driving();
    if !is_afoot || !(player.body_unchecked || is_buried(world, actors)) {
        return false;
    }
    player.body_unchecked = false;
    if player.stands_up {
        let firm = firm_place(world, actors);
        player.stands_up = firm.is_some();
        if let Some(firm) = firm {
            teleport(world, actors, player, firm);
            return true;
        }
    }
    let lifted = lift_out(world, actors, player) || raise_to_surface(world, actors, player);
    // The way up may have ended in ground that was not there yet.
    player.body_unchecked = lifted;
    if !lifted {
        set_down(world, actors);
    }
    lifted
}

/// Lifts the player out of ground that was built over it, as far as a lift reaches.
pub(crate) fn lift_out(world: &World, actors: &mut Actors, player: &Player) -> bool {
    if player.flying || actors.cars.is_driving() {
        return false;
    }
    let Ok((position, body)) = actors.ecs.query_one_mut::<Parts<'_>>(actors.player) else {
        return false;
    };
    let chart = position.0.chart;
    let solid = |at: DVec3| world.ground.is_solid(ChartPoint::new(chart, at));
    body.0.feet = position.0.pos;
    let lifted = world
        .physics
        .for_bodies(&*world.strategy, chart)
        .lift_out_sized(&mut body.0, &actors.tuning, &solid);
    if lifted {
        position.0.pos = body.0.feet;
    }
    lifted
}

/// The surface nearest to the player where nobody has dug deep, if that below or just beside has been dug away.
fn firm_place(world: &World, actors: &Actors) -> Option<ChartPoint> {
    let is_hole = |at: ChartPoint| {
        let surface_m = world.ground.untouched_height(at);
        let feet = ChartPoint::new(at.chart, at.pos.with_y(surface_m + CLEARANCE_M));
        let ground_m = world.ground_height(feet.moved(DVec3::Y * HEAD_M));
        let is_hole = ground_m.is_none_or(|ground_m| surface_m - ground_m > FALL_M);
        (feet, is_hole)
    };
    // Nor at the brink of one.
    let falls_from = |at: ChartPoint| {
        let (feet, falls) = is_hole(at);
        let mut beside = [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z].into_iter();
        let falls = falls || beside.any(|way| is_hole(at.moved(way * BRINK_M)).1);
        (feet, falls)
    };
    let (here, falls) = falls_from(actors.feet());
    if !falls || is_buried(world, actors) {
        return None;
    }
    let places = (1..=FIRM_RINGS * WAYS).map(|n| {
        let way = DVec2::from_angle(f64::from(n % WAYS) * TAU / f64::from(WAYS));
        let off = way * (RING_M * f64::from(n.div_ceil(WAYS)));
        within_world(&*world.strategy, here.moved(DVec3::new(off.x, 0.0, off.y)))
    });
    let mut firm = places.map(falls_from).filter(|(_, falls)| !falls);
    firm.next().map(|(feet, _)| feet)
}

/// Stands a body on the ground that it was put over.
fn set_down(world: &World, actors: &mut Actors) {
    let Ok((position, body)) = actors.ecs.query_one_mut::<Parts<'_>>(actors.player) else {
        return;
    };
    if body.0.grounded || body.0.velocity != DVec3::ZERO {
        return;
    }
    body.0.feet = position.0.pos;
    let ground = world.physics.for_bodies(&*world.strategy, position.0.chart);
    let lands = ground.set_down(&mut body.0, &actors.tuning, SET_DOWN_M);
    if lands {
        position.0.pos = body.0.feet;
    }
}

/// Puts a buried body that no lift can free on the surface of its column.
fn raise_to_surface(world: &World, actors: &mut Actors, player: &mut Player) -> bool {
    let feet = actors.feet();
    let surface_m = world.ground.untouched_height(feet) + CLEARANCE_M;
    if !is_buried(world, actors) || surface_m <= feet.pos.y {
        return false;
    }
    let pos = DVec3::new(feet.pos.x, surface_m, feet.pos.z);
    let surface = ChartPoint::new(feet.chart, pos);
    teleport(world, actors, player, surface);
    true
}

fn is_buried(world: &World, actors: &Actors) -> bool {
    let mut middle = actors.feet();
    middle.pos.y += 0.5 * actors.tuning.height_m;
    world.ground.is_solid(middle)
}

/// The point itself where it lies in the world, else one on the world's border; the middle for what is no place.
pub(crate) fn within_world(strategy: &dyn Atlas, point: ChartPoint) -> ChartPoint {
    let mut point = point;
    if !point.pos.is_finite() {
        point.pos = DVec3::ZERO;
    }
    if !strategy.has_chart(point.chart) {
        point.chart = ChartId::FIRST;
    }
    let edge_m = strategy.domain(point.chart).half_width_m();
    let axis_m = point.pos.x.hypot(point.pos.z);
    if axis_m > 2.0 * edge_m {
        let share = edge_m / axis_m;
        point.pos.x *= share;
        point.pos.z *= share;
    } else if let Some(crossing) = strategy.cross(point) {
        point = crossing.point;
    }
    let farthest = DVec3::splat(FARTHEST_M);
    point.pos = point.pos.clamp(-farthest, farthest);
    if let Some(limits) = strategy.limits() {
        point.pos.y = point.pos.y.clamp(limits.bedrock_m, limits.ceiling_m);
    }
    point
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, strategy};

    use super::*;

    #[test]
    fn a_place_in_the_world_is_left_as_it_is() {
        for (geometry, pos) in [
            (Geometry::Euclidean, DVec3::new(-7.5e8, 12.0, 3.25)),
            (Geometry::Hyperbolic, DVec3::new(1e6, -12.0, 3.25)),
            (Geometry::Spherical, DVec3::new(-30.0, 9.0, 12.0)),
        ] {
            let space = strategy(geometry, 32.0);
            assert_eq!(
                within_world(&*space, ChartPoint::a(pos)),
                ChartPoint::a(pos)
            );
        }
    }

    #[test]
    fn a_place_outside_comes_to_the_border_and_no_place_to_the_middle() {
        let flat = strategy(Geometry::Euclidean, 0.0);
        let far = ChartPoint::new(ChartId::SECOND, DVec3::new(1e300, -1e12, 5.0));
        let border = ChartPoint::a(DVec3::new(FARTHEST_M, -FARTHEST_M, 5.0));
        assert_eq!(within_world(&*flat, far), border);
        let nowhere = ChartPoint::a(DVec3::new(f64::NAN, 1.0, f64::INFINITY));
        assert_eq!(within_world(&*flat, nowhere).pos, DVec3::ZERO);
        let sphere = strategy(Geometry::Spherical, 32.0);
        let (rim_m, limits) = (
            sphere.domain(ChartId::FIRST).radius_m().unwrap_or(0.0),
            sphere.limits(),
        );
        for pos in [
            DVec3::new(0.0, 1e8, 0.0),
            DVec3::new(1e9, -4.0, 1e9),
            DVec3::new(rim_m + 9.0, 8.0, 0.0),
        ] {
            let inside = within_world(&*sphere, ChartPoint::a(pos)).pos;
            assert!(inside.x.hypot(inside.z) <= rim_m + 1e-9, "{inside}");
            assert!(limits.is_some_and(|l| (l.bedrock_m..=l.ceiling_m).contains(&inside.y)));
        }
        let over = within_world(&*sphere, ChartPoint::a(DVec3::new(rim_m + 9.0, 8.0, 0.0)));
        assert_eq!(over.chart, ChartId::SECOND);
    }
}
