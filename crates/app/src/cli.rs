//! The command line: what may be asked for, and who answers.

use std::ffi::OsString;
use std::panic::AssertUnwindSafe;
use std::path::PathBuf;

use antipode_geometry::Geometry;
use antipode_scene::frame::Quality;
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::failure::Failure;
use crate::log::LogLevel;
use crate::script::Shooting;
use crate::trouble::Trouble;
use crate::{confined, crash, log_file, session};
use crate::{rooms_command, saves_command, script, tour, window};

/// Exit status of a failure at run time.
pub const EXIT_FAILED: u8 = 1;
/// Exit status of wrong usage.
pub const EXIT_USAGE: u8 = 2;
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
    /// Radius of the new spherical world in metres, 16 to 256.
    #[arg(long, requires = "geometry", value_name = "METRES")]
    pub radius: Option<f64>,
    /// Begin straight in a saved world.
    #[arg(long, value_name = "NAME", conflicts_with = "geometry")]
    pub load: Option<String>,
    /// The report of a crash to tell of first; the game starts itself so after one.
    #[arg(long, hide = true, value_name = "REPORT", conflicts_with_all = ["geometry", "load"])]
    pub after_crash: Option<PathBuf>,
    /// Why the graphics of the game before failed; the game starts itself so when they do.
    #[arg(long, hide = true, value_name = "WHY", conflicts_with_all = ["geometry", "load", "after_crash"])]
    pub after_graphics: Option<Trouble>,
    /// Break on purpose, to see what becomes of it.
    #[arg(long, hide = true, value_enum)]
    pub inject: Option<Fault>,
    /// Options of every command.
    #[command(flatten)]
    pub common: Common,
}

/// Options that every command understands.
#[derive(Clone, Debug, Args)]
pub struct Common {
    /// Where worlds are kept.
    #[arg(long, global = true, value_name = "DIR")]
    pub saves_dir: Option<PathBuf>,
    /// What draws the pictures.
    #[arg(long, global = true, value_enum, default_value_t = Adapter::Auto)]
    pub adapter: Adapter,
    /// How much exactness pictures trade for speed: fast, balanced or exact [default: the settings', for commands
    /// balanced].
    #[arg(long, global = true)]
    pub quality: Option<Quality>,
    /// The file of the settings; without it commands go by the defaults, and the window by the player's own file.
    #[arg(long, global = true, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Size of the window or the pictures in pixels.
    #[arg(long, global = true, value_parser = parse_size, default_value = "1280x720", value_name = "WxH")]
    pub size: (u32, u32),
    /// How far land is loaded, in chunks of 32 metres, 1 to 16.
    #[arg(long, global = true, value_name = "CHUNKS", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub view_distance: Option<u32>,
    /// How much the log says [default: warn for the window, error for commands].
    #[arg(long, global = true, value_enum)]
    pub log: Option<LogLevel>,
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

/// What can be broken on purpose while the game runs in its window: two seconds of frames after a world is there, or
/// from the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Fault {
    /// A panic of the main thread.
    Panic,
    /// The adapter is lost, and can be opened again.
    LostDevice,
    /// The adapter is lost, and no other can be opened.
    DeadDevice,
    /// The window's surface is lost.
    LostSurface,
    /// The adapter refuses a shader.
    BrokenShader,
    /// The machine sleeps for some hours.
    Suspend,
    /// The window comes to a monitor with twice the pixels.
    Rescale,
}

/// What draws the pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Adapter {
    /// A graphics card if there is one, else software.
    Auto,
    /// A graphics card, or fail.
    Gpu,
    /// Software rendering.
    Software,
    /// No pictures at all.
    None,
}

/// What to do instead of playing.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a script without a window.
    Script {
        /// The script's file, or - for standard input.
        file: PathBuf,
    },
    /// Play the built-in tour of the three spaces and make pictures.
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

/// What can be done with saved worlds.
#[derive(Debug, Subcommand)]
pub enum SavesAction {
    /// Every world, newest first.
    List,
    /// One world's particulars.
    Info {
        /// The world's name.
        name: String,
    },
    /// Read everything in a world and say whether it is sound.
    Verify {
        /// The world's name.
        name: String,
    },
    /// Rescue what can be read of a damaged world; the damaged file is kept beside it.
    Repair {
        /// The world's name.
        name: String,
    },
    /// Delete a world for ever.
    Delete {
        /// The world's name.
        name: String,
    },
    /// Write a world into one file.
    Export {
        /// The world's name.
        name: String,
        /// The file to write.
        file: PathBuf,
    },
    /// Bring a world in from a file.
    Import {
        /// The file to read.
        file: PathBuf,
    },
    /// Work that the game gives to a process of its own.
    #[command(hide = true)]
    Confined {
        /// What to do.
        #[command(subcommand)]
        task: confined::Task,
    },
}

/// What can be done with rooms.
#[derive(Debug, Subcommand)]
pub enum RoomsAction {
    /// Every room: the player's own, then those that come with the game.
    List,
    /// Read a room and every file that it names, and say whether it is sound.
    Verify {
        /// The room's name.
        name: String,
    },
    /// Write a room into one file.
    Export {
        /// The room's name.
        name: String,
        /// The file to write.
        file: PathBuf,
    },
    /// Bring a room in from a file.
    Import {
        /// The file to read.
        file: PathBuf,
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

/// The text, or its beginning if it has more than `most` characters.
pub fn shortened(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
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
            let start = match (after, cli.geometry, cli.load) {
                (Some(after), ..) => window::Start::After(after),
                (None, Some(geometry), _) => window::Start::New {
                    geometry,
                    seed: cli.seed,
                    name: cli.name,
                    radius_m: cli.radius,
                },
                (None, None, Some(name)) => window::Start::Load { name },
                (None, None, None) => window::Start::Menu,
            };
            let play = AssertUnwindSafe(|| window::run(start, &cli.common, cli.inject));
            crash::guard(log_file::folder().as_deref(), again, play)
        }
    }
}

fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let wrong =
        || format!("\"{text}\" is not a size; write it like 1280x720, each side from 64 to 8192");
    let (width, height) = text.split_once('x').ok_or_else(wrong)?;
    let side = |s: &str| {
        s.parse::<u32>()
            .ok()
            .filter(|n| (64..=8192).contains(n))
            .ok_or_else(wrong)
    };
    Ok((side(width)?, side(height)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }

    #[test]
    fn sizes_are_read_and_nonsense_is_refused() {
        assert_eq!(parse_size("640x360"), Ok((640, 360)));
        for wrong in ["640", "x", "0x0", "-1x5", "640x99999", "640x360x2", "axb"] {
            assert!(parse_size(wrong).is_err(), "{wrong} passed");
        }
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
