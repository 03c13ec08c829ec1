//! The command line: its arguments, and the function that handles each command.

use std::ffi::OsString;
use std::panic::AssertUnwindSafe;
use std::path::PathBuf;

use antipode_geometry::Geometry;
use antipode_scene::Mode;
use clap::{Parser, Subcommand};

use crate::common::Common;
use crate::failure::Failure;
use crate::log::LogLevel;
use crate::rooms_command::RoomsAction;
use crate::saves_command::SavesAction;
use crate::script::Shooting;
use crate::text::shortened;
use crate::trouble::Trouble;
use crate::window::Fault;
use crate::{crash, log_file, session};
use crate::{rooms_command, saves_command, script, tour, window};

/// Most characters of a mistake on the command line; it may quote what was typed.
const LONGEST_MISTAKE: usize = 240;

/// A voxel-terrain game in curved space.
#[derive(Debug, Parser)]
#[command(name = "antipode", bin_name = "antipode", version, about)]
pub struct Cli {
    /// What to do; without it the game opens in a window.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Begin straight in a new world of this space.
    #[arg(long, value_name = "SPACE")]
    pub geometry: Option<Geometry>,
    /// Seed of the new world; random when left out.
    #[arg(long, requires = "geometry")]
    pub seed: Option<u64>,
    /// Name of the new world.
    #[arg(long, requires = "geometry")]
    pub name: Option<String>,
    /// Radius of the new spherical world in metres, 16 to 256, or of the new hyperbolic-world, 30 to 121.
    #[arg(long, requires = "geometry", value_name = "METRES")]
    pub radius: Option<f64>,
    /// What building costs in the new world: nothing (creative), or what was dug (gathering).
    #[arg(long, requires = "geometry", value_name = "MODE")]
    pub mode: Option<Mode>,
    /// Begin straight in a saved world.
    #[arg(long, value_name = "NAME", conflicts_with = "geometry")]
    pub load: Option<String>,
    /// Begin straight in a room.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["geometry", "load"])]
    pub room: Option<String>,
    /// The report of a crash to tell of first; the game starts itself so after one.
    #[arg(long, hide = true, value_name = "REPORT", conflicts_with_all = ["geometry", "load", "room"])]
    pub after_crash: Option<PathBuf>,
    /// Why the graphics of the game before failed; the game starts itself so when they do.
    #[arg(long, hide = true, value_name = "WHY", conflicts_with_all = ["geometry", "load", "room", "after_crash"])]
    pub after_graphics: Option<Trouble>,
    /// Break on purpose, to see what becomes of it.
    #[arg(long, hide = true, value_enum)]
    pub inject: Option<Fault>,
    /// Options of every command.
    #[command(flatten)]
    pub common: Common,
}

impl Cli {
    /// How much the log says. What a command has to say of a failure it says itself.
    pub fn log_level(&self) -> LogLevel {
        let usual = match self.command {
            None => LogLevel::Warn,
            Some(_) => LogLevel::Error,
        };
        self.common.log.unwrap_or(usual)
    }
}

/// What to do instead of playing.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a script without a window.
    Script {
        /// The script's file, or - for standard input.
        file: PathBuf,
    },
    /// Play the built-in tour of the four spaces and make pictures.
    Tour {
        /// Where the pictures go.
        #[arg(long, default_value = "tour")]
        out: PathBuf,
    },
    /// The laboratory, which is a program of its own.
    #[command(hide = true, disable_help_flag = true)]
    Lab {
        /// Whatever it was asked for.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        rest: Vec<OsString>,
    },
    /// Look after rooms of deformed space.
    Rooms {
        /// What to do with them.
        #[command(subcommand)]
        action: RoomsAction,
    },
    /// Look after saved worlds.
    Saves {
        /// What to do with them.
        #[command(subcommand)]
        action: SavesAction,
    },
}

/// A mistake on the command line in one line: what clap says first, without its hints.
pub fn one_line(mistake: &clap::Error) -> String {
    if mistake.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "a command is missing; --help lists those there are".to_owned();
    }
    let rendered = mistake.render().to_string();
    let said: Vec<&str> = rendered
        .lines()
        .take_while(|line| !line.trim().is_empty())
        .flat_map(str::split_whitespace)
        .collect();
    let said = said.join(" ");
    shortened(
        said.strip_prefix("error: ").unwrap_or(&said),
        LONGEST_MISTAKE,
    )
}

/// Does what the command line asks for.
///
/// # Errors
/// A [`Failure`] in words, with its exit status.
pub fn run(cli: Cli) -> Result<(), Failure> {
    match cli.command {
        Some(Command::Script { file }) => script::run_file(&file, &cli.common, Shooting::Here),
        Some(Command::Tour { out }) => tour::run(&out, &cli.common),
        Some(Command::Lab { .. }) => Err(Failure::Usage(
            "The laboratory is a program of its own: antipode-lab, or in a checkout `cargo xtask lab`.".to_owned(),
        )),
        Some(Command::Rooms { action }) => rooms_command::run(&action, &cli.common),
        Some(Command::Saves { action }) => saves_command::run(&action, &cli.common),
        None => {
            let again = cli.after_crash.is_none() && cli.after_graphics.is_none();
            if let Some(geometry) = cli.geometry {
                // Said at once, and not in a window that opens for it.
                session::radius_m(geometry, cli.radius)?;
            }
            let after = match (cli.after_crash, cli.after_graphics) {
                (Some(report), _) => Some(window::After::Crash(report)),
                (None, trouble) => trouble.map(window::After::Graphics),
            };
            let start = match (after, cli.geometry, cli.load, cli.room) {
                (Some(after), ..) => window::Start::After(after),
                (None, Some(geometry), ..) => window::Start::New {
                    geometry,
                    seed: cli.seed,
                    name: cli.name,
                    radius_m: cli.radius,
                    mode: cli.mode.unwrap_or_default(),
                },
                (None, None, Some(name), _) => window::Start::Load { name },
                (None, None, None, Some(name)) => window::Start::Room { name },
                (None, None, None, None) => window::Start::Menu,
            };
            let play = AssertUnwindSafe(|| window::run(start, &cli.common, cli.inject));
            crash::guard(log_file::folder().as_deref(), again, play)
        }
    }
}

#[cfg(test)]
mod tests {
    use antipode_scene::frame::Quality;

    use super::*;
    use crate::common::Adapter;
    use crate::failure::EXIT_USAGE;

    #[test]
    fn the_command_line_is_consistent() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }

    #[test]
    fn options_of_a_new_world_need_its_space() {
        assert!(Cli::try_parse_from(["antipode", "--seed", "7"]).is_err());
        let cli = Cli::try_parse_from(["antipode", "--geometry", "spherical", "--seed", "7"]);
        assert_eq!(
            cli.map(|c| c.geometry).ok(),
            Some(Some(Geometry::Spherical))
        );
        assert!(Cli::try_parse_from(["antipode", "--geometry", "toroidal"]).is_err());
    }

    #[test]
    fn who_asks_for_the_laboratory_is_told_its_program() {
        for line in [
            "antipode lab",
            "antipode lab all --quick",
            "antipode lab --help",
        ] {
            let cli = Cli::try_parse_from(line.split(' ')).map_err(|e| e.to_string());
            let failure = cli.map(|cli| run(cli).map_err(|e| (e.exit_status(), e.to_string())));
            let said = failure.and_then(|said| said.map_or_else(Ok, |()| Err(line.to_owned())));
            assert!(
                said.as_ref().is_ok_and(
                    |(status, words)| *status == EXIT_USAGE && words.contains("antipode-lab")
                ),
                "{said:?}"
            );
        }
    }

    #[test]
    fn mistakes_are_told_in_one_line() {
        let long = "x".repeat(5000);
        for (args, says) in [
            (vec!["--seed", "7"], "--geometry"),
            (vec!["--size", "1x1"], "from 64 to 8192"),
            (vec!["--adapter", "best"], "possible values"),
            (vec!["--quality", "best"], "fast, balanced or exact"),
            (vec!["tour", "--out"], "--out"),
            (vec!["saves"], "--help"),
            (vec!["--size", "a\n\nb"], "a"),
            (vec![long.as_str()], "xxx"),
        ] {
            let all = std::iter::once("antipode").chain(args.iter().copied());
            let line = Cli::try_parse_from(all).map_or_else(|e| one_line(&e), |_| String::new());
            assert!(line.contains(says), "{args:?}: {line}");
            assert!(!line.contains('\n') && line.chars().count() <= LONGEST_MISTAKE + 1);
        }
    }

    #[test]
    fn commands_leave_the_log_to_failures_unless_asked() {
        let level = |args: &[&str]| {
            let all = std::iter::once("antipode").chain(args.iter().copied());
            Cli::try_parse_from(all).map(|cli| cli.log_level()).ok()
        };
        assert_eq!(level(&[]), Some(LogLevel::Warn));
        assert_eq!(level(&["script", "-"]), Some(LogLevel::Error));
        assert_eq!(
            level(&["script", "-", "--log", "info"]),
            Some(LogLevel::Info)
        );
    }

    #[test]
    fn common_options_may_follow_the_command() {
        let cli = Cli::try_parse_from([
            "antipode",
            "script",
            "-",
            "--adapter",
            "none",
            "--size",
            "320x200",
            "--quality",
            "exact",
        ]);
        assert_eq!(
            cli.map(|c| (c.common.adapter, c.common.size, c.common.quality))
                .ok(),
            Some((Adapter::None, (320, 200), Some(Quality::Exact)))
        );
    }
}
