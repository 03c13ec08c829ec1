//! How a document is kept: each change is handed to a worker, and nobody waits.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_rooms::{Room, RoomError};
use antipode_storage::StorageError;

use crate::document::Document;
use crate::error::WorkshopError;
use crate::history::Step;
use crate::journal::{Keeper, News, Note};

/// What a drag has done is handed over so often.
const DRAG_EVERY: Duration = Duration::from_millis(500);

/// What keeps a document, if anything does. A copy of it keeps nothing.
#[derive(Debug, Default)]
pub(crate) struct Kept(Option<By>);

#[derive(Debug)]
struct By {
    keeper: Keeper,
    dir: PathBuf,
    /// The room that the file has.
    saved: Arc<Room>,
    trouble: Option<Trouble>,
    /// When a drag was handed over last.
    dragged: Option<Instant>,
}

impl Clone for Kept {
    fn clone(&self) -> Self {
        Self(None)
    }
}

/// Why a document is not kept as it should be.
#[derive(Debug)]
pub enum Trouble {
    /// The room could not become the room's file.
    NotSaved(RoomError),
    /// Edits cannot be written down. It is tried again; when that does, this trouble is gone.
    NotWritten(StorageError),
}

impl Kept {
    /// What keeps a document in that folder, whose file has that room.
    pub fn by(keeper: Keeper, dir: PathBuf, saved: Arc<Room>) -> Self {
        Self(Some(By {
            keeper,
            dir,
            saved,
            trouble: None,
            dragged: None,
        }))
    }
}

impl Document {
    /// The folder in which it is kept, if it is.
    pub fn dir(&self) -> Option<&Path> {
        self.kept.0.as_ref().map(|it| it.dir.as_path())
    }

    /// Makes the room as it is now the room's file. Does not wait: [`Self::is_saved`] and [`Self::trouble`] tell what comes of it.
    ///
    /// # Errors
    /// [`WorkshopError::NotKept`].
    pub fn save(&mut self) -> Result<(), WorkshopError> {
        self.end_drag();
        let room = self.room_shared();
        let kept = self.kept.0.as_mut().ok_or(WorkshopError::NotKept)?;
        kept.trouble = None;
        kept.keeper.hand(Note::Save { room, answer: None });
        Ok(())
    }

    /// The same, and waits for it: for scripts, and at the end.
    ///
    /// # Errors
    /// If the room is not sound, names a file that is not there, is kept nowhere, or the disk refuses.
    pub fn save_now(&mut self) -> Result<(), WorkshopError> {
        self.end_drag();
        let room = self.room_shared();
        let kept = self.kept.0.as_mut().ok_or(WorkshopError::NotKept)?;
        kept.trouble = None;
        kept.keeper.saving(room.clone())()?;
        kept.saved = room;
        Ok(())
    }

    /// The same; what is returned waits for it, on any thread.
    ///
    /// # Errors
    /// [`WorkshopError::NotKept`]; later as [`Self::save_now`].
    pub fn saving(
        &mut self,
    ) -> Result<impl FnOnce() -> Result<(), RoomError> + Send + use<>, WorkshopError> {
        self.end_drag();
        let room = self.room_shared();
        let kept = self.kept.0.as_mut().ok_or(WorkshopError::NotKept)?;
        kept.trouble = None;
        Ok(kept.keeper.saving(room))
    }

    /// Waits until all edits are on the disk, as far as that can be written.
    pub fn flush(&mut self) {
        if let Some(kept) = &self.kept.0 {
            kept.keeper.flush();
        }
    }

    /// Takes in what the worker has told. To be called once a frame.
    pub fn poll(&mut self) {
        let Some(kept) = &mut self.kept.0 else {
            return;
        };
        for news in kept.keeper.news() {
            match news {
                News::Saved(room) => kept.saved = room,
                News::NotSaved(error) => kept.trouble = Some(Trouble::NotSaved(error)),
                News::Trouble(error) => kept.trouble = Some(Trouble::NotWritten(error)),
                News::Mended => {
                    kept.trouble
                        .take_if(|it| matches!(it, Trouble::NotWritten(_)));
                }
            }
        }
    }

    /// Why it is not kept as it should be, as far as [`Self::poll`] has heard.
    pub fn trouble(&self) -> Option<&Trouble> {
        self.kept.0.as_ref().and_then(|it| it.trouble.as_ref())
    }

    /// Whether the room's file has the room as it is now, as far as [`Self::poll`] has heard.
    pub fn is_saved(&self) -> bool {
        let saved = self.kept.0.as_ref().map(|it| &it.saved);
        saved.is_some_and(|it| Arc::ptr_eq(it, self.shared()) || **it == *self.room())
    }

    pub(crate) fn keep_step(&mut self, step: &Arc<Step>) {
        let (at, room) = (self.place(), self.room_shared());
        if let Some(kept) = &mut self.kept.0 {
            kept.dragged = None;
            let step = step.clone();
            kept.keeper.hand(Note::Step { at, step, room });
        }
    }

    pub(crate) fn keep_place(&mut self) {
        let (to, room) = (self.place(), self.room_shared());
        if let Some(kept) = &mut self.kept.0 {
            kept.dragged = None;
            kept.keeper.hand(Note::Go { to, room });
        }
    }

    /// Hands over what a drag has done, now and then.
    pub(crate) fn keep_drag(&mut self) {
        let now = Instant::now();
        let is_due = |it: &By| it.dragged.is_none_or(|at| now >= at + DRAG_EVERY);
        if !self.kept.0.as_ref().is_some_and(is_due) {
            return;
        }
        let (at, room, step) = (self.place(), self.room_shared(), self.dragged());
        if let (Some(kept), Some(step)) = (&mut self.kept.0, step) {
            kept.dragged = Some(now);
            kept.keeper.hand(Note::Held { at, step, room });
        }
    }

    pub(crate) fn keep_marks(&mut self) {
        let marks = self.marks();
        let (hidden, locked) = (marks.hidden.clone(), marks.locked.clone());
        if let Some(kept) = &self.kept.0 {
            kept.keeper.hand(Note::Marks { hidden, locked });
        }
    }

    /// How many steps are made since the journal began.
    fn place(&self) -> usize {
        let history = self.history();
        history.forgotten() + history.made()
    }
}
