//! What can be put in: a click puts a part before the camera, on what is seen there.

use egui::{RichText, ScrollArea, Ui};

use super::lesson;
use super::model::{LessonTarget, WorkshopModel, WorkshopWish};
use crate::theme::WEAK;
use crate::widgets::column_button;

/// Draws the list.
pub(super) fn show(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let hint = model.texts.say("workshop-parts-hint");
    ui.label(RichText::new(hint).color(WEAK).small());
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for part in model.parts {
            let response = column_button(ui, &part.label, false);
            let target = LessonTarget::Part(part.id.clone());
            lesson::point_out(ui, model, &target, response.rect);
            if response.clicked() {
                wishes.push(WorkshopWish::Put(part.id.clone()));
            }
            if !part.about.is_empty() {
                response.on_hover_text(&part.about);
            }
        }
    });
}
