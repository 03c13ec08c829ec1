//! The live world behind the main menu: one after another, in another space each, flown over and never saved.
//!
//! A world is opened on a thread and streamed by its chunk workers as any other, with a short view distance and no
//! store. The next one is made while the present one is shown, and they change in the dark.

mod flight;
#[cfg(test)]
mod tests;

use std::time::Duration;

use antipode_scene::frame::{Frame, Quality};

use super::background::{Progress, Task};
use super::play::CHUNK_BUDGET;
use flight::{Flight, WORLDS};

/// How long a world is shown, seconds.
const SHOWN_S: f64 = 40.0;
/// The next world is begun so long before its turn, seconds.
const AHEAD_S: f64 = 12.0;
/// From light to dark, and back again, seconds.
const FADE_S: f64 = 0.8;
/// Longest that the land of a world is waited for before it is shown as it is, seconds.
const WAIT_S: f64 = 10.0;
/// Longest that a world flies on in one frame, seconds: a slow moment is no leap.
const LONGEST_S: f64 = 0.1;
/// Numbers of worlds here begin at this one and go down, so that they are never those of worlds that are played.
const FIRST_NUMBER: u64 = u64::MAX;

/// The worlds behind the menu.
#[derive(Debug, Default)]
pub struct Backdrop {
    /// Whether there is to be any, and whether the processor draws it.
    enabled: Option<bool>,
    shown: Option<Flight>,
    /// No other world is shown for the moment: what its pictures are drawn with may not be made yet.
    pub(super) held: bool,
    next: Next,
    /// How many worlds have been begun.
    begun: u64,
    /// How far the picture is faded to dark, 0 to 1.
    shade: f64,
    /// What is to pass of the flight in the next picture, seconds.
    owed_s: f64,
}

/// The world after the one that is shown.
#[derive(Debug, Default)]
enum Next {
    #[default]
    None,
    /// It is being opened.
    Opening(Task<Option<Flight>>),
    /// Its land is being made, for so many seconds already.
    Coming(Flight, f64),
    /// It can be shown.
    Ready(Flight),
    /// It could not be opened; nothing more is tried.
    Failed,
}

impl Backdrop {
    /// Allows live worlds from now on. `software`: whether the processor draws them.
    pub fn enable(&mut self, software: bool) {
        self.enabled = Some(software);
    }

    /// What the interface is to know.
    pub fn model(&self) -> antipode_ui::Backdrop {
        antipode_ui::Backdrop {
            live: self.shown.is_some(),
            shade: self.shade as f32,
        }
    }

    /// Lets time pass. Where no world is `wanted` all are dropped, on a thread: their workers have to end.
    pub fn tick(&mut self, passed: Duration, wanted: bool) {
        let Some(software) = self.enabled.filter(|_| wanted) else {
            self.drop_all();
            return;
        };
        let passed_s = passed.as_secs_f64().min(LONGEST_S);
        self.owed_s = (self.owed_s + passed_s).min(LONGEST_S);
        if let Some(shown) = &mut self.shown {
            shown.pump(CHUNK_BUDGET);
        }
        self.prepare(passed_s, software);
        self.fade(passed_s);
    }

    /// Has the next world made when its turn is near.
    fn prepare(&mut self, passed_s: f64, software: bool) {
        let shown_s = self.shown.as_ref().map_or(SHOWN_S, Flight::shown_s);
        self.next = match std::mem::take(&mut self.next) {
            Next::None if shown_s >= SHOWN_S - AHEAD_S => self.begin(software),
            Next::Opening(task) => match task.poll() {
                Progress::Running => Next::Opening(task),
                Progress::Done(Some(flight)) => Next::Coming(flight, 0.0),
                Progress::Done(None) | Progress::Died => Next::Failed,
            },
            Next::Coming(mut flight, waited_s) => {
                flight.pump(CHUNK_BUDGET);
                if self.held {
                    Next::Coming(flight, waited_s)
                } else if flight.is_complete() || waited_s >= WAIT_S {
                    Next::Ready(flight)
                } else {
                    Next::Coming(flight, waited_s + passed_s)
                }
            }
            other => other,
        };
    }

    fn begin(&mut self, software: bool) -> Next {
        let world = WORLDS[(self.begun % WORLDS.len() as u64) as usize];
        let number = FIRST_NUMBER - self.begun;
        self.begun += 1;
        let quality = if software {
            Quality::Fast
        } else {
            Quality::Balanced
        };
        Next::Opening(Task::start("backdrop", move || {
            Flight::open(world, number, software, quality)
                .inspect_err(|error| tracing::info!("no world behind the menu: {error}"))
                .ok()
        }))
    }

    /// Darkens before a change and brightens after it.
    fn fade(&mut self, passed_s: f64) {
        let due = self
            .shown
            .as_ref()
            .is_none_or(|shown| shown.shown_s() >= SHOWN_S);
        let leaves = due && matches!(self.next, Next::Ready(_));
        let by = passed_s / FADE_S;
        self.shade = (self.shade + if leaves { by } else { -by }).clamp(0.0, 1.0);
        if !leaves || self.shade < 1.0 {
            return;
        }
        if let Next::Ready(flight) = std::mem::take(&mut self.next)
            && let Some(before) = self.shown.replace(flight)
        {
            Task::start("backdrop", move || drop(before));
        }
    }

    fn drop_all(&mut self) {
        self.shade = 0.0;
        let shown = self.shown.take();
        let next = std::mem::take(&mut self.next);
        if shown.is_none() && matches!(next, Next::None | Next::Failed) {
            // What failed once is not tried again each time that the menu opens.
            self.next = next;
            return;
        }
        Task::start("backdrop", move || drop((shown, next)));
    }

    /// The picture to draw, after the flight of the time that has passed.
    pub fn frame(&mut self, aspect: f64, height_px: u32) -> Option<Frame> {
        let by_s = std::mem::take(&mut self.owed_s);
        let shown = self.shown.as_mut()?;
        shown.fly(by_s);
        Some(shown.frame(aspect, height_px))
    }
}
