//! The clocks of one thread.

use std::time::{Duration, Instant};

use antipode_timing::{ThreadAccount, thread_ran};

use super::Spent;

/// Most times that the clocks are looked at again for one moment.
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
    thread: Option<ThreadAccount>,
}

impl Clock {
    /// The present moment.
    pub fn now(&mut self) -> Moment {
        let thread = self
            .thread
            .get_or_insert_with(ThreadAccount::of_this_thread);
        let mut moment = look(thread);
        for _ in 0..MOST_LOOKS {
            let queued = thread.queued();
            let is_whole = moment.account.is_none_or(|it| Some(it.starved) == queued);
            if is_whole {
                break;
            }
            // The thread lost the processor meanwhile; the clocks do not tell of one moment.
            moment = look(thread);
        }
        moment
    }
}

fn look(thread: &ThreadAccount) -> Moment {
    Moment {
        account: account(thread),
        wall: Instant::now(),
    }
}

fn account(thread: &ThreadAccount) -> Option<Account> {
    Some(Account {
        starved: thread.queued()?,
        waits: thread.waits()?,
        ran: thread_ran()?,
    })
}
