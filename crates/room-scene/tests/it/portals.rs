//! Walking, looking, shooting and throwing through portals of a room.

use antipode_room_scene::{RoomScene, Steer};
use antipode_rooms::Assets;
use glam::DVec3;

use crate::{AHEAD, empty};

fn build(commands: &[&str]) -> RoomScene {
    let mut scene = empty();
    for command in commands {
        let words: Vec<&str> = command.split(' ').collect();
        scene.edit(&words, |_| Ok(Assets::default())).unwrap();
    }
    scene
}

/// A door ahead at z = -5, and its partner at (20, 0, 0), which looks along +x, with a post ten metres before that.
fn doors() -> RoomScene {
    build(&[
        "add portal name=here at=0,1.25,-5 turn=90,0,0 size=1.6,2.5 to=there",
        "add portal name=there at=20,1.25,0 size=1.6,2.5 to=here",
        "add box name=post at=30,1,0 size=0.4,3,0.4",
    ])
}

fn steps(scene: &mut RoomScene, steer: &Steer, count: usize) {
    for _ in 0..count {
        scene.step(steer);
    }
}

#[test]
fn the_crosshair_sees_through_a_door_and_one_walks_to_what_it_is_on() {
    let mut scene = doors();
    scene.aim(-90.0, -2.0);
    let pick = scene.probe().pick;
    assert_eq!(pick.object.as_deref(), Some("post"));
    let [event] = &pick.events[..] else {
        panic!("{pick:?}")
    };
    assert_eq!((event.kind, &event.name[..]), ("portal", "here"));
    let (felt, way) = (pick.felt.unwrap(), pick.scene.unwrap());
    assert!(
        (felt - 14.8).abs() < 0.02 && (felt - way).abs() < 1e-9,
        "{pick:?}"
    );
    steps(&mut scene, &AHEAD, 180);
    let player = scene.probe().player;
    // Turned as the doors are, and in line with the post.
    assert!(player.yaw.abs() < 1e-6, "{player:?}");
    let [x, y, z] = player.pos;
    assert!(x > 24.0 && y.abs() < 1e-3 && z.abs() < 1e-3, "{player:?}");
}

#[test]
fn bullets_and_balls_fly_through_a_door_and_lamps_are_put_down_behind_it() {
    let mut scene = doors();
    scene.aim(-90.0, -2.0);
    let shoot = Steer {
        shoot: true,
        ..Steer::default()
    };
    steps(&mut scene, &shoot, 1);
    steps(&mut scene, &Steer::default(), 40);
    let probe = scene.probe();
    let hit = probe.hit.unwrap();
    assert_eq!(hit.object, "post");
    let mark = probe.things.last().unwrap().pos;
    assert!(
        (mark[0] - 29.8).abs() < 0.02 && mark[2].abs() < 0.02,
        "{mark:?}"
    );
    let throw = Steer {
        throw: true,
        ..Steer::default()
    };
    steps(&mut scene, &throw, 1);
    steps(&mut scene, &Steer::default(), 60);
    let ball = scene.probe().things.last().unwrap().pos;
    assert!(ball[0] > 20.0 && ball[2].abs() < 0.1, "{ball:?}");
    scene.teleport(DVec3::new(0.0, 0.0, -3.0)).unwrap();
    scene.aim(-90.0, -30.0);
    let place = Steer {
        place: true,
        ..Steer::default()
    };
    steps(&mut scene, &place, 1);
    let lamp = scene.probe().things.last().unwrap().pos;
    assert!((20.0..22.0).contains(&lamp[0]) && lamp[1] < 0.2, "{lamp:?}");
}

#[test]
fn who_comes_out_twice_as_large_is_told_so_and_sees_and_jumps_twice_as_high() {
    let mut scene = build(&[
        "add portal name=small at=0,1.25,-5 turn=90,0,0 size=1.6,2.5 to=large",
        "add portal name=large at=20,2.5,0 size=3.2,5 to=small",
    ]);
    steps(&mut scene, &AHEAD, 90);
    steps(&mut scene, &Steer::default(), 30);
    let probe = scene.probe();
    assert!((probe.scale - 2.0).abs() < 1e-9, "{}", probe.scale);
    assert!(
        (probe.camera.pos[1] - 2.0 * 1.62).abs() < 1e-3,
        "{:?}",
        probe.camera
    );
    let jump = Steer {
        jump: true,
        ..Steer::default()
    };
    let mut highest: f64 = 0.0;
    for _ in 0..60 {
        scene.step(&jump);
        highest = highest.max(scene.feet().y);
    }
    assert!((highest - 2.4).abs() < 0.05, "{highest}");
}

#[test]
fn the_picture_rolls_through_a_turned_portal_without_a_jump_and_rights_itself() {
    // One falls into the ground and comes out of a wall.
    let mut scene = build(&[
        "add portal name=pit at=0,0.001,-4 turn=90,90,0 size=3,3 to=wall",
        "add portal name=wall at=30,12,0 turn=0,0,0 size=3,3 to=pit",
    ]);
    scene.aim(-90.0, -20.0);
    let mut before = scene.eye();
    let mut rolled: f64 = 0.0;
    let mut turned_at_once = Vec::new();
    for step in 0..150 {
        scene.step(&AHEAD);
        let eye = scene.eye();
        if eye.place.passage == before.place.passage {
            rolled = rolled.max(eye.right.y.abs());
            turned_at_once.push((eye.up.angle_between(before.up), step));
        }
        before = eye;
    }
    let most = turned_at_once
        .iter()
        .fold(0.0, |most: f64, it| most.max(it.0));
    assert!(
        scene.probe().player.pos[0] > 25.0,
        "{:?}",
        scene.probe().player
    );
    assert!(rolled < 1.0 && most < 0.35, "{rolled} {most}");
    assert!(before.right.y.abs() < 1e-6, "it is level in the end");
}
