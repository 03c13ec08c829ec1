//! Frames a second for the display.

use std::time::{Duration, Instant};

/// Longest time that a frame takes, seconds; what is longer is a rest.
const LONGEST_S: f64 = 2.0;

/// Frames a second, smoothed over about half a second.
#[derive(Debug, Default)]
pub struct FrameRate {
    last: Option<Instant>,
    mean_s: f64,
}

impl FrameRate {
    /// A frame was shown.
    pub fn shown(&mut self, now: Instant) {
        if let Some(last) = self.last.replace(now) {
            self.frame(now.saturating_duration_since(last));
        }
    }

    fn frame(&mut self, passed: Duration) {
        let passed = passed.as_secs_f64();
        // Nothing was drawn meanwhile: the picture stood still, or the machine slept.
        if passed <= 0.0 || passed > LONGEST_S {
            return;
        }
        let share = (passed / 0.5).clamp(0.02, 1.0);
        self.mean_s = if self.mean_s == 0.0 {
            passed
        } else {
            self.mean_s + (passed - self.mean_s) * share
        };
    }

    /// Frames a second; 0 before the second frame.
    pub fn value(&self) -> f32 {
        if self.mean_s > 0.0 {
            (1.0 / self.mean_s) as f32
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_frames_give_their_rate_and_a_slow_second_shows_at_once() {
        let mut rate = FrameRate::default();
        assert_eq!(rate.value(), 0.0);
        let mut now = Instant::now();
        for _ in 0..100 {
            rate.shown(now);
            now += Duration::from_millis(20);
        }
        assert!((rate.value() - 50.0).abs() < 0.5);
        rate.shown(now + Duration::from_secs(1));
        assert!(rate.value() < 1.5);
    }
}
