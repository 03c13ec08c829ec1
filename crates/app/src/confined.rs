//! Repair and import in a process of their own, with bounds.
//!
//! Both read files that may be damaged, or made by somebody who means harm. What is known of
//! such is refused before the store is opened; what nobody has thought of yet ends a process
//! that has nothing else to lose, and not the game with its unsaved world.
//!
//! The process is this program again, with a hidden command ([`Task`]). It takes limits on
//! its memory and time, does the work as anybody would and leaves its [`Answer`] on standard
//! output; who asked waits, and ends it when its time is over. If who asked is gone, it ends
//! itself then. Only Linux enforces the limit on memory; elsewhere there is the one on time
//! alone. What is left of an ended process the
//! next use of the saves directory removes, since its lock is gone with it.

mod process;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::Duration;

use antipode_rooms::RoomsDir;
use antipode_storage::{RepairReport, SavesDir, StorageError, WORLD_FILE};
use clap::Subcommand;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::output::line;
use process::{answer_of, end_after, limit_memory, myself};

/// What the work needs besides the file, with room to spare.
const MEMORY_BYTES: u64 = 512 << 20;
/// Repair keeps what it finds until it is written: twice the file, and no more than this.
const MOST_MEMORY_BYTES: u64 = 4 << 30;
/// Time for a small file; a slow disk may be busy.
const TIME: Duration = Duration::from_mins(1);
/// What a slow disk reads and writes besides.
const BYTES_PER_S: u64 = 2 << 20;
/// Nobody waits longer.
const MOST_TIME: Duration = Duration::from_mins(10);
/// Work for a process of its own.
#[derive(Clone, Debug, Subcommand)]
pub enum Task {
    /// Rescue what can be read of the world in a directory.
    Repair {
        /// The directory's name.
        slug: String,
    },
    /// Bring a world in from a file.
    Import {
        /// The file.
        file: PathBuf,
    },
    /// Bring a room in from a file; the directory is that of the rooms.
    ImportRoom {
        /// The file.
        file: PathBuf,
    },
}

/// What has come of it.
#[derive(Debug, Serialize, Deserialize)]
pub enum Answer {
    /// The world is repaired, with what could be rescued.
    Repaired(RepairReport),
    /// The world, or the room, is in the directory of this name.
    Imported(String),
    /// It was not done, for this reason.
    Refused(StorageError),
    /// It was not done, for the reason that this sentence has.
    Told(String),
}

/// Repairs a world in a process of its own.
///
/// # Errors
/// As [`SavesDir::repair`]; [`Failure::Runtime`] if the process did not come to an end.
pub fn repair(saves: &SavesDir, slug: &str) -> Result<RepairReport, Failure> {
    let slug = slug.to_owned();
    let task = Task::Repair { slug };
    match answer_of(myself(&task, saves)?, &task, task.limits(saves))? {
        Answer::Repaired(report) => Ok(report),
        Answer::Refused(error) => Err(error.into()),
        Answer::Told(sentence) => Err(Failure::Runtime(sentence)),
        Answer::Imported(_) => Err(senseless()),
    }
}

/// Brings a world in from a file in a process of its own; the name of its directory.
///
/// # Errors
/// As [`SavesDir::import`]; [`Failure::Runtime`] if the process did not come to an end.
pub fn import(saves: &SavesDir, file: &Path) -> Result<String, Failure> {
    let file = file.to_path_buf();
    imported(saves, &Task::Import { file })
}

/// Brings a room in from a file in a process of its own; the name of its directory.
///
/// # Errors
/// As [`RoomsDir::import`], in words; [`Failure::Runtime`] if the process did not come to an end.
pub fn import_room(rooms: &RoomsDir, file: &Path) -> Result<String, Failure> {
    let file = file.to_path_buf();
    // What is called the directory of worlds on the command line of that process is where its work is done.
    imported(&SavesDir::new(rooms.path()), &Task::ImportRoom { file })
}

fn imported(saves: &SavesDir, task: &Task) -> Result<String, Failure> {
    match answer_of(myself(task, saves)?, task, task.limits(saves))? {
        Answer::Imported(slug) => Ok(slug),
        Answer::Refused(error) => Err(error.into()),
        Answer::Told(sentence) => Err(Failure::Runtime(sentence)),
        Answer::Repaired(_) => Err(senseless()),
    }
}

/// Does the work in this process, which is there for nothing else, and says what came of it.
///
/// # Errors
/// If standard output refuses, or a limit cannot be had.
pub fn obey(saves: &SavesDir, task: &Task) -> Result<(), Failure> {
    let limits = task.limits(saves);
    end_after(limits.time)?;
    limit_memory(limits.memory_bytes)?;
    let done = match task {
        Task::Repair { slug } => saves.repair(slug).map(Answer::Repaired),
        Task::Import { file } => saves.import(file).map(Answer::Imported),
        Task::ImportRoom { file } => {
            let rooms = RoomsDir::new(saves.path());
            let imported = rooms.import(file).map(Answer::Imported);
            Ok(imported.unwrap_or_else(|error| Answer::Told(error.to_string())))
        }
    };
    let answer = done.unwrap_or_else(Answer::Refused);
    let said = serde_json::to_string(&answer).map_err(|_| senseless())?;
    line(&said)
}

/// What a task may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Limits {
    memory_bytes: u64,
    time: Duration,
}

impl Task {
    fn limits(&self, saves: &SavesDir) -> Limits {
        let length = |path: &Path| std::fs::metadata(path).map_or(0, |data| data.len());
        let (bytes, kept) = match self {
            Self::Repair { slug } => {
                let bytes = length(&saves.path().join(slug).join(WORLD_FILE));
                (bytes, bytes.saturating_mul(2))
            }
            Self::Import { file } | Self::ImportRoom { file } => (length(file), 0),
        };
        let time = TIME + Duration::from_secs(bytes / BYTES_PER_S);
        Limits {
            memory_bytes: MEMORY_BYTES.saturating_add(kept).min(MOST_MEMORY_BYTES),
            time: time.min(MOST_TIME),
        }
    }

    fn arguments(&self, saves: &SavesDir) -> Vec<OsString> {
        let (verb, object) = match self {
            Self::Repair { slug } => ("repair", OsString::from(slug)),
            Self::Import { file } => ("import", file.clone().into_os_string()),
            Self::ImportRoom { file } => ("import-room", file.clone().into_os_string()),
        };
        // In one word, since the directory may look like an option.
        let mut place = OsString::from("--saves-dir=");
        place.push(saves.path());
        let words: [OsString; 6] = [
            "saves".into(),
            "confined".into(),
            place,
            verb.into(),
            "--".into(),
            object,
        ];
        words.into()
    }

    /// What it was about, to say what became of it.
    fn object(&self) -> String {
        match self {
            Self::Repair { slug } => format!("Repairing the world in {slug}"),
            Self::Import { file } | Self::ImportRoom { file } => {
                format!("Importing {}", file.display())
            }
        }
    }
}

fn senseless() -> Failure {
    Failure::Runtime("The answer of the game's other process makes no sense.".to_owned())
}

#[cfg(test)]
mod tests;
