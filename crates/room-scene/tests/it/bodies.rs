//! What is loose in rooms: how it falls, lies, passes portals and faces, and is met on both sides of them.

use antipode_room_scene::{LooseState, RoomScene, Steer};
use glam::DVec3;

use crate::empty;

/// A room with a floor and what the commands add.
pub fn with(commands: &[&str]) -> RoomScene {
    let mut scene = empty();
    for command in commands {
        let words: Vec<_> = command.split(' ').collect();
        scene
            .edit(&words, |_| Ok(antipode_rooms::Assets::default()))
            .unwrap();
    }
    scene
}

pub fn wait(scene: &mut RoomScene, seconds: f64) {
    for _ in 0..(seconds * 60.0).round() as u32 {
        scene.step(&Steer::default());
    }
}

pub fn state(scene: &RoomScene, name: &str) -> LooseState {
    let all = scene.loose_states();
    all.into_iter().find(|it| it.name == name).unwrap()
}

#[test]
fn a_crate_falls_onto_the_floor_and_lies_still() {
    let mut scene = with(&["add box name=crate at=4,3,0 size=0.6,0.6,0.6 mass=12"]);
    wait(&mut scene, 0.5);
    let falls = state(&scene, "crate");
    assert!(
        (falls.point.y - (3.0 - 9.81 * 0.125)).abs() < 1e-3,
        "{falls:?}"
    );
    assert!((falls.velocity.y + 9.81 * 0.5).abs() < 1e-3, "{falls:?}");
    wait(&mut scene, 4.0);
    let lies = state(&scene, "crate");
    assert!(
        (lies.point - DVec3::new(4.0, 0.3, 0.0)).length() < 0.08,
        "{lies:?}"
    );
    assert!(lies.rests, "{lies:?}");
}

/// Energy for each kilogram of its own size.
fn energy(it: &LooseState) -> f64 {
    0.5 * it.velocity.length_squared() + 9.81 * it.point.y / it.place.scale
}

#[test]
fn a_portal_turns_and_scales_what_is_thrown_through_it_and_its_speed_is_kept() {
    let mut scene = with(&[
        "add portal name=p at=0,4,-10 turn=90,0,0 size=4,4 to=q",
        "add portal name=q at=30,6,0 turn=0,0,0 size=8,8 to=p",
        "add box name=crate at=0,4,-8.5 size=0.6,0.4,0.5 mass=12",
    ]);
    assert!(scene.strike("crate", DVec3::new(0.0, 1.0, -9.0)));
    let mut before = state(&scene, "crate");
    for _ in 0..60 {
        scene.step(&Steer::default());
        let now = state(&scene, "crate");
        if now.place.passage.count > 0 {
            let change = now.velocity.length() - before.velocity.length();
            assert!(
                change.abs() < 0.2,
                "{} and {}",
                before.velocity,
                now.velocity
            );
            assert!(
                now.velocity.x > 8.9 && now.velocity.z.abs() < 1e-3,
                "{now:?}"
            );
            assert!((now.place.scale - 2.0).abs() < 1e-9);
            assert!(now.point.x > 30.0 && now.point.x < 31.0);
            break;
        }
        before = now;
    }
    let came_out = state(&scene, "crate");
    assert_eq!(came_out.place.passage.count, 1);
    let kept = energy(&came_out);
    wait(&mut scene, 0.4);
    let flies = energy(&state(&scene, "crate"));
    assert!(
        (flies / kept - 1.0).abs() < 1e-3,
        "{kept} J/kg became {flies}"
    );
    wait(&mut scene, 5.0);
    let lies = state(&scene, "crate");
    let twice = 2.0 * 0.2;
    assert!(
        lies.rests && lies.point.y > twice - 0.02 && lies.point.y < 0.62,
        "{lies:?}"
    );
}

#[test]
fn a_crate_in_a_shaft_falls_for_ever_and_no_faster_than_may_be() {
    let mut scene = crate::room("falling-crate");
    wait(&mut scene, 1.0);
    let mut count = 0;
    for second in 0..30 {
        wait(&mut scene, 1.0);
        let crate_now = state(&scene, "crate");
        assert!(
            crate_now.place.passage.count > count,
            "{second} s: {crate_now:?}"
        );
        count = crate_now.place.passage.count;
        assert!(crate_now.velocity.length() < 60.1, "{crate_now:?}");
        assert!(
            crate_now
                .point
                .with_y(0.0)
                .distance(DVec3::new(0.0, 0.0, -9.0))
                < 0.7
        );
    }
    assert!(state(&scene, "crate").velocity.y < -59.0);
}

#[test]
fn energy_is_kept_through_the_faces_of_a_soft_box() {
    for stretch in ["1,2,1", "0.5,0.5,0.5", "3,1,1", "1,0.25,2"] {
        let mut scene = with(&[
            &format!("add aberration name=soft at=0,9,-5 half=3,3,3 stretch={stretch} sides=soft"),
            "add ball name=ball at=0,14,-5 radius=0.3 mass=5",
        ]);
        scene.strike("ball", DVec3::new(0.9, 0.0, -0.4));
        let first = energy(&state(&scene, "ball"));
        let mut inside = 0;
        while state(&scene, "ball").point.y > 1.0 {
            scene.step(&Steer::default());
            let now = state(&scene, "ball");
            inside += usize::from(!now.place.stack.is_empty());
            let off = energy(&now) / first - 1.0;
            assert!(off.abs() < 1e-3, "{stretch}: {off} at {}", now.point);
        }
        assert!(inside > 5, "{stretch}: {inside}");
    }
}

/// A door at the floor's height that leads from z = -10 to x = 30, as large, turned by a right angle.
pub const DOOR: [&str; 2] = [
    "add portal name=p at=0,1.25,-10 turn=90,0,0 size=2,2.5 to=q",
    "add portal name=q at=30,1.25,0 turn=0,0,0 size=2,2.5 to=p",
];

#[test]
fn who_lies_astride_a_portal_is_lain_on_and_struck_on_both_sides() {
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add box name=low at=0,0.3,-9.8 size=0.6,0.6,1.6 mass=40",
        "add box name=upper at=30.35,1.4,0 size=0.3,0.3,0.3 mass=5",
        "add box name=hither at=0,1.4,-9.3 size=0.3,0.3,0.3 mass=5",
    ]);
    wait(&mut scene, 5.0);
    let [low, upper, hither] = ["low", "upper", "hither"].map(|it| state(&scene, it));
    assert!(low.astride && low.rests, "{low:?}");
    assert!(
        low.point.distance(DVec3::new(0.0, 0.3, -9.8)) < 0.05,
        "{low:?}"
    );
    // What fell onto the half that is elsewhere lies on it.
    assert!((upper.point.y - 0.75).abs() < 0.03, "{upper:?}");
    assert!((hither.point.y - 0.75).abs() < 0.03, "{hither:?}");
    assert!(upper.rests && hither.rests, "{upper:?} {hither:?}");
    // What strikes it there pushes it back here.
    scene.strike("upper", DVec3::new(0.0, 0.0, 4.0));
    wait(&mut scene, 1.0);
    assert!(state(&scene, "upper").point.z > 0.2);
}

#[test]
fn a_blow_through_a_portal_gives_as_much_as_it_takes() {
    // Balls that float: what is heard of it is the blow alone.
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add ball name=a at=0,1.3,-9.0 radius=0.25 mass=6",
        "add ball name=b at=30.22,1.3,0 radius=0.25 mass=2",
    ]);
    scene.set_gravity(DVec3::ZERO).unwrap();
    scene.strike("a", DVec3::new(0.0, 0.0, -3.0));
    wait(&mut scene, 0.3);
    let [a, b] = ["a", "b"].map(|it| state(&scene, it));
    assert!(
        a.place.passage.count == 0 && b.velocity.x > 2.5,
        "{a:?} {b:?}"
    );
    wait(&mut scene, 0.3);
    let [a, b] = ["a", "b"].map(|it| state(&scene, it));
    assert!(b.velocity.x > 2.5, "{b:?}");
    // Both in the axes of the far side, if a has come through; else -z is +x there.
    let along = if a.place.passage.count > 0 {
        a.velocity.x
    } else {
        -a.velocity.z
    };
    let momentum = 6.0 * along + 2.0 * b.velocity.x;
    assert!(
        (momentum / 18.0 - 1.0).abs() < 0.01,
        "{momentum}: {a:?} {b:?}"
    );
    let kinetic = 3.0 * a.velocity.length_squared() + b.velocity.length_squared();
    assert!(kinetic < 27.0 * 1.01, "{kinetic}");
}

/// Looks there and does that for a while.
pub fn go(scene: &mut RoomScene, aim: (f64, f64), steer: &Steer, seconds: f64) {
    scene.aim(aim.0, aim.1);
    for _ in 0..(seconds * 60.0).round() as u32 {
        scene.step(steer);
    }
}

pub const GRASP: Steer = Steer {
    grasp: true,
    ..crate::AHEAD
};

pub fn once(scene: &mut RoomScene, steer: Steer) {
    scene.step(&Steer {
        forward: 0.0,
        ..steer
    });
}

#[test]
fn who_walks_into_a_crate_pushes_it_and_a_heavy_one_stays() {
    let mut scene = with(&[
        "add box name=light at=0,0.4,-2 size=0.8,0.8,0.8 mass=20",
        "add box name=heavy at=3,0.4,-2 size=0.8,0.8,0.8 mass=900",
    ]);
    go(&mut scene, (-90.0, 0.0), &crate::AHEAD, 2.0);
    let light = state(&scene, "light");
    assert!(light.point.z < -4.0, "{light:?}");
    assert!(scene.feet().z < -3.0, "{}", scene.feet());
    scene.teleport(DVec3::new(3.0, 0.0, 0.0)).unwrap();
    go(&mut scene, (-90.0, 0.0), &crate::AHEAD, 2.0);
    let heavy = state(&scene, "heavy");
    assert!(
        heavy.point.distance(DVec3::new(3.0, 0.4, -2.0)) < 0.05,
        "{heavy:?}"
    );
    assert!(scene.feet().z > -1.6, "it is in the way: {}", scene.feet());
}

#[test]
fn a_crate_is_pushed_through_a_door_that_leads_elsewhere() {
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add box name=crate at=0,0.4,-8.5 size=0.8,0.8,0.8 mass=20",
    ]);
    scene.teleport(DVec3::new(0.0, 0.0, -6.0)).unwrap();
    go(&mut scene, (-90.0, 0.0), &crate::AHEAD, 1.9);
    let pushed = state(&scene, "crate");
    assert_eq!(pushed.place.passage.count, 1, "{pushed:?}");
    assert!(
        pushed.point.x > 30.2 && pushed.point.z.abs() < 1.0,
        "{pushed:?}"
    );
}

#[test]
fn what_is_lifted_comes_along_through_a_door_and_is_thrown() {
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add box name=crate at=0,0.25,-1.6 size=0.5,0.5,0.5 mass=8",
    ]);
    wait(&mut scene, 0.5);
    scene.aim(-90.0, -40.0);
    once(&mut scene, GRASP);
    go(&mut scene, (-90.0, 0.0), &Steer::default(), 1.0);
    let held = state(&scene, "crate");
    assert!(held.point.y > 1.2 && held.point.z < -0.8, "{held:?}");
    go(&mut scene, (-90.0, 0.0), &crate::AHEAD, 3.0);
    let carried = state(&scene, "crate");
    assert_eq!(carried.place.passage.count, 1, "{carried:?}");
    assert!(scene.feet().x > 30.5, "{}", scene.feet());
    assert!(
        carried.point.distance(scene.eye().place.point) < 2.0,
        "{carried:?}"
    );
    once(
        &mut scene,
        Steer {
            throw: true,
            ..Steer::default()
        },
    );
    wait(&mut scene, 0.3);
    let thrown = state(&scene, "crate");
    assert!(thrown.velocity.x > 6.0, "{thrown:?}");
}

#[test]
fn a_bullet_pushes_what_it_hits_through_a_door() {
    let mut scene = with(&[
        DOOR[0],
        DOOR[1],
        "add ball name=ball at=34,0.5,0 radius=0.5 mass=4",
    ]);
    wait(&mut scene, 1.0);
    scene.teleport(DVec3::new(0.0, 0.0, -7.0)).unwrap();
    scene.aim(-90.0, -8.5);
    assert_eq!(scene.pick().object.as_deref(), Some("ball"));
    let before = state(&scene, "ball").point;
    once(
        &mut scene,
        Steer {
            shoot: true,
            ..Steer::default()
        },
    );
    wait(&mut scene, 1.0);
    let after = state(&scene, "ball").point;
    assert!(after.x - before.x > 0.5, "{before} {after}");
}

#[test]
fn what_falls_onto_who_walks_does_not_go_into_them() {
    let mut scene = with(&["add box name=crate at=0.1,4,0 size=0.6,0.6,0.6 mass=12"]);
    for _ in 0..180 {
        scene.step(&Steer::default());
        let it = state(&scene, "crate");
        let eye = scene.eye().place.point;
        let inside = (it.turn.inverse() * (eye - it.point)).abs().max_element() < 0.3;
        assert!(!inside, "{it:?}");
    }
    assert!(scene.probe().player.grounded);
}

#[test]
fn a_pile_comes_to_rest_and_stays_a_pile() {
    let stacked = (0..12).map(|it| {
        let (x, y) = (
            4.0 + 0.62 * f64::from(it % 4),
            0.35 + 0.7 * f64::from(it / 4),
        );
        format!("add box name=c{it} at={x},{y},0 size=0.6,0.6,0.6 mass=12")
    });
    let stacked: Vec<_> = stacked.collect();
    let mut scene = with(&stacked.iter().map(String::as_str).collect::<Vec<_>>());
    wait(&mut scene, 8.0);
    let all = scene.loose_states();
    assert!(all.iter().all(|it| it.rests), "{all:?}");
    let top = all
        .iter()
        .filter(|it| (it.point.y - 1.5).abs() < 0.05)
        .count();
    assert_eq!(top, 4, "{all:?}");
}

#[test]
fn astride_the_door_of_a_tunnel_what_is_inside_is_met_by_its_felt_length() {
    // Five times as long inside: a block 0.3 m beyond the door feels 1.5 m off, and 0.8 m of the crate are in there.
    let tunnel = "add aberration name=tunnel at=0,1.24,-12 half=1,1.26,4 axis=z felt=40";
    for (block, meets) in [(-8.3, false), (-8.1, true)] {
        let z = block - 0.25;
        let mut scene = with(&[
            tunnel,
            &format!("add box name=block at=0,0.5,{z} size=1,1,0.5"),
            "add box name=crate at=0,0.31,-7.9 size=0.6,0.6,1.8 mass=20",
        ]);
        wait(&mut scene, 4.0);
        let it = state(&scene, "crate");
        assert!(it.astride && it.place.stack.is_empty(), "{it:?}");
        // With its middle 0.1 m before the door, and 0.5 m felt to the block, it has to give way.
        let moved = it.point.z + 7.9;
        assert!(
            if meets {
                moved > 0.25
            } else {
                moved.abs() < 0.03
            },
            "{block}: {it:?}"
        );
        // What is in there takes up a fifth of its length of the scene.
        let solids = scene.now().things;
        assert_eq!(solids.len(), 2);
        assert!(solids.iter().all(|it| it.cut.is_some()));
        let length = |it: &antipode_rays::Mover| it.pose.matrix3.z_axis.length();
        assert!((length(&solids[0]) - 1.0).abs() < 0.02 && (length(&solids[1]) - 0.2).abs() < 0.02);
    }
}
