//! One step of the cars: what their drivers ask for, over the edges of charts, out of ground, and with the player at the wheel.

use antipode_geometry::{ChartPoint, Crossing, pace};
use antipode_physics::{VehicleDoors, VehicleInput, VehicleMotion, VehiclePhysics};
use glam::DVec3;

use super::bushes;
use super::damage::run_over;
use super::tuning::{CRASH_FROM_M_S, CRASH_SHARE, NEEDED_AHEAD_S, NEEDED_AROUND_M, SEAT_M};
use super::{Car, Cars};
use crate::actions::Actions;
use crate::actors::{Actors, all_mut};
use crate::damage::{DamageKind, fall_damage, hurt_player};
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
    let Cars {
        physics, driving, ..
    } = &mut actors.cars;
    let mut cars = all_mut::<Car>(&mut actors.ecs);
    if cars.is_empty() {
        return;
    }
    let driven = driving.as_ref().map(|driving| driving.car);
    let before: Vec<_> = cars.iter().map(|(_, car)| car.point()).collect();
    let vehicles = cars.iter_mut().map(|(id, car)| {
        car.put_free(world, physics);
        let input = car.input(world, actions, driven == Some(*id));
        (&mut car.vehicle, input)
    });
    let mut vehicles: Vec<_> = vehicles.collect();
    let doors = world.doors.as_ref().map(|pair| VehicleDoors {
        atlas: &*world.strategy,
        pair,
    });
    physics.step(&world.physics, doors.as_ref(), &mut vehicles, STEP_S);
    for ((id, car), before) in cars.into_iter().zip(before) {
        car.keep_between_limits(world, physics);
        let crossing = car.cross(world, physics, before);
        if let (Some(crossing), Some(driving)) = (crossing, driving.as_mut())
            && driving.car == id
        {
            driving.chase.carry(&*world.strategy, &crossing);
        }
    }
    bushes::go_through(world, actors, outbox);
    run_over(world, actors, player, outbox);
    seat_driver(world, actors, player, outbox, actions);
}

impl Car {
    /// What is asked of it; nothing where its ground is not there, which holds it.
    fn input(&self, world: &World, actions: &Actions, driven: bool) -> Option<VehicleInput> {
        let speed_m_s = self.vehicle.motion().velocity.length();
        let reach_m = NEEDED_AROUND_M + NEEDED_AHEAD_S * speed_m_s;
        let is_firm = |at: ChartPoint| world.is_firm_around(at, reach_m);
        let beyond = world.beyond_door(self.point());
        if self.unplaced || !is_firm(self.point()) || !beyond.is_none_or(is_firm) {
            return None;
        }
        Some(if driven {
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
        })
    }

    /// Brings one that was put somewhere, or was built over, to the first free place above.
    fn put_free(&mut self, world: &World, physics: &mut VehiclePhysics) {
        let (motion, point) = (self.vehicle.motion(), self.point());
        let solid = |at: DVec3| world.ground.is_solid(ChartPoint::new(motion.chart, at));
        if !(self.unplaced || solid(motion.middle()))
            || !world.is_firm_around(point, NEEDED_AROUND_M)
        {
            return;
        }
        let free = physics.upright_at(&world.physics, point, motion.ahead(), &solid);
        if let Some(free) = free {
            physics.set_motion(&mut self.vehicle, free);
        }
        self.unplaced = false;
    }

    /// A world has heights that nothing leaves.
    fn keep_between_limits(&mut self, world: &World, physics: &mut VehiclePhysics) {
        let Some(limits) = world.strategy.limits() else {
            return;
        };
        let motion = self.vehicle.motion();
        let lowest_m = limits.bedrock_m - WHEELS_BELOW_M;
        let y = motion.place.y.clamp(lowest_m, limits.ceiling_m);
        if y != motion.place.y {
            let still = VehicleMotion {
                place: motion.place.with_y(y),
                velocity: motion.velocity.with_y(0.0),
                ..motion
            };
            physics.set_motion(&mut self.vehicle, still);
        }
    }

    /// Carries it through a door or over an edge of its chart whole: place, stance, velocity and spin.
    fn cross(
        &mut self,
        world: &World,
        physics: &mut VehiclePhysics,
        before: ChartPoint,
    ) -> Option<Crossing> {
        let (space, motion) = (&*world.strategy, self.vehicle.motion());
        let door = world.through_door_whole(before, motion.point());
        let crossing = door.or_else(|| space.cross(motion.point()))?;
        physics.carry(&mut self.vehicle, &crossing);
        if door.is_some() {
            let pace = pace::share(space, motion.point(), &crossing, motion.velocity);
            physics.hasten(&mut self.vehicle, pace);
        }
        Some(crossing)
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
    let car = actors.driven_car();
    let (Some(car), Some(driving)) = (car, &mut actors.cars.driving) else {
        return;
    };
    driving.throttle = actions.forward;
    let along = world.strategy.in_chart(car.point, car.velocity);
    driving.chase.pass(&car, along, actions.look_turn(), STEP_S);
    let (yaw, pitch) = driving.chase.look(player.gaze.camera);
    let jolt_m_s = actors.map_one(car.id, |car: &Car| car.vehicle.jolt_m_s());
    let jolt_m_s = jolt_m_s.unwrap_or_default();
    let seat = car.place(SEAT_M);
    if let Ok((position, body)) = actors
        .ecs
        .query_one_mut::<(&mut Position, &mut Body)>(actors.player)
    {
        position.0 = seat;
        body.0.feet = seat.pos;
        body.0.velocity = car.velocity;
        body.0.grounded = true;
    }
    actors.set_look(yaw, pitch);
    if jolt_m_s >= CRASH_FROM_M_S {
        outbox.sounds.push(SoundEvent::Crashed {
            speed_m_s: jolt_m_s,
        });
        let damage = fall_damage(jolt_m_s * CRASH_SHARE, actors.tuning.gravity_m_s2);
        let from = Some(car.turn * DVec3::X);
        hurt_player(actors, player, outbox, damage, DamageKind::Crash, from);
    }
}
