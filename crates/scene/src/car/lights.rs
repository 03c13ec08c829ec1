//! Shows cars: bodies and wheels as figures, the driver at the wheel, and their lights.

use glam::{DQuat, DVec3};

use super::CarView;
use super::tuning::{HEAD_LIGHT_M, SEAT_M, TAIL_LIGHT_M};
use crate::frame::{BeamLight, Figure, LampLight, ModelId};
use crate::frame::{Clip, Posture};
use crate::moment::{Lit, Who};
use crate::situation::Situation;

/// Colour times strength of a head light: nearly white.
const HEAD_COLOUR: [f32; 3] = [7.0, 6.6, 5.6];
/// Where it has faded away, in metres.
const HEAD_RANGE_M: f64 = 45.0;
/// Angles from its middle within which it is full, and outside which there is none, radians.
const HEAD_CONE_RAD: (f64, f64) = (0.24, 0.55);
/// How far down head lights point, and outwards, as tangents.
const HEAD_DOWN: f64 = 0.10;
const HEAD_OUT: f64 = 0.06;
/// Colour times strength of the tail lights, and of the brake lights.
const TAIL_COLOUR: [f32; 3] = [0.16, 0.009, 0.006];
const BRAKE_COLOUR: [f32; 3] = [0.85, 0.043, 0.027];
/// Where they have faded away, in metres.
const TAIL_RANGE_M: f64 = 3.0;
const BRAKE_RANGE_M: f64 = 5.0;
/// Left and right.
const SIDES: [f64; 2] = [-1.0, 1.0];
/// Cars whose lights are shown, the player's first.
const MOST_LIT_CARS: usize = 6;

/// Bodies and wheels of all cars.
pub(crate) fn show_cars(now: Situation<'_>, seen: &mut Vec<(Who, Figure)>) {
    for car in now.actors.car_views() {
        let figure = |model, own: DVec3, turn: DQuat| Figure {
            turn,
            level: car.level,
            ..Figure::standing(model, car.place(own), 0.0)
        };
        let body = Figure {
            lights: car.lights,
            brakes: car.brakes,
            ..figure(ModelId::CarBody, DVec3::ZERO, car.turn)
        };
        seen.push((Who::Car(car.id), body));
        for (number, wheel) in car.wheels.iter().enumerate() {
            let model = if number % 2 == 0 {
                ModelId::CarWheelLeft
            } else {
                ModelId::CarWheelRight
            };
            let turn = car.turn
                * DQuat::from_rotation_y(-wheel.steer_rad)
                * DQuat::from_rotation_z(-wheel.roll_rad);
            seen.push((Who::Wheel(car.id, number), figure(model, wheel.hub, turn)));
        }
    }
}

/// Seats the player's own figure in the car that is driven.
pub(crate) fn seat_figure(now: Situation<'_>, figure: &mut Figure) {
    let Some(car) = now.actors.driven_car() else {
        return;
    };
    figure.point = car.place(SEAT_M);
    figure.turn = car.turn;
    figure.level = car.level;
    figure.posture = Posture::of(Clip::Sit, 0.0);
    figure.held = None;
    figure.flashes = false;
}

/// Beams of the head lights, and the glow of the lights behind.
pub(crate) fn car_lights(now: Situation<'_>) -> Lit {
    let mut cars = now.actors.car_views();
    cars.retain(|car| car.lights || car.brakes);
    cars.sort_by_key(|car| !car.driven);
    cars.truncate(MOST_LIT_CARS);
    let beams = cars
        .iter()
        .filter(|car| car.lights)
        .flat_map(|car| {
            SIDES.map(|side| (Who::CarLight(car.id, side > 0.0), head_light(car, side)))
        })
        .collect();
    let glows = cars
        .iter()
        .flat_map(|car| {
            SIDES.map(|side| (Who::CarLight(car.id, side > 0.0), tail_light(car, side)))
        })
        .collect();
    Lit {
        lamps: glows,
        beams,
    }
}

fn beside(place: DVec3, side: f64) -> DVec3 {
    DVec3::new(place.x, place.y, place.z * side)
}

fn head_light(car: &CarView, side: f64) -> BeamLight {
    let way = DVec3::new(1.0, -HEAD_DOWN, HEAD_OUT * side).normalize();
    BeamLight {
        point: car.place(beside(HEAD_LIGHT_M, side)),
        direction: car.level.in_chart(car.turn * way).normalize(),
        colour: HEAD_COLOUR,
        range_m: HEAD_RANGE_M,
        cone_rad: HEAD_CONE_RAD,
        behind: None,
    }
}

fn tail_light(car: &CarView, side: f64) -> LampLight {
    let (colour, range_m) = if car.brakes {
        (BRAKE_COLOUR, BRAKE_RANGE_M)
    } else {
        (TAIL_COLOUR, TAIL_RANGE_M)
    };
    LampLight {
        point: car.place(beside(TAIL_LIGHT_M, side)),
        colour,
        range_m,
    }
}
