//! What a test does with keyboard and mouse.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

use image::RgbImage;

use super::{GLANCE, Window};

/// Longer than a frame takes on a slow and busy machine.
const SLOW_FRAME: Duration = Duration::from_millis(900);

/// A key or button that is down until this is dropped. A test that fails lets go of it, too: a display keeps what is
/// down for the next program.
#[derive(Debug)]
struct Held {
    display: String,
    up: [String; 2],
}

impl Drop for Held {
    fn drop(&mut self) {
        let _ = Command::new("xdotool")
            .args(&self.up)
            .env("DISPLAY", &self.display)
            .status();
    }
}

impl Window {
    /// Clicks a button at a place of the window, in pixels.
    pub fn click(&self, x: u32, y: u32) {
        self.drag((x, y), (x, y));
    }

    /// Clicks with the right button at a place of the window, in pixels.
    pub fn click_right(&self, x: u32, y: u32) {
        self.press_between("3", (x, y), (x, y));
    }

    /// Presses the left button at a place of the window and lets go of it at another, in pixels.
    pub fn drag(&self, from: (u32, u32), to: (u32, u32)) {
        self.press_between("1", from, to);
    }

    fn press_between(&self, button: &str, from: (u32, u32), to: (u32, u32)) {
        self.move_to(from);
        self.xdotool(&["mousedown", button]);
        sleep(GLANCE);
        if from != to {
            // What comes within one frame of a slow machine is a click and no drag.
            sleep(SLOW_FRAME);
            self.move_to(to);
            sleep(SLOW_FRAME);
        }
        self.xdotool(&["mouseup", button]);
        sleep(GLANCE);
    }

    fn move_to(&self, (x, y): (u32, u32)) {
        let (x, y) = (x.to_string(), y.to_string());
        self.xdotool(&["mousemove", "--window", &self.id, &x, &y]);
        sleep(GLANCE);
    }

    /// Types a text.
    pub fn write(&self, text: &str) {
        self.xdotool(&["type", "--delay", "60", text]);
        sleep(GLANCE);
    }

    /// Presses and lets go of a key, by its X name.
    pub fn key(&self, name: &str) {
        self.xdotool(&["keydown", name]);
        sleep(GLANCE);
        self.xdotool(&["keyup", name]);
        sleep(GLANCE);
    }

    /// Presses a key in a menu and waits until that has changed the picture and it stands still again.
    ///
    /// # Panics
    /// When nothing changes.
    pub fn step(&mut self, name: &str) -> RgbImage {
        let before = self.look();
        self.key(name);
        let what = format!("what {name} changes");
        self.wait_until(&what, |picture| *picture != before);
        self.stillness()
    }

    /// Presses keys in a menu, one after another.
    ///
    /// # Panics
    /// When one of them changes nothing.
    pub fn steps(&mut self, names: &[&str]) {
        for name in names {
            self.step(name);
        }
    }

    /// Presses keys in a menu, each with what the program is to say of it then, such as "focus: Back"; it says so at
    /// the log level debug. Unlike [`Self::steps`] it does not take a blinking cursor for an answer.
    ///
    /// # Panics
    /// When it says something else.
    pub fn told_steps(&mut self, steps: &[(&str, &str)]) {
        for (name, words) in steps {
            let before = self.said().len();
            self.key(name);
            self.wait_for_after(before, words);
            self.stillness();
        }
    }

    /// Clicks a button at a place of the window, in pixels, and waits until the program says so. The pointer rests there
    /// meanwhile: a click is lost where it is elsewhere by the end of the frame that the click comes in.
    ///
    /// # Panics
    /// When it says something else.
    pub fn told_click(&mut self, (x, y): (u32, u32), words: &str) {
        let before = self.said().len();
        self.click(x, y);
        self.wait_for_after(before, words);
    }

    /// Types a text into a line that has the focus and holds nothing, and waits until the program says that it has it.
    ///
    /// # Panics
    /// When it does not.
    pub fn told_write(&mut self, text: &str) {
        let before = self.said().len();
        self.write(text);
        self.wait_for_after(before, &format!("changed: {text}: "));
    }

    /// Types over what a line of text holds, and waits until the program says at the log level debug that it has it.
    ///
    /// # Panics
    /// When it does not.
    pub fn overwrite(&mut self, text: &str) {
        let before = self.said().len();
        self.key("ctrl+a");
        self.write(text);
        self.wait_for_after(before, &format!("changed: {text}: "));
    }

    /// Presses a key or button and keeps it down.
    fn hold(&self, what: &str, name: &str) -> Held {
        self.xdotool(&[&format!("{what}down"), name]);
        Held {
            display: self.display.clone(),
            up: [format!("{what}up"), name.to_owned()],
        }
    }

    /// Holds a key until the program has written these words to standard error.
    ///
    /// # Panics
    /// When it does not.
    pub fn hold_key_for(&mut self, name: &str, words: &str) {
        let _held = self.hold("key", name);
        self.wait_for(words);
    }

    /// Holds the left button until the program has written these words to standard error.
    ///
    /// # Panics
    /// When it does not.
    pub fn hold_left_for(&mut self, words: &str) {
        let _held = self.hold("mouse", "1");
        self.wait_for(words);
    }

    /// Turns the view down to the ground at one's feet, and waits until the program says that the view was turned: the
    /// pointer may be caught a moment late. Needs the hints for newcomers.
    ///
    /// # Panics
    /// When it does not.
    pub fn look_down(&mut self) {
        let began = Instant::now();
        while !self.said().contains("learnt Look") {
            self.give_up_after(began, "learnt Look");
            self.turn(0, 120);
        }
        for _ in 0..3 {
            self.turn(0, 120);
        }
    }

    /// Moves the mouse by pixels.
    pub fn turn(&self, dx: i32, dy: i32) {
        self.xdotool(&["mousemove_relative", "--", &dx.to_string(), &dy.to_string()]);
        sleep(GLANCE);
    }
}
