//! Things and light through the keys of a player, in every space: what each key does to what is carried, lit, fired,
//! thrown and seen, and what falls do.

use antipode_tests::program::{comparable, field, number, run};
use serde_json::Value;

const SPACES: [&str; 3] = ["euclidean", "hyperbolic", "spherical"];

/// A world in which the player has come to stand, and what follows there.
fn play(space: &str, then: &str) -> antipode_tests::program::Run {
    let saves = tempfile::tempdir().unwrap();
    let radius = if space == "spherical" {
        " radius=64"
    } else {
        ""
    };
    run(
        saves.path(),
        &format!("new {space} seed=3{radius}\nwait 0.5\n{then}"),
    )
}

fn key(name: &str) -> String {
    format!("down {name}\nup {name}\nwait 0.05")
}

/// How many of an item are carried.
fn carried(probe: &Value, item: &str) -> f64 {
    let slots = field(probe, "inventory").as_array().unwrap().iter();
    slots
        .filter(|slot| slot["item"] == item)
        .map(|slot| slot["count"].as_f64().unwrap())
        .sum()
}

fn length(probe: &Value, list: &str) -> usize {
    field(probe, list).as_array().unwrap().len()
}

#[test]
fn digits_and_the_wheel_choose_what_is_in_hand() {
    for space in SPACES {
        let run = play(
            space,
            &format!(
                "{}\nprobe\n{}\nscroll -1\nwait 0.05\nprobe\ndown AltLeft\nscroll -1\nup AltLeft\nwait 0.05\nprobe",
                key("Digit6"),
                key("Digit2")
            ),
        );
        assert_eq!(field(run.probe(0), "item"), "lamp", "{space}");
        let (turned, stepped) = (run.probe(1), run.probe(2));
        if space == "hyperbolic" {
            assert_eq!(number(turned, "curvature"), 9.0);
            assert_eq!(field(turned, "item"), "pickaxe-wood");
            assert_eq!(field(stepped, "item"), "pickaxe-iron");
        } else {
            assert_eq!(field(turned, "item"), "pickaxe-iron", "{space}");
            assert_eq!(field(stepped, "item"), "pickaxe-diamond", "{space}");
        }
        assert_eq!(field(stepped, "curvature"), field(turned, "curvature"));
    }
}

#[test]
fn the_left_button_puts_a_lamp_down_and_the_right_one_picks_it_up() {
    for space in SPACES {
        let run = play(
            space,
            &format!(
                "{}\naim 0 -60\nprobe\nclick LEFT\nwait 0.1\nprobe\nclick RIGHT\nwait 0.1\nprobe",
                key("Digit6")
            ),
        );
        let [before, placed, taken] = [0, 1, 2].map(|n| run.probe(n));
        assert_eq!(length(before, "lamps"), 0, "{space}");
        assert_eq!(length(placed, "lamps"), 1, "{space}");
        assert_eq!(carried(placed, "lamp"), carried(before, "lamp") - 1.0);
        let off = (0..3).map(|axis| {
            let lamp = number(placed, &format!("lamps.0.pos.{axis}"));
            (lamp - number(placed, &format!("player.pos.{axis}"))).powi(2)
        });
        let off = off.sum::<f64>().sqrt();
        assert!(off < 3.0, "{space}: {off} m from the feet");
        assert_eq!(length(taken, "lamps"), 0, "{space}");
        assert_eq!(carried(taken, "lamp"), carried(before, "lamp"), "{space}");
    }
}

/// In the numbers with which one stood half in the rock: at the next digging near it, it came up through twelve metres.
#[test]
fn a_lamp_on_a_dug_wall_hangs_there_until_the_wall_is_dug_away() {
    let saves = tempfile::tempdir().unwrap();
    let run = run(
        saves.path(),
        "new euclidean seed=21 generator=1\nset npcs off\nsettle\naim 180 -38\nwait 0.2\ntap Digit4\nhold LEFT 2.5\nhold KeyW 1.2\n\
         aim 180 -10\nhold LEFT 2.5\nwait 1\ntap Digit6\naim 180 5\nwait 0.1\nclick LEFT\nwait 0.5\nprobe\n\
         tap Digit4\naim 60 -10\nhold LEFT 1\nwait 1\nprobe\naim 180 5\nhold LEFT 3\nwait 2\nprobe",
    );
    let height = |n: usize| number(run.probe(n), "lamps.0.pos.1");
    assert!(height(0) > number(run.probe(0), "player.pos.1") + 1.0);
    assert!((height(1) - height(0)).abs() < 1e-6, "{} m", height(1));
    assert!(height(2) < height(0) - 1.0, "{} m", height(2));
}

#[test]
fn the_flashlight_goes_on_and_off_by_its_key() {
    for space in SPACES {
        let y = key("KeyY");
        let run = play(space, &format!("probe\n{y}\nprobe\n{y}\nprobe"));
        let lit = [0, 1, 2].map(|n| field(run.probe(n), "flashlight") == true);
        assert_eq!(lit, [false, true, false], "{space}");
    }
}

#[test]
fn a_shot_takes_a_bullet_which_flies_until_it_lands_and_lies_for_five_seconds() {
    for space in SPACES {
        let run = play(
            space,
            &format!(
                "{}\naim 40 45\nprobe\nclick LEFT\nwait 0.1\nprobe\nwait 5.4\nprobe\nwait 20\nprobe",
                key("Digit1")
            ),
        );
        let [before, fired, late, gone] = [0, 1, 2, 3].map(|n| run.probe(n));
        assert_eq!(length(before, "projectiles"), 0);
        assert_eq!(length(fired, "projectiles"), 1, "{space}");
        assert_eq!(carried(fired, "bullet"), carried(before, "bullet") - 1.0);
        let speed = (0..3).map(|axis| number(fired, &format!("projectiles.0.vel.{axis}")).powi(2));
        assert!(speed.sum::<f64>().sqrt() > 30.0, "{space}");
        // Others of the world may fire meanwhile.
        let own = field(fired, "projectiles.0.id");
        let flies = |probe: &Value| {
            let all = field(probe, "projectiles").as_array().unwrap();
            all.iter().any(|bullet| bullet["id"] == *own)
        };
        assert!(flies(late), "{space}: gone too early");
        assert!(!flies(gone), "{space}: still there");
        assert_eq!(carried(gone, "bullet"), carried(fired, "bullet"));
    }
}

#[test]
fn what_is_thrown_away_lies_about_until_it_is_walked_over() {
    for space in SPACES {
        let run = play(
            space,
            &format!(
                "{}\naim 0 0\nprobe\n{}\nprobe\nwait 2.5\nprobe\naim 0 0\nhold KeyW 2\nprobe",
                key("Digit6"),
                key("KeyQ")
            ),
        );
        let [before, thrown, lies, taken] = [0, 1, 2, 3].map(|n| run.probe(n));
        assert_eq!(length(before, "drops"), 0);
        assert_eq!(length(thrown, "drops"), 1, "{space}");
        assert_eq!(carried(thrown, "lamp"), carried(before, "lamp") - 1.0);
        assert_eq!(length(lies, "drops"), 1, "{space}");
        assert_eq!(length(taken, "drops"), 0, "{space}: not picked up");
        assert_eq!(carried(taken, "lamp"), carried(before, "lamp"), "{space}");
    }
}

#[test]
fn tab_goes_behind_the_figure_and_back() {
    for space in SPACES {
        let tab = key("Tab");
        let run = play(space, &format!("probe\n{tab}\nprobe\n{tab}\nprobe"));
        let modes = [0, 1, 2].map(|n| field(run.probe(n), "camera.mode").clone());
        assert_eq!(modes, ["first", "third", "first"], "{space}");
        let off = |n: usize| {
            let of = |what: &str, axis| number(run.probe(n), &format!("{what}.pos.{axis}"));
            let apart = [0, 2].map(|axis| of("camera", axis) - of("player", axis));
            apart[0].hypot(apart[1])
        };
        assert!(off(0) < 1e-6 && off(2) < 1e-6, "{space}");
        assert!((1.0..6.0).contains(&off(1)), "{space}: {} m behind", off(1));
    }
}

#[test]
fn keys_of_the_display_disturb_nothing_in_the_world() {
    let keys = ["F1", "F3", "F4"].map(key).join("\n");
    for space in SPACES {
        let script = |keys: &str| {
            format!(
                "{}\n{keys}\nhold KeyW 0.5\naim 30 -40\nclick LEFT\n{keys}\nwait 0.5\nprobe",
                key("Digit1")
            )
        };
        let idle = "wait 0.05\nwait 0.05\nwait 0.05";
        let (with, without) = (play(space, &script(&keys)), play(space, &script(idle)));
        let (with, without) = (with.probe(0), without.probe(0));
        assert_eq!(comparable(with), comparable(without), "{space}");
        assert_eq!(length(with, "projectiles"), 1, "{space}");
    }
}

/// Rises for so many seconds as a spectator, and falls from there.
fn fall(space: &str, rise_s: f64, then: &str) -> antipode_tests::program::Run {
    play(
        space,
        &format!("set fly on\nhold Space {rise_s}\nwait 0.5\nset fly off\nprobe\n{then}"),
    )
}

#[test]
fn a_fall_of_more_than_eight_metres_hurts_and_a_lower_one_does_not() {
    for space in SPACES {
        for (rise_s, hurts) in [(0.5, false), (1.8, true)] {
            let run = fall(space, rise_s, "wait 2.5\nprobe");
            let (above, below) = (run.probe(0), run.probe(1));
            let height = |probe| number(probe, "player.pos.1");
            let fell = height(above) - height(below);
            assert_eq!(fell > 8.0, hurts, "{space}: fell {fell} m");
            assert_eq!(field(below, "player.grounded"), true, "{space}");
            let lost = number(above, "player.health") - number(below, "player.health");
            let due = if hurts { fell - 7.0 } else { 0.0 };
            assert!((lost - due).abs() < 1.2, "{space}: {fell} m cost {lost}");
        }
    }
}

#[test]
fn a_deep_fall_kills_and_one_stands_up_again_at_the_start_with_everything() {
    for space in SPACES {
        let run = fall(space, 5.5, "wait 3.5\nprobe\nwait 4\nprobe");
        let (alive, dead, back) = (run.probe(0), run.probe(1), run.probe(2));
        assert_eq!(number(dead, "player.health"), 0.0, "{space}");
        assert_eq!(field(dead, "player.animation"), "die", "{space}");
        // Others of the world may have fired at who stands there.
        assert!(number(back, "player.health") > 12.0, "{space}");
        assert_eq!(field(back, "player.grounded"), true, "{space}");
        for axis in [0, 2] {
            let at = format!("player.pos.{axis}");
            let off = number(back, &at) - number(alive, &at);
            assert!(off.abs() < 1.0, "{space}: {off} m from the start");
        }
        assert_eq!(
            field(back, "inventory"),
            field(alive, "inventory"),
            "{space}"
        );
    }
}

#[test]
fn straight_shots_do_not_fall_and_others_do() {
    for space in SPACES {
        let flight = |straight: &str| {
            let run = play(
                space,
                &format!(
                    "{}\naim 40 70\n{straight}click LEFT\nwait 0.05\nprobe\nwait 0.4\nprobe",
                    key("Digit1")
                ),
            );
            let rise = |n: usize| number(run.probe(n), "projectiles.0.vel.1");
            let height = number(run.probe(1), "projectiles.0.pos.1");
            (rise(1) - rise(0), height)
        };
        let (usual, straight) = (flight(""), flight("set straight-shots on\n"));
        assert!(usual.0 < -3.0, "{space}: {usual:?}");
        // In curved space a straight line of the space is bent in the chart, but not as a parabola.
        let apart = (straight.1 - usual.1).abs();
        assert!(apart > 0.02, "{space}: {straight:?} {usual:?}");
        if space == "euclidean" {
            assert!(straight.0.abs() < 1e-9, "{straight:?}");
        }
    }
}
