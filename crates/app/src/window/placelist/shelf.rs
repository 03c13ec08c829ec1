//! Where places are kept that a list shows: worlds, and rooms. What the list needs to know of each kind, and no more.

use std::path::{Path, PathBuf};

use antipode_language::Texts;
use antipode_rooms::{RoomSummary, RoomsDir};
use antipode_storage::{ArchiveFile, NameError, StorageError, WorldSummary, archives_in};
use antipode_ui::{WorldRow, legible_name};

use super::pictures::PictureSource;
use super::words;
use crate::confined;
use crate::failure::Failure;
use crate::room_portraits;
use crate::session::Worlds;
use crate::wording;

/// What the slug of a room that comes with the game begins with in the menu; no folder's name has a colon.
const SHIPPED: &str = "game:";

/// The picture of a room of the player's own in its folder. No room uses such a file, so no export and no copy has it.
pub const ROOM_PICTURE: &str = "picture.png";

/// What a list knows of one place.
pub trait Kept: Send + std::fmt::Debug + 'static {
    /// What intents carry back.
    fn slug(&self) -> String;
    /// Its name as it is written.
    fn name(&self) -> &str;
    /// What its own records say of it.
    fn row(&self, texts: &Texts) -> WorldRow;

    /// What it is called where it is shown.
    fn shown(&self) -> String {
        legible_name(self.name(), &self.slug()).into_owned()
    }
}

/// Where places of one kind are kept. None of its methods is for the main thread, but for those that touch no disk.
pub trait Shelf: Clone + Send + std::fmt::Debug + 'static {
    /// What is known of a place.
    type Kept: Kept;
    /// What the keys of its words begin with.
    const WORDS: &'static str;
    /// What the names of its archives end in, without the dot.
    const EXTENSION: &'static str;

    /// Its directory. Touches no disk.
    fn path(&self) -> &Path;
    /// Where the picture of one is, if it can have one. Touches no disk.
    fn picture(&self, place: &Self::Kept) -> Option<PictureSource>;
    /// All that is there.
    fn list(&self) -> Result<Vec<Self::Kept>, Failure>;
    /// What is known of one.
    fn find(&self, slug: &str) -> Result<Self::Kept, Failure>;
    /// What only a closer look tells: how much was changed by hand.
    fn edits(&self, slug: &str) -> Option<usize>;
    /// Has it gone.
    fn delete(&self, slug: &str) -> Result<(), Failure>;
    /// Calls it otherwise.
    fn rename(&self, slug: &str, name: &str) -> Result<(), Failure>;
    /// Makes another one like it; its slug.
    fn duplicate(&self, slug: &str) -> Result<String, Failure>;
    /// Writes it into a file, which must not exist.
    fn export(&self, slug: &str, file: &Path) -> Result<(), Failure>;
    /// Makes one of a file; its slug.
    fn import(&self, file: &Path) -> Result<String, Failure>;
    /// The words for a failure. Touches no disk.
    fn failure(texts: &Texts, failure: &Failure, known: &[Self::Kept]) -> String;
    /// The words for a name that will not do. Touches no disk.
    fn name_words(texts: &Texts, error: &NameError, known: &[Self::Kept]) -> String;

    /// The archives in a directory.
    fn archives(dir: &Path) -> Vec<ArchiveFile> {
        archives_in(dir, Self::EXTENSION)
    }
}

impl Kept for WorldSummary {
    fn slug(&self) -> String {
        self.slug.clone()
    }

    fn name(&self) -> &str {
        self.name()
    }

    fn row(&self, texts: &Texts) -> WorldRow {
        words::world_row(texts, self)
    }
}

impl Shelf for Worlds {
    type Kept = WorldSummary;
    const WORDS: &'static str = "worlds";
    const EXTENSION: &'static str = antipode_storage::ARCHIVE_EXTENSION;

    fn path(&self) -> &Path {
        self.saves().path()
    }

    fn picture(&self, world: &WorldSummary) -> Option<PictureSource> {
        world.thumbnail.clone().map(PictureSource::File)
    }

    fn list(&self) -> Result<Vec<WorldSummary>, Failure> {
        Worlds::list(self)
    }

    fn find(&self, slug: &str) -> Result<WorldSummary, Failure> {
        Ok(self.saves().find_slug(slug)?)
    }

    fn edits(&self, slug: &str) -> Option<usize> {
        self.saves().edited_chunks(slug).ok().flatten()
    }

    fn delete(&self, slug: &str) -> Result<(), Failure> {
        Ok(self.saves().delete(slug)?)
    }

    fn rename(&self, slug: &str, name: &str) -> Result<(), Failure> {
        Ok(self.saves().rename(slug, name)?)
    }

    fn duplicate(&self, slug: &str) -> Result<String, Failure> {
        Ok(self.saves().duplicate(slug)?)
    }

    fn export(&self, slug: &str, file: &Path) -> Result<(), Failure> {
        Ok(self.saves().export(slug, file)?)
    }

    fn import(&self, file: &Path) -> Result<String, Failure> {
        confined::import(self.saves(), file)
    }

    fn failure(texts: &Texts, failure: &Failure, known: &[WorldSummary]) -> String {
        wording::failure(texts, failure, known)
    }

    fn name_words(texts: &Texts, error: &NameError, known: &[WorldSummary]) -> String {
        wording::name(texts, error, known)
    }
}

impl Kept for RoomSummary {
    fn slug(&self) -> String {
        if self.shipped {
            format!("{SHIPPED}{}", self.slug)
        } else {
            self.slug.clone()
        }
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn row(&self, texts: &Texts) -> WorldRow {
        words::room_row(texts, self)
    }
}

/// The player's rooms and those of the game.
#[derive(Clone, Debug)]
pub struct RoomShelf(RoomsDir);

impl RoomShelf {
    /// The rooms that go with those worlds.
    pub fn new(worlds: &Worlds) -> Self {
        Self(worlds.rooms())
    }

    /// The file of the picture of a room of the player's own.
    fn picture_file(&self, slug: &str) -> PathBuf {
        self.0.path().join(slug).join(ROOM_PICTURE)
    }
}

impl Shelf for RoomShelf {
    type Kept = RoomSummary;
    const WORDS: &'static str = "rooms";
    const EXTENSION: &'static str = antipode_rooms::ARCHIVE_EXTENSION;

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn picture(&self, room: &RoomSummary) -> Option<PictureSource> {
        if room.shipped {
            room_portraits::of(&room.slug).map(PictureSource::Game)
        } else {
            Some(PictureSource::File(self.picture_file(&room.slug)))
        }
    }

    fn list(&self) -> Result<Vec<RoomSummary>, Failure> {
        Ok(self.0.list()?)
    }

    fn find(&self, slug: &str) -> Result<RoomSummary, Failure> {
        room_of(&self.0, slug)
    }

    fn edits(&self, slug: &str) -> Option<usize> {
        self.find(slug).ok().map(|room| room.objects)
    }

    fn delete(&self, slug: &str) -> Result<(), Failure> {
        Ok(self.0.delete(&self.find(slug)?)?)
    }

    fn rename(&self, slug: &str, name: &str) -> Result<(), Failure> {
        Ok(self.0.rename(&self.find(slug)?, name)?)
    }

    fn duplicate(&self, slug: &str) -> Result<String, Failure> {
        let room = self.find(slug)?;
        let made = self.0.double(&room)?;
        let copied = match self.picture(&room) {
            Some(PictureSource::Game(bytes)) => Some(bytes.to_vec()),
            Some(PictureSource::File(file)) => std::fs::read(file).ok(),
            None => None,
        };
        if let Some(bytes) = copied
            && let Err(why) = antipode_storage::replace_file(&self.picture_file(&made), &bytes)
        {
            tracing::info!("the copy of the room has no picture: {why}");
        }
        Ok(made)
    }

    fn export(&self, slug: &str, file: &Path) -> Result<(), Failure> {
        Ok(self.0.export(&self.find(slug)?, file)?)
    }

    fn import(&self, file: &Path) -> Result<String, Failure> {
        confined::import_room(&self.0, file)
    }

    fn failure(texts: &Texts, failure: &Failure, _: &[RoomSummary]) -> String {
        wording::failure(texts, failure, &[])
    }

    fn name_words(texts: &Texts, error: &NameError, _: &[RoomSummary]) -> String {
        match error {
            NameError::Taken { existing } => texts.say_with(
                "room-name-taken",
                &[("name", legible_name(existing, "").into())],
            ),
            _ => wording::name(texts, error, &[]),
        }
    }
}

/// The room that a menu's slug is of.
///
/// # Errors
/// When it is not there any more.
pub fn room_of(dir: &RoomsDir, slug: &str) -> Result<RoomSummary, Failure> {
    let rooms = dir.list()?;
    let found = rooms.into_iter().find(|room| Kept::slug(room) == slug);
    found.ok_or_else(|| {
        StorageError::NotFound {
            world: slug.trim_start_matches(SHIPPED).to_owned(),
            dir: dir.path().to_path_buf(),
        }
        .into()
    })
}
