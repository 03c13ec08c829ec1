//! Wherever a walking body is put, it ends up standing on free ground of its world.

use crate::common::{LIMIT, scene, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::{Actions, Hint, Scene, WorldSetup};
use glam::DVec3;

/// Asserts that the body stands free on the ground below it.
fn assert_stands(scene: &Scene, place: &str) {
    let (feet, probe) = (scene.feet().pos, scene.probe());
    let ground_m = scene.ground_height().expect("there is ground below");
    assert!(probe.player.grounded, "{place}: falls at {feet}");
    assert_eq!(probe.player.vel, [0.0; 3], "{place}");
    assert!(
        (feet.y - ground_m).abs() < 0.6,
        "{place}: {feet} over ground at {ground_m}"
    );
}

#[test]
fn a_body_put_into_rock_comes_out_on_the_ground_in_every_space() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        for (x, y, z) in [
            (32.0, 0.0, 32.0),
            (-20.0, 3.5, 11.0),
            (16.0, -40.0, -16.0),
            (30.0, -2000.0, 4.0),
        ] {
            let place = format!("{geometry:?} {x} {y} {z}");
            scene.teleport(ChartPoint::a(DVec3::new(x, y, z)));
            assert!(scene.wait_for_step(LIMIT), "{place}");
            let feet = scene.feet().pos;
            assert!(
                scene
                    .ground_height()
                    .is_some_and(|height| height < feet.y + 0.6),
                "{place}: not out at once, but at {feet}"
            );
            steps(&mut scene, 60, &Actions::default());
            assert_stands(&scene, &place);
        }
    }
}

#[test]
fn at_the_bedrock_of_the_largest_closed_world_no_fall_goes_on() {
    let setup = WorldSetup {
        radius_m: 64.0,
        ..crate::common::setup(Geometry::Spherical)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.teleport(ChartPoint::a(DVec3::new(64.0, 20.0, 0.0)));
    steps(&mut scene, 180, &Actions::default());
    assert_stands(&scene, "64 20 0");
}

#[test]
fn the_same_teleport_ends_at_the_same_place_to_the_bit() {
    let end = || {
        let mut scene = scene(Geometry::Euclidean);
        scene.teleport(ChartPoint::a(DVec3::new(45.5, -300.0, 7.25)));
        steps(&mut scene, 30, &Actions::default());
        scene.feet().pos
    };
    assert_eq!(end(), end());
}

#[test]
fn a_flight_that_ends_inside_the_ground_leads_out_of_it() {
    let mut scene = scene(Geometry::Hyperbolic);
    scene.set_flying(true);
    let mut deep = scene.feet();
    deep.pos.y -= 12.0;
    scene.teleport(deep);
    steps(&mut scene, 5, &Actions::default());
    assert!(
        (scene.feet().pos - deep.pos).length() < 1e-9,
        "a spectator may be in rock"
    );
    scene.set_flying(false);
    steps(&mut scene, 60, &Actions::default());
    assert_stands(&scene, "after the flight");
}

#[test]
fn from_inside_rock_no_ground_is_seen_above_the_head() {
    let mut scene = scene(Geometry::Euclidean);
    scene.set_flying(true);
    let mut deep = scene.feet();
    deep.pos.y -= 12.0;
    scene.teleport(deep);
    assert!(scene.wait_for_step(LIMIT));
    let head_m = scene.head().point.pos.y;
    assert!(scene.ground_height().is_none_or(|ground| ground < head_m));
}

#[test]
fn a_body_that_stands_is_never_moved_by_the_check() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        steps(&mut scene, 60, &Actions::default());
        let feet = scene.feet();
        scene.teleport(feet);
        assert!(scene.wait_for_step(LIMIT));
        assert_eq!(scene.feet(), feet);
    }
}

#[test]
fn at_the_ceiling_of_a_closed_world_no_speed_builds_up() {
    let mut scene = scene(Geometry::Spherical);
    let ceiling_m = scene.strategy().limits().unwrap().ceiling_m;
    scene.set_flying(true);
    let start = ChartPoint::new(ChartId::SECOND, DVec3::new(3.0, ceiling_m - 0.5, 0.0));
    scene.teleport(start);
    assert!(scene.wait_for_step(LIMIT));
    let rise = Actions {
        jump: true,
        ..Actions::default()
    };
    steps(&mut scene, 60, &rise);
    let player = scene.probe().player;
    assert_eq!((player.pos[1], player.vel[1]), (ceiling_m, 0.0));
}

#[test]
fn places_outside_the_world_end_at_its_border_and_can_be_played() {
    for (geometry, pos) in [
        (Geometry::Spherical, DVec3::new(0.0, 1e8, 0.0)),
        (Geometry::Spherical, DVec3::new(1e8, 0.0, -1e8)),
        (Geometry::Euclidean, DVec3::new(6.87e10, 0.0, 0.0)),
        (Geometry::Hyperbolic, DVec3::new(-1e300, 20.0, 1e300)),
    ] {
        let mut scene = scene(geometry);
        scene.teleport(ChartPoint::a(pos));
        assert!(scene.wait_for_step(LIMIT), "{geometry:?} {pos}");
        assert!(scene.settle(LIMIT));
        assert_eq!(scene.loading_progress(), 1.0);
        steps(&mut scene, 3, &Actions::default());
        assert!(scene.feet().pos.is_finite());
    }
}

#[test]
fn far_out_the_ground_carries_as_it_does_at_home() {
    let mut scene = scene(Geometry::Euclidean);
    scene.teleport(ChartPoint::a(DVec3::new(1e6, 60.0, -1e6)));
    steps(&mut scene, 300, &Actions::default());
    assert_stands(&scene, "a thousand kilometres out");
}

#[test]
fn who_builds_in_a_tunnel_is_not_lifted_through_the_hill() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let top = scene.feet().pos.y;
        let dig = Actions {
            slot: Some(3),
            primary: true,
            ..Actions::default()
        };
        scene.aim(0.3, -1.5);
        steps(&mut scene, 300, &dig);
        scene.aim(0.3, -0.4);
        let onwards = Actions {
            forward: 0.5,
            ..dig
        };
        steps(&mut scene, 300, &onwards);
        steps(&mut scene, 60, &Actions::default());
        let before = scene.feet().pos;
        assert!(before.y < top - 6.0, "{geometry:?}: {before} below {top}");
        scene.take_hints();
        let build = Actions {
            secondary: true,
            ..Actions::default()
        };
        scene.aim(0.3, -0.2);
        steps(&mut scene, 180, &build);
        steps(&mut scene, 60, &Actions::default());
        let after = scene.feet().pos;
        assert!(
            after.y < before.y + 1.5,
            "{geometry:?}: {before} to {after}"
        );
        assert!(scene.take_hints().contains(&Hint::InTheWay), "{geometry:?}");
    }
}

#[test]
fn the_player_of_a_new_world_stands_on_the_ground_before_any_time_has_passed() {
    for geometry in Geometry::ALL {
        for seed in 0..8 {
            let setup = WorldSetup {
                seed,
                view_distance: 1,
                ..crate::common::setup(geometry)
            };
            let mut scene = Scene::open(setup, None).unwrap();
            assert!(scene.wait_for_step(LIMIT));
            let place = format!("{geometry:?} {seed}");
            assert_eq!(scene.simulated_s(), 0.0);
            assert!(scene.probe().player.grounded, "{place}");
            let feet = scene.feet().pos;
            steps(&mut scene, 30, &Actions::default());
            let moved_m = scene.feet().pos.distance(feet);
            assert!(moved_m < 1e-6, "{place}: sinks by {moved_m} m");
            assert_stands(&scene, &place);
        }
    }
}

#[test]
fn who_is_put_high_over_the_ground_falls() {
    let mut scene = scene(Geometry::Euclidean);
    let up = scene.feet().moved(DVec3::Y * 3.0);
    scene.teleport(up);
    assert!(scene.wait_for_step(LIMIT));
    assert!(!scene.probe().player.grounded && scene.feet() == up);
}
