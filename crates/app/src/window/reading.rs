//! What somebody asks of the open room that waits for the disk: files that an edit names and nobody has read, older versions, and saving. It is
//! done on a thread, and taken in when that is through; what is asked for after it waits for its turn.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use antipode_room_scene::RoomScene;
use antipode_rooms::folder::assets;
use antipode_rooms::{Assets, Room, RoomError, RoomsDir};
use antipode_ui::ToastKind;
use antipode_ui::workshop::WorkshopWish;
use antipode_workshop::{Edit, Plan, Version, versions};

use super::background::{Progress, Task};
use super::game::Game;
use super::visit::Visit;
use crate::rooms::{Older, Saved, find_older};

/// What is said where the thread that reads has ended without a word.
const DIED: &str = "Something failed while files of the room were read, so the room is as it was.";

/// What is to be done with the room.
#[derive(Clone, Debug, PartialEq)]
pub enum Asked {
    /// An edit by the words of a command.
    Words(Vec<String>),
    /// An edit by hand.
    Edit(Edit),
    /// A way back or forth in the history.
    Step(WorkshopWish),
    /// Its older versions are told.
    Versions,
    /// The older version of that number takes its place.
    Older(usize),
    /// It is saved; under that name as another room.
    Save(Option<String>),
}

/// What was read for it.
#[derive(Debug)]
enum Read {
    Files(Result<Assets, RoomError>),
    Versions(Vec<Version>),
    Older(Result<Older, RoomError>),
    Saved(Result<Saved, RoomError>),
}

/// What came of it.
#[derive(Debug, PartialEq)]
pub enum Done {
    /// The room has changed.
    Changed,
    /// These are its older versions, the newest first.
    Versions(Vec<Version>),
    /// It is saved.
    Saved,
}

/// All that is asked for and not done yet.
#[derive(Debug, Default)]
pub struct Reading {
    waiting: VecDeque<Asked>,
    task: Option<(Asked, Task<Read>)>,
}

impl Reading {
    /// Asks for something.
    pub fn ask(&mut self, asked: Asked) {
        self.waiting.push_back(asked);
    }

    /// Whether there is nothing to do.
    pub fn rests(&self) -> bool {
        self.waiting.is_empty() && self.task.is_none()
    }
}

impl Visit {
    /// Goes on with what is asked of the room. Returns something that is done, or why it could not be.
    fn go_on_reading(&mut self) -> Option<(Asked, Result<Done, RoomError>)> {
        if let Some((_, task)) = &self.reading.task {
            let read = match task.poll() {
                Progress::Running => return None,
                Progress::Done(read) => Some(read),
                Progress::Died => None,
            };
            let (asked, _) = self.reading.task.take()?;
            let done = match read {
                Some(read) => self.take_read(&asked, read),
                None => Err(RoomError::Command(DIED.to_owned())),
            };
            return Some((asked, done));
        }
        let asked = self.reading.waiting.pop_front()?;
        match self.begin(&asked) {
            Ok(Some(done)) => Some((asked, Ok(done))),
            Ok(None) => None,
            Err(why) => Some((asked, Err(why))),
        }
    }

    /// Whether something can be done that is asked for now; what is asked for before it may change that.
    ///
    /// # Errors
    /// Why not.
    pub(super) fn check_asked(&mut self, asked: &Asked) -> Result<(), RoomError> {
        if self.reading.rests() {
            plan(&mut self.room.scene, asked)?;
        }
        Ok(())
    }

    /// Does something at once, if nothing has to be read for it, or has it read.
    fn begin(&mut self, asked: &Asked) -> Result<Option<Done>, RoomError> {
        let folder = self.own_folder();
        match asked {
            Asked::Versions => self.read(asked, move || {
                Read::Versions(folder.map_or_else(Vec::new, |it| versions(&it)))
            }),
            Asked::Older(number) => {
                let number = *number;
                self.read(asked, move || {
                    Read::Older(find_older(folder.as_deref(), number))
                });
            }
            Asked::Save(name) => {
                let dir = RoomsDir::new(self.dir.clone());
                let work = self.room.saving(&dir, name.as_deref())?;
                self.read(asked, move || Read::Saved(work()));
            }
            Asked::Words(_) | Asked::Edit(_) | Asked::Step(_) => {
                let plan = plan(&mut self.room.scene, asked)?;
                if !self.room.scene.lacks_files(&plan) {
                    return self.make(asked, plan, Assets::default()).map(Some);
                }
                let room = Arc::clone(plan.room());
                // A room that is kept nowhere has no files.
                let folder = folder.unwrap_or_default();
                self.read(asked, move || Read::Files(assets(&folder, &room)));
            }
        }
        Ok(None)
    }

    fn read(&mut self, asked: &Asked, work: impl FnOnce() -> Read + Send + 'static) {
        self.reading.task = Some((asked.clone(), Task::start("room-files", work)));
    }

    fn take_read(&mut self, asked: &Asked, read: Read) -> Result<Done, RoomError> {
        match read {
            Read::Versions(all) => Ok(Done::Versions(all)),
            Read::Saved(saved) => {
                let before = self.room.take_saved(saved?)?;
                Task::start("leave", move || drop(before));
                Ok(Done::Saved)
            }
            Read::Older(older) => self.room.take_older(older?).map(|()| Done::Changed),
            Read::Files(files) => {
                let files = files?;
                // The room may have changed since.
                let plan = plan(&mut self.room.scene, asked)?;
                self.make(asked, plan, files)
            }
        }
    }

    fn make(&mut self, asked: &Asked, plan: Plan, files: Assets) -> Result<Done, RoomError> {
        let scene = &mut self.room.scene;
        scene.make(plan, |_: &Room| Ok(files))?;
        let selects = match asked {
            Asked::Edit(edit) => edit.puts_in(),
            Asked::Step(wish) => *wish == WorkshopWish::Redo,
            _ => false,
        };
        if selects {
            scene.document_mut().select_made();
        }
        Ok(Done::Changed)
    }

    fn own_folder(&self) -> Option<PathBuf> {
        let slug = self.own_slug();
        (!slug.is_empty()).then(|| self.dir.join(slug))
    }
}

/// What something that is asked for would do to the room.
fn plan(scene: &mut RoomScene, asked: &Asked) -> Result<Plan, RoomError> {
    let document = scene.document_mut();
    document.end_drag();
    Ok(match asked {
        Asked::Words(words) => {
            let words: Vec<_> = words.iter().map(String::as_str).collect();
            document.plan_words(&words)?
        }
        Asked::Edit(edit) => document.plan(edit)?,
        Asked::Step(WorkshopWish::GoTo(step)) => document.plan_jump(*step),
        Asked::Step(WorkshopWish::Redo) => document.plan_redo(1)?,
        Asked::Step(_) | Asked::Versions | Asked::Older(_) | Asked::Save(_) => {
            document.plan_undo(1)?
        }
    })
}

impl Game {
    /// Asks something of the open room, and does it at once where nothing has to be read for it.
    pub(super) fn ask_of_room(&mut self, asked: Asked) {
        if let Some(visit) = self.play.phase.visit_mut() {
            visit.reading.ask(asked);
        }
        self.go_on_reading();
    }

    /// Goes on with what is asked of the open room, and tells what has come of it where it was asked for.
    pub(super) fn go_on_reading(&mut self) {
        loop {
            let visit = self.play.phase.visit_mut();
            let Some((asked, done)) = visit.and_then(Visit::go_on_reading) else {
                return;
            };
            let visit = self.play.phase.visit_mut();
            if let Some(workshop) = visit.and_then(|visit| visit.workshop.as_mut()) {
                workshop.look_anew();
            }
            match asked {
                Asked::Words(_) | Asked::Versions | Asked::Older(_) | Asked::Save(_) => {
                    self.answer_of_room(done);
                }
                Asked::Edit(_) | Asked::Step(_) => {
                    if let Err(why) = done {
                        self.menus.shell.toast(why.to_string(), ToastKind::State);
                    }
                }
            }
        }
    }
}
