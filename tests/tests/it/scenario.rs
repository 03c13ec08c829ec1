//! Whole games by script: what a player does must come out, and come back after saving.

use antipode_tests::program::{comparable, field, game, number, run};
use serde_json::Value;

const SPACES: [&str; 3] = ["euclidean", "hyperbolic", "spherical"];

#[test]
fn walking_digging_building_saving_and_loading_bring_the_same_world_back() {
    for space in SPACES {
        let saves = tempfile::tempdir().unwrap();
        let script = format!(
            "new {space} seed=11 name=Kept\nhold KeyW 1\naim -60 -50\ntap Digit4\nhold LEFT 1\nlook 400 0\ntap Digit3\n\
             hold RIGHT 0.5\ntap ArrowUp\nscroll 2\nwait 2.5\nprobe\nsave"
        );
        let before = run(saves.path(), &script);
        let again = run(saves.path(), "load Kept\nprobe");
        let (before, after) = (before.probe(0), again.probe(0));
        assert_eq!(kept(before), kept(after), "{space}");
        assert_eq!(
            field(before, "chunks.edited"),
            field(after, "chunks.edited"),
            "{space}"
        );
        assert!(
            number(before, "chunks.edited") >= 1.0,
            "{space}: nothing was dug"
        );
        assert_eq!(field(before, "t"), field(after, "t"), "{space}");
    }
}

/// What a save keeps of a probe: others are where they were, but what they were about begins anew.
fn kept(probe: &Value) -> Value {
    let mut kept = comparable(probe);
    for bot in kept["bots"].as_array_mut().unwrap() {
        bot.as_object_mut().unwrap().remove("state");
    }
    kept
}

#[test]
fn a_stroke_is_counted_and_undone() {
    for space in SPACES {
        let saves = tempfile::tempdir().unwrap();
        let script = format!(
            "new {space} seed=11\nset npcs off\nwait 0.5\naim -60 -50\ntap Digit4\nhold LEFT 0.5\nwait 1.5\nprobe\n\
             undo\nwait 1.5\nprobe\nundo\nwait 0.5\nprobe"
        );
        let run = run(saves.path(), &script);
        let dug = field(run.probe(0), "terrain.dug").as_object().unwrap();
        let total: f64 = dug.values().filter_map(Value::as_f64).sum();
        assert!(total > 1.0, "{space}: {dug:?}");
        assert!(number(run.probe(0), "chunks.edited") >= 1.0, "{space}");
        for undone in [run.probe(1), run.probe(2)] {
            assert_eq!(number(undone, "chunks.edited"), 0.0, "{space}");
            assert!(undone["terrain"].get("dug").is_none(), "{space}: {undone}");
        }
    }
}

#[test]
fn a_new_player_has_ground_in_reach_under_the_crosshair() {
    for space in SPACES {
        for seed in [1, 3, 7, 9, 12] {
            let saves = tempfile::tempdir().unwrap();
            let run = run(
                saves.path(),
                &format!("new {space} seed={seed}\nwait 0.5\nprobe"),
            );
            let probe = run.probe(0);
            let pitch = number(probe, "player.pitch");
            assert!((-45.0..-2.0).contains(&pitch), "{pitch} degrees");
            let at = |of: &str| [0, 1, 2].map(|axis| number(probe, &format!("{of}.{axis}")));
            let (eye, marker) = (at("camera.pos"), at("marker.pos"));
            let off: f64 = eye.iter().zip(marker).map(|(a, b)| (a - b).powi(2)).sum();
            assert!(off.sqrt() < 22.0, "{space} {seed}: {} m off", off.sqrt());
        }
    }
}

#[test]
fn the_same_script_gives_the_same_probes() {
    let script = "new hyperbolic seed=5\nhold KeyW 2\naim 30 -40\nhold LEFT 1.2\nhold KeyD 1\ntap Space\nwait 0.5\nprobe\nhold KeyS 1\nprobe";
    let saves = tempfile::tempdir().unwrap();
    let (a, b) = (run(saves.path(), script), run(saves.path(), script));
    for n in 0..2 {
        assert_eq!(comparable(a.probe(n)), comparable(b.probe(n)));
    }
}

#[test]
fn a_player_walks_at_walking_speed_sprints_faster_and_jumps_its_height() {
    let saves = tempfile::tempdir().unwrap();
    let script = "new euclidean seed=3\nwait 1\nprobe\ntap Space\nwait 0.3\nprobe\nwait 2\nset fly on\nteleport 0 60 0\n\
                  aim 0 0\nhold KeyW 1\nprobe";
    let run = run(saves.path(), script);
    assert_eq!(
        field(run.probe(0), "player.grounded"),
        true,
        "stands on the ground after a second"
    );
    let rise = number(run.probe(1), "player.pos.1") - number(run.probe(0), "player.pos.1");
    assert!((0.8..=1.3).contains(&rise), "jumped {rise} m");
    assert_eq!(
        number(run.probe(2), "player.pos.1"),
        60.0,
        "flight keeps its height"
    );
    assert!(number(run.probe(2), "player.pos.0") > 3.0);
}

#[test]
fn digging_lowers_the_ground_where_the_marker_lies_and_building_raises_it() {
    for space in SPACES {
        let saves = tempfile::tempdir().unwrap();
        let script = format!(
            "new {space} seed=21\nwait 0.5\ntap Digit4\naim 0 -89\nprobe\nhold LEFT 2\nwait 1.5\nprobe\n\
             hold RIGHT 3\nwait 1\nprobe"
        );
        let run = run(saves.path(), &script);
        let feet = |n| number(run.probe(n), "player.pos.1");
        assert!(
            feet(1) < feet(0) - 1.0,
            "{space}: after digging the feet went from {} to {}",
            feet(0),
            feet(1)
        );
        assert!(
            feet(2) > feet(1) + 1.0,
            "{space}: after building the feet went from {} to {}",
            feet(1),
            feet(2)
        );
        let ground = number(run.probe(2), "terrain.ground_height");
        assert!(
            feet(2) > ground - 0.3,
            "{space}: buried, feet {} under ground {ground}",
            feet(2)
        );
    }
}

#[test]
fn a_stronger_pickaxe_digs_faster() {
    let depth = |key: &str| {
        let saves = tempfile::tempdir().unwrap();
        let script = format!(
            "new euclidean seed=3\nwait 1\nprobe\ntap {key}\naim 0 -89\nhold LEFT 1.5\nwait 1\nprobe"
        );
        let run = run(saves.path(), &script);
        number(run.probe(0), "player.pos.1") - number(run.probe(1), "player.pos.1")
    };
    let (wood, iron, diamond) = (depth("Digit2"), depth("Digit3"), depth("Digit4"));
    assert!(wood < iron && iron < diamond, "{wood} {iron} {diamond}");
}

#[test]
fn nobody_falls_through_ground_that_is_not_there_yet() {
    for space in ["euclidean", "hyperbolic"] {
        let saves = tempfile::tempdir().unwrap();
        let run = run(
            saves.path(),
            &format!("new {space} seed=9\nteleport 5000 45 -7000\nwait 6\nprobe"),
        );
        let (feet, ground) = (
            number(run.probe(0), "player.pos.1"),
            number(run.probe(0), "terrain.ground_height"),
        );
        assert!(
            (feet - ground).abs() < 0.7,
            "{space}: feet at {feet}, ground at {ground}"
        );
        assert_eq!(field(run.probe(0), "player.grounded"), true);
    }
}

#[test]
fn a_great_circle_flown_at_constant_height_comes_home_through_the_other_hemisphere() {
    let saves = tempfile::tempdir().unwrap();
    // 2 pi 32 m on the plane are 163.1 m at the height of 20 m, at 8 m/s; the tuning of flight is read from a second of it.
    let mut script = String::from(
        "new spherical seed=4 radius=32\nset fly on\nteleport 0 20 0\naim 30 0\nprobe\ndown KeyW\n",
    );
    for _ in 0..1300 {
        script.push_str("wait 0.0166667\nprobe\n");
    }
    let run = run(saves.path(), &script);
    let mut sides = vec![field(run.probe(0), "player.hemisphere").clone()];
    let mut nearest = f64::MAX;
    for n in 1..=1300 {
        let probe = run.probe(n);
        let side = field(probe, "player.hemisphere");
        if sides.last() != Some(side) {
            sides.push(side.clone());
        }
        assert_eq!(number(probe, "player.pos.1"), 20.0, "the height stays");
        if sides.len() == 3 {
            nearest =
                nearest.min(number(probe, "player.pos.0").hypot(number(probe, "player.pos.2")));
        }
    }
    assert_eq!(sides, ["A", "B", "A"]);
    assert!(nearest < 0.2, "came back only to within {nearest} m");
    let yaw = number(run.probe(1300), "player.yaw");
    assert!(
        (yaw - 30.0).abs() < 1e-6,
        "came home looking along {yaw} degrees"
    );
}

#[test]
fn walking_over_the_equator_works_twice() {
    let saves = tempfile::tempdir().unwrap();
    let mut script = String::from(
        "new spherical seed=4 radius=16\nwait 0.5\naim 0 0\ndown KeyW\ndown ShiftLeft\ndown Space\n",
    );
    for _ in 0..60 {
        script.push_str("wait 0.5\nprobe\n");
    }
    let run = run(saves.path(), &script);
    let mut crossings = 0;
    for n in 1..60 {
        if field(run.probe(n), "player.hemisphere") != field(run.probe(n - 1), "player.hemisphere")
        {
            crossings += 1;
        }
        let (feet, ground) = (
            number(run.probe(n), "player.pos.1"),
            number(run.probe(n), "terrain.ground_height"),
        );
        assert!(
            feet > ground - 0.5,
            "probe {n}: feet {feet} m in ground at {ground} m"
        );
    }
    assert!(crossings >= 2, "crossed {crossings} times");
}

#[test]
fn a_closed_world_of_a_script_is_of_32_metres_unless_it_says_otherwise() {
    let saves = tempfile::tempdir().unwrap();
    for (line, radius) in [
        ("new spherical seed=4", 32.0),
        ("new spherical seed=4 radius=100", 100.0),
    ] {
        let run = run(saves.path(), &format!("{line}\nprobe"));
        assert_eq!(field(run.probe(0), "radius"), radius, "{line}");
    }
}

#[test]
fn mistakes_stop_a_script_with_their_line_and_status_two() {
    let saves = tempfile::tempdir().unwrap();
    for (script, line) in [
        ("probe", "line 1:"),
        ("new euclidean seed=1\nwait -1", "line 2:"),
        ("new euclidean seed=1\n\nset curvature 5", "line 3:"),
        ("new spherical radius=999", "line 1:"),
        ("new euclidean\nteleport 0 0 0 B", "line 2:"),
        ("new euclidean\nsave", "line 2:"),
        ("new euclidean\nshot a.png", "line 2:"),
    ] {
        let run = run(saves.path(), script);
        assert_eq!(run.status, Some(2), "{script}: {}", run.stderr);
        assert!(run.stderr.contains(line), "{script}: {}", run.stderr);
        assert_eq!(
            run.stderr.trim().lines().count(),
            1,
            "one line says it: {}",
            run.stderr
        );
    }
    let missing = run(saves.path(), "load Nowhere");
    assert_eq!(missing.status, Some(1), "{}", missing.stderr);
    assert!(missing.stderr.contains("Nowhere"), "{}", missing.stderr);
}

#[test]
fn worlds_are_listed_and_deleted_and_the_open_one_is_not() {
    let saves = tempfile::tempdir().unwrap();
    let run = run(
        saves.path(),
        "new euclidean seed=1 name=First\nnew hyperbolic seed=2 name=\"Zweite Welt\"\nlist\ndelete first\nlist\ndelete \"zweite welt\"",
    );
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert_eq!(run.lines[0].as_array().map(Vec::len), Some(2));
    assert_eq!(run.lines[1].as_array().map(Vec::len), Some(1));
    assert!(run.stderr.contains("line 6"), "{}", run.stderr);
}

#[test]
fn curvature_glides_to_where_the_wheel_sets_it_and_slots_follow_elsewhere() {
    let saves = tempfile::tempdir().unwrap();
    let run = run(
        saves.path(),
        "new hyperbolic seed=1\nscroll 3\nprobe\ndown AltLeft\nscroll 1\nprobe\nnew euclidean seed=1\nscroll -1\nprobe",
    );
    assert_eq!(number(run.probe(0), "curvature"), 13.0);
    assert_eq!(number(run.probe(1), "curvature"), 13.0);
    assert_eq!(
        run.probe(1)["item"],
        "gun",
        "one slot to the left of the pickaxes is the gun"
    );
    assert_eq!(run.probe(2)["curvature"], Value::Null);
    assert_eq!(run.probe(2)["item"], "pickaxe-iron");
}

#[test]
fn a_repair_that_lost_the_land_says_so() {
    let saves = tempfile::tempdir().unwrap();
    let made = run(
        saves.path(),
        "new euclidean seed=1 name=Lost\naim 0 -60\nhold LEFT 0.5\nsave",
    );
    assert_eq!(made.status, Some(0), "{}", made.stderr);
    std::fs::remove_file(saves.path().join("lost").join("world.redb")).unwrap();
    let repaired = game(saves.path())
        .args(["saves", "repair", "Lost"])
        .output()
        .unwrap();
    let said = String::from_utf8(repaired.stdout).unwrap();
    assert!(
        repaired.status.success() && !said.contains("sound"),
        "{said}"
    );
    assert!(
        said.lines().count() >= 2,
        "what was lost is not told: {said}"
    );
}

#[test]
fn a_world_in_which_a_command_cheated_is_marked_and_others_are_not() {
    let saves = tempfile::tempdir().unwrap();
    run(
        saves.path(),
        "new euclidean seed=3 name=Fair\nhold KeyW 0.5\nset view-distance 2\nset bend 3\nsave\n\
         new euclidean seed=3 name=Foul\ngive pickaxe-iron 1\nsave",
    );
    let marked = |name: &str| {
        let world = antipode_storage::SavesDir::new(saves.path())
            .find(name)
            .unwrap();
        world.meta.unwrap().cheated
    };
    assert!(!marked("Fair") && marked("Foul"));
    run(saves.path(), "load Foul\nwait 0.1\nsave");
    assert!(marked("Foul"), "the mark stays");
}
