//! Getting in and out of a car, setting it upright, its lights and its horn.

use antipode_geometry::ChartPoint;
use glam::{DQuat, DVec3};

use super::camera::Chase;
use super::tuning::{
    DOOR_DROP_M, DOOR_RISE_M, DOORS_M, HORN_REACH_M, IN_VIEW, JUMPED_OFF_SHARE, REACH_M,
};
use super::{CarView, Driving};
use crate::actions::Actions;
use crate::camera::CameraMode;
use crate::harm::{HarmKind, fall_harm};
use crate::notice::Hint;
use crate::npc::sees;
use crate::player::Look;
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;

/// Height of a car's middle over the ground, in metres.
const MIDDLE_UP_M: f64 = 0.8;
/// Height just over its roof, in metres: a way to the roof itself would end at the body.
const ROOF_UP_M: f64 = 1.7;
/// The box that holds a car's body, in its axes, in metres.
const BODY_BOX_M: (DVec3, DVec3) = (DVec3::new(-1.52, 0.30, -0.70), DVec3::new(1.52, 1.49, 0.70));
/// Gap left below the feet of who gets out, in metres.
const CLEARANCE_M: f64 = 0.02;

/// A car lies whose own upward way has less than this of the world's, slower than this in m/s, for so long in seconds.
const LIES_BELOW: f64 = 0.5;
const LIES_M_S: f64 = 1.0;
const LIES_S: f64 = 1.2;

/// A car in view that is no farther than this is meant by who wants to get in, in metres.
const CALLS_M: f64 = 25.0;

impl Scene {
    /// Does what was asked for with a car.
    pub(crate) fn use_doors(&mut self, actions: &Actions) {
        match self.driven_number() {
            None if actions.enter_car => self.enter_car(),
            Some(_) if actions.leave_car => self.leave_car(),
            _ => {}
        }
        if actions.flip_car {
            self.flip_car();
        }
        if actions.horn
            && let Some(car) = self.driven_car()
        {
            self.outbox.sounds.push(SoundEvent::Horn);
            self.scare(car.point, HORN_REACH_M);
        }
        self.tell_of_fallen_car();
    }

    /// Tells a driver whose car has come to lie on its side or roof.
    fn tell_of_fallen_car(&mut self) {
        let lies = self.driven_car().is_some_and(|car| {
            (car.turn * DVec3::Y).y < LIES_BELOW && car.velocity.length() < LIES_M_S
        });
        if let Some(driving) = &mut self.actors.cars.driving {
            let before_s = driving.lies_s;
            driving.lies_s = if lies { before_s + STEP_S } else { 0.0 };
            if before_s < LIES_S && driving.lies_s >= LIES_S {
                self.outbox.hints.push(Hint::FallenOver);
            }
        }
    }

    /// Switches the lights of the car that the player drives.
    pub(crate) fn toggle_car_lights(&mut self, number: usize) {
        if let Some(state) = self.actors.cars.states.get_mut(number) {
            state.lights = !state.lights;
        }
    }

    fn enter_car(&mut self) {
        if self.player.flying {
            return;
        }
        let Some(number) = self.car_in_reach(true) else {
            self.outbox.hints.push(self.why_no_car());
            return;
        };
        let before = self.shown.camera;
        self.take_wheel(number);
        self.shown.camera = CameraMode::Third;
        if let Some(driving) = &mut self.actors.cars.driving {
            driving.camera_before = before;
        }
        self.outbox.sounds.push(SoundEvent::CarDoor);
        self.outbox.hints.push(Hint::AtTheWheel);
        self.seat_driver(&Actions::default());
    }

    /// Puts the player at the wheel of a car.
    pub(crate) fn take_wheel(&mut self, number: usize) {
        let Some(car) = self.car(number) else {
            return;
        };
        self.actors.cars.driving = Some(Driving {
            car: number,
            chase: Chase::behind(&car),
            camera_before: CameraMode::First,
            throttle: 0.0,
            lies_s: 0.0,
        });
        self.actors.cars.vehicles.wake(number);
    }

    /// The nearest car that the player can reach; with `seen`, of those in view.
    fn car_in_reach(&self, seen: bool) -> Option<usize> {
        self.car_within(REACH_M, seen)
    }

    /// What keeps the player from getting into a car.
    fn why_no_car(&self) -> Hint {
        if self.car_in_reach(false).is_some() {
            Hint::LookAtCar
        } else if self
            .car_within(CALLS_M, true)
            .is_some_and(|it| self.sees_car(it))
        {
            Hint::CarTooFar
        } else {
            Hint::NoCarNear
        }
    }

    /// Whether nothing hides a car's roof.
    fn sees_car(&self, number: usize) -> bool {
        let optics = self.aiming();
        let pictured = &*optics.strategy;
        self.car(number).is_some_and(|car| {
            let over_roof = car.place(DVec3::Y * ROOF_UP_M);
            sees(pictured, &self.world.physics, &self.head(), over_roof)
        })
    }

    fn car_within(&self, reach_m: f64, seen: bool) -> Option<usize> {
        let head = self.head();
        let feet = self.feet();
        let optics = self.aiming();
        let pictured = &*optics.strategy;
        let distance_m = |car: &CarView| pictured.distance_m(feet, car.point, &head);
        self.cars()
            .iter()
            .enumerate()
            .filter(|(_, car)| !seen || is_in_view(pictured.view_point(&head, middle(car))))
            .map(|(number, car)| (distance_m(car), number))
            .filter(|(far_m, _)| *far_m <= reach_m)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, number)| number)
    }

    fn leave_car(&mut self) {
        let Some(car) = self.driven_car() else {
            return;
        };
        let Some(spot) = self.free_spot(&car) else {
            self.outbox.hints.push(Hint::NoWayOut);
            return;
        };
        self.get_out();
        self.place_body(spot, car.velocity, false);
        self.outbox.sounds.push(SoundEvent::CarDoor);
        let harm = fall_harm(
            car.velocity.length() * JUMPED_OFF_SHARE,
            self.actors.tuning.gravity_m_s2,
        );
        self.hurt_player(harm, HarmKind::Fall, None);
    }

    /// The player sits in no car any more, wherever he is then put.
    pub(crate) fn get_out(&mut self) {
        let Some(driving) = self.actors.cars.driving.take() else {
            return;
        };
        let (yaw, _) = driving.chase.look(self.shown.camera);
        self.shown.camera = driving.camera_before;
        if let Ok(mut look) = self.actors.ecs.get::<&mut Look>(self.actors.player) {
            *look = Look {
                yaw: 0.0,
                pitch: 0.0,
            };
            look.turn(yaw, 0.0);
        }
    }

    /// Where one can stand beside a car: on ground about as high, clear of all that is solid, with nothing between.
    fn free_spot(&self, car: &CarView) -> Option<ChartPoint> {
        let hemisphere = car.point.hemisphere;
        let origin = self.world.strategy.chart_origin_m(hemisphere);
        let level = DQuat::from_rotation_y(-car.yaw());
        let inside = middle(car).pos + origin;
        let (height_m, radius_m) = (self.actors.tuning.height_m, self.actors.tuning.radius_m);
        DOORS_M.into_iter().find_map(|door| {
            let beside = car.point.pos + origin + level * door;
            let from = beside + DVec3::Y * (DOOR_RISE_M + radius_m);
            let way = from - inside;
            let shut = self
                .world
                .physics
                .cast_ray(inside, way, way.length())
                .is_some();
            if shut || self.is_rock(from - origin, car) {
                return None;
            }
            let most_m = DOOR_RISE_M + DOOR_DROP_M;
            let down_m = self
                .world
                .physics
                .cast_sphere(from, DVec3::NEG_Y, radius_m, most_m)?;
            // On the roof one stands on the car and not on the ground below it.
            let on_roof = door.y > 0.0;
            let down_m = if on_roof {
                down_m.min(DOOR_RISE_M)
            } else {
                down_m
            };
            let feet = from - DVec3::Y * (down_m + radius_m - CLEARANCE_M);
            let is_free = (on_roof || !self.is_within(car, feet - origin))
                && !self
                    .world
                    .physics
                    .overlaps_capsule(feet, height_m, radius_m)
                && !self.is_rock(feet - origin + DVec3::Y * (0.5 * height_m), car);
            is_free.then(|| self.within_world(ChartPoint::new(hemisphere, feet - origin)))
        })
    }

    fn is_rock(&self, pos: DVec3, car: &CarView) -> bool {
        self.world
            .ground
            .is_solid(ChartPoint::new(car.point.hemisphere, pos))
    }

    /// Sets the car that the player sits in or stands beside on its wheels, its heading kept.
    fn flip_car(&mut self) {
        let Some(number) = self.driven_number().or_else(|| self.car_in_reach(false)) else {
            return;
        };
        let Some(car) = self.car(number) else {
            return;
        };
        let origin = self.world.strategy.chart_origin_m(car.point.hemisphere);
        let solid = |at: DVec3| self.is_rock(at - origin, &car);
        let vehicles = &self.actors.cars.vehicles;
        if let Some(upright) = vehicles.upright(number, &self.world.physics, &solid) {
            self.actors.cars.vehicles.set_motion(number, upright);
            self.make_way(number);
        }
    }

    /// Puts a player on foot beside a car that was set upright about him.
    fn make_way(&mut self, number: usize) {
        let feet = self.feet();
        let Some(car) = self.car(number) else { return };
        let is_caught = !self.is_driving()
            && feet.hemisphere == car.point.hemisphere
            && self.is_within(&car, feet.pos);
        if let Some(spot) = self.free_spot(&car).filter(|_| is_caught) {
            self.place_body(spot, DVec3::ZERO, false);
        }
    }

    /// Whether who stands with the feet at a place of a car's chart would be in the car, however it lies.
    fn is_within(&self, car: &CarView, feet: DVec3) -> bool {
        let (low_m, high_m) = (
            self.actors.tuning.radius_m,
            self.actors.tuning.height_m - self.actors.tuning.radius_m,
        );
        (0..=4).any(|part| {
            let up_m = low_m + (high_m - low_m) * f64::from(part) / 4.0;
            let own = car.turn.inverse() * (feet + DVec3::Y * up_m - car.point.pos);
            let (low, high) = BODY_BOX_M;
            own.distance(own.clamp(low, high)) < self.actors.tuning.radius_m
        })
    }
}

fn middle(car: &CarView) -> ChartPoint {
    car.place(DVec3::Y * MIDDLE_UP_M)
}

/// Whether a point in view coordinates is about in the picture.
fn is_in_view(view: glam::DVec4) -> bool {
    let (aside, up) = IN_VIEW;
    view.z < 0.0 && view.x.abs() <= aside * -view.z && view.y.abs() <= up * -view.z
}
