//! Writes a report when the game itself breaks, and finds words for it.

use std::backtrace::Backtrace;
use std::ffi::{OsStr, OsString};
use std::fmt::Write as _;
use std::panic::{PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use crate::failure::Failure;
use crate::output::escaped_lines;
use crate::trouble::Trouble;

/// The option that a game is started with after another has crashed: it shows the report's place.
pub const AFTER_CRASH: &str = "--after-crash";
/// The option that a game is started with after another has lost its graphics: it says why.
pub const AFTER_GRAPHICS: &str = "--after-graphics";

/// What breaks at every start breaks sooner than this: a game that has gone on for so long is started anew, however the one before
/// ended.
const PLAYED: Duration = Duration::from_secs(30);

/// Where the report of this process's crash lies.
type Report = Arc<Mutex<Option<PathBuf>>>;

/// Runs the game in its window. If it breaks, its report is written, what was written goes to the log, and the game
/// is started anew to say so: not again at once, so that what breaks at every start does not go on for ever. So it is where the
/// graphics fail for good, since without them nothing can be said in the window; the new game draws in software.
///
/// # Errors
/// The game's own, or that it has crashed.
pub fn guard(
    folder: Option<&Path>,
    again: bool,
    play: impl FnOnce() -> Result<(), Failure> + std::panic::UnwindSafe,
) -> Result<(), Failure> {
    let (begun, report) = (Instant::now(), Report::default());
    install(folder.map(Path::to_owned), Arc::clone(&report));
    let Ok(ended) = catch_unwind(play) else {
        let path = report.lock().unwrap_or_else(PoisonError::into_inner).take();
        let again = again || begun.elapsed() > PLAYED;
        if again && let Some(path) = &path {
            start_again(
                kept_options(std::env::args_os().skip(1), &OF_A_WORLD),
                AFTER_CRASH,
                path,
            );
        }
        return Err(Failure::Crashed {
            report: path.map_or_else(|| "the log".to_owned(), |p| p.display().to_string()),
        });
    };
    if let (true, Err(Failure::Render(error))) = (again, &ended)
        && let Some(trouble) = Trouble::of(error)
    {
        let but = [&OF_A_WORLD[..], &["--adapter"]].concat();
        let mut options = kept_options(std::env::args_os().skip(1), &but);
        options.extend(["--adapter", "software"].map(OsString::from));
        start_again(options, AFTER_GRAPHICS, trouble.to_string());
    }
    ended
}

/// Reports panics of the main thread; those of others are caught where they work, and told there.
fn install(folder: Option<PathBuf>, report: Report) {
    let before = take_hook();
    let main = std::thread::current().id();
    set_hook(Box::new(move |panic| {
        before(panic);
        let name = std::thread::current()
            .name()
            .unwrap_or("unnamed")
            .to_owned();
        tracing::error!("thread {name} panicked: {panic}");
        if std::thread::current().id() == main
            && let Some(folder) = &folder
        {
            let path = folder.join(format!("crash-{}.txt", seconds_now()));
            let written = std::fs::create_dir_all(folder)
                .and_then(|()| std::fs::write(&path, escaped_lines(&text(panic))));
            match written {
                Ok(()) => *report.lock().unwrap_or_else(PoisonError::into_inner) = Some(path),
                Err(e) => tracing::error!("no report could be written to {}: {e}", path.display()),
            }
        }
    }));
}

fn text(panic: &PanicHookInfo<'_>) -> String {
    let mut text = format!(
        "Antipode {} on {} {}, {} s after 1970\n\n{panic}\n\n",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH,
        seconds_now(),
    );
    // Formatting into a String does not fail.
    let _ = writeln!(text, "{}", Backtrace::force_capture());
    text
}

fn seconds_now() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |since| since.as_secs())
}

/// The same program with these options: in its menu, with words about why.
fn start_again(options: Vec<OsString>, why: &str, details: impl AsRef<OsStr>) {
    let Ok(program) = std::env::current_exe() else {
        return;
    };
    let mut command = Command::new(program);
    command.args(options);
    command.arg(why).arg(details).stdin(Stdio::null());
    if let Err(e) = command.spawn() {
        tracing::error!("the game could not be started again: {e}");
    }
}

/// Options that say which world the game began in, how the one before ended, and what breaks it on purpose.
const OF_A_WORLD: [&str; 9] = [
    "--geometry",
    "--seed",
    "--name",
    "--radius",
    "--load",
    "--room",
    "--inject",
    AFTER_CRASH,
    AFTER_GRAPHICS,
];

/// What the new game is started with: everything but these options and their values.
fn kept_options(arguments: impl Iterator<Item = OsString>, but: &[&str]) -> Vec<OsString> {
    let mut kept = Vec::new();
    let mut arguments = arguments;
    while let Some(argument) = arguments.next() {
        // What is no text is no option, and what follows an option may be anything.
        let words = argument.to_string_lossy();
        if but.contains(&words.as_ref()) {
            arguments.next();
        } else if !but.iter().any(|o| words.starts_with(&format!("{o}="))) {
            kept.push(argument);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use clap::Parser as _;

    use super::*;

    #[test]
    fn the_new_game_keeps_the_options_and_leaves_the_world() {
        let args = [
            "--size",
            "640x360",
            "--load",
            "Foo",
            "--seed=7",
            "--saves-dir",
            "/x",
        ];
        let kept = kept_options(args.map(OsString::from).into_iter(), &OF_A_WORLD);
        assert_eq!(kept, ["--size", "640x360", "--saves-dir", "/x"]);
    }

    /// Else the new game would not start, and nobody would be told of the crash: be it the second, or one in a room.
    #[test]
    fn the_new_game_takes_its_own_options_beside_what_is_kept_of_any() {
        let begun: [&[&str]; 5] = [
            &[
                "--geometry",
                "spherical",
                "--seed=7",
                "--name",
                "x",
                "--radius",
                "64",
            ],
            &["--load", "x"],
            &["--room", "x", "--inject=panic"],
            &[AFTER_CRASH, "/report"],
            &[AFTER_GRAPHICS, "lost"],
        ];
        for options in begun {
            let given = options.iter().map(OsString::from);
            let taken = |options: Vec<OsString>| {
                let program = OsString::from("antipode");
                crate::cli::Cli::try_parse_from([program].into_iter().chain(options)).is_ok()
            };
            let kept = kept_options(given, &OF_A_WORLD);
            assert!(kept.is_empty(), "{kept:?}");
            let own = [AFTER_CRASH, "/report"].map(OsString::from);
            assert!(taken(kept.into_iter().chain(own).collect()), "{options:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn options_that_are_no_text_are_kept_as_they_are() {
        use std::os::unix::ffi::OsStringExt;
        let odd = |bytes: &[u8]| OsString::from_vec(bytes.to_vec());
        let args = [
            odd(b"--saves-dir"),
            odd(b"/\xff"),
            odd(b"--name=\xff"),
            odd(b"--load"),
            odd(b"\xfe"),
            odd(b"--config=/\xfd"),
        ];
        let kept = kept_options(args.into_iter(), &OF_A_WORLD);
        let left = [&b"--saves-dir"[..], b"/\xff", b"--config=/\xfd"].map(odd);
        assert_eq!(kept, left);
    }
}
