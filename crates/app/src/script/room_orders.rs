//! What scripts do with rooms: enter, keep, list and change them.

use antipode_rooms::RoomError;
use glam::DVec3;

use super::parse::RoomOrder;
use super::run::Runner;
use super::say;
use crate::failure::Failure;

/// What is said where no room is open.
const NO_ROOM: &str = "no room is open; begin with room new or room load";

/// A command that makes no sense is a mistake of the script.
fn told(error: RoomError) -> Failure {
    match error {
        RoomError::Command(what) => Failure::Usage(what),
        other => other.into(),
    }
}

impl Runner {
    /// What `room` does.
    pub(super) fn order_room(&mut self, order: &RoomOrder) -> Result<(), Failure> {
        match order {
            RoomOrder::New { name, gravity } => {
                self.close()?;
                self.controls.release_all();
                let gravity = gravity.map(DVec3::from_array);
                self.rooms.make(name.as_deref(), gravity).map_err(told)
            }
            RoomOrder::Load(name) => {
                self.close()?;
                self.controls.release_all();
                self.rooms.load(name).map_err(told)
            }
            RoomOrder::Save(name) => match self.rooms.save(name.as_deref()) {
                Some(saved) => saved.map_err(told),
                None => Err(Failure::Usage(NO_ROOM.to_owned())),
            },
            RoomOrder::Delete(name) => self.rooms.delete(name).map_err(told),
            RoomOrder::List => say::rooms(&self.rooms.list()?),
            RoomOrder::Versions => match self.rooms.versions() {
                Some(versions) => say::versions(&versions),
                None => Err(Failure::Usage(NO_ROOM.to_owned())),
            },
            RoomOrder::Older(number) => match self.rooms.open_older(*number) {
                Some(opened) => opened.map_err(told),
                None => Err(Failure::Usage(NO_ROOM.to_owned())),
            },
        }
    }

    /// Changes the open room.
    pub(super) fn edit_room(&mut self, words: &[String]) -> Result<(), Failure> {
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        match self.rooms.edit(&words) {
            Some(edited) => edited.map_err(told),
            None => Err(Failure::Usage(NO_ROOM.to_owned())),
        }
    }
}
