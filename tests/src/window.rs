//! The game in a real window under a virtual display: how it is opened, asked and ended.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

mod eyes;
mod hands;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::background::try_signal;
use crate::processes::{arguments, started_with};
use crate::program::game;
use crate::screen::Screen;

/// Longest wait for something to appear; a deadline for a hung program, not a measure of speed.
const PATIENCE: Duration = Duration::from_mins(2);
/// A program whose window is gone has ended within this.
const GONE_WITHIN: Duration = Duration::from_secs(10);
/// Pause between looks at the screen.
const GLANCE: Duration = Duration::from_millis(150);

/// Who may have a window open: there is one keyboard, and two tests of one program would fight for it.
static KEYBOARD: Mutex<()> = Mutex::new(());

/// A game in a window on the test display. While it is open no other test of the same program opens one.
#[derive(Debug)]
pub struct Window {
    /// `None` of a game that another game has started.
    child: Option<Child>,
    process: u32,
    display: String,
    screen: Screen,
    id: String,
    /// What it writes to standard error.
    words: PathBuf,
    _keyboard: MutexGuard<'static, ()>,
}

/// Settings under which pictures can be compared: a still menu, English, no hints; `more` is put behind them.
///
/// # Panics
/// When they cannot be written.
pub fn settle_settings(saves: &Path, more: &str) {
    let text = format!(
        "(schema: 1, settings: {{\"language\": \"en\", \"reduced-motion\": true, \"hints\": false{more}}})"
    );
    std::fs::write(settings_file(saves), text).expect("the settings can be written");
}

/// Has newcomers told what to do: at the log level debug what they have learnt is said then.
///
/// # Panics
/// When the settings cannot be read or written.
pub fn with_hints(saves: &Path) {
    let file = settings_file(saves);
    let text = std::fs::read_to_string(&file).expect("the settings can be read");
    let text = text.replace("\"hints\": false", "\"hints\": true");
    std::fs::write(file, text).expect("the settings can be written");
}

/// Where a window's settings are.
pub fn settings_file(saves: &Path) -> PathBuf {
    saves.join("settings.ron")
}

/// The display for window tests, or `None` where nobody provides one.
pub fn display() -> Option<String> {
    std::env::var("ANTIPODE_TEST_DISPLAY")
        .ok()
        .filter(|name| !name.is_empty())
}

impl Window {
    /// Starts the game and waits for its window, which gets the keyboard. One that ends by itself before, as a
    /// fault may have it, is left to [`Self::ended`].
    ///
    /// # Panics
    /// When it does not appear.
    pub fn open(display: &str, saves: &Path, options: &[&str]) -> Self {
        // A test that failed has let go of its window, too.
        let keyboard = KEYBOARD.lock().unwrap_or_else(PoisonError::into_inner);
        let words = saves.join("stderr.txt");
        let child = game(saves)
            .args(options)
            .arg("--config")
            .arg(settings_file(saves))
            .env("DISPLAY", display)
            .env_remove("WAYLAND_DISPLAY")
            .stderr(File::create(&words).expect("a file for its words"))
            .spawn()
            .expect("the program starts");
        let mut window = Self {
            process: child.id(),
            child: Some(child),
            display: display.to_owned(),
            screen: Screen::connect(display),
            id: String::new(),
            words,
            _keyboard: keyboard,
        };
        if window.find() {
            window.focus();
        }
        window
    }

    /// Finds the window of a game that another one on these saves has started with that option, and gives it the
    /// keyboard.
    ///
    /// # Panics
    /// When there is none.
    pub fn follow(display: &str, saves: &Path, option: &str) -> Self {
        let keyboard = KEYBOARD.lock().unwrap_or_else(PoisonError::into_inner);
        let began = Instant::now();
        let process = loop {
            if let Some(process) = started_with(saves, option) {
                break process;
            }
            assert!(
                began.elapsed() < PATIENCE,
                "no game was started with {option}"
            );
            sleep(GLANCE);
        };
        let mut window = Self {
            child: None,
            process,
            display: display.to_owned(),
            screen: Screen::connect(display),
            id: String::new(),
            words: saves.join("stderr.txt"),
            _keyboard: keyboard,
        };
        assert!(window.find(), "the game ended: {}", window.said());
        window.focus();
        window
    }

    /// Waits for the window; whether the game is still there.
    fn find(&mut self) -> bool {
        let began = Instant::now();
        while self.id.is_empty() {
            if !self.is_alive() {
                return false;
            }
            self.give_up_after(began, "the window never appeared");
            // By its process, too: others may have the game open on the same display.
            let process = self.process.to_string();
            let search = ["search", "--all", "--pid", &process, "--name", "^Antipode$"];
            let found = self.tool("xdotool", &search);
            let listed = String::from_utf8_lossy(&found.stdout).into_owned();
            listed
                .lines()
                .next()
                .unwrap_or_default()
                .clone_into(&mut self.id);
            sleep(GLANCE);
        }
        true
    }

    /// Gives it the keyboard.
    fn focus(&mut self) {
        let focus = ["windowfocus", "--sync", &self.id.clone()];
        let focused = self.tool("xdotool", &focus);
        if !focused.status.success() {
            // A window that goes away in this moment cannot be given the keyboard.
            sleep(GONE_WITHIN);
            let words = String::from_utf8_lossy(&focused.stderr);
            assert!(!self.is_alive(), "xdotool {focus:?}: {words}");
        }
    }

    /// Asks for another size, in pixels.
    pub fn resize(&self, width: u32, height: u32) {
        let (width, height) = (width.to_string(), height.to_string());
        self.xdotool(&["windowsize", &self.id, &width, &height]);
    }

    /// Puts the window away, as its button on a frame would.
    pub fn minimise(&self) {
        self.xdotool(&["windowminimize", &self.id]);
    }

    /// Brings the window back with the keyboard.
    pub fn restore(&self) {
        self.xdotool(&["windowmap", "--sync", &self.id]);
        self.xdotool(&["windowactivate", "--sync", &self.id]);
    }

    /// Waits for anything outside of the picture.
    ///
    /// # Panics
    /// When it does not come.
    pub fn wait_while(&mut self, what: &str, lacking: impl Fn() -> bool) {
        let began = Instant::now();
        while lacking() {
            self.give_up_after(began, what);
            sleep(GLANCE);
        }
    }

    /// Whether the program is still there.
    ///
    /// # Panics
    /// When nobody can tell.
    pub fn is_alive(&mut self) -> bool {
        match &mut self.child {
            Some(child) => {
                let ended = child.try_wait();
                ended.expect("the program can be asked").is_none()
            }
            None => arguments(self.process).is_some(),
        }
    }

    /// What the program has written to standard error so far.
    pub fn said(&self) -> String {
        std::fs::read_to_string(&self.words).unwrap_or_default()
    }

    /// Waits until the program has written these words to standard error.
    ///
    /// # Panics
    /// When it does not.
    pub fn wait_for(&mut self, words: &str) {
        self.wait_for_after(0, words);
    }

    /// Waits until the program has written these words behind the first `heard` bytes of what it said.
    fn wait_for_after(&mut self, heard: usize, words: &str) {
        let began = Instant::now();
        while !self
            .said()
            .get(heard..)
            .is_some_and(|new| new.contains(words))
        {
            self.give_up_after(began, words);
            sleep(GLANCE);
        }
    }

    /// Waits until that is what the program says, at the log level debug, that its window shows now.
    ///
    /// # Panics
    /// When it does not.
    pub fn shows(&mut self, what: &str) {
        let words = format!("shown: {what}.");
        let began = Instant::now();
        loop {
            let said = self.said();
            let last = said.lines().rfind(|line| line.contains(" shown: "));
            if last.is_some_and(|line| line.ends_with(&words)) {
                return;
            }
            self.give_up_after(began, &words);
            sleep(GLANCE);
        }
    }

    /// The number of the program's process.
    pub fn process(&self) -> u32 {
        self.process
    }

    /// Waits until a game that another one has started is gone.
    ///
    /// # Panics
    /// When it does not end.
    pub fn gone(mut self) {
        let began = Instant::now();
        while self.is_alive() {
            self.give_up_after(began, "the program did not end");
            sleep(GLANCE);
        }
    }

    /// Waits until the program has ended by itself; its exit status.
    ///
    /// # Panics
    /// When it does not end.
    pub fn ended(mut self) -> Option<i32> {
        let began = Instant::now();
        loop {
            let child = self
                .child
                .as_mut()
                .expect("a game that this test has started");
            if let Some(status) = child.try_wait().expect("the program can be waited for") {
                return status.code();
            }
            self.give_up_after(began, "the program did not end");
            sleep(GLANCE);
        }
    }

    fn give_up_after(&mut self, began: Instant, what: &str) {
        if began.elapsed() > PATIENCE {
            let path = std::env::temp_dir().join("antipode-window-test.png");
            let seen = self
                .id
                .parse()
                .ok()
                .and_then(|id| self.screen.picture(id).ok());
            let path = match seen.map(|picture| picture.save(&path)) {
                Some(Ok(())) => path.display().to_string(),
                _ => "none".to_owned(),
            };
            self.kill();
            panic!("{what} (picture: {path})\n{}", self.said());
        }
    }

    fn kill(&mut self) {
        match &mut self.child {
            Some(child) => {
                let _ = child.kill();
                let _ = child.wait();
            }
            None if arguments(self.process).is_some() => {
                let _ = try_signal("KILL", self.process);
            }
            None => {}
        }
    }

    fn xdotool(&self, arguments: &[&str]) {
        let output = self.tool("xdotool", arguments);
        assert!(
            output.status.success(),
            "xdotool {arguments:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }

    fn tool(&self, name: &str, arguments: &[&str]) -> Output {
        // `xdotool --sync` waits for ever for a window that never does what it was asked.
        let output = Command::new("timeout")
            .arg(PATIENCE.as_secs().to_string())
            .arg(name)
            .args(arguments)
            .env("DISPLAY", &self.display)
            .output()
            .unwrap_or_else(|e| panic!("{name} cannot be run: {e}"));
        assert_ne!(
            output.status.code(),
            Some(124),
            "{name} {arguments:?} did not end"
        );
        output
    }
}

impl Drop for Window {
    fn drop(&mut self) {
        self.kill();
    }
}
