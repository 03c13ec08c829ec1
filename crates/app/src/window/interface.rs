//! Shows the game to the interface, and does what the player asks for there.

use antipode_geometry::Geometry;
use antipode_scene::Mode;
use antipode_settings::Value;
use antipode_ui::{GeometryChoice, HintModel, Intent, ModeChoice, Screen, ToastKind};

use super::game::Game;
use super::hints::HintContext;
use super::phase::{Next, Phase, Request};
use crate::console::complete;
use crate::drawn::Drawn;
use crate::session::{Beginning, NewWorld};

impl Game {
    /// Shows display and menu, and does what the player asks for there. `drawn` is what the last frame was drawn
    /// with, and the adapter's own time in milliseconds where it can tell.
    pub fn interface(&mut self, context: &egui::Context, drawn: Option<(Drawn, Option<f64>)>) {
        self.display.drawn = drawn;
        self.play.veil.show(context);
        let instruments = self.show_display(context);
        self.menus.shell.keep_toasts_above(instruments);
        let (texts, devices, play) = (&self.menus.texts, &mut self.devices, &mut self.play);
        let backpack = &mut self.overlays.backpack;
        backpack.show(context, texts, devices, play);
        let is_free = matches!(play.phase, Phase::Playing(_)) && !self.overlays.are_up();
        self.overlays.naming.ask(is_free, devices, play);
        if self.shots.is_now() {
            // What is typed is never in a picture, nor with the display hidden is what was told of the last one.
            let is_bare = self.display.hidden || self.overlays.is_photographing();
            if is_bare && !self.menus.shell.is_open() {
                return;
            }
        } else {
            self.show_console(context);
            self.show_photo_panel(context);
            let (naming, texts) = (&mut self.overlays.naming, &self.menus.texts);
            naming.show(context, texts, &mut self.play);
        }
        self.show_workshop(context);
        let covered = self.overlays.covered(context.content_rect());
        self.menus.shell.keep_toasts_off(covered);
        let (config, phase) = (&self.options.config, &self.play.phase);
        let backdrop = self.backdrop.model();
        let intents = self.menus.show(context, config, phase, backdrop);
        for intent in intents {
            self.follow(intent);
        }
    }

    /// Shows the display. Returns where its instruments are.
    fn show_display(&mut self, context: &egui::Context) -> egui::Rect {
        let texts = &self.menus.texts;
        let model = self.display.model(texts, &self.options.config, &self.play);
        let Some(mut model) = model.filter(|_| !self.overlays.is_photographing()) else {
            return egui::Rect::NOTHING;
        };
        if self.overlays.is_packing() || self.overlays.is_naming() {
            model.show_crosshair = false;
        } else {
            model.hint = self.hint();
        }
        antipode_ui::show_hud(context, texts, &model)
    }

    /// What a newcomer is to be told now.
    pub(super) fn hint(&self) -> Option<HintModel> {
        // They are about worlds, and would lie over the large map.
        if self.play.phase.visit().is_some() || self.display.large_map {
            return None;
        }
        let config = &self.options.config;
        let hints = config.settings.hints.then_some(&self.hints)?;
        let context = HintContext::in_phase(&self.play.phase);
        hints.model(&self.menus.texts, &config.profiles, context)
    }

    fn show_console(&mut self, context: &egui::Context) {
        if !self.overlays.is_typing() {
            return;
        }
        let (view, texts) = (&mut self.overlays.console.view, &self.menus.texts);
        let worlds = self.menus.list.names();
        if let Some(line) = view.show(context, texts, &|line| complete(line, &worlds)) {
            self.enter(&line);
        }
    }

    fn show_photo_panel(&mut self, context: &egui::Context) {
        let (photo, texts) = (&mut self.overlays.photo, &self.menus.texts);
        let wishes = photo.show(context, texts, &self.options.config);
        let wishes = wishes.unwrap_or_default();
        if wishes.save {
            photo.begin(&mut self.play);
        }
        if wishes.leave {
            photo.leave(&mut self.devices, &mut self.play, &mut self.menus);
        }
    }

    /// Does what the player asks for in the menus.
    pub(super) fn follow(&mut self, intent: Intent) {
        match intent {
            Intent::Resume => self.resume(),
            Intent::Save => self.play.save(),
            Intent::BeginAnew => self.begin_anew(),
            Intent::BuildHere => {
                self.resume();
                self.toggle_workshop();
            }
            Intent::SaveAndQuitToMenu => self.leave(Next::Menu),
            Intent::NewGame {
                name,
                geometry,
                seed,
                radius_m,
                mode,
            } => self.leave(Next::Open(Request::New(NewWorld {
                geometry: geometry_of(geometry),
                name: Some(name),
                seed,
                radius_m,
                generator: None,
                mode: mode_of(mode),
                start: Beginning::View,
            }))),
            Intent::Load { slug } => match self.menus.list.work_on(&self.menus.texts, &slug) {
                // It would be called in use by somebody else.
                Some(work) => self.menus.shell.toast(work, ToastKind::State),
                None => self.leave(Next::Open(Request::Load(slug))),
            },
            Intent::Set { id, value } => self.set_option(id, value),
            Intent::ResetSetting(id) => {
                if self.options.config.settings.reset(id) {
                    self.option_changed(id);
                }
            }
            Intent::Bind(profiles) => {
                self.options.config.profiles = *profiles;
                self.option_changed("bindings");
            }
            Intent::Delete { slug } => self.menus.list.delete(slug),
            Intent::Worlds(intent) => self.menus.list.follow(intent),
            Intent::BuildNewRoom => self.leave(Next::Open(Request::BuildNew)),
            Intent::NewRoom => self.leave(Next::Open(Request::NewRoom(None))),
            Intent::EnterRoom { slug } => self.open_room(&slug.clone(), Request::Room(slug)),
            Intent::BuildIn { slug } => self.open_room(&slug.clone(), Request::Build(slug)),
            Intent::DeleteRoom { slug } => self.menus.rooms.delete(slug),
            Intent::Rooms(intent) => self.menus.rooms.follow(intent),
            Intent::Quit => self.leave(Next::Quit),
            Intent::TrySavingAgain => {
                let next = self.play.held_up.take().unwrap_or(Next::Menu);
                self.leave(next);
            }
            Intent::LeaveUnsaved => self.play.abandon(&mut self.menus),
            Intent::DismissMessage => self.dismiss_message(),
        }
    }

    fn dismiss_message(&mut self) {
        self.play.held_up = None;
        if self.play.phase.is_paused() && !self.menus.shell.is_open() {
            self.menus.shell.open(Screen::Main);
        }
    }

    /// Leaves for a room, unless something is being done with it.
    fn open_room(&mut self, slug: &str, request: Request) {
        match self.menus.rooms.work_on(&self.menus.texts, slug) {
            Some(work) => self.menus.shell.toast(work, ToastKind::State),
            None => self.leave(Next::Open(request)),
        }
    }

    /// Gives a setting a value.
    pub(super) fn set_option(&mut self, id: &'static str, value: Value) {
        if self.options.set(id, value) {
            self.option_changed(id);
        }
    }

    fn option_changed(&mut self, id: &str) {
        let (menus, controls) = (&mut self.menus, &mut self.devices.controls);
        self.options.changed(id, menus, controls, &mut self.play);
    }
}

fn mode_of(choice: ModeChoice) -> Mode {
    match choice {
        ModeChoice::Creative => Mode::Creative,
        ModeChoice::Gathering => Mode::Gathering,
    }
}

fn geometry_of(choice: GeometryChoice) -> Geometry {
    match choice {
        GeometryChoice::Hyperbolic => Geometry::Hyperbolic,
        GeometryChoice::HyperbolicWorld => Geometry::HyperbolicWorld,
        GeometryChoice::Euclidean => Geometry::Euclidean,
        GeometryChoice::Spherical => Geometry::Spherical,
    }
}
