//! The other picture of a space: the horizon map, the bend of a flat world, and what the program tells of them.

use std::fmt::Write;
use std::path::Path;

use antipode_testing::may_skip;
use antipode_tests::program::{comparable, field, number, run, run_with};
use antipode_tests::seam::{Difference, compare, picture};
use serde_json::Value;

const SMALL: [&str; 4] = ["--size", "320x180", "--view-distance", "2"];

/// Whether there is an adapter to draw with; the first picture tells.
fn no_adapter(saves: &Path) -> bool {
    let options = ["--size", "64x64", "--view-distance", "1"];
    let probe = run_with(saves, "new euclidean seed=4\nshot probe.png", &options);
    probe.status != Some(0) && may_skip(&format!("a graphics adapter ({})", probe.stderr.trim()))
}

#[test]
fn the_key_turns_the_map_and_each_map_keeps_its_own_dial() {
    let saves = tempfile::tempdir().unwrap();
    let run = run(
        saves.path(),
        "new hyperbolic seed=1\nset curvature 14\nprobe\ntap KeyH\nscroll 2\nprobe\nwait 3\ntap KeyH\nprobe\n\
         set map horizon\nprobe",
    );
    let told = |n| {
        (
            field(run.probe(n), "map").as_str(),
            number(run.probe(n), "curvature"),
        )
    };
    assert_eq!(told(0), (Some("raised"), 14.0));
    assert_eq!(told(1), (Some("horizon"), 12.0));
    assert_eq!(told(2), (Some("raised"), 14.0));
    assert_eq!(told(3), (Some("horizon"), 12.0));
    assert_eq!(field(run.probe(3), "bend"), &Value::Null);
}

#[test]
fn a_flat_world_bends_by_key_wheel_and_order() {
    let saves = tempfile::tempdir().unwrap();
    let run = run(
        saves.path(),
        "new euclidean seed=1\nscroll -1\nprobe\ntap KeyH\nscroll -6\nprobe\ntap KeyH\nscroll 1\nprobe\n\
         set bend 30e-1\nprobe\nset bend 0\nprobe",
    );
    let bend = |n| field(run.probe(n), "bend").as_f64();
    let item = |n| field(run.probe(n), "item").as_str();
    assert_eq!((bend(0), item(0)), (None, Some("pickaxe-iron")));
    assert_eq!((bend(1), item(1)), (Some(-6.0), item(0)), "the wheel bends");
    assert_eq!(bend(2), None);
    assert_ne!(item(2), item(1), "the wheel moves along the hotbar again");
    assert_eq!((bend(3), bend(4)), (Some(3.0), None));
    for n in 0..5 {
        let told = |name| field(run.probe(n), name);
        assert_eq!(
            (told("map"), told("curvature")),
            (&Value::Null, &Value::Null)
        );
        assert_eq!(
            (told("radius"), told("quality")),
            (&Value::Null, &Value::from("balanced"))
        );
    }
}

#[test]
fn map_dials_and_bend_come_back_with_a_saved_world() {
    let saves = tempfile::tempdir().unwrap();
    let told =
        |probe: &Value| ["map", "curvature", "bend"].map(|name| field(probe, name).to_string());
    for (name, orders, kept, other, turned) in [
        (
            "Kept",
            "new hyperbolic seed=2 name=Kept\nset curvature 3\ntap KeyH\nscroll -4\nwait 0.1",
            ["\"horizon\"", "6.0", "null"],
            "tap KeyH",
            ["\"raised\"", "3.0", "null"],
        ),
        (
            "Bent",
            "new euclidean seed=2 name=Bent\ntap KeyH\nscroll 7",
            ["null", "null", "7.0"],
            "tap KeyH",
            ["null"; 3],
        ),
        (
            "Unbent",
            "new euclidean seed=2 name=Unbent\nset bend 5\ntap KeyH\nwait 2",
            ["null"; 3],
            "tap KeyH",
            ["null", "null", "5.0"],
        ),
    ] {
        let before = run(saves.path(), &format!("{orders}\nprobe\nsave"));
        assert_eq!(told(before.probe(0)), kept, "{name}");
        let after = run(saves.path(), &format!("load {name}\nprobe\n{other}\nprobe"));
        assert_eq!(told(after.probe(0)), kept, "{name} after loading");
        assert_eq!(told(after.probe(1)), turned, "{name}, the other picture");
    }
}

#[test]
fn a_space_without_the_thing_refuses_it_in_words() {
    let saves = tempfile::tempdir().unwrap();
    for (script, says) in [
        (
            "new spherical\nset map horizon",
            "line 2: this space has no other map",
        ),
        (
            "new euclidean\nset map raised",
            "line 2: this space has no other map",
        ),
        (
            "new hyperbolic\nset bend 1",
            "line 2: only a flat world can be bent",
        ),
        (
            "new spherical\nset bend 0",
            "line 2: only a flat world can be bent",
        ),
        (
            "new euclidean\nset bend 3\nset curvature 3",
            "line 3: this space has no curvature dial",
        ),
        (
            "new euclidean\nset bend 21",
            "line 2: 21 is out of range (-20 to 20)",
        ),
        (
            "new hyperbolic\nset map flat",
            "line 2: there is no map \"flat\"",
        ),
        (
            "new hyperbolic\nset quality best",
            "line 2: there is no quality \"best\"",
        ),
    ] {
        let run = run(saves.path(), script);
        assert_eq!(run.status, Some(2), "{script}: {}", run.stderr);
        assert!(run.stderr.contains(says), "{script}: {}", run.stderr);
    }
    let sphere = run(
        saves.path(),
        "new spherical seed=1\nprobe\ntap KeyH\nwait 1\nprobe",
    );
    let still = |n| comparable(sphere.probe(n))["camera"].clone();
    assert_eq!(
        still(0)["mode"],
        still(1)["mode"],
        "the key changes nothing on a sphere"
    );
    assert_eq!(field(sphere.probe(1), "map"), &Value::Null);
}

#[test]
fn quality_comes_from_the_command_line_and_stays_over_worlds_once_set() {
    let saves = tempfile::tempdir().unwrap();
    let script =
        "new euclidean seed=1\nprobe\nset quality exact\nprobe\nnew euclidean seed=1\nprobe";
    let run = run_with(
        saves.path(),
        script,
        &["--adapter", "none", "--quality", "fast"],
    );
    for (n, quality) in ["fast", "exact", "exact"].into_iter().enumerate() {
        assert_eq!(field(run.probe(n), "quality"), quality);
        assert_eq!(field(run.probe(n), "picture"), &Value::Null);
    }
}

/// A place in the air over some land from which nothing moves by itself, nor leaves in the wind, without display and marker.
const ALOFT: &str = "seed=7 generator=2\nset fly on\nteleport 0 40 0\nsettle\ndown F1\nup F1\ntap Digit1\naim 20 -12\nset time 60";

/// Makes pictures a.png and b.png by orders in a world and returns their difference.
fn pair(saves: &Path, world: &str, a: &str, b: &str) -> Difference {
    let script = format!("new {world} {ALOFT}\n{a}\nshot a.png\n{b}\nset time 60\nshot b.png");
    let run = run_with(saves, &script, &SMALL);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    compare(
        &picture(&saves.join("a.png")),
        &picture(&saves.join("b.png")),
    )
}

#[test]
fn a_bend_of_nothing_is_the_flat_picture_pixel_for_pixel() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    for bend in ["set bend 0", "set bend 9\nset bend 0", "tap KeyH\nwait 0.1"] {
        let same = pair(saves.path(), "euclidean", "", bend);
        assert_eq!((same.mean, same.far_off), (0.0, 0.0), "{bend}");
    }
    for bend in [-10, 10] {
        let bent = pair(saves.path(), "euclidean", "", &format!("set bend {bend}"));
        assert!(
            bent.far_off > 0.05,
            "a bend of {bend} shows nothing: {bent:?}"
        );
    }
}

#[test]
fn the_maps_show_different_pictures_and_no_step_is_seen_where_they_are_swapped() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    let apart = pair(saves.path(), "hyperbolic", "", "set map horizon");
    assert!(apart.far_off > 0.05, "{apart:?}");
    // From ten to the hundredth at which the maps are swapped the dial takes 45 steps.
    for (first, other) in [("raised", "horizon"), ("horizon", "raised")] {
        let mut script =
            format!("new hyperbolic {ALOFT}\nset map {first}\ntap KeyH\nwait 0.666667\n");
        for n in 0..6 {
            writeln!(script, "set time 60\nshot {n}.png\nwait 0.0166667").unwrap();
        }
        write!(
            script,
            "wait 3\nset time 60\nshot turned.png\nset map {other}\nshot set.png"
        )
        .unwrap();
        let run = run_with(saves.path(), &script, &SMALL);
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        let shot = |name: &str| picture(&saves.path().join(format!("{name}.png")));
        for n in 0..5 {
            let step = compare(&shot(&n.to_string()), &shot(&(n + 1).to_string()));
            assert!(step.far_off < 0.002, "from {first}, step {n}: {step:?}");
        }
        assert_eq!(
            compare(&shot("turned"), &shot("set")).mean,
            0.0,
            "to {other}"
        );
    }
}

#[test]
fn frame_figures_show_on_demand_and_the_probe_tells_what_was_drawn() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    let key = |name: &str| format!("down {name}\nup {name}");
    let script = format!(
        "new hyperbolic {ALOFT}\n{f1}\nset quality fast\nprobe\nshot a.png\n{f4}\nshot b.png\nprobe\n{f4}\nshot c.png\n\
         {f1}\nshot d.png\n{f4}\nshot e.png",
        f1 = key("F1"),
        f4 = key("F4"),
    );
    let run = run_with(saves.path(), &script, &SMALL);
    assert_eq!(field(run.probe(0), "picture"), &Value::Null);
    let shot = |name: &str| picture(&saves.path().join(name));
    let (a, b) = (shot("a.png"), shot("b.png"));
    assert_eq!(
        compare(&a, &shot("c.png")).mean,
        0.0,
        "hidden unless asked for"
    );
    assert!(compare(&a, &b).far_off > 0.005);
    let top = |y: u32| y < 60;
    for (x, y, was) in a.enumerate_pixels() {
        assert!(was == b.get_pixel(x, y) || top(y), "changed at {x} {y}");
    }
    assert_eq!(
        compare(&shot("d.png"), &shot("e.png")).mean,
        0.0,
        "part of the display"
    );
    let drawn = field(run.probe(1), "picture");
    assert_eq!(field(drawn, "quality"), "fast");
    let count = |name| number(drawn, name);
    assert!(count("triangles") > 0.0 && count("error_px") >= 0.0);
    assert!(count("chunks_by_frame") + count("chunks_by_vertex") > 0.0);
    let land = number(run.probe(1), "chunks.triangles");
    let saved = count("triangles_outside") + count("triangles_hidden") + count("triangles_small");
    assert!(saved > 0.0 && saved <= land, "{saved} of {land} left out");
}
