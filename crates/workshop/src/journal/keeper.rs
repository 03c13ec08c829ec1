//! The main thread's end of what keeps a document: it hands over and never waits.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::thread::JoinHandle;

use antipode_rooms::{Room, RoomError};
use antipode_storage::StorageError;
use crossbeam_channel::{Receiver, Sender, bounded, unbounded};

use super::worker::Worker;
use crate::history::Step;

/// What is handed over. Steps are counted from the beginning of the journal.
#[derive(Debug)]
pub(crate) enum Note {
    Step {
        at: usize,
        step: Arc<Step>,
        room: Arc<Room>,
    },
    Held {
        at: usize,
        step: Arc<Step>,
        room: Arc<Room>,
    },
    Go {
        to: usize,
        room: Arc<Room>,
    },
    Marks {
        hidden: BTreeSet<String>,
        locked: BTreeSet<String>,
    },
    /// The room is to be the file; who wants to know gets the answer, too.
    Save {
        room: Arc<Room>,
        answer: Option<Sender<Result<(), RoomError>>>,
    },
    /// Says when all before is on the disk.
    Flush(Sender<()>),
}

/// What is told of keeping.
#[derive(Debug)]
pub(crate) enum News {
    /// The file has this room now.
    Saved(Arc<Room>),
    /// The room could not be saved.
    NotSaved(RoomError),
    /// The journal cannot be written; it is tried again.
    Trouble(StorageError),
    /// It can be written again.
    Mended,
}

/// Keeps a document, on a thread of its own.
#[derive(Debug)]
pub(crate) struct Keeper {
    notes: Option<Sender<Note>>,
    news: Receiver<News>,
    thread: Option<JoinHandle<()>>,
}

impl Keeper {
    /// Starts a worker on a thread of its own.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(worker: Worker) -> Result<Self, StorageError> {
        let (notes, taken) = unbounded();
        let (told, news) = unbounded();
        let path = worker.dir().to_path_buf();
        let thread = std::thread::Builder::new()
            .name("antipode-workshop".to_owned())
            .spawn(move || worker.run(&taken, &told))
            .map_err(|source| StorageError::Io {
                action: "Keeping".into(),
                path,
                source,
            })?;
        Ok(Self {
            notes: Some(notes),
            news,
            thread: Some(thread),
        })
    }

    /// Hands the worker a note, without waiting for it.
    pub fn hand(&self, note: Note) {
        if let Some(notes) = &self.notes {
            // The worker ends after this only.
            let _ = notes.send(note);
        }
    }

    /// What the worker has told since this was asked last.
    pub fn news(&self) -> impl Iterator<Item = News> + '_ {
        self.news.try_iter()
    }

    /// Waits until all that was handed over is on the disk, as far as that can be written.
    pub fn flush(&self) {
        let (done, wait) = bounded(1);
        self.hand(Note::Flush(done));
        let _ = wait.recv();
    }

    /// Has the room made the file. What is returned waits for that, on any thread.
    pub fn saving(&self, room: Arc<Room>) -> impl FnOnce() -> Result<(), RoomError> + Send + use<> {
        let (answer, wait) = bounded(1);
        self.hand(Note::Save {
            room,
            answer: Some(answer),
        });
        move || wait.recv().unwrap_or(Ok(()))
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.notes = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
