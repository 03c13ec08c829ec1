//! What is heard of who walks.

use antipode_room_scene::{RoomSound, Steer};
use glam::DVec3;

use crate::{AHEAD, room};

#[test]
fn a_fall_is_heard_when_it_ends_and_feet_on_the_way() {
    let mut scene = room("long-house");
    (0..30).for_each(|_| scene.step(&Steer::default()));
    scene.take_sounds();
    let feet = scene.feet();
    scene.teleport(feet + DVec3::Y * 2.0).unwrap();
    (0..90).for_each(|_| scene.step(&Steer::default()));
    let heard = scene.take_sounds();
    let fell = heard.iter().find_map(|it| match it {
        RoomSound::Landed(speed_m_s) => Some(*speed_m_s),
        _ => None,
    });
    // v^2 = 2 g h.
    let expected = (2.0 * 9.81 * 2.0_f64).sqrt();
    assert!(
        fell.is_some_and(|it| (it - expected).abs() < 0.4),
        "{heard:?}"
    );
    (0..120).for_each(|_| scene.step(&AHEAD));
    let heard = scene.take_sounds();
    let steps = heard.iter().filter(|it| matches!(it, RoomSound::Step(_)));
    assert!((3..12).contains(&steps.count()), "{heard:?}");
    assert_eq!(scene.take_sounds(), [], "each is told once");
}

#[test]
fn the_gun_is_heard_once_for_a_pull() {
    let mut scene = room("long-house");
    scene.take_sounds();
    let shoot = Steer {
        shoot: true,
        ..Steer::default()
    };
    (0..30).for_each(|_| scene.step(&shoot));
    let heard = scene.take_sounds();
    let shots = heard.iter().filter(|it| **it == RoomSound::Shot).count();
    assert_eq!(shots, 1, "{heard:?}");
}
