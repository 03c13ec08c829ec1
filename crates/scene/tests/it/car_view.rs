//! How a driver sees the world from the bonnet.

use crate::common::cars::{ahead, car, driving, still};
use crate::common::steps;
use antipode_geometry::Geometry;
use antipode_scene::{Actions, CameraMode, Scene};
use glam::DVec3;

/// A car this far from level, as the sine of its lean, leans so that one sees it.
const LEANS: f64 = 0.1;
/// The bonnet lies within this of level in the picture, once the eased view has come to rest: sine.
const LEVEL: f64 = 0.03;

/// How far the car's right side is below its left in the world, and in the picture: sines.
fn leans(scene: &Scene) -> (f64, f64) {
    let right = car(scene).turn * DVec3::Z;
    (-right.y, -scene.eye().to_view(right).y)
}

/// Drives about until the car stands leaning to its side.
fn leaning(geometry: Geometry) -> Scene {
    let mut scene = driving(geometry);
    for turn in 0..40 {
        let wish = Actions {
            strafe: if turn % 3 == 0 { 0.8 } else { 0.1 },
            ..ahead()
        };
        steps(&mut scene, 90, &wish);
        let brake = Actions {
            jump: true,
            ..still()
        };
        steps(&mut scene, 150, &brake);
        let (world, _) = leans(&scene);
        if (LEANS..0.5).contains(&world.abs()) {
            return scene;
        }
    }
    panic!("{geometry:?}: no slope was found");
}

#[test]
fn from_the_bonnet_the_land_leans_and_the_bonnet_does_not() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = leaning(geometry);
        if scene.camera_mode() != CameraMode::First {
            let turn = Actions {
                toggle_camera: true,
                ..still()
            };
            steps(&mut scene, 1, &turn);
        }
        steps(&mut scene, 60, &still());
        let (world, picture) = leans(&scene);
        assert!(
            world.abs() > LEANS,
            "{geometry:?}: it stands level: {world}"
        );
        assert!(picture.abs() < LEVEL, "{geometry:?}: {world}, {picture}");

        let mut viewing = scene.viewing();
        viewing.reduced_motion = true;
        scene.set_viewing(viewing);
        steps(&mut scene, 1, &still());
        let up = scene.eye().to_view(DVec3::Y);
        assert!(up.x.abs() < 1e-9, "{geometry:?}: the horizon is level");
    }
}

#[test]
fn the_mirror_shows_what_is_behind_the_car_and_is_there_from_the_bonnet_alone() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = driving(geometry);
        let turn = Actions {
            toggle_camera: true,
            ..still()
        };
        for _ in 0..2 {
            let frame = scene.frame(1.2, 16.0 / 9.0, 1);
            let from_bonnet = scene.camera_mode() == CameraMode::First;
            assert_eq!(frame.mirror.is_some(), from_bonnet, "{geometry:?}");
            if let Some(mirror) = frame.mirror {
                let car = car(&scene);
                let seen = |own: DVec3| mirror.point(car.place(own)).truncate();
                let behind = seen(DVec3::new(-6.0, 1.0, 0.0));
                assert!(behind.z < 0.0 && behind.x.abs() < 0.1, "{behind}");
                // To who looks back what is on the car's right is on the left, until the mirror swaps it.
                let right = seen(DVec3::new(-6.0, 1.0, 1.0));
                assert!(right.x < -0.5, "{geometry:?}: {right}");
                let bonnet = seen(DVec3::new(1.0, 1.0, 0.0));
                assert!(bonnet.z > 0.0, "{geometry:?}: {bonnet}");
                assert!(mirror.hand.is_none());
            }
            steps(&mut scene, 1, &turn);
        }
    }
}
