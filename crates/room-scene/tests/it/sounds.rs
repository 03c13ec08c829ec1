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

#[test]
fn what_falls_behind_a_portal_is_heard_as_from_there() {
    let loudest = |portals: &[&str]| {
        let mut scene = crate::empty();
        let crate_there = ["add box name=crate at=80,2,0 size=0.6,0.6,0.6 mass=12"];
        for command in crate_there.iter().chain(portals) {
            let words: Vec<_> = command.split(' ').collect();
            let read = |_: &antipode_rooms::Room| Ok(antipode_rooms::Assets::default());
            scene.edit(&words, read).unwrap();
        }
        let heard = (0..90).flat_map(|_| {
            scene.step(&Steer::default());
            scene.take_sounds()
        });
        let knocks = heard.filter_map(|it| match it {
            RoomSound::Knocked(speed_m_s) => Some(speed_m_s),
            _ => None,
        });
        knocks.fold(0.0, f64::max)
    };
    let door = [
        "add portal name=p at=0,1.25,-2 turn=90,0,0 size=2,2.5 to=q",
        "add portal name=q at=78,1.25,0 turn=0,0,0 size=2,2.5 to=p",
    ];
    let (far, near) = (loudest(&[]), loudest(&door));
    assert_eq!(far, 0.0, "80 m off it is not heard");
    assert!(near > 2.0, "4 m off by the portal: {near}");
}
