//! Accounts for the main thread's time, frame by frame: at work, ready while others have the processor, and waiting.
//!
//! Only drawing may wait, for the adapter and the screen. Whatever else does is a mistake, and the log tells of it at
//! its level for developers.

mod clock;

use std::time::{Duration, Instant};

use antipode_timing::nearest_rank;
use clock::{Clock, Moment};

/// Time from one line in the log about the frames to the next.
const TOLD_EVERY: Duration = Duration::from_secs(10);
/// Longest that the main thread should wait in one frame besides drawing.
pub const LONGEST_WAIT: Duration = Duration::from_millis(5);
/// A frame that takes longer than this is told of by itself.
const LONG_FRAME: Duration = Duration::from_millis(250);

/// What a stretch of time is spent on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Events of the window system, gamepads, and everything of the game that has no part of its own.
    Input,
    /// Taking over finished land.
    Land,
    /// Steps of the simulation.
    Steps,
    /// What is to be seen of the world.
    Scene,
    /// One pass of the interface.
    Interface,
    /// Planning, refining, uploading and recording a picture.
    Record,
    /// The adapter's and the screen's: the next texture, and showing it.
    Drawing,
}

impl Part {
    const ALL: [Self; 7] = [
        Self::Input,
        Self::Land,
        Self::Steps,
        Self::Scene,
        Self::Interface,
        Self::Record,
        Self::Drawing,
    ];
}

/// What became of a stretch of time; the rest of it is work, or the system does not tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Spent {
    wall: Duration,
    /// Ready to run, while others had the processor, or the machine was not let run.
    starved: Duration,
    /// Neither at work nor ready: for a lock, the disk, another thread.
    blocked: Duration,
}

impl Spent {
    fn add(&mut self, other: Self) {
        self.wall += other.wall;
        self.starved += other.starved;
        self.blocked += other.blocked;
    }
}

/// One frame's time by its parts, in the order of [`Part::ALL`].
#[derive(Clone, Copy, Debug, Default)]
struct Frame([Spent; Part::ALL.len()]);

impl Frame {
    fn wall(&self) -> Duration {
        self.0.iter().map(|spent| spent.wall).sum()
    }

    /// All but drawing, taken together.
    fn undrawn(&self) -> Spent {
        let mut sum = Spent::default();
        for (part, spent) in Part::ALL.iter().zip(self.0) {
            if *part != Part::Drawing {
                sum.add(spent);
            }
        }
        sum
    }

    fn is_worth_telling(&self) -> bool {
        self.wall() > LONG_FRAME || self.undrawn().blocked > LONGEST_WAIT
    }

    fn told(&self) -> String {
        let parts = Part::ALL.iter().zip(self.0).map(|(part, spent)| {
            let [wall, starved, blocked] = [spent.wall, spent.starved, spent.blocked].map(ms);
            format!("{part:?} {wall:.1} (starved {starved:.1}, waited {blocked:.1})")
        });
        let parts: Vec<_> = parts.collect();
        format!("a frame of {:.1} ms: {}", ms(self.wall()), parts.join(", "))
    }
}

/// Keeps account of the main thread.
#[derive(Debug, Default)]
pub struct Waits {
    clock: Clock,
    /// Since when time counts; none while the thread rests until there is something to do.
    since: Option<Moment>,
    frame: Frame,
    /// Of the frames since the last line in the log.
    walls: Vec<Duration>,
    undrawn: Vec<Spent>,
    told: Option<Instant>,
    /// Of every frame, how long it waited besides drawing, and the whole of it in words.
    #[cfg(test)]
    pub waited: Vec<(Duration, String)>,
}

impl Waits {
    /// Something happens; what was before this was rest.
    pub fn wake(&mut self) {
        if tracing::enabled!(tracing::Level::DEBUG) {
            self.since = Some(self.clock.now());
        }
    }

    /// As [`Waits::wake`], whatever is in the log.
    #[cfg(test)]
    pub fn keep_account(&mut self) {
        self.since = Some(self.clock.now());
    }

    /// The time since the last of these calls went to that part.
    pub fn spent_on(&mut self, part: Part) {
        let Some(since) = self.since else { return };
        let now = self.clock.now();
        self.frame.0[part as usize].add(now.since(&since));
        self.since = Some(now);
    }

    /// Nothing is to be done until the next [`Waits::wake`].
    pub fn rest(&mut self) {
        self.spent_on(Part::Input);
        self.since = None;
    }

    /// There was nothing to draw: what that took is no part of the frame that comes.
    pub fn nothing_to_show(&mut self) {
        self.spent_on(Part::Input);
        let _ = self.closed();
    }

    /// The account of what came since the last, which is told of where it is worth it.
    fn closed(&mut self) -> Frame {
        let frame = std::mem::take(&mut self.frame);
        if frame.is_worth_telling() {
            tracing::debug!("{}", frame.told());
        }
        #[cfg(test)]
        self.waited.push((frame.undrawn().blocked, frame.told()));
        frame
    }

    /// A frame has been shown.
    pub fn shown(&mut self) {
        let Some(since) = self.since else { return };
        let frame = self.closed();
        self.walls.push(frame.wall());
        self.undrawn.push(frame.undrawn());
        let told = *self.told.get_or_insert(since.at());
        if since.at().saturating_duration_since(told) >= TOLD_EVERY {
            self.told = Some(since.at());
            tracing::debug!("{}", self.summary());
            self.walls.clear();
            self.undrawn.clear();
        }
    }

    fn summary(&self) -> String {
        let by = |of: fn(&Spent) -> Duration| spread(self.undrawn.iter().map(of).collect());
        format!(
            "{} frames: {}; besides drawing {}, starved {}, waited {}",
            self.walls.len(),
            spread(self.walls.clone()),
            by(|spent| spent.wall),
            by(|spent| spent.starved),
            by(|spent| spent.blocked),
        )
    }
}

/// Median, 99.9 of 100, and the longest.
fn spread(mut times: Vec<Duration>) -> String {
    times.sort();
    let rank = |share| ms(nearest_rank(&times, share).unwrap_or_default());
    format!(
        "{:.1} / {:.1} / {:.1} ms",
        rank(0.5),
        rank(0.999),
        rank(1.0)
    )
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn sleep_is_waiting_and_sums_are_work() {
        let mut waits = Waits::default();
        waits.since = Some(waits.clock.now());
        std::thread::sleep(Duration::from_millis(60));
        waits.spent_on(Part::Land);
        let began = Instant::now();
        while began.elapsed() < Duration::from_millis(60) {
            std::hint::black_box(began);
        }
        waits.spent_on(Part::Drawing);
        let [land, drawing] = [Part::Land, Part::Drawing].map(|part| waits.frame.0[part as usize]);
        assert!(land.blocked > Duration::from_millis(40), "{land:?}");
        // However many others want the processor: those take it, nobody waits.
        assert!(drawing.blocked < Duration::from_millis(20), "{drawing:?}");
        assert_eq!(waits.frame.undrawn(), land);
        assert!(waits.frame.is_worth_telling());
    }

    #[test]
    fn rest_counts_for_nothing_and_a_frame_takes_what_came_before_it() {
        let mut waits = Waits::default();
        waits.spent_on(Part::Steps);
        waits.shown();
        assert!(waits.walls.is_empty());
        waits.since = Some(waits.clock.now());
        waits.rest();
        waits.spent_on(Part::Steps);
        assert_eq!(waits.frame.0[Part::Steps as usize], Spent::default());
        waits.since = Some(waits.clock.now());
        std::thread::sleep(Duration::from_millis(2));
        waits.nothing_to_show();
        waits.spent_on(Part::Steps);
        waits.shown();
        assert_eq!(waits.walls.len(), 1);
        assert!(waits.walls[0] < Duration::from_millis(2));
        assert_eq!(waits.frame.wall(), Duration::ZERO);
    }
}
