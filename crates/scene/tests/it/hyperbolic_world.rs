//! A world of hyperbolic space in squares, played: there is more room in it than in flat land, and the way back is another.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_scene::survey::Survey;
use antipode_scene::{Actions, Generator, NpcMode, Scene, WorldSetup};
use glam::DVec3;

use crate::common::{LIMIT, setup, steps};

/// High over the land, where nothing is in the way, metres.
const HIGH_M: f64 = 40.0;

fn world(radius_m: f64) -> Scene {
    let setup = WorldSetup {
        generator: Generator::Planted,
        radius_m,
        ..setup(Geometry::HyperbolicWorld)
    };
    let mut scene = Scene::open_with(setup, None, 2).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.set_npcs(NpcMode::Off);
    scene
}

/// How far two places are apart on the plane, metres.
fn plane_m(scene: &Scene, a: ChartPoint, b: ChartPoint) -> f64 {
    let foot = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
    scene
        .strategy()
        .distance_m(foot(a), foot(b), &Eye::default())
}

/// Flies straight on for so many metres of the plane.
fn fly(scene: &mut Scene, way_m: f64) {
    let from = scene.feet();
    let ahead = |forward| Actions {
        forward,
        ..Actions::default()
    };
    while plane_m(scene, from, scene.feet()) < way_m - 1.0 {
        steps(scene, 1, &ahead(1.0));
    }
    // The last metre is gone ever slower.
    for _ in 0..600 {
        let left_m = way_m - plane_m(scene, from, scene.feet());
        let share = left_m.clamp(-0.2, 0.2);
        steps(scene, 1, &ahead(share));
    }
    let off_m = plane_m(scene, from, scene.feet()) - way_m;
    assert!(off_m.abs() < 0.01, "{off_m}");
}

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

#[test]
fn the_compass_leads_home() {
    let mut scene = world(60.305);
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(DVec3::new(0.0, HIGH_M, 0.0)));
    scene.aim(0.4, 0.0);
    assert!(scene.wait_for_step(LIMIT));
    for way_m in [100.0, 120.0] {
        fly(&mut scene, way_m);
        let yaw = scene.eye().yaw;
        scene.aim(yaw + 1.0, 0.0);
    }
    let home = scene.bearings().home.unwrap();
    assert!(home.squares >= 3, "{home:?}");
    scene.aim(home.heading_rad, 0.0);
    fly(&mut scene, home.distance_m);
    let there = scene.bearings().home.unwrap();
    assert!(there.squares == 0 && there.distance_m < 0.1, "{there:?}");
}

#[test]
fn the_map_shows_the_edges_of_squares_five_of_which_meet_at_a_corner() {
    let mut scene = world(60.305);
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(DVec3::new(31.9, HIGH_M, 31.9)));
    assert!(scene.wait_for_step(LIMIT));
    let map = Survey::default().look(&scene, 1, 1);
    let away_m = |end: [f32; 2]| end[0].hypot(end[1]);
    let ends = map.edges.iter().flatten();
    assert!(
        ends.clone()
            .all(|end| f64::from(away_m(*end)) <= map.reach_m)
    );
    let corner = ends.filter(|end| away_m(**end) < 1.0);
    assert_eq!(corner.count(), 5);
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
