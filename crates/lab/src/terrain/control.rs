//! A control for the flight's frames: the same piece of arithmetic after every frame, timed by the same clock. It
//! reads no memory, takes no lock and allocates nothing, so whatever makes one run of it longer than another is the
//! machine's.

use std::hint::black_box;

use super::clock::{Spent, ThreadClock};

/// Frames that the piece's length is taken from.
const LEARNT_FROM: usize = 60;
/// Steps of a trial, some tens of microseconds, and trials, of which the shortest counts.
const TRIAL: (u32, usize) = (20_000, 20);

/// A piece of arithmetic that lasts as long as the middle one of the first frames.
#[derive(Debug, Default)]
pub struct Control {
    /// What the first frames took, milliseconds.
    frames_ms: Vec<f64>,
    steps: Option<u32>,
}

impl Control {
    /// Runs the piece once after a frame of `frame_ms`; nothing as long as its length is being found.
    pub fn run(&mut self, clock: &ThreadClock, frame_ms: f64) -> Option<Spent> {
        if let Some(steps) = self.steps {
            return Some(timed(clock, steps));
        }
        self.frames_ms.push(frame_ms);
        if self.frames_ms.len() == LEARNT_FROM {
            self.frames_ms.sort_by(f64::total_cmp);
            let (steps, trials) = TRIAL;
            // By the processor: of so short a time others may seem to have had the whole.
            let trials = (0..trials).map(|_| timed(clock, steps).cpu_ms);
            let trial_ms = trials.fold(f64::INFINITY, f64::min);
            let share = self.frames_ms[LEARNT_FROM / 2] / trial_ms;
            // The cast saturates.
            self.steps = Some((share * f64::from(steps)) as u32);
        }
        None
    }
}

fn timed(clock: &ThreadClock, steps: u32) -> Spent {
    let then = clock.now();
    black_box(arithmetic(black_box(steps)));
    clock.since(then)
}

/// So many steps of a linear congruential generator (Knuth's MMIX constants), each waiting for the one before.
fn arithmetic(steps: u32) -> u64 {
    (0..steps).fold(1, |state: u64, _| {
        state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longer_frames_make_a_longer_piece_and_the_first_frames_none() {
        let clock = ThreadClock::new();
        let steps = |frame_ms: f64| {
            let mut control = Control::default();
            for _ in 0..LEARNT_FROM {
                assert!(control.run(&clock, frame_ms).is_none());
            }
            assert!(
                control.run(&clock, 1e9).is_some(),
                "what comes later changes nothing"
            );
            control.steps
        };
        // Whatever the machine does meanwhile, it is not a hundred times slower in one than in the other.
        assert!(steps(0.001) < steps(1.0));
    }
}
