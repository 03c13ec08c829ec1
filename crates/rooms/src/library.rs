//! The directory of a player's rooms, and the rooms that come with the game: list, find, make, rename, double, delete,
//! export, import. What is made appears whole or not at all.

use std::path::{Component, Path, PathBuf};

use antipode_storage::{ArchiveKind, NamedFolders, StorageError, folded_name, free_name};

use crate::bounds::{MOST_ARCHIVE_BYTES, MOST_FOLDER_BYTES};
use crate::error::RoomError;
use crate::files::{ROOM_FILE, most_bytes};
use crate::folder::{self, Loaded};
use crate::lines::value_of;
use crate::read::read;
use crate::room::Room;
use crate::shipped::{self, Shipped};
use crate::write::{text, write};

/// File name extension of an exported room, without the dot.
pub const ARCHIVE_EXTENSION: &str = "antipode-room";

/// Archives of rooms.
pub const ARCHIVE: ArchiveKind = ArchiveKind {
    magic: *b"ANTIROOM",
    noun: "room",
    most_bytes: MOST_ARCHIVE_BYTES,
    most_file_bytes: most_bytes,
    most_unpacked_bytes: |_| MOST_FOLDER_BYTES,
};

/// What takes the place of a name of which nothing can be used.
const OTHER: &str = "Room";

/// What a list says of a room.
#[derive(Debug, Clone, PartialEq)]
pub struct RoomSummary {
    /// Its folder's name; of a room that comes with the game, its id.
    pub slug: String,
    /// Its name, or its folder's where that cannot be read.
    pub name: String,
    /// What is strange in it, in one sentence; may be empty.
    pub sentence: String,
    /// How many objects it has.
    pub objects: usize,
    /// Whether it comes with the game.
    pub shipped: bool,
    /// The room of the game whose sentence it has, word for word: itself, or the one that it is a copy of.
    pub says: Option<String>,
    /// Why it cannot be entered, if its text is not sound. Files that it names are not looked at for a list.
    pub problem: Option<String>,
}

/// A directory of rooms. Need not exist until the first room is made.
#[derive(Debug, Clone)]
pub struct RoomsDir {
    folders: NamedFolders,
}

impl RoomsDir {
    /// The rooms in `path`.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self {
            folders: NamedFolders::new(path),
        }
    }

    /// The directory.
    pub fn path(&self) -> &Path {
        self.folders.path()
    }

    /// All rooms: the player's by name, then those that come with the game. One bad room has a `problem`.
    ///
    /// # Errors
    /// If the directory itself cannot be read; a missing one is empty.
    pub fn list(&self) -> Result<Vec<RoomSummary>, RoomError> {
        let rooms = shipped::ROOMS.iter();
        let mut games: Vec<_> = rooms.map(|it| summary(it.id, it.room(), true)).collect();
        let mut own = self.own()?;
        own.sort_by_key(|it| (folded_name(&it.name), it.slug.clone()));
        for room in own.iter_mut().filter(|it| !it.sentence.is_empty()) {
            let told = games.iter().find(|it| it.sentence == room.sentence);
            room.says = told.map(|it| it.slug.clone());
        }
        for room in &mut games {
            room.says = Some(room.slug.clone());
        }
        own.append(&mut games);
        Ok(own)
    }

    fn own(&self) -> Result<Vec<RoomSummary>, RoomError> {
        let slugs = self.folders.folders_with(ROOM_FILE)?;
        let read = |slug: &String| {
            let dir = self.path().join(slug);
            let room = folder::read_text(&dir)
                .and_then(|it| read(&dir.join(ROOM_FILE).display().to_string(), &it));
            summary(slug, room, false)
        };
        Ok(slugs.iter().map(read).collect())
    }

    /// Finds a room by its name, ignoring case, or by its folder; the player's own before those of the game.
    ///
    /// # Errors
    /// [`RoomError::NotFound`], or if the directory cannot be read.
    pub fn find(&self, name_or_slug: &str) -> Result<RoomSummary, RoomError> {
        let wanted = folded_name(name_or_slug);
        let rooms = self.list()?;
        let by_name = rooms.iter().find(|it| folded_name(&it.name) == wanted);
        let found = by_name.or_else(|| rooms.iter().find(|it| it.slug == name_or_slug.trim()));
        found.cloned().ok_or_else(|| self.not_found(name_or_slug))
    }

    /// Reads a whole room.
    ///
    /// # Errors
    /// As [`folder::open`]; [`RoomError::NotFound`].
    pub fn open(&self, room: &RoomSummary) -> Result<Loaded, RoomError> {
        if room.shipped {
            return self.shipped(room)?.loaded();
        }
        folder::open(&self.dir(&room.slug)?)
    }

    /// Makes a room, under its name; the name of its folder.
    ///
    /// # Errors
    /// [`RoomError::Unsound`], [`RoomError::Name`] if there is a room of that name, failures of the file system.
    pub fn make(&self, room: &Room) -> Result<String, RoomError> {
        let text = write(room).map_err(RoomError::Unsound)?;
        let _turn = self.folders.turn()?;
        self.check_free(&room.name, None)?;
        let scratch = self.folders.scratch("new")?;
        folder::assets(scratch.path(), room)?;
        antipode_storage::new_file(&scratch.path().join(ROOM_FILE), text.as_bytes())?;
        Ok(self.folders.settle(&scratch, &room.name, "room")?)
    }

    /// Writes a room that is there again, whole or not at all. What its file had in comments is gone.
    ///
    /// # Errors
    /// [`RoomError::Unsound`], also where it names a file that its folder does not have, [`RoomError::NotFound`], failures of the file system.
    pub fn save(&self, slug: &str, room: &Room) -> Result<(), RoomError> {
        let text = write(room).map_err(RoomError::Unsound)?;
        let dir = self.dir(slug)?;
        folder::assets(&dir, room)?;
        Ok(antipode_storage::replace_file(
            &dir.join(ROOM_FILE),
            text.as_bytes(),
        )?)
    }

    /// Gives a room another name, and changes nothing else of its text. Its folder stays.
    ///
    /// # Errors
    /// [`RoomError::Name`], [`RoomError::Shipped`], [`RoomError::NotFound`], failures of the file system.
    pub fn rename(&self, room: &RoomSummary, name: &str) -> Result<(), RoomError> {
        let dir = self.own_dir(room)?;
        let _turn = self.folders.turn()?;
        self.check_free(name, Some(&room.slug))?;
        let text = renamed(&dir, name.trim())?;
        Ok(antipode_storage::replace_file(
            &dir.join(ROOM_FILE),
            text.as_bytes(),
        )?)
    }

    /// Makes a room like another, under its name with a number; the name of its folder. What it does not use of its
    /// folder is left behind.
    ///
    /// # Errors
    /// As [`RoomsDir::open`], failures of the file system.
    pub fn double(&self, room: &RoomSummary) -> Result<String, RoomError> {
        let loaded = self.open(room)?;
        let scratch = self.folders.scratch("copy")?;
        if room.shipped {
            antipode_storage::new_file(
                &scratch.path().join(ROOM_FILE),
                self.shipped(room)?.text.as_bytes(),
            )?;
        } else {
            copy(&loaded, &self.dir(&room.slug)?, scratch.path())?;
        }
        self.adopt(&scratch, &loaded.room.name)
    }

    /// Deletes a room for good.
    ///
    /// # Errors
    /// [`RoomError::Shipped`], [`RoomError::NotFound`], failures of the file system.
    pub fn delete(&self, room: &RoomSummary) -> Result<(), RoomError> {
        self.own_dir(room)?;
        Ok(self.folders.discard(&room.slug)?)
    }

    /// Writes a room into one file, which must not exist.
    ///
    /// # Errors
    /// As [`RoomsDir::open`]; [`StorageError::Exists`], [`StorageError::Archive`] if it would be too long, failures of
    /// the file system.
    pub fn export(&self, room: &RoomSummary, file: &Path) -> Result<(), RoomError> {
        let loaded = self.open(room)?;
        let names: Vec<&str> = loaded.files.iter().map(String::as_str).collect();
        let shipped = room.shipped.then(|| self.shipped(room)).transpose()?;
        let dir = if room.shipped {
            PathBuf::new()
        } else {
            self.dir(&room.slug)?
        };
        antipode_storage::make_file(file, |scratch, packed| {
            let from = match shipped {
                Some(it) => {
                    antipode_storage::new_file(
                        &scratch.path().join(ROOM_FILE),
                        it.text.as_bytes(),
                    )?;
                    scratch.path()
                }
                None => &dir,
            };
            antipode_storage::pack_archive(&ARCHIVE, from, &names, packed).map_err(|error| {
                match error {
                    // What it is called there is gone with it.
                    StorageError::Archive { reason, .. } => StorageError::Archive {
                        path: file.to_path_buf(),
                        reason,
                    },
                    other => other,
                }
            })
        })?;
        Ok(())
    }

    /// Adds a room from an exported file; the name of its folder. Everything in it is looked at before it appears, and
    /// nothing is overwritten: if its name is taken it gets a number.
    ///
    /// # Errors
    /// [`StorageError::Archive`], what is wrong with the room in it, failures of the file system.
    pub fn import(&self, file: &Path) -> Result<String, RoomError> {
        let scratch = self.folders.scratch("import")?;
        let names = antipode_storage::unpack_archive(&ARCHIVE, file, scratch.path())?;
        if !names.iter().any(|it| it == ROOM_FILE) {
            let reason = format!("there is no {ROOM_FILE} in it");
            return Err(StorageError::Archive {
                path: file.to_path_buf(),
                reason,
            }
            .into());
        }
        let loaded =
            folder::open(scratch.path()).map_err(|error| within(&error, scratch.path(), file))?;
        // Only what the room uses stays.
        let kept = self.folders.scratch("import")?;
        copy(&loaded, scratch.path(), kept.path())?;
        self.adopt(&kept, &loaded.room.name)
    }

    /// Makes a room of the finished folder in `scratch`, under a name that is free.
    fn adopt(
        &self,
        scratch: &antipode_storage::Scratch,
        wanted: &str,
    ) -> Result<String, RoomError> {
        let _turn = self.folders.turn()?;
        let rooms = self.list()?;
        let taken: Vec<&str> = rooms.iter().map(|it| it.name.as_str()).collect();
        let name = free_name(wanted, OTHER, &taken);
        if name != wanted {
            let text = renamed(scratch.path(), &name)?;
            antipode_storage::replace_file(&scratch.path().join(ROOM_FILE), text.as_bytes())?;
        }
        Ok(self.folders.settle(scratch, &name, "room")?)
    }

    fn check_free(&self, name: &str, but: Option<&str>) -> Result<(), RoomError> {
        antipode_storage::check_name(name)
            .map_err(|error| RoomError::Name(error.to_string().replace("world", "room")))?;
        let rooms = self.list()?;
        let is_taken = |it: &&RoomSummary| {
            folded_name(&it.name) == folded_name(name)
                && (it.shipped || Some(it.slug.as_str()) != but)
        };
        match rooms.iter().find(is_taken) {
            Some(it) => Err(RoomError::Name(format!(
                "There is a room called \"{}\" already.",
                it.name
            ))),
            None => Ok(()),
        }
    }

    fn not_found(&self, room: &str) -> RoomError {
        RoomError::NotFound {
            room: room.to_owned(),
            dir: self.path().to_path_buf(),
        }
    }

    fn shipped(&self, room: &RoomSummary) -> Result<&'static Shipped, RoomError> {
        shipped::find(&room.slug).ok_or_else(|| self.not_found(&room.name))
    }

    fn own_dir(&self, room: &RoomSummary) -> Result<PathBuf, RoomError> {
        if room.shipped {
            Err(RoomError::Shipped(room.name.clone()))
        } else {
            self.dir(&room.slug)
        }
    }

    /// The folder of a room that is there. A slug is one plain directory name.
    fn dir(&self, slug: &str) -> Result<PathBuf, RoomError> {
        let mut parts = Path::new(slug).components();
        let plain = matches!((parts.next(), parts.next()), (Some(Component::Normal(part)), None) if part == slug);
        let dir = self.path().join(slug);
        let is_dir = std::fs::symlink_metadata(&dir).is_ok_and(|data| data.is_dir());
        if plain && !slug.starts_with('.') && is_dir && dir.join(ROOM_FILE).is_file() {
            Ok(dir)
        } else {
            Err(self.not_found(slug))
        }
    }
}

fn summary(slug: &str, room: Result<Room, RoomError>, shipped: bool) -> RoomSummary {
    let slug = slug.to_owned();
    match room {
        Ok(room) => RoomSummary {
            slug,
            name: room.name,
            sentence: room.sentence,
            objects: room.objects.len(),
            shipped,
            says: None,
            problem: None,
        },
        Err(error) => RoomSummary {
            name: slug.clone(),
            slug,
            sentence: String::new(),
            objects: 0,
            shipped,
            says: None,
            problem: Some(error.to_string()),
        },
    }
}

/// The text of the room in `dir` with another name, and else as it is.
fn renamed(dir: &Path, name: &str) -> Result<String, RoomError> {
    let label = dir.join(ROOM_FILE).display().to_string();
    let bytes = folder::read_text(dir)?;
    let room = read(&label, &bytes)?;
    let mut old = String::from_utf8_lossy(&bytes).into_owned();
    if let Some(place) = value_of(&old, "name") {
        old.replace_range(place, &text(name));
        if read(&label, old.as_bytes()).is_ok_and(|it| it.name == name) {
            return Ok(old);
        }
    }
    write(&Room {
        name: name.to_owned(),
        ..room
    })
    .map_err(RoomError::Unsound)
}

/// Copies the files of a room.
fn copy(loaded: &Loaded, from: &Path, to: &Path) -> Result<(), RoomError> {
    for name in &loaded.files {
        let most = most_bytes(name).unwrap_or_default();
        let path = from.join(name);
        let bytes = antipode_storage::read_file(&path, most).map_err(|error| RoomError::File {
            path,
            reason: error.to_string(),
        })?;
        antipode_storage::new_file(&to.join(name), &bytes)?;
    }
    Ok(())
}

/// What is wrong in an unpacked archive, told of the archive.
fn within(error: &RoomError, hidden: &Path, archive: &Path) -> RoomError {
    let hidden = format!("{}{}", hidden.display(), std::path::MAIN_SEPARATOR);
    let said = error.to_string().replace(&hidden, "");
    let reason = format!(
        "the room in it is not sound: {}",
        said.trim_end_matches('.')
    );
    StorageError::Archive {
        path: archive.to_path_buf(),
        reason,
    }
    .into()
}
