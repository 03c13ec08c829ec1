//! The file on disk: opened once at the start, kept aside where it was not understood, replaced as a whole.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use super::MAX_BYTES;
use super::keeper::Keeper;
use super::notice::Notice;
use super::take::{Condition, Reading, read};
use crate::Config;

/// Most files that were put aside for one reason; beyond them nothing is written any more.
const MOST_KEPT: u32 = 1000;

/// The settings to begin with.
#[derive(Debug)]
pub struct Opened {
    /// What holds.
    pub config: Config,
    /// What there is to tell of the file.
    pub notices: Vec<Notice>,
    /// What writes changes; it does nothing where nothing may be written.
    pub keeper: Keeper,
}

/// Reads the file at a path and gets ready to write there. Where there is none, defaults hold and nothing is written
/// before something changes.
pub fn open(path: Option<PathBuf>) -> Opened {
    let Some(path) = path else {
        return without_file(Notice::NoPlace);
    };
    // A link is followed once, so that it stays a link when the file is replaced.
    let path = fs::canonicalize(&path).unwrap_or(path);
    let bytes = match bytes_of(&path) {
        Ok(Some(bytes)) => bytes,
        Ok(None) => {
            return Opened {
                config: Config::default(),
                notices: Vec::new(),
                keeper: Keeper::new(path),
            };
        }
        Err(error) => {
            let why = error.to_string();
            return without_file(Notice::Unreadable { path, why });
        }
    };
    let reading = read(&bytes);
    if reading.condition == Condition::Sound && reading.notices.is_empty() {
        return Opened {
            config: reading.config,
            notices: Vec::new(),
            keeper: Keeper::new(path),
        };
    }
    begin_anew(path, reading)
}

fn without_file(notice: Notice) -> Opened {
    Opened {
        config: Config::default(),
        notices: vec![notice],
        keeper: Keeper::idle(),
    }
}

/// Puts the file aside and writes what was understood of it.
fn begin_anew(path: PathBuf, reading: Reading) -> Opened {
    let Reading {
        config,
        condition,
        mut notices,
    } = reading;
    let word = match condition {
        Condition::Sound => "odd",
        Condition::Damaged => "damaged",
        Condition::Older => "older",
        Condition::Newer => "newer",
    };
    let keeper = match put_aside(&path, word) {
        Ok(kept) => {
            let notice = match condition {
                Condition::Sound => Notice::Kept { kept },
                Condition::Damaged => Notice::Damaged { kept },
                Condition::Older => Notice::Older { kept },
                Condition::Newer => Notice::Newer { kept },
            };
            notices.insert(0, notice);
            let keeper = Keeper::new(path);
            keeper.save(&config);
            keeper
        }
        Err(error) => {
            let why = error.to_string();
            notices.insert(0, Notice::Stuck { path, why });
            Keeper::idle()
        }
    };
    Opened {
        config,
        notices,
        keeper,
    }
}

/// At most as many bytes as are needed to see that a file is too long; `None` where there is nothing.
fn bytes_of(path: &Path) -> io::Result<Option<Vec<u8>>> {
    // Asked before opening: opening a pipe would wait for ever.
    match fs::metadata(path) {
        Ok(data) if data.is_file() => {}
        Ok(_) => return Err(io::Error::new(ErrorKind::InvalidInput, "it is not a file")),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    }
    let mut bytes = Vec::new();
    File::open(path)?
        .take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)?;
    Ok(Some(bytes))
}

/// Keeps a file under the first free name of the kind `settings.ron.damaged-1`; returns it. Where the system has
/// links the file has both names until it is replaced, so that at no moment there is none at all.
fn put_aside(path: &Path, word: &str) -> io::Result<PathBuf> {
    if fs::metadata(path)?.permissions().readonly() {
        return Err(read_only());
    }
    for number in 1..=MOST_KEPT {
        let mut aside = path.as_os_str().to_owned();
        aside.push(format!(".{word}-{number}"));
        let aside = PathBuf::from(aside);
        let kept = fs::hard_link(path, &aside).or_else(|error| match error.kind() {
            ErrorKind::AlreadyExists => Err(error),
            _ => rename_anew(path, &aside),
        });
        match kept {
            Ok(()) => return Ok(aside),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::Error::other("too many files have been put aside here"))
}

/// Renames a file to a name that nothing has yet.
fn rename_anew(path: &Path, to: &Path) -> io::Result<()> {
    // Made first, so that two games at once never choose the same name.
    File::create_new(to)?;
    fs::rename(path, to).inspect_err(|_| {
        let _ = fs::remove_file(to);
    })
}

fn read_only() -> io::Error {
    io::Error::new(
        ErrorKind::PermissionDenied,
        "the file is marked as read-only",
    )
}

/// Replaces a file by a text; a reader sees the old or the new, never a part. A file marked as read-only is left.
pub(super) fn replace(path: &Path, text: &str) -> io::Result<()> {
    if let Some(directory) = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty())
    {
        fs::create_dir_all(directory)?;
    }
    match fs::metadata(path) {
        Ok(data) if !data.is_file() => {
            return Err(io::Error::new(ErrorKind::InvalidInput, "it is not a file"));
        }
        Ok(data) if data.permissions().readonly() => return Err(read_only()),
        _ => {}
    }
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.tmp", std::process::id()));
    let beside = PathBuf::from(beside);
    // Whatever a killed process left there: made anew, it is a plain file for sure.
    let _ = fs::remove_file(&beside);
    let written = (|| {
        let mut file = File::create_new(&beside)?;
        file.write_all(text.as_bytes())?;
        file.sync_data()?;
        fs::rename(&beside, path)
    })();
    if written.is_err() {
        let _ = fs::remove_file(&beside);
        return written;
    }
    sync_directory(path);
    Ok(())
}

/// Makes the new name durable, where the system can: Windows cannot open a directory as a file.
fn sync_directory(path: &Path) {
    if let Some(Ok(directory)) = path.parent().map(File::open) {
        let _ = directory.sync_all();
    }
}
