//! What keeps a document on the disk, on a thread of its own: each entry is in the journal as soon as it is handed over, and
//! safe from a power cut within [`Pace::sync_after`].

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant, SystemTime};

use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Room, RoomError, folder, write, write_so_far};
use antipode_storage::StorageError;
use crossbeam_channel::{Receiver, RecvTimeoutError, Sender};

use super::frames;
use super::keeper::{News, Note};
use super::opening::Pace;
use super::record::{Record, Written, mark_of};
use crate::versions::write_version;

/// How long after a failure the journal is tried again.
const RETRY: Duration = Duration::from_secs(1);

/// What keeps a document.
#[derive(Debug)]
pub(crate) struct Worker {
    pub dir: PathBuf,
    pub journal: PathBuf,
    /// The journal, open at its end.
    pub file: File,
    /// How many bytes of it are whole entries.
    pub good: u64,
    /// Rooms whose texts were written by hand, perhaps: that of the file when it was opened, and that with which the journal
    /// began. What is the same again is saved as it was, comments and all.
    pub known: Vec<(Arc<Room>, String)>,
    /// The mark of the text that the room's file has.
    pub saved: String,
    pub pace: Pace,
    /// Held as long as this works.
    pub lock: File,
    /// Entries that are not in the journal yet.
    pub pending: Vec<u8>,
    /// The room that no version has yet.
    pub unversioned: Option<Arc<Room>>,
}

/// When something is to be done next.
#[derive(Debug, Default)]
struct Due {
    sync: Option<Instant>,
    retry: Option<Instant>,
    version: Option<Instant>,
}

impl Worker {
    /// The folder that it writes into.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Works until nobody hands over anything any more.
    pub fn run(mut self, notes: &Receiver<Note>, news: &Sender<News>) {
        let mut due = Due::default();
        loop {
            let next = [due.sync, due.retry, due.version]
                .into_iter()
                .flatten()
                .min();
            let taken = match next {
                None => notes.recv().map_err(|_| RecvTimeoutError::Disconnected),
                Some(at) => notes.recv_deadline(at),
            };
            match taken {
                Ok(note) => self.take(note, notes, news, &mut due),
                Err(RecvTimeoutError::Timeout) => self.work_off(news, &mut due),
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        self.append(news, &mut due);
        let _ = self.file.sync_data();
        self.write_version();
        let _ = self.lock.unlock();
    }

    /// Takes what has been handed over, all that is there at once.
    fn take(&mut self, first: Note, notes: &Receiver<Note>, news: &Sender<News>, due: &mut Due) {
        let now = Instant::now();
        for note in std::iter::once(first).chain(notes.try_iter()) {
            match note {
                Note::Save { room, answer } => {
                    self.append(news, due);
                    let saved = self.save(&room);
                    let told = match &saved {
                        Ok(()) => Some(News::Saved(room)),
                        Err(_) => None,
                    };
                    match (answer, saved) {
                        (Some(answer), saved) => drop(answer.send(saved)),
                        (None, Err(error)) => drop(news.send(News::NotSaved(error))),
                        (None, Ok(())) => {}
                    }
                    if let Some(told) = told {
                        let _ = news.send(told);
                    }
                }
                Note::Flush(done) => {
                    self.append(news, due);
                    let _ = self.file.sync_data();
                    due.sync = None;
                    let _ = done.send(());
                }
                note => self.write_down(note),
            }
        }
        self.append(news, due);
        due.sync = due.sync.or(Some(now + self.pace.sync_after));
        if self.unversioned.is_some() {
            due.version = due.version.or(Some(now + self.pace.version_after));
        }
    }

    fn write_down(&mut self, note: Note) {
        let record = match note {
            Note::Step { at, step, room } => {
                let step = Written::of(&step, &room);
                self.unversioned = Some(room);
                Record::Step { at, step }
            }
            Note::Held { at, step, room } => {
                let step = Written::of(&step, &room);
                Record::Held { at, step }
            }
            Note::Go { to, room } => {
                self.unversioned = Some(room);
                Record::Go { to }
            }
            Note::Marks { hidden, locked } => Record::Marks { hidden, locked },
            Note::Save { .. } | Note::Flush(_) => return,
        };
        self.add(&record);
    }

    fn add(&mut self, record: &Record) {
        match serde_json::to_vec(record) {
            Ok(payload) => frames::put(&mut self.pending, &payload),
            Err(error) => tracing::error!(%error, "an edit cannot be written down"),
        }
    }

    /// Writes what is pending to the end of the journal. What cannot be written stays pending, and no half of it in the file.
    fn append(&mut self, news: &Sender<News>, due: &mut Due) {
        if self.pending.is_empty() {
            return;
        }
        match self.try_append() {
            Ok(()) => {
                if due.retry.take().is_some() {
                    let _ = news.send(News::Mended);
                }
            }
            Err(source) => {
                if due.retry.is_none() {
                    let error = StorageError::io("Writing", &self.journal, source);
                    let _ = news.send(News::Trouble(error));
                }
                due.retry = Some(Instant::now() + RETRY);
            }
        }
    }

    fn try_append(&mut self) -> std::io::Result<()> {
        // After a failure there may be a part of an entry.
        if self.file.metadata()?.len() != self.good {
            self.file.set_len(self.good)?;
        }
        self.file.seek(SeekFrom::Start(self.good))?;
        self.file.write_all(&self.pending)?;
        self.good += self.pending.len() as u64;
        self.pending.clear();
        Ok(())
    }

    fn work_off(&mut self, news: &Sender<News>, due: &mut Due) {
        let now = Instant::now();
        let is_due = |at: Option<Instant>| at.is_some_and(|at| at <= now);
        if is_due(due.retry) {
            self.append(news, due);
        }
        if is_due(due.sync) {
            due.sync = None;
            if let Err(error) = self.file.sync_data() {
                tracing::warn!(%error, journal = %self.journal.display(), "the disk does not confirm what was written");
            }
        }
        if is_due(due.version) {
            due.version = None;
            self.write_version();
        }
    }

    fn write_version(&mut self) {
        let Some(room) = self.unversioned.take() else {
            return;
        };
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        let when_s = now.unwrap_or_default().as_secs();
        if let Err(error) = write_version(&self.dir, when_s, &write_so_far(&room)) {
            tracing::warn!(%error, room = %self.dir.display(), "a version of the room cannot be kept");
        }
    }

    /// Makes a room the file, whole or not at all.
    fn save(&mut self, room: &Arc<Room>) -> Result<(), RoomError> {
        let text = match self.known.iter().find(|(it, _)| it == room) {
            Some((_, text)) => text.clone(),
            None => write(room).map_err(RoomError::Unsound)?,
        };
        let mark = mark_of(text.as_bytes());
        if mark == self.saved {
            return Ok(());
        }
        folder::assets(&self.dir, room)?;
        // Before it is written, so that the file is known again if the process is killed between.
        self.add(&Record::Saving(mark.clone()));
        let written = self.try_append().and_then(|()| self.file.sync_data());
        written.map_err(|source| StorageError::io("Writing", &self.journal, source))?;
        antipode_storage::replace_file(&self.dir.join(ROOM_FILE), text.as_bytes())?;
        self.saved = mark;
        Ok(())
    }
}
