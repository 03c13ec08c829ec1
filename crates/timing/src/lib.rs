//! Measures the time of threads and the memory of the program, and finds percentiles of many times.
//!
//! Only Linux reports these numbers (`/proc/thread-self` and `/proc/self`, see proc_pid_schedstat(5) and
//! proc_pid_status(5)). On other systems every answer is `None`.

use std::time::Duration;

/// What the system has on account of one thread.
#[derive(Debug)]
pub struct ThreadAccount(imp::Files);

impl ThreadAccount {
    /// Of the thread that asks for it, which alone may use it.
    pub fn of_this_thread() -> Self {
        Self(imp::Files::open())
    }

    /// So long the thread was ready while others had the processor.
    pub fn queued(&self) -> Option<Duration> {
        self.0.queued()
    }

    /// How often the thread gave the processor away itself, to wait for something.
    pub fn waits(&self) -> Option<u64> {
        self.0.waits()
    }
}

/// So long this thread has been on the processor.
pub fn thread_ran() -> Option<Duration> {
    imp::thread_ran()
}

/// So long all threads of the program together have been on a processor.
pub fn program_ran() -> Option<Duration> {
    imp::program_ran()
}

/// Memory that the program holds resident, in MB of 10^6 bytes.
pub fn resident_mb() -> Option<f64> {
    imp::resident_mb()
}

/// The value that a share of all is at most, by nearest rank; the values are in rising order.
pub fn nearest_rank<T: Copy>(sorted: &[T], share: f64) -> Option<T> {
    let place = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(place.saturating_sub(1)).copied()
}

#[cfg(target_os = "linux")]
mod imp {
    use std::fs::File;
    use std::os::unix::fs::FileExt;
    use std::time::Duration;

    use rustix::time::{ClockId, clock_gettime};

    /// Kept open, since they are read many times a frame.
    #[derive(Debug)]
    pub(super) struct Files {
        schedstat: Option<File>,
        status: Option<File>,
    }

    impl Files {
        pub(super) fn open() -> Self {
            let open = |name| File::open(format!("/proc/thread-self/{name}")).ok();
            Self {
                schedstat: open("schedstat"),
                status: open("status"),
            }
        }

        /// The second number of the line. The first, the time on the processor, is as old as the last tick of the
        /// system's clock.
        pub(super) fn queued(&self) -> Option<Duration> {
            let line = read::<64>(self.schedstat.as_ref()?)?;
            let nanoseconds = line.split_whitespace().nth(1)?.parse().ok()?;
            Some(Duration::from_nanos(nanoseconds))
        }

        pub(super) fn waits(&self) -> Option<u64> {
            let status = read::<4096>(self.status.as_ref()?)?;
            let mut lines = status.lines();
            let waits = lines.find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"))?;
            waits.trim().parse().ok()
        }
    }

    /// What the system writes there now, up to so many bytes.
    fn read<const BYTES: usize>(file: &File) -> Option<String> {
        let mut text = [0; BYTES];
        let length = file.read_at(&mut text, 0).ok()?;
        String::from_utf8(text[..length].to_vec()).ok()
    }

    pub(super) fn thread_ran() -> Option<Duration> {
        ran(ClockId::ThreadCPUTime)
    }

    pub(super) fn program_ran() -> Option<Duration> {
        ran(ClockId::ProcessCPUTime)
    }

    pub(super) fn resident_mb() -> Option<f64> {
        let text = std::fs::read_to_string("/proc/self/status").ok()?;
        let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
        let kib: f64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
        Some(kib * 1024.0 / 1e6)
    }

    #[expect(clippy::unnecessary_wraps, reason = "other systems do not tell")]
    fn ran(clock: ClockId) -> Option<Duration> {
        let time = clock_gettime(clock);
        Some(Duration::new(time.tv_sec as u64, time.tv_nsec as u32))
    }
}

#[cfg(not(target_os = "linux"))]
mod imp {
    use std::time::Duration;

    #[derive(Debug)]
    pub(super) struct Files;

    impl Files {
        pub(super) fn open() -> Self {
            Self
        }

        pub(super) fn queued(&self) -> Option<Duration> {
            None
        }

        pub(super) fn waits(&self) -> Option<u64> {
            None
        }
    }

    pub(super) fn thread_ran() -> Option<Duration> {
        None
    }

    pub(super) fn program_ran() -> Option<Duration> {
        None
    }

    pub(super) fn resident_mb() -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_are_the_nearest() {
        let values: Vec<u32> = (1..=200).collect();
        let ranks = [0.0, 0.5, 0.99, 1.0].map(|share| nearest_rank(&values, share));
        assert_eq!(ranks, [1, 100, 198, 200].map(Some));
        assert_eq!(nearest_rank::<u32>(&[], 0.5), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn memory_that_is_taken_is_resident() {
        let before_mb = resident_mb().unwrap_or(f64::NAN);
        let taken = std::hint::black_box(vec![1_u8; 64_000_000]);
        let more_mb = resident_mb().unwrap_or(f64::NAN) - before_mb;
        assert!(more_mb > 60.0 && taken.len() == 64_000_000, "{more_mb} MB");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_thread_that_waits_once_is_told_to_have_waited() {
        let account = ThreadAccount::of_this_thread();
        let (waits, ran) = (account.waits(), thread_ran());
        std::thread::sleep(Duration::from_millis(1));
        assert!(account.waits() > waits && thread_ran() > ran);
        let ran = thread_ran();
        assert!(account.queued().is_some() && program_ran() >= ran);
    }
}
