//! What can be heard of walking, falling and digging.

use crate::common::{scene, steps};
use antipode_geometry::{ChartPoint, Geometry};
use antipode_scene::{Actions, Item, Scene, SoundEvent};
use glam::DVec3;

/// A world whose player stands still and has been heard out.
fn standing(geometry: Geometry) -> Scene {
    let mut scene = scene(geometry);
    steps(&mut scene, 90, &Actions::default());
    scene.take_sounds();
    scene
}

fn forward() -> Actions {
    Actions {
        forward: 1.0,
        ..Actions::default()
    }
}

#[test]
fn who_stands_still_is_not_heard_and_who_walks_is_at_every_step() {
    for geometry in Geometry::ALL {
        let mut scene = standing(geometry);
        steps(&mut scene, 60, &Actions::default());
        assert_eq!(scene.take_sounds(), [], "{geometry:?}");
        let from = scene.feet().pos;
        steps(&mut scene, 120, &forward());
        let walked_m = (scene.feet().pos - from).with_y(0.0).length();
        let heard = scene.take_sounds();
        let feet = heard
            .iter()
            .filter(|event| matches!(event, SoundEvent::Step { .. }))
            .count();
        let expected = walked_m / (0.28 * std::f64::consts::PI);
        assert!(
            (feet as f64 - expected).abs() < 0.25 * expected + 1.5,
            "{geometry:?}: {feet} steps over {walked_m} m"
        );
    }
}

#[test]
fn a_fall_is_heard_once_and_the_louder_the_farther() {
    let mut loudness = Vec::new();
    for drop_m in [1.0, 12.0] {
        let mut scene = standing(Geometry::Euclidean);
        let feet = scene.feet();
        scene.teleport(ChartPoint::new(feet.chart, feet.pos + DVec3::Y * drop_m));
        steps(&mut scene, 200, &Actions::default());
        let heard = scene.take_sounds();
        let [SoundEvent::Landed { speed_m_s, .. }, ref after @ ..] = heard[..] else {
            panic!("after {drop_m} m: {heard:?}");
        };
        // A long fall hurts, and that is heard too.
        let hurts: &[_] = if drop_m > 8.0 {
            &[SoundEvent::Hurt]
        } else {
            &[]
        };
        assert_eq!(after, hurts, "after {drop_m} m");
        loudness.push(speed_m_s);
    }
    assert!(loudness[1] > 2.0 * loudness[0], "{loudness:?}");
}

#[test]
fn a_spectator_in_flight_makes_no_steps() {
    let mut scene = standing(Geometry::Euclidean);
    scene.set_flying(true);
    steps(&mut scene, 90, &forward());
    assert_eq!(scene.take_sounds(), []);
}

#[test]
fn a_held_pickaxe_is_heard_at_the_ground_and_not_in_the_air() {
    let mut scene = standing(Geometry::Euclidean);
    scene.inventory_mut().select(3);
    assert_eq!(scene.inventory().held(), Some(Item::PickaxeDiamond));
    let dig = Actions {
        primary: true,
        ..Actions::default()
    };
    scene.aim(0.0, -1.2);
    steps(&mut scene, 60, &dig);
    let heard = scene.take_sounds();
    let bites = heard
        .iter()
        .filter(|event| matches!(event, SoundEvent::Dug { .. }))
        .count();
    assert!((3..=5).contains(&bites), "{heard:?}");

    scene.aim(0.0, 1.2);
    steps(&mut scene, 60, &dig);
    let heard = scene.take_sounds();
    let into_air = heard
        .iter()
        .any(|event| matches!(event, SoundEvent::Dug { .. }));
    assert!(!into_air, "{heard:?}");
}

#[test]
fn another_slot_is_heard_and_the_same_again_is_not() {
    let mut scene = standing(Geometry::Euclidean);
    let take = |slot| Actions {
        slot: Some(slot),
        ..Actions::default()
    };
    steps(&mut scene, 1, &take(2));
    assert_eq!(scene.take_sounds(), [SoundEvent::SlotChanged]);
    steps(&mut scene, 1, &take(2));
    assert_eq!(scene.take_sounds(), []);
}

#[test]
fn the_same_actions_are_heard_the_same() {
    let run = || {
        let mut scene = standing(Geometry::Hyperbolic);
        steps(&mut scene, 100, &forward());
        (scene.take_sounds(), scene.surroundings())
    };
    let first = run();
    assert!(!first.0.is_empty());
    assert_eq!(first, run());
}

#[test]
fn night_and_height_are_told_in_every_space() {
    for geometry in Geometry::ALL {
        let mut scene = standing(geometry);
        scene.set_time_of_day_s(150.0);
        let noon = scene.surroundings();
        scene.set_time_of_day_s(450.0);
        let midnight = scene.surroundings();
        assert!(
            noon.day > 0.99 && midnight.day < 0.01,
            "{geometry}: {noon:?} {midnight:?}"
        );
        assert!((0.0..=noon.relief_m).contains(&noon.height_m), "{noon:?}");
    }
}
