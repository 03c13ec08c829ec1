//! Who walks a closed world is as fast as the probe says at every place and in every direction, and its heading leads along a great
//! circle.

use std::f64::consts::{FRAC_PI_2, TAU};

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use crate::common::{LIMIT, scene, steps};

const RADIUS_M: f64 = 32.0;
const WALK_M_S: f64 = 4.5;

fn forward() -> Actions {
    Actions {
        forward: 1.0,
        ..Actions::default()
    }
}

/// Someone who has been walking for half a second, at the n-th of places all over the world and along a heading of its own.
fn walk(scene: &mut Scene, n: u32) {
    let share = |ratio: f64| (f64::from(n) * ratio).fract();
    let level_m = (1.0 - share(0.618_034)).acos() * RADIUS_M;
    let (z, x) = (share(0.754_878) * TAU).sin_cos();
    let chart = [ChartId::FIRST, ChartId::SECOND][n as usize % 2];
    let (x, z) = (x * level_m, z * level_m);
    let y = scene.field().surface_height(chart, x, z);
    scene.teleport(ChartPoint::new(chart, DVec3::new(x, y + 0.2, z)));
    scene.aim(share(0.569_840) * TAU, 0.0);
    assert!(scene.wait_for_step(LIMIT));
    steps(scene, 30, &forward());
}

/// How far the level way between two places is at the height of the first, in metres of the space.
fn level_m(scene: &Scene, from: ChartPoint, to: ChartPoint) -> f64 {
    let foot = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
    let plane_m = scene
        .strategy()
        .distance_m(foot(from), foot(to), &Eye::default());
    plane_m * (from.pos.y / RADIUS_M).cos()
}

#[test]
fn a_walk_over_the_land_is_as_fast_everywhere() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_npcs(NpcMode::Off);
    let mut free = 0;
    for n in 1..=50 {
        walk(&mut scene, n);
        let (mut gone_m, mut is_free) = (0.0, true);
        for _ in 0..20 {
            let before = scene.feet();
            steps(&mut scene, 1, &forward());
            gone_m += level_m(&scene, before, scene.feet());
            let [x, _, z] = scene.probe().player.vel;
            is_free &= scene.probe().player.grounded && (x.hypot(z) - WALK_M_S).abs() < 1e-6;
        }
        // Others run against a rock or jump off a step.
        if is_free {
            free += 1;
            let speed_m_s = 3.0 * gone_m;
            assert!(
                (speed_m_s / WALK_M_S - 1.0).abs() < 0.005,
                "{n} at {:?}: {speed_m_s}",
                scene.feet()
            );
        }
    }
    assert!(free >= 40, "{free} of 50 walks were free");
}

/// High over the land, where nothing is in the way: a quarter round the world the player looks along the great circle on which it
/// set out.
#[test]
fn a_heading_is_kept_over_a_quarter_of_the_world() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_npcs(NpcMode::Off);
    scene.set_flying(true);
    for n in 1..=8 {
        walk(&mut scene, n);
        let start = ChartPoint::new(scene.feet().chart, scene.feet().pos.with_y(20.0));
        scene.teleport(start);
        steps(&mut scene, 30, &forward());
        let look = |scene: &Scene| Eye {
            point: ChartPoint::new(scene.feet().chart, scene.feet().pos.with_y(0.0)),
            yaw: scene.eye().yaw,
            ..Eye::default()
        };
        let from = look(&scene);
        let turned_rad = |scene: &Scene| {
            let view = scene.strategy().view_point(&from, look(scene).point);
            (-view.z / RADIUS_M).atan2(view.w)
        };
        while turned_rad(&scene) < FRAC_PI_2 - 0.02 {
            steps(&mut scene, 1, &forward());
        }
        // What was the way ahead is the way back now, and no side of it is nearer.
        let here = look(&scene);
        let aside = scene.strategy().view_point(&from, here.point).x / RADIUS_M;
        let back = scene.strategy().view_point(&here, from.point);
        let off_rad = back.x.atan2(back.z);
        assert!(aside.abs() < 1e-6, "{n}: {aside} rad aside");
        assert!(
            off_rad.abs() < 0.1_f64.to_radians(),
            "{n}: looks {off_rad} rad off its way"
        );
    }
}

/// Who hangs in the air and flies no more falls, as anywhere.
#[test]
fn who_stops_flying_falls_and_is_not_put_down() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_flying(true);
    let start = scene.feet().moved(DVec3::Y * 5.0);
    scene.teleport(start);
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 10, &Actions::default());
    scene.set_flying(false);
    steps(&mut scene, 2, &Actions::default());
    assert!(start.pos.y - scene.feet().pos.y < 0.1, "{:?}", scene.feet());
    assert!(!scene.probe().player.grounded);
}
