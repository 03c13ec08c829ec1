//! Older versions of the room: a list above what was done, from which one is taken in place of the room as it is.

use egui::{Button, RichText, ScrollArea, Ui, vec2};

use super::model::{WorkshopModel, WorkshopWish};
use crate::theme::{TEXT, WEAK};
use crate::widgets::focus_ring;

/// Height of a line, points.
const LINE: f32 = 22.0;
/// The list is no higher, points.
const HIGHEST: f32 = 160.0;

/// The button that opens the list, and the list.
pub(super) fn list(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    let is_open = model.older.is_some();
    let button = Button::new(model.texts.say("workshop-older")).selected(is_open);
    let response = ui.add_sized(vec2(ui.available_width(), LINE), button.truncate());
    focus_ring(ui, &response);
    if response.clicked() {
        wishes.push(WorkshopWish::ShowOlder(!is_open));
    }
    let Some(rows) = model.older else { return };
    let about = if rows.is_empty() {
        "workshop-older-none"
    } else {
        "workshop-older-about"
    };
    ui.label(RichText::new(model.texts.say(about)).color(WEAK));
    ScrollArea::vertical()
        .id_salt("older")
        .max_height(HIGHEST)
        .auto_shrink([false, true])
        .show_rows(ui, LINE, rows.len(), |ui, range| {
            for row in &rows[range] {
                let button = Button::new(RichText::new(&row.text).color(TEXT)).frame(false);
                let response = ui.add_sized(vec2(ui.available_width(), LINE - 4.0), button);
                focus_ring(ui, &response);
                if response.clicked() {
                    wishes.push(WorkshopWish::OpenOlder(row.when_s));
                }
            }
        });
    ui.separator();
}
