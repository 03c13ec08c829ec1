//! `cargo xtask fuzz`: every target of `fuzz/` for a while, where a nightly toolchain and
//! cargo-fuzz are here.

use std::process::Command;

use crate::error::Error;
use crate::steps::{in_turn, is_installed, root};

/// The program of `fuzz/` that all targets are in.
const PROGRAM: &str = "readers";
/// Minutes for all of them together, where nothing is said.
const USUAL_MINUTES: u32 = 6;
/// Most memory of a target.
const MOST_MB: u32 = 512;
/// Most time for an input.
const MOST_SECONDS: u32 = 5;

/// Fuzzes every target, all together for so many minutes.
///
/// # Errors
/// When the minutes are none, or a target has a find.
pub fn fuzz(arguments: &[String]) -> Result<(), Error> {
    let minutes = minutes(arguments)?;
    if let Some(missing) = missing(has_nightly(), is_installed("fuzz")) {
        println!("{missing}");
        return Ok(());
    }
    let targets = targets()?;
    let seconds = (minutes * 60 / targets.len().max(1) as u32).max(1);
    let commands = targets
        .iter()
        .map(|target| (format!("fuzz {target}"), command(target, seconds)));
    in_turn(commands.collect())
}

/// The names of all targets: a test of theirs sees that each has a folder of inputs to begin with, and nothing else has.
fn targets() -> Result<Vec<String>, Error> {
    let path = root().join("fuzz/corpus");
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        entry.map(|entry| entry.file_name().to_string_lossy().into_owned())
    };
    let names = std::fs::read_dir(&path).and_then(|entries| entries.map(name).collect());
    let mut names: Vec<_> = names.map_err(|source| Error::Unreadable { path, source })?;
    names.sort();
    Ok(names)
}

fn minutes(arguments: &[String]) -> Result<u32, Error> {
    match arguments {
        [] => Ok(USUAL_MINUTES),
        [one] => match one.parse() {
            Ok(minutes @ 1..=100_000) => Ok(minutes),
            _ => Err(Error::Usage(format!("`{one}` is no number of minutes"))),
        },
        _ => Err(Error::Usage("`fuzz` takes a number of minutes".into())),
    }
}

/// What is to be installed first, as a sentence.
fn missing(nightly: bool, cargo_fuzz: bool) -> Option<&'static str> {
    match (nightly, cargo_fuzz) {
        (true, true) => None,
        (false, true) => Some(
            "Nothing was fuzzed: a nightly toolchain is missing; `rustup toolchain install nightly` brings one.",
        ),
        (true, false) => {
            Some("Nothing was fuzzed: cargo-fuzz is missing; `cargo install cargo-fuzz` brings it.")
        }
        (false, false) => Some(
            "Nothing was fuzzed: a nightly toolchain and cargo-fuzz are missing; `rustup toolchain install nightly` and `cargo install cargo-fuzz` bring them.",
        ),
    }
}

fn has_nightly() -> bool {
    let listed = Command::new("rustup").args(["toolchain", "list"]).output();
    listed.is_ok_and(|output| {
        String::from_utf8_lossy(&output.stdout)
            .lines()
            .any(|line| line.starts_with("nightly"))
    })
}

/// The fuzzer on one target. New inputs go to `target/fuzz`, so that the corpus in the
/// repository stays as it is; finds go to `fuzz/artifacts`.
fn command(target: &str, seconds: u32) -> Command {
    let found = root().join("target/fuzz").join(target);
    // libFuzzer wants its first folder to be there.
    let _ = std::fs::create_dir_all(&found);
    let mut command = Command::new("rustup");
    // No code here is unsafe, and a sanitizer's own memory would count towards the limit.
    command.args([
        "run",
        "nightly",
        "cargo",
        "fuzz",
        "run",
        "--sanitizer",
        "none",
    ]);
    command
        .args(["--features", "libfuzzer", PROGRAM])
        .arg(found);
    for kind in ["corpus", "finds"] {
        let folder = root().join("fuzz").join(kind).join(target);
        if folder.is_dir() {
            command.arg(folder);
        }
    }
    command.arg("--").args([
        format!("-max_total_time={seconds}"),
        format!("-rss_limit_mb={MOST_MB}"),
        format!("-timeout={MOST_SECONDS}"),
    ]);
    command.env("ANTIPODE_FUZZ_TARGET", target);
    command.current_dir(root());
    command
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn what_is_missing_is_said_with_the_command_that_brings_it() {
        assert_eq!(missing(true, true), None);
        for (nightly, cargo_fuzz) in [(false, true), (true, false), (false, false)] {
            let said = missing(nightly, cargo_fuzz).unwrap();
            assert_eq!(said.contains("rustup toolchain install nightly"), !nightly);
            assert_eq!(said.contains("cargo install cargo-fuzz"), !cargo_fuzz);
        }
    }

    #[test]
    fn minutes_are_a_number_or_a_mistake() {
        assert_eq!(minutes(&[]).unwrap(), USUAL_MINUTES);
        assert_eq!(minutes(&["30".to_owned()]).unwrap(), 30);
        for wrong in ["0", "-1", "soon"] {
            assert_eq!(
                minutes(&[wrong.to_owned()]).unwrap_err().status(),
                2,
                "{wrong}"
            );
        }
    }

    #[test]
    fn a_target_is_given_the_corpus_and_the_bounds() {
        let arguments: Vec<_> = command("script", 60)
            .get_args()
            .map(|one| one.to_string_lossy().into_owned())
            .collect();
        let line = arguments.join(" ");
        assert!(targets().unwrap().contains(&"script".to_owned()));
        let program = std::fs::read_to_string(root().join("fuzz/Cargo.toml")).unwrap();
        assert!(
            line.contains(&format!(" {PROGRAM} "))
                && program.contains(&format!("name = \"{PROGRAM}\"")),
            "{line}"
        );
        assert!(
            line.contains("corpus/script") && line.contains("-rss_limit_mb=512"),
            "{line}"
        );
    }
}
