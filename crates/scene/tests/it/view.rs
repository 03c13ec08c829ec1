//! What is pointed at and what is handed to the renderer.

use crate::common::{LIMIT, scene, steps};
use antipode_geometry::{ChartId, ChartPoint, FAR_LIMIT_RADII, Geometry};
use antipode_scene::frame::{ChunkChange, LandCursor};
use antipode_scene::{Actions, CameraMode, Item, Scene};
use glam::DVec3;

#[test]
fn from_behind_at_a_wall_the_wall_is_pointed_at_and_not_what_is_past_it() {
    let mut scene = scene(Geometry::Euclidean);
    let open = scene.marker().map(|marker| marker.point);
    steps(
        &mut scene,
        1,
        &Actions {
            toggle_camera: true,
            ..Actions::default()
        },
    );
    assert_eq!(scene.camera_mode(), CameraMode::Third);
    // Looking up, the camera has the ground at its back and cannot go all the way.
    scene.aim(0.3, 1.2);
    let (eye, head) = (scene.eye(), scene.head());
    let behind_m = eye.point.pos.distance(head.point.pos);
    assert!(behind_m < 3.0, "the camera hangs {behind_m} m behind");
    let marker = scene.marker().unwrap().point;
    // In the air, the marker hangs at the full reach from the head and no further.
    let reach_m = marker.pos.distance(eye.point.pos) - behind_m;
    assert!(
        (reach_m - antipode_scene::tuning::REACH_M).abs() < 0.01,
        "{reach_m} m past the head, was {open:?}"
    );
}

#[test]
fn on_a_sphere_everything_in_reach_is_there_after_a_step() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_flying(true);
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    for at in [
        DVec3::new(rim_m - 2.0, 30.0, 0.0),
        DVec3::new(0.0, 37.0, 20.0),
    ] {
        scene.teleport(ChartPoint::a(at));
        assert!(scene.wait_for_step(LIMIT));
        assert_eq!(scene.pending(), 0);
        let resident = scene.probe().chunks.resident;
        assert!(scene.settle(LIMIT));
        assert_eq!(scene.probe().chunks.resident, resident);
    }
}

#[test]
fn digging_in_one_place_hands_each_chunk_over_once() {
    let mut scene = scene(Geometry::Euclidean);
    assert!(scene.settle(LIMIT));
    let mut cursor = LandCursor::default();
    assert!(
        !scene
            .frame(1.0, 1.5, 1)
            .content
            .land
            .news(&mut cursor)
            .changes
            .is_empty()
    );
    scene.aim(0.0, -0.6);
    let build = Actions {
        secondary: true,
        ..Actions::default()
    };
    steps(&mut scene, 40, &build);
    let changes = scene
        .frame(1.0, 1.5, 1)
        .content
        .land
        .news(&mut cursor)
        .changes;
    let mut coords: Vec<_> = changes.iter().map(ChunkChange::coord).collect();
    let all = coords.len();
    coords.sort_unstable();
    coords.dedup();
    assert!(all > 0 && coords.len() == all);
}

#[test]
fn the_fog_is_complete_before_a_curved_space_ends_to_be_drawn() {
    let mut scene = scene(Geometry::Hyperbolic);
    let limit_m = (FAR_LIMIT_RADII * scene.strategy().radius_m()) as f32;
    assert!(scene.frame(1.0, 1.5, 1).view.fog_distance_m < limit_m);
    scene.set_view_distance(16);
    assert_eq!(scene.frame(1.0, 1.5, 1).view.fog_distance_m, limit_m);
}

#[test]
fn the_ground_height_does_not_depend_on_what_else_is_loaded() {
    let at = ChartPoint::a(DVec3::new(11.0, 100.0, -7.0));
    let mut fresh = scene(Geometry::Euclidean);
    fresh.set_flying(true);
    fresh.teleport(at);
    assert!(fresh.wait_for_step(LIMIT));
    let at_once = fresh.ground_height();
    assert!(fresh.settle(LIMIT));
    assert!(at_once.is_some());
    assert_eq!(fresh.ground_height(), at_once);
}

#[test]
fn the_other_picture_answers_in_words_and_a_sphere_has_none() {
    let turn = Actions {
        turn_map: true,
        ..Actions::default()
    };
    for (geometry, says) in [
        (Geometry::Hyperbolic, "horizon"),
        (Geometry::Euclidean, "bends"),
        (Geometry::Spherical, "no other map"),
    ] {
        let mut scene = scene(geometry);
        let eye = scene.eye();
        steps(&mut scene, 1, &turn);
        let hints = scene.take_hints();
        assert!(
            hints.len() == 1 && hints[0].to_string().contains(says),
            "{hints:?}"
        );
        assert!(scene.take_hints().is_empty());
        if geometry == Geometry::Spherical {
            steps(&mut scene, 60, &Actions::default());
            assert_eq!(scene.eye().dial, eye.dial);
        }
    }
}

#[test]
fn the_fog_is_complete_before_a_bent_picture_ends() {
    let mut scene = scene(Geometry::Euclidean);
    for bend in [-20.0, -10.0, 10.0, 20.0] {
        assert!(scene.set_bend(bend));
        let limit_m = scene.lens().strategy().sight_limit_m(&scene.eye());
        let fog_m = f64::from(scene.frame(1.0, 1.5, 1).view.fog_distance_m);
        assert!(
            fog_m <= limit_m * 1.000_001 && fog_m < 60.0,
            "bend {bend}: {fog_m} of {limit_m}"
        );
    }
}

#[test]
fn a_lamp_in_hand_is_shown_where_it_comes_to_hang() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let lamps = Actions {
            slot: Some(5),
            ..Actions::default()
        };
        steps(&mut scene, 1, &lamps);
        assert_eq!(scene.inventory().held(), Some(Item::Lamp));
        let marked = |scene: &mut Scene| scene.frame(1.0, 1.5, 1).content.marker;
        scene.aim(0.3, 1.2);
        steps(&mut scene, 1, &Actions::default());
        assert_eq!(marked(&mut scene), None, "{geometry:?}: no lamp in the sky");
        scene.aim(0.3, -0.6);
        steps(&mut scene, 1, &Actions::default());
        let shown = marked(&mut scene).expect("there is ground ahead");
        assert_eq!(scene.marker(), None, "a lamp is no brush");
        let put = Actions {
            primary: true,
            ..Actions::default()
        };
        steps(&mut scene, 1, &put);
        let lamp = scene.lamps()[0].glow();
        assert_eq!(lamp.chart, shown.point.chart);
        let off_m = lamp.pos.distance(shown.point.pos);
        assert!(off_m < 0.02, "{geometry:?}: {off_m} m off");
    }
}

#[test]
fn the_ring_of_the_brush_is_there_while_it_digs_or_builds_and_at_no_other_time() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.aim(0.3, -0.6);
        let rest = Actions::default();
        let dig = Actions {
            primary: true,
            ..rest
        };
        let build = Actions {
            secondary: true,
            ..rest
        };
        for (work, there) in [
            (rest, false),
            (dig, true),
            (rest, false),
            (build, true),
            (rest, false),
        ] {
            steps(&mut scene, 2, &work);
            assert!(
                scene.marker().is_some(),
                "{geometry:?}: there is ground ahead"
            );
            let shown = scene.frame(1.0, 1.5, 1).content.marker;
            assert_eq!(shown.is_some(), there, "{geometry:?}: {work:?}");
        }
    }
}

#[test]
fn who_dies_sees_it_from_the_ground_and_stands_up_again() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let high = scene.feet().moved(DVec3::Y * 40.0);
        scene.teleport(high);
        while !scene.is_dead() {
            steps(&mut scene, 1, &Actions::default());
        }
        steps(&mut scene, 60, &Actions::default());
        let over_m = scene.eye().point.pos.y - scene.feet().pos.y;
        assert!((0.2..0.5).contains(&over_m), "{geometry:?}: {over_m} m");
        assert!(scene.eye().roll > 0.5, "{geometry:?}: it lies on its side");
        steps(&mut scene, 200, &Actions::default());
        assert!(!scene.is_dead());
        let over_m = scene.eye().point.pos.y - scene.feet().pos.y;
        assert!(over_m > 1.4 && scene.eye().roll == 0.0, "{geometry:?}");
    }
}

/// How far (as a share of its way) the beam of the flashlight passes from what the crosshair covers, in the picture.
fn beam_misses(scene: &mut Scene) -> f64 {
    let frame = scene.frame(1.3, 1.7, 1);
    let beam = frame.content.lights.beams[0];
    // Where geodesics are straight.
    let seen = |point: ChartPoint| {
        let view = frame.view.strategy.view_point(&frame.view.eye, point);
        view.truncate() / view.w
    };
    let at = seen(beam.point);
    let way = (seen(beam.point.moved(beam.direction * 1e-3)) - at).normalize();
    // What the crosshair covers is somewhere straight ahead: the beam has to meet that line, where there is ground.
    let marker = seen(scene.marker().unwrap().point);
    let toward = marker - at;
    assert!(way.dot(toward) > 0.0);
    toward.reject_from(way).length() / toward.length()
}

#[test]
fn the_flashlight_lights_what_the_crosshair_covers_from_wherever_one_looks() {
    let mut looks = 0;
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = scene(geometry);
        scene.inventory_mut().select(1);
        let toggle = Actions {
            toggle_light: true,
            ..Actions::default()
        };
        steps(&mut scene, 30, &Actions::default());
        steps(&mut scene, 1, &toggle);
        for camera in [CameraMode::First, CameraMode::Third] {
            if scene.camera_mode() != camera {
                let toggle = Actions {
                    toggle_camera: true,
                    ..Actions::default()
                };
                steps(&mut scene, 1, &toggle);
            }
            for (yaw, pitch) in [(0.3, -0.2), (2.0, -0.5), (-1.4, -0.9), (4.0, -1.3)] {
                scene.aim(yaw, pitch);
                let reach_m = antipode_scene::tuning::REACH_M;
                let (eye, marker) = (scene.eye(), scene.marker().unwrap().point);
                let strategy = scene.frame(1.3, 1.7, 1).view.strategy;
                if strategy.distance_m(eye.point, marker, &eye) > 0.95 * reach_m {
                    continue;
                }
                let off = beam_misses(&mut scene);
                assert!(off < 0.01, "{geometry} {camera:?} {yaw} {pitch}: {off}");
                looks += 1;
            }
        }
    }
    assert!(looks >= 18, "{looks}");
}
