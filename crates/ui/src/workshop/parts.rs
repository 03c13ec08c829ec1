//! What can be put in: a click puts a part before the camera, on what is seen there.

use std::sync::Arc;

use egui::scroll_area::ScrollBarVisibility;
use egui::{Align, Color32, Galley, Rect, Response, RichText, ScrollArea, Sense, Ui, pos2, vec2};

use super::lesson;
use super::model::{LessonTarget, PartRow, WorkshopModel, WorkshopWish};
use crate::theme::{GRID, TEXT, WEAK};
use crate::widgets::{column_button, paint_card};

/// How wide a card is at least, points.
const CARD: f32 = 104.0;
/// How wide it is at most.
const WIDEST: f32 = 180.0;
/// Width over height of pictures.
const ASPECT: f32 = 4.0 / 3.0;
/// Between a card's edge and what is in it, points.
const MARGIN: f32 = 4.0;

/// Draws the list: a picture of each part with its word below.
pub(super) fn show(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let hint = model.texts.say("workshop-parts-hint");
    ui.label(RichText::new(hint).color(WEAK).small());
    let from_file = model.texts.say("workshop-do-from-file");
    if column_button(ui, &from_file, false).clicked() {
        wishes.push(WorkshopWish::ChooseFile);
    }
    // A bar that comes and goes would change how large the cards are, and by that whether there is one.
    let area = ScrollArea::vertical().scroll_bar_visibility(ScrollBarVisibility::AlwaysVisible);
    area.auto_shrink(false).show(ui, |ui| {
        // Rings of the focus and of the lesson lie outside of cards.
        let whole = ui.available_width() - GRID;
        let columns = ((whole + GRID) / (CARD + GRID)).floor().max(1.0);
        let width = ((whole - GRID * (columns - 1.0)) / columns).min(WIDEST);
        ui.spacing_mut().item_spacing = vec2(GRID, GRID);
        for row in model.parts.chunks(columns as usize) {
            let words: Vec<_> = row.iter().map(|it| words(ui, &it.label, width)).collect();
            let highest = words.iter().map(|it| it.size().y).fold(0.0, f32::max);
            ui.horizontal_top(|ui| {
                for (part, words) in row.iter().zip(words) {
                    let response = card(ui, part, words, vec2(width, highest));
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
    });
}

/// A part's word in the middle of its card, on as many lines as it needs.
fn words(ui: &Ui, label: &str, width: f32) -> Arc<Galley> {
    let font = egui::FontId::proportional(13.0);
    let inner = width - 2.0 * MARGIN;
    let mut job = egui::text::LayoutJob::simple(label.to_owned(), font, TEXT, inner);
    job.halign = Align::Center;
    ui.painter().layout_job(job)
}

/// Draws one of that width, with room for words of that height.
fn card(ui: &mut Ui, part: &PartRow, words: Arc<Galley>, size: egui::Vec2) -> Response {
    let picture = vec2(size.x, (size.x - 2.0 * MARGIN) / ASPECT);
    let whole = vec2(size.x, picture.y + size.y + 3.0 * MARGIN);
    let (rect, response) = ui.allocate_exact_size(whole, Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), &part.label)
    });
    paint_card(ui, &response, false);
    let inner = Rect::from_min_size(rect.min, picture).shrink2(vec2(MARGIN, 0.0));
    let inner = inner.translate(vec2(0.0, MARGIN));
    if let Some(id) = part.picture {
        let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        ui.painter().image(id, inner, all, Color32::WHITE);
    } else {
        ui.painter()
            .rect_filled(inner, 2, Color32::from_white_alpha(12));
    }
    let at = pos2(rect.center().x, inner.max.y + MARGIN);
    ui.painter().galley(at, words, TEXT);
    response
}
