//! Settings and the command line: a script goes by the file it is given and by no other.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use antipode_tests::program::{Run, game, number, run, run_with};

const WALK: &str =
    "new euclidean seed=7\nset view-distance 1\nwait 1\nhold KeyI 1\nprobe\nhold KeyW 1\nprobe";

/// Forward on I and nowhere else, in RON as somebody writes it.
const FORWARD_ON_I: &str = "(schema: 1, settings: {\"view-distance\": 1}, profile: \"Mine\", profiles: [\n\
                            (name: \"Mine\", keys: {\"forward\": [\"KeyI\"]}),\n])";

/// How far the player is from the start, level, after the first and after the second walk.
fn walked_m(run: &Run) -> (f64, f64) {
    assert!(run.stderr.is_empty(), "{}", run.stderr);
    let from = |probe| {
        number(run.probe(probe), "player.pos.0").hypot(number(run.probe(probe), "player.pos.2"))
    };
    let start = from(0);
    (start, from(1))
}

#[test]
fn a_script_goes_by_the_bindings_of_its_file() {
    let saves = tempfile::tempdir().unwrap();
    let file = saves.path().join("mine.ron");
    fs::write(&file, FORWARD_ON_I).unwrap();
    let with = run_with(
        saves.path(),
        WALK,
        &["--adapter", "none", "--config", file.to_str().unwrap()],
    );
    let without = run(saves.path(), WALK);
    let (on_i, on_w) = walked_m(&with);
    assert!(
        (on_i - on_w).abs() < 0.5,
        "W does nothing any more: {on_i} {on_w}"
    );
    let (not_on_i, then_on_w) = walked_m(&without);
    assert!(
        (not_on_i - then_on_w).abs() > 2.0,
        "W walks: {not_on_i} {then_on_w}"
    );
    assert!((on_i - not_on_i).abs() > 2.0, "I walks: {on_i} {not_on_i}");
}

#[test]
fn a_script_neither_reads_nor_writes_the_players_own_settings() {
    let saves = tempfile::tempdir().unwrap();
    let home = tempfile::tempdir().unwrap();
    let own = home.path().join("antipode");
    fs::create_dir(&own).unwrap();
    fs::write(own.join("settings.ron"), FORWARD_ON_I).unwrap();
    let output = in_home(saves.path(), home.path());
    let plain = run(saves.path(), WALK);
    let probes: Vec<serde_json::Value> = output
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(probes[1]["player"], plain.probe(1)["player"]);
    let kept = fs::read_to_string(own.join("settings.ron")).unwrap();
    assert_eq!(kept, FORWARD_ON_I);
    assert_eq!(fs::read_dir(&own).unwrap().count(), 1);
}

/// What a script prints with all the platforms' places for settings under `home`.
fn in_home(saves: &Path, home: &Path) -> String {
    use std::io::Write as _;
    let mut child = game(saves)
        .args(["script", "-", "--adapter", "none"])
        .env("XDG_CONFIG_HOME", home)
        .env("HOME", home)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(WALK.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_file_that_will_not_do_stops_a_script_in_one_line() {
    let saves = tempfile::tempdir().unwrap();
    let file = saves.path().join("bad.ron");
    for (text, says) in [
        ("half a fi", "damaged"),
        ("(schema: 1, settings: {\"field-of-view\": 900})", "900"),
    ] {
        fs::write(&file, text).unwrap();
        let run = run_with(
            saves.path(),
            "list",
            &["--adapter", "none", "--config", file.to_str().unwrap()],
        );
        assert_eq!(run.status, Some(2));
        assert!(
            run.stderr.contains(says) && run.stderr.trim().lines().count() == 1,
            "{}",
            run.stderr
        );
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            text,
            "a script changes no settings"
        );
    }
}
