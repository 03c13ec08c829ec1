//! Ends that nobody asked the game for in its menu: signals, polite and not.
#![cfg(unix)]

use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

use antipode_testing::may_skip;
use antipode_tests::background::{Background, signal};
use antipode_tests::program::{comparable, game, number, run};
use antipode_tests::window::{Window, display, settle_settings, with_hints};
use serde_json::Value;

/// How many kills there are; the long form is for a night.
const KILLS: &str = "ANTIPODE_TEST_KILLS";
const USUAL_KILLS: u64 = 20;
/// Most of what a kill may lose, seconds of the world.
const MOST_LOST_S: f64 = 5.0;

/// Somebody who digs here and there for minutes and says every half second how far that is.
fn digging() -> String {
    let steps = (0..400).map(|step| {
        let yaw = (step * 47) % 360;
        format!("aim {yaw} -55\nhold LEFT 0.3\nhold KeyW 0.2\nprobe\n")
    });
    let steps: Vec<_> = steps.collect();
    format!("load Mortal\nprobe\ntap Digit4\n{}", steps.concat())
}

fn made(saves: &Path) {
    let made = run(saves, "new euclidean seed=8 name=Mortal\nwait 0.5\nsave");
    assert_eq!(made.status, Some(0), "{}", made.stderr);
}

/// The world as it is found, whole.
fn found(saves: &Path) -> Value {
    let verified = game(saves)
        .args(["saves", "verify", "Mortal"])
        .output()
        .unwrap();
    assert!(
        verified.status.success(),
        "{}",
        String::from_utf8_lossy(&verified.stderr)
    );
    run(saves, "load Mortal\nprobe").probe(0).clone()
}

/// Knuth's numbers: the same moments in every run.
struct Moments(u64);

impl Moments {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}

#[test]
fn killed_at_any_moment_the_world_opens_and_lacks_five_seconds_at_most() {
    let saves = tempfile::tempdir().unwrap();
    made(saves.path());
    let kills = std::env::var(KILLS).map_or(USUAL_KILLS, |kills| kills.parse().unwrap());
    let mut moments = Moments(2026);
    let script = digging();
    let mut before = number(&found(saves.path()), "t");
    for kill in 0..kills {
        let mut playing = Background::begin(saves.path(), &script);
        // Now and then before it has even opened the world.
        let mut seen: Vec<_> = (0..moments.below(12))
            .map_while(|_| playing.next_line())
            .collect();
        sleep(Duration::from_micros(moments.below(30_000)));
        seen.extend(playing.kill());
        let reached = seen.last().map_or(before, |probe| number(probe, "t"));
        let kept = number(&found(saves.path()), "t");
        assert!(
            kept >= before && kept >= reached - MOST_LOST_S,
            "kill {kill}: {reached} s were played, {kept} s are left"
        );
        before = kept;
    }
}

#[test]
fn asked_to_end_a_script_saves_everything_first() {
    let saves = tempfile::tempdir().unwrap();
    made(saves.path());
    for lines in [1, 4, 9] {
        let mut playing = Background::begin(saves.path(), &digging());
        for _ in 0..lines {
            playing.next_line().unwrap();
        }
        let (rest, ended) = playing.terminate();
        assert_eq!(ended.status, Some(143), "{}", ended.stderr);
        assert_eq!(ended.stderr.trim().lines().count(), 1, "{}", ended.stderr);
        let kept = number(&found(saves.path()), "t");
        if let Some(last) = rest.last() {
            assert!(kept >= number(last, "t"), "{last}");
        }
    }
}

#[test]
fn what_was_dug_before_a_script_was_asked_to_end_is_there() {
    let saves = tempfile::tempdir().unwrap();
    made(saves.path());
    let script = "load Mortal\ntap Digit4\naim 0 -80\nhold LEFT 0.7\nwait 0.1\nprobe\nsettle 1000\nwait 80000";
    let mut playing = Background::begin(saves.path(), script);
    let before = playing.next_line().unwrap();
    let (_, ended) = playing.terminate();
    assert_eq!(ended.status, Some(143), "{}", ended.stderr);
    let after = found(saves.path());
    assert_eq!(before["chunks"]["edited"], after["chunks"]["edited"]);
    assert!(number(&after, "chunks.edited") >= 1.0);
    let (mut before, mut after) = (comparable(&before), comparable(&after));
    // It went on for a moment, in which the day went on and the player may have sunk into the hole.
    for probe in [&mut before, &mut after] {
        let fields = probe.as_object_mut().unwrap();
        fields.retain(|name, _| {
            ["world", "seed", "geometry", "inventory", "item"].contains(&name.as_str())
        });
    }
    assert_eq!(before, after);
}

#[test]
fn asked_to_end_the_window_saves_everything_first() {
    let Some(display) = display() else {
        may_skip("a test display (ANTIPODE_TEST_DISPLAY; `cargo xtask test` starts one)");
        return;
    };
    let saves = tempfile::tempdir().unwrap();
    made(saves.path());
    let before = number(&found(saves.path()), "t");
    let options = [
        "--load",
        "Mortal",
        "--size",
        "640x360",
        "--view-distance",
        "1",
        "--adapter",
        "software",
        "--log",
        "debug",
    ];
    settle_settings(saves.path(), "");
    with_hints(saves.path());
    let mut game = Window::open(&display, saves.path(), &options);
    game.shows("the world");
    game.hold_key_for("w", "learnt Walk");
    game.look_down();
    game.key("4");
    game.hold_left_for("learnt Dig");
    signal("TERM", game.process());
    assert_eq!(game.ended(), Some(143));
    let kept = found(saves.path());
    assert!(number(&kept, "t") > before, "{kept}");
    assert!(
        number(&kept, "chunks.edited") >= 1.0,
        "the hole is not in the save"
    );
    assert!(saves.path().join("mortal/summary.bin").exists());
}
