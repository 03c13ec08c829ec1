//! The car at full speed over the equator of a closed world: nothing jerks that would not jerk elsewhere.

use crate::common::cars::{ahead, car, enter, stand_beside, still};
use crate::common::{LIMIT, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_physics::VehicleWheel;
use antipode_scene::{Actions, CarView, Scene};
use glam::{DQuat, DVec3};

/// A car at the wheel of which the player drives towards the equator along that azimuth, turned aside by an angle.
fn bound_for_the_equator(seed: u64, azimuth: f64, aside: f64) -> Scene {
    let mut scene = {
        let setup = antipode_scene::WorldSetup {
            seed,
            ..crate::common::setup(Geometry::Spherical)
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    };
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    let from_m = rim_m - 24.0;
    let out = DVec3::new(azimuth.cos(), 0.0, azimuth.sin());
    let at = ChartPoint::new(ChartId::FIRST, out * from_m + DVec3::Y * 12.0);
    assert!(scene.spawn_car(at, azimuth + aside));
    scene.teleport(at.moved(DVec3::Y * 6.0));
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 120, &still());
    stand_beside(&mut scene, 2.2);
    steps(&mut scene, 1, &enter());
    scene
}

/// Steps about a crossing: the last two in the old chart, the one that ended in the new chart, and the next two.
struct Crossed {
    before: [CarView; 2],
    over: CarView,
    after: [CarView; 2],
    /// The way the chart turned.
    turn_rad: f64,
}

/// Drives until the car has changed charts.
fn cross(scene: &mut Scene, wish: Actions) -> Option<Crossed> {
    let mut before = [car(scene); 2];
    for _ in 0..600 {
        steps(scene, 1, &wish);
        let over = car(scene);
        if over.point.chart != before[1].point.chart {
            let turn_rad = scene
                .strategy()
                .images(before[1].point, f64::INFINITY)
                .pop()?
                .turn_rad;
            let next = |scene: &mut Scene| {
                steps(scene, 1, &wish);
                car(scene)
            };
            let after = [next(scene), next(scene)];
            return Some(Crossed {
                before,
                over,
                after,
                turn_rad,
            });
        }
        before = [before[1], over];
    }
    None
}

/// Whether a wheel's spring comes out so fast that it is about to hang in the air, as over any bump.
fn is_leaving(before: &VehicleWheel, now: &VehicleWheel) -> bool {
    const AIRBORNE_BELOW_M: f64 = 0.02;
    2.0 * now.compression_m - before.compression_m < AIRBORNE_BELOW_M
}

/// How much one thing changes from step to step, and how much that change changes.
fn jerks(crossed: &Crossed) -> (f64, usize, f64) {
    let level = |car: &CarView| car.velocity.length();
    let speeds: Vec<f64> = crossed
        .before
        .iter()
        .chain([&crossed.over])
        .chain(&crossed.after)
        .map(level)
        .collect();
    let changes: Vec<f64> = speeds.windows(2).map(|w| w[1] - w[0]).collect();
    let jerk = changes
        .windows(2)
        .map(|w| (w[1] - w[0]).abs())
        .fold(0.0, f64::max);
    let lost = (0..4)
        .filter(|&i| {
            crossed.before[1].wheels[i].contact
                && crossed.over.wheels[i].contact
                && !crossed.after[0].wheels[i].contact
                && !is_leaving(&crossed.before[1].wheels[i], &crossed.over.wheels[i])
        })
        .count();
    let spring = (0..4)
        .map(|i| {
            (crossed.after[0].wheels[i].compression_m - crossed.over.wheels[i].compression_m).abs()
        })
        .fold(0.0, f64::max);
    (jerk / speeds[1], lost, spring)
}

/// Drives over the equator in many directions on the rough land as it is. Wheels jump there and the body bumps, so what
/// happens in the step of the crossing is held against what happens in every other step.
#[test]
fn over_the_equator_nothing_jerks_that_would_not_jerk_elsewhere() {
    let (mut crossings, mut lost, mut worse) = (0, 0, 0);
    for (seed, azimuth, aside) in [
        (3, 0.89, 0.6),
        (3, 1.67, 0.0),
        (4, 0.89, 0.6),
        (5, 5.59, 0.6),
        (6, 2.46, 0.6),
        (6, 3.24, 0.6),
        (6, 4.03, 0.0),
        (6, 5.59, 0.0),
        (7, 0.10, 0.6),
        (7, 4.81, 0.0),
        (8, 3.24, 0.0),
        (9, 3.24, 0.0),
    ] {
        let mut scene = bound_for_the_equator(seed, azimuth, aside);
        assert!(scene.is_driving(), "{seed} {azimuth}");
        let crossed = cross(&mut scene, ahead()).expect("it gets there");
        let (jerk, gone, _) = jerks(&crossed);
        crossings += 1;
        lost += gone;
        worse += usize::from(jerk > 0.01);
        let heading = |car: &CarView| car.turn * DVec3::X;
        let kept = DQuat::from_rotation_y(crossed.turn_rad) * heading(&crossed.before[1]);
        let turned = kept.dot(heading(&crossed.over)).clamp(-1.0, 1.0).acos();
        assert!(turned < 0.04, "{seed} {azimuth}: {turned} rad in a step");
        let player = scene.feet();
        assert_eq!(player.chart, crossed.over.point.chart);
    }
    assert_eq!((crossings, lost), (12, 0));
    assert!(worse <= 1, "{worse} of {crossings}");
}

/// Whether a wheel lets go of the ground from one step to the next.
fn let_go(before: &CarView, after: &CarView) -> bool {
    let wheels = before.wheels.iter().zip(&after.wheels);
    wheels
        .into_iter()
        .any(|(before, after)| before.contact && !after.contact)
}

/// On rough land wheels let go now and then. They do so no more often in the step over the equator than in others.
#[test]
fn over_the_equator_wheels_let_go_no_more_often_than_elsewhere() {
    let (mut over, mut over_lost, mut other, mut other_lost) = (0, 0, 0, 0);
    for seed in 3..13 {
        for turn in 0..16 {
            let azimuth = 0.1 + std::f64::consts::FRAC_PI_8 * f64::from(turn);
            let aside = if turn % 2 == 0 { 0.0 } else { 0.6 };
            let mut scene = bound_for_the_equator(seed, azimuth, aside);
            if !scene.is_driving() {
                continue;
            }
            let mut last = car(&scene);
            let mut left = 600;
            while left > 0 {
                left -= 1;
                steps(&mut scene, 1, &ahead());
                let now = car(&scene);
                let crosses = now.point.chart != last.point.chart;
                if crosses {
                    // In the step that ends beyond, the wheels still touched the old chart's land.
                    let step = now;
                    steps(&mut scene, 1, &ahead());
                    over += 1;
                    over_lost += usize::from(let_go(&step, &car(&scene)));
                    left = left.min(60);
                } else if now.velocity.length() > 4.0 {
                    other += 1;
                    other_lost += usize::from(let_go(&last, &now));
                }
                last = car(&scene);
            }
        }
    }
    let share = |lost: usize, all: usize| lost as f64 / all as f64;
    let (there, elsewhere) = (share(over_lost, over), share(other_lost, other));
    println!("{over_lost} of {over} steps over the equator, {other_lost} of {other} others");
    assert!(over > 80, "{over}");
    assert!(there < 1.5 * elsewhere, "{there} against {elsewhere}");
}
