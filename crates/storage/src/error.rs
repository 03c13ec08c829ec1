//! Everything that can go wrong with a save. Each error is a sentence for the player: what happened, to which world or
//! file, and what the player can do.

use std::borrow::Cow;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize, Serializer};

use crate::name::NameError;
use crate::schema::SCHEMA_VERSION;

/// What can go wrong with a save. It passes from one process to another as the sentence that it is.
#[derive(Debug, Serialize, Deserialize, thiserror::Error)]
pub enum StorageError {
    /// Another process, or this one, has the world open.
    #[error(
        "The world \"{world}\" is in use: it is open in another window of the game or another program. Close it there and try again."
    )]
    InUse {
        /// Name or directory of the world.
        world: String,
    },
    /// Somebody else gives names to worlds, and for too long.
    #[error("Another game is making, renaming or importing a world in {} and has not finished. Try again in a moment, or close the other game.", dir.display())]
    Busy {
        /// The directory of worlds.
        #[serde(serialize_with = "lossy")]
        dir: PathBuf,
    },
    /// The world was written by a newer game.
    #[error(
        "The world \"{world}\" was saved by a newer version of the game (save format {found}; this game knows up to {SCHEMA_VERSION}). Update the game to play it; nothing has been changed."
    )]
    Newer {
        /// Name or directory of the world.
        world: String,
        /// The schema version found.
        found: u16,
    },
    /// One stored value is damaged; the others may be whole.
    #[error(
        "In the world \"{world}\" {what} is damaged: {reason}. The rest can be used; `antipode saves repair` restores an older copy of it if there is one."
    )]
    Damaged {
        /// Name or directory of the world.
        world: String,
        /// What the value is, such as `chunk A (1, 0, -2)`.
        what: String,
        /// Why it cannot be believed.
        reason: String,
    },
    /// The store as a whole cannot be read.
    #[error("The save {} cannot be read: {reason}. `antipode saves repair` salvages what is whole and keeps this file.", path.display())]
    Unreadable {
        /// The file.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// There is a world, but no file where its store should be.
    #[error("The save {} {what}. {}", path.display(), remedy(*rebuildable))]
    NoStore {
        /// Where the file should be.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
        /// What is there instead, such as `is missing`.
        what: String,
        /// Whether the summary beside it tells which world it was.
        rebuildable: bool,
    },
    /// An open world's file is not where it was opened.
    #[error("The save {} is gone: its folder was moved, deleted or replaced while the world was open, so nothing can be saved there. Move the folder back and save again, or import a copy of the world.", path.display())]
    Vanished {
        /// Where the file was.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
    },
    /// A file stands where a directory of worlds should be.
    #[error("{} is a file, so there can be no worlds in it. Choose a directory with --saves-dir.", path.display())]
    NotADirectory {
        /// The file.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
    },
    /// A repair has found nothing to save.
    #[error("Nothing could be salvaged from {}: {reason}. Nothing was changed; if you have a copy of this world, import it.", path.display())]
    Unsalvageable {
        /// The file.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
        /// What is missing.
        reason: String,
    },
    /// There is no such world.
    #[error("There is no world \"{world}\" in {}. `antipode saves list` shows those there are.", dir.display())]
    NotFound {
        /// What was asked for.
        world: String,
        /// The saves directory.
        #[serde(serialize_with = "lossy")]
        dir: PathBuf,
    },
    /// The name cannot be used.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A file or directory stands where a new one should be made.
    #[error("{} exists already and is not overwritten. Choose another name or move it away.", path.display())]
    Exists {
        /// The path in the way.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
    },
    /// A file is no exported world, or a damaged one.
    #[error("{} cannot be imported: {reason}.", path.display())]
    Archive {
        /// The file.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The disk, or the player's share of it, is full.
    #[error(
        "There is no space left to write {what}, or a limit on the size of files is reached. Free some space and save again; what was saved before is safe."
    )]
    DiskFull {
        /// What was being written: a world by its name, or a path.
        what: String,
    },
    /// The file system or the permissions forbid writing.
    #[error("{} cannot be written: it is read-only or belongs to someone else. Change its permissions, or choose another place with --saves-dir.", path.display())]
    NotWritable {
        /// What was being written.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
    },
    /// The permissions forbid even to look.
    #[error("{} cannot be read: its permissions forbid it, or it belongs to someone else. Change its permissions, or choose another place with --saves-dir.", path.display())]
    NotReadable {
        /// What was being read.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
    },
    /// Any other failure of the file system.
    #[error("{action} {} failed: {source}. Check the disk and try again.", path.display())]
    Io {
        /// What was being done, such as `Reading`.
        action: Cow<'static, str>,
        /// To what.
        #[serde(serialize_with = "lossy")]
        path: PathBuf,
        /// What the system said.
        #[serde(with = "as_text")]
        source: io::Error,
    },
    /// A value that the game hands over cannot be stored; a fault of the game.
    #[error(
        "{what} of the world \"{world}\" cannot be stored: {reason}. The save is as it was before; please report this."
    )]
    Unstorable {
        /// Name or directory of the world.
        world: String,
        /// What the value is.
        what: String,
        /// Why it cannot be stored.
        reason: String,
    },
}

impl StorageError {
    /// The sentence for a failed file operation.
    pub fn io(action: &'static str, path: &Path, source: io::Error) -> Self {
        let path = path.to_path_buf();
        match source.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                Self::DiskFull {
                    what: path.display().to_string(),
                }
            }
            ErrorKind::PermissionDenied if action == "Reading" => Self::NotReadable { path },
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                Self::NotWritable { path }
            }
            ErrorKind::AlreadyExists => Self::Exists { path },
            _ => Self::Io {
                action: action.into(),
                path,
                source,
            },
        }
    }

    /// The sentence for a failure of the store in `path`, of the world called `world`.
    pub(crate) fn store(path: &Path, world: &str, error: impl Into<redb::Error>) -> Self {
        match error.into() {
            redb::Error::DatabaseAlreadyOpen => Self::InUse {
                world: world.to_owned(),
            },
            // What a foreign, empty or shortened file gives.
            redb::Error::Io(source)
                if matches!(
                    source.kind(),
                    ErrorKind::InvalidData | ErrorKind::UnexpectedEof
                ) =>
            {
                Self::unreadable(
                    path,
                    "it is no save of this game, or a part of it is missing",
                )
            }
            redb::Error::Io(source) => {
                Self::io("Writing or reading", path, source).of_world(world, path, path)
            }
            redb::Error::PreviousIo => Self::Io {
                action: "Writing".into(),
                path: path.to_path_buf(),
                source: io::Error::other("an earlier write failed"),
            },
            redb::Error::Corrupted(reason) => {
                Self::unreadable(path, &format!("its index is damaged ({reason})"))
            }
            other => Self::unreadable(path, &other.to_string()),
        }
    }

    /// The same failure, told of the world called `world`: a full disk names it, and what lies in the hidden place
    /// `hidden` is called by `shown`, where it is to end.
    pub(crate) fn of_world(mut self, world: &str, hidden: &Path, shown: &Path) -> Self {
        match &mut self {
            Self::DiskFull { what } => *what = format!("\"{world}\" ({})", shown.display()),
            Self::NotWritable { path }
            | Self::NotReadable { path }
            | Self::Exists { path }
            | Self::Unreadable { path, .. }
            | Self::Io { path, .. }
                if path.starts_with(hidden) =>
            {
                *path = shown.to_path_buf();
            }
            _ => {}
        }
        self
    }

    /// The sentence for a failure at the directory of worlds itself: most often it,
    /// or what it should be in, is a file.
    pub(crate) fn place(action: &'static str, saves: &Path, source: io::Error) -> Self {
        let file = saves.ancestors().find(|path| path.is_file());
        match file {
            Some(file) => Self::NotADirectory {
                path: file.to_path_buf(),
            },
            None => Self::io(action, saves, source),
        }
    }

    /// Whether the world is damaged, which a report tells, rather than out of reach.
    pub(crate) fn is_damage(&self) -> bool {
        matches!(
            self,
            Self::Unreadable { .. } | Self::Damaged { .. } | Self::NoStore { .. }
        )
    }

    /// What is damaged and how, in words that name no file.
    pub(crate) fn damage(&self) -> String {
        match self {
            Self::Unreadable { reason, .. } => reason.clone(),
            Self::Damaged { what, reason, .. } => format!("{what} is damaged, {reason}"),
            Self::NoStore { what, .. } => format!("it {what}"),
            other => other.to_string(),
        }
    }

    /// The sentence for a store that cannot be read.
    pub(crate) fn unreadable(path: &Path, reason: &str) -> Self {
        Self::Unreadable {
            path: path.to_path_buf(),
            reason: reason.trim_end_matches('.').to_owned(),
        }
    }

    /// Runs `work` and puts failures of the file system into words.
    pub(crate) fn at<T>(
        action: &'static str,
        path: &Path,
        result: io::Result<T>,
    ) -> Result<T, Self> {
        result.map_err(|source| Self::io(action, path, source))
    }
}

/// A path as it is shown: one that is no text would keep the whole error from being one.
fn lossy<S: Serializer>(path: &Path, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&path.to_string_lossy())
}

/// What the system said, in its words.
mod as_text {
    use std::io;

    use serde::{Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(error: &io::Error, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(error)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<io::Error, D::Error> {
        String::deserialize(from).map(io::Error::other)
    }
}

fn remedy(rebuildable: bool) -> &'static str {
    if rebuildable {
        "`antipode saves repair` makes the world anew from its summary, without what was built in it; if you have a copy of the file, put it back instead."
    } else {
        "Nothing is left that tells which world it was: put the file back from a copy, or delete the world."
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;

    #[test]
    fn file_system_failures_are_told_apart() {
        let path = Path::new("saves/x/world.redb");
        let say = |kind| StorageError::io("Writing", path, io::Error::from(kind)).to_string();
        assert!(say(ErrorKind::StorageFull).contains("no space left"));
        assert!(say(ErrorKind::QuotaExceeded).contains("no space left"));
        assert!(say(ErrorKind::ReadOnlyFilesystem).contains("read-only"));
        assert!(say(ErrorKind::PermissionDenied).contains("--saves-dir"));
        let denied = io::Error::from(ErrorKind::PermissionDenied);
        let reading = StorageError::io("Reading", path, denied).to_string();
        assert!(
            reading.contains("cannot be read: its permissions"),
            "{reading}"
        );
        assert!(say(ErrorKind::TimedOut).starts_with("Writing saves/x/world.redb failed"));
        assert!(say(ErrorKind::StorageFull).contains("saves/x/world.redb"));
    }

    #[test]
    fn a_full_disk_names_the_world_and_nothing_hidden() {
        let hidden = Path::new("saves/.antipode-new-1-0/contents");
        let shown = Path::new("saves/foo");
        for kind in [
            ErrorKind::StorageFull,
            ErrorKind::FileTooLarge,
            ErrorKind::PermissionDenied,
            ErrorKind::TimedOut,
        ] {
            let error = StorageError::io("Writing", &hidden.join("world.redb"), kind.into());
            let said = error.of_world("Foo", hidden, shown).to_string();
            assert!(said.contains("saves/foo") && !said.contains("/."), "{said}");
        }
        let elsewhere = StorageError::io("Writing", Path::new("x"), ErrorKind::TimedOut.into());
        let said = elsewhere.of_world("Foo", hidden, shown).to_string();
        assert!(said.starts_with("Writing x failed"), "{said}");
        let full = StorageError::store(
            Path::new("saves/x/world.redb"),
            "Foo",
            redb::Error::Io(ErrorKind::FileTooLarge.into()),
        );
        assert!(
            full.to_string().contains("write \"Foo\" (saves/x"),
            "{full}"
        );
    }

    #[test]
    fn store_failures_name_the_world_or_the_file() {
        let path = Path::new("saves/x/world.redb");
        let say = |error| StorageError::store(path, "Foo", error).to_string();
        assert!(say(redb::Error::DatabaseAlreadyOpen).contains("\"Foo\" is in use"));
        assert!(say(redb::Error::Corrupted("x".to_owned())).contains("repair"));
        assert!(
            say(redb::Error::Io(ErrorKind::InvalidData.into())).contains("no save of this game")
        );
        assert!(say(redb::Error::Io(ErrorKind::StorageFull.into())).contains("no space left"));
    }
}
