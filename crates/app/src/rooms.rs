//! The room that is open, and the directory of rooms that it comes from and goes to.

mod kept;
mod saving;

use antipode_rays::{Options, Outlines, View};
use antipode_room_scene::{Moment, RoomScene, RoomViewing, Steer};
use antipode_rooms::folder::assets;
use antipode_rooms::{Assets, Loaded, Room, RoomError, RoomSummary, RoomsDir, rooms_dir};
use antipode_scene::Actions;
use antipode_scene::frame::Quality;
use antipode_settings::Settings;
use antipode_workshop::{Document, Version, WorkshopError};
use glam::DVec3;

use crate::common::Common;
pub use kept::{Older, RoomNote, find_older, older_plan};
pub use saving::Saved;

/// Mirrors and panes in a row that *exact* pictures follow.
const MOST_BOUNCES: u32 = 4;
/// What a room is called that has no name yet.
const NAMELESS: &str = "Room";

/// The directory of rooms, and the one that is open.
#[derive(Debug)]
pub struct Rooms {
    dir: RoomsDir,
    open: Option<OpenRoom>,
    /// How many rooms have been opened.
    opened: u64,
    /// How often what is read in rooms was to be in another language.
    reworded: u64,
}

/// An open room.
#[derive(Debug)]
pub struct OpenRoom {
    /// What happens in it.
    pub scene: RoomScene,
    /// Where it is kept; none for a room that is not.
    pub kept: Option<RoomSummary>,
    /// By which rule it is looked at.
    pub look: View,
    /// Of which aberrations the outlines are shown.
    pub outlines: Outlines,
    /// What there is to tell of how it was found.
    pub notes: Vec<RoomNote>,
}

/// What a step of a room takes of what is held and turned.
fn steer(actions: &Actions) -> Steer {
    Steer {
        forward: actions.forward,
        strafe: actions.strafe,
        sprint: actions.sprint,
        jump: actions.jump,
        look_yaw_rad: actions.look_yaw,
        look_pitch_rad: actions.look_pitch,
        shoot: actions.primary,
        place: actions.secondary,
        throw: actions.drop_one,
        grasp: actions.grasp,
    }
}

/// The ways to look at a room, one after another.
fn next_look(look: View) -> View {
    match look {
        View::Exact => View::Split,
        View::Split => View::Thesis,
        View::Thesis => View::Plain,
        View::Plain => View::Exact,
    }
}

impl OpenRoom {
    /// Makes a room and enters it; one without a name is not kept.
    ///
    /// # Errors
    /// When the name is taken, or the disk refuses.
    pub fn make(
        dir: &RoomsDir,
        name: Option<&str>,
        gravity: Option<DVec3>,
    ) -> Result<Self, RoomError> {
        let mut room = Room::new(name.unwrap_or(NAMELESS));
        room.gravity = gravity.unwrap_or(room.gravity);
        let Some(name) = name else {
            let loaded = Loaded {
                room,
                assets: Assets::default(),
                files: Vec::new(),
                bytes: 0,
            };
            return Ok(Self::of(loaded, None));
        };
        dir.make(&room)?;
        let kept = dir.find(name)?;
        Ok(Self::of(dir.open(&kept)?, Some(kept)))
    }

    /// Enters a room that is kept.
    ///
    /// # Errors
    /// When it is not there any more, or not sound.
    pub fn enter(dir: &RoomsDir, kept: RoomSummary) -> Result<Self, RoomError> {
        Ok(Self::of(dir.open(&kept)?, Some(kept)))
    }

    /// Enters a room that is kept, so that it can be built in: one of the player's own has its journal, and all that was done to
    /// it can be taken back. Waits for the disk.
    ///
    /// # Errors
    /// When it is not there any more or not sound, or another game builds in it.
    pub fn enter_with_journal(dir: &RoomsDir, kept: RoomSummary) -> Result<Self, RoomError> {
        if kept.shipped {
            return Self::enter(dir, kept);
        }
        let folder = dir.path().join(&kept.slug);
        let opened = match Document::open(&folder) {
            Ok(opened) => opened,
            Err(WorkshopError::Room(why)) => return Err(why),
            // It can be walked through.
            Err(WorkshopError::InUse(_)) => {
                let mut room = Self::enter(dir, kept)?;
                room.notes.push(RoomNote::InUse);
                return Ok(room);
            }
            Err(why) => {
                let mut room = Self::enter(dir, kept)?;
                room.notes.push(RoomNote::NoJournal(why.to_string()));
                return Ok(room);
            }
        };
        let files = assets(&folder, opened.document.room())?;
        let notes = [
            opened.aside.map(RoomNote::Aside),
            opened.was_changed.then_some(RoomNote::Changed),
            (opened.is_ahead && !opened.was_changed).then_some(RoomNote::Ahead),
        ];
        Ok(Self {
            scene: RoomScene::of(opened.document, files),
            kept: Some(kept),
            look: View::Exact,
            outlines: Outlines::default(),
            notes: notes.into_iter().flatten().collect(),
        })
    }

    fn of(loaded: Loaded, kept: Option<RoomSummary>) -> Self {
        Self {
            scene: RoomScene::open(loaded),
            kept,
            look: View::Exact,
            outlines: Outlines::default(),
            notes: Vec::new(),
        }
    }

    /// Pictures of it are made as the player has chosen for worlds.
    pub fn fit(&mut self, settings: &Settings) {
        let viewing = crate::options::viewing(settings);
        self.scene.set_viewing(RoomViewing {
            fov_y_rad: viewing.fov_y_rad,
            reduced_motion: viewing.reduced_motion,
        });
    }

    /// One step of who does that.
    pub fn step(&mut self, actions: &Actions) {
        if actions.turn_map {
            self.look = next_look(self.look);
        }
        if actions.flip_car {
            self.scene.begin_anew();
        }
        if actions.toggle_camera {
            let third_person = !self.scene.third_person();
            self.scene.set_third_person(third_person);
        }
        self.scene.step(&steer(actions));
    }

    /// What a picture of a moment of it shows: what is held before the eye only where `with_hand` asks for it, and by the exact
    /// rule, since by others it would be bent by what the eye is in.
    pub fn shown(&self, mut moment: Moment, with_hand: bool) -> Moment {
        let has_hand = with_hand && self.look == View::Exact;
        moment.hand = moment.hand.filter(|_| has_hand);
        moment
    }

    /// How pictures of it are made in that quality, with so many samples a pixel.
    pub fn picture_options(&self, quality: Quality, samples: u32) -> Options {
        Options {
            bounces: match quality {
                Quality::Exact => MOST_BOUNCES,
                Quality::Fast | Quality::Balanced => 0,
            },
            samples,
            view: self.look,
            outlines: self.outlines,
            raster: true,
            as_compiled: false,
        }
    }
}

impl Rooms {
    /// The directory that the command line, the environment or the platform names.
    pub fn new(common: &Common) -> Self {
        Self {
            dir: RoomsDir::new(rooms_dir(common.saves_dir.as_deref())),
            open: None,
            opened: 0,
            reworded: 0,
        }
    }

    /// What is read in rooms is in another language from now on.
    pub fn reword(&mut self) {
        self.reworded += 1;
    }

    /// The open room, as it is played.
    pub fn open_room(&mut self) -> Option<&mut OpenRoom> {
        self.open.as_mut()
    }

    /// What happens in the open room.
    pub fn scene(&mut self) -> Option<&mut RoomScene> {
        self.open.as_mut().map(|open| &mut open.scene)
    }

    /// Tells pictures of what the open room looks like from those of others.
    pub fn look_id(&self) -> (u64, u64) {
        let revision = self.open.as_ref().map_or(0, |open| open.scene.revision());
        (self.opened, revision + self.reworded)
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
        let made = OpenRoom::make(&self.dir, name, gravity)?;
        self.take(made);
        Ok(())
    }

    /// Enters a room.
    ///
    /// # Errors
    /// When there is none of that name, or it is not sound.
    pub fn load(&mut self, name: &str) -> Result<(), RoomError> {
        let found = self.dir.find(name)?;
        let entered = OpenRoom::enter(&self.dir, found)?;
        self.take(entered);
        Ok(())
    }

    fn take(&mut self, room: OpenRoom) {
        self.open = Some(room);
        self.opened += 1;
    }

    /// Keeps the open room as it is now; under another name as another room, which is the open one then. None where no room
    /// is open.
    ///
    /// # Errors
    /// When the room comes with the game or has no name and is given none, the name is taken, or the disk refuses.
    pub fn save(&mut self, name: Option<&str>) -> Option<Result<(), RoomError>> {
        let open = self.open.as_mut()?;
        Some(open.save(&self.dir, name))
    }

    /// Older versions of the open room, the newest first. None where no room is open.
    pub fn versions(&self) -> Option<Vec<Version>> {
        Some(self.open.as_ref()?.versions(&self.dir))
    }

    /// Goes back to an older version of the open room. None where no room is open.
    ///
    /// # Errors
    /// As [`OpenRoom::open_older`].
    pub fn open_older(&mut self, number: usize) -> Option<Result<(), RoomError>> {
        let open = self.open.as_mut()?;
        Some(open.open_older(&self.dir, number))
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
        Some(open.edit(&self.dir, words))
    }
}

impl OpenRoom {
    /// Changes it by the words of a command.
    ///
    /// # Errors
    /// As [`RoomScene::edit`].
    pub fn edit(&mut self, dir: &RoomsDir, words: &[&str]) -> Result<(), RoomError> {
        self.check_free()?;
        // A room that is kept nowhere has no files.
        let own = self.kept.as_ref().filter(|kept| !kept.shipped);
        let dir = dir.path().join(own.map_or("", |kept| &kept.slug));
        self.scene.edit(words, |room: &Room| assets(&dir, room))
    }
}

#[cfg(test)]
mod tests;
