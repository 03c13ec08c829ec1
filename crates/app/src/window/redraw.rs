//! Decides whether a frame is drawn: a picture that stands still is not drawn again.

use std::time::{Duration, Instant};

/// How long frames are drawn after something has happened: what it sets going shows within this.
const LINGER: Duration = Duration::from_millis(250);
/// From one look at a game that is not drawn to the next: pads are asked, and what threads have done is taken over.
pub const REST: Duration = Duration::from_millis(25);

/// When frames are to be drawn.
#[derive(Debug)]
pub struct Redraw {
    /// Every frame until then.
    until: Instant,
    /// Once at that time, for the interface.
    at: Option<Instant>,
}

impl Redraw {
    /// Something happens now.
    pub fn new(now: Instant) -> Self {
        Self {
            until: now + LINGER,
            at: None,
        }
    }

    /// Something has happened that may be seen.
    pub fn touch(&mut self, now: Instant) {
        self.until = self.until.max(now + LINGER);
    }

    /// Whether to draw a frame now.
    pub fn is_due(&self, now: Instant) -> bool {
        now < self.until || self.at.is_some_and(|at| at <= now)
    }

    /// A frame was drawn, and the interface wants another one after `wait`: an animation, a message that goes.
    pub fn drawn(&mut self, now: Instant, wait: Duration) {
        self.at = now.checked_add(wait);
    }

    /// When to look next, at the latest, if nothing is drawn now.
    pub fn next_look(&self, now: Instant) -> Instant {
        let rest = now + REST;
        self.at.map_or(rest, |at| at.clamp(now, rest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_still_is_drawn_for_a_moment_and_then_no_more() {
        let start = Instant::now();
        let at = |ms| start + Duration::from_millis(ms);
        let mut redraw = Redraw::new(start);
        assert!(redraw.is_due(at(0)) && redraw.is_due(at(200)));
        redraw.drawn(at(200), Duration::MAX);
        assert!(!redraw.is_due(at(300)) && !redraw.is_due(at(100_000)));
        redraw.touch(at(100_000));
        assert!(redraw.is_due(at(100_100)));
    }

    #[test]
    fn what_changes_at_a_time_is_drawn_at_that_time() {
        let start = Instant::now();
        let at = |ms| start + Duration::from_millis(ms);
        let mut redraw = Redraw::new(start);
        redraw.drawn(at(400), Duration::from_millis(500));
        assert!(!redraw.is_due(at(899)) && redraw.is_due(at(900)));
        assert_eq!(redraw.next_look(at(895)), at(900));
        assert_eq!(redraw.next_look(at(500)), at(525));
        redraw.drawn(at(900), Duration::from_millis(500));
        assert!(!redraw.is_due(at(901)));
    }
}
