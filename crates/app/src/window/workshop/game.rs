//! The workshop in the game: when it is up, its keys, and what of the rest of the game it asks.

use std::time::Duration;

use antipode_room_scene::RoomScene;
use antipode_room_scene::tuning::EYE_M;
use antipode_rooms::RoomsDir;
use antipode_ui::workshop::{
    BarModel, LessonChoice, ToolChoice, WorkshopModel, WorkshopPanes, WorkshopWish,
};
use antipode_ui::{Intent, ToastKind};
use glam::DVec3;

use super::keeping::NotKept;
use super::wishes::{Bench, Outcome};
use super::{Lesson, Workshop, chosen, findings, lines};
use crate::bindings::Action;
use crate::room_picture::Tile;
use crate::window::game::Game;
use crate::window::phase::Phase;
use crate::window::press::{ESCAPE, Press, Taken};
use crate::window::visit::Visit;

impl Game {
    /// Builds in the open room, or walks in it again. Rooms of the game are copied first.
    pub fn toggle_workshop(&mut self) {
        self.devices.release_all();
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        if visit.workshop.is_some() {
            visit.keep_at_last();
            visit.walk();
            self.play.pace.rest();
            self.menus.shell.keep_toasts_within(None);
            return;
        }
        let kept = visit.room.kept.as_ref();
        if kept.is_none_or(|kept| kept.shipped) {
            self.menus.toast(ToastKind::State, "workshop-not-own", &[]);
            return;
        }
        if let Some(why) = visit.room.read_only() {
            let words = findings::note(&self.menus.texts, why).text;
            self.menus.shell.toast(words, ToastKind::State);
            return;
        }
        visit.build();
    }

    /// The layer of the workshop: the key that leads out of it, Esc, and what works everywhere.
    pub(in crate::window) fn press_in_workshop(&mut self, press: &Press) -> Taken {
        if !self.play.phase.is_built() || self.menus.shell.is_open() {
            return Taken::Not;
        }
        let Some(key) = press.fresh_key() else {
            return Taken::Not;
        };
        let does = |action| self.devices.controls.does(key, action);
        if does(Action::Workshop) {
            self.toggle_workshop();
        } else if key == ESCAPE {
            // Whoever types, and menus that are down, hear of it themselves.
            if !press.into_text {
                self.leave_off();
            }
            return Taken::AndHeard;
        } else if does(Action::Console) && !press.into_text {
            self.act(Action::Console);
        } else {
            return Taken::Not;
        }
        Taken::Wholly
    }

    /// Esc: gives up what is being done, then what is chosen, and then leads to the menu.
    fn leave_off(&mut self) {
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        let Some(workshop) = &mut visit.workshop else {
            return;
        };
        let scene = &mut visit.room.scene;
        if workshop.is_dropped || workshop.give_up(scene) {
            return;
        }
        if std::mem::take(&mut workshop.bar.flies) {
            return;
        }
        if scene.document().selection().is_empty() {
            visit.keep_at_last();
            self.pause();
        } else {
            scene.document_mut().select([]);
            workshop.told.forget();
        }
    }

    /// Lets time pass: what has changed is kept.
    pub(in crate::window) fn tick_workshop(&mut self, passed: Duration) {
        self.take_chosen();
        self.bring_in();
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        let Some(workshop) = &mut visit.workshop else {
            return;
        };
        let scene = &mut visit.room.scene;
        workshop.findings.pass(scene);
        if workshop.unsaved.is_some()
            && workshop.findings.rest()
            && workshop.findings.gravest(&self.menus.texts).is_none()
        {
            workshop.unsaved = None;
        }
        if let Some(lesson) = &mut visit.lesson
            && lesson.pass(scene)
        {
            workshop.bring_into_view(scene, &lesson.seen_together(scene.room()));
        }
        if let Some(why) = workshop.older.pass(scene) {
            self.menus.shell.toast(why, ToastKind::State);
        }
        if let Some(why) = workshop.keeping.pass(scene, passed.as_secs_f64()) {
            let found = workshop.findings.gravest(&self.menus.texts);
            let (words, reason) = match (why, found) {
                (NotKept::Failed(why), _) => ("workshop-not-kept", why),
                (NotKept::Unsound(_), Some(found)) => ("workshop-not-saved-yet", found),
                (NotKept::Unsound(_), None) if !workshop.findings.rest() => {
                    workshop.keeping.tell_again();
                    return;
                }
                (NotKept::Unsound(why), None) => ("workshop-not-saved-yet", why),
            };
            // Every edit that follows finds the same.
            if workshop.unsaved.as_ref() == Some(&reason) {
                return;
            }
            let values = [("reason", reason.as_str().into())];
            self.menus.toast(ToastKind::Problem, words, &values);
            workshop.unsaved = Some(reason);
        }
    }

    /// Ends the lesson when who walks has come into what was built.
    pub(in crate::window) fn watch_lesson(&mut self) {
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        let scene = &visit.room.scene;
        let walks = visit.workshop.is_none();
        if walks && (visit.lesson.as_mut()).is_some_and(|it| it.walk(scene)) {
            self.end_lesson(true);
        }
    }

    /// The lesson is over; whether it was done to its end.
    fn end_lesson(&mut self, done: bool) {
        let visit = self.play.phase.visit_mut();
        let lesson = visit.and_then(|visit| visit.lesson.take());
        self.options.keep_taught_to_build(true);
        if done {
            let words = match lesson.map(|it| it.choice()) {
                Some(LessonChoice::Doors) => "workshop-lesson-done-doors",
                _ => "workshop-lesson-done",
            };
            self.menus.toast(ToastKind::Info, words, &[]);
        }
    }

    /// What is asked for of the lesson.
    fn follow_lesson(&mut self, wish: &WorkshopWish) {
        let Some(visit) = self.play.phase.visit_mut() else {
            return;
        };
        let room = visit.room.scene.room();
        match wish {
            WorkshopWish::BeginLesson(choice) => {
                visit.lesson = Some(Lesson::begin(*choice, room));
                if let Some(workshop) = &mut visit.workshop {
                    workshop.step_out(&visit.room.scene);
                }
            }
            WorkshopWish::SkipStep => {
                let goes_on = (visit.lesson.as_mut()).is_some_and(|it| it.skip(room));
                if !goes_on {
                    self.end_lesson(false);
                }
            }
            _ => self.end_lesson(false),
        }
    }

    /// Draws the panes of the workshop, if it is up, and does what is asked for there.
    pub(in crate::window) fn show_workshop(&mut self, context: &egui::Context) {
        let is_free = !self.menus.shell.is_open();
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        if !visit.is_drawn || !is_free {
            return;
        }
        let Some(mut workshop) = visit.workshop.take() else {
            return;
        };
        if !self.options.config.taught_to_build && visit.lesson.is_none() {
            let lesson = Lesson::begin(LessonChoice::House, visit.room.scene.room());
            visit.lesson = Some(lesson);
        }
        let layout = &self.options.config.panes;
        let wishes = workshop.show(context, &self.menus.texts, visit, layout);
        let lies = workshop.layout();
        self.menus.shell.keep_toasts_within(workshop.view_rect());
        visit.workshop = Some(workshop);
        if let Some(lies) = lies {
            self.options.keep_panes(lies);
        }
        self.follow_workshop(wishes);
    }

    /// Does what is asked for in the workshop.
    pub(in crate::window) fn follow_workshop(&mut self, wishes: Vec<WorkshopWish>) {
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        let Some(mut workshop) = visit.workshop.take() else {
            return;
        };
        let (dir, slug) = (RoomsDir::new(visit.dir.clone()), visit.own_slug());
        let mut bench = Bench {
            scene: &mut visit.room.scene,
            dir: &dir,
            slug: &slug,
            reading: &mut visit.reading,
            texts: &self.menus.texts,
        };
        let (mut plays, mut keeps, mut leaves) = (false, false, false);
        let mut refused = None;
        let mut of_lesson = Vec::new();
        for wish in wishes {
            workshop.told.note(&wish);
            if is_of_lesson(&wish) {
                of_lesson.push(wish);
                continue;
            }
            match workshop.follow(&mut bench, wish) {
                Some(Outcome::Play) => plays = true,
                Some(Outcome::Keep) => keeps = true,
                Some(Outcome::Leave) => leaves = true,
                Some(Outcome::Refused(why)) => refused = Some(why),
                None => {}
            }
        }
        visit.workshop = Some(workshop);
        // A drag that goes on is kept when it ends.
        if keeps && !visit.room.scene.document().is_dragging() {
            // Why it cannot be kept is told anew.
            let waits = (visit.workshop.as_mut()).is_some_and(|it| it.unsaved.take().is_some());
            visit.keep_at_last();
            if !waits {
                self.menus.toast(ToastKind::Info, "workshop-kept", &[]);
            }
        }
        self.go_on_reading();
        for wish in of_lesson {
            self.follow_lesson(&wish);
        }
        if let Some(why) = refused {
            self.menus.shell.toast(why, ToastKind::State);
        }
        if plays {
            self.toggle_workshop();
        } else if leaves {
            if let Some(visit) = self.play.phase.visit_mut() {
                visit.keep_at_last();
            }
            // The list gets a picture, as it does by the menu.
            self.pause();
            self.follow(Intent::SaveAndQuitToMenu);
        }
    }
}

impl Visit {
    /// The folder of a room of the player's own; empty for one that is kept nowhere.
    pub(in crate::window) fn own_slug(&self) -> String {
        let kept = self.room.kept.as_ref().filter(|kept| !kept.shipped);
        kept.map_or_else(String::new, |kept| kept.slug.clone())
    }

    /// The workshop is left: what has changed is written.
    pub(in crate::window) fn keep_at_last(&mut self) {
        if let Some(workshop) = &mut self.workshop {
            let scene = &mut self.room.scene;
            scene.document_mut().end_drag();
            workshop.keeping.save(scene);
        }
    }
}

impl Workshop {
    /// Where the room is seen, points.
    fn view_rect(&self) -> Option<egui::Rect> {
        self.panes.as_ref().map(WorkshopPanes::view_rect)
    }

    /// Who looks from within a space looks from where one begins.
    fn step_out(&mut self, scene: &RoomScene) {
        if !self.camera.eye(scene.space(), 1.0).place.stack.is_empty() {
            let spawn = scene.room().spawn;
            self.camera.point = spawn.at + DVec3::Y * EYE_M;
            self.camera.aim_deg = spawn.look;
            self.forget_chain();
        }
    }

    /// The room was changed from elsewhere.
    pub(in crate::window) fn look_anew(&mut self) {
        self.forget_chain();
        self.told.forget();
    }

    /// How the panes lie, if somebody has moved them.
    fn layout(&self) -> Option<String> {
        self.panes.as_ref().and_then(WorkshopPanes::changed_layout)
    }

    /// Draws the panes.
    fn show(
        &mut self,
        context: &egui::Context,
        texts: &antipode_language::Texts,
        visit: &Visit,
        layout: &str,
    ) -> Vec<WorkshopWish> {
        let scene = visit.scene();
        let document = scene.document();
        if self.told.renew(texts, scene) && self.camera.parallel.is_some() {
            self.camera.parallel = Some(scene.radius_m());
        }
        self.part_pictures.add_to(context, &mut self.told.parts);
        let told = &self.told;
        let (steps, made) = (told.history.len(), document.history().made());
        let bar = BarModel {
            can_undo: made > 0,
            can_redo: made < steps,
            has_chosen: !document.selection().is_empty(),
            has_copied: !document.clipboard().is_empty(),
            parallel: self.camera.parallel.is_some(),
            hides_walls: scene.leaves_out_walls(),
            ..self.bar
        };
        let status = if visit.is_late {
            texts.say("workshop-status-late")
        } else {
            self.status(texts, scene)
        };
        let lesson = visit.lesson.as_ref();
        let lesson = lesson.map(|it| it.model(texts, scene.room()));
        let model = WorkshopModel {
            texts,
            room: &scene.room().name,
            objects: &told.objects,
            chosen: &told.chosen,
            fields: &told.fields,
            parts: &told.parts,
            messages: &self.findings.rows(texts),
            history: &told.history,
            older: self.older.rows(),
            done: made,
            bar,
            lines: &lines::lines(self, scene, texts),
            status: &status,
            lesson: lesson.as_ref(),
            examples: &self.pictures.rows(context, texts),
            chooser: self.choosing.as_mut().map(|it| it.model(texts)),
        };
        let width = context.content_rect().width();
        let panes = self
            .panes
            .get_or_insert_with(|| WorkshopPanes::new(layout, width));
        let wishes = panes.show(context, &model);
        self.is_dropped =
            egui::Popup::is_any_open(context) || panes.has_page() || self.choosing.is_some();
        let rect = panes.view_rect();
        self.tile = tile(rect, context).map(|tile| (tile, f64::from(rect.height())));
        wishes
    }

    /// What stands at the lower end of the view: what keys do just now.
    fn status(&self, texts: &antipode_language::Texts, scene: &RoomScene) -> String {
        if self.bar.flies {
            texts.say("workshop-status-flies")
        } else if scene.document().selection().is_empty() {
            texts.say("workshop-status-nothing")
        } else {
            texts.say(match self.bar.tool {
                ToolChoice::Move => "workshop-status-chosen",
                ToolChoice::Turn => "workshop-status-turn",
                ToolChoice::Scale if chosen::is_group(scene) => "workshop-status-scale-whole",
                ToolChoice::Scale => "workshop-status-scale",
            })
        }
    }
}

fn is_of_lesson(wish: &WorkshopWish) -> bool {
    matches!(
        wish,
        WorkshopWish::BeginLesson(_) | WorkshopWish::SkipStep | WorkshopWish::EndLesson
    )
}

/// A part of the window in pixels, if there is any of it.
fn tile(rect: egui::Rect, context: &egui::Context) -> Option<Tile> {
    let scale = context.pixels_per_point();
    let whole = context.content_rect();
    let inside = rect.intersect(whole);
    if !inside.is_finite() || inside.width() < 2.0 || inside.height() < 2.0 {
        return None;
    }
    let pixels = |points: f32| (points * scale).round().max(0.0) as u32;
    let (left, top) = (pixels(inside.min.x), pixels(inside.min.y));
    Some(Tile {
        corner: (left, top),
        size: (pixels(inside.max.x) - left, pixels(inside.max.y) - top),
    })
}
