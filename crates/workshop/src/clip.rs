//! What was copied: objects with all that they carry, in the axes of the room they were copied from, as text, so that it can
//! lie in the clipboard of the system, too.

use std::sync::Arc;

use antipode_rooms::{Object, Room, What, read_so_far, write_so_far};

use crate::copies::{carried, into_room};
use crate::error::WorkshopError;

/// The longest text that is taken for copied objects, bytes.
const MOST_BYTES: usize = 2 << 20;
/// What a room of copied objects is called.
const NAME: &str = "Clip";

/// Copied objects.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Clip {
    /// In the order of the room they are from; those that no other of them carries are in no group.
    pub(crate) objects: Vec<Arc<Object>>,
}

impl Clip {
    /// Copies objects, groups with all that they carry.
    pub fn of(room: &Room, names: &[String]) -> Self {
        let picked = carried(room, names);
        Self {
            objects: into_room(room, &picked),
        }
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.objects.is_empty()
    }

    /// The objects in it.
    pub fn objects(&self) -> &[Arc<Object>] {
        &self.objects
    }

    /// The same under other names.
    #[must_use]
    pub fn renamed(&self, called: impl Fn(&str) -> String) -> Self {
        let mut objects = self.objects.clone();
        for object in objects.iter_mut().map(Arc::make_mut) {
            object.name = called(&object.name);
            object.group = object.group.as_deref().map(&called);
            if let What::Portal(portal) = &mut object.what {
                portal.to = called(&portal.to);
            }
        }
        Self { objects }
    }

    /// It as text, the file of a room with these objects only.
    pub fn text(&self) -> String {
        let mut room = Room::new(NAME);
        room.objects.clone_from(&self.objects);
        write_so_far(&room)
    }

    /// Copied objects from text. The text of any room will do.
    ///
    /// # Errors
    /// If it is not that of a room.
    pub fn parse(text: &str) -> Result<Self, WorkshopError> {
        if text.len() > MOST_BYTES {
            return crate::error::refuse("What was copied is no part of a room: it is too long.");
        }
        let room = read_so_far("clipboard", text.as_bytes())?;
        Ok(Self {
            objects: room.objects,
        })
    }
}
