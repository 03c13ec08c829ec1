//! The clocks of one thread.

use std::time::{Duration, Instant};

use super::Spent;

/// Most times that the clocks are looked at again for one moment.
#[cfg(target_os = "linux")]
const MOST_LOOKS: usize = 3;

/// A moment of a thread.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    wall: Instant,
    /// None where the system does not tell.
    account: Option<Account>,
}

/// What the system has on account of a thread.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    not(target_os = "linux"),
    allow(dead_code, reason = "only Linux tells")
)]
struct Account {
    /// On the processor.
    ran: Duration,
    /// Ready, while others were on it.
    starved: Duration,
    /// How often the thread gave the processor away itself, to wait for something.
    waits: u64,
}

impl Moment {
    /// By the wall clock.
    pub fn at(&self) -> Instant {
        self.wall
    }

    /// What became of the time since an earlier moment of the same thread.
    pub fn since(&self, then: &Self) -> Spent {
        let wall = self.wall.saturating_duration_since(then.wall);
        let (Some(now), Some(then)) = (self.account, then.account) else {
            return Spent {
                wall,
                ..Spent::default()
            };
        };
        let idle = wall.saturating_sub(now.ran.saturating_sub(then.ran));
        let starved = if now.waits == then.waits {
            // A virtual machine that is not let run itself is on no account.
            idle
        } else {
            now.starved.saturating_sub(then.starved).min(idle)
        };
        let blocked = idle.saturating_sub(starved);
        Spent {
            wall,
            starved,
            blocked,
        }
    }
}

/// The clocks of the thread that asks first.
#[derive(Debug, Default)]
pub struct Clock {
    #[cfg(target_os = "linux")]
    files: Option<(std::fs::File, std::fs::File)>,
}

impl Clock {
    /// The present moment.
    #[cfg(target_os = "linux")]
    pub fn now(&mut self) -> Moment {
        if self.files.is_none() {
            let open = |name| std::fs::File::open(format!("/proc/thread-self/{name}")).ok();
            self.files = open("schedstat").zip(open("status"));
        }
        let mut moment = self.look();
        for _ in 0..MOST_LOOKS {
            let queued = self.queued();
            let is_whole = moment.account.is_none_or(|it| Some(it.starved) == queued);
            if is_whole {
                break;
            }
            // The thread lost the processor meanwhile; the clocks do not tell of one moment.
            moment = self.look();
        }
        moment
    }

    #[cfg(target_os = "linux")]
    fn look(&self) -> Moment {
        let starved = self.queued();
        let account = starved.and_then(|starved| self.account(starved));
        Moment {
            wall: Instant::now(),
            account,
        }
    }

    /// So long the thread was ready while others had the processor. The first number of the line, the time on it, is as
    /// old as the last tick of the system's clock.
    #[cfg(target_os = "linux")]
    fn queued(&self) -> Option<Duration> {
        let line = read(&self.files.as_ref()?.0)?;
        let nanoseconds = line.split_whitespace().nth(1)?.parse().ok()?;
        Some(Duration::from_nanos(nanoseconds))
    }

    #[cfg(target_os = "linux")]
    fn account(&self, starved: Duration) -> Option<Account> {
        let status = read(&self.files.as_ref()?.1)?;
        let mut lines = status.lines();
        let waits = lines.find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"))?;
        let ran = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        Some(Account {
            ran: Duration::new(ran.tv_sec as u64, ran.tv_nsec as u32),
            starved,
            waits: waits.trim().parse().ok()?,
        })
    }

    /// The present moment; this system tells nothing of threads.
    #[cfg(not(target_os = "linux"))]
    #[allow(clippy::unused_self, reason = "elsewhere there are files to ask")]
    pub fn now(&mut self) -> Moment {
        Moment {
            wall: Instant::now(),
            account: None,
        }
    }
}

/// What the system writes there now.
#[cfg(target_os = "linux")]
fn read(file: &std::fs::File) -> Option<String> {
    use std::os::unix::fs::FileExt;

    let mut text = [0; 4096];
    let length = file.read_at(&mut text, 0).ok()?;
    String::from_utf8(text[..length].to_vec()).ok()
}
