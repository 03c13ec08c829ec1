//! What is about to be done to a document: the room as it will be, so that whoever shows it can refuse what they cannot show.

use std::collections::BTreeSet;
use std::sync::Arc;

use antipode_rooms::{Fault, Room, RoomError, What, check_each, check_so_far};

use crate::document::Document;
use crate::edit::Edit;
use crate::error::WorkshopError;
use crate::history::Step;
use crate::make::make;
use crate::telling::told;
use crate::words::{Command, parse};
use crate::{Delta, Said};

/// A change of a document that can be made.
#[derive(Debug, Clone)]
pub struct Plan {
    pub(crate) room: Arc<Room>,
    pub(crate) what: Planned,
    /// Of which revision of the document.
    pub(crate) revision: u64,
}

#[derive(Debug, Clone)]
pub(crate) enum Planned {
    /// A step is made.
    Step(Arc<Step>),
    /// So many steps are made then.
    Go(usize),
    /// A drag goes on.
    Drag(Said),
}

impl Plan {
    /// The room as it will be.
    pub fn room(&self) -> &Arc<Room> {
        &self.room
    }

    /// Whether the room names other files than now.
    pub fn names_other_files(&self, document: &Document) -> bool {
        files(&self.room) != files(document.room())
    }
}

/// The files that a room names, each once.
fn files(room: &Room) -> BTreeSet<&str> {
    let models = room.objects.iter().filter_map(|it| match &it.what {
        What::Model { file, .. } => Some(file.as_str()),
        _ => None,
    });
    let textures = room
        .objects
        .iter()
        .filter_map(|it| it.surface.texture.as_ref());
    models.chain(textures.map(|it| it.file.as_str())).collect()
}

impl Document {
    /// What an edit would do.
    ///
    /// # Errors
    /// If it makes no sense, would leave numbers that no room may have, or touches what is locked.
    pub fn plan(&self, edit: &Edit) -> Result<Plan, WorkshopError> {
        self.free(edit)?;
        let room = make(self.room(), edit)?;
        check_each(&room).map_err(|it| unsound(&it))?;
        Ok(self.planned(room, told(self.room(), edit)))
    }

    /// What the words of a command would do.
    ///
    /// # Errors
    /// As [`Self::plan`]; and if the command would leave aberrations or portals that do not fit, as [`antipode_rooms::space_so_far`]
    /// says, and the room as it is has none such.
    pub fn plan_words(&self, words: &[&str]) -> Result<Plan, WorkshopError> {
        match parse(self.room(), words)? {
            Command::Undo(count) => self.plan_undo(count),
            Command::Redo(count) => self.plan_redo(count),
            Command::Edit(edit) => {
                let plan = self.plan(&edit)?;
                match check_so_far(&plan.room) {
                    Err(fault) if check_so_far(self.room()).is_ok() => Err(unsound(&fault)),
                    _ => Ok(plan),
                }
            }
        }
    }

    /// What taking steps back would do; all, if there are fewer.
    ///
    /// # Errors
    /// If there is none.
    pub fn plan_undo(&self, count: usize) -> Result<Plan, WorkshopError> {
        match self.history().made() {
            0 => Err(WorkshopError::NoStep("undo")),
            made => Ok(self.plan_jump(made.saturating_sub(count))),
        }
    }

    /// What making steps again would do; all, if there are fewer.
    ///
    /// # Errors
    /// If there is none.
    pub fn plan_redo(&self, count: usize) -> Result<Plan, WorkshopError> {
        let history = self.history();
        if history.made() == history.steps().len() {
            return Err(WorkshopError::NoStep("redo"));
        }
        Ok(self.plan_jump(history.made().saturating_add(count)))
    }

    /// What going to where the first `to` steps are made would do; to the last, if there are fewer.
    pub fn plan_jump(&self, to: usize) -> Plan {
        let to = to.min(self.history().steps().len());
        Plan {
            room: Arc::new(self.history().room_at(self.room(), to)),
            what: Planned::Go(to),
            revision: self.revision(),
        }
    }

    /// What taking another room in place of this one would do, as one step that is told so.
    ///
    /// # Errors
    /// If it has numbers that no room may have.
    pub fn plan_room(&self, room: Room, said: Said) -> Result<Plan, WorkshopError> {
        check_each(&room).map_err(|it| unsound(&it))?;
        Ok(self.planned(room, said))
    }

    fn planned(&self, room: Room, said: Said) -> Plan {
        let delta = Delta::between(self.room(), &room);
        Plan {
            room: Arc::new(room),
            what: Planned::Step(Arc::new(Step { said, delta })),
            revision: self.revision(),
        }
    }

    /// Whether nothing that it touches is locked.
    pub(crate) fn free(&self, edit: &Edit) -> Result<(), WorkshopError> {
        if self.marks().locked.is_empty() {
            return Ok(());
        }
        let touched = edit.touched();
        match touched
            .iter()
            .find(|it| self.marks().is_locked(self.room(), it))
        {
            Some(name) => Err(WorkshopError::Locked((*name).to_owned())),
            None => Ok(()),
        }
    }
}

/// A fault as a sentence of its own.
pub(crate) fn unsound(fault: &Fault) -> WorkshopError {
    let said = fault.to_string();
    let mut letters = said.chars();
    let said = letters
        .next()
        .map(|it| it.to_uppercase().chain(letters).collect())
        .unwrap_or_default();
    RoomError::Command(said).into()
}
