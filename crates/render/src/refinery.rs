//! A thread that halves the edges of one mesh after another, so that no frame waits for it.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread::{Builder, JoinHandle};

use antipode_geometry::ChunkCoord;
use antipode_terrain::ChunkMesh;
use glam::Vec3;

use crate::plan::{Halver, RefineRules, Refined};

/// Meshes under way at most: what is asked for early is out of date when it comes.
const MOST_UNDER_WAY: usize = 3;

/// A mesh to be refined.
#[derive(Clone, Debug)]
pub struct Task {
    /// Its chunk.
    pub coord: ChunkCoord,
    /// The mesh.
    pub source: Arc<ChunkMesh>,
    /// What edges are halved.
    pub rules: Arc<RefineRules>,
    /// The eye from the chunk's corner, metres.
    pub eye: Vec3,
}

/// The thread and what it is at.
#[derive(Debug, Default)]
pub struct Refinery {
    thread: Option<Worker>,
    under_way: Vec<Task>,
    failed: bool,
}

#[derive(Debug)]
struct Worker {
    tasks: Sender<Task>,
    done: Receiver<(Task, Refined)>,
    handle: JoinHandle<()>,
}

impl Worker {
    fn start() -> std::io::Result<Self> {
        let (tasks, orders) = channel::<Task>();
        let (results, done) = channel();
        let work = move || {
            let mut halver = Halver::default();
            while let Ok(task) = orders.recv() {
                let refined = halver.refine(&task.rules, task.eye, &task.source);
                if results.send((task, refined)).is_err() {
                    return;
                }
            }
        };
        let handle = Builder::new()
            .name("antipode-refine".to_owned())
            .spawn(work)?;
        Ok(Self {
            tasks,
            done,
            handle,
        })
    }
}

impl Refinery {
    /// Whether there is a thread to be had, and it has room for another mesh.
    pub fn has_room(&self) -> bool {
        !self.failed && self.under_way.len() < MOST_UNDER_WAY
    }

    /// Whether meshes are under way.
    pub fn is_busy(&self) -> bool {
        !self.under_way.is_empty()
    }

    /// Whether there is no thread to be had.
    pub fn has_failed(&self) -> bool {
        self.failed
    }

    /// Hands a mesh over, unless the same is under way already.
    pub fn start(&mut self, task: Task) {
        let same = |other: &Task| {
            Arc::ptr_eq(&other.source, &task.source) && Arc::ptr_eq(&other.rules, &task.rules)
        };
        if self.under_way.iter().any(same) {
            return;
        }
        if self.thread.is_none() {
            match Worker::start() {
                Ok(worker) => self.thread = Some(worker),
                Err(e) => self.fail(&e.to_string()),
            }
        }
        if let Some(worker) = &self.thread
            && worker.tasks.send(task.clone()).is_ok()
        {
            self.under_way.push(task);
        }
    }

    /// One mesh that is finished, if there is any. Never waits.
    pub fn take(&mut self) -> Option<(Task, Refined)> {
        match self.thread.as_ref()?.done.try_recv() {
            Ok((task, refined)) => {
                // In the order in which they were handed over.
                self.under_way.remove(0);
                Some((task, refined))
            }
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.fail("it broke off");
                None
            }
        }
    }

    fn fail(&mut self, why: &str) {
        tracing::error!("the thread that refines land: {why}; the main thread does its work");
        self.failed = true;
        self.thread = None;
        self.under_way.clear();
    }
}

impl Drop for Refinery {
    fn drop(&mut self) {
        if let Some(Worker { tasks, handle, .. }) = self.thread.take() {
            // Without anybody to give it tasks it ends.
            drop(tasks);
            let _ = handle.join();
        }
    }
}
