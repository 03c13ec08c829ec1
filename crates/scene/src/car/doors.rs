//! Getting in and out of a car, setting it upright, its lights and its horn.

use antipode_geometry::ChartPoint;
use antipode_physics::CharacterTuning;
use glam::{DQuat, DVec3};

use super::camera::Chase;
use super::tuning::{DOOR_DROP_M, DOOR_RISE_M, DOORS_M, HORN_REACH_M, JUMPED_OFF_SHARE, REACH_M};
use super::{Car, CarView, Driving, drive};
use crate::actions::Actions;
use crate::actors::{ActorId, Actors, one_mut};
use crate::aimed::Gaze;
use crate::body;
use crate::camera::CameraMode;
use crate::crosshair::Crosshair;
use crate::damage::{DamageKind, fall_damage, hurt_player};
use crate::notice::Hint;
use crate::npc::scare;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::player::Player;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;
use crate::world::World;

/// Height just over its roof, in metres: a way to the roof itself would end at the body.
const ROOF_UP_M: f64 = 1.7;
/// The box that holds a car's body, in its axes, in metres.
const BODY_BOX_M: (DVec3, DVec3) = (DVec3::new(-1.52, 0.30, -0.70), DVec3::new(1.52, 1.49, 0.70));
/// Gap below the feet of a driver who gets out, in metres.
const CLEARANCE_M: f64 = 0.02;

/// A car lies whose own upward way has less than this of the world's, slower than this in m/s, for so long in seconds.
const LIES_BELOW: f64 = 0.5;
const LIES_M_S: f64 = 1.0;
const LIES_S: f64 = 1.2;

/// A player who wants to get in means a car in view that is no farther than this, in metres.
const CALLS_M: f64 = 25.0;

/// Does what was asked for with a car.
pub(crate) fn step(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    match actors.cars.driven() {
        None if actions.enter_car => enter_car(world, actors, player, outbox),
        Some(_) if actions.leave_car => leave_car(world, actors, player, outbox),
        _ => {}
    }
    if actions.flip_car {
        flip_car(world, actors, player);
    }
    if actions.horn
        && let Some(car) = actors.driven_car()
    {
        outbox.sounds.push(SoundEvent::Horn);
        scare(actors, car.point, HORN_REACH_M);
    }
    tell_of_fallen_car(actors, outbox);
}

/// Tells a driver whose car has come to lie on its side or roof.
fn tell_of_fallen_car(actors: &mut Actors, outbox: &mut Outbox) {
    let lies = actors.driven_car().is_some_and(|car| {
        (car.turn * DVec3::Y).y < LIES_BELOW && car.velocity.length() < LIES_M_S
    });
    if let Some(driving) = &mut actors.cars.driving {
        let before_s = driving.lies_s;
        driving.lies_s = if lies { before_s + STEP_S } else { 0.0 };
        if before_s < LIES_S && driving.lies_s >= LIES_S {
            outbox.hints.push(Hint::FallenOver);
        }
    }
}

/// Switches the lights of a car.
pub(crate) fn toggle_lights(actors: &mut Actors, id: ActorId) {
    if let Some(car) = one_mut::<Car>(&mut actors.ecs, id) {
        car.lights = !car.lights;
    }
}

fn enter_car(world: &World, actors: &mut Actors, player: &mut Player, outbox: &mut Outbox) {
    if player.flying {
        return;
    }
    let now = Situation::of(world, actors, player);
    let crosshair = Crosshair::aimed(now);
    let Some(car) = crosshair.car(REACH_M, true) else {
        outbox.hints.push(why_no_car(&crosshair));
        return;
    };
    take_wheel(actors, &car, player.gaze.camera);
    player.gaze.camera = CameraMode::Third;
    outbox.sounds.push(SoundEvent::CarDoor);
    outbox.hints.push(Hint::AtTheWheel);
    drive::seat_driver(world, actors, player, outbox, &Actions::default());
}

/// Puts the player at the wheel of a car; `camera_before` is from where the world is seen again on foot.
pub(crate) fn take_wheel(actors: &mut Actors, car: &CarView, camera_before: CameraMode) {
    actors.cars.driving = Some(Driving {
        car: car.id,
        chase: Chase::behind(car),
        camera_before,
        throttle: 0.0,
        lies_s: 0.0,
    });
    if let Some(car) = one_mut::<Car>(&mut actors.ecs, car.id) {
        car.vehicle.wake();
    }
}

/// What keeps the player from getting into a car.
fn why_no_car(crosshair: &Crosshair<'_>) -> Hint {
    let is_seen = |car: CarView| crosshair.sees(car.place(DVec3::Y * ROOF_UP_M));
    if crosshair.car(REACH_M, false).is_some() {
        Hint::LookAtCar
    } else if crosshair.car(CALLS_M, true).is_some_and(is_seen) {
        Hint::CarTooFar
    } else {
        Hint::NoCarNear
    }
}

fn leave_car(world: &World, actors: &mut Actors, player: &mut Player, outbox: &mut Outbox) {
    let Some(car) = actors.driven_car() else {
        return;
    };
    let Some(spot) = free_spot(world, &actors.tuning, &car) else {
        outbox.hints.push(Hint::NoWayOut);
        return;
    };
    get_out(actors, &mut player.gaze);
    let velocity = car.velocity;
    body::place(world, actors, player, spot, velocity, false);
    outbox.sounds.push(SoundEvent::CarDoor);
    let damage = fall_damage(
        velocity.length() * JUMPED_OFF_SHARE,
        actors.tuning.gravity_m_s2,
    );
    hurt_player(actors, player, outbox, damage, DamageKind::Fall, None);
}

/// The player sits in no car any more, wherever he is then put.
pub(crate) fn get_out(actors: &mut Actors, gaze: &mut Gaze) {
    let Some(driving) = actors.cars.driving.take() else {
        return;
    };
    let (yaw, _) = driving.chase.look(gaze.camera);
    gaze.camera = driving.camera_before;
    actors.set_look(yaw, 0.0);
}

/// Where one can stand beside a car: on ground about as high, clear of all that is solid, with nothing between.
fn free_spot(world: &World, tuning: &CharacterTuning, car: &CarView) -> Option<ChartPoint> {
    let chart = car.point.chart;
    let physics = world.physics.chart(chart);
    let bodies = world.physics.for_bodies(&*world.strategy, chart);
    let level = DQuat::from_rotation_y(-car.yaw());
    let inside = car.middle().pos;
    let (height_m, radius_m) = (tuning.height_m, tuning.radius_m);
    DOORS_M.into_iter().find_map(|door| {
        let beside = car.point.pos + car.level.in_chart(level * door);
        let from = beside + DVec3::Y * (DOOR_RISE_M + radius_m);
        let way = from - inside;
        let shut = physics.cast_ray(inside, way, way.length()).is_some();
        if shut || is_rock(world, from, car) {
            return None;
        }
        let most_m = DOOR_RISE_M + DOOR_DROP_M;
        let down_m = physics.cast_sphere(from, DVec3::NEG_Y, radius_m, most_m)?;
        // On the roof one stands on the car and not on the ground below it.
        let on_roof = door.y > 0.0;
        let down_m = if on_roof {
            down_m.min(DOOR_RISE_M)
        } else {
            down_m
        };
        let feet = from - DVec3::Y * (down_m + radius_m - CLEARANCE_M);
        let is_free = (on_roof || !is_within(tuning, car, feet))
            && !bodies.overlaps_capsule(feet, height_m, radius_m)
            && !is_rock(world, feet + DVec3::Y * (0.5 * height_m), car);
        let spot = ChartPoint::new(chart, feet);
        is_free.then(|| body::within_world(&*world.strategy, spot))
    })
}

fn is_rock(world: &World, pos: DVec3, car: &CarView) -> bool {
    world.ground.is_solid(ChartPoint::new(car.point.chart, pos))
}

/// Sets the car that the player sits in or stands beside on its wheels, its heading kept.
fn flip_car(world: &World, actors: &mut Actors, player: &mut Player) {
    let now = Situation::of(world, actors, player);
    let driven = actors.driven_car();
    let Some(car) = driven.or_else(|| Crosshair::aimed(now).car(REACH_M, false)) else {
        return;
    };
    let solid = |at: DVec3| is_rock(world, at, &car);
    let physics = &mut actors.cars.physics;
    let Some(Car { vehicle, .. }) = one_mut(&mut actors.ecs, car.id) else {
        return;
    };
    if let Some(upright) = physics.upright(&vehicle.motion(), &world.physics, &solid) {
        physics.set_motion(vehicle, upright);
        make_way(world, actors, player, car.id);
    }
}

/// Puts a player on foot beside a car that was set upright about him.
fn make_way(world: &World, actors: &mut Actors, player: &mut Player, id: ActorId) {
    let feet = actors.feet();
    let Some(car) = actors.car_view(id) else {
        return;
    };
    let there = over(&*world.strategy, car.point, feet);
    let is_caught = !actors.cars.is_driving()
        && there.chart == car.point.chart
        && is_within(&actors.tuning, &car, there.pos);
    if is_caught && let Some(spot) = free_spot(world, &actors.tuning, &car) {
        body::place(world, actors, player, spot, DVec3::ZERO, false);
    }
}

/// Whether who stands with the feet at a place of a car's chart would be in the car, however it lies.
fn is_within(tuning: &CharacterTuning, car: &CarView, feet: DVec3) -> bool {
    let radius_m = tuning.radius_m;
    let (low_m, high_m) = (radius_m, tuning.height_m - radius_m);
    (0..=4).any(|part| {
        let up_m = low_m + (high_m - low_m) * f64::from(part) / 4.0;
        let own = car.own(feet + DVec3::Y * up_m);
        let (low, high) = BODY_BOX_M;
        own.distance(own.clamp(low, high)) < radius_m
    })
}
