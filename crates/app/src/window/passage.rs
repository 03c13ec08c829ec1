//! How the game gets into worlds and out of them again, without losing one on the way.

use std::time::Duration;

use antipode_ui::{Screen, ToastKind};

use super::background::{Progress, Task};
use super::game::{CHUNK_BUDGET, Game};
use super::phase::{Next, Phase, Request};
use super::portrait::LastPicture;
use super::veil::Veil;
use crate::failure::Failure;
use crate::session::{Session, Unclosed};
use crate::wording;

/// Longest time that a world which is closed waits for its picture; it is saved already then.
const PATIENCE: Duration = Duration::from_secs(5);

impl Game {
    /// The player closes the window: what is open is committed first.
    pub fn close_window(&mut self) {
        self.close_backpack();
        match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.close(session, Next::Quit);
            }
            Phase::Closing(task, _) => self.phase = Phase::Closing(task, Next::Quit),
            Phase::Opening(task) => {
                // A world being opened is closed again as soon as it is there; nothing of it is lost.
                self.worlds_opened += 1;
                self.menus.say_saving();
                let closing = Task::start("close", move || match task.finish() {
                    Some(Ok(session)) => session.close(),
                    _ => Ok(()),
                });
                self.phase = Phase::Closing(closing, Next::Quit);
            }
            Phase::Menu | Phase::Over => {}
        }
    }

    /// Nothing can be shown any more: saves what is open and ends without asking.
    pub fn end_unseen(&mut self) {
        self.unseen = true;
        self.last_picture = None;
        self.close_window();
    }

    /// Ends at once, but not before what is open is on disk.
    pub fn finish(&mut self) {
        self.end_unseen();
        self.console.keep_history();
        self.finish_pictures();
        if let Phase::Closing(task, _) = std::mem::replace(&mut self.phase, Phase::Over) {
            match task.finish() {
                Some(Ok(())) => {}
                Some(Err(unclosed)) => self.last_words = Some(unclosed.error.to_string()),
                None => self.last_words = Some(CLOSE_DIED.to_owned()),
            }
        }
    }

    /// Closes what is open, then goes on.
    pub(super) fn leave(&mut self, next: Next) {
        self.close_backpack();
        match std::mem::replace(&mut self.phase, Phase::Menu) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.close(session, next);
            }
            Phase::Menu => self.go_on(next),
            other => self.phase = other,
        }
    }

    /// Leaves a world that cannot be saved, without what is not saved.
    pub(super) fn abandon(&mut self) {
        let next = self.held_up.take().unwrap_or(Next::Menu);
        match std::mem::replace(&mut self.phase, Phase::Menu) {
            Phase::Loading(session) | Phase::Playing(session) | Phase::Paused(session) => {
                self.menus.busy("busy-leaving", None, String::new());
                let task = Task::start("leave", move || {
                    drop(session);
                    Ok(())
                });
                self.phase = Phase::Closing(task, next);
            }
            other => self.phase = other,
        }
    }

    fn close(&mut self, mut session: Session, next: Next) {
        session.scene.watch_from(None);
        self.controls.release_all();
        self.console.leave();
        self.leave_photo_mode();
        self.saving = false;
        self.held_up = None;
        self.menus.say_saving();
        let picture = self.last_picture.as_mut().map(LastPicture::comes_later);
        let close = move || {
            if let Some(picture) = picture {
                // What matters is written first.
                session.scene.save();
                session.picture = picture.recv_timeout(PATIENCE).ok().or(session.picture);
            }
            session.close()
        };
        self.phase = Phase::Closing(Task::start("close", close), next);
    }

    fn go_on(&mut self, next: Next) {
        match next {
            Next::Menu => {
                self.phase = Phase::Menu;
                self.menus.open_main();
            }
            Next::Open(request) => self.open(request),
            Next::Quit => self.phase = Phase::Over,
        }
    }

    pub(super) fn open(&mut self, request: Request) {
        let worlds = self.worlds.clone();
        let detail = self.menus.texts.say("busy-opening-about");
        self.menus.busy("busy-opening", None, detail);
        let work = move || match request {
            Request::New(wanted) => worlds.create(&wanted),
            Request::Load(name) => worlds.load(&name),
        };
        self.phase = Phase::Opening(Task::start("open", work));
    }

    pub(super) fn opening(&mut self, task: Task<Result<Session, Failure>>) -> Phase {
        let why = match task.poll() {
            Progress::Running => return Phase::Opening(task),
            Progress::Done(Ok(mut session)) => {
                self.worlds_opened += 1;
                // What was answered in another world is not true of this one.
                self.console.view.clear();
                self.fit(&mut session);
                self.veil = Veil::Down;
                return self.loading(session);
            }
            Progress::Done(Err(failure)) => {
                tracing::error!("a world could not be opened: {failure}");
                wording::failure(&self.menus.texts, &failure, self.menus.list.worlds())
            }
            Progress::Died => {
                tracing::error!("a world could not be opened: its thread died");
                self.menus.texts.say("open-died")
            }
        };
        self.menus.fail("open-failed", why);
        Phase::Menu
    }

    pub(super) fn loading(&mut self, mut session: Session) -> Phase {
        session.scene.pump(CHUNK_BUDGET * 4);
        self.tell(&mut session);
        let progress = session.scene.loading_progress();
        if progress < 1.0 {
            self.veil = Veil::Down;
        }
        if self.veil == Veil::Down {
            let name = &session.scene.setup().name;
            let name = antipode_ui::legible_name(name, &session.slug).into_owned();
            self.menus.busy("busy-land", Some(progress), name);
            return Phase::Loading(session);
        }
        self.pace.rest();
        self.since_save_s = 0.0;
        if self.is_player_elsewhere() {
            // Somebody who is busy elsewhere should not have the pointer taken away.
            self.menus.shell.open(Screen::Main);
            return Phase::Paused(session);
        }
        self.menus.shell.open(Screen::Hidden);
        Phase::Playing(session)
    }

    pub(super) fn closing(&mut self, task: Task<Result<(), Unclosed>>, next: Next) -> Phase {
        match task.poll() {
            Progress::Running => return Phase::Closing(task, next),
            Progress::Done(Ok(())) => self.go_on(next),
            Progress::Done(Err(unclosed)) => return self.not_closed(unclosed, next),
            Progress::Died if self.unseen => self.last_words = Some(CLOSE_DIED.to_owned()),
            Progress::Died => {
                tracing::error!("{CLOSE_DIED}");
                let why = self.menus.texts.say("close-died");
                self.menus.fail("save-failed", why);
                return Phase::Menu;
            }
        }
        std::mem::replace(&mut self.phase, Phase::Over)
    }

    /// The world stays open, and the player is asked what to do.
    fn not_closed(&mut self, unclosed: Unclosed, next: Next) -> Phase {
        let why = unclosed.error;
        tracing::error!("{why}");
        if self.unseen {
            self.last_words = Some(why.to_string());
            return Phase::Over;
        }
        let text = wording::streaming(&self.menus.texts, &why);
        self.held_up = Some(next);
        self.since_save_s = 0.0;
        self.menus.shell.open(Screen::Unsaved { text });
        let mut session = *unclosed.session;
        // The question says already what these would say of the save.
        let told = session.scene.save_problem();
        for notice in session.scene.take_notices() {
            if told.as_ref() != Some(&notice) {
                let words = wording::notice(&self.menus.texts, &notice);
                self.menus.shell.toast(words, ToastKind::Problem);
            }
        }
        Phase::Paused(session)
    }
}

/// What is said when the thread that saves has ended without a word.
const CLOSE_DIED: &str = "Something failed while the world was written; the log has the rest.";
