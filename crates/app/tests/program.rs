//! The built program as a shell sees it: answers, one-line refusals and exit statuses.
//!
//! Naming the binary here also makes `cargo test --workspace` build it, which the workspace's own tests need.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::process::{Command, Output};

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
