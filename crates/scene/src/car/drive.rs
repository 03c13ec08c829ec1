//! One step of the cars: what their drivers ask for, over the equator, out of ground, and with the player at the wheel.

use antipode_geometry::ChartPoint;
use antipode_physics::{VehicleInput, VehicleMotion};
use glam::DVec3;

use super::tuning::{CRASH_FROM_M_S, CRASH_SHARE, NEEDED_AHEAD_S, NEEDED_AROUND_M, SEAT_M};
use crate::actions::Actions;
use crate::ground::chunks_near;
use crate::harm::{HarmKind, fall_harm};
use crate::player::{Body, Look, Position};
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;

/// How far below bedrock the wheels of a car may reach, in metres.
const WHEELS_BELOW_M: f64 = 0.5;

impl Scene {
    /// Moves all cars by one step, and the player who sits in one.
    pub(crate) fn step_cars(&mut self, actions: &Actions) {
        if self.actors.cars.states.is_empty() {
            return;
        }
        self.put_cars_free();
        let inputs = self.car_inputs(actions);
        if let Some(car) = self.driven_car() {
            let origin = self.world.strategy.chart_origin_m(car.point.hemisphere);
            self.world.physics.recentre(car.point.pos + origin);
        }
        self.actors
            .cars
            .vehicles
            .step(&self.world.physics, &inputs, STEP_S);
        self.keep_cars_between_limits();
        self.cross_cars();
        self.run_over();
        self.world
            .physics
            .set_obstacles(self.actors.cars.vehicles.obstacles());
        self.seat_driver(actions);
    }

    /// What is asked of each car; nothing where its ground is not there, which holds it.
    fn car_inputs(&self, actions: &Actions) -> Vec<Option<VehicleInput>> {
        let driven = self.driven_number();
        let input = |number: usize| {
            let car = self.car(number)?;
            let reach_m = NEEDED_AROUND_M + NEEDED_AHEAD_S * car.velocity.length();
            let is_ready = !self.actors.cars.states[number].unplaced
                && chunks_near(&*self.world.strategy, car.point, reach_m)
                    .into_iter()
                    .all(|coord| self.world.is_firm(coord));
            is_ready.then(|| match driven {
                Some(own) if own == number => VehicleInput {
                    throttle: actions.forward,
                    steer: actions.strafe,
                    brake: actions.jump,
                    boost: actions.sprint,
                    parked: false,
                },
                _ => VehicleInput {
                    parked: true,
                    ..VehicleInput::default()
                },
            })
        };
        (0..self.actors.cars.states.len()).map(input).collect()
    }

    /// Brings cars that were put somewhere, or were built over, to the first free place above.
    fn put_cars_free(&mut self) {
        for number in 0..self.actors.cars.states.len() {
            let state = self.actors.cars.states[number];
            let Some(car) = self.car(number) else {
                continue;
            };
            let origin = self.world.strategy.chart_origin_m(state.hemisphere);
            let middle = self.actors.cars.vehicles.middle(number).unwrap_or_default() - origin;
            let is_there = || {
                chunks_near(&*self.world.strategy, car.point, NEEDED_AROUND_M)
                    .into_iter()
                    .all(|coord| self.world.is_firm(coord))
            };
            let is_buried = self
                .world
                .ground
                .is_solid(ChartPoint::new(state.hemisphere, middle));
            if !(state.unplaced || is_buried) || !is_there() {
                continue;
            }
            let solid = |at: DVec3| {
                self.world
                    .ground
                    .is_solid(ChartPoint::new(state.hemisphere, at - origin))
            };
            let ahead = car.turn * DVec3::X;
            let place = car.point.pos + origin;
            let vehicles = &self.actors.cars.vehicles;
            if let Some(free) = vehicles.upright_at(&self.world.physics, place, ahead, &solid) {
                self.actors.cars.vehicles.set_motion(number, free);
            }
            self.actors.cars.states[number].unplaced = false;
        }
    }

    /// A world has heights that nothing leaves.
    fn keep_cars_between_limits(&mut self) {
        let Some(limits) = self.world.strategy.limits() else {
            return;
        };
        for number in 0..self.actors.cars.states.len() {
            let Some(vehicle) = self.actors.cars.vehicles.all().get(number) else {
                continue;
            };
            let motion = vehicle.motion();
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
                self.actors.cars.vehicles.set_motion(number, still);
            }
        }
    }

    /// Carries cars over the equator whole: place, stance, velocity, spin, and the camera behind the player's own.
    fn cross_cars(&mut self) {
        let driven = self.driven_number();
        for number in 0..self.actors.cars.states.len() {
            let Some(car) = self.car(number) else {
                continue;
            };
            let Some(crossing) = self.world.strategy.cross(car.point) else {
                continue;
            };
            let hemisphere = crossing.point.hemisphere;
            let place = crossing.point.pos + self.world.strategy.chart_origin_m(hemisphere);
            self.actors
                .cars
                .vehicles
                .carry(number, place, crossing.rotation());
            self.actors.cars.states[number].hemisphere = hemisphere;
            if driven == Some(number)
                && let Some(driving) = &mut self.actors.cars.driving
            {
                driving.chase.carry(&*self.world.strategy, &crossing);
            }
        }
    }

    /// The player goes with the car that he sits in, and feels what it runs into.
    pub(crate) fn seat_driver(&mut self, actions: &Actions) {
        let Some(number) = self.driven_number() else {
            return;
        };
        let Some(car) = self.car(number) else {
            self.actors.cars.driving = None;
            return;
        };
        let jolt_m_s = self
            .actors
            .cars
            .vehicles
            .all()
            .get(number)
            .map_or(0.0, antipode_physics::Vehicle::jolt_m_s);
        let mut sees = None;
        if let Some(driving) = &mut self.actors.cars.driving {
            driving.throttle = actions.forward;
            driving
                .chase
                .pass(&car, (actions.look_yaw, actions.look_pitch), STEP_S);
            sees = Some(driving.chase.look(self.shown.camera));
        }
        let seat = car.place(SEAT_M);
        let origin = self.world.strategy.chart_origin_m(seat.hemisphere);
        if let Ok((position, look, body)) = self
            .actors
            .ecs
            .query_one_mut::<(&mut Position, &mut Look, &mut Body)>(self.actors.player)
        {
            position.0 = seat;
            body.0.feet = seat.pos + origin;
            body.0.velocity = car.velocity;
            body.0.grounded = true;
            if let Some((yaw, pitch)) = sees {
                *look = Look {
                    yaw: 0.0,
                    pitch: 0.0,
                };
                look.turn(yaw, pitch);
            }
        }
        if jolt_m_s >= CRASH_FROM_M_S {
            self.outbox.sounds.push(SoundEvent::Crashed {
                speed_m_s: jolt_m_s,
            });
            let harm = fall_harm(jolt_m_s * CRASH_SHARE, self.actors.tuning.gravity_m_s2);
            self.hurt_player(harm, HarmKind::Crash, Some(car.turn * DVec3::X));
        }
    }
}
