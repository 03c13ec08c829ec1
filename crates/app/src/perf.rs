//! Times of frames and steps, and their percentiles.

use antipode_timing::nearest_rank;
use serde::Serialize;
use std::time::Duration;

/// Percentiles of a row of times, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Percentiles {
    /// Median.
    pub p50: f64,
    /// 95 of 100 are at most this.
    pub p95: f64,
    /// 99 of 100 are at most this.
    pub p99: f64,
    /// The longest.
    pub max: f64,
}

/// A row of times.
#[derive(Clone, Debug, Default)]
pub struct Times {
    ms: Vec<f64>,
}

impl Times {
    /// Adds a time.
    pub fn push(&mut self, time: Duration) {
        self.ms.push(time.as_secs_f64() * 1000.0);
    }

    /// Adds a time in milliseconds.
    pub fn push_ms(&mut self, ms: f64) {
        self.ms.push(ms);
    }

    /// Percentiles by nearest rank; none of an empty row.
    pub fn percentiles(&self) -> Option<Percentiles> {
        let mut sorted = self.ms.clone();
        sorted.sort_by(f64::total_cmp);
        let rank = |share| nearest_rank(&sorted, share);
        Some(Percentiles {
            p50: rank(0.5)?,
            p95: rank(0.95)?,
            p99: rank(0.99)?,
            max: *sorted.last()?,
        })
    }
}

/// What `perf` prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Whole frames; null where nothing was drawn.
    pub frame_ms: Option<Percentiles>,
    /// Simulation steps, main thread.
    pub step_ms: Option<Percentiles>,
    /// The main thread's share of a frame: the step, taking finished chunks in, and recording what to draw.
    pub main_ms: Option<Percentiles>,
    /// The adapter's own time; null where it cannot tell.
    pub gpu_ms: Option<Percentiles>,
    /// What the script waited for so that it can be repeated exactly.
    pub wait_ms: Option<Percentiles>,
    /// Triangles drawn in the last frame.
    pub triangles: u64,
    /// Draw calls of the last frame.
    pub draws: u64,
    /// From a stroke to its mesh; null when nothing was edited.
    pub edit_latency_ms: Option<Percentiles>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_by_nearest_rank() {
        let mut times = Times::default();
        for ms in (1..=100).rev() {
            times.push_ms(f64::from(ms));
        }
        let p = times.percentiles();
        assert_eq!(
            p,
            Some(Percentiles {
                p50: 50.0,
                p95: 95.0,
                p99: 99.0,
                max: 100.0
            })
        );
    }

    #[test]
    fn an_empty_row_has_none_and_a_single_time_is_all_of_them() {
        assert_eq!(Times::default().percentiles(), None);
        let mut times = Times::default();
        times.push(Duration::from_millis(7));
        assert_eq!(
            times.percentiles().map(|p| (p.p50, p.max)),
            Some((7.0, 7.0))
        );
    }
}
