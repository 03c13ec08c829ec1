//! The console in the game: what is typed is carried out in the open world, and nothing waits for it.

use std::path::PathBuf;

use antipode_scene::Scene;
use antipode_settings::Value;
use antipode_storage::StorageError;
use antipode_ui::{Console, Intent, LineKind, legible_name};

use super::game::Game;
use super::phase::{Next, Phase, Request};
use crate::bindings::{Action, Input};
use crate::console::{HELP, complete, help, read_history, write_history};
use crate::controls::Controls;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::script::{Host, Order, command_named, obey, parse_line, probe_text, steps_in};
use crate::session::{NewWorld, Worlds};
use crate::wording;

/// The console, and what it has set going.
#[derive(Default)]
pub struct Desk {
    pub(super) view: Console,
    /// What is held for some more steps.
    held: Vec<(Input, u64)>,
    /// What the last frame was drawn with.
    pub(super) drawn: Option<Drawn>,
    /// The adapter's name.
    pub(super) adapter: String,
    /// Where what was entered is kept for later runs.
    history: Option<PathBuf>,
}

impl Desk {
    /// Takes over what was entered in earlier runs, and keeps there what is entered in this one.
    pub fn remember_in(&mut self, file: PathBuf) {
        self.view.remember(read_history(&file));
        self.history = Some(file);
    }

    /// Keeps what was entered.
    pub fn keep_history(&self) {
        if let Some(file) = self
            .history
            .as_ref()
            .filter(|_| !self.view.history().is_empty())
        {
            write_history(file, self.view.history());
        }
    }

    /// A step has passed: what was held long enough is let go.
    pub fn step(&mut self, controls: &mut Controls) {
        self.held.retain_mut(|(input, steps)| {
            *steps = steps.saturating_sub(1);
            if *steps == 0 {
                controls.input(*input, false);
            }
            *steps > 0
        });
    }

    /// What is typed no longer concerns the world that it was typed in.
    pub fn leave(&mut self) {
        self.view.close();
        self.held.clear();
    }
}

impl Game {
    /// Whether the console is up and has the keys.
    pub fn is_typing(&self) -> bool {
        self.console.view.is_open()
    }

    pub(super) fn open_console(&mut self) {
        self.controls.release_all();
        self.console.held.clear();
        self.console.view.open();
    }

    /// A key while the console is up. Returns whether it closed the console and is nobody else's.
    pub fn console_key(&mut self, input: Input) -> bool {
        let does = |action| self.controls.does(input, action);
        let closes = does(Action::Menu) || does(Action::Console);
        if closes {
            self.console.view.close();
        }
        closes
    }

    /// Draws the console and does what was entered.
    pub(super) fn show_console(&mut self, context: &egui::Context) {
        if !self.is_typing() {
            return;
        }
        let worlds = self.menus.list.names();
        let entered = self
            .console
            .view
            .show(context, &self.menus.texts, &|line| complete(line, &worlds));
        if let Some(line) = entered {
            self.enter(&line);
        }
    }

    /// Does what a line says, and answers below it.
    pub(super) fn enter(&mut self, line: &str) {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap_or_default();
        if name == HELP.name {
            match help(&self.menus.texts, words.next()) {
                Ok(words) => self.answer(&words),
                Err(words) => self.refuse(&words),
            }
            return;
        }
        let order = match parse_line(line) {
            Ok(Some(order)) => order,
            Ok(None) => return,
            Err(what) => {
                let known = command_named(name);
                let words = known.map_or_else(
                    || {
                        help(&self.menus.texts, Some(name))
                            .err()
                            .unwrap_or_default()
                    },
                    |_| self.sentence(&what),
                );
                self.refuse(&words);
                if let Some(command) = known {
                    self.answer(&format!("{} {}", command.name, command.usage));
                }
                return;
            }
        };
        let was_marked = self.is_marked();
        match obey(self, &order) {
            Ok(()) if !was_marked && self.is_marked() => {
                self.answer(&self.menus.texts.say("console-marked"));
            }
            Ok(()) => {}
            Err(Failure::Usage(what) | Failure::Script(what)) => {
                let words = self.sentence(&what);
                self.refuse(&words);
            }
            Err(failure) => {
                let words = wording::failure(&self.menus.texts, &failure, self.menus.list.worlds());
                self.refuse(&words);
            }
        }
    }

    fn is_marked(&self) -> bool {
        self.phase
            .session()
            .is_some_and(|session| session.scene.cheated())
    }

    fn sentence(&self, what: &str) -> String {
        let details = what.trim_end_matches('.').into();
        self.menus
            .texts
            .say_with("console-refused", &[("details", details)])
    }

    fn answer(&mut self, words: &str) {
        self.console.view.say(words, LineKind::Answer);
    }

    fn refuse(&mut self, words: &str) {
        self.console.view.say(words, LineKind::Problem);
    }

    fn go(&mut self, next: Next) {
        self.console.leave();
        self.leave(next);
    }

    fn make(&mut self, wanted: &NewWorld) -> Result<(), Failure> {
        let name = match &wanted.name {
            Some(name) => {
                self.worlds
                    .saves()
                    .check_name(name)
                    .map_err(StorageError::Name)?;
                name.clone()
            }
            // Who plays it will want to keep it.
            None => self.worlds.free_name(),
        };
        self.go(Next::Open(Request::New(NewWorld {
            name: Some(name),
            ..wanted.clone()
        })));
        Ok(())
    }

    fn change_to(&mut self, name: &str) -> Result<(), Failure> {
        let slug = self.worlds.saves().find(name)?.slug;
        if self.open_slug() == Some(&slug) {
            let words = self
                .menus
                .texts
                .say_with("console-open-already", &[("name", name.into())]);
            self.answer(&words);
        } else {
            self.go(Next::Open(Request::Load(slug)));
        }
        Ok(())
    }

    fn list_worlds(&mut self) -> Result<(), Failure> {
        let worlds = self.worlds.list()?;
        if worlds.is_empty() {
            self.answer(&self.menus.texts.say("console-no-worlds"));
        }
        for world in worlds {
            let words = match &world.meta {
                Some(meta) => {
                    let space = meta.geometry.parse();
                    let space = space.map_or_else(
                        |_| meta.geometry.clone(),
                        |space| wording::geometry(&self.menus.texts, space),
                    );
                    let values = [
                        ("name", legible_name(world.name(), &world.slug).into()),
                        ("space", space.into()),
                        ("seed", meta.seed.to_string().into()),
                    ];
                    self.menus.texts.say_with("console-world", &values)
                }
                None => legible_name(world.name(), &world.slug).into_owned(),
            };
            self.answer(&words);
        }
        Ok(())
    }

    fn probe_here(&mut self) -> Result<(), Failure> {
        let probe = self.scene()?.probe();
        let fps = f64::from(self.frames_per_second());
        let known = (fps > 0.0).then_some(fps);
        let drawn = self.console.drawn;
        let words = probe_text(
            &probe,
            known,
            &self.console.adapter,
            drawn.as_ref(),
            self.pace.dropped_s(),
        )?;
        self.answer(&words);
        Ok(())
    }

    fn shoot_as(&mut self, file: &str) {
        let stem = std::path::Path::new(file)
            .file_stem()
            .and_then(std::ffi::OsStr::to_str);
        let plain = std::path::Path::new(file).components().count() == 1;
        if let (Some(stem), true) = (stem, plain) {
            self.shots.want(stem.to_owned());
            return;
        }
        let dir = self.shots.album.dir().display().to_string();
        let words = self
            .menus
            .texts
            .say_with("console-shot-name", &[("dir", dir.into())]);
        self.refuse(&words);
    }

    fn settled(&mut self) -> Result<(), Failure> {
        let words = match self.scene()?.pending() {
            0 => self.menus.texts.say("console-settled"),
            count => self
                .menus
                .texts
                .say_with("console-unsettled", &[("count", count.into())]),
        };
        self.answer(&words);
        Ok(())
    }

    fn save_now(&mut self) -> Result<(), Failure> {
        if self.scene()?.is_kept() {
            self.follow(Intent::Save);
            self.answer(&self.menus.texts.say("console-saving"));
        } else {
            self.refuse(&self.menus.texts.say("console-not-kept"));
        }
        Ok(())
    }
}

impl Host for Game {
    fn scene(&mut self) -> Result<&mut Scene, Failure> {
        match &mut self.phase {
            Phase::Playing(session) => Ok(&mut session.scene),
            _ => Err(Failure::Usage("no world is open".to_owned())),
        }
    }

    fn worlds(&mut self) -> &mut Worlds {
        &mut self.worlds
    }

    fn controls(&mut self) -> &mut Controls {
        &mut self.controls
    }

    fn open_slug(&self) -> Option<&str> {
        let slug = self.phase.session().map(|session| session.slug.as_str());
        slug.filter(|slug| !slug.is_empty())
    }

    fn set_own(&mut self, id: &'static str, value: Value) {
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
            Order::New(wanted) => self.make(wanted),
            Order::Load(name) => self.change_to(name),
            Order::Save => self.save_now(),
            Order::List => self.list_worlds(),
            Order::Quit => {
                self.go(Next::Quit);
                Ok(())
            }
            Order::Hold(input, time_s) => {
                self.press_input(*input);
                self.console.held.push((*input, steps_in(*time_s).max(1)));
                Ok(())
            }
            Order::Wait(_) => {
                self.refuse(&self.menus.texts.say("console-no-wait"));
                Ok(())
            }
            Order::Settle(_) => self.settled(),
            Order::Probe => self.probe_here(),
            Order::Shot(file) => {
                self.shoot_as(file);
                Ok(())
            }
            Order::Perf(_) => {
                self.refuse(&self.menus.texts.say("console-no-perf"));
                Ok(())
            }
            // The rest is carried out alike everywhere.
            _ => Ok(()),
        }
    }
}
