//! Timing of rivals against each other: interleaved in one run, the least of several medians.

use std::hint::black_box;
use std::time::Instant;

use crate::Effort;

/// Work that is timed as a whole.
pub type Batch<'a> = Box<dyn FnMut() + 'a>;

/// A batch that applies a formula to every input by itself. What goes in and what comes out is hidden from the
/// optimiser, so that no two inputs are worked on at once.
pub fn scalar<'a, I, O>(inputs: &'a [I], formula: impl Fn(&I) -> O + 'a) -> Batch<'a> {
    Box::new(move || {
        for input in inputs {
            black_box(formula(black_box(input)));
        }
    })
}

/// Nanoseconds per item of each rival, each of which handles `items` a run. In every round all rivals take turns,
/// so that what else the machine does strikes all alike; a round's figure is the median, the result the least of
/// the rounds.
pub fn race(rivals: &mut [Batch<'_>], items: usize, effort: Effort) -> Vec<f64> {
    let (rounds, turns) = if effort.quick { (4, 5) } else { (10, 15) };
    let mut best = vec![f64::INFINITY; rivals.len()];
    for _ in 0..rounds {
        let mut times = vec![Vec::with_capacity(turns); rivals.len()];
        for _ in 0..turns {
            for (rival, own) in rivals.iter_mut().zip(&mut times) {
                let began = Instant::now();
                rival();
                own.push(began.elapsed().as_secs_f64());
            }
        }
        for (least, own) in best.iter_mut().zip(&mut times) {
            *least = least.min(median(own));
        }
    }
    best.iter().map(|s| s * 1e9 / items as f64).collect()
}

/// The middle value; infinite where there is none.
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values
        .get(values.len() / 2)
        .copied()
        .unwrap_or(f64::INFINITY)
}

/// Seconds that all threads of this program have been at work, where the system tells: on a software adapter that is
/// what a frame costs, whatever else the machine does meanwhile.
pub fn worked_s() -> Option<f64> {
    antipode_timing::program_ran().map(|time| time.as_secs_f64())
}
