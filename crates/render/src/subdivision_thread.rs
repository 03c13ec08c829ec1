//! A thread that halves the edges of one mesh after another, so that no frame waits for it.

use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, Weak};
use std::thread::{Builder, JoinHandle};

use antipode_geometry::ChunkCoord;
use antipode_terrain::ChunkMesh;
use glam::Vec3;

use crate::plan::{RefineRules, Refined, Subdivider};

/// A mesh to be refined.
#[derive(Clone, Debug)]
pub struct Task {
    /// Its chunk.
    pub coord: ChunkCoord,
    /// The mesh.
    pub source: Arc<ChunkMesh>,
    /// What edges are halved.
    pub rules: Arc<RefineRules>,
    /// The eyes from the chunk's corner, metres.
    pub eyes: Vec<Vec3>,
    /// Whether anybody waits for it still.
    pub wanted: Weak<()>,
}

/// When frames get what the thread has made. Another than the first has a test not depend on how fast the machine is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delivery {
    /// As soon as it is made; no frame waits for it.
    Soon,
    /// Not for now: the thread seems to be at its work still, whatever it has done.
    Held,
    /// All that is under way, in the next frame, which waits for it.
    Awaited,
}

impl Default for Delivery {
    fn default() -> Self {
        if cfg!(test) {
            Self::Awaited
        } else {
            Self::Soon
        }
    }
}

/// The thread and what it is at.
#[derive(Debug, Default)]
pub struct SubdivisionThread {
    thread: Option<Worker>,
    under_way: VecDeque<Task>,
    failed: bool,
    /// When frames get what it has made.
    pub delivery: Delivery,
}

#[derive(Debug)]
struct Worker {
    tasks: Sender<Task>,
    done: Receiver<(Task, Option<Refined>)>,
    handle: JoinHandle<()>,
}

impl Worker {
    fn start() -> std::io::Result<Self> {
        let (tasks, orders) = channel::<Task>();
        let (results, done) = channel();
        let work = move || {
            let mut subdivider = Subdivider::default();
            while let Ok(task) = orders.recv() {
                let is_wanted = task.wanted.strong_count() > 0;
                let refined =
                    is_wanted.then(|| subdivider.refine(&task.rules, &task.eyes, &task.source));
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

impl SubdivisionThread {
    /// Whether meshes are under way.
    pub fn is_busy(&self) -> bool {
        !self.under_way.is_empty()
    }

    /// Whether there is no thread to be had.
    pub fn has_failed(&self) -> bool {
        self.failed
    }

    /// Hands a mesh over, unless the same is under way already. What it was to be made for may be dropped meanwhile;
    /// then it is not made.
    pub fn start(&mut self, task: Task) {
        if self.failed {
            return;
        }
        let same = |other: &Task| {
            Arc::ptr_eq(&other.source, &task.source) && other.wanted.ptr_eq(&task.wanted)
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
            self.under_way.push_back(task);
        }
    }

    /// One mesh that is finished, if there is any. Never waits.
    pub fn take(&mut self) -> Option<(Task, Refined)> {
        loop {
            match self.next()? {
                Ok((task, refined)) => {
                    // In the order in which they were handed over.
                    self.under_way.pop_front();
                    if let Some(refined) = refined {
                        return Some((task, refined));
                    }
                }
                Err(TryRecvError::Empty) => return None,
                Err(TryRecvError::Disconnected) => {
                    self.fail("it broke off");
                    return None;
                }
            }
        }
    }

    fn next(&self) -> Option<Result<(Task, Option<Refined>), TryRecvError>> {
        let done = &self.thread.as_ref()?.done;
        match self.delivery {
            Delivery::Soon => Some(done.try_recv()),
            Delivery::Awaited if !self.under_way.is_empty() => {
                Some(done.recv().map_err(|_| TryRecvError::Disconnected))
            }
            Delivery::Held | Delivery::Awaited => None,
        }
    }

    fn fail(&mut self, why: &str) {
        tracing::error!("the thread that refines land: {why}; the main thread does its work");
        self.failed = true;
        self.thread = None;
        self.under_way.clear();
    }
}

impl Drop for SubdivisionThread {
    fn drop(&mut self) {
        if let Some(Worker { tasks, handle, .. }) = self.thread.take() {
            // Without anybody to give it tasks it ends.
            drop(tasks);
            let _ = handle.join();
        }
    }
}
