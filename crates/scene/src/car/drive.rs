//! One step of the cars: what their drivers ask for, over the equator, out of ground, and with the player at the wheel.

use antipode_geometry::ChartPoint;
use antipode_physics::{Vehicle, VehicleInput, VehicleMotion};
use glam::DVec3;

use super::Cars;
use super::harm::run_over;
use super::tuning::{CRASH_FROM_M_S, CRASH_SHARE, NEEDED_AHEAD_S, NEEDED_AROUND_M, SEAT_M};
use crate::actions::Actions;
use crate::actors::Actors;
use crate::ground::chunks_near;
use crate::harm::{HarmKind, fall_harm, hurt_player};
use crate::outbox::Outbox;
use crate::player::{Body, Player, Position};
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;
use crate::world::World;

/// How far below bedrock the wheels of a car may reach, in metres.
const WHEELS_BELOW_M: f64 = 0.5;

/// Moves all cars by one step, and the player who sits in one.
pub(crate) fn step(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let cars = &mut actors.cars;
    if cars.states.is_empty() {
        return;
    }
    put_free(world, cars);
    let inputs = inputs(world, cars, actions);
    cars.vehicles.step(&world.physics, &inputs, STEP_S);
    keep_between_limits(world, cars);
    cross(world, cars);
    run_over(world, actors, player, outbox);
    seat_driver(world, actors, player, outbox, actions);
}

/// What is asked of each car; nothing where its ground is not there, which holds it.
fn inputs(world: &World, cars: &Cars, actions: &Actions) -> Vec<Option<VehicleInput>> {
    let input = |number: usize| {
        let car = cars.view(world, number)?;
        let reach_m = NEEDED_AROUND_M + NEEDED_AHEAD_S * car.velocity.length();
        let is_ready = !cars.states[number].unplaced && is_firm_around(world, car.point, reach_m);
        is_ready.then(|| {
            if car.driven {
                VehicleInput {
                    throttle: actions.forward,
                    steer: actions.strafe,
                    brake: actions.jump,
                    boost: actions.sprint,
                    parked: false,
                }
            } else {
                VehicleInput {
                    parked: true,
                    ..VehicleInput::default()
                }
            }
        })
    };
    (0..cars.states.len()).map(input).collect()
}

fn is_firm_around(world: &World, point: ChartPoint, reach_m: f64) -> bool {
    chunks_near(&*world.strategy, point, reach_m)
        .into_iter()
        .all(|coord| world.is_firm(coord))
}

/// Brings cars that were put somewhere, or were built over, to the first free place above.
fn put_free(world: &World, cars: &mut Cars) {
    for (number, car) in cars.views(world).into_iter().enumerate() {
        let hemisphere = car.point.hemisphere;
        let origin = world.strategy.chart_origin_m(hemisphere);
        let solid = |at: DVec3| {
            world
                .ground
                .is_solid(ChartPoint::new(hemisphere, at - origin))
        };
        let is_buried = solid(cars.vehicles.middle(number).unwrap_or_default());
        if !(cars.states[number].unplaced || is_buried)
            || !is_firm_around(world, car.point, NEEDED_AROUND_M)
        {
            continue;
        }
        let ahead = car.turn * DVec3::X;
        let place = car.point.pos + origin;
        let free = cars
            .vehicles
            .upright_at(&world.physics, place, ahead, &solid);
        if let Some(free) = free {
            cars.vehicles.set_motion(number, free);
        }
        cars.states[number].unplaced = false;
    }
}

/// A world has heights that nothing leaves.
fn keep_between_limits(world: &World, cars: &mut Cars) {
    let Some(limits) = world.strategy.limits() else {
        return;
    };
    for number in 0..cars.states.len() {
        let Some(motion) = cars.vehicles.all().get(number).map(Vehicle::motion) else {
            continue;
        };
        let y = motion
            .place
            .y
            .clamp(limits.bedrock_m - WHEELS_BELOW_M, limits.ceiling_m);
        if y != motion.place.y {
            let still = VehicleMotion {
                place: motion.place.with_y(y),
                velocity: motion.velocity.with_y(0.0),
                ..motion
            };
            cars.vehicles.set_motion(number, still);
        }
    }
}

/// Carries cars over the equator whole: place, stance, velocity, spin, and the camera behind the player's own.
fn cross(world: &World, cars: &mut Cars) {
    for (number, car) in cars.views(world).into_iter().enumerate() {
        let Some(crossing) = world.strategy.cross(car.point) else {
            continue;
        };
        let hemisphere = crossing.point.hemisphere;
        let place = crossing.point.pos + world.strategy.chart_origin_m(hemisphere);
        cars.vehicles.carry(number, place, crossing.rotation());
        cars.states[number].hemisphere = hemisphere;
        if let Some(driving) = cars.driving.as_mut().filter(|_| car.driven) {
            driving.chase.carry(&*world.strategy, &crossing);
        }
    }
}

/// The player goes with the car that he sits in, and feels what it runs into.
pub(super) fn seat_driver(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let cars = &mut actors.cars;
    let car = cars.driven(world);
    let (Some(car), Some(driving)) = (car, &mut cars.driving) else {
        return;
    };
    driving.throttle = actions.forward;
    driving
        .chase
        .pass(&car, (actions.look_yaw, actions.look_pitch), STEP_S);
    let (yaw, pitch) = driving.chase.look(player.gaze.camera);
    let vehicle = cars.vehicles.all().get(driving.car);
    let jolt_m_s = vehicle.map_or(0.0, Vehicle::jolt_m_s);
    let seat = car.place(SEAT_M);
    if let Ok((position, body)) = actors
        .ecs
        .query_one_mut::<(&mut Position, &mut Body)>(actors.player)
    {
        position.0 = seat;
        body.0.feet = seat.pos + world.strategy.chart_origin_m(seat.hemisphere);
        body.0.velocity = car.velocity;
        body.0.grounded = true;
    }
    actors.set_look(yaw, pitch);
    if jolt_m_s >= CRASH_FROM_M_S {
        outbox.sounds.push(SoundEvent::Crashed {
            speed_m_s: jolt_m_s,
        });
        let harm = fall_harm(jolt_m_s * CRASH_SHARE, actors.tuning.gravity_m_s2);
        let from = Some(car.turn * DVec3::X);
        hurt_player(actors, player, outbox, harm, HarmKind::Crash, from);
    }
}
