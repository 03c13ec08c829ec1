//! What the interface shows of the game, and what the player asks for there.

use antipode_geometry::Geometry;
use antipode_ui::{
    Backpack, Console, GeometryChoice, HudModel, Intent, Screen, ToastKind, legible_name,
};

use super::game::Game;
use super::menus::Running;
use super::phase::{Next, Phase, Request};
use crate::drawn::Drawn;
use crate::hud;
use crate::navigator::columns_for;
use crate::session::{Beginning, NewWorld};

impl Game {
    /// Shows display and menu, and does what the player asks for there. `drawn` is what the last frame was drawn
    /// with, and the adapter's own time in milliseconds where it can tell.
    pub fn interface(&mut self, context: &egui::Context, drawn: Option<(Drawn, Option<f64>)>) {
        self.console.drawn = drawn.map(|(drawn, _)| drawn);
        self.show_veil(context);
        let display = self.display(drawn);
        let instruments = display.map_or(egui::Rect::NOTHING, |model| {
            antipode_ui::show_hud(context, &self.menus.texts, &model)
        });
        self.menus.shell.keep_toasts_above(instruments);
        self.show_backpack(context);
        if self.shots.is_now() {
            // What is typed is never in a picture, nor with the display hidden is what was told of the last one.
            if (self.display_hidden || self.is_photographing()) && !self.menus.shell.is_open() {
                return;
            }
        } else {
            self.show_console(context);
            self.show_photo_panel(context);
        }
        let covered = self.covered(context.content_rect());
        self.menus.shell.keep_toasts_off(covered);
        let running = self.running();
        let backdrop = self.backdrop.model();
        let intents = self
            .menus
            .show(context, &self.config, running.as_ref(), backdrop);
        for intent in intents {
            self.follow(intent);
        }
    }

    /// What lies on the world while no menu does.
    fn covered(&self, screen: egui::Rect) -> Option<egui::Rect> {
        if self.is_typing() {
            Some(Console::panel(screen))
        } else if self.is_packing() {
            Some(Backpack::panel(screen))
        } else {
            self.is_photographing()
                .then(|| antipode_ui::photo_panel(screen))
        }
    }

    fn running(&self) -> Option<Running> {
        let session = self.phase.session()?;
        let setup = session.scene.setup();
        let values = [
            ("name", legible_name(&setup.name, &session.slug).into()),
            ("seed", setup.seed.to_string().into()),
        ];
        let mut title = self.menus.texts.say_with("running-world", &values);
        if session.scene.cheated() {
            title = format!("{title} · {}", self.menus.texts.say("cheats-used"));
        }
        Some(Running {
            slug: session.slug.clone(),
            title: (!matches!(self.phase, Phase::Loading(_))).then_some(title),
        })
    }

    fn display(&mut self, drawn: Option<(Drawn, Option<f64>)>) -> Option<HudModel> {
        match &self.phase {
            Phase::Playing(session) if !self.display_hidden && !self.is_photographing() => {
                let fps = self.fps.value();
                let frame_ms = (fps > 0.0).then(|| 1000.0 / f64::from(fps));
                let figures = drawn.filter(|_| self.figures_shown).map(|(drawn, gpu_ms)| {
                    drawn.figures(
                        &self.menus.texts,
                        &session.scene,
                        frame_ms,
                        gpu_ms,
                        self.pace.dropped_s(),
                    )
                });
                let seen = session.between.seen(&session.scene);
                let mut model = hud::model(&self.menus.texts, &session.scene, &seen, fps, figures);
                let settings = &self.config.settings;
                let columns = columns_for(1e-3 * frame_ms.unwrap_or_default());
                let surveyed = (self.worlds_opened, columns);
                self.navigator
                    .add_to(&mut model, (&session.scene, &seen), settings, surveyed);
                Some(HudModel {
                    hint: self.hint().filter(|_| !self.is_packing()),
                    show_crosshair: model.show_crosshair && !self.is_packing(),
                    ..model
                })
            }
            _ => None,
        }
    }

    pub(super) fn follow(&mut self, intent: Intent) {
        match intent {
            Intent::Resume => self.resume(),
            Intent::Save => {
                if let Some(session) = self.phase.session_mut() {
                    session.scene.save();
                    self.since_save_s = 0.0;
                    self.saving = true;
                }
            }
            Intent::SaveAndQuitToMenu => self.leave(Next::Menu),
            Intent::NewGame {
                name,
                geometry,
                seed,
                radius_m,
            } => self.leave(Next::Open(Request::New(NewWorld {
                geometry: geometry_of(geometry),
                name: Some(name),
                seed,
                radius_m,
                start: Beginning::View,
            }))),
            Intent::Load { slug } => match self.menus.list.work_on(&self.menus.texts, &slug) {
                // It would be called in use by somebody else.
                Some(work) => self.menus.shell.toast(work, ToastKind::State),
                None => self.leave(Next::Open(Request::Load(slug))),
            },
            Intent::Set { id, value } => self.set_option(id, value),
            Intent::ResetSetting(id) => self.reset_option(id),
            Intent::Bind(profiles) => self.bind(*profiles),
            Intent::Delete { slug } => self.menus.list.delete(slug),
            Intent::Worlds(intent) => self.menus.list.follow(intent),
            Intent::Quit => self.leave(Next::Quit),
            Intent::TrySavingAgain => {
                let next = self.held_up.take().unwrap_or(Next::Menu);
                self.leave(next);
            }
            Intent::LeaveUnsaved => self.abandon(),
            Intent::DismissMessage => {
                self.held_up = None;
                if matches!(self.phase, Phase::Paused(_)) && !self.menus.shell.is_open() {
                    self.menus.shell.open(Screen::Main);
                }
            }
        }
    }
}

fn geometry_of(choice: GeometryChoice) -> Geometry {
    match choice {
        GeometryChoice::Hyperbolic => Geometry::Hyperbolic,
        GeometryChoice::Euclidean => Geometry::Euclidean,
        GeometryChoice::Spherical => Geometry::Spherical,
    }
}
