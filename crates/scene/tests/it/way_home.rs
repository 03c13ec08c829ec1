//! What leads one home in a world in squares: compass, maps, breadcrumbs, and flags whose angles are told.

use std::f64::consts::TAU;

use antipode_geometry::{ChartPoint, Eye, equilateral_angle_sum_rad};
use antipode_scene::survey::{Extent, Survey};
use antipode_scene::{Item, Scene};
use glam::{DVec2, DVec3, Vec3Swizzles};

use crate::common::LIMIT;
use crate::common::squares::{HIGH_M, fly, world};

#[test]
fn home_is_where_one_began() {
    let mut scene = world(60.305);
    assert!(scene.wait_for_step(LIMIT));
    let begun = scene.feet();
    assert!(begun.pos.xz().length() > 1.0, "that is not the middle");
    let away_m = |scene: &Scene| scene.bearings().home.unwrap().distance_m;
    assert!(away_m(&scene) < 0.1, "{} m", away_m(&scene));
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(begun.pos.with_y(HIGH_M)));
    assert!(scene.wait_for_step(LIMIT));
    fly(&mut scene, 20.0);
    assert!((15.0..25.0).contains(&away_m(&scene)));
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
    let map = Survey::default().look(&scene, 1, Extent::Near, 1);
    let away_m = |end: [f32; 2]| end[0].hypot(end[1]);
    let ends = map.edges.iter().flatten();
    assert!(
        ends.clone()
            .all(|end| f64::from(away_m(*end)) <= map.reach_m)
    );
    let corner = ends.filter(|end| away_m(**end) < 1.0);
    assert_eq!(corner.count(), 5);
}

/// Also where it lies aside: of a conformal map that is true of every corner.
#[test]
fn on_the_large_map_five_squares_meet_at_equal_angles_at_every_corner() {
    let mut scene = world(60.305);
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(DVec3::new(9.0, HIGH_M, -4.0)));
    assert!(scene.wait_for_step(LIMIT));
    let map = Survey::default().look(&scene, 1, Extent::Wide, 1);
    assert!((map.reach_m - 2.0 * 60.305).abs() < 1e-2);
    let place = |end: [f32; 2]| DVec2::new(end[0].into(), end[1].into());
    let mut corners: Vec<(DVec2, Vec<f64>)> = Vec::new();
    for [from, to] in map.edges.iter().map(|piece| piece.map(place)) {
        assert!(from.length() < map.reach_m && to.length() < map.reach_m);
        for (from, to) in [(from, to), (to, from)] {
            let way = to - from;
            let heading = way.y.atan2(way.x);
            match corners.iter_mut().find(|it| it.0.distance(from) < 1e-3) {
                Some(found) => found.1.push(heading),
                None => corners.push((from, vec![heading])),
            }
        }
    }
    // Farther off an edge is few pieces, each a chord of its arc.
    corners.retain(|(at, headings)| headings.len() == 5 && at.length() < 78.0);
    assert!(corners.len() >= 4, "{}", corners.len());
    for (at, mut headings) in corners {
        headings.sort_by(f64::total_cmp);
        let next = headings.iter().cycle().skip(1);
        for (from, to) in headings.iter().zip(next) {
            let degrees = (to - from).rem_euclid(TAU).to_degrees();
            assert!((degrees - 72.0).abs() < 6.0, "{at}: {degrees}");
        }
    }
}

/// Three flags, each a square's width from the others.
#[test]
fn who_looks_from_flag_to_flag_is_told_the_angles() {
    for (radius_m, sum_deg) in [(60.305, 155.48), (30.152, 108.00)] {
        let mut scene = world(radius_m);
        scene.set_flying(true);
        let strategy = scene.strategy().clone();
        let first = ChartPoint::a(DVec3::new(3.0, 0.0, 5.0));
        let eye = |point| Eye {
            point,
            ..Eye::default()
        };
        let apart = equilateral_angle_sum_rad(strategy.curvature().per_m2(), 64.0) / 3.0;
        let ways = [0.2, 0.2 + apart].map(|turn: f64| DVec3::new(turn.sin(), 0.0, -turn.cos()));
        let others = ways.map(|way| strategy.along(&eye(first), way, 64.0));
        let flags = [first, others[0], others[1]];
        for flag in flags {
            let foot = ChartPoint::new(flag.chart, flag.pos.with_y(20.0));
            assert!(scene.spawn_flag(foot, 0.0, ""));
        }
        scene.teleport(ChartPoint::new(first.chart, first.pos.with_y(HIGH_M)));
        assert!(scene.wait_for_step(LIMIT));
        scene.aim(2.0, 0.0);
        assert_eq!(scene.sighting(), None, "nowhere in particular");
        let way = scene.flag_ways()[1].clone();
        scene.aim(way.heading_rad + 0.05, 0.0);
        let found = scene.sighting().unwrap();
        let sum = found.angles_rad.iter().sum::<f64>().to_degrees();
        assert!((sum - sum_deg).abs() < 0.05, "{radius_m}: {sum}");
        assert!(
            found.sides_m.iter().all(|side| (side - 64.0).abs() < 1e-6),
            "{found:?}"
        );
    }
}

/// One lays breadcrumbs round bends, over edges of squares, and is led back to the first.
#[test]
fn breadcrumbs_lead_back_the_way_one_came() {
    let mut scene = world(60.305);
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(DVec3::new(3.0, HIGH_M, 5.0)));
    scene.aim(0.3, 0.0);
    assert!(scene.wait_for_step(LIMIT));
    let begun = scene.feet();
    for bend in [0.9, -0.7, 1.6, -0.4, 0.8] {
        for _ in 0..5 {
            let at = scene.feet();
            let foot = ChartPoint::new(at.chart, at.pos.with_y(20.0));
            assert!(scene.put_up(Item::Crumb, foot, 0.0, ""));
            fly(&mut scene, 8.0);
        }
        let yaw = scene.eye().yaw;
        scene.aim(yaw + bend, 0.0);
    }
    assert_ne!(scene.feet().chart, begun.chart);
    let mut legs = 0;
    while let Some(way) = scene.way_back() {
        scene.aim(way.heading_rad, 0.0);
        fly(&mut scene, 2.0);
        legs += 1;
        assert!(legs < 160, "{way:?}");
    }
    let home = scene.strategy().tiled().unwrap();
    let gap = home.level_way_m(scene.feet(), begun).unwrap();
    assert!(gap.with_y(0.0).length() < 7.5, "{gap}");
}
