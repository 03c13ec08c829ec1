//! A world of hyperbolic space in squares, played: there is more room in it than in flat land, and the way back is another.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{Actions, Scene, WorldSetup};
use glam::DVec3;

use crate::common::figures::{
    SECOND, away_m, beside_turned, bot, look_at, open_turns_rad, pass, shoot,
};
use crate::common::squares::{HIGH_M, fly, plane_m, world};
use crate::common::{LIMIT, setup, steps};

#[test]
fn four_sides_do_not_close_and_five_do() {
    for (radius_m, side_m, off_m) in [
        (60.305, 20.0, 1.5987),
        (60.305, 64.0, 63.9996),
        (30.152, 20.0, 6.922),
    ] {
        let mut scene = world(radius_m);
        scene.set_flying(true);
        scene.teleport(ChartPoint::a(DVec3::new(3.0, HIGH_M, -2.0)));
        scene.aim(0.4, 0.0);
        assert!(scene.wait_for_step(LIMIT));
        let start = scene.feet();
        let mut apart = Vec::new();
        for _ in 0..5 {
            fly(&mut scene, side_m);
            let yaw = scene.eye().yaw;
            scene.aim(yaw + FRAC_PI_2, 0.0);
            apart.push(plane_m(&scene, start, scene.feet()));
        }
        let radius = scene.strategy().radius_m();
        assert!(
            (apart[3] - off_m).abs() < 0.05,
            "{radius} {side_m}: {apart:?}"
        );
        if side_m == 64.0 {
            assert!(apart[4] < 0.1, "{apart:?}");
            assert_eq!(scene.feet().chart, start.chart);
        }
    }
}

/// In the midst of a square, over an edge and at a corner: a stroke there changes samples of one square, of two and of five.
#[test]
fn a_stroke_is_undone_in_all_squares_that_it_reached() {
    for radius_m in [60.305, 30.152] {
        let mut scene = world(radius_m);
        let half_m = scene.strategy().domain(ChartId::FIRST).half_width_m();
        for [x, z] in [[0.2, 0.1], [0.97, 0.1], [0.95, 0.95]] {
            let [x, z] = [x * half_m, z * half_m];
            let y = scene.field().surface_height(ChartId::FIRST, x, z);
            let place = ChartPoint::a(DVec3::new(x, y + 0.2, z));
            let before = ground_at(&mut scene, place);
            scene.aim(0.3, -1.45);
            let dig = Actions {
                slot: Some(2),
                primary: true,
                ..Actions::default()
            };
            steps(&mut scene, 60, &dig);
            steps(&mut scene, 1, &Actions::default());
            assert!(scene.settle(LIMIT));
            let dug = ground_at(&mut scene, place);
            assert!(dug < before - 0.3, "{x} {z}: {before} {dug}");
            scene.take_hints();
            let undo = Actions {
                undo: true,
                ..Actions::default()
            };
            steps(&mut scene, 1, &undo);
            assert!(scene.settle(LIMIT));
            steps(&mut scene, 2, &Actions::default());
            let after = ground_at(&mut scene, place);
            let hints = scene.take_hints();
            assert!(
                (after - before).abs() < 1e-3,
                "{x} {z}: {hints:?} {before} {after}"
            );
        }
    }
}

/// How far walks lead, metres.
const FAR_WALK_M: f64 = 10_000.0;
/// Where one turns back towards home, radii: numbers end at 77.
const TURNS_BACK_RAD: f64 = 60.0;

/// 10 km by random turns, and back from one turning to the one before as breadcrumbs lead: the same square, and the same hole
/// to the last bit. By headings alone nobody comes back from so far: one that is off by the last of 53 bits misses by
/// `R sinh(d/R)` as much, which is the radius at 37 radii.
fn walk_far_and_back(radius_m: f64, go: fn(&mut Scene, f64)) {
    let mut scene = world(radius_m);
    let (place, dug) = hole(&mut scene);
    scene.set_flying(true);
    scene.teleport(ChartPoint::new(place.chart, place.pos.with_y(HIGH_M)));
    let mut dice = 12_345_u64;
    let mut turnings = vec![scene.feet()];
    let (mut walked_m, mut farthest) = (0.0, 0);
    while walked_m < FAR_WALK_M {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let random = (dice >> 40) as f64 / f64::from(1 << 24);
        let home = scene.bearings().home.unwrap();
        farthest = farthest.max(home.squares);
        let yaw = if home.distance_m > TURNS_BACK_RAD * radius_m {
            home.heading_rad + random
        } else {
            scene.eye().yaw + 3.0 * (random - 0.5)
        };
        scene.aim(yaw, 0.0);
        let way_m = 60.0 + 80.0 * random;
        go(&mut scene, way_m);
        walked_m += way_m;
        turnings.push(scene.feet());
    }
    println!(
        "{radius_m}: {walked_m} m, {} turnings, {farthest} squares off",
        turnings.len()
    );
    assert!(farthest > 30, "{farthest}");
    let strategy = scene.strategy().clone();
    while let Some(to) = turnings.pop() {
        // It is flown past by a step.
        for _ in 0..100 {
            let way = strategy
                .tiled()
                .unwrap()
                .level_way_m(scene.feet(), to)
                .unwrap();
            let way_m = way.with_y(0.0).length();
            if way_m < 0.5 {
                break;
            }
            scene.aim(way.z.atan2(way.x), 0.0);
            go(&mut scene, way_m);
        }
    }
    assert_eq!(scene.feet().chart, ChartId::FIRST);
    let off_m = plane_m(&scene, scene.feet(), place);
    assert!(off_m < 0.6, "{off_m}");
    let found = ground_at(&mut scene, place);
    assert_eq!(found.to_bits(), dug.to_bits());
}

/// Digs a hole; returns where, and how high its ground is.
fn hole(scene: &mut Scene) -> (ChartPoint, f64) {
    let y = scene.field().surface_height(ChartId::FIRST, 9.0, 7.0);
    let place = ChartPoint::a(DVec3::new(9.0, y + 0.2, 7.0));
    let before = ground_at(scene, place);
    scene.aim(0.0, -1.2);
    let dig = Actions {
        slot: Some(2),
        primary: true,
        ..Actions::default()
    };
    steps(scene, 120, &dig);
    assert!(scene.settle(LIMIT));
    let dug = ground_at(scene, place);
    assert!(dug < before - 0.5, "{before} {dug}");
    (place, dug)
}

/// By hops along the geodesic.
#[test]
fn ten_kilometres_by_random_turns_and_back_lead_to_the_same_hole() {
    for radius_m in [60.305, 30.152] {
        walk_far_and_back(radius_m, |scene, way_m| {
            let mut left_m = way_m;
            while left_m > 0.0 {
                let hop_m = left_m.min(30.0);
                left_m -= hop_m;
                let feet = scene.feet();
                let eye = Eye {
                    point: ChartPoint::new(feet.chart, feet.pos.with_y(0.0)),
                    yaw: scene.eye().yaw,
                    ..Eye::default()
                };
                let end = scene.strategy().along(&eye, DVec3::NEG_Z, hop_m);
                let back = scene
                    .strategy()
                    .tiled()
                    .unwrap()
                    .level_way_m(end, feet)
                    .unwrap();
                scene.teleport(ChartPoint::new(end.chart, end.pos.with_y(HIGH_M)));
                scene.aim((-back.z).atan2(-back.x), 0.0);
                scene.step(&Actions::default());
            }
        });
    }
}

/// As bodies fly: each step of 20 km, which takes minutes.
#[test]
#[ignore = "takes minutes"]
fn ten_kilometres_flown_lead_to_the_same_hole() {
    for radius_m in [60.305, 30.152] {
        walk_far_and_back(radius_m, |scene, way_m| {
            let from = scene.feet();
            let slow = (way_m / 8.0).min(1.0);
            let ahead = Actions {
                forward: slow,
                sprint: slow == 1.0,
                ..Actions::default()
            };
            while plane_m(scene, from, scene.feet()) < way_m {
                steps(scene, 1, &ahead);
            }
        });
    }
}

/// How high the ground is where somebody lands at a place, metres.
fn ground_at(scene: &mut Scene, place: ChartPoint) -> f64 {
    scene.teleport(place);
    assert!(scene.settle(LIMIT));
    scene.ground_height().unwrap()
}

/// Ground is dug, and found again by one who has gone round a corner, through five squares, and by one who loads the world.
#[test]
fn a_hole_is_where_it_was_dug_whichever_way_one_comes_back() {
    let mut scene = world(60.305);
    let y = scene.field().surface_height(ChartId::FIRST, 20.0, 20.0);
    let place = ChartPoint::a(DVec3::new(20.0, y + 0.2, 20.0));
    let before = ground_at(&mut scene, place);
    scene.aim(0.0, -1.2);
    let dig = Actions {
        slot: Some(2),
        primary: true,
        ..Actions::default()
    };
    steps(&mut scene, 120, &dig);
    assert!(scene.settle(LIMIT));
    let dug = ground_at(&mut scene, place);
    assert!(dug < before - 0.5, "{before} {dug}");

    scene.set_flying(true);
    scene.teleport(ChartPoint::new(place.chart, place.pos.with_y(HIGH_M)));
    scene.aim(0.4, 0.0);
    let mut charts = BTreeSet::new();
    for _ in 0..5 {
        fly(&mut scene, 64.0);
        charts.insert(scene.feet().chart);
        let yaw = scene.eye().yaw;
        scene.aim(yaw + FRAC_PI_2, 0.0);
    }
    assert!(charts.len() > 3, "{charts:?}");
    let back = scene.feet();
    assert_eq!(back.chart, place.chart);
    assert!(plane_m(&scene, back, place) < 0.1);
    assert_eq!(ground_at(&mut scene, place), dug);
}

/// A world with the player on the ground, so far from the edges of the first square as is told, metres.
fn by_edges(radius_m: f64, from_edges_m: [f64; 2]) -> Scene {
    let setup = WorldSetup {
        radius_m,
        ..setup(Geometry::HyperbolicWorld)
    };
    let mut scene = Scene::open_with(setup, None, 2).unwrap();
    let half_m = scene.strategy().domain(ChartId::FIRST).half_width_m();
    let [x, z] = from_edges_m.map(|it| half_m - it);
    let y = scene.field().surface_height(ChartId::FIRST, x, z) + 0.2;
    scene.teleport(ChartPoint::a(DVec3::new(x, y, z)));
    steps(&mut scene, SECOND / 2, &Actions::default());
    scene
}

/// Each sees the other, keeps his distance, and hits, though both are in squares of their own.
#[test]
fn over_an_edge_and_about_a_corner_one_fights_as_elsewhere() {
    for radius_m in [30.152, 60.305] {
        for from_edges_m in [[2.0, 13.0], [2.0, 2.5]] {
            let mut scene = by_edges(radius_m, from_edges_m);
            let own = scene.feet().chart;
            let turns = open_turns_rad(&scene, 10.0).into_iter();
            let mut over = turns.filter(|it| beside_turned(&scene, *it, 10.0, 0.0).chart != own);
            let turn_rad = over.next().expect("some way over is open");
            let place = beside_turned(&scene, turn_rad, 10.0, 0.0);
            let id = scene.spawn_bot(place, 3.0 + turn_rad, true);
            let there = bot(&scene, id).point;
            look_at(&mut scene, there);
            pass(&mut scene, 0.5);
            shoot(&mut scene, id);
            let told = format!("{radius_m} {from_edges_m:?} {:?}", bot(&scene, id));
            assert!(bot(&scene, id).health < 3.0, "not hit: {told}");
            for second in 0..12 {
                pass(&mut scene, 1.0);
                let away_m = away_m(&scene, bot(&scene, id).point);
                let keeps = second < 3 || (5.5..14.5).contains(&away_m);
                assert!(keeps, "{away_m} m away: {told}");
            }
            assert!(scene.health() < FULL_HEALTH, "never hit: {told}");
        }
    }
}

#[test]
#[ignore = "prints how long steps take in which a hundred fight"]
fn print_steps_of_a_hundred_who_fight() {
    for geometry in [Geometry::Euclidean, Geometry::HyperbolicWorld] {
        let mut scene = Scene::open_with(setup(geometry), None, 2).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        for n in 0..100 {
            let turn_rad = f64::from(n) * 2.4;
            let place = beside_turned(&scene, turn_rad, 8.0 + 0.3 * f64::from(n), 0.0);
            scene.spawn_bot(place, 3.0 + turn_rad, true);
        }
        assert!(scene.wait_for_step(LIMIT));
        let mut took_ms = Vec::new();
        for _ in 0..20 * SECOND {
            scene.set_health(FULL_HEALTH);
            let begun = std::time::Instant::now();
            scene.step(&Actions::default());
            took_ms.push(begun.elapsed().as_secs_f64() * 1e3);
            assert!(scene.wait_for_step(LIMIT));
        }
        took_ms.sort_by(f64::total_cmp);
        let at = |share: f64| took_ms[(share * (took_ms.len() - 1) as f64) as usize];
        let (p50, p99) = (at(0.5), at(0.99));
        println!(
            "{geometry}: p50 {p50:.2} ms, p99 {p99:.2} ms, {} live",
            scene.bots().len()
        );
    }
}

/// Addresses are whole numbers of 128 bits, which end about 78 radii from home.
#[test]
fn at_the_end_of_the_world_one_stops_and_goes_back() {
    let mut scene = world(60.305);
    let space = std::sync::Arc::clone(scene.strategy());
    let eye = Eye::default();
    let ahead = DVec3::new(0.3, 0.0, -0.954).normalize();
    let far = (60..80).map(|n| space.along(&eye, ahead, 60.0 * f64::from(n)));
    let last = far
        .take_while(|at| space.has_chart(at.chart))
        .last()
        .unwrap();
    scene.set_flying(true);
    scene.teleport(ChartPoint::new(last.chart, last.pos.with_y(HIGH_M)));
    assert!(scene.settle(LIMIT));
    assert!(scene.ground_height().is_some(), "there is land");
    let home = |scene: &Scene| scene.bearings().home.unwrap();
    let go = |scene: &mut Scene, from_home: f64, count: usize| {
        scene.aim(home(scene).heading_rad + from_home, 0.0);
        let ahead = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        steps(scene, count, &ahead);
        home(scene)
    };
    let at_end = go(&mut scene, std::f64::consts::PI, 1200);
    let still = go(&mut scene, std::f64::consts::PI, 300);
    let radius_m = space.radius_m();
    assert!(
        at_end.distance_m > 77.0 * radius_m && at_end.squares > 90,
        "{at_end:?}"
    );
    assert!(
        (still.distance_m - at_end.distance_m).abs() < 1.0,
        "{still:?}"
    );
    // The end is ragged: the straight way may lead past it for a moment, and is looked for anew each second.
    for _ in 0..10 {
        go(&mut scene, 0.0, 60);
    }
    let back = home(&scene);
    assert!(
        back.distance_m < at_end.distance_m - 50.0,
        "{at_end:?} {still:?} {back:?}"
    );
}
