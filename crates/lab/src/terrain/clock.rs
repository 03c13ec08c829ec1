//! The clocks of the terrain suites: rivals raced for their least times, what a thread did itself while others ran
//! beside it, and the spread of many times.

use std::time::{Duration, Instant};

use antipode_timing::{ThreadAccount, nearest_rank, program_ran, thread_ran};

use crate::Effort;

/// Rounds that every rival runs at least.
const LEAST_ROUNDS: usize = 5;

/// One way to do some work.
pub struct Rival<'a> {
    /// Its name in tables.
    pub name: &'static str,
    /// Items that one run handles.
    pub items: usize,
    /// One run; returns how many things it made, if it counts them.
    pub work: Box<dyn FnMut() -> usize + 'a>,
}

impl<'a> Rival<'a> {
    /// A rival that handles `items` in a run; what it makes is hidden from the optimiser.
    pub fn new<T>(name: &'static str, items: usize, mut work: impl FnMut() -> T + 'a) -> Self {
        Self::counting(name, items, move || {
            std::hint::black_box(work());
            0
        })
    }

    /// A rival that tells how many things it made.
    pub fn counting(name: &'static str, items: usize, work: impl FnMut() -> usize + 'a) -> Self {
        Self {
            name,
            items,
            work: Box::new(work),
        }
    }
}

/// Least nanoseconds per item of each rival. They take turns, so that whatever else the machine does strikes all
/// alike, and the least of many short runs is the one that nothing struck. Time is the thread's on the processor,
/// where the system tells: a long run is interrupted by others more often than a short one, and would seem slower.
pub fn race(rivals: &mut [Rival<'_>], effort: Effort) -> Vec<f64> {
    let clock = ThreadClock::new();
    let limit = Duration::from_millis(if effort.quick { 500 } else { 2500 });
    let mut best = vec![f64::INFINITY; rivals.len()];
    let began = Instant::now();
    let mut rounds = 0;
    while rounds < LEAST_ROUNDS || began.elapsed() < limit {
        for (rival, least) in rivals.iter_mut().zip(&mut best) {
            let then = clock.now();
            std::hint::black_box((rival.work)());
            *least = least.min(clock.since(then).cpu_ms * 1e6 / rival.items as f64);
        }
        rounds += 1;
    }
    best
}

/// Least milliseconds of one piece of work.
pub fn least_ms<T>(effort: Effort, work: impl FnMut() -> T) -> f64 {
    race(&mut [Rival::new("", 1, work)], effort)[0] * 1e-6
}

/// Percentiles by nearest rank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The middle.
    pub p50: f64,
    /// 99 of 100 are at most this.
    pub p99: f64,
    /// The greatest.
    pub max: f64,
}

impl Spread {
    /// Of some values; infinite where there are none.
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let rank = |share| nearest_rank(&sorted, share).unwrap_or(f64::INFINITY);
        Self {
            p50: rank(0.5),
            p99: rank(0.99),
            max: rank(1.0),
        }
    }
}

/// What a piece of a thread's work took, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[expect(clippy::struct_field_names, reason = "units stand in names")]
pub struct Spent {
    /// By the wall clock.
    pub wall_ms: f64,
    /// By the wall clock without the time in which the thread was ready but another had the core: what it would have
    /// taken on a machine of its own. Waiting for locks or the disk counts.
    pub own_ms: f64,
    /// Time on the processor.
    pub cpu_ms: f64,
}

/// A thread's clocks at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    wall: Instant,
    ran: Option<Duration>,
    queued: Option<Duration>,
}

/// The clocks of the thread that made it.
#[derive(Debug)]
pub struct ThreadClock {
    account: ThreadAccount,
}

impl ThreadClock {
    /// Of this thread.
    pub fn new() -> Self {
        Self {
            account: ThreadAccount::of_this_thread(),
        }
    }

    /// Now.
    pub fn now(&self) -> Moment {
        // The wall clock is read last here and first in `since`, so that the reading itself is not measured.
        let (ran, queued) = (thread_ran(), self.account.queued());
        Moment {
            wall: Instant::now(),
            ran,
            queued,
        }
    }

    /// What has been spent since then.
    pub fn since(&self, then: Moment) -> Spent {
        let wall_ms = ms(then.wall.elapsed());
        let between =
            |now: Option<Duration>, then: Option<Duration>| Some(ms(now?.saturating_sub(then?)));
        let cpu_ms = between(thread_ran(), then.ran).unwrap_or(wall_ms);
        let queued_ms = between(self.account.queued(), then.queued).unwrap_or(0.0);
        Spent {
            wall_ms,
            own_ms: (wall_ms - queued_ms).max(0.0),
            cpu_ms: cpu_ms.min(wall_ms),
        }
    }
}

/// Processor time of all threads of the program so far, milliseconds, where the system tells.
pub fn program_ms() -> Option<f64> {
    program_ran().map(ms)
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_by_nearest_rank() {
        let values: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        let spread = Spread::of(&values);
        assert_eq!((spread.p50, spread.p99, spread.max), (100.0, 198.0, 200.0));
        assert_eq!(Spread::of(&[]).max, f64::INFINITY);
    }

    #[test]
    fn sleep_is_nobodys_work_but_counts_as_the_threads_own_time() {
        let clock = ThreadClock::new();
        let then = clock.now();
        std::thread::sleep(Duration::from_millis(20));
        let spent = clock.since(then);
        assert!(spent.wall_ms >= 20.0 && spent.own_ms <= spent.wall_ms);
        if cfg!(target_os = "linux") {
            assert!(spent.cpu_ms < spent.wall_ms, "{spent:?}");
        }
    }
}
