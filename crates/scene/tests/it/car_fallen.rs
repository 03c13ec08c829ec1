//! A car on its side or roof: how it comes to that, what its driver is told, and how it is set upright.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::cars::{ahead, at_the_wheel, car, still};
use crate::common::{LIMIT, setup, steps};
use antipode_geometry::Geometry;
use antipode_scene::{Actions, CarView, Hint, NpcMode, Scene, WorldSetup};
use antipode_storage::{Batch, WorldStore};
use glam::{DQuat, DVec3};
use tempfile::TempDir;

/// How far a car is turned about its length, in radians, and how far it is lifted for that, in metres.
type Stance = (f64, f64);
const RIGHT_SIDE: Stance = (1.45, 0.77);
const LEFT_SIDE: Stance = (-1.45, 0.77);
const ROOF: Stance = (PI, 1.5);
/// Where it stays lying: on these slopes its weight takes it back from the other stances.
const LYING: [(Geometry, Stance); 6] = [
    (Geometry::Euclidean, RIGHT_SIDE),
    (Geometry::Euclidean, ROOF),
    (Geometry::Hyperbolic, RIGHT_SIDE),
    (Geometry::Hyperbolic, ROOF),
    (Geometry::Spherical, RIGHT_SIDE),
    (Geometry::Spherical, LEFT_SIDE),
];

/// A car that lies, the player at its wheel and its lights on.
fn fallen(geometry: Geometry, (stance_rad, lift_m): Stance) -> (TempDir, Scene) {
    let dir = tempfile::tempdir().unwrap();
    let (here, setup) = (dir.path().join("world"), setup(geometry));
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup.clone(), Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    let mut scene = at_the_wheel(scene);
    let light = Actions {
        toggle_light: true,
        ..still()
    };
    steps(&mut scene, 1, &light);
    scene.close().unwrap();
    let store = WorldStore::open(&here).unwrap();
    let mut state = store.state().unwrap().unwrap();
    let record = &mut state.cars[0];
    let turn = DQuat::from_array(record.turn) * DQuat::from_rotation_x(stance_rad);
    record.turn = turn.to_array();
    record.pos[1] += lift_m;
    let batch = Batch {
        records: (&state).into(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.set_npcs(NpcMode::Still);
    steps(&mut scene, 240, &still());
    let upright = upright(&scene);
    assert!(upright < 0.3, "{geometry:?} {stance_rad}: {upright}");
    (dir, scene)
}

/// The upward part of the car's own upward way.
fn upright(scene: &Scene) -> f64 {
    (car(scene).turn * DVec3::Y).y
}

/// A careless driver: full force, and the wheel thrown about, until the car lies on its side or roof.
fn roll_over(scene: &mut Scene) -> bool {
    for second in 0..400 {
        let strafe = [0.0, 1.0, 1.0, -1.0][second % 4];
        let wish = Actions {
            sprint: true,
            strafe,
            ..ahead()
        };
        steps(scene, 60, &wish);
        if upright(scene) < 0.3 {
            steps(scene, 180, &still());
            if scene.take_hints().contains(&Hint::FallenOver) {
                return true;
            }
        }
    }
    false
}

#[test]
fn a_careless_driver_rolls_it_over_within_minutes() {
    let rolls = |seed: u64| {
        let setup = WorldSetup {
            seed,
            ..setup(Geometry::Euclidean)
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        let mut scene = at_the_wheel(scene);
        scene.set_npcs(NpcMode::Still);
        roll_over(&mut scene)
    };
    // Each drive is chaotic: a change of a millimetre in where it begins makes another of it, so half of many are asked.
    let rolled = (1..=12).filter(|seed| rolls(*seed)).count();
    assert!(rolled >= 6, "{rolled} of 12");
}

/// How deep who stands there is in the box of the car's body, as it lies: none below 0, in metres.
fn depth_m(scene: &Scene) -> f64 {
    let car = car(scene);
    let (low, high) = (DVec3::new(-1.52, 0.3, -0.7), DVec3::new(1.52, 1.49, 0.7));
    let depths = (3..=15).map(|tenths| {
        let place = scene.feet().pos + DVec3::Y * 0.1 * f64::from(tenths);
        let own = car.turn.inverse() * (place - car.point.pos);
        (own - low).min(high - own).min_element()
    });
    depths.fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn who_gets_out_of_a_fallen_car_or_sets_one_upright_stands_beside_it() {
    for (geometry, stance) in LYING {
        let (_dir, mut scene) = fallen(geometry, stance);
        let leave = Actions {
            leave_car: true,
            ..still()
        };
        steps(&mut scene, 1, &leave);
        assert!(!scene.is_driving());
        let depth = depth_m(&scene);
        assert!(depth < 0.0, "{geometry:?} {stance:?}: {depth} m in it");
        // Where it will stand, and on both sides of it.
        let place = car(&scene).point;
        for aside in [-0.8, 0.0, 0.8] {
            scene.teleport(place.moved(DVec3::new(aside, 0.3, aside)));
            let flip = Actions {
                flip_car: true,
                ..still()
            };
            steps(&mut scene, 1, &flip);
            let depth = depth_m(&scene);
            assert!(depth < 0.0, "{geometry:?} {stance:?}: {depth} m in it");
        }
    }
}

#[test]
fn it_is_set_upright_with_its_heading_and_lights_kept() {
    for (geometry, stance) in LYING {
        let (_dir, mut scene) = fallen(geometry, stance);
        let told = scene.take_hints();
        assert!(
            told.contains(&Hint::FallenOver),
            "{geometry:?} {stance:?}: {told:?}"
        );
        let lies = car(&scene);
        let flip = Actions {
            flip_car: true,
            ..still()
        };
        steps(&mut scene, 1, &flip);
        steps(&mut scene, 90, &still());
        let stands = car(&scene);
        assert!(upright(&scene) > 0.6, "{stands:?}");
        assert!(scene.is_driving() && stands.lights && scene.cars().len() == 1);
        assert_eq!(lies.point.chart, stands.point.chart);
        let heading = |car: &CarView| (car.turn * DVec3::X).with_y(0.0).normalize();
        let kept = heading(&lies).dot(heading(&stands));
        assert!(kept > 0.8, "{geometry:?} {stance:?}: {kept}");
        steps(&mut scene, 60, &ahead());
        assert!(car(&scene).velocity.length() > 1.0, "{:?}", car(&scene));
    }
}
