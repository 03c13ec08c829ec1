//! Walking through rooms: how long it takes, and that one stays where one can be.

use antipode_room_scene::tuning::{RADIUS_M, STEP_S, WALK_SPEED_M_S};
use antipode_room_scene::{RoomHint, RoomScene, Steer};
use antipode_rooms::Assets;
use antipode_rooms::shipped;
use glam::DVec3;

use crate::{AHEAD, room};

/// Seconds until one who walks ahead is past z = `to`.
fn walks_to(scene: &mut RoomScene, to: f64, most_s: f64) -> f64 {
    let steps = (most_s / STEP_S) as u32;
    for step in 1..=steps {
        scene.step(&AHEAD);
        if scene.feet().z < to {
            return f64::from(step) * STEP_S;
        }
    }
    panic!("after {most_s} s at {}", scene.feet());
}

#[test]
fn a_tunnel_takes_as_long_as_it_feels() {
    for (x, felt_m) in [(-24.0, 79.0 / 3.0), (-8.0, 395.0)] {
        let mut scene = room("four-tunnels");
        // Two metres before the near door; the far one is 79 m on.
        scene.teleport(DVec3::new(x, 0.0, -18.0)).unwrap();
        scene.aim(-90.0, 0.0);
        let pick = scene.pick();
        assert!(pick.object.unwrap().ends_with("-end"), "{x}");
        assert_eq!(pick.events.len(), 2, "{:?}", pick.events);
        let (felt, seen) = (pick.felt.unwrap(), pick.scene.unwrap());
        assert!(
            (felt - seen - (felt_m - 79.0)).abs() < 1e-3,
            "{felt} {seen}"
        );
        walks_to(&mut scene, -20.0, 5.0);
        let took_s = walks_to(&mut scene, -99.0, 2.0 * felt_m / WALK_SPEED_M_S);
        let wanted_s = felt_m / WALK_SPEED_M_S;
        assert!(
            (took_s - wanted_s).abs() < 0.1,
            "{took_s} s for {wanted_s} s"
        );
        assert!((scene.feet().x - x).abs() < 1e-6 && scene.probe().player.grounded);
        // The wall at the end stops them.
        for _ in 0..300 {
            scene.step(&AHEAD);
        }
        let wall_m = -103.7 + RADIUS_M;
        assert!((scene.feet().z - wall_m).abs() < 0.02, "{}", scene.feet());
        assert!(scene.probe().felt_speed < 0.3);
    }
}

#[test]
fn walls_of_a_tunnel_hold_whoever_walks_against_them() {
    // The solids beside this one stand 8 cm behind its walls, which are to hold by themselves.
    let mut scene = room("four-tunnels");
    for (yaw, side) in [(0.0, 1.0), (180.0, -1.0)] {
        scene.teleport(DVec3::new(-8.0, 0.01, -61.0)).unwrap();
        scene.aim(yaw, 0.0);
        for _ in 0..120 {
            scene.step(&AHEAD);
        }
        let feet = scene.feet();
        let wall_m = -8.0 + side * (4.75 - RADIUS_M);
        assert!((feet.x - wall_m).abs() < 0.02, "{feet}");
        assert!(feet.y.abs() < 0.01 && scene.probe().felt_speed < 0.3);
    }
}

#[test]
fn one_walks_runs_and_jumps_as_in_worlds() {
    let mut scene = room("long-house");
    for _ in 0..30 {
        scene.step(&Steer::default());
    }
    assert!(scene.probe().player.grounded);
    scene.aim(90.0, 0.0);
    let begin = scene.feet();
    for _ in 0..60 {
        scene.step(&AHEAD);
    }
    let walked = scene.feet().distance(begin);
    assert!((walked - 4.5).abs() < 0.3, "{walked}");
    let sprint = Steer {
        sprint: true,
        forward: 0.0,
        strafe: 1.0,
        ..AHEAD
    };
    let begin = scene.feet();
    for _ in 0..60 {
        scene.step(&sprint);
    }
    let ran = scene.feet() - begin;
    assert!(ran.x < -6.5, "right of +z is -x: {ran}");
    let speed = scene.probe().felt_speed;
    assert!((speed - 4.5 * 1.7).abs() < 0.1, "{speed}");
    let jump = Steer {
        jump: true,
        ..Steer::default()
    };
    scene.step(&jump);
    let mut highest = 0.0_f64;
    for _ in 0..120 {
        scene.step(&Steer::default());
        highest = highest.max(scene.feet().y);
    }
    assert!((highest - 1.2).abs() < 0.1, "{highest}");
    let probe = scene.probe();
    assert!(probe.player.grounded && probe.felt_speed < 0.2, "{probe:?}");
}

#[test]
fn in_every_room_of_the_game_one_stands_and_sees_something() {
    for shipped in shipped::ROOMS {
        let mut scene = room(shipped.id);
        scene.aim(-90.0, -10.0);
        assert!(scene.pick().object.is_some(), "{}", shipped.id);
        for _ in 0..120 {
            scene.step(&AHEAD);
        }
        // Who enters a large box becomes small about their middle, and falls to their feet.
        for _ in 0..60 {
            scene.step(&Steer::default());
        }
        scene.aim(-90.0, -10.0);
        let probe = scene.probe();
        // In one of them one falls for ever, and in another one climbs.
        let falls = ["bottomless-shaft", "falling-crate"].contains(&shipped.id);
        assert!(
            probe.player.grounded != falls,
            "{}: {:?}",
            shipped.id,
            probe.player
        );
        if !falls && shipped.id != "endless-stair" {
            assert!(probe.player.pos[1].abs() < 0.3, "{}", shipped.id);
        }
        assert!(probe.pick.object.is_some(), "{}", shipped.id);
        assert_eq!(probe.objects.len(), scene.room().objects.len());
    }
}

#[test]
fn who_is_in_a_large_box_is_small_in_the_scene() {
    let mut scene = room("nested-boxes");
    assert_eq!(scene.probe().scale, 1.0);
    let (index, _) = scene.room().aberrations().next().unwrap();
    let at = antipode_rooms::poses(scene.room())[index].translation;
    scene.teleport(DVec3::new(at.x, 0.05, at.z)).unwrap();
    let probe = scene.probe();
    assert!(
        (probe.scale - 0.0625).abs() < 1e-9,
        "four deep: {}",
        probe.scale
    );
    let eye = probe.camera.pos[1] - probe.player.pos[1];
    assert!(eye < 1.0, "{eye}");
}

#[test]
fn who_falls_out_begins_anew() {
    let mut scene = room("long-house");
    let spawn = scene.room().spawn.at;
    scene.teleport(DVec3::new(500.0, 0.0, 0.0)).unwrap();
    let fell = (0..60 * 40).find(|_| {
        scene.step(&Steer::default());
        scene.take_hints().contains(&RoomHint::FellOut)
    });
    // 41 m below its floor, of which the game knows the lowest corner.
    assert!(
        fell.is_some_and(|steps| steps < 60 * 5),
        "nobody waits long: {fell:?} steps"
    );
    (0..30).for_each(|_| scene.step(&Steer::default()));
    assert!(scene.feet().distance(spawn) < 0.1, "{}", scene.feet());
    let refused = scene.teleport(DVec3::new(2000.0, 0.0, 0.0)).unwrap_err();
    assert!(refused.to_string().contains("2000"), "{refused}");
    assert!(scene.teleport(DVec3::splat(f64::NAN)).is_err());
}

/// The lower face of the box is where the floor is, as in most rooms.
#[test]
fn who_is_put_on_the_lower_face_of_a_box_stands_in_it() {
    let mut scene = crate::empty();
    for command in [
        "add box name=plate at=0,-0.5,0 size=60,1,60",
        "add aberration name=shed at=0,1.25,-6 half=1,1.25,4 axis=z felt=40 sides=walls",
    ] {
        let words: Vec<_> = command.split(' ').collect();
        scene.edit(&words, |_| Ok(Assets::default())).unwrap();
    }
    scene.teleport(DVec3::new(0.0, 0.0, -6.0)).unwrap();
    (0..30).for_each(|_| scene.step(&Steer::default()));
    let place = scene.eye().place;
    assert_eq!(place.stack.len(), 1, "{place:?}");
    let feet = scene.feet();
    assert!(feet.distance(DVec3::new(0.0, 0.0, -6.0)) < 0.01, "{feet}");
    assert!((place.point.y - 1.62).abs() < 0.01, "{place:?}");
}
