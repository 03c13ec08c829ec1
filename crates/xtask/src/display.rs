//! Displays: the one the player sits at, and one in memory for the window tests.

use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use crate::error::Error;

/// The display servers that a program started here can reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Session {
    /// `DISPLAY` is set.
    pub x11: bool,
    /// `WAYLAND_DISPLAY` is set.
    pub wayland: bool,
}

impl Session {
    /// Reads the environment.
    pub fn current() -> Self {
        let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        Self {
            x11: set("DISPLAY"),
            wayland: set("WAYLAND_DISPLAY"),
        }
    }

    /// Whether a window can be opened; elsewhere than on Linux, always.
    pub fn has_display(self) -> bool {
        self.x11 || self.wayland || !cfg!(target_os = "linux")
    }
}

/// An X server in memory, stopped when this is dropped.
#[derive(Debug)]
pub struct Xvfb {
    server: Child,
    /// `:N`, as `DISPLAY` takes it.
    pub name: String,
}

impl Xvfb {
    const START_LIMIT: Duration = Duration::from_secs(30);

    /// Starts a server of 2560x1440 pixels on a display that nobody uses.
    ///
    /// The server looks for the free number itself (`-displayfd`) and tells it
    /// once it takes connections, so there is neither a race for the number nor
    /// a wait for the socket. What it has to say goes to the file `log`.
    ///
    /// # Errors
    /// When the log cannot be made, or Xvfb cannot be started or gives no display.
    pub fn start(log: &Path) -> Result<Self, Error> {
        let words = File::create(log).map_err(|source| Error::Scratch {
            path: log.into(),
            source,
        })?;
        let server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-screen",
                "0",
                "2560x1440x24",
                "-nolisten",
                "tcp",
                "-noreset",
            ])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(words)
            .spawn()
            .map_err(|source| Error::Start {
                program: "Xvfb".into(),
                source,
            })?;
        let mut display = Self {
            server,
            name: String::new(),
        };
        match display.announced_number() {
            Some(number) => display.name = format!(":{number}"),
            None => return Err(Error::NoDisplay(last_words(log))),
        }
        Ok(display)
    }

    /// The first line that the server prints, if it is a number and comes in time.
    fn announced_number(&mut self) -> Option<u32> {
        let output = self.server.stdout.take()?;
        let (send, receive) = mpsc::channel();
        thread::spawn(move || {
            let mut line = String::new();
            let read = BufReader::new(output).read_line(&mut line);
            // Nobody listens any more when the wait was too long.
            let _ = send.send(read.map(|_| line));
        });
        let line = receive.recv_timeout(Self::START_LIMIT).ok()?.ok()?;
        line.trim().parse().ok()
    }
}

impl Drop for Xvfb {
    fn drop(&mut self) {
        // A polite end lets the server remove its socket and its lock; a child
        // that has already ended makes all of this do nothing. A small system
        // has no `kill` but the shell's.
        let asked = Command::new("sh")
            .args(["-c", &format!("kill {}", self.server.id())])
            .stderr(Stdio::null())
            .status();
        if !asked.is_ok_and(|status| status.success()) {
            let _ = self.server.kill();
        }
        let _ = self.server.wait();
    }
}

fn last_words(log: &Path) -> String {
    let text = fs::read_to_string(log).unwrap_or_default();
    text.lines()
        .rev()
        .find(|line| !line.trim().is_empty())
        .unwrap_or("(nothing)")
        .trim()
        .to_owned()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn either_server_is_a_display() {
        assert!(
            Session {
                x11: true,
                wayland: false
            }
            .has_display()
        );
        assert!(
            Session {
                x11: false,
                wayland: true
            }
            .has_display()
        );
        let none = Session {
            x11: false,
            wayland: false,
        };
        assert_eq!(none.has_display(), !cfg!(target_os = "linux"));
    }

    #[test]
    fn two_servers_get_two_displays_and_clear_them_away() {
        let log = std::env::temp_dir().join(format!("xtask-xvfb-{}", std::process::id()));
        let socket = |name: &str| format!("/tmp/.X11-unix/X{}", name.trim_start_matches(':'));
        let (first, second) = match (Xvfb::start(&log), Xvfb::start(&log)) {
            (Ok(first), Ok(second)) => (first, second),
            (Err(Error::Start { .. }), _) => return, // no Xvfb on this machine, nothing to try
            (first, second) => panic!("{first:?} {second:?}"),
        };
        assert_ne!(first.name, second.name);
        let sockets = [socket(&first.name), socket(&second.name)];
        assert!(sockets.iter().all(|path| fs::exists(path).unwrap()));
        drop((first, second));
        assert!(!sockets.iter().any(|path| fs::exists(path).unwrap()));
        fs::remove_file(&log).unwrap();
    }

    #[test]
    fn the_last_words_are_the_last_line_that_says_something() {
        let path = std::env::temp_dir().join(format!("xtask-words-{}", std::process::id()));
        fs::write(&path, "warning\n(EE) no screens found\n\n").unwrap();
        let words = last_words(&path);
        fs::remove_file(&path).unwrap();
        assert_eq!(words, "(EE) no screens found");
        assert_eq!(last_words(&path), "(nothing)");
    }
}
