//! What the crosshair covers: the marker lies on the geodesic through the screen's centre and is drawn there.

use std::time::Duration;

use antipode_geometry::{ChartId, ChartPoint, Geometry, HyperbolicMap, Projection};
use antipode_scene::tuning::{FOV_Y_RAD, NEAR_M, REACH_M};
use antipode_scene::{Actions, Scene, WorldSetup};
use glam::DVec3;

const LIMIT: Duration = Duration::from_mins(1);
/// One pixel of a picture 720 pixels high, in units of half its height.
const PIXEL: f64 = 2.0 / 720.0;

fn scene(geometry: Geometry) -> Scene {
    seeded(geometry, 6)
}

fn seeded(geometry: Geometry, seed: u64) -> Scene {
    let radius_m = if geometry == Geometry::Spherical {
        32.0
    } else {
        20.0
    };
    let setup = WorldSetup {
        name: "Marker".to_owned(),
        seed,
        geometry,
        radius_m,
        generator: antipode_scene::Generator::OneBiome,
        mode: antipode_scene::Mode::default(),
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
    let view = scene.lens().strategy().view_point(&eye, marker.point);
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
fn a_view_along_an_axis_of_the_chart_finds_the_same_ground_as_one_beside_it() {
    for seed in [7, 9] {
        let mut scene = seeded(Geometry::Euclidean, seed);
        let mut found = |yaw: f64, pitch: f64| {
            scene.aim(yaw.to_radians(), pitch.to_radians());
            let marker = scene.marker().expect("a pickaxe is in hand");
            marker.point.pos.distance(scene.eye().point.pos)
        };
        for yaw in [-90.0, 0.0, 90.0, 180.0] {
            for pitch in [-12.0, -15.0, -20.0, -22.0, -30.0, -40.0] {
                let (along, beside) = (found(yaw, pitch), found(yaw + 0.01, pitch));
                assert!(
                    (along - beside).abs() < 0.1,
                    "{yaw} {pitch} in {seed}: {along} m and {beside} m"
                );
            }
        }
    }
}

#[test]
fn the_marker_is_drawn_within_a_pixel_of_the_centre_everywhere() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = scene(geometry);
        let rim = scene.strategy().domain(ChartId::FIRST).radius_m();
        let mut places = vec![scene.feet()];
        let far = rim.map_or(300.0, |rim| rim - 0.5);
        places.push(ChartPoint::a(DVec3::new(far * 0.8, 17.0, far * 0.6)));
        if rim.is_some() {
            places.push(ChartPoint::new(
                ChartId::SECOND,
                DVec3::new(-3.0, 15.0, 40.0),
            ));
        }
        let mut hits = 0;
        for place in places {
            stand(&mut scene, place);
            for dial in [0.0, 0.001, 10.0, 20.0] {
                // Where there is no dial it stays as it is.
                let _ = scene.set_curvature(dial);
                for pitch in [-89.0, -60.0, -30.0, -5.0, 0.0, 30.0, 89.0_f64] {
                    for yaw in [-170.0, -40.0, 20.0, 95.0_f64] {
                        scene.aim(yaw.to_radians(), pitch.to_radians());
                        let off = off_centre(&scene);
                        assert!(
                            off < PIXEL,
                            "{geometry} dial {dial} pitch {pitch} yaw {yaw}: {off}"
                        );
                        let marker = scene.marker().unwrap().point;
                        let reach = scene.lens().strategy().distance_m(
                            scene.eye().point,
                            marker,
                            &scene.eye(),
                        );
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

/// Aims all around; says how often the marker met ground before the reach or the picture ended.
fn look_around(scene: &mut Scene, past_head_m: f64, what: &str) -> u32 {
    let mut hits = 0;
    for pitch in [-89.0, -60.0, -30.0, -5.0, 0.0, 30.0, 89.0_f64] {
        for yaw in [-170.0, -40.0, 20.0, 95.0_f64] {
            scene.aim(yaw.to_radians(), pitch.to_radians());
            let off = off_centre(scene);
            assert!(off < PIXEL, "{what}, pitch {pitch} yaw {yaw}: {off}");
            let (eye, marker) = (scene.eye(), scene.marker().unwrap().point);
            let strategy = scene.lens().strategy();
            let reach = strategy.distance_m(eye.point, marker, &eye) - past_head_m;
            let end = REACH_M.min(strategy.sight_limit_m(&eye));
            assert!(reach <= end + 1e-6, "{what}: reaches {reach} m");
            hits += u32::from(pitch < -20.0 && reach < end - 0.1);
        }
    }
    hits
}

#[test]
fn the_marker_is_drawn_within_a_pixel_of_the_centre_through_the_other_pictures() {
    let mut high = scene(Geometry::Hyperbolic);
    let far = ChartPoint::a(DVec3::new(240.0, 17.0, 180.0));
    for place in [high.feet(), far] {
        stand(&mut high, place);
        assert!(high.set_map(HyperbolicMap::Horizon));
        for dial in [0.0, 0.001, 10.0, 20.0] {
            assert!(high.set_curvature(dial));
            let hits = look_around(&mut high, 0.0, &format!("horizon map, dial {dial}"));
            assert!(hits > 3 || place == far, "dial {dial}: {hits} hits");
        }
    }
    let mut flat = scene(Geometry::Euclidean);
    for place in [flat.feet(), far] {
        stand(&mut flat, place);
        for bend in [-20.0, -10.0, -0.001, 0.001, 10.0, 20.0] {
            assert!(flat.set_bend(bend));
            let hits = look_around(&mut flat, 0.0, &format!("bend {bend}"));
            assert!(hits > 3 || place == far, "bend {bend}: {hits} hits");
        }
    }
}

#[test]
fn the_marker_stays_under_the_crosshair_while_one_map_gives_way_to_the_other() {
    for (geometry, notches) in [(Geometry::Hyperbolic, 0.0), (Geometry::Euclidean, -8.0)] {
        let mut scene = scene(geometry);
        scene.aim(0.7, -0.4);
        for third in [false, true] {
            let mut turn = Actions {
                turn_map: true,
                dial: notches,
                toggle_camera: third,
                ..Actions::default()
            };
            let (mut least, mut last) = (f64::INFINITY, scene.eye().dial);
            for step in 0..180 {
                scene.step(&turn);
                turn = Actions::default();
                let dial = scene.eye().dial;
                least = least.min(dial.abs());
                assert!((dial - last).abs() < 1.5, "from {last} to {dial}");
                let off = off_centre(&scene);
                assert!(off < PIXEL, "{geometry}, step {step}: {off}");
                last = dial;
            }
            assert_eq!(least, 0.0, "{geometry}: never flat");
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
