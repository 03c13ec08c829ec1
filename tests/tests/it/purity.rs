//! One script gives the same probes whatever is chosen of the picture and the machine, and whether pictures are taken.
//!
//! `ANTIPODE_TEST_LONG=1` plays ten minutes in place of one round.

use std::path::Path;

use antipode_testing::may_skip;
use antipode_tests::program::{comparable, field, number, run, run_with};
use serde_json::Value;

/// Settings that have no part in the world: language, sound, comfort, and the width of the view.
const SETTINGS: &str = "(schema: 1, settings: {\"language\": \"de\", \"reduced-motion\": true, \"head-dip\": false, \
                        \"volume-master\": 0.0, \"field-of-view\": 100.0, \"ui-scale\": 1.5})";

const WAYS: [&[&str]; 3] = [
    &["--adapter", "software", "--size", "320x200", "--config"],
    &[
        "--adapter",
        "none",
        "--view-distance",
        "2",
        "--quality",
        "fast",
        "--config",
    ],
    &[
        "--adapter",
        "none",
        "--view-distance",
        "8",
        "--size",
        "1920x1080",
        "--quality",
        "exact",
    ],
];

/// Rounds in which a car is put there: a world has places for as many, and one from the start.
const CARS: usize = 15;

/// Half a minute: digging while the picture glides, building, a fight, a drive, and a walk that in a small closed world
/// leads over the equator. A probe at each end.
fn round(space: &str, [x, y, z]: [f64; 3], number: usize) -> String {
    let dial = if space == "spherical" {
        ""
    } else {
        "tap KeyH\nscroll 5\n"
    };
    let (car, foe) = (x + 2.2, x + 9.0);
    let spawn = if number < CARS {
        format!("spawn car {car} {y} {z}\n")
    } else {
        String::new()
    };
    format!(
        "set health 20\naim 30 -40\n{dial}tap Digit3\nhold LEFT 1.2\nhold KeyD 1\ntap Space\nhold RIGHT 0.4\nwait 0.5\n\
         probe\nspawn hostile {foe} {} {z}\naim 0 -2\ntap Digit1\nhold LEFT 0.1\nwait 3\nhold LEFT 0.1\nwait 2\n\
         probe\nset health 20\nteleport {x} {y} {z}\n{spawn}wait 1.5\naim 0 -20\ntap KeyC\nhold KeyW 3\nprobe\n\
         hold Space 2\ntap KeyL\nwait 0.5\nteleport {x} {y} {z}\naim 0 0\ndown ShiftLeft\nhold KeyW 12\nup ShiftLeft\nprobe\n",
        y + 0.5
    )
}

fn script(space: &str, start: [f64; 3]) -> String {
    let long = std::env::var("ANTIPODE_TEST_LONG").is_ok_and(|it| it == "1");
    let rounds = if long { 20 } else { 1 };
    let new = new(space);
    let rounds = (0..rounds).map(|number| round(space, start, number));
    format!("{new}\nhold KeyW 2\n") + &rounds.collect::<String>()
}

fn new(space: &str) -> String {
    let radius = if space == "spherical" {
        " radius=16"
    } else {
        ""
    };
    format!("new {space} seed=5{radius}")
}

/// Where a new player stands, a little over the ground.
fn start(saves: &Path, space: &str) -> [f64; 3] {
    let new = run(saves, &format!("{}\nwait 1\nprobe", new(space)));
    let at = |axis| number(new.probe(0), &format!("player.pos.{axis}"));
    [at(0), at(1) + 0.3, at(2)]
}

/// What of a probe is the world's.
fn simulated(probe: &Value) -> Value {
    let mut simulated = comparable(probe);
    for picture in ["quality", "picture"] {
        simulated.as_object_mut().unwrap().remove(picture);
    }
    simulated
}

fn is_the_same(space: &str) {
    let saves = tempfile::tempdir().unwrap();
    let file = saves.path().join("chosen.ron");
    std::fs::write(&file, SETTINGS).unwrap();
    let script = script(space, start(saves.path(), space));
    let usual = run(saves.path(), &script);
    assert_eq!(field(usual.probe(2), "player.in_car"), true, "{space}");
    for options in WAYS {
        let mut options = options.to_vec();
        if options.last() == Some(&"--config") {
            options.push(file.to_str().unwrap());
        }
        // A picture is taken where something draws.
        let draws = !options.contains(&"none");
        let shots = script.replace("probe\n", "shot seen.png\nprobe\n");
        let other = run_with(saves.path(), if draws { &shots } else { &script }, &options);
        if draws && other.status != Some(0) && may_skip("a software adapter") {
            continue;
        }
        assert!(!other.stderr.contains("chosen.ron"), "{}", other.stderr);
        assert_eq!(usual.lines.len(), other.lines.len(), "{}", other.stderr);
        for n in 0..usual.lines.len() {
            let (a, b) = (simulated(usual.probe(n)), simulated(other.probe(n)));
            assert_eq!(a, b, "{space} with {options:?}, probe {n}");
        }
    }
}

#[test]
fn a_flat_world_is_the_same_whatever_is_chosen_of_the_picture_and_the_machine() {
    is_the_same("euclidean");
}

#[test]
fn a_hyperbolic_world_is_the_same_whatever_is_chosen_of_the_picture_and_the_machine() {
    is_the_same("hyperbolic");
}

#[test]
fn a_closed_world_is_the_same_whatever_is_chosen_of_the_picture_and_the_machine() {
    is_the_same("spherical");
}
