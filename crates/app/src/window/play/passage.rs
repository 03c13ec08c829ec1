//! The way into worlds and rooms and out of them again, without losing anything on the way.

use std::time::Duration;

use antipode_rooms::RoomsDir;
use antipode_settings::Settings;
use antipode_ui::{Screen, ToastKind, legible_name};

use super::super::background::{Progress, Task};
use super::super::menus::Menus;
use super::super::phase::{Closing, Next, Opened, Opening, Phase, Request};
use super::super::placelist::room_of;
use super::super::veil::Veil;
use super::super::visit::Visit;
use super::super::workshop::note;
use super::{CHUNK_BUDGET, Play};
use crate::failure::Failure;
use crate::options;
use crate::rooms::OpenRoom;
use crate::session::{Session, Unclosed, Worlds};
use crate::wording;

/// Longest time that a world which is closed waits for its picture; it is saved already then.
const PATIENCE: Duration = Duration::from_secs(5);

impl Play {
    /// Begins to open a world or a room.
    pub fn open(&mut self, request: Request, menus: &mut Menus) {
        self.phase = self.begin(request, menus);
    }

    /// Closes what is open, then goes on.
    pub fn leave(&mut self, next: Next, menus: &mut Menus) {
        self.phase = match std::mem::take(&mut self.phase) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.close(session, next, menus)
            }
            Phase::Opening(task) => {
                // A world being opened is closed again as soon as it is there; nothing of it is lost.
                self.opened += 1;
                menus.say_saving();
                let closing = Task::start("close", move || match task.finish() {
                    Some(Ok(Opened::World(session))) => session.close(),
                    _ => Ok(()),
                });
                Phase::Closing(closing, next)
            }
            Phase::Closing(task, _) => Phase::Closing(task, next),
            Phase::Menu => self.go_on(next, menus),
            Phase::InRoom(mut visit) | Phase::RoomPaused(mut visit) => {
                let builds = visit.workshop.is_some();
                visit.keep_at_last();
                // What is not written yet is waited for elsewhere.
                Task::start("leave", move || drop(visit));
                let phase = self.go_on(next, menus);
                if matches!(phase, Phase::Menu) {
                    // The next room is chosen there.
                    menus.shell.open(if builds {
                        Screen::Workshop
                    } else {
                        Screen::Rooms
                    });
                }
                phase
            }
            Phase::Over => Phase::Over,
        };
    }

    /// Leaves a world that cannot be saved, without what is not saved.
    pub fn abandon(&mut self, menus: &mut Menus) {
        let next = self.held_up.take().unwrap_or(Next::Menu);
        self.phase = match std::mem::take(&mut self.phase) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                menus.busy("busy-leaving", None, String::new());
                let task = Task::start("leave", move || {
                    drop(session);
                    Ok(())
                });
                Phase::Closing(task, next)
            }
            other => other,
        };
    }

    /// Nothing can be shown any more: nothing will be asked.
    pub fn end_unseen(&mut self, menus: &mut Menus) {
        self.unseen = true;
        self.portrait.miss();
        self.leave(Next::Quit, menus);
    }

    /// Waits until what is being closed is on disk.
    pub fn finish(&mut self) {
        if let Phase::Closing(task, _) = std::mem::take(&mut self.phase) {
            self.last_words = match task.finish() {
                Some(Ok(())) => return,
                Some(Err(unclosed)) => Some(unclosed.error.to_string()),
                None => Some(CLOSE_DIED.to_owned()),
            };
        }
    }

    /// Goes on with what takes its time: opening, loading, closing. `elsewhere`: the player has turned to another window.
    pub fn poll(&mut self, menus: &mut Menus, settings: &Settings, elsewhere: bool) {
        self.phase = match std::mem::take(&mut self.phase) {
            Phase::Opening(task) => self.opening(task, menus, settings, elsewhere),
            Phase::Loading(session) => self.loading(session, menus, elsewhere),
            Phase::Closing(task, next) => self.closing(task, next, menus),
            other => other,
        };
    }

    fn close(&mut self, mut session: Session, next: Next, menus: &mut Menus) -> Phase {
        session.scene.watch_from(None);
        self.saving = false;
        self.held_up = None;
        menus.say_saving();
        let picture = self.portrait.comes_later();
        let close = move || {
            if let Some(picture) = picture {
                // What matters is written first.
                session.scene.save();
                session.picture = picture.recv_timeout(PATIENCE).ok().or(session.picture);
            }
            session.close()
        };
        Phase::Closing(Task::start("close", close), next)
    }

    fn go_on(&mut self, next: Next, menus: &mut Menus) -> Phase {
        match next {
            Next::Menu => {
                menus.open_main();
                Phase::Menu
            }
            Next::Open(request) => self.begin(request, menus),
            Next::Quit => Phase::Over,
        }
    }

    fn begin(&self, request: Request, menus: &mut Menus) -> Phase {
        let worlds = self.worlds.clone();
        let about = match request {
            Request::New(_) | Request::Load(_) => "busy-opening-about",
            _ => "busy-opening-room",
        };
        menus.busy("busy-opening", None, menus.texts.say(about));
        Phase::Opening(Task::start("open", move || opened(&worlds, request)))
    }

    fn opening(
        &mut self,
        task: Opening,
        menus: &mut Menus,
        settings: &Settings,
        elsewhere: bool,
    ) -> Phase {
        let why = match task.poll() {
            Progress::Running => return Phase::Opening(task),
            Progress::Done(Ok(Opened::World(mut session))) => {
                self.opened += 1;
                options::fit(&mut session.scene, settings);
                self.veil = Veil::Down;
                return self.loading(*session, menus, elsewhere);
            }
            Progress::Done(Ok(Opened::Room(room, builds))) => {
                self.opened += 1;
                self.pace.rest();
                let dir = self.worlds.rooms().path().to_path_buf();
                let mut visit = Visit::new(*room, self.opened, dir);
                if let Some(why) = visit.room.read_only() {
                    let words = note(&menus.texts, why).text;
                    menus.shell.toast(words, ToastKind::Problem);
                } else if builds {
                    visit.build();
                }
                return Phase::InRoom(Box::new(visit));
            }
            Progress::Done(Err(failure)) => {
                tracing::error!("it could not be opened: {failure}");
                wording::failure(&menus.texts, &failure, menus.list.known())
            }
            Progress::Died => {
                tracing::error!("it could not be opened: its thread died");
                menus.texts.say("open-died")
            }
        };
        menus.fail("open-failed", why);
        Phase::Menu
    }

    fn loading(&mut self, mut session: Session, menus: &mut Menus, elsewhere: bool) -> Phase {
        session.scene.pump(CHUNK_BUDGET * 4);
        let progress = session.scene.loading_progress();
        if progress < 1.0 {
            self.veil = Veil::Down;
        }
        if self.veil == Veil::Down {
            let name = legible_name(&session.scene.setup().name, &session.slug).into_owned();
            menus.busy("busy-land", Some(progress), name);
            return Phase::Loading(session);
        }
        self.pace.rest();
        self.since_save_s = 0.0;
        if elsewhere {
            // Somebody who is busy elsewhere should not have the pointer taken away.
            menus.shell.open(Screen::Main);
            return Phase::Paused(session);
        }
        menus.shell.open(Screen::Hidden);
        Phase::Playing(session)
    }

    fn closing(&mut self, task: Closing, next: Next, menus: &mut Menus) -> Phase {
        match task.poll() {
            Progress::Running => Phase::Closing(task, next),
            Progress::Done(Ok(())) => self.go_on(next, menus),
            Progress::Done(Err(unclosed)) => self.not_closed(unclosed, next, menus),
            Progress::Died if self.unseen => {
                self.last_words = Some(CLOSE_DIED.to_owned());
                Phase::Over
            }
            Progress::Died => {
                tracing::error!("{CLOSE_DIED}");
                menus.fail("save-failed", menus.texts.say("close-died"));
                Phase::Menu
            }
        }
    }

    /// The world stays open, and the player is asked what to do.
    fn not_closed(&mut self, unclosed: Unclosed, next: Next, menus: &mut Menus) -> Phase {
        let why = unclosed.error;
        tracing::error!("{why}");
        if self.unseen {
            self.last_words = Some(why.to_string());
            return Phase::Over;
        }
        let text = wording::streaming(&menus.texts, &why);
        self.held_up = Some(next);
        self.since_save_s = 0.0;
        menus.shell.open(Screen::Unsaved { text });
        let mut session = *unclosed.session;
        // The question says already what these would say of the save.
        let told = session.scene.save_problem();
        for notice in session.scene.take_notices() {
            if told.as_ref() != Some(&notice) {
                let words = wording::notice(&menus.texts, &notice);
                menus.shell.toast(words, ToastKind::Problem);
            }
        }
        Phase::Paused(session)
    }
}

impl Play {
    /// A picture of the open room was drawn.
    pub fn room_drawn(&mut self, menus: &mut Menus, elsewhere: bool) {
        let Some(visit) = self.phase.visit_mut() else {
            return;
        };
        if std::mem::replace(&mut visit.is_drawn, true) {
            return;
        }
        self.pace.rest();
        if elsewhere {
            self.pause(menus);
        } else if matches!(self.phase, Phase::InRoom(_)) {
            menus.shell.open(Screen::Hidden);
        }
    }

    /// Whether the picture of the open room is of how it was a while ago.
    pub fn room_is_late(&mut self, is_late: bool) {
        if let Some(visit) = self.phase.visit_mut() {
            visit.is_late = is_late;
        }
    }

    /// The open room cannot be drawn, for that reason: it is left.
    pub fn room_refused(&mut self, why: &Failure, menus: &mut Menus) {
        tracing::error!("the room cannot be drawn: {why}");
        if self.phase.visit().is_some() {
            self.phase = Phase::Menu;
            menus.fail("open-failed", wording::failure(&menus.texts, why, &[]));
        }
    }
}

/// A name that no room has.
fn free_room_name(rooms: &RoomsDir) -> Result<String, Failure> {
    let known = rooms.list()?;
    let is_free = |name: &String| known.iter().all(|it| it.name != *name);
    let mut names = (1..100_000).map(|number| format!("Room {number}"));
    Ok(names.find(is_free).unwrap_or_else(|| "Room".to_owned()))
}

/// Opens what was asked for. Waits for the disk.
fn opened(worlds: &Worlds, request: Request) -> Result<Opened, Failure> {
    let builds = matches!(request, Request::Build(_) | Request::BuildNew);
    let rooms = worlds.rooms();
    let room = match request {
        Request::New(wanted) => return Ok(Opened::World(Box::new(worlds.create(&wanted)?))),
        Request::Load(name) => return Ok(Opened::World(Box::new(worlds.load(&name)?))),
        Request::NewRoom(name) => {
            let name = name.map_or_else(|| free_room_name(&rooms), Ok)?;
            OpenRoom::make(&rooms, Some(&name), None)?
        }
        Request::BuildNew => {
            let name = free_room_name(&rooms)?;
            drop(OpenRoom::make(&rooms, Some(&name), None)?);
            OpenRoom::enter_with_journal(&rooms, rooms.find(&name)?)?
        }
        Request::Room(slug) | Request::Build(slug) => {
            OpenRoom::enter_with_journal(&rooms, room_of(&rooms, &slug)?)?
        }
        Request::RoomNamed(name) => OpenRoom::enter_with_journal(&rooms, rooms.find(&name)?)?,
    };
    Ok(Opened::Room(Box::new(room), builds))
}

/// What is said when the thread that saves has ended without a word.
const CLOSE_DIED: &str =
    "Something failed while the game wrote the world. The log has the details.";
