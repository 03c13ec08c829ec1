//! A document as it comes from its folder: what the journal tells, and what the file of the room is.

use std::fs::{self, File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use antipode_rooms::bounds::MOST_ROOM_BYTES;
use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Room, read, write_so_far};
use antipode_storage::StorageError;

use super::frames::{HEAD, put};
use super::keeper::Keeper;
use super::record::{Record, Written, mark_of};
use super::replay::{Told, replay};
use super::worker::Worker;
use super::{FOLDER, JOURNAL, LOCK, VERSIONS, in_folder};
use crate::Delta;
use crate::document::{Document, Kept};
use crate::error::WorkshopError;
use crate::history::{History, LEAST_STEPS, Step};
use crate::said::Said;
use crate::versions::versions;

/// No journal is longer, bytes.
const MOST_JOURNAL_BYTES: u64 = 1 << 30;
/// A longer journal is written anew when it is opened, with the newest steps only.
const LONG_JOURNAL_BYTES: usize = 32 << 20;

/// How fast what was done is kept.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    /// So long after an edit it outlives a power cut. It outlives the end of the process as soon as the worker has it.
    pub sync_after: Duration,
    /// So long after an edit that no version has there is one.
    pub version_after: Duration,
}

impl Default for Pace {
    fn default() -> Self {
        Self {
            sync_after: Duration::from_secs(1),
            version_after: Duration::from_secs(30),
        }
    }
}

/// A document that was opened, and what there is to tell of it.
#[derive(Debug)]
pub struct Opened {
    /// The document.
    pub document: Document,
    /// Whether the document has edits that the room's file does not have.
    pub is_ahead: bool,
    /// Whether the file was changed by something else since it was saved here; that is a step of its own.
    pub was_changed: bool,
    /// Where a journal was put aside that could not be read to its end.
    pub aside: Option<PathBuf>,
}

/// Everything that is read before a document is made.
struct Found {
    lock: File,
    text: String,
    room: Room,
    told: Option<Told>,
    aside: Option<PathBuf>,
    bytes: Vec<u8>,
    /// Whether no file has these bytes.
    is_new: bool,
}

impl Document {
    /// Opens the room in a folder for editing, with all that is known of earlier edits. Waits for the disk.
    ///
    /// # Errors
    /// [`WorkshopError::InUse`], what is wrong with the room's file, failures of the file system.
    pub fn open(dir: &Path) -> Result<Opened, WorkshopError> {
        Self::open_at(dir, Pace::default())
    }

    /// The same at another pace.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_at(dir: &Path, pace: Pace) -> Result<Opened, WorkshopError> {
        let mut found = find(dir)?;
        let told = match found.told.take() {
            Some(told) => told,
            None => begin(&mut found)?,
        };
        settle(dir, found, told, pace)
    }
}

fn io(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> StorageError {
    move |error| StorageError::io(action, path, error)
}

fn find(dir: &Path) -> Result<Found, WorkshopError> {
    let path = dir.join(ROOM_FILE);
    fs::metadata(&path).map_err(io("Reading", &path))?;
    for folder in [dir.join(FOLDER), in_folder(dir, VERSIONS)] {
        fs::create_dir_all(&folder).map_err(io("Making", &folder))?;
        antipode_storage::sweep(&folder);
    }
    antipode_storage::sweep(dir);
    let lock = lock(dir)?;
    let bytes =
        antipode_storage::read_file(&path, MOST_ROOM_BYTES).map_err(io("Reading", &path))?;
    let room = read(&path.display().to_string(), &bytes)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let journal = in_folder(dir, JOURNAL);
    let bytes = read_journal(&journal)?;
    let told = bytes.as_ref().and_then(|it| replay(it));
    let bytes = bytes.unwrap_or_default();
    let is_whole = match &told {
        Some(told) => !told.is_damaged,
        None => fs::symlink_metadata(&journal).is_err(),
    };
    let aside = if is_whole {
        None
    } else {
        Some(put_aside(&journal, &bytes)?)
    };
    Ok(Found {
        lock,
        text,
        room,
        told,
        aside,
        bytes,
        is_new: false,
    })
}

fn lock(dir: &Path) -> Result<File, WorkshopError> {
    let path = in_folder(dir, LOCK);
    let mut options = File::options();
    let file = options.create(true).truncate(false).write(true).open(&path);
    let file = file.map_err(io("Locking", &path))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(WorkshopError::InUse(dir.to_path_buf())),
        // A disk without locks is no reason not to edit.
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(file),
        Err(TryLockError::Error(error)) => Err(io("Locking", &path)(error).into()),
    }
}

/// Whether another window, or another game, edits the room in a folder. Nothing is made there.
pub fn is_in_use(dir: &Path) -> bool {
    let path = in_folder(dir, LOCK);
    let file = File::options().write(true).open(path);
    file.is_ok_and(|it| matches!(it.try_lock(), Err(TryLockError::WouldBlock)))
}

/// The bytes of a journal; none if there are none that could be one.
fn read_journal(journal: &Path) -> Result<Option<Vec<u8>>, WorkshopError> {
    match antipode_storage::read_file(journal, MOST_JOURNAL_BYTES) {
        Ok(bytes) => Ok(Some(bytes)),
        // There is none, or it is too long, or no plain file.
        Err(error) => match error.kind() {
            ErrorKind::NotFound | ErrorKind::InvalidData | ErrorKind::InvalidInput => Ok(None),
            _ => Err(StorageError::io("Reading", journal, error).into()),
        },
    }
}

/// Keeps a copy of what cannot be read to its end; what cannot be read at all gets another name.
fn put_aside(journal: &Path, bytes: &[u8]) -> Result<PathBuf, WorkshopError> {
    let is_free = |path: &PathBuf| fs::symlink_metadata(path).is_err();
    let names = (1..).map(|number| journal.with_extension(format!("damaged-{number}")));
    let path = names.into_iter().find(is_free).unwrap_or_default();
    if bytes.is_empty() {
        fs::rename(journal, &path).map_err(io("Writing", &path))?;
    } else {
        antipode_storage::new_file(&path, bytes)?;
    }
    Ok(path)
}

/// A journal that begins with the room's file.
fn begin(found: &mut Found) -> Result<Told, WorkshopError> {
    found.bytes = journal_of(&found.text);
    found.is_new = true;
    match replay(&found.bytes) {
        Some(told) => Ok(told),
        None => crate::error::refuse("The room cannot be written down."),
    }
}

fn journal_of(text: &str) -> Vec<u8> {
    let mut bytes = HEAD.to_vec();
    add(&mut bytes, &Record::Base(text.to_owned()));
    bytes
}

fn add(bytes: &mut Vec<u8>, record: &Record) {
    // What JSON cannot say is no part of records.
    if let Ok(payload) = serde_json::to_vec(record) {
        put(bytes, &payload);
    }
}

/// Makes a document of what was found, and has it kept from now on.
fn settle(dir: &Path, found: Found, mut told: Told, pace: Pace) -> Result<Opened, WorkshopError> {
    let mark = mark_of(found.text.as_bytes());
    let mut new = told.unwritten(&found.bytes, found.is_new);
    let was_changed = !told.saved.contains(&mark) && found.room != told.room;
    let file_room = Arc::new(found.room);
    if was_changed {
        let step = told.outside(&file_room);
        add(&mut new, &step);
    }
    if told.saved[0] != mark {
        add(&mut new, &Record::Saving(mark.clone()));
    }
    let is_long = told.steps.len() > 2 * LEAST_STEPS || found.bytes.len() > LONG_JOURNAL_BYTES;
    let journal = in_folder(dir, JOURNAL);
    if is_long && told.made >= LEAST_STEPS {
        (new, told) = shortened(told, &mark);
        antipode_storage::replace_file(&journal, &new)?;
        told.good = new.len();
        new.clear();
    }
    let is_first = was_changed || versions(dir).is_empty();
    let worker = Worker {
        dir: dir.to_path_buf(),
        file: open_at_end(&journal, told.good as u64)?,
        journal,
        good: told.good as u64,
        known: vec![
            (file_room.clone(), found.text),
            (Arc::new(told.base), told.base_text),
        ],
        saved: mark,
        pace,
        lock: found.lock,
        pending: new,
        unversioned: is_first.then(|| file_room.clone()),
    };
    let keeper = Keeper::start(worker)?;
    keeper.flush();
    let is_ahead = told.room != *file_room;
    let room = Arc::new(told.room);
    let mut document = Document::of(room, History::of(told.steps, told.made));
    document.marks_mut().hidden = told.hidden;
    document.marks_mut().locked = told.locked;
    document.kept = Kept::by(keeper, dir.to_path_buf(), file_room);
    Ok(Opened {
        document,
        is_ahead,
        was_changed,
        aside: found.aside,
    })
}

/// Opens a journal of which so many bytes count.
fn open_at_end(journal: &Path, good: u64) -> Result<File, StorageError> {
    let mut options = File::options();
    options.create(true).truncate(false).read(true).write(true);
    let file = options.open(journal).map_err(io("Writing", journal))?;
    file.set_len(good).map_err(io("Writing", journal))?;
    Ok(file)
}

impl Told {
    /// What is to be added to the journal before anything else: all of it where it is new, and a drag that had not ended.
    fn unwritten(&mut self, bytes: &[u8], is_new: bool) -> Vec<u8> {
        let mut new = Vec::new();
        if is_new {
            new.extend(&bytes[..self.good]);
            self.good = 0;
        }
        if let Some((at, step)) = self.ended.take() {
            add(&mut new, &Record::Step { at, step });
        }
        new
    }

    /// Takes the room that the file has as a step.
    fn outside(&mut self, room: &Room) -> Record {
        let step = Step {
            said: Said::new("outside"),
            delta: Delta::between(&self.room, room),
        };
        let record = Record::Step {
            at: self.made,
            step: Written::of(&step, room),
        };
        self.push(Arc::new(step));
        record
    }
}

/// A journal of the newest steps only, whose base is the room before them; what was taken back stays.
fn shortened(told: Told, mark: &str) -> (Vec<u8>, Told) {
    let from = told.made - LEAST_STEPS;
    let history = History::of(told.steps, told.made);
    let base = history.room_at(&told.room, from);
    let base_text = write_so_far(&base);
    let steps = history.steps()[from..].to_vec();
    let mut bytes = journal_of(&base_text);
    let mut room = base.clone();
    for (at, step) in steps.iter().enumerate() {
        step.delta.make(&mut room);
        let step = Written::of(step, &room);
        add(&mut bytes, &Record::Step { at, step });
    }
    add(&mut bytes, &Record::Go { to: LEAST_STEPS });
    add(&mut bytes, &Record::Saving(mark.to_owned()));
    let (hidden, locked) = (told.hidden.clone(), told.locked.clone());
    add(&mut bytes, &Record::Marks { hidden, locked });
    let told = Told {
        base_text,
        base,
        steps,
        made: LEAST_STEPS,
        ..told
    };
    (bytes, told)
}
