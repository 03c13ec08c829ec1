//! The clocks of one thread.

use std::time::{Duration, Instant};

use super::Spent;

/// A moment of a thread.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    wall: Instant,
    /// None where the system does not tell.
    account: Option<Account>,
}

/// What the system has on account of a thread.
#[derive(Clone, Copy, Debug)]
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
        let ran = now.ran.saturating_sub(then.ran);
        let queued = now.starved.saturating_sub(then.starved);
        let rest = wall.saturating_sub(ran).saturating_sub(queued);
        // A virtual machine that is not let run itself is on no account; without a wait it can be nothing else.
        let (starved, blocked) = if now.waits == then.waits {
            (queued + rest, Duration::ZERO)
        } else {
            (queued, rest)
        };
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
    files: Option<[std::fs::File; 2]>,
}

impl Clock {
    /// The present moment.
    pub fn now(&mut self) -> Moment {
        let account = self.account();
        Moment {
            wall: Instant::now(),
            account,
        }
    }

    #[cfg(target_os = "linux")]
    fn account(&mut self) -> Option<Account> {
        if self.files.is_none() {
            let open = |name| std::fs::File::open(format!("/proc/thread-self/{name}")).ok();
            self.files = Some([open("schedstat")?, open("status")?]);
        }
        let [times, status] = self.files.as_ref()?;
        // The first number there is as old as the last tick of the system's clock.
        let starved = read(times)?.split_whitespace().nth(1)?.parse().ok()?;
        let ran = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        let status = read(status)?;
        let mut lines = status.lines();
        let waits = lines.find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"))?;
        Some(Account {
            ran: Duration::new(ran.tv_sec as u64, ran.tv_nsec as u32),
            starved: Duration::from_nanos(starved),
            waits: waits.trim().parse().ok()?,
        })
    }

    #[cfg(not(target_os = "linux"))]
    #[expect(clippy::unused_self, reason = "other systems have something to ask")]
    fn account(&mut self) -> Option<Account> {
        None
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
