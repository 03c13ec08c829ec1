//! `cargo xtask`: one command to play, one to test, one that is the whole of CI.
//!
//! It has no dependencies on purpose: it is what a fresh clone builds first, so
//! it has to be ready in seconds and must not fail for the lack of anything.

mod apt;
mod display;
mod dist;
mod error;
mod fuzzing;
mod lab_archive;
mod licences;
mod machine;
mod openbox;
mod packages;
mod steps;
mod testbed;

use std::ffi::OsStr;
use std::process::ExitCode;

use display::Session;
use error::Error;
use machine::Machine;
use packages::Purpose;

const USAGE: &str = "\
cargo xtask play [--no-install] [ARGUMENTS OF THE GAME]   install what is missing, build, play
cargo xtask test [--no-install] [FILTER]                  install what is missing, run every test
cargo xtask ci [--no-install]                             format, lints, docs, laboratory, every bench once, every test
cargo xtask bench [FILTER]                                measure every bench
cargo xtask fuzz [MINUTES]                                fuzz what reads bytes of others, where nightly and cargo-fuzz are here
cargo xtask lab                                           measure everything, and remake docs/accuracy.md and docs/terrain.md
cargo xtask dist                                          an archive and a Debian package of the game, in target/dist
cargo xtask lab-archive [PROFILE]                         an archive that measures a graphics card, in target/lab-archive
cargo xtask licences                                      the list of others' work that the game shows, anew
cargo xtask packages                                      system packages: what for, and whether they are here

--no-install names the missing packages and goes on without them.
Without a display, `play` makes the tour's pictures in ./tour instead of opening a window.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match dispatch(&arguments) {
        Ok(status) => ExitCode::from(status),
        Err(error) => {
            eprintln!("xtask: {error}");
            ExitCode::from(error.status())
        }
    }
}

fn dispatch(arguments: &[String]) -> Result<u8, Error> {
    let Some((command, rest)) = arguments.split_first() else {
        return Err(Error::Usage("say what to do".into()));
    };
    let options = Options::parse(rest);
    match command.as_str() {
        "play" => play(&options),
        "test" => {
            provide(Purpose::Test, options.install)?;
            steps::test(&options.rest).map(|()| 0)
        }
        "ci" if options.rest.is_empty() => {
            provide(Purpose::Test, options.install)?;
            steps::ci().map(|()| 0)
        }
        "bench" => steps::bench(&options.rest).map(|()| 0),
        "fuzz" => fuzzing::fuzz(&options.rest).map(|()| 0),
        "lab" if options.rest.is_empty() => {
            provide(Purpose::Test, options.install)?;
            steps::lab().map(|()| 0)
        }
        "dist" if options.rest.is_empty() => {
            provide(Purpose::Play(Session::current()), options.install)?;
            for made in dist::dist()? {
                println!("{}", made.display());
            }
            Ok(0)
        }
        "lab-archive" if options.rest.len() <= 1 => {
            provide(Purpose::Test, options.install)?;
            let profile = options.rest.first().map(String::as_str);
            println!("{}", lab_archive::lab_archive(profile)?.display());
            Ok(0)
        }
        "licences" if options.rest.is_empty() => {
            println!("{}", licences::remake_list()?.display());
            Ok(0)
        }
        "packages" if options.rest.is_empty() => {
            print!("{}", packages::inventory(&Machine::look()));
            Ok(0)
        }
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
            Ok(0)
        }
        "ci" | "lab" | "lab-archive" | "dist" | "licences" | "packages" => Err(Error::Usage(
            format!("`{command}` does not know `{}`", options.rest.join(" ")),
        )),
        _ => Err(Error::Usage(format!("there is no command `{command}`"))),
    }
}

/// What stands after the command's name.
#[derive(Debug, PartialEq)]
struct Options {
    install: bool,
    /// Everything that is not ours: for the game, or for the test runner.
    rest: Vec<String>,
}

impl Options {
    fn parse(arguments: &[String]) -> Self {
        let mut arguments = arguments.iter();
        let mut options = Self {
            install: true,
            rest: Vec::new(),
        };
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--no-install" => options.install = false,
                // The first separator is for us; a later one is for what we start,
                // as in `cargo xtask test seam -- --nocapture`.
                "--" => {
                    if !options.rest.is_empty() {
                        options.rest.push(argument.clone());
                    }
                    options.rest.extend(arguments.by_ref().cloned());
                }
                _ => options.rest.push(argument.clone()),
            }
        }
        options
    }
}

fn play(options: &Options) -> Result<u8, Error> {
    let session = Session::current();
    provide(Purpose::Play(session), options.install)?;
    let features = features();
    let features = features.as_deref();
    if session.has_display() || !options.rest.is_empty() {
        return steps::game(&options.rest, features);
    }
    eprintln!(
        "xtask: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set), so the tour is played offscreen"
    );
    // The whole path, because the game says where the pictures are.
    let pictures = steps::root().join("tour");
    let tour = [
        OsStr::new("tour"),
        OsStr::new("--out"),
        pictures.as_os_str(),
    ];
    steps::game(&tour, features)
}

/// The features the game is built with, where that is not all of them: what lacks its library is left out.
fn features() -> Option<Vec<&'static str>> {
    if !cfg!(target_os = "linux") {
        return None;
    }
    let (with, without) = packages::reduced_features(&Machine::look())?;
    eprintln!("xtask: the game is built without {}", without.join(" and "));
    Some(with)
}

/// Sees to the system packages, or says what they are.
fn provide(purpose: Purpose, install: bool) -> Result<(), Error> {
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let machine = Machine::look();
    let missing = packages::missing(purpose, &machine);
    if !install {
        print!("{}", packages::listing(&missing, purpose));
        return Ok(());
    }
    if missing.is_empty() {
        return Ok(());
    }
    eprint!("{}", packages::listing(&missing, purpose));
    if !machine.uses_apt() {
        eprintln!(
            "This is neither Debian nor Ubuntu, so please install them with your system's own package manager. \
             Going on without them."
        );
        return Ok(());
    }
    apt::install(&missing, &machine)?;
    let still = packages::missing(purpose, &Machine::look());
    if !still.is_empty() {
        eprint!(
            "Even after the installation: {}",
            packages::listing(&still, purpose)
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    fn words(text: &str) -> Vec<String> {
        text.split_whitespace().map(str::to_owned).collect()
    }

    #[test]
    fn unknown_arguments_go_to_the_game() {
        let options = Options::parse(&words("--no-install --geometry spherical --seed 7"));
        assert!(!options.install);
        assert_eq!(options.rest, words("--geometry spherical --seed 7"));
    }

    #[test]
    fn what_follows_two_dashes_is_never_ours() {
        let options = Options::parse(&words("-- tour --no-install"));
        assert!(options.install);
        assert_eq!(options.rest, words("tour --no-install"));
    }

    #[test]
    fn a_second_separator_is_handed_on() {
        let options = Options::parse(&words("seam -- --nocapture"));
        assert_eq!(options.rest, words("seam -- --nocapture"));
    }

    #[test]
    fn wrong_usage_has_status_two_and_shows_the_usage() {
        for line in [
            "",
            "fly",
            "ci fast",
            "lab fast",
            "lab-archive a b",
            "packages --all",
        ] {
            let error = dispatch(&words(line)).unwrap_err();
            assert_eq!(error.status(), 2, "{line}");
            assert!(error.to_string().contains("cargo xtask play"), "{line}");
        }
    }

    #[test]
    fn every_command_is_in_the_usage() {
        for command in [
            "play",
            "test",
            "ci",
            "bench",
            "fuzz",
            "lab",
            "lab-archive",
            "packages",
        ] {
            assert!(
                USAGE.contains(&format!("cargo xtask {command}")),
                "{command}"
            );
        }
    }
}
