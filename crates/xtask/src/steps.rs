//! Runs cargo: the game, the tests and the steps of CI.
//!
//! Everything but what players are given is built in the release profile, so that the dependencies are
//! compiled once for the game, the tests and the benches. The tests come last
//! and nothing is printed after them: the last line is the runner's summary.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use crate::error::Error;
use crate::testbed::TestBed;

/// The profile of what players are given.
pub const SHIPPED: &str = "shipped";

/// The root of the checkout.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here)
}

/// Runs the game with `arguments` and returns its exit status. `features` are those
/// it is built with, where that is not all of them.
///
/// # Errors
/// When cargo cannot be started.
pub fn game(arguments: &[impl AsRef<OsStr>], features: Option<&[&str]>) -> Result<u8, Error> {
    let mut command = cargo(&["run", "--release", "--package", "antipode"]);
    if let Some(features) = features {
        command.args(["--no-default-features", "--features", &features.join(",")]);
    }
    command.arg("--").args(arguments);
    let status = command
        .status()
        .map_err(|source| start_error(&command, source))?;
    // Any other end is a failure too: a build that broke, or a signal.
    Ok(match status.code() {
        Some(0) => 0,
        Some(2) => 2,
        _ => 1,
    })
}

/// Builds the game as players get it, and returns where it is.
///
/// # Errors
/// When cargo cannot be started or the build fails.
pub fn build_game() -> Result<PathBuf, Error> {
    build_program("antipode", SHIPPED, &[])
}

/// Builds a program in a profile, with more arguments of cargo, and returns where it is.
///
/// # Errors
/// When cargo cannot be started or the build fails.
pub fn build_program(package: &str, profile: &str, more: &[&str]) -> Result<PathBuf, Error> {
    let mut build = cargo(&["build", "--profile", profile, "--package", package]);
    Steps::new(1).run(&format!("build of {package}"), build.args(more))?;
    // What cargo calls the profile of debugging has a folder of another name.
    let folder = if profile == "dev" { "debug" } else { profile };
    Ok(root().join("target").join(folder).join(package))
}

/// What is built into a program, one package a line: name, version and place, `|`, licence, `|`, repository.
///
/// # Errors
/// When cargo cannot be started or fails.
pub fn tree_of(package: &str, more: &[&str]) -> Result<String, Error> {
    let mut tree = cargo(&["tree", "--package", package, "--edges", "normal"]);
    tree.args(more);
    tree.args(["--prefix", "none", "--format", "{p}|{l}|{r}"]);
    let output = tree.output().map_err(|source| start_error(&tree, source))?;
    if !output.status.success() {
        return Err(Error::Step {
            name: "what is built in".into(),
            command: typed(&tree),
        });
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Measures the benches, all or those that `arguments` name.
///
/// # Errors
/// When cargo cannot be started or a bench fails.
pub fn bench(arguments: &[String]) -> Result<(), Error> {
    let mut command = cargo(&["bench", "--workspace", "--bench", "*", "--"]);
    Steps::new(1).run("benches", command.args(arguments))
}

/// Measures everything the laboratory has, and remakes `docs/accuracy.md` and `docs/terrain.md` with their plots from it,
/// even where a bar is not met. The figures themselves, their pages and the log of the flight go to `target/lab`.
///
/// # Errors
/// When cargo cannot be started, or the laboratory fails.
pub fn lab() -> Result<(), Error> {
    let mut steps = Steps::new(2);
    let mut laboratory = |suite: &str, more: &[&str]| {
        let measurements = format!("target/lab/{suite}");
        let json = format!("{measurements}/report.json");
        let mut command = cargo(&["run", "--release", "--package", "antipode-lab", "--"]);
        command.args([suite, "--json", &json, "--report", &measurements]);
        command.args(["--docs", "docs"]).args(more);
        std::fs::create_dir_all(root().join(&measurements)).map_err(|source| Error::Scratch {
            path: measurements.into(),
            source,
        })?;
        steps.run(suite, &mut command)
    };
    let terrain = laboratory("terrain", &["--frame-log", "target/lab/terrain/flight.csv"]);
    let exactness = laboratory("exactness", &[]);
    terrain.and(exactness)
}

/// Runs every test, and every bench once; with a `filter`, only the tests that
/// cargo's own filter arguments select.
///
/// # Errors
/// When the surroundings of the tests cannot be made, or a test fails.
pub fn test(filter: &[String]) -> Result<(), Error> {
    let bed = TestBed::make()?;
    if filter.is_empty() {
        return every_test(&mut Steps::new(3), &bed);
    }
    let mut command = cargo(&TESTS);
    command.args(filter);
    Steps::new(1).run("the chosen tests", bed.surround(&mut command))
}

/// Every check there is.
///
/// # Errors
/// At the first step that fails.
pub fn ci() -> Result<(), Error> {
    let mut steps = Steps::new(11);
    steps.run("format", &mut cargo(&["fmt", "--all", "--check"]))?;
    steps.run("lints", cargo(&LINTS).args(["--", "-D", "warnings"]))?;
    // The same packages and targets, so that no dependency is looked at anew.
    let mut bare = cargo(&LINTS);
    bare.args(["--no-default-features", "--", "-D", "warnings"]);
    steps.run("lints without sound and gamepads", &mut bare)?;
    let mut docs = cargo(&["doc", "--release", "--workspace", "--no-deps"]);
    steps.run("docs", docs.env("RUSTDOCFLAGS", "-D warnings"))?;
    if is_installed("deny") {
        steps.run("licences and advisories", &mut cargo(&["deny", "check"]))?;
    } else {
        steps.skip("licences and advisories", "cargo-deny is not installed");
    }
    let bed = TestBed::make()?;
    // All at once: the game alone has other features of some dependencies, and nearly everything would be compiled
    // once for it and again for the tests.
    let mut build = cargo(&["build", "--release", "--workspace", "--all-targets"]);
    steps.run("build", &mut build)?;
    let mut laboratory = built_laboratory();
    laboratory.args(["accuracy", "--quick", "--adapter", "software"]);
    steps.run("laboratory", bed.surround(&mut laboratory))?;
    // A quick run is judged by ratios between rivals of the same run and by counts, never by times.
    let mut terrain = built_laboratory();
    terrain.args(["terrain", "--quick", "--adapter", "none"]);
    steps.run("laboratory of terrain", bed.surround(&mut terrain))?;
    every_test(&mut steps, &bed)
}

const LINTS: [&str; 4] = ["clippy", "--release", "--workspace", "--all-targets"];

const TESTS: [&str; 8] = [
    "test",
    "--release",
    "--workspace",
    "--no-fail-fast",
    "--lib",
    "--bins",
    "--tests",
    "--examples",
];

/// Three steps. rustdoc prints a time after its summary and the benches print
/// no summary at all, so the ordinary tests are the last.
fn every_test(steps: &mut Steps, bed: &TestBed) -> Result<(), Error> {
    let mut examples = cargo(&["test", "--release", "--workspace", "--doc"]);
    steps.run("the docs' examples", bed.surround(&mut examples))?;
    // Under `cargo test` a bench runs each of its functions once.
    let mut benches = cargo(&["test", "--release", "--workspace", "--bench", "*"]);
    steps.run("every bench once", bed.surround(&mut benches))?;
    steps.run("tests", bed.surround(&mut cargo(&TESTS)))
}

/// The laboratory as it was last built, in the root of the checkout. It lies beside the profile that we were built in.
fn built_laboratory() -> Command {
    let ours = std::env::current_exe().unwrap_or_default();
    let target = ours.ancestors().nth(2).map(Path::to_path_buf);
    let target = target.unwrap_or_else(|| root().join("target"));
    let mut command = Command::new(target.join("release").join("antipode-lab"));
    command.current_dir(root());
    command
}

/// The very cargo that started us, in the root of the checkout.
fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

/// Runs commands one after the other, each with what it is called.
///
/// # Errors
/// At the first that cannot be started or fails.
pub fn in_turn(commands: Vec<(String, Command)>) -> Result<(), Error> {
    let mut steps = Steps::new(commands.len());
    commands
        .into_iter()
        .try_for_each(|(name, mut command)| steps.run(&name, &mut command))
}

/// Whether cargo has a subcommand of that name.
pub fn is_installed(subcommand: &str) -> bool {
    cargo(&[subcommand, "--version"])
        .output()
        .is_ok_and(|output| output.status.success())
}

/// The command as one could type it.
fn typed(command: &Command) -> String {
    let mut words = vec![
        Path::new(command.get_program())
            .file_name()
            .unwrap_or_default()
            .to_string_lossy(),
    ];
    words.extend(command.get_args().map(OsStr::to_string_lossy));
    let quoted: Vec<String> = words
        .iter()
        .map(|word| {
            if word.contains(['*', ' ']) {
                format!("'{word}'")
            } else {
                word.to_string()
            }
        })
        .collect();
    quoted.join(" ")
}

fn start_error(command: &Command, source: std::io::Error) -> Error {
    Error::Start {
        program: command.get_program().to_string_lossy().into_owned(),
        source,
    }
}

/// Tells on stderr which step begins, and how long all before it took.
struct Steps {
    began: Instant,
    count: usize,
    total: usize,
}

impl Steps {
    fn new(total: usize) -> Self {
        Self {
            began: Instant::now(),
            count: 0,
            total,
        }
    }

    fn announce(&mut self, what: &str) {
        self.count += 1;
        eprintln!(
            "[{}/{}, {}] {what}",
            self.count,
            self.total,
            clock(self.began.elapsed())
        );
    }

    fn skip(&mut self, name: &str, why: &str) {
        self.announce(&format!("{name}: skipped, {why}"));
    }

    fn run(&mut self, name: &str, command: &mut Command) -> Result<(), Error> {
        self.announce(name);
        let status = command
            .status()
            .map_err(|source| start_error(command, source))?;
        if status.success() {
            return Ok(());
        }
        Err(Error::Step {
            name: name.into(),
            command: typed(command),
        })
    }
}

/// Minutes and seconds.
fn clock(elapsed: Duration) -> String {
    format!("{}:{:02}", elapsed.as_secs() / 60, elapsed.as_secs() % 60)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use std::process::Stdio;

    #[test]
    fn the_root_is_where_the_workspace_is() {
        let manifest = std::fs::read_to_string(root().join("Cargo.toml")).unwrap();
        assert!(manifest.contains("[workspace]"));
    }

    #[test]
    fn a_command_can_be_typed_again() {
        let mut command = Command::new("/opt/rust/bin/cargo");
        command.args(["test", "--bench", "*"]);
        assert_eq!(typed(&command), "cargo test --bench '*'");
    }

    #[test]
    fn the_clock_shows_minutes_and_seconds() {
        assert_eq!(clock(Duration::from_secs(9)), "0:09");
        assert_eq!(clock(Duration::from_secs(3605)), "60:05");
    }

    #[test]
    fn a_failing_step_is_an_error_that_names_it() {
        let mut steps = Steps::new(2);
        let mut good = cargo(&["--version"]);
        assert!(steps.run("good", good.stdout(Stdio::null())).is_ok());
        let mut bad = cargo(&["no-such-subcommand"]);
        let error = steps.run("bad", bad.stderr(Stdio::null())).unwrap_err();
        assert!(
            error.to_string().contains("\"bad\"")
                && error.to_string().contains("no-such-subcommand")
        );
    }
}
