//! A room that is changed while one is in it.

use antipode_room_scene::workshop::FreeCamera;
use antipode_room_scene::{RoomScene, Steer};
use antipode_rooms::{Assets, Room, RoomError};
use glam::DVec3;

use crate::{AHEAD, empty};

fn edit(scene: &mut RoomScene, command: &str) -> Result<(), RoomError> {
    let words: Vec<_> = command.split(' ').collect();
    scene.edit(&words, |_| Ok(Assets::default()))
}

/// The box that a camera is in may be taken away, as by who takes back what has just been put about it.
#[test]
fn a_free_camera_is_where_it_was_when_the_box_about_it_is_gone() {
    let mut scene = empty();
    let camera = FreeCamera::of(&scene.eye());
    let wall = camera.point + DVec3::new(0.0, 0.0, -6.0);
    let before = scene.way_to(&scene.viewpoint(&camera, 1.0), wall, &[]);
    let before = before.unwrap().1;
    let hall = "add aberration name=hall at=0,2,0 half=4,4,4 stretch=2,2,2 sides=soft";
    edit(&mut scene, hall).unwrap();
    let within = scene.viewpoint(&camera, 1.0);
    assert!(!within.eye.place.stack.is_empty());
    edit(&mut scene, "undo").unwrap();
    let view = scene.viewpoint(&camera, 1.0);
    assert!(view.eye.place.stack.is_empty());
    let after = scene.way_to(&view, wall, &[]).unwrap().1;
    assert!(view.apart(after, before) < 1e-9, "{after} {before}");
}

/// Who walks on from a camera near the ground, or in it, stands on it.
#[test]
fn one_walks_on_from_a_camera_on_the_ground_however_low_that_is() {
    for height in [3.0, 1.0, 0.2, -0.4, -0.9] {
        let mut scene = empty();
        let mut camera = FreeCamera::of(&scene.eye());
        camera.point = DVec3::new(1.5, height, 2.5);
        scene.walk_from(&camera);
        for _ in 0..120 {
            scene.step(&AHEAD);
        }
        let feet = scene.feet();
        assert!(feet.y.abs() < 0.01, "from {height} to {feet}");
        assert!(feet.z < 1.5, "from {height} to {feet}");
    }
}

#[test]
fn what_is_added_is_picked_met_and_taken_back() {
    let mut scene = empty();
    scene.aim(-90.0, 0.0);
    assert_eq!(scene.pick().object, None, "the sky");
    edit(&mut scene, "add box name=wall at=0,1,-5 size=4,2,0.2").unwrap();
    let pick = scene.pick();
    assert_eq!(pick.object.as_deref(), Some("wall"));
    assert!((pick.felt.unwrap() - 4.9).abs() < 1e-6, "{pick:?}");
    for _ in 0..180 {
        scene.step(&AHEAD);
    }
    assert!((scene.feet().z + 4.55).abs() < 0.02, "{}", scene.feet());
    edit(&mut scene, "undo").unwrap();
    for _ in 0..60 {
        scene.step(&AHEAD);
    }
    assert!(scene.feet().z < -8.0, "{}", scene.feet());
}

#[test]
fn space_changes_under_who_stands_in_it() {
    let mut scene = empty();
    edit(
        &mut scene,
        "add aberration name=hall at=0,2,0 half=4,4,4 stretch=2,2,2 sides=soft",
    )
    .unwrap();
    assert_eq!(scene.probe().scale, 0.5);
    let seen = scene.revision();
    edit(&mut scene, "change hall stretch=4,4,4").unwrap();
    assert_eq!(scene.probe().scale, 0.25);
    assert!(scene.revision() > seen);
    edit(&mut scene, "undo 2").unwrap();
    assert_eq!(scene.probe().scale, 1.0);
    edit(&mut scene, "redo 2").unwrap();
    assert_eq!(scene.probe().scale, 0.25);
}

#[test]
fn what_is_refused_leaves_all_as_it_was() {
    let mut scene = empty();
    edit(
        &mut scene,
        "add aberration name=one at=0,1,-20 half=2,2,2 stretch=2,2,2 sides=soft",
    )
    .unwrap();
    let (seen, room) = (scene.revision(), scene.room().clone());
    let turned =
        "add aberration name=two at=1,1,-20 turn=30,0,0 half=2,2,2 stretch=2,2,2 sides=soft";
    let said = edit(&mut scene, turned).unwrap_err().to_string();
    assert!(
        said.contains("\"one\"") && said.contains("\"two\""),
        "{said}"
    );
    let words = ["add", "model", "name=m", "file=models/none.glb"];
    let missing = |_: &Room| Err(RoomError::Command("It is not there.".to_owned()));
    assert!(scene.edit(&words, missing).is_err());
    assert_eq!((scene.revision(), scene.room()), (seen, &room));
    scene.step(&Steer::default());
}
