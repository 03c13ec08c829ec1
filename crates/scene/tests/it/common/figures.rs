//! Worlds with other figures for the tests of the scene.
#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "each test program uses its own part, and fails by panicking"
)]

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_scene::bot::BotView;
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use super::{scene, steps};

/// Steps in a second.
pub const SECOND: usize = 60;

/// The ground at some metres from the player in the player's chart; over the rim in the other.
pub fn beside(scene: &Scene, dx: f64, dz: f64) -> ChartPoint {
    let field = scene.field().clone();
    let feet = scene.feet();
    let mut point = feet.moved(DVec3::new(dx, 0.0, dz));
    if let Some(crossing) = scene.strategy().cross(point) {
        point = crossing.point;
    }
    point.pos.y = field.surface_height(point.chart, point.pos.x, point.pos.z) + 0.2;
    point
}

/// Turns of the player's ground plan, radians, 0 first, after which nobody who stands so many metres ahead is behind a rise of the
/// ground.
pub fn open_turns_rad(scene: &Scene, ahead_m: f64) -> Vec<f64> {
    let eye_m = scene.head().point.pos.y;
    let is_open = |turn_rad: &f64| {
        let ground_m = |away_m: f64| beside_turned(scene, *turn_rad, away_m, 0.0).pos.y;
        let belt_m = ground_m(ahead_m) + 0.5;
        (1..20).all(|part| {
            let share = f64::from(part) / 20.0;
            ground_m(ahead_m * share) + 0.3 < eye_m + (belt_m - eye_m) * share
        })
    };
    let turns = (0..16).map(|n| f64::from(n) * std::f64::consts::TAU / 16.0);
    turns.filter(is_open).collect()
}

/// The ground at some metres from the player, ahead by a turn of the ground plan and aside from there.
pub fn beside_turned(scene: &Scene, turn_rad: f64, ahead_m: f64, aside_m: f64) -> ChartPoint {
    let (sin, cos) = turn_rad.sin_cos();
    let (dx, dz) = (ahead_m * cos - aside_m * sin, ahead_m * sin + aside_m * cos);
    beside(scene, dx, dz)
}

pub fn bot(scene: &Scene, id: u32) -> BotView {
    let bots = scene.bots();
    *bots
        .iter()
        .find(|view| view.bot.id == id)
        .expect("it lives")
}

pub fn away_m(scene: &Scene, point: ChartPoint) -> f64 {
    let feet = scene.feet();
    let eye = Eye {
        point: feet,
        ..Eye::default()
    };
    scene.strategy().distance_m(feet, point, &eye)
}

/// Puts the player near the equator of a closed world, in hemisphere A.
pub fn go_to_equator(scene: &mut Scene) {
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    let field = scene.field().clone();
    let x = rim_m - 4.0;
    let y = field.surface_height(ChartId::FIRST, x, 0.0) + 0.2;
    scene.teleport(ChartPoint::a(DVec3::new(x, y, 0.0)));
    steps(scene, SECOND / 2, &Actions::default());
}

/// A world of that kind with the player on the ground, in a closed one by the equator.
pub fn world(geometry: Geometry) -> Scene {
    let mut scene = scene(geometry);
    steps(&mut scene, SECOND / 2, &Actions::default());
    if scene.strategy().is_closed() {
        go_to_equator(&mut scene);
    }
    scene
}

pub fn pass(scene: &mut Scene, seconds: f64) {
    steps(
        scene,
        (seconds * SECOND as f64) as usize,
        &Actions::default(),
    );
}

/// Points the view at a place as the picture shows it.
pub fn look_at(scene: &mut Scene, point: ChartPoint) {
    let eye = scene.eye();
    let view = scene
        .frame(1.3, 1.7, 1)
        .view
        .strategy
        .view_point(&eye, point);
    let way = eye.to_chart(view.truncate().normalize());
    scene.aim(way.z.atan2(way.x), way.y.clamp(-1.0, 1.0).asin());
}

/// Fires the gun once at a figure's middle, and waits for the bullet.
pub fn shoot(scene: &mut Scene, id: u32) {
    let point = bot(scene, id).point.moved(DVec3::Y);
    let gun = Actions {
        slot: Some(0),
        ..Actions::default()
    };
    steps(scene, 1, &gun);
    look_at(scene, point);
    let pull = Actions {
        primary: true,
        ..Actions::default()
    };
    steps(scene, 1, &pull);
    pass(scene, 0.5);
}
