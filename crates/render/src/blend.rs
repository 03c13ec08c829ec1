//! The short blend from one level of a chunk to another: how far it is, by the scene's own time.

/// A blend takes this long, seconds.
const BLEND_S: f32 = 0.25;
/// Frames after which a scene whose time has not moved is taken to stand still; a screen may show several frames
/// for a step of the scene.
const STILL_FRAMES: u32 = 16;

/// The scene's time, and whether it moves. A picture of a scene that stands still shows what blends lead to.
#[derive(Clone, Copy, Debug)]
pub struct BlendClock {
    time_s: f32,
    frames_since: u32,
}

impl Default for BlendClock {
    fn default() -> Self {
        Self {
            time_s: 0.0,
            frames_since: STILL_FRAMES,
        }
    }
}

impl BlendClock {
    /// Takes note of a frame's time.
    pub fn advance(&mut self, time_s: f32) {
        if self.time_s == time_s {
            self.frames_since = self.frames_since.saturating_add(1);
        } else {
            *self = Self {
                time_s,
                frames_since: 0,
            };
        }
    }

    /// Lets the next frames be taken for a scene that stands still, until its time moves.
    pub fn stop(&mut self) {
        self.frames_since = STILL_FRAMES;
    }

    /// Whether anything blends at all.
    pub fn moves(self) -> bool {
        self.frames_since < STILL_FRAMES
    }

    /// The time, seconds.
    pub fn now_s(self) -> f32 {
        self.time_s
    }

    /// How much of a blend that began at `began_s` is done, above 0 and below 1; `None` when all of it is.
    pub fn progress(self, began_s: f32) -> Option<f32> {
        let done = (self.time_s - began_s) / BLEND_S;
        // A fresh blend shows a little of what is new already.
        ((0.0..1.0).contains(&done) && self.moves()).then(|| done.max(1.0 / 32.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blend_goes_by_the_scenes_time_and_is_done_when_that_stands_still_or_goes_back() {
        let mut clock = BlendClock::default();
        assert!(!clock.moves());
        clock.advance(7.0);
        assert!(clock.moves());
        assert_eq!(clock.progress(7.0), Some(1.0 / 32.0));
        clock.advance(7.125);
        assert_eq!(clock.progress(7.0), Some(0.5));
        for _ in 0..STILL_FRAMES - 1 {
            clock.advance(7.125);
        }
        assert_eq!(clock.progress(7.0), Some(0.5));
        clock.advance(7.125);
        assert_eq!(clock.progress(7.0), None);
        clock.advance(7.2);
        assert!(clock.progress(7.0).is_some());
        clock.stop();
        assert_eq!(clock.progress(7.0), None);
        clock.advance(7.25);
        assert_eq!(clock.progress(7.0), None);
        clock.advance(6.5);
        assert_eq!(clock.progress(7.0), None);
    }
}
