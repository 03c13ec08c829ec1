//! Balls that are thrown, kicked and lifted, and what one stands on.

use antipode_room_scene::Steer;
use glam::DVec3;

use crate::bodies::{DOOR, GRASP, go, once, state, wait, with};

const THROW: Steer = Steer {
    throw: true,
    forward: 0.0,
    ..crate::AHEAD
};

#[test]
fn a_ball_that_is_thrown_pushes_what_it_hits_also_through_a_door() {
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add box name=near at=3,0.75,-2.2 size=0.3,1.5,0.3 mass=4",
        "add box name=far at=31.5,0.75,0 size=0.3,1.5,0.3 mass=4",
    ]);
    wait(&mut scene, 1.0);
    for (feet, name) in [
        (DVec3::new(3.0, 0.0, 0.0), "near"),
        (DVec3::new(0.0, 0.0, -8.0), "far"),
    ] {
        scene.teleport(feet).unwrap();
        scene.aim(-90.0, -8.0);
        let before = state(&scene, name);
        once(&mut scene, THROW);
        wait(&mut scene, 2.5);
        let after = state(&scene, name);
        let tilted = (after.turn * DVec3::Y).y < 0.5;
        assert!(tilted, "it lies on its side: {before:?} {after:?}");
    }
}

#[test]
fn who_walks_into_a_ball_that_was_thrown_kicks_it_and_may_lift_it() {
    let mut scene = with(&[]);
    scene.aim(-90.0, -60.0);
    once(&mut scene, THROW);
    wait(&mut scene, 8.0);
    let lies = state(&scene, "ball");
    assert!(lies.rests, "{lies:?}");
    scene
        .teleport(lies.point + DVec3::new(0.0, -0.12, 1.5))
        .unwrap();
    scene.aim(-90.0, -55.0);
    let on_it = (0..60).find(|step| {
        scene.aim(-90.0, -30.0 - 0.7 * f64::from(*step));
        scene.pick().object.as_deref() == Some("ball")
    });
    assert!(on_it.is_some(), "it can be looked at");
    once(&mut scene, GRASP);
    wait(&mut scene, 1.0);
    let held = state(&scene, "ball");
    assert!(held.point.y > 0.6, "{held:?}");
    once(&mut scene, GRASP);
    wait(&mut scene, 4.0);
    let before = state(&scene, "ball").point;
    scene
        .teleport(before + DVec3::new(0.0, -0.12, 1.0))
        .unwrap();
    go(&mut scene, (-90.0, 0.0), &crate::AHEAD, 0.6);
    let after = state(&scene, "ball").point;
    assert!(after.z < before.z - 1.0, "{before} {after}");
}

/// A picture that comes late brings a whole turn of the mouse in one step; what is held goes round after it, to either side.
#[test]
fn what_is_lifted_stays_in_the_hands_of_who_turns_about_in_one_step() {
    let mut scene = with(&["add box name=crate at=0,0.25,-1.6 size=0.5,0.5,0.5 mass=8"]);
    wait(&mut scene, 0.5);
    scene.aim(-90.0, -40.0);
    once(&mut scene, GRASP);
    for yaw in [-90.0, 90.0, -60.0, 120.0, 0.0_f64] {
        go(&mut scene, (yaw, 0.0), &Steer::default(), 1.0);
        let crate_m = state(&scene, "crate").point - scene.eye().place.point;
        let ahead = DVec3::new(yaw.to_radians().cos(), 0.0, yaw.to_radians().sin());
        assert!(crate_m.dot(ahead) > 0.9, "{yaw}: {crate_m}");
        assert!(crate_m.length() < 1.4, "{yaw}: {crate_m}");
    }
}

/// What cannot come along is let go, and not held from afar.
#[test]
fn what_is_lifted_behind_bars_slips_from_the_hands_of_who_goes_away() {
    let mut scene = with(&[
        "add box name=stand at=0,0.4,-1.8 size=0.8,0.8,0.8",
        "add box name=crate at=0,1.05,-1.65 size=0.5,0.5,0.5 mass=8",
        "add box name=left at=-0.3,1.5,-1.1 size=0.3,3,0.1",
        "add box name=right at=0.3,1.5,-1.1 size=0.3,3,0.1",
    ]);
    wait(&mut scene, 0.5);
    scene.aim(-90.0, -19.0);
    once(&mut scene, GRASP);
    go(&mut scene, (-90.0, 0.0), &Steer::default(), 1.0);
    assert!(state(&scene, "crate").point.y > 1.4);
    let away = Steer {
        forward: -1.0,
        ..crate::AHEAD
    };
    go(&mut scene, (-90.0, 0.0), &away, 0.5);
    go(&mut scene, (-90.0, 0.0), &Steer::default(), 1.5);
    let slipped = state(&scene, "crate");
    assert!(slipped.point.y < 1.2, "{slipped:?}");
}

#[test]
fn who_stands_on_the_end_of_a_plank_tips_it_and_a_crate_bears_them() {
    let mut scene = with(&[
        "add box name=block at=6,0.25,0 size=0.3,0.5,1",
        "add box name=plank at=6,0.55,0 size=3,0.1,0.8 mass=20",
        "add box name=crate at=0,0.3,-4 size=0.6,0.6,0.6 mass=12",
    ]);
    wait(&mut scene, 1.0);
    let level = state(&scene, "plank");
    assert!((level.turn * DVec3::X).y.abs() < 0.05, "{level:?}");
    scene.teleport(DVec3::new(7.1, 0.62, 0.0)).unwrap();
    wait(&mut scene, 1.0);
    let tipped = state(&scene, "plank");
    assert!((tipped.turn * DVec3::X).y.abs() > 0.15, "{tipped:?}");
    scene.teleport(DVec3::new(0.0, 0.62, -4.0)).unwrap();
    wait(&mut scene, 5.0);
    let bears = state(&scene, "crate");
    assert!(
        bears.point.distance(DVec3::new(0.0, 0.3, -4.0)) < 0.02,
        "{bears:?}"
    );
    assert!((scene.feet().y - 0.6).abs() < 0.03, "{}", scene.feet());
}
