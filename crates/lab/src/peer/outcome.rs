//! How far a run got before its error passed the tolerance, and the median of many runs.

/// How far one run got.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// It first failed here: tiles, radii or steps, as the test has it.
    Failed(u32),
    /// It did not fail up to here, the farthest that was tried.
    Held(u32),
}

impl Outcome {
    /// The first of the sizes that does not pass, or the last one if all do.
    pub fn first(sizes: impl Iterator<Item = u32>, mut passes: impl FnMut(u32) -> bool) -> Self {
        let mut last = 0;
        for size in sizes {
            if !passes(size) {
                return Self::Failed(size);
            }
            last = size;
        }
        Self::Held(last)
    }

    /// Failing later is better, and not failing best.
    fn rank(self) -> (bool, u32) {
        match self {
            Self::Failed(at) => (false, at),
            Self::Held(to) => (true, to),
        }
    }

    /// The size itself.
    pub fn reached(self) -> u32 {
        self.rank().1
    }

    /// Whether this is as good as another: later, or never.
    pub fn at_least(self, other: Self) -> bool {
        self.rank() >= other.rank()
    }

    /// The lower median, so that one of the runs reached it.
    pub fn median(mut runs: Vec<Self>) -> Option<Self> {
        runs.sort_by_key(|run| run.rank());
        runs.get(runs.len().saturating_sub(1) / 2).copied()
    }
}

/// Whether an error is within a tolerance. One that is not a number is not.
pub fn within(error: f64, tolerance: f64) -> bool {
    error.abs() < tolerance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_is_a_failure() {
        assert!(within(-0.05, 0.1) && !within(0.2, 0.1));
        assert!(!within(f64::NAN, 0.1) && !within(f64::INFINITY, 0.1));
        let run = Outcome::first(1..10, |size| {
            within(if size < 4 { 0.0 } else { f64::NAN }, 0.1)
        });
        assert_eq!(run, Outcome::Failed(4));
    }

    #[test]
    fn a_run_that_holds_ranks_above_one_that_fails_later() {
        let runs = vec![Outcome::Held(9), Outcome::Failed(30), Outcome::Failed(2)];
        assert_eq!(Outcome::median(runs), Some(Outcome::Failed(30)));
        assert!(Outcome::Held(9).at_least(Outcome::Failed(30)));
        assert_eq!(Outcome::median(Vec::new()), None);
    }
}
