//! What can be changed of what is chosen, field by field.

use egui::scroll_area::ScrollBarVisibility;
use egui::{Align, Label, Layout, RichText, ScrollArea, Ui};

use super::field;
use super::lesson;
use super::model::{FieldKind, FieldRow, LessonTarget, Unit, WorkshopModel, WorkshopWish};
use crate::theme::{ACCENT, TEXT, WEAK};
use crate::widgets::focus_ring;

/// How wide the number beside a slider's name is, and from which width of the pane on it has a line of its own, points.
const TIMES: f32 = 64.0;
const NARROW: f32 = 220.0;

/// Draws it.
pub(super) fn show(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    ui.add(Label::new(RichText::new(model.chosen).color(TEXT).strong()).truncate());
    // A bar that comes and goes would change how wide the fields are.
    let bar = ScrollBarVisibility::AlwaysVisible;
    let area = ScrollArea::vertical().scroll_bar_visibility(bar);
    area.auto_shrink(false).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        ui.spacing_mut().interact_size.y = 18.0;
        for row in model.fields {
            let from = ui.cursor().min;
            ui.push_id(&row.key, |ui| self::row(ui, model, row, wishes));
            let to = egui::pos2(ui.max_rect().max.x, ui.cursor().min.y);
            let target = LessonTarget::Field(row.key.clone());
            lesson::point_out(ui, model, &target, egui::Rect::from_min_max(from, to));
        }
    });
}

fn row(ui: &mut Ui, model: &WorkshopModel<'_>, row: &FieldRow, wishes: &mut Vec<WorkshopWish>) {
    if let FieldKind::Words(words, is_warning) = &row.kind {
        let colour = if *is_warning { ACCENT } else { WEAK };
        ui.add(Label::new(RichText::new(words).color(colour).small()).wrap());
        return;
    }
    let stretch = match &row.kind {
        FieldKind::Stretch(value) => Some(*value),
        _ => None,
    };
    let is_narrow = ui.available_width() < NARROW;
    if let Some(value) = stretch.filter(|_| !is_narrow) {
        // A number stands at the right end, and a long name in two lines before it.
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                field::times(ui, model.texts, row, value, (TIMES, wishes));
                reset(ui, model, row, wishes);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| name(ui, row));
            });
        });
    } else {
        ui.horizontal_wrapped(|ui| {
            name(ui, row);
            reset(ui, model, row, wishes);
        });
    }
    if let Some(value) = stretch.filter(|_| is_narrow) {
        let width = ui.available_width();
        field::times(ui, model.texts, row, value, (width, wishes));
    }
    field::show(ui, model.texts, row, wishes);
    ui.add_space(2.0);
}

fn name(ui: &mut Ui, row: &FieldRow) {
    let axes = match &row.kind {
        FieldKind::Numbers(all, unit) if all.len() == 3 && *unit != Unit::Degrees => " (x, y, z)",
        _ => "",
    };
    let words = format!("{}{axes}", row.label);
    let label = ui.add(Label::new(RichText::new(words).color(WEAK).small()).wrap());
    if !row.about.is_empty() {
        label.on_hover_text(&row.about);
    }
}

/// The button that leaves a field as it is when nothing is said of it; none where it is so.
fn reset(ui: &mut Ui, model: &WorkshopModel<'_>, row: &FieldRow, wishes: &mut Vec<WorkshopWish>) {
    if row.is_default {
        return;
    }
    let values = [("name", row.label.as_str().into())];
    let label = model.texts.say_with("workshop-reset", &values);
    let words = RichText::new(model.texts.say("workshop-reset-short"));
    let response = ui.add(egui::Button::new(words.color(WEAK).small()).small());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &label));
    focus_ring(ui, &response);
    if response.on_hover_text(&label).clicked() {
        wishes.push(WorkshopWish::Reset(row.key.clone()));
    }
}
