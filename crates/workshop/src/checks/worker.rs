//! The thread that looks at a room while it is edited. A newer room ends the look at an older one.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

use antipode_deformation::WalkerShape;
use antipode_rooms::{Assets, Room};
use crossbeam_channel::{Receiver, Sender, unbounded};

use super::{Finding, find};

/// A room is looked at when it has stayed as it is for so long: what is drawn of it is made meanwhile, and edits that follow each
/// other at once are looked at together.
const RESTS: Duration = Duration::from_millis(150);

/// What was found in a room.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// The revision that was looked at.
    pub revision: u64,
    /// What was found.
    pub findings: Vec<Finding>,
    /// Whether that is all; else the search for ways goes on.
    pub is_all: bool,
}

struct Job {
    number: u64,
    revision: u64,
    room: Arc<Room>,
    assets: Assets,
}

/// Looks at rooms, on a thread of its own.
#[derive(Debug)]
pub struct Checker {
    jobs: Option<Sender<Job>>,
    news: Receiver<(u64, Findings)>,
    newest: Arc<AtomicU64>,
    thread: Option<JoinHandle<()>>,
}

impl Checker {
    /// Starts it; `shape` is who walks in rooms.
    ///
    /// # Errors
    /// If the system has no thread for it.
    pub fn start(shape: WalkerShape) -> std::io::Result<Self> {
        let (jobs, taken) = unbounded::<Job>();
        let (told, news) = unbounded();
        let newest = Arc::new(AtomicU64::new(0));
        let wanted = newest.clone();
        let thread = std::thread::Builder::new()
            .name("antipode-checks".to_owned())
            .spawn(move || {
                while let Ok(mut job) = taken.recv() {
                    while let Ok(newer) = taken.recv_timeout(RESTS) {
                        job = newer;
                    }
                    look(&job, &shape, &wanted, &told);
                }
            })?;
        Ok(Self {
            jobs: Some(jobs),
            news,
            newest,
            thread: Some(thread),
        })
    }

    /// Has it look at a room, and at no older one any more.
    pub fn look(&self, revision: u64, room: Arc<Room>, assets: Assets) {
        let number = self.newest.fetch_add(1, Ordering::Relaxed) + 1;
        if let Some(jobs) = &self.jobs {
            // The thread ends after this only.
            let _ = jobs.send(Job {
                number,
                revision,
                room,
                assets,
            });
        }
    }

    /// What was found since it was asked last, in the newest room only.
    pub fn poll(&self) -> Option<Findings> {
        let newest = self.newest.load(Ordering::Relaxed);
        let told = self.news.try_iter().filter(|(number, _)| *number == newest);
        told.map(|(_, findings)| findings).last()
    }
}

fn look(job: &Job, shape: &WalkerShape, newest: &AtomicU64, told: &Sender<(u64, Findings)>) {
    let goes_on = || newest.load(Ordering::Relaxed) == job.number;
    let tell = |findings: Vec<Finding>, is_all| {
        let findings = Findings {
            revision: job.revision,
            findings,
            is_all,
        };
        let _ = told.send((job.number, findings));
    };
    let mut early = |found: &[Finding]| tell(found.to_vec(), false);
    let found = find(&job.room, &job.assets, shape, &goes_on, &mut early);
    if goes_on() {
        tell(found, true);
    }
}

impl Drop for Checker {
    fn drop(&mut self) {
        self.newest.fetch_add(1, Ordering::Relaxed);
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
