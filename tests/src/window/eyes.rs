//! What a test sees of the window.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::thread::sleep;
use std::time::{Duration, Instant};

use image::RgbImage;

use super::{GLANCE, GONE_WITHIN, Window};
use crate::seam::compare;

/// What has not changed for so long stands still; a text's cursor blinks every half second.
const STILL: Duration = Duration::from_millis(300);

/// Who falls or slides in a world is seen to do so after this, on a slow machine, too.
const CALM: Duration = Duration::from_millis(1800);
/// So far a picture of a world changes while nothing moves but sun and clouds: mean over pixels and channels, in steps
/// of 1/255.
const CALM_CHANGE: f64 = 2.0;

impl Window {
    /// What the window shows.
    ///
    /// # Panics
    /// When no picture can be taken.
    pub fn look(&self) -> RgbImage {
        let window = self.id.parse().expect("xdotool tells numbers");
        let began = Instant::now();
        loop {
            match self.screen.picture(window) {
                Ok(picture) => return picture,
                // A window that is just being made larger has no such pixels yet.
                Err(_) if began.elapsed() < GONE_WITHIN => sleep(GLANCE),
                Err(error) => panic!("no picture of the window: {error}"),
            }
        }
    }

    /// Looks until the picture is as wanted.
    ///
    /// # Panics
    /// When it does not become so.
    pub fn wait_until(&mut self, what: &str, wanted: impl Fn(&RgbImage) -> bool) -> RgbImage {
        let began = Instant::now();
        loop {
            let picture = self.look();
            if wanted(&picture) {
                return picture;
            }
            self.give_up_after(began, what);
            sleep(GLANCE);
        }
    }

    /// Looks until the picture stands still.
    ///
    /// # Panics
    /// When it does not.
    pub fn stillness(&mut self) -> RgbImage {
        let began = Instant::now();
        let (mut last, mut since) = (self.look(), Instant::now());
        while since.elapsed() < STILL {
            sleep(GLANCE);
            let next = self.look();
            if next != last {
                (last, since) = (next, Instant::now());
            }
            self.give_up_after(began, "the picture never stood still");
        }
        last
    }

    /// Looks until hardly anything moves in a world: whoever fell has landed.
    ///
    /// # Panics
    /// When it never gets calm.
    pub fn calm(&mut self) -> RgbImage {
        let began = Instant::now();
        let mut last = self.look();
        loop {
            sleep(CALM);
            let next = self.look();
            if compare(&last, &next).mean < CALM_CHANGE {
                return next;
            }
            last = next;
            self.give_up_after(began, "the world never got calm");
        }
    }
}
