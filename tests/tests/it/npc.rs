//! Other figures in whole games by script: the player's keys on one side, what a probe tells of them on the other.

use antipode_tests::program::{Run, comparable, field, number, run};
use serde_json::Value;

#[test]
fn anger_outlasts_leaving_and_passes() {
    let saves = tempfile::tempdir().unwrap();
    let there = play("new euclidean seed=3\nset npcs off\nwait 1\nprobe");
    let feet = [0, 1, 2].map(|axis| number(there.probe(0), &format!("player.pos.{axis}")));
    let place = format!("{} {} {} A", feet[0] - 2.5, feet[1] + 6.0, feet[2] + 1.0);
    let begin = format!(
        "new euclidean seed=3 name=Angry\nset npcs off\nwait 1\ntap Digit1\nspawn bot {place}\nwait 1.6\n"
    );
    let looked = play(&format!("{}probe", begin.replace(" name=Angry", "")));
    let (yaw, pitch) = at_bot(looked.probe(0));
    let script = format!("{begin}aim {yaw} {pitch}\nclick LEFT\nwait 0.5\nsave\nprobe");
    assert_eq!(bot(run(saves.path(), &script).probe(0), 0)["hostile"], true);
    let back = "load Angry\nset npcs off\nset fly on\nprobe\nwait 45\nprobe";
    let back = run(saves.path(), back);
    assert_eq!(
        bot(back.probe(0), 0)["hostile"],
        true,
        "forgotten on leaving"
    );
    assert_eq!(bot(back.probe(1), 0)["hostile"], false, "never forgiven");
}

/// A world of each space in which the player stands; in the closed one by the equator.
const WORLDS: [(&str, &str); 3] = [
    ("new euclidean seed=3", ""),
    ("new hyperbolic seed=3", ""),
    ("new spherical seed=3 generator=1", "teleport 46 16 0\n"),
];

fn play(script: &str) -> Run {
    let saves = tempfile::tempdir().unwrap();
    run(saves.path(), script)
}

/// Runs a script in each world; a place is told from where the player stands then.
fn in_each(then: impl Fn(&dyn Fn(f64, f64) -> String) -> String, check: impl Fn(&str, &Run)) {
    for (new, arrive) in WORLDS {
        let begin = format!("{new}\nset npcs off\n{arrive}wait 1\n");
        let there = play(&format!("{begin}probe"));
        let feet = [0, 1, 2].map(|axis| number(there.probe(0), &format!("player.pos.{axis}")));
        // From six metres up it comes down on whatever is there, unhurt.
        let place =
            |dx: f64, dz: f64| format!("{} {} {} A", feet[0] + dx, feet[1] + 6.0, feet[2] + dz);
        check(new, &play(&format!("{begin}{}", then(&place))));
    }
}

fn bot(probe: &Value, index: usize) -> &Value {
    field(probe, &format!("bots.{index}"))
}

fn state(probe: &Value) -> &str {
    bot(probe, 0)["state"].as_str().unwrap()
}

/// Where to look to see a figure, in degrees: it is near, so that no space bends the way by more than a little.
fn at_bot(probe: &Value) -> (f64, f64) {
    let at = |of: &str| [0, 1, 2].map(|axis| number(probe, &format!("{of}.{axis}")));
    let (eye, feet) = (at("camera.pos"), at("bots.0.pos"));
    let (x, y, z) = (feet[0] - eye[0], feet[1] + 0.9 - eye[1], feet[2] - eye[2]);
    (z.atan2(x).to_degrees(), y.atan2(x.hypot(z)).to_degrees())
}

#[test]
fn a_hostile_one_comes_keeps_off_and_shoots_after_four_seconds() {
    in_each(
        |place| {
            let far = place(-18.0, 4.0);
            format!("spawn hostile {far}\nwait 2\nprobe\nwait 1.5\nprobe\nwait 12\nprobe")
        },
        |world, run| {
            let early = run.probe(0);
            assert!(
                matches!(state(early), "chase" | "fight"),
                "{world}: {early}"
            );
            assert_eq!(
                field(run.probe(1), "projectiles").as_array().unwrap().len(),
                0
            );
            let late = run.probe(2);
            assert_eq!(state(late), "fight", "{world}");
            assert!(
                number(late, "player.health") < 20.0,
                "{world}: nobody was hit"
            );
        },
    );
}

#[test]
fn a_peaceful_one_is_talked_to_by_t_and_fights_when_it_is_shot() {
    in_each(
        |place| {
            format!(
                "spawn bot {}\nwait 1.5\nset npcs still\nwait 0.1\nprobe",
                place(-2.5, 1.0)
            )
        },
        |world, run| {
            let (yaw, pitch) = at_bot(run.probe(0));
            let (new, arrive) = WORLDS.into_iter().find(|(new, _)| *new == world).unwrap();
            let feet = [0, 1, 2].map(|axis| number(run.probe(0), &format!("player.pos.{axis}")));
            let place = format!("{} {} {} A", feet[0] - 2.5, feet[1] + 6.0, feet[2] + 1.0);
            let again = play(&format!(
                "{new}\nset npcs off\n{arrive}wait 1\nspawn bot {place}\nwait 1.5\nset npcs still\nwait 0.1\n\
                 tap Digit1\naim {yaw} {pitch}\nwait 0.5\nset npcs off\ntap KeyT\nwait 0.2\nprobe\n\
                 click LEFT\nwait 1\nprobe"
            ));
            assert_eq!(
                state(again.probe(0)),
                "watch",
                "{world}: it does not listen"
            );
            assert_eq!(bot(again.probe(0), 0)["hostile"], false);
            assert_eq!(bot(again.probe(1), 0)["hostile"], true, "{world}");
            assert_eq!(state(again.probe(1)), "fight", "{world}");
        },
    );
}

#[test]
fn those_who_came_by_themselves_are_saved_and_the_same_in_each_run() {
    for space in ["euclidean", "spherical"] {
        let saves = tempfile::tempdir().unwrap();
        let script = format!("new {space} seed=5 name=Kept\nwait 8\nprobe\nsave\nwait 4\nprobe");
        let first = run(saves.path(), &script);
        let there = field(first.probe(0), "bots").as_array().unwrap();
        // As many as a new world has: half of what an older one has, and peaceful.
        let most = if space == "spherical" { 3 } else { 4 };
        assert_eq!(there.len(), most, "{space}");
        assert!(there.iter().all(|bot| bot["hostile"] == false), "{space}");
        let back = run(saves.path(), "load Kept\nset npcs still\nprobe");
        let at_end = field(first.probe(1), "bots").as_array().unwrap();
        let sitting: Vec<_> = at_end
            .iter()
            .filter(|bot| bot["state"] == "sit")
            .map(|bot| bot["id"].clone())
            .collect();
        assert!(sitting.len() < most, "{space}: nobody is left to compare");
        let places = |probe: &Value| {
            let bots = field(probe, "bots").as_array().unwrap();
            // Who sits on a stone is saved where he stands when he gets up.
            let kept = bots
                .iter()
                .filter(|bot| !sitting.contains(&bot["id"]))
                .map(|bot| (bot["pos"].clone(), bot["hostile"].clone()));
            kept.collect::<Vec<_>>()
        };
        // The world is saved on leaving, as it was then.
        assert_eq!(places(first.probe(1)), places(back.probe(0)), "{space}");
        let other = tempfile::tempdir().unwrap();
        let second = run(other.path(), &script);
        for n in 0..2 {
            assert_eq!(
                comparable(first.probe(n)),
                comparable(second.probe(n)),
                "{space}"
            );
        }
    }
}
