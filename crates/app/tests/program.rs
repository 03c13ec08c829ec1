//! The built program as a shell sees it: answers, one-line refusals and exit statuses.
//!
//! Naming the binary here also makes `cargo test --workspace` build it, which the workspace's own tests need.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::process::{Command, Output, Stdio};

fn antipode(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_antipode"))
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn help_and_version_are_answers() {
    for (argument, word) in [
        ("--help", "--geometry"),
        ("--version", env!("CARGO_PKG_VERSION")),
    ] {
        let output = antipode(&[argument]);
        assert_eq!(output.status.code(), Some(0));
        assert!(
            String::from_utf8(output.stdout).unwrap().contains(word),
            "{argument}"
        );
    }
}

#[test]
fn wrong_usage_is_refused_in_one_line_with_status_two() {
    for wrong in [
        &["juggle"][..],
        &["--seed", "-1"],
        &["saves", "info"],
        &["--size", "1x1"],
        &["--geometry", "spherical", "--radius", "5"],
    ] {
        let output = antipode(wrong);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(said.trim().lines().count(), 1, "{wrong:?} said: {said}");
    }
}

/// What `saves info` tells of a world made by this script.
fn told(script: &str) -> String {
    let saves = tempfile::tempdir().unwrap();
    let file = saves.path().join("script.txt");
    std::fs::write(&file, script).unwrap();
    let (saves, file) = (saves.path().to_str().unwrap(), file.to_str().unwrap());
    let at = ["--saves-dir", saves, "--adapter", "none"];
    let made = antipode(&[&at[..], &["script", file]].concat());
    assert!(made.status.success(), "{made:?}");
    let info = antipode(&["--saves-dir", saves, "saves", "info", "W"]);
    assert!(info.status.success(), "{info:?}");
    String::from_utf8(info.stdout).unwrap()
}

#[test]
fn the_particulars_of_a_world_are_those_that_its_space_has() {
    let said = told("new hyperbolic seed=4 name=W\nsave");
    assert!(
        said.contains("hyperbolic") && !said.contains("radius"),
        "{said}"
    );
    assert!(!said.contains("cheats"), "{said}");
    let said = told("new spherical seed=4 radius=40 name=W\ngive lamp 1\nsave");
    assert!(
        said.contains("radius    40 m") && said.contains("cheats    used"),
        "{said}"
    );
}

/// Everything that a run printed.
fn printed(output: &Output) -> String {
    [&output.stdout, &output.stderr]
        .map(|bytes| String::from_utf8(bytes.clone()).unwrap())
        .concat()
}

fn assert_tame(what: &str, said: &str) {
    let wild = |c: char| c != '\n' && antipode_storage::is_unprintable(c);
    assert!(!said.contains(wild), "{what}: {said:?}");
}

#[test]
fn nothing_that_a_terminal_obeys_is_printed() {
    let evil = "\u{1b}]0;x\u{7}\u{9b}2J\u{202e}\u{2028}\rX\u{7f}";
    let dir = tempfile::tempdir().unwrap();
    let saves = dir.path().join("saves");
    // A copied folder whose store says what no form would take.
    let meta = antipode_storage::WorldMeta {
        name: format!("{evil}\nW"),
        geometry: evil.to_owned(),
        biome: evil.to_owned(),
        ..antipode_storage::WorldMeta::default()
    };
    drop(antipode_storage::WorldStore::create(&saves.join("w"), &meta).unwrap());
    let script = dir.path().join("script");
    let run = |arguments: &[&str]| {
        let at = ["--saves-dir", saves.to_str().unwrap(), "--adapter", "none"];
        antipode(&[&at[..], arguments].concat())
    };
    for arguments in [
        &["saves", "list"][..],
        &["saves", "info", "w"],
        &["saves", "verify", "w"],
        &["saves", "repair", "w"],
        &["saves", "verify", evil],
        &["saves", "export", "w", &format!("/nowhere/{evil}")],
        &["saves", "import", &format!("/nowhere/{evil}")],
        &["script", &format!("/nowhere/{evil}")],
        &["--load", evil, "--config", evil, "script", "-"],
        &["--geometry", evil],
        &["--log", "debug", "script", evil],
        &["--config", evil, "script", "/dev/null"],
        &[evil],
    ] {
        let output = run(arguments);
        assert_tame(&format!("{arguments:?}"), &printed(&output));
    }
    let listed = printed(&run(&["saves", "list"]));
    assert_eq!(listed.lines().count(), 1, "{listed}");
    for order in [
        "list".to_owned(),
        "load w".to_owned(),
        format!("{evil} 1"),
        format!("set {evil} 1"),
        format!("load \"{evil}\""),
        format!("new {evil}"),
        format!("new euclidean {evil}=1"),
        format!("hold {evil} 1"),
        format!("new euclidean\nshot /nowhere/{evil}.png"),
    ] {
        std::fs::write(&script, &order).unwrap();
        let said = printed(&run(&[
            "script",
            script.to_str().unwrap(),
            "--log",
            "debug",
        ]));
        assert_tame(&order, &said);
    }
}

#[cfg(unix)]
#[test]
fn a_script_or_settings_without_an_end_are_refused_in_words() {
    for arguments in [
        &["script", "/dev/zero"][..],
        &["--config", "/dev/zero", "script", "/dev/null"],
    ] {
        let output = antipode(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        let why = said.contains("longer than 1 MB") || said.contains("not a file");
        assert!(why && said.lines().count() == 1, "{said}");
    }
    let zeros = std::fs::File::open("/dev/zero").unwrap();
    let piped = Command::new(env!("CARGO_BIN_EXE_antipode"))
        .args(["script", "-"])
        .stdin(Stdio::from(zeros))
        .output()
        .unwrap();
    assert_eq!(piped.status.code(), Some(2));
    assert!(printed(&piped).contains("longer than 1 MB"));
    let dir = tempfile::tempdir().unwrap();
    let long = dir.path().join("long.ron");
    std::fs::write(&long, vec![b' '; (1 << 20) + 1]).unwrap();
    let output = antipode(&["--config", long.to_str().unwrap(), "script", "/dev/null"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(printed(&output).contains("longer than 1 MB"));
}

#[cfg(unix)]
#[test]
fn a_limit_on_the_size_of_files_is_told_and_does_not_kill() {
    let dir = tempfile::tempdir().unwrap();
    let script = dir.path().join("script");
    std::fs::write(&script, "new euclidean name=W\nsave").unwrap();
    let output = Command::new("sh")
        .args(["-c", "ulimit -f 8; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_antipode"))
        .args(["--adapter", "none", "--saves-dir"])
        .arg(dir.path())
        .arg("script")
        .arg(&script)
        .output()
        .unwrap();
    let said = printed(&output);
    assert_eq!(output.status.code(), Some(1), "{:?} {said}", output.status);
    assert!(
        said.contains("no space left") && said.contains("\"W\""),
        "{said}"
    );
    assert!(!said.contains(".antipode"), "{said}");
}

#[test]
fn rooms_are_listed_looked_at_given_away_and_taken_in() {
    let place = tempfile::tempdir().unwrap();
    let saves = place.path().join("saves");
    let run = |words: &[&str]| {
        antipode(&[&["--saves-dir", saves.to_str().unwrap(), "rooms"], words].concat())
    };
    let said = printed(&run(&["list"]));
    let shipped = antipode_rooms::shipped::ROOMS.len();
    assert_eq!(said.lines().count(), shipped, "{said}");
    assert!(
        said.contains("The long house") && said.contains("the game's"),
        "{said}"
    );
    let said = printed(&run(&["verify", "the long house"]));
    assert!(
        said.contains("is sound: ") && said.contains("aberrations 1,"),
        "{said}"
    );
    let file = place.path().join("house.antipode-room");
    let file = file.to_str().unwrap();
    assert!(run(&["export", "long-house", file]).status.success());
    let imported = run(&["import", file]);
    assert_eq!(imported.status.code(), Some(0), "{imported:?}");
    let room = saves.join("rooms/the-long-house-2/room.ron");
    assert!(room.exists(), "{imported:?}");
    let text = std::fs::read_to_string(&room).unwrap();
    std::fs::write(&room, text.replace("felt: 79", "felt: 7900")).unwrap();
    let refused = run(&["verify", "the-long-house-2"]);
    assert_eq!(refused.status.code(), Some(1));
    let said = printed(&refused);
    assert!(said.contains("room.ron:39: felt of \"corridor\""), "{said}");
    assert!(printed(&run(&["list"])).contains("felt of \"corridor\""));
    std::fs::write(file, b"no archive").unwrap();
    let refused = run(&["import", file]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(
        printed(&refused).contains("no exported room"),
        "{refused:?}"
    );
}
