//! The lesson: a card over the view that says one deed in a sentence, and a ring round what it is done with.

use egui::{Area, Id, Order, Rect, RichText, Stroke, StrokeKind, Ui, pos2, vec2};

use super::model::{LessonTarget, WorkshopModel, WorkshopWish};
use crate::theme::{ACCENT, GRID, ROUNDING, TEXT, panel};
use crate::widgets::button;

/// A lesson that can be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonChoice {
    /// A house that is larger inside.
    House,
    /// A tunnel, and two portals that lead to each other.
    Doors,
}

/// Widest the card gets, points.
const WIDEST: f32 = 420.0;
/// How wide the ring is, points.
const RING: f32 = 3.0;

/// Draws the card at the top of the view, if a lesson is taken.
pub(super) fn show(ui: &Ui, view: Rect, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let Some(lesson) = model.lesson else { return };
    let texts = model.texts;
    let width = WIDEST.min(view.width() - 2.0 * GRID);
    if width < 80.0 {
        return;
    }
    let corner = pos2(view.center().x - width / 2.0, view.min.y + GRID);
    let values = [("number", lesson.number.into()), ("of", lesson.of.into())];
    let title = texts.say_with("workshop-lesson-title", &values);
    Area::new(Id::unique("antipode-workshop-lesson"))
        .order(Order::Middle)
        .fixed_pos(corner)
        .movable(false)
        .show(ui.ctx(), |ui| {
            ui.style_mut().override_font_id = Some(egui::FontId::proportional(14.0));
            ui.spacing_mut().item_spacing = vec2(6.0, 4.0);
            ui.spacing_mut().button_padding = vec2(8.0, 3.0);
            ui.spacing_mut().interact_size.y = 24.0;
            let background = ui.painter().add(egui::Shape::Noop);
            let response = egui::Frame::NONE.inner_margin(GRID).show(ui, |ui| {
                ui.set_width(width - 2.0 * GRID);
                ui.label(RichText::new(title).color(ACCENT).small());
                ui.add(egui::Label::new(RichText::new(&lesson.text).color(TEXT)).wrap());
                ui.horizontal_wrapped(|ui| {
                    if button(ui, &texts.say("workshop-lesson-skip")).clicked() {
                        wishes.push(WorkshopWish::SkipStep);
                    }
                    if button(ui, &texts.say("workshop-lesson-end")).clicked() {
                        wishes.push(WorkshopWish::EndLesson);
                    }
                });
            });
            ui.painter().set(background, panel(response.response.rect));
        });
}

/// Rings what the lesson is done with, if that is it.
pub(super) fn point_out(ui: &Ui, model: &WorkshopModel<'_>, it: &LessonTarget, rect: Rect) {
    let Some(lesson) = model.lesson.filter(|lesson| lesson.target == *it) else {
        return;
    };
    ring(ui, rect);
    // It comes into view once, and can be scrolled away then.
    let id = Id::unique("antipode-workshop-pointed");
    if ui.data(|data| data.get_temp(id)) != Some(lesson.number) {
        ui.data_mut(|data| data.insert_temp(id, lesson.number));
        ui.scroll_to_rect(rect, Some(egui::Align::Center));
    }
}

fn ring(ui: &Ui, rect: Rect) {
    let stroke = Stroke::new(RING, ACCENT);
    // Panes cut off what lies above their first and below their last line.
    let rect = rect.expand2(vec2(2.0 * RING, 1.0));
    ui.painter()
        .rect_stroke(rect, ROUNDING, stroke, StrokeKind::Inside);
}
