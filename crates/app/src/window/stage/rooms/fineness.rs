//! How many pixels of a room are traced in a frame, from how long frames took.

use std::time::{Duration, Instant};

/// How long frames are to take where not all pixels can be traced in less.
const BEARABLE: Duration = Duration::from_millis(45);
/// Frames that take this much less or more are left as they are, as a factor.
const NEAR: f32 = 1.4;
/// A frame that took longer than this was held up by something else as well.
const LONGEST: Duration = Duration::from_secs(1);
/// Frames that are begun already when the number of pixels changes, and tell nothing of the new one.
const BEGUN: u32 = 2;
/// Frames of which one is judged, unless it is far off.
const JUDGED: u32 = 4;
/// Greatest change at once.
const STEP: (f32, f32) = (0.5, 1.2);
/// Least share of the window's pixels along each side.
const LEAST_SHARE: f32 = 0.125;

/// How many of the window's pixels are traced: as many as frames of a bearable length allow.
#[derive(Debug)]
pub struct Fineness {
    share: f32,
    last: Option<Instant>,
    /// Frames since the last change.
    frames: u32,
    /// What those took that count.
    spent: Duration,
}

impl Default for Fineness {
    fn default() -> Self {
        Self {
            share: 0.25,
            last: None,
            frames: 0,
            spent: Duration::ZERO,
        }
    }
}

impl Fineness {
    /// The share of the window's pixels along each side, at most `most`, for a frame that begins now.
    pub fn share(&mut self, most: f32, now: Instant) -> f32 {
        if let Some(last) = self.last.replace(now) {
            self.note(now.saturating_duration_since(last), most);
        }
        self.share.min(most)
    }

    /// Nothing is traced in this frame, which tells nothing.
    pub fn rest(&mut self) {
        (self.last, self.frames, self.spent) = (None, 0, Duration::ZERO);
    }

    fn note(&mut self, passed: Duration, most: f32) {
        self.frames += 1;
        if self.frames <= BEGUN {
            return;
        }
        self.spent += passed.min(LONGEST);
        let each = self.spent / (self.frames - BEGUN);
        // Time goes by the number of pixels, which is the share squared.
        let change = (BEARABLE.as_secs_f32() / each.as_secs_f32().max(1e-3)).sqrt();
        let is_near = (1.0 / NEAR..NEAR).contains(&(change * change));
        if self.frames < BEGUN + JUDGED && change > STEP.0 {
            return;
        }
        (self.frames, self.spent) = (BEGUN, Duration::ZERO);
        let wanted = self.share.min(most) * change.clamp(STEP.0, STEP.1);
        let wanted = wanted.clamp(LEAST_SHARE.min(most), most);
        if !is_near && wanted != self.share {
            (self.share, self.frames) = (wanted, 0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share after a while of frames that take so long for each whole window of pixels.
    fn settled(whole: Duration, most: f32) -> f32 {
        let (mut fineness, mut now) = (Fineness::default(), Instant::now());
        for _ in 0..300 {
            let share = fineness.share(most, now);
            now += whole.mul_f32(share * share) + Duration::from_millis(5);
        }
        fineness.share(most, now)
    }

    #[test]
    fn a_slow_adapter_traces_fewer_pixels_and_a_fast_one_all() {
        assert_eq!(settled(Duration::from_millis(10), 1.0), 1.0);
        assert_eq!(settled(Duration::from_millis(10), 0.5), 0.5);
        let share = settled(Duration::from_secs(1), 1.0);
        assert!((0.17..0.26).contains(&share), "{share}");
        assert_eq!(settled(Duration::from_mins(1), 1.0), LEAST_SHARE);
    }

    #[test]
    fn a_frame_that_was_held_up_is_soon_forgotten() {
        let (mut fineness, mut now) = (Fineness::default(), Instant::now());
        let mut shares = Vec::new();
        for frame in 0..120 {
            shares.push(fineness.share(1.0, now));
            let held_up = u64::from(frame == 60) * 3600;
            now += Duration::from_secs(held_up) + Duration::from_millis(10);
        }
        assert_eq!(shares[60], 1.0);
        assert!(shares[61..].iter().all(|share| *share >= 0.5));
        assert_eq!(shares[119], 1.0);
    }
}
