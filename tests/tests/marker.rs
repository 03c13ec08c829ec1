//! What the crosshair covers: the marker lies on the geodesic through the screen's centre and is drawn there.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::time::Duration;

use antipode_geometry::{ChartPoint, Geometry, Hemisphere, Projection};
use antipode_scene::tuning::{FOV_Y_RAD, NEAR_M, REACH_M};
use antipode_scene::{Actions, Scene, WorldSetup};
use glam::DVec3;

const LIMIT: Duration = Duration::from_mins(1);
/// One pixel of a picture 720 pixels high, in units of half its height.
const PIXEL: f64 = 2.0 / 720.0;

fn scene(geometry: Geometry) -> Scene {
    let radius_m = if geometry == Geometry::Spherical {
        32.0
    } else {
        20.0
    };
    let setup = WorldSetup {
        name: "Marker".to_owned(),
        seed: 6,
        geometry,
        radius_m,
        view_distance: 2,
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.settle(LIMIT));
    scene
}

/// How far from the screen's centre the marker is drawn, in the units of `PIXEL`.
fn off_centre(scene: &Scene) -> f64 {
    let eye = scene.eye();
    let marker = scene.marker().expect("a pickaxe is in hand");
    let view = scene.strategy().view_point(&eye, marker.point);
    let projection = Projection::new(FOV_Y_RAD, 16.0 / 9.0, NEAR_M);
    assert!(view.z < 0.0, "the marker is behind the eye");
    (projection.sx * view.x / -view.z).hypot(projection.sy * view.y / -view.z)
}

fn stand(scene: &mut Scene, point: ChartPoint) {
    scene.set_flying(true);
    scene.teleport(point);
    assert!(scene.wait_for_step(LIMIT));
    assert!(scene.settle(LIMIT));
}

#[test]
fn the_marker_is_drawn_within_a_pixel_of_the_centre_everywhere() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = scene(geometry);
        let rim = scene.strategy().rim_m();
        let mut places = vec![scene.feet()];
        let far = rim.map_or(300.0, |rim| rim - 0.5);
        places.push(ChartPoint::a(DVec3::new(far * 0.8, 17.0, far * 0.6)));
        if rim.is_some() {
            places.push(ChartPoint::new(Hemisphere::B, DVec3::new(-3.0, 15.0, 40.0)));
        }
        let mut hits = 0;
        for place in places {
            stand(&mut scene, place);
            for dial in [0.0, 0.001, 10.0, 20.0] {
                scene.dial_mut().set(dial);
                for pitch in [-89.0, -60.0, -30.0, -5.0, 0.0, 30.0, 89.0_f64] {
                    for yaw in [-170.0, -40.0, 20.0, 95.0_f64] {
                        scene.aim(yaw.to_radians(), pitch.to_radians());
                        let off = off_centre(&scene);
                        assert!(
                            off < PIXEL,
                            "{geometry} dial {dial} pitch {pitch} yaw {yaw}: {off}"
                        );
                        let marker = scene.marker().unwrap().point;
                        let reach =
                            scene
                                .strategy()
                                .distance_m(scene.eye().point, marker, &scene.eye());
                        assert!(reach <= REACH_M + 1e-6, "{geometry}: reaches {reach} m");
                        hits += usize::from(reach < REACH_M - 0.1);
                    }
                }
            }
        }
        assert!(
            hits > 20,
            "{geometry}: the marker met ground only {hits} times"
        );
    }
}

#[test]
fn in_third_person_the_marker_is_under_the_crosshair_too() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = scene(geometry);
        scene.step(&Actions {
            toggle_camera: true,
            ..Actions::default()
        });
        for pitch in [-50.0, -20.0, 0.0, 20.0_f64] {
            scene.aim(0.7, pitch.to_radians());
            assert!(off_centre(&scene) < PIXEL, "{geometry} pitch {pitch}");
        }
    }
}

#[test]
fn an_empty_hand_has_no_marker() {
    let mut scene = scene(Geometry::Euclidean);
    scene.step(&Actions {
        slot: Some(0),
        ..Actions::default()
    });
    assert!(scene.marker().is_none());
    scene.step(&Actions {
        slot: Some(1),
        ..Actions::default()
    });
    assert!(scene.marker().is_some());
}
