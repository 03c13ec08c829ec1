//! The room that is open, and the directory of rooms that it comes from and goes to.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_rooms::folder::assets;
use antipode_rooms::{Assets, Loaded, Room, RoomError, RoomSummary, RoomsDir, rooms_dir, shipped};
use glam::DVec3;

use crate::common::Common;

/// What a room is called that has no name yet.
const NAMELESS: &str = "Room";

/// The directory of rooms, and the one that is open.
#[derive(Debug)]
pub struct Rooms {
    dir: RoomsDir,
    open: Option<OpenRoom>,
    /// How many rooms have been opened.
    opened: u64,
    /// What is read in rooms of the game.
    texts: Texts,
}

/// The open room.
#[derive(Debug)]
struct OpenRoom {
    scene: RoomScene,
    /// Where it is kept; none for a room that is not.
    kept: Option<RoomSummary>,
}

impl Rooms {
    /// The directory that the command line, the environment or the platform names.
    pub fn new(common: &Common) -> Self {
        Self {
            dir: RoomsDir::new(rooms_dir(common.saves_dir.as_deref())),
            open: None,
            opened: 0,
            texts: Texts::default(),
        }
    }

    /// Signs in rooms of the game that are entered from now on are in these words.
    pub fn set_texts(&mut self, texts: &Texts) {
        self.texts = texts.clone();
    }

    /// The open room.
    pub fn scene(&mut self) -> Option<&mut RoomScene> {
        self.open.as_mut().map(|open| &mut open.scene)
    }

    /// Tells pictures of what the open room looks like from those of others.
    pub fn look_id(&self) -> (u64, u64) {
        let revision = self.open.as_ref().map_or(0, |open| open.scene.revision());
        (self.opened, revision)
    }

    /// Leaves the open room.
    pub fn close(&mut self) {
        self.open = None;
    }

    /// Every room: the player's own, then those of the game.
    ///
    /// # Errors
    /// When the directory cannot be read.
    pub fn list(&self) -> Result<Vec<RoomSummary>, RoomError> {
        self.dir.list()
    }

    /// Makes a room and enters it; one without a name is not kept.
    ///
    /// # Errors
    /// When the name is taken, or the disk refuses.
    pub fn make(&mut self, name: Option<&str>, gravity: Option<DVec3>) -> Result<(), RoomError> {
        let mut room = Room::new(name.unwrap_or(NAMELESS));
        room.gravity = gravity.unwrap_or(room.gravity);
        let Some(name) = name else {
            let loaded = Loaded {
                room,
                assets: Assets::default(),
                files: Vec::new(),
                bytes: 0,
            };
            return self.enter(loaded, None);
        };
        self.dir.make(&room)?;
        self.load(name)
    }

    /// Enters a room.
    ///
    /// # Errors
    /// When there is none of that name, or it is not sound.
    pub fn load(&mut self, name: &str) -> Result<(), RoomError> {
        let found = self.dir.find(name)?;
        let mut loaded = self.dir.open(&found)?;
        if let Some(it) = shipped::find(&found.slug).filter(|_| found.shipped) {
            it.reword(&mut loaded.room, |key| {
                let key = format!("room-{key}");
                self.texts.has(&key).then(|| self.texts.say(&key))
            });
        }
        self.enter(loaded, Some(found))
    }

    fn enter(&mut self, loaded: Loaded, kept: Option<RoomSummary>) -> Result<(), RoomError> {
        let scene = RoomScene::open(loaded)?;
        self.open = Some(OpenRoom { scene, kept });
        self.opened += 1;
        Ok(())
    }

    /// Keeps the open room as it is now; under another name as another room, which is the open one then. None where no room
    /// is open.
    ///
    /// # Errors
    /// When the room comes with the game or has no name and is given none, the name is taken, or the disk refuses.
    pub fn save(&mut self, name: Option<&str>) -> Option<Result<(), RoomError>> {
        let open = self.open.as_mut()?;
        Some(keep(&self.dir, open, name))
    }

    /// Deletes a room of the player.
    ///
    /// # Errors
    /// When there is none, it is open or comes with the game, or the disk refuses.
    pub fn delete(&mut self, name: &str) -> Result<(), RoomError> {
        let found = self.dir.find(name)?;
        let kept = self.open.as_ref().and_then(|open| open.kept.as_ref());
        if kept.is_some_and(|kept| kept.slug == found.slug && kept.shipped == found.shipped) {
            return Err(RoomError::Command(format!(
                "\"{name}\" is open and cannot be deleted."
            )));
        }
        self.dir.delete(&found)
    }

    /// Changes the open room by the words of a command. None where no room is open.
    ///
    /// # Errors
    /// As [`RoomScene::edit`].
    pub fn edit(&mut self, words: &[&str]) -> Option<Result<(), RoomError>> {
        let open = self.open.as_mut()?;
        // A room that is kept nowhere has no files.
        let own = open.kept.as_ref().filter(|kept| !kept.shipped);
        let dir = self.dir.path().join(own.map_or("", |kept| &kept.slug));
        let read = |room: &Room| assets(&dir, room);
        Some(open.scene.edit(words, read))
    }
}

fn keep(dir: &RoomsDir, open: &mut OpenRoom, name: Option<&str>) -> Result<(), RoomError> {
    let Some(name) = name else {
        return match &open.kept {
            Some(kept) if kept.shipped => Err(RoomError::Shipped(kept.name.clone())),
            Some(kept) => dir.save(&kept.slug, open.scene.room()),
            None => Err(RoomError::Command(
                "This room has no name, so it is not kept; say room save name=...".to_owned(),
            )),
        };
    };
    let mut room = open.scene.room().clone();
    name.trim().clone_into(&mut room.name);
    let slug = match &open.kept {
        // Its files come along.
        Some(kept) if !kept.shipped => copied(dir, kept, &room)?,
        _ => dir.make(&room)?,
    };
    open.scene.rename(name)?;
    open.kept = Some(RoomSummary {
        slug,
        name: room.name,
        sentence: room.sentence,
        objects: room.objects.len(),
        shipped: false,
        problem: None,
    });
    Ok(())
}

/// Makes a copy of a room with its files, under the name that the changed room has.
fn copied(dir: &RoomsDir, kept: &RoomSummary, room: &Room) -> Result<String, RoomError> {
    let slug = dir.double(kept)?;
    let copy = RoomSummary {
        slug: slug.clone(),
        ..kept.clone()
    };
    let made = dir
        .rename(&copy, &room.name)
        .and_then(|()| dir.save(&slug, room));
    if let Err(error) = made {
        dir.delete(&copy)?;
        return Err(error);
    }
    Ok(slug)
}
