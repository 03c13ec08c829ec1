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
