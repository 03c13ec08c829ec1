//! Ways through land of several biomes: who runs straight on and jumps now and then gets on, comes home round a closed world,
//! and finds level ground to build on.

use std::f64::consts::{SQRT_2, TAU};

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_scene::{Actions, Generator, NpcMode, Scene, WorldSetup};
use glam::{DVec2, DVec3};

use crate::common::{LIMIT, setup};

/// How fast a sprint is, m/s, and how long it is, seconds.
const SPRINT_M_S: f64 = 4.5 * 1.7;
const SPRINT_S: u32 = 60;
/// This near its start one is home, metres.
const HOME_M: f64 = 8.0;
/// Seeds that nothing was tuned by.
const UNSEEN: u64 = 7_000;

/// A number, 0 to 1, of a seed and a count: the finaliser of SplitMix64.
fn chance(seed: u64, n: u64) -> f64 {
    let z = (seed << 20 ^ n).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// A world with nobody else in it.
fn world(geometry: Geometry, radius_m: f64, seed: u64) -> Scene {
    let setup = WorldSetup {
        seed,
        radius_m,
        generator: Generator::Climates,
        mode: antipode_scene::Mode::default(),
        view_distance: 1,
        ..setup(geometry)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    scene.set_npcs(NpcMode::Off);
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// A step of a sprint with a jump each second.
fn run_on(scene: &mut Scene, step: u32) {
    scene.step(&Actions {
        forward: 1.0,
        sprint: true,
        jump: step % 60 < 4,
        ..Actions::default()
    });
    assert!(scene.wait_for_step(LIMIT));
}

/// How far a minute leads from where a seed puts the player, as a share of what it would on a plane, and whether high rock was
/// on the way.
fn minute(seed: u64) -> (f64, bool) {
    let mut scene = world(Geometry::Euclidean, 20.0, seed);
    let at = DVec2::new(chance(seed, 1) - 0.5, chance(seed, 2) - 0.5) * 4000.0;
    let height_m = scene.field().surface_height(ChartId::FIRST, at.x, at.y);
    scene.teleport(ChartPoint::a(DVec3::new(at.x, height_m + 0.2, at.y)));
    scene.aim(chance(seed, 3) * TAU, 0.0);
    assert!(scene.wait_for_step(LIMIT));
    let from = scene.feet().pos;
    let mut rock = false;
    for step in 0..60 * SPRINT_S {
        run_on(&mut scene, step);
        rock |= scene.biome() == "crags";
    }
    let gone = scene.feet().pos - from;
    let share = gone.x.hypot(gone.z) / (SPRINT_M_S * f64::from(SPRINT_S));
    (share, rock)
}

/// How near to its start a sprint round a closed world comes, metres, in a ninth more time than it would take on a plane.
fn round(radius_m: f64, seed: u64) -> f64 {
    let mut scene = world(Geometry::Spherical, radius_m, seed);
    scene.aim(chance(seed, 3) * TAU, 0.0);
    let home = scene.feet();
    let time_s = TAU * radius_m / SPRINT_M_S / 0.9 + 2.0;
    let steps = (60.0 * time_s) as u32;
    let mut nearest_m = f64::INFINITY;
    for step in 0..steps {
        run_on(&mut scene, step);
        if step > steps / 2 {
            let away_m = scene
                .strategy()
                .distance_m(scene.feet(), home, &Eye::default());
            nearest_m = nearest_m.min(away_m);
        }
    }
    nearest_m
}

/// Whether a square of 30 m about a place is level to 10 degrees, as its heights each 3 m have it.
fn is_level(scene: &Scene, middle: DVec2, turn: f64) -> bool {
    const STEP_M: f64 = 3.0;
    let steepest = 10.0_f64.to_radians().tan();
    let axis = DVec2::from_angle(turn);
    let height = |i: i32, k: i32| {
        let by = axis * f64::from(i) + axis.perp() * f64::from(k);
        let at = middle + by * STEP_M;
        scene.field().surface_height(ChartId::FIRST, at.x, at.y)
    };
    let mut before = [0.0; 11];
    for i in -5..=5 {
        let row: [f64; 11] = std::array::from_fn(|k| height(i, k as i32 - 5));
        let along = row.windows(2).map(|it| (it[1] - it[0]).abs());
        let across = row.iter().zip(before).map(|(a, b)| (a - b).abs());
        let rise = along.zip(across.chain([0.0])).map(|(a, b)| {
            let across = if i > -5 { b } else { 0.0 };
            a.hypot(across)
        });
        if rise.fold(0.0, f64::max) > steepest * STEP_M {
            return false;
        }
        before = row;
    }
    true
}

/// Whether a level square lies within 300 m of where a seed begins.
fn has_level_square(seed: u64) -> bool {
    let scene = world(Geometry::Euclidean, 20.0, seed);
    let from = DVec2::new(scene.feet().pos.x, scene.feet().pos.z);
    let reach_m = 300.0 - 15.0 * SQRT_2;
    (0..1500).any(|n| {
        let radius_m = reach_m * chance(seed, 2 * n + 10).sqrt();
        let at = from + DVec2::from_angle(chance(seed, 2 * n + 11) * TAU) * radius_m;
        is_level(&scene, at, chance(seed, n) * TAU)
    })
}

fn told(name: &str, passed: usize, all: usize) {
    println!("{name}: {passed} of {all}");
    assert!(10 * passed >= 9 * all, "{name}: {passed} of {all}");
}

fn minutes(seeds: std::ops::Range<u64>) {
    let tries: Vec<_> = seeds.map(minute).collect();
    let passed = |with_rock: bool| {
        let shares = tries.iter().filter(|it| it.1 == with_rock);
        let count = shares.clone().filter(|it| it.0 >= 0.9).count();
        (count, shares.count())
    };
    let (passed_rock, rock) = passed(true);
    println!("minutes of sprint through high rock: {passed_rock} of {rock}");
    println!("{tries:.2?}");
    let (passed, all) = passed(false);
    told("minutes of sprint outside of high rock", passed, all);
}

fn rounds(radii_m: &[f64], seeds: std::ops::Range<u64>) {
    for &radius_m in radii_m {
        let nearest: Vec<_> = seeds.clone().map(|seed| round(radius_m, seed)).collect();
        println!("{nearest:.1?}");
        let home = nearest.iter().filter(|it| **it < HOME_M).count();
        told(&format!("home round {radius_m} m"), home, nearest.len());
    }
}

#[test]
fn a_minute_of_sprint_gets_on_along_any_heading() {
    minutes(UNSEEN..UNSEEN + 12);
}

#[test]
fn straight_on_leads_home_round_closed_worlds() {
    rounds(&[16.0, 32.0, 64.0], UNSEEN..UNSEEN + 10);
}

#[test]
fn there_is_level_ground_to_build_on() {
    let count = (UNSEEN..UNSEEN + 12)
        .filter(|seed| has_level_square(*seed))
        .count();
    println!("starts with a level square within 300 m: {count} of 12");
    assert!(3 * count >= 2 * 12, "{count}");
}

#[test]
#[ignore = "prints the numbers of many tries; takes minutes"]
fn print_many_ways() {
    minutes(UNSEEN + 100..UNSEEN + 160);
    let level = (UNSEEN + 100..UNSEEN + 140)
        .filter(|seed| has_level_square(*seed))
        .count();
    println!("starts with a level square within 300 m: {level} of 40");
    rounds(
        &[16.0, 24.0, 32.0, 64.0, 128.0, 256.0],
        UNSEEN + 100..UNSEEN + 110,
    );
}
