//! Carries out the lines of the console; nothing waits for them.

use std::path::Path;

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_rooms::RoomError;
use antipode_scene::Scene;
use antipode_storage::{StorageError, WorldSummary};
use antipode_ui::LineKind::{self, Answer, Problem};
use antipode_ui::legible_name;

use super::game::Game;
use super::phase::{Next, Phase, Request};
use super::placelist::Kept;
use super::reading::{Asked, Done};
use super::visit::Visit;
use crate::bindings::Input;
use crate::console::{HELP, help};
use crate::controls::Controls;
use crate::dates::moment;
use crate::failure::Failure;
use crate::rooms::OpenRoom;
use crate::script::{
    Host, Order, RoomOrder, command_named, obey, parse_line, probe_text, room_probe_text, steps_in,
};
use crate::session::{NewWorld, Worlds};
use crate::wording;

/// What is said of commands that only scripts have.
const ONLY_SCRIPTS: &str = "rooms with another gravity are made by scripts, as docs/rooms.md tells";
/// What is said where a room of the game is to be changed.
const SHIPPED: &str = "this room comes with the game; duplicate it in the list of rooms, or keep it by room save name=NAME, and change the copy";
/// What is said where no room is played.
const NO_ROOM: &str = "no room is open";

impl Game {
    /// Does what a line says, and answers below it.
    pub(super) fn enter(&mut self, line: &str) {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap_or_default();
        let texts = &self.menus.texts;
        if name == HELP.name {
            return match help(texts, words.next()) {
                Ok(words) => self.write(Answer, &words),
                Err(words) => self.write(Problem, &words),
            };
        }
        let order = match parse_line(line) {
            Ok(Some(order)) => order,
            Ok(None) => return,
            Err(what) => {
                let Some(command) = command_named(name) else {
                    let words = help(texts, Some(name)).err().unwrap_or_default();
                    return self.write(Problem, &words);
                };
                let (words, usage) = (sentence(texts, &what), command.usage);
                self.write(Problem, &words);
                return self.write(Answer, &format!("{name} {usage}"));
            }
        };
        let was_marked = self.is_marked();
        match obey(self, &order) {
            Ok(()) if !was_marked && self.is_marked() => self.reply(Answer, "console-marked", &[]),
            Ok(()) => {}
            Err(Failure::Usage(what) | Failure::Script(what)) => {
                let words = sentence(&self.menus.texts, &what);
                self.write(Problem, &words);
            }
            Err(failure) => {
                let worlds = self.menus.list.known();
                let words = wording::failure(&self.menus.texts, &failure, worlds);
                self.write(Problem, &words);
            }
        }
    }

    fn is_marked(&self) -> bool {
        let session = self.play.phase.session();
        session.is_some_and(|session| session.scene.cheated())
    }

    fn write(&mut self, kind: LineKind, words: &str) {
        self.overlays.console.view.say(words, kind);
    }

    fn reply(&mut self, kind: LineKind, key: &str, values: &[(&str, Value<'_>)]) {
        let words = self.menus.texts.say_with(key, values);
        self.write(kind, &words);
    }

    fn list_worlds(&mut self) -> Result<(), Failure> {
        let worlds = self.play.worlds.list()?;
        if worlds.is_empty() {
            self.reply(Answer, "console-no-worlds", &[]);
        }
        for world in worlds {
            let words = told(&self.menus.texts, &world);
            self.write(Answer, &words);
        }
        Ok(())
    }

    fn order_room(&mut self, order: &RoomOrder) -> Result<(), Failure> {
        match order {
            RoomOrder::New {
                gravity: Some(_), ..
            } => return Err(Failure::Usage(ONLY_SCRIPTS.to_owned())),
            RoomOrder::Save(name) => {
                self.visited()?;
                self.ask_of_room(Asked::Save(name.clone()));
            }
            RoomOrder::New { name, .. } => {
                self.leave(Next::Open(Request::NewRoom(name.clone())));
            }
            RoomOrder::Load(name) => {
                self.leave(Next::Open(Request::RoomNamed(name.clone())));
            }
            RoomOrder::Delete(name) => {
                let visited = self.play.phase.visit().map(Visit::slug);
                let known = self.menus.rooms.known().iter();
                let found = known
                    .filter(|room| room.name == *name)
                    .map(Kept::slug)
                    .next();
                match found {
                    Some(slug) if Some(&slug) == visited.as_ref() => {
                        return Err(Failure::Usage(format!(
                            "\"{name}\" is open and cannot be deleted"
                        )));
                    }
                    Some(slug) => self.menus.rooms.delete(slug),
                    None => return Err(Failure::Usage(format!("no room is called \"{name}\""))),
                }
            }
            RoomOrder::Versions => {
                self.visited()?;
                self.ask_of_room(Asked::Versions);
            }
            RoomOrder::Older(number) => self.open_older(*number)?,
            RoomOrder::List => {
                let names = self.menus.rooms.names();
                for name in names {
                    self.write(Answer, &legible_name(&name, ""));
                }
            }
        }
        Ok(())
    }

    /// Tells what has come of something that was asked of the open room.
    pub(super) fn answer_of_room(&mut self, done: Result<Done, RoomError>) {
        match done {
            Ok(Done::Saved) => {
                self.menus.rooms.refresh();
                self.reply(Answer, "console-room-saved", &[]);
            }
            Ok(Done::Changed) => self.reply(Answer, "console-room-changed", &[]),
            Ok(Done::Versions(all)) if all.is_empty() => {
                self.reply(Answer, "console-no-versions", &[]);
            }
            Ok(Done::Versions(all)) => {
                for (number, it) in (1..).zip(all) {
                    self.write(Answer, &format!("{number}: {}", moment(it.when_s)));
                }
            }
            Err(why) => {
                let words = sentence(&self.menus.texts, &why.to_string());
                self.write(Problem, &words);
            }
        }
    }

    fn open_older(&mut self, number: usize) -> Result<(), Failure> {
        let is_free = self.visited()?.check_free();
        is_free.map_err(|error| told_of_room(&error))?;
        self.ask_of_room(Asked::Older(number));
        Ok(())
    }

    fn visited(&mut self) -> Result<&mut OpenRoom, Failure> {
        let visit = self.play.phase.visit_mut();
        let room = visit.map(|visit| &mut visit.room);
        room.ok_or_else(|| Failure::Usage(NO_ROOM.to_owned()))
    }

    /// Changes the open room, if it is the player's own.
    fn edit_room(&mut self, words: &[String]) -> Result<(), Failure> {
        let room = self.visited()?;
        if room.kept.as_ref().is_none_or(|kept| kept.shipped) {
            return Err(Failure::Usage(SHIPPED.to_owned()));
        }
        let is_free = room.check_free();
        is_free.map_err(|error| told_of_room(&error))?;
        let asked = Asked::Words(words.to_vec());
        if let Some(visit) = self.play.phase.visit_mut() {
            let checked = visit.check_asked(&asked);
            checked.map_err(|error| told_of_room(&error))?;
        }
        self.ask_of_room(asked);
        Ok(())
    }

    fn probe_here(&mut self) -> Result<(), Failure> {
        if let Phase::InRoom(visit) = &self.play.phase {
            let adapter = &self.overlays.console.adapter;
            let words = room_probe_text(&visit.scene().probe(), adapter)?;
            self.write(Answer, &words);
            return Ok(());
        }
        let probe = self.scene()?.probe();
        let fps = f64::from(self.display.fps.value());
        let console = &self.overlays.console;
        let words = probe_text(
            &probe,
            (fps > 0.0).then_some(fps),
            &console.adapter,
            self.display.drawn.map(|(drawn, _)| drawn).as_ref(),
            self.play.pace.dropped_s(),
        )?;
        self.write(Answer, &words);
        Ok(())
    }

    fn shoot_as(&mut self, file: &str) {
        let file = Path::new(file);
        let stem = file.file_stem().and_then(std::ffi::OsStr::to_str);
        if let (Some(stem), 1) = (stem, file.components().count()) {
            self.shots.want(stem.to_owned());
            return;
        }
        let values = [("dir", self.shots.album.dir().display().to_string().into())];
        self.reply(Problem, "console-shot-name", &values);
    }
}

impl Host for Game {
    fn scene(&mut self) -> Result<&mut Scene, Failure> {
        match &mut self.play.phase {
            Phase::Playing(session) => Ok(&mut session.scene),
            _ => Err(Failure::Usage("no world is open".to_owned())),
        }
    }

    fn room(&mut self) -> Option<&mut RoomScene> {
        match &mut self.play.phase {
            Phase::InRoom(visit) => Some(&mut visit.room.scene),
            _ => None,
        }
    }

    fn worlds(&mut self) -> &mut Worlds {
        &mut self.play.worlds
    }

    fn controls(&mut self) -> &mut Controls {
        &mut self.devices.controls
    }

    fn open_slug(&self) -> Option<&str> {
        Some(self.play.phase.slug()).filter(|slug| !slug.is_empty())
    }

    fn set_own(&mut self, id: &'static str, value: antipode_settings::Value) {
        self.set_option(id, value);
    }

    fn press(&mut self, input: Input) {
        self.press_input(input);
    }

    fn step(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    fn arrive(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    fn own(&mut self, order: &Order) -> Result<(), Failure> {
        match order {
            Order::New(wanted) => {
                let request = named(&self.play.worlds, wanted)?;
                self.leave(Next::Open(request));
            }
            Order::Load(name) => {
                let slug = self.play.worlds.saves().find(name)?.slug;
                if self.open_slug() == Some(&slug) {
                    let values = [("name", name.into())];
                    self.reply(Answer, "console-open-already", &values);
                } else {
                    self.leave(Next::Open(Request::Load(slug)));
                }
            }
            Order::Save if self.scene()?.is_kept() => {
                self.play.save();
                self.reply(Answer, "console-saving", &[]);
            }
            Order::Save => self.reply(Problem, "console-not-kept", &[]),
            Order::List => self.list_worlds()?,
            Order::Quit => self.leave(Next::Quit),
            Order::Hold(input, time_s) => {
                self.press_input(*input);
                self.devices.hold_for(*input, steps_in(*time_s).max(1));
            }
            Order::Wait(_) => self.reply(Problem, "console-no-wait", &[]),
            Order::Settle(_) => match self.scene()?.pending() {
                0 => self.reply(Answer, "console-settled", &[]),
                count => self.reply(Answer, "console-unsettled", &[("count", count.into())]),
            },
            Order::Probe => self.probe_here()?,
            Order::Shot(file) => self.shoot_as(file),
            Order::Perf(_) => self.reply(Problem, "console-no-perf", &[]),
            Order::Room(order) => return self.order_room(order),
            Order::Edit(words) => return self.edit_room(words),
            // The rest is carried out alike everywhere.
            _ => {}
        }
        Ok(())
    }
}

/// A command that makes no sense is told in its own words.
fn told_of_room(error: &RoomError) -> Failure {
    Failure::Usage(error.to_string())
}

fn sentence(texts: &Texts, what: &str) -> String {
    let details = what.trim_end_matches('.').into();
    texts.say_with("console-refused", &[("details", details)])
}

fn named(worlds: &Worlds, wanted: &NewWorld) -> Result<Request, Failure> {
    let name = match &wanted.name {
        Some(name) => {
            let checked = worlds.saves().check_name(name);
            checked.map_err(StorageError::Name)?;
            name.clone()
        }
        // The player will want to keep it.
        None => worlds.free_name(),
    };
    Ok(Request::New(NewWorld {
        name: Some(name),
        ..wanted.clone()
    }))
}

fn told(texts: &Texts, world: &WorldSummary) -> String {
    let name = legible_name(world.name(), &world.slug);
    let Some(meta) = &world.meta else {
        return name.into_owned();
    };
    let space = meta.geometry.parse();
    let space = space.map_or_else(
        |_| meta.geometry.clone(),
        |space| wording::geometry(texts, space),
    );
    let values = [
        ("name", name.into()),
        ("space", space.into()),
        ("seed", meta.seed.to_string().into()),
    ];
    texts.say_with("console-world", &values)
}
