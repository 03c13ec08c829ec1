//! A room that is being edited: the one way in which it changes.

use std::collections::HashSet;
use std::sync::Arc;

use antipode_rooms::{Object, Room};

use crate::clip::Clip;
use crate::drag::Drag;
use crate::edit::Edit;
use crate::error::{WorkshopError, refuse};
use crate::history::{History, Step};
pub(crate) use crate::keeping::Kept;
use crate::marks::Marks;
use crate::plan::{Plan, Planned};

/// A room that is being edited. A copy of it is kept nowhere.
#[derive(Debug, Clone)]
pub struct Document {
    room: Arc<Room>,
    history: History,
    marks: Marks,
    pub(crate) clipboard: Clip,
    pub(crate) drag: Option<Drag>,
    pub(crate) kept: Kept,
    revision: u64,
}

impl Document {
    /// Edits a room that is kept nowhere.
    pub fn new(room: Room) -> Self {
        Self::of(Arc::new(room), History::default())
    }

    pub(crate) fn of(room: Arc<Room>, history: History) -> Self {
        Self {
            room,
            history,
            marks: Marks::default(),
            clipboard: Clip::default(),
            drag: None,
            kept: Kept::default(),
            revision: 0,
        }
    }

    /// The room as it is now.
    pub fn room(&self) -> &Room {
        &self.room
    }

    /// The same, to be kept by others as it is now.
    pub fn room_shared(&self) -> Arc<Room> {
        self.room.clone()
    }

    pub(crate) fn shared(&self) -> &Arc<Room> {
        &self.room
    }

    /// Counts changes of the room.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// All steps, and how many of them are made.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// What is selected, hidden and locked.
    pub fn marks(&self) -> &Marks {
        &self.marks
    }

    pub(crate) fn marks_mut(&mut self) -> &mut Marks {
        &mut self.marks
    }

    /// Makes an edit as one step. What changes nothing is none.
    ///
    /// # Errors
    /// As [`Self::plan`]; the document is as it was then.
    pub fn edit(&mut self, edit: &Edit) -> Result<(), WorkshopError> {
        self.end_drag();
        let plan = self.plan(edit)?;

        self.commit(plan)?;
        if edit.puts_in() {
            self.select_made();
        }
        Ok(())
    }

    /// Does what the words of a command say: an edit, `undo` or `redo`.
    ///
    /// # Errors
    /// As [`Self::plan_words`]; the document is as it was then.
    pub fn command(&mut self, words: &[&str]) -> Result<(), WorkshopError> {
        self.end_drag();
        let plan = self.plan_words(words)?;
        self.commit(plan)
    }

    /// Takes steps back; all, if there are fewer.
    ///
    /// # Errors
    /// If there is none.
    pub fn undo(&mut self, count: usize) -> Result<(), WorkshopError> {
        self.end_drag();
        let plan = self.plan_undo(count)?;
        self.commit(plan)
    }

    /// Makes steps again; all, if there are fewer.
    ///
    /// # Errors
    /// If there is none.
    pub fn redo(&mut self, count: usize) -> Result<(), WorkshopError> {
        self.end_drag();
        let plan = self.plan_redo(count)?;
        self.commit(plan)
    }

    /// Goes to where the first `to` steps are made; to the last, if there are fewer.
    ///
    /// # Errors
    /// None that a caller could cause.
    pub fn jump(&mut self, to: usize) -> Result<(), WorkshopError> {
        self.end_drag();
        let plan = self.plan_jump(to);
        self.commit(plan)
    }

    /// Makes what was planned.
    ///
    /// # Errors
    /// If the document has changed since.
    pub fn commit(&mut self, plan: Plan) -> Result<(), WorkshopError> {
        if plan.revision != self.revision {
            return refuse("The room has changed meanwhile. Do that again.");
        }
        match plan.what {
            Planned::Step(step) if step.delta.is_empty() => {}
            Planned::Step(step) => {
                // Before what is not there under its old name is forgotten.
                self.marks.follow(&step.delta, false);
                self.take_room(plan.room);
                self.add_step(step);
            }
            Planned::Go(to) => self.go(plan.room, to),
            Planned::Drag(said) => {
                self.take_room(plan.room);
                if let Some(drag) = &mut self.drag {
                    drag.said = Some(said);
                }
                self.keep_drag();
            }
        }
        Ok(())
    }

    fn go(&mut self, room: Arc<Room>, to: usize) {
        let made = self.history.made();
        let (first, last, back) = (to.min(made), to.max(made), to < made);
        let steps: Vec<_> = self.history.steps()[first..last].to_vec();
        let in_order: Box<dyn Iterator<Item = &Arc<Step>>> = if back {
            Box::new(steps.iter().rev())
        } else {
            Box::new(steps.iter())
        };
        in_order.for_each(|it| self.marks.follow(&it.delta, back));
        self.history.go(to);
        self.take_room(room);
        self.keep_place();
    }

    /// Adds a step that is made already.
    pub(crate) fn add_step(&mut self, step: Arc<Step>) {
        self.keep_step(&step);
        self.history.push(step);
    }

    pub(crate) fn take_room(&mut self, room: Arc<Room>) {
        let was = std::mem::replace(&mut self.room, room);
        self.revision += 1;
        if !was.names().eq(self.room.names()) {
            self.marks.forget(&self.room);
        }
    }

    /// Selects what the last step has put in, as far as no other of it carries it.
    pub fn select_made(&mut self) {
        let last = self.history.made().checked_sub(1);
        let Some(step) = last.and_then(|it| self.history.steps().get(it)).cloned() else {
            return;
        };
        let new: Vec<_> = step.delta.inserted.iter().map(|(_, it)| it).collect();
        let within: HashSet<&str> = new.iter().map(|it| it.name.as_str()).collect();
        let is_carried = |it: &Object| it.group.as_deref().is_some_and(|it| within.contains(it));
        let roots = new.iter().filter(|it| !is_carried(it));
        let names: Vec<_> = roots.map(|it| it.name.clone()).collect();
        if !names.is_empty() {
            self.select(names);
        }
    }
}
