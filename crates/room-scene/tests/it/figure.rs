//! Who walks as a figure, the camera behind them, and what their hands leave as things that are drawn.

use antipode_frame::Clip;
use antipode_room_scene::{RoomScene, RoomViewing, Steer, ThingKind};
use antipode_rooms::{Assets, What};
use glam::{DVec3, Vec3};

use crate::{AHEAD, empty, room};

fn edit(scene: &mut RoomScene, command: &str) {
    let words: Vec<_> = command.split(' ').collect();
    scene.edit(&words, |_| Ok(Assets::default())).unwrap();
}

/// In the open, on the ground.
fn standing() -> RoomScene {
    let mut scene = empty();
    edit(&mut scene, "add box name=plate at=0,-0.5,400 size=60,1,60");
    scene.teleport(DVec3::new(0.0, 0.0, 400.0)).unwrap();
    scene.aim(-90.0, 0.0);
    (0..60).for_each(|_| scene.step(&Steer::default()));
    scene
}

fn strongest(scene: &RoomScene) -> Clip {
    let posture = scene.figure_between(1.0).posture;
    let by_share = |a: &Clip, b: &Clip| posture.share(*a).total_cmp(&posture.share(*b));
    Clip::WHOLE.into_iter().max_by(by_share).unwrap()
}

#[test]
fn the_figure_stands_runs_and_jumps_where_one_is() {
    let mut scene = standing();
    assert_eq!(strongest(&scene), Clip::Idle);
    (0..60).for_each(|_| scene.step(&AHEAD));
    assert_eq!(strongest(&scene), Clip::Run);
    let figure = scene.figure_between(1.0);
    let feet = figure.pose.transform_point3(Vec3::ZERO).as_dvec3();
    assert!(feet.distance(scene.feet()) < 1e-3, "{feet}");
    let ahead = figure.pose.transform_vector3(Vec3::X);
    assert!(
        ahead.distance(Vec3::NEG_Z) < 1e-5,
        "where one looks: {ahead}"
    );
    let right = figure.pose.transform_vector3(Vec3::Z);
    assert!(
        right.distance(Vec3::X) < 1e-5,
        "its right is one's own: {right}"
    );
    assert_eq!(figure.object as usize, scene.room().objects.len());
    let jump = Steer {
        jump: true,
        ..Steer::default()
    };
    (0..12).for_each(|_| scene.step(&jump));
    assert_eq!(strongest(&scene), Clip::Jump);
}

#[test]
fn the_figure_keeps_its_felt_size() {
    let mut scene = room("nested-boxes");
    let height = |scene: &RoomScene| {
        let pose = scene.figure_between(1.0).pose;
        pose.transform_vector3(Vec3::Y * 1.8).y
    };
    assert!((height(&scene) - 1.8).abs() < 1e-5);
    let (index, _) = scene.room().aberrations().next().unwrap();
    let at = antipode_rooms::poses(scene.room())[index].translation;
    scene.teleport(DVec3::new(at.x, 0.05, at.z)).unwrap();
    let small = f64::from(height(&scene)) / 1.8;
    assert!(
        (small - scene.probe().scale).abs() < 1e-5 && small < 0.1,
        "{small}"
    );
}

#[test]
fn from_behind_one_sees_who_walks_and_from_the_head_one_does_not() {
    let mut scene = standing();
    assert!(scene.figure_between(1.0).unseen_by_eye);
    let head = scene.eye().place.point;
    scene.set_third_person(true);
    let eye = scene.eye();
    let away = eye.place.point - head;
    assert!(
        (away - DVec3::new(0.0, 0.45, 5.2)).length() < 1e-6,
        "{away}"
    );
    assert!(eye.front.distance(DVec3::NEG_Z) < 1e-9);
    assert!(!scene.figure_between(1.0).unseen_by_eye);
    let probe = scene.probe();
    assert_eq!(probe.camera.mode, "third");
    assert_eq!(probe.camera.pos, eye.place.point.to_array());
}

#[test]
fn the_camera_behind_stops_before_walls_and_is_as_far_as_it_feels() {
    let mut scene = standing();
    edit(&mut scene, "add box name=wall at=0,2,402.1 size=20,4,0.2");
    scene.set_third_person(true);
    let eye = scene.eye().place.point;
    assert!(
        (eye.z - 401.75).abs() < 1e-6,
        "0.25 m before the wall: {eye}"
    );
    assert!(
        scene.figure_between(1.0).unseen_by_eye,
        "too near to be seen as a whole"
    );
    edit(&mut scene, "undo");
    // Twice as long inside as outside.
    edit(
        &mut scene,
        "add aberration name=hall at=0,2,400 half=8,4,8 stretch=2,2,2 sides=soft",
    );
    let head = {
        scene.set_third_person(false);
        scene.eye().place.point
    };
    scene.set_third_person(true);
    let away = scene.eye().place.point.z - head.z;
    assert!((away - 2.6).abs() < 1e-6, "5.2 felt metres: {away}");
}

#[test]
fn the_gun_is_out_of_the_picture_while_one_reads_a_sign_and_back_for_a_shot() {
    let mut scene = standing();
    let lowered = |scene: &mut RoomScene, steer: &Steer, steps: u32| {
        (0..steps).for_each(|_| scene.step(steer));
        scene.now().hand.unwrap().hand.lowered
    };
    let rests = Steer::default();
    assert_eq!(lowered(&mut scene, &rests, 60), 0.0);
    edit(
        &mut scene,
        "add sign name=words at=0,1.6,397 turn=90,0,0 size=1,0.6 text=hello",
    );
    assert_eq!(lowered(&mut scene, &rests, 60), 1.0);
    let shoots = Steer {
        shoot: true,
        ..Steer::default()
    };
    assert!(lowered(&mut scene, &shoots, 1) < 0.1);
    edit(&mut scene, "change words at=0,1.6,380");
    assert_eq!(
        lowered(&mut scene, &rests, 60),
        0.0,
        "it is too far off to read"
    );
}

/// A crate whose side is nearly in the camera's way does not fill half of the picture.
#[test]
fn the_camera_behind_stays_before_what_stands_beside_its_way() {
    for side in [-1.0, 1.0] {
        let mut scene = standing();
        let x = side * 1.05;
        let crate_there = format!("add box name=crate at={x},1.5,404 size=2,3,2");
        edit(&mut scene, &crate_there);
        scene.set_third_person(true);
        let eye = scene.eye().place.point;
        assert!((eye.z - 402.75).abs() < 1e-3, "0.25 m before it: {eye}");
        edit(
            &mut scene,
            &format!("change crate at={},1.5,404", side * 1.3),
        );
        let eye = scene.eye().place.point;
        assert!((eye.z - 405.2).abs() < 1e-3, "it is out of the way: {eye}");
    }
}

#[test]
fn what_hands_leave_is_drawn_and_lamps_shine() {
    let mut scene = standing();
    scene.aim(-90.0, -30.0);
    let lamps = scene.lamps_between(1.0).len();
    let own = scene.room().objects.iter();
    let own = own
        .filter(|it| matches!(it.what, What::Light { .. }))
        .count();
    assert_eq!(lamps, own);
    scene.step(&Steer {
        throw: true,
        place: true,
        ..Steer::default()
    });
    let things = scene.things();
    let lamp = things.iter().find(|it| it.kind == ThingKind::Lamp).unwrap();
    let shining = scene.lamps_between(1.0);
    assert_eq!(shining.len(), own + 1);
    assert_eq!(shining[own].place, lamp.place);
    assert!(
        f64::from(shining[own].radius_m) > lamp.radius_m,
        "out of its globe"
    );
    let mut movers = scene.movers_between(1.0);
    movers.sort_by_key(|it| it.object);
    assert_eq!(movers.len(), things.len());
    for (mover, thing) in movers.iter().zip(&things) {
        let middle = mover.pose.transform_point3(Vec3::ZERO).as_dvec3();
        assert!(middle.distance(thing.place.point) < 1e-4);
        let radius = f64::from(mover.pose.transform_vector3(Vec3::X).length());
        assert!((radius - thing.radius_m).abs() < 1e-6, "{:?}", thing.kind);
        assert!(mover.object as usize > scene.room().objects.len());
    }
}

const SHOOT: Steer = Steer {
    forward: 0.0,
    shoot: true,
    ..AHEAD
};

#[test]
fn the_gun_is_seen_before_the_eye_and_in_the_hand_of_the_figure() {
    let mut scene = standing();
    let seen = scene.now().hand.unwrap();
    assert_eq!((seen.hand.kick, seen.hand.flashes), (0.0, false));
    assert_eq!(seen.hand.bob_m, [0.0, 0.0], "who stands holds it still");
    let ahead = seen.pose.transform_vector3(Vec3::NEG_Z).as_dvec3();
    assert!(ahead.distance(DVec3::NEG_Z) < 1e-6, "{ahead}");
    let lamps = scene.lamps_between(1.0).len();
    scene.step(&SHOOT);
    let shot = scene.now();
    let hand = shot.hand.unwrap().hand;
    assert!(hand.kick > 0.9 && hand.flashes && shot.figure.flashes);
    assert!(shot.figure.posture.kick > 0.9 && shot.figure.held.is_some());
    assert_eq!(shot.lamps.len(), lamps + 1, "a shot lightens");
    (0..60).for_each(|_| scene.step(&Steer::default()));
    let rests = scene.now();
    assert_eq!(rests.hand, Some(seen), "it comes to rest");
    assert_eq!(rests.lamps.len(), lamps);
    scene.set_third_person(true);
    let behind = scene.now();
    assert!(behind.hand.is_none() && behind.figure.held.is_some());
}

#[test]
fn the_gun_bobs_with_the_steps_but_for_whom_moving_pictures_make_ill() {
    let most_m = |reduced_motion: bool| {
        let mut scene = standing();
        scene.set_viewing(RoomViewing {
            reduced_motion,
            ..RoomViewing::default()
        });
        let bobs = (0..120).map(|_| {
            scene.step(&AHEAD);
            let [right_m, up_m] = scene.now().hand.unwrap().hand.bob_m;
            right_m.abs().max(up_m.abs())
        });
        bobs.fold(0.0, f32::max)
    };
    let seen_m = most_m(false);
    assert!((0.005..0.02).contains(&seen_m), "{seen_m}");
    assert_eq!(most_m(true), 0.0);
}

/// In a box that is larger inside along one axis the gun is as much flatter as everything else is: to the eye it is as ever.
#[test]
fn the_gun_keeps_its_felt_size() {
    let mut scene = empty();
    edit(&mut scene, "add box name=plate at=0,-0.5,0 size=60,1,60");
    edit(
        &mut scene,
        "add aberration name=long at=0,3,0 half=8,3,8 axis=z felt=64 sides=soft",
    );
    scene.teleport(DVec3::new(0.0, 0.0, 0.0)).unwrap();
    scene.aim(-90.0, 0.0);
    scene.step(&Steer::default());
    let pose = scene.now().hand.unwrap().pose;
    let ahead = pose.transform_vector3(Vec3::NEG_Z).length();
    let right = pose.transform_vector3(Vec3::X).length();
    assert!((ahead - 0.25).abs() < 1e-5 && (right - 1.0).abs() < 1e-5);
}

/// Over a wall at one's back that hides the legs the camera rises, and over a low one it stays.
#[test]
fn the_camera_behind_rises_until_it_sees_the_legs() {
    let lift_m = |height_m: f64| {
        let mut scene = standing();
        let wall = format!(
            "add box name=wall at=0,{},402.5 size=9,{height_m},0.3",
            0.5 * height_m
        );
        edit(&mut scene, &wall);
        scene.set_third_person(true);
        let eye = scene.eye().place.point;
        assert!((eye.z - 405.2).abs() < 1e-6, "behind: {eye}");
        eye.y - scene.feet().y
    };
    let plain = 1.62 + 0.45;
    assert!((lift_m(0.5) - plain).abs() < 1e-3);
    // The shins are 0.3 m up and 2.35 m before the wall: (h - 0.3) 2.35 / 5.2 = 1.2.
    let seen = 0.3 + 1.2 * 5.2 / 2.35;
    let rises = lift_m(1.5);
    assert!((rises - seen).abs() < 0.03, "{rises}, not {seen}");
    // Not even from so high up.
    let most = lift_m(2.0);
    assert!((most - plain - 1.5).abs() < 0.02, "{most}");
}
