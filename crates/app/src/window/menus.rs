//! The menus and their messages: the interface's shell, the words that it speaks in, the worlds and rooms that it lists, and
//! what it says of this machine.

use std::path::Path;

use antipode_language::{Texts, Value};
use antipode_scene::tuning::walk_speed_m_s;
use antipode_settings::{Config, Notice, Settings};
use antipode_ui::{
    AboutModel, Backdrop, Intent, MenuModel, OwnRoom, Screen, Shell, ToastKind, legible_name,
};

use super::phase::Phase;
use super::placelist::{RoomList, RoomShelf, WorldList};
use super::press::{ESCAPE, Press, Taken};
use super::visit::Visit;
use crate::failure::Failure;
use crate::session::Worlds;
use crate::trouble::Trouble;
use crate::wording;

/// Most sentences about the file of the settings that are told one by one.
const MOST_TOLD: usize = 3;

/// What the player is told outside of the world.
pub struct Menus {
    pub(super) shell: Shell,
    /// The words of the player's language.
    pub(super) texts: Texts,
    pub(super) list: WorldList,
    pub(super) rooms: RoomList,
    pub(super) about: AboutModel,
    /// The name of the adapter, where it draws in software.
    pub(super) software: Option<String>,
    /// Key of the words for a player who hears nothing.
    pub(super) sound_trouble: Option<&'static str>,
}

impl Menus {
    /// The main menu. `software` names the adapter if it draws in software.
    pub fn new(worlds: Worlds, software: Option<String>) -> Self {
        let mut menus = Self {
            shell: Shell::new(),
            texts: Texts::default(),
            rooms: RoomList::new(RoomShelf::new(&worlds)),
            list: WorldList::new(worlds),
            about: AboutModel::default(),
            software,
            sound_trouble: None,
        };
        menus.open_main();
        menus
    }

    /// Opens the main menu, or that of a paused world or room, with the worlds and rooms that are there now.
    pub fn open_main(&mut self) {
        self.list.refresh();
        self.rooms.refresh();
        self.shell.open(Screen::Main);
    }

    /// Takes over what has become of work on saved worlds and rooms, and tells it.
    pub fn tick(&mut self) {
        self.list.poll();
        self.rooms.poll();
        let mut news = || {
            let of_worlds = self.list.take_news(&self.texts);
            of_worlds.or_else(|| self.rooms.take_news(&self.texts))
        };
        while let Some((words, kind)) = news() {
            self.shell.toast(words, kind);
        }
    }

    /// Whether no work on saved worlds or rooms is under way.
    pub fn are_lists_idle(&self) -> bool {
        self.list.is_idle() && self.rooms.is_idle()
    }

    /// The layer of an action that waits for its key: it takes whatever it is, but Escape.
    pub fn press_to_bind(&mut self, press: &Press) -> Taken {
        let input = press.fresh().filter(|input| *input != ESCAPE);
        match input.filter(|_| self.shell.wants_input()) {
            Some(input) => self.shell.take_input(input),
            None => return Taken::Not,
        }
        Taken::Wholly
    }

    /// Puts the message of that key up for some seconds.
    pub fn toast(&mut self, kind: ToastKind, key: &str, values: &[(&str, Value<'_>)]) {
        self.shell.toast(self.texts.say_with(key, values), kind);
    }

    /// Says what is being done, until another screen is opened.
    pub fn busy(&mut self, key: &str, progress: Option<f32>, detail: String) {
        let title = self.texts.say(key);
        self.shell.open(Screen::Busy {
            title,
            progress,
            detail,
        });
    }

    /// Says that what was open is being written.
    pub fn say_saving(&mut self) {
        self.busy("busy-saving", None, self.texts.say("busy-saving-about"));
    }

    /// Says why something failed, over the main menu.
    pub fn fail(&mut self, key: &str, text: String) {
        self.list.refresh();
        self.rooms.refresh();
        self.message(key, text);
    }

    fn message(&mut self, key: &str, text: String) {
        let title = self.texts.say(key);
        self.shell.open(Screen::Message { title, text });
    }

    /// Says that the game before this one crashed, and where it wrote what is known.
    pub fn tell_crash(&mut self, report: &Path) {
        let report = report.display().to_string();
        let text = self.texts.say_with("crash", &[("report", report.into())]);
        self.message("crash-title", text);
    }

    /// Says that the graphics of the game before this one failed for good, and what draws now.
    pub fn tell_graphics(&mut self, trouble: &Trouble) {
        let mut text = wording::trouble(&self.texts, trouble);
        if self.software.is_some() {
            text = format!("{text} {}", self.texts.say("graphics-software"));
        }
        self.message("graphics-title", text);
    }

    /// The adapter was lost, and drawing goes on with one that draws in software if it has this name.
    pub fn tell_reopened(&mut self, software: Option<String>) {
        self.software = software;
        self.toast(ToastKind::State, "adapter-reopened", &[]);
    }

    /// Tells what there is to tell of the file of the settings.
    pub fn tell_settings(&mut self, notices: &[Notice]) {
        for notice in notices.iter().take(MOST_TOLD) {
            let words = wording::settings_notice(&self.texts, notice);
            self.shell.toast(words, ToastKind::Problem);
        }
        let more = notices.len().saturating_sub(MOST_TOLD);
        if more > 0 {
            let values = [("count", more.into())];
            self.toast(ToastKind::Problem, "settings-file-more", &values);
        }
    }

    /// Tells that the window could not be made as the settings say.
    pub fn tell_not_applied(&mut self, why: &Failure) {
        tracing::warn!("settings could not be applied: {why}");
        let reason = wording::failure(&self.texts, why, &[]);
        let values = [("reason", reason.into())];
        self.toast(ToastKind::Problem, "settings-not-applied", &values);
    }

    /// There is no picture, for that reason.
    pub fn tell_no_picture(&mut self, reason: &str) {
        tracing::error!("no picture was taken: {reason}");
        let values = [("reason", reason.into())];
        self.toast(ToastKind::Problem, "picture-not-taken", &values);
    }

    /// Draws what is up, in that phase of the game. Returns what the player asked for there.
    pub fn show(
        &mut self,
        context: &egui::Context,
        config: &Config,
        phase: &Phase,
        backdrop: Backdrop,
    ) -> Vec<Intent> {
        self.list.show_pictures(context);
        self.rooms.show_pictures(context);
        let (texts, list, rooms) = (&self.texts, &self.list, &self.rooms);
        let is_open = self.shell.is_open();
        let (worlds, world_files) = if is_open {
            (list.rows(texts, Some(phase.slug())), list.files(texts))
        } else {
            Default::default()
        };
        let visited = phase.visit().map(Visit::slug);
        let (room_rows, room_files) = if is_open {
            (rooms.rows(texts, visited.as_deref()), rooms.files(texts))
        } else {
            Default::default()
        };
        let running = running(texts, phase);
        let notice = self.software_notice(&config.settings);
        let sound_notice = self.sound_trouble.map(|key| texts.say(key));
        let model = MenuModel {
            texts,
            running_world: running.as_deref(),
            backdrop,
            in_room: phase.visit().is_some(),
            own_room: own_room(phase),
            worlds: &worlds,
            rooms: &room_rows,
            config,
            check_name: &|name| list.check_name(texts, name),
            walk_m_s: walk_speed_m_s(),
            check_rename: &|slug, name| list.check_rename(texts, slug, name),
            check_room_rename: &|slug, name| rooms.check_rename(texts, slug, name),
            world_files: &world_files,
            room_files: &room_files,
            adapter_notice: notice.as_deref(),
            sound_notice: sound_notice.as_deref(),
            version: env!("CARGO_PKG_VERSION"),
            about: &self.about,
        };
        self.shell.show(context, &model)
    }

    /// What the menu says of an adapter that is software.
    fn software_notice(&self, settings: &Settings) -> Option<String> {
        let adapter = self.software.as_ref()?;
        let percent = (settings
            .render_scale
            .share(settings.preset.is_software(true))
            * 100.0)
            .round();
        let percent = percent as u32;
        let values = [("adapter", adapter.into()), ("percent", percent.into())];
        Some(self.texts.say_with("adapter-software", &values))
    }
}

/// What is done in a room of the player's own that is behind the menu.
fn own_room(phase: &Phase) -> OwnRoom {
    match phase {
        Phase::RoomPaused(visit) if visit.workshop.is_some() => OwnRoom::Built,
        Phase::RoomPaused(visit) if visit.file().is_some() => OwnRoom::Walked,
        _ => OwnRoom::No,
    }
}

/// What the open world or room is called, where it can be gone back to.
fn running(texts: &Texts, phase: &Phase) -> Option<String> {
    if let Phase::RoomPaused(visit) = phase {
        return Some(wording::open_room(texts, &visit.room).name);
    }
    let (Phase::Playing(session) | Phase::Paused(session)) = phase else {
        return None;
    };
    let setup = session.scene.setup();
    let values = [
        ("name", legible_name(&setup.name, &session.slug).into()),
        ("seed", setup.seed.to_string().into()),
    ];
    let title = texts.say_with("running-world", &values);
    if session.scene.cheated() {
        return Some(format!("{title} · {}", texts.say("cheats-used")));
    }
    Some(title)
}
