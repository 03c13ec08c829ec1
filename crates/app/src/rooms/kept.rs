//! How a room of the player's own is kept beside its file: what there is to tell of that when it is opened, whether it may be
//! changed here, and its older versions.

use std::path::{Path, PathBuf};

use antipode_rooms::folder::assets;
use antipode_rooms::{Assets, Room, RoomError, RoomSummary, RoomsDir};
use antipode_workshop::{Document, Plan, Said, Version, WorkshopError, read_version, versions};

use super::{NAMELESS, OpenRoom};

/// What there is to tell of a room that was opened to be built in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RoomNote {
    /// It has edits that its file does not have.
    Ahead,
    /// Its file was changed by something else.
    Changed,
    /// Its journal was damaged, and lies there now.
    Aside(PathBuf),
    /// Another window builds in it.
    InUse,
    /// Its journal cannot be written, for that reason.
    NoJournal(String),
}

impl OpenRoom {
    /// Why it is not to be changed here, if it is not.
    pub fn read_only(&self) -> Option<&RoomNote> {
        let is_it = |it: &&RoomNote| matches!(it, RoomNote::InUse | RoomNote::NoJournal(_));
        self.notes.iter().find(is_it)
    }

    /// The folder of a room of the player's own.
    pub fn folder(&self, dir: &RoomsDir) -> Option<PathBuf> {
        let own = self.kept.as_ref().filter(|kept| !kept.shipped)?;
        Some(dir.path().join(&own.slug))
    }

    /// Its older versions, the newest first; none of a room that is not the player's own. Waits for the disk.
    pub fn versions(&self, dir: &RoomsDir) -> Vec<Version> {
        self.folder(dir).map_or_else(Vec::new, |it| versions(&it))
    }

    /// Goes back to the older version of that number, 1 for the newest, which is a step that can be taken back. Waits for the disk.
    ///
    /// # Errors
    /// If there is none of that number, or why it cannot be read.
    pub fn open_older(&mut self, dir: &RoomsDir, number: usize) -> Result<(), RoomError> {
        self.check_free()?;
        self.take_older(find_older(self.folder(dir).as_deref(), number)?)
    }

    /// Goes back to an older version that has been read, which is a step that can be taken back.
    ///
    /// # Errors
    /// If it cannot take the room's place.
    pub fn take_older(&mut self, older: Older) -> Result<(), RoomError> {
        self.scene.document_mut().end_drag();
        let plan = older_plan(self.scene.document(), older.room, older.version)?;
        self.scene.make(plan, |_: &Room| Ok(older.files))
    }

    /// Whether it may be changed here.
    ///
    /// # Errors
    /// If another window builds in it.
    pub fn check_free(&self) -> Result<(), RoomError> {
        match self.read_only() {
            Some(_) => Err(in_use(self.kept.as_ref())),
            None => Ok(()),
        }
    }
}

/// An older version of a room, with the files that it names.
#[derive(Debug)]
pub struct Older {
    version: Version,
    room: Room,
    files: Assets,
}

/// Reads the older version of that number of the room in a folder, 1 for the newest. Waits for the disk.
///
/// # Errors
/// If there is none of that number, or why it cannot be read.
pub fn find_older(folder: Option<&Path>, number: usize) -> Result<Older, RoomError> {
    let all = folder.map_or_else(Vec::new, versions);
    let found = number.checked_sub(1).and_then(|it| all.get(it));
    let (Some(version), Some(folder)) = (found, folder) else {
        return Err(RoomError::Command(match all.len() {
            0 => "There are no older versions of this room; they are kept while one builds in a room of one's own."
                .to_owned(),
            count => format!("There is no older version {number} of this room; there are 1 to {count}, 1 the newest."),
        }));
    };
    let room = read_version(folder, *version)?;
    let files = assets(folder, &room)?;
    Ok(Older {
        version: *version,
        room,
        files,
    })
}

/// Why a room is not changed here.
pub(super) fn in_use(kept: Option<&RoomSummary>) -> RoomError {
    let name = kept.map_or(NAMELESS, |it| &it.name);
    RoomError::Command(format!(
        "\"{name}\" is being built in by another window of the game, or its folder cannot be written, so it is not changed here. Close it there first, or keep this one under another name."
    ))
}

/// Takes an older version in place of the room, as a step.
pub fn older_plan(
    document: &Document,
    room: Room,
    version: Version,
) -> Result<Plan, WorkshopError> {
    let when = crate::dates::moment(version.when_s);
    document.plan_room(room, Said::new("version").with("when", when))
}
