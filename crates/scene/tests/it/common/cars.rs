//! Worlds with a car, and its driver.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a helper of tests fails by panicking"
)]

use antipode_geometry::Geometry;
use antipode_scene::{Actions, CarView, Scene};
use glam::DVec3;

use super::{LIMIT, scene, steps};

pub fn still() -> Actions {
    Actions::default()
}

pub fn ahead() -> Actions {
    Actions {
        forward: 1.0,
        ..still()
    }
}

pub fn enter() -> Actions {
    Actions {
        enter_car: true,
        ..still()
    }
}

/// A world with its first car, which has come to rest.
pub fn with_car(geometry: Geometry) -> Scene {
    rested(scene(geometry))
}

fn rested(mut scene: Scene) -> Scene {
    scene.give_first_car();
    steps(&mut scene, 150, &still());
    scene
}

pub fn car(scene: &Scene) -> CarView {
    scene.cars()[0]
}

/// Puts the player so many metres to the car's left, and looks at it.
pub fn stand_beside(scene: &mut Scene, far_m: f64) {
    go_beside(scene, far_m);
    assert!(scene.wait_for_step(LIMIT));
    steps(scene, 60, &still());
    look_at_car(scene);
}

/// Puts the player so many metres to the car's left.
pub fn go_beside(scene: &mut Scene, far_m: f64) {
    let car = car(scene);
    let left = (car.turn * DVec3::NEG_Z).with_y(0.0).normalize();
    scene.teleport(car.point.moved(left * far_m + DVec3::Y * 0.3));
}

/// Turns the view to the car.
pub fn look_at_car(scene: &mut Scene) {
    let way = car(scene).point.pos - scene.feet().pos;
    scene.aim(way.z.atan2(way.x), -0.2);
}

/// A player at the wheel of a car at rest.
pub fn driving(geometry: Geometry) -> Scene {
    at_the_wheel(scene(geometry))
}

/// A player at the wheel of the first car of a world that is just made.
pub fn at_the_wheel(scene: Scene) -> Scene {
    let geometry = scene.setup().geometry;
    let mut scene = rested(scene);
    stand_beside(&mut scene, 2.0);
    steps(&mut scene, 1, &enter());
    assert!(scene.is_driving(), "{geometry:?} {:?}", scene.take_hints());
    steps(&mut scene, 10, &still());
    scene
}
