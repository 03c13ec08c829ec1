//! What the thesis's rule shows elsewhere.

use glam::{DVec2, DVec3};

use crate::room;

const ASPECT: f64 = 16.0 / 9.0;

#[test]
fn each_rule_says_what_lies_under_a_point_of_the_picture() {
    let mut scene = room("four-tunnels");
    scene.teleport(DVec3::new(-8.0, 0.0, -18.0)).unwrap();
    scene.aim(-80.0, 0.0);
    let middle = scene.difference(DVec2::ZERO, ASPECT);
    let pick = scene.pick();
    assert_eq!(
        middle.exact.object, pick.object,
        "the crosshair is in the middle"
    );
    assert_eq!(middle.exact.felt, pick.felt);
    // Ten degrees to the left, along the tunnel.
    let half = (0.5 * antipode_room_scene::tuning::FOV_Y_RAD).tan();
    let left = -(10_f64.to_radians().tan()) / (half * ASPECT);
    let along = scene.difference(DVec2::new(left, 0.0), ASPECT);
    assert!(along.exact.turned_deg < 1e-6, "{along:?}");
    assert!(
        along.exact.object.as_ref().unwrap().ends_with("-end"),
        "{along:?}"
    );
    assert!(
        (along.exact.felt.unwrap() - 395.0).abs() < 30.0,
        "{along:?}"
    );
    assert_ne!(
        along.exact.felt, along.thesis.felt,
        "light is not slowed down by its rule"
    );
    // Its bend is along the axes of the scene, and shows aside of them.
    assert!(middle.exact.turned_deg < 1e-6, "{middle:?}");
    assert!(middle.thesis.turned_deg > 3.0, "{middle:?}");
    // Where no aberration is in the way both agree.
    scene.aim(90.0, -20.0);
    let behind = scene.difference(DVec2::new(0.3, 0.1), ASPECT);
    assert_eq!(behind.exact.object, behind.thesis.object);
    assert!(behind.thesis.turned_deg < 1e-6, "{behind:?}");
}
