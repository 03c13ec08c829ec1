//! The map of the land about the player: as high as the land, as far as the space has it, dug where it was dug.

use crate::common::twins::Twins;
use crate::common::{scene, setup, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::bearings::LandmarkKind;
use antipode_scene::survey::{Extent, PlanNode, Survey, SurveyMap};
use antipode_scene::{Actions, Generator, Scene, WorldSetup};
use glam::{DVec2, DVec3};

const ALL: usize = 100_000;

/// The node that is nearest to metres from the player.
fn node_at(plan: &SurveyMap, at: DVec2) -> PlanNode {
    let off = |node: [f32; 2]| (DVec2::new(node[0].into(), node[1].into()) - at).length();
    let nearest = plan
        .nodes
        .iter()
        .min_by(|a, b| off(a.at).total_cmp(&off(b.at)))
        .unwrap();
    assert!(off(nearest.at) < 4.0, "nothing at {at}");
    *nearest
}

/// Height share of the map at metres from the player.
fn share_at(plan: &SurveyMap, at: DVec2) -> f32 {
    node_at(plan, at).share
}

fn height_m(scene: &Scene, share: f32) -> f64 {
    let field = scene.field().clone();
    let (low, high) = field.ground_range_m();
    low + f64::from(share) * (high - low)
}

/// Area that the patches cover, square metres.
fn covered_m2(plan: &SurveyMap) -> f64 {
    let at = |node: u32| {
        let [x, z] = plan.nodes[node as usize].at;
        DVec2::new(x.into(), z.into())
    };
    let triangle = |a: u32, b: u32, c: u32| (at(b) - at(a)).perp_dot(at(c) - at(a)).abs() / 2.0;
    plan.patches
        .iter()
        .map(|[a, b, c, d]| triangle(*a, *b, *c) + triangle(*b, *d, *c))
        .sum()
}

#[test]
fn the_map_fills_its_circle_everywhere_and_over_the_equator_too() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let rim_m = scene.strategy().domain(ChartId::FIRST).half_width_m();
        for x in [0.0, 31.0, (rim_m - 0.5).min(500.0)] {
            scene.set_flying(true);
            scene.teleport(ChartPoint::a(DVec3::new(x, 30.0, 2.0)));
            steps(&mut scene, 1, &Actions::default());
            for extent in [Extent::Near, Extent::Wide] {
                let plan = Survey::default().look(&scene, 1, extent, ALL);
                let farthest = plan.nodes.iter().map(|it| it.at[0].hypot(it.at[1]));
                let farthest_m = f64::from(farthest.fold(0.0, f32::max));
                assert!(farthest_m <= plan.reach_m + 1e-3);
                let is_disc = geometry == Geometry::HyperbolicWorld && extent == Extent::Wide;
                let least_m = if is_disc { 0.79 } else { 0.999 } * plan.reach_m;
                assert!(farthest_m > least_m, "{geometry} {x}: {farthest_m}");
                let whole = std::f64::consts::PI * farthest_m.powi(2);
                let share = covered_m2(&plan) / whole;
                // Over the equator, and over the edges of squares, strips of both charts may lie on each other.
                let most = if is_disc { 1.4 } else { 1.16 };
                assert!(
                    (0.94..most).contains(&share),
                    "{geometry} {x} {extent:?}: {share}"
                );
            }
        }
    }
}

#[test]
fn heights_are_those_of_the_land_and_a_pit_shows() {
    let mut scene = scene(Geometry::Euclidean);
    steps(&mut scene, 30, &Actions::default());
    let mut survey = Survey::default();
    let plan = survey.look(&scene, 1, Extent::Near, ALL);
    let below = height_m(&scene, share_at(&plan, DVec2::ZERO));
    let feet_m = scene.feet().pos.y;
    assert!((below - feet_m).abs() < 2.5, "{below} {feet_m}");
    assert!(!plan.contours.is_empty());

    scene.aim(0.0, -1.5);
    let dig = Actions {
        primary: true,
        slot: Some(3),
        ..Actions::default()
    };
    steps(&mut scene, 240, &dig);
    steps(&mut scene, 60, &Actions::default());
    let dug_m = feet_m - scene.feet().pos.y;
    assert!(dug_m > 4.0, "{dug_m}");
    for _ in 0..400 {
        survey.look(&scene, 1, Extent::Near, 4);
    }
    let plan = survey.look(&scene, 1, Extent::Near, 4);
    let (pit, land) = (
        node_at(&plan, DVec2::ZERO),
        node_at(&plan, DVec2::splat(20.0)),
    );
    assert!(pit.sky < 0.6 && land.sky > 0.99, "{} {}", pit.sky, land.sky);
    let after = height_m(&scene, pit.share);
    assert!(after < below - 0.5 * dug_m, "{after} after {below}");
}

#[test]
fn it_comes_bit_by_bit_and_is_not_made_anew_where_nobody_moves() {
    let scene = scene(Geometry::Hyperbolic);
    let mut survey = Survey::default();
    let first = survey.look(&scene, 1, Extent::Near, 20);
    let mut last = first.clone();
    for _ in 0..200 {
        last = survey.look(&scene, 1, Extent::Near, 20);
    }
    assert!(first.patches.len() < 20 && last.patches.len() > 600);
    let again = survey.look(&scene, 1, Extent::Near, 20);
    assert!(std::sync::Arc::ptr_eq(&last, &again));
    let elsewhere = survey.look(&scene, 2, Extent::Near, 20);
    assert!(
        elsewhere.patches.len() < 20,
        "another world is surveyed anew"
    );
}

#[test]
fn north_is_where_the_stars_turn_and_keeps_its_place_over_the_equator() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        // At the pole of a closed world the ground may be too steep to stand on.
        scene.teleport(ChartPoint::a(DVec3::Y * 15.0));
        let bearings = scene.bearings();
        assert!((bearings.north_rad.abs() - std::f64::consts::PI).abs() < 1e-9);
        assert_eq!(bearings.equator.is_some(), geometry == Geometry::Spherical);
    }
    let mut scene = scene(Geometry::Spherical);
    scene.set_flying(true);
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    let start = ChartPoint::a(DVec3::new(0.0, 15.0, rim_m - 3.0));
    scene.teleport(start);
    scene.aim(std::f64::consts::FRAC_PI_2, 0.0);
    steps(&mut scene, 1, &Actions::default());
    let ahead = Actions {
        forward: 1.0,
        ..Actions::default()
    };
    let relative = |scene: &Scene| {
        let bearings = scene.bearings();
        (bearings.north_rad - bearings.heading_rad).rem_euclid(std::f64::consts::TAU)
    };
    let mut last = relative(&scene);
    let equator = scene.bearings().equator.unwrap();
    assert!((equator.distance_m - 3.0).abs() < 0.3 && equator.hemisphere == 'A');
    assert!((equator.heading_rad - std::f64::consts::FRAC_PI_2).abs() < 1e-6);
    for _ in 0..90 {
        steps(&mut scene, 1, &ahead);
        let now = relative(&scene);
        assert!(
            (now - last).abs() < 0.05,
            "north jumps from {last} to {now}"
        );
        last = now;
    }
    let equator = scene.bearings().equator.unwrap();
    assert_eq!(equator.hemisphere, 'B');
}

#[test]
fn lamps_and_bots_are_marked_where_they_stand() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_flying(true);
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    scene.teleport(ChartPoint::a(DVec3::new(rim_m - 4.0, 15.0, 0.0)));
    steps(&mut scene, 1, &Actions::default());
    let over = ChartPoint::a(DVec3::new(rim_m + 6.0, 9.0, 0.0));
    let over = scene.strategy().images(over, f64::INFINITY)[0].point;
    assert!(scene.spawn_lamp(over));
    scene.spawn_bot(scene.feet().moved(DVec3::new(-8.0, -3.0, 0.0)), 0.0, true);
    scene.spawn_bot(ChartPoint::a(DVec3::new(-rim_m, 9.0, 0.0)), 0.0, false);
    // A car beyond the edge is marked there, in its direction.
    assert!(scene.spawn_car(scene.feet().moved(DVec3::new(-60.0, 0.0, 0.0)), 0.0));
    // So is a flag.
    assert!(scene.spawn_flag(scene.feet().moved(DVec3::new(0.0, 0.0, 90.0)), 0.0, "far"));
    let marks = scene.landmarks(45.0);
    let flag = marks.iter().find(|mark| mark.kind == LandmarkKind::Flag);
    assert!(
        flag.is_some_and(|mark| (mark.at.length() - 42.3).abs() < 1e-6),
        "{marks:?}"
    );
    let is_there = |kind: LandmarkKind, x: f64| {
        let here = |mark: &&antipode_scene::bearings::Landmark| {
            mark.kind == kind && (mark.at - DVec2::new(x, 0.0)).length() < 1e-6
        };
        marks.iter().filter(here).count() == 1
    };
    assert!(is_there(LandmarkKind::Lamp, 10.0), "{marks:?}");
    assert!(is_there(LandmarkKind::Hostile, -8.0), "{marks:?}");
    assert!(is_there(LandmarkKind::Car, -42.3), "{marks:?}");
    assert!(marks.iter().all(|mark| mark.at.length() <= 45.0));
}

#[test]
fn north_is_one_way_in_all_charts_of_squares_that_are_turned() {
    let mut twins = Twins::new();
    let mut turned = std::collections::BTreeSet::new();
    for (x, z) in [(5.0, 5.0), (70.0, 5.0), (130.0, -60.0), (-64.0, 128.0)] {
        twins.stand(x, z, 0.4, 0.0);
        twins.step(&Actions::default());
        let [one, many] = [&twins.one, &twins.many].map(Scene::bearings);
        let [from_one, from_many] = [one, many].map(|it| it.north_rad - it.heading_rad);
        assert!((from_one - from_many).cos() > 1.0 - 1e-12, "{x} {z}");
        assert_eq!(many.equator, None, "an edge of squares is no place");
        turned.insert((many.north_rad - one.north_rad).rem_euclid(std::f64::consts::TAU) as u32);
    }
    assert!(turned.len() > 1, "{turned:?}");
}

#[test]
fn lands_have_their_own_colours_on_it() {
    let setup = WorldSetup {
        generator: Generator::Climates,
        ..setup(Geometry::Euclidean)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    let biome = |x: f64| {
        let at = ChartPoint::a(DVec3::new(x, 30.0, 0.0));
        scene.field().biome_at(at).name()
    };
    let border = (1..400).map(|n| 20.0 * f64::from(n));
    let border = border
        .into_iter()
        .find(|x| biome(x - 20.0) != biome(x + 20.0));
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(DVec3::new(border.unwrap(), 60.0, 0.0)));
    let plan = Survey::default().look(&scene, 1, Extent::Near, ALL);
    let [here, there] = [-25.0, 25.0].map(|x| node_at(&plan, DVec2::new(x, 0.0)));
    assert_ne!(here.colours, there.colours);
}
