//! What is wrong with the room, and what was done to it: lines that lead there.

use egui::{Button, RichText, ScrollArea, Ui, vec2};

use super::model::{WorkshopModel, WorkshopWish};
use crate::theme::{ACCENT, BAD, GOOD, TEXT, WEAK};
use crate::widgets::focus_ring;

/// What is wrong with the room.
pub(super) fn messages(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        if model.messages.is_empty() {
            let well = model.texts.say("workshop-all-well");
            ui.label(RichText::new(well).color(GOOD));
        }
        for (number, message) in model.messages.iter().enumerate() {
            let colour = if message.is_grave { BAD } else { ACCENT };
            let words = RichText::new(&message.text).color(colour);
            let width = ui.available_width();
            let button = Button::new(words).frame(false).wrap();
            let response = ui
                .scope(|ui| {
                    ui.set_max_width(width);
                    ui.add(button)
                })
                .inner;
            focus_ring(ui, &response);
            if response.clicked() {
                wishes.push(WorkshopWish::ShowMessage(number));
            }
        }
    });
}

/// What was done: a click leads back to there, or forth.
pub(super) fn history(ui: &mut Ui, model: &WorkshopModel<'_>, wishes: &mut Vec<WorkshopWish>) {
    super::older::list(ui, model, wishes);
    let height = 22.0;
    let beginning = model.texts.say("workshop-beginning");
    let mut area = ScrollArea::vertical()
        .auto_shrink(false)
        .stick_to_bottom(true);
    // What holds after a step back comes into view.
    let id = ui.scope_id().with("done");
    let last = ui.data_mut(|data| data.get_temp::<usize>(id));
    ui.data_mut(|data| data.insert_temp(id, model.done));
    if last.is_some_and(|last| last != model.done) {
        let above = model.done.saturating_sub(2) as f32;
        area = area.vertical_scroll_offset(above * (height + ui.spacing().item_spacing.y));
    }
    area.show_rows(ui, height, model.history.len() + 1, |ui, range| {
        for step in range {
            let text = match step.checked_sub(1) {
                None => &beginning,
                Some(before) => &model.history[before].text,
            };
            let colour = if step > model.done { WEAK } else { TEXT };
            let button = Button::new(RichText::new(text).color(colour))
                .selected(step == model.done)
                .frame(step == model.done)
                .truncate();
            let size = vec2(ui.available_width(), height - 4.0);
            let response = ui.add_sized(size, button);
            focus_ring(ui, &response);
            // Whole, where the pane is too narrow for it.
            if response.on_hover_text(text).clicked() {
                wishes.push(WorkshopWish::GoTo(step));
            }
        }
    });
}
