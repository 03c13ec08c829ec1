//! A drag: many changes while a hand moves, which are one step in the end.

use std::sync::Arc;

use antipode_rooms::{Room, check_each};

use crate::document::Document;
use crate::edit::Edit;
use crate::error::{WorkshopError, refuse};
use crate::history::Step;
use crate::make::make;
use crate::plan::{Plan, Planned, unsound};
use crate::telling::told;
use crate::{Delta, Said};

/// A drag that goes on.
#[derive(Debug, Clone)]
pub(crate) struct Drag {
    /// The room as it was before.
    pub before: Arc<Room>,
    /// What was done last.
    pub said: Option<Said>,
}

impl Document {
    /// Begins a drag. One that goes on ends as a step first.
    pub fn begin_drag(&mut self) {
        self.end_drag();
        self.drag = Some(Drag {
            before: self.room_shared(),
            said: None,
        });
    }

    /// Whether a drag goes on.
    pub fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// The room as it was before the drag that goes on; as it is if none does.
    pub fn room_before_drag(&self) -> &Room {
        self.drag
            .as_ref()
            .map_or_else(|| self.room(), |it| &it.before)
    }

    /// What an edit would do that counts from the room before the drag: the next takes its place.
    ///
    /// # Errors
    /// As [`Document::plan`]; and if no drag goes on.
    pub fn plan_drag(&self, edit: &Edit) -> Result<Plan, WorkshopError> {
        let Some(drag) = &self.drag else {
            return refuse("No drag goes on.");
        };
        self.free(edit)?;
        let room = make(&drag.before, edit)?;
        check_each(&room).map_err(|it| unsound(&it))?;
        Ok(Plan {
            room: Arc::new(room),
            what: Planned::Drag(told(&drag.before, edit)),
            revision: self.revision(),
        })
    }

    /// Goes on with the drag: the room is what the edit makes of the room before it.
    ///
    /// # Errors
    /// As [`Self::plan_drag`]; the room is as it was then.
    pub fn drag(&mut self, edit: &Edit) -> Result<(), WorkshopError> {
        let plan = self.plan_drag(edit)?;
        self.commit(plan)
    }

    /// Ends the drag; whether it is a step, since it changed something.
    pub fn end_drag(&mut self) -> bool {
        let Some(step) = self.dragged() else {
            self.drag = None;
            return false;
        };
        self.drag = None;
        self.add_step(step);
        true
    }

    /// Ends the drag and takes back what it did.
    pub fn cancel_drag(&mut self) {
        if let Some(drag) = self.drag.take() {
            self.take_room(drag.before);
            self.keep_place();
        }
    }

    /// What the drag has done so far as a step.
    pub(crate) fn dragged(&self) -> Option<Arc<Step>> {
        let drag = self.drag.as_ref()?;
        let said = drag.said.clone()?;
        let delta = Delta::between(&drag.before, self.room());
        (!delta.is_empty()).then(|| Arc::new(Step { said, delta }))
    }
}
