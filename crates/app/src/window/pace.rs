//! Decides how many steps of the world a frame takes, and drops the time that is too much.

use std::time::Duration;

use antipode_scene::tuning::STEP_S;

/// Most steps simulated for one frame; time beyond them is dropped, so a slow moment never snowballs.
const MOST_STEPS: u32 = 6;
/// After a frame that took longer than this the machine was asleep, or somebody looked at the game in a debugger: no
/// time of the world has passed.
const ASLEEP: Duration = Duration::from_secs(5);
/// Time from one word about dropped time to the next, seconds.
const TOLD_EVERY_S: f64 = 30.0;

/// The world's time against the wall's.
#[expect(clippy::struct_field_names, reason = "all of them are seconds")]
#[derive(Debug, Default)]
pub struct Pace {
    owed_s: f64,
    dropped_s: f64,
    /// Of that, what has been told of.
    told_s: f64,
    since_told_s: f64,
}

impl Pace {
    /// So much time has passed while playing; how many steps the world takes for it.
    pub fn steps(&mut self, passed: Duration) -> u32 {
        if passed > ASLEEP {
            return 0;
        }
        self.owed_s += passed.as_secs_f64();
        let mut steps = 0;
        while self.owed_s >= STEP_S && steps < MOST_STEPS {
            self.owed_s -= STEP_S;
            steps += 1;
        }
        let kept_s = self.owed_s.min(STEP_S);
        self.dropped_s += self.owed_s - kept_s;
        self.owed_s = kept_s;
        self.since_told_s += passed.as_secs_f64();
        steps
    }

    /// The same, and how many seconds pictures go on by, which show a moment between two steps.
    pub fn go_on(&mut self, passed: Duration) -> (u32, f64) {
        let share = self.share();
        let steps = self.steps(passed);
        (steps, (f64::from(steps) + self.share() - share) * STEP_S)
    }

    /// A world begins; what another was owed is owed no more.
    pub fn rest(&mut self) {
        self.owed_s = 0.0;
    }

    /// How much of the next step's time has passed, 0 to 1: so far is the picture on its way through the last one.
    pub fn share(&self) -> f64 {
        (self.owed_s / STEP_S).min(1.0)
    }

    /// Time of the world that was left out so far, in seconds.
    pub fn dropped_s(&self) -> f64 {
        self.dropped_s
    }

    /// Time that was dropped since the last word about it, in seconds; now and then, and only if it can be noticed.
    pub fn take_news(&mut self) -> Option<f64> {
        let new_s = self.dropped_s - self.told_s;
        if new_s < 0.1 || (self.told_s > 0.0 && self.since_told_s < TOLD_EVERY_S) {
            return None;
        }
        self.told_s = self.dropped_s;
        self.since_told_s = 0.0;
        Some(new_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn a_slow_frame_takes_six_steps_and_the_rest_is_dropped_and_told() {
        let mut pace = Pace::default();
        assert_eq!(pace.steps(ms(50)), 3);
        assert_eq!((pace.dropped_s(), pace.take_news()), (0.0, None));
        pace.rest();
        assert_eq!(pace.steps(ms(1000)), 6);
        // A step is kept for the next frame.
        assert!((pace.dropped_s() - (1.0 - 7.0 / 60.0)).abs() < 1e-9);
        assert_eq!(pace.take_news(), Some(pace.dropped_s()));
        assert_eq!(pace.steps(ms(0)), 1);
        assert_eq!(pace.steps(ms(0)), 0);
    }

    #[test]
    fn at_an_even_pace_nothing_is_dropped() {
        let mut pace = Pace::default();
        let steps: u32 = (0..600)
            .map(|_| pace.steps(Duration::from_nanos(16_666_667)))
            .sum();
        assert!((599..=600).contains(&steps), "{steps}");
        assert_eq!(pace.dropped_s(), 0.0);
    }

    #[test]
    fn words_about_dropped_time_come_now_and_then() {
        let mut pace = Pace::default();
        let told = (0..630).filter(|_| {
            pace.steps(ms(200));
            pace.take_news().is_some()
        });
        // Two minutes and a little of frames that are twice too slow.
        assert_eq!(told.count(), 5);
    }

    #[test]
    fn hours_of_sleep_are_no_time_of_the_world_and_nothing_is_dropped() {
        let mut pace = Pace::default();
        pace.steps(ms(10));
        assert_eq!(pace.steps(Duration::from_hours(9)), 0);
        assert_eq!(pace.steps(ms(17)), 1);
        assert_eq!(pace.dropped_s(), 0.0);
    }
}
