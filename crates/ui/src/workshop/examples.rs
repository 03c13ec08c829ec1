//! What is possible: a page of small examples, each of which can be put into the room as it is.

use egui::{Grid, Id, Image, Modal, RichText, ScrollArea, Ui, load::SizedTexture, vec2};

use super::model::{ExampleRow, WorkshopModel, WorkshopWish};
use crate::theme::{GRID, TEXT, WEAK};
use crate::widgets::{button, primary_button};

/// How wide a card is at least, points.
const CARD: f32 = 200.0;
/// Width over height of their pictures.
const ASPECT: f32 = 16.0 / 9.0;

/// Draws it while it is `open`.
pub(super) fn show(
    ui: &Ui,
    model: &WorkshopModel<'_>,
    open: &mut bool,
    wishes: &mut Vec<WorkshopWish>,
) {
    if !*open {
        return;
    }
    let screen = ui.ctx().content_rect();
    let columns = if screen.width() < 900.0 { 2 } else { 3 };
    let width = (0.86 * screen.width()).min(columns as f32 * 260.0);
    let response = Modal::new(Id::unique("antipode-workshop-examples")).show(ui.ctx(), |ui| {
        ui.style_mut().override_font_id = Some(egui::FontId::proportional(14.0));
        ui.spacing_mut().item_spacing = vec2(GRID, 4.0);
        ui.spacing_mut().button_padding = vec2(8.0, 3.0);
        ui.spacing_mut().interact_size.y = 26.0;
        ui.set_width(width);
        let title = model.texts.say("workshop-examples-title");
        ui.label(RichText::new(title).color(TEXT).size(20.0));
        let about = model.texts.say("workshop-examples-about");
        ui.add(egui::Label::new(RichText::new(about).color(WEAK)).wrap());
        ui.add_space(4.0);
        let card = (width - 10.0 - columns as f32 * GRID) / columns as f32;
        ScrollArea::vertical()
            .max_height(screen.height() - 190.0)
            .show(ui, |ui| {
                Grid::new("examples")
                    .num_columns(columns)
                    .spacing(vec2(GRID, 2.0 * GRID))
                    .show(ui, |ui| {
                        for (number, row) in model.examples.iter().enumerate() {
                            if self::card(ui, model, row, card.max(CARD * 0.7)) {
                                wishes.push(WorkshopWish::Put(row.id.clone()));
                                *open = false;
                            }
                            if (number + 1) % columns == 0 {
                                ui.end_row();
                            }
                        }
                    });
            });
        ui.add_space(4.0);
        if button(ui, &model.texts.say("workshop-examples-close")).clicked() {
            *open = false;
        }
    });
    *open &= !response.should_close();
}

/// Draws one; whether it is to be put into the room.
fn card(ui: &mut Ui, model: &WorkshopModel<'_>, row: &ExampleRow, width: f32) -> bool {
    ui.vertical(|ui| {
        ui.set_width(width);
        if let Some(picture) = row.picture {
            let size = vec2(width, width / ASPECT);
            ui.add(Image::new(SizedTexture::new(picture, size)).corner_radius(4));
        }
        ui.label(RichText::new(&row.label).color(TEXT).strong());
        ui.add(egui::Label::new(RichText::new(&row.about).color(WEAK).small()).wrap());
        let values = [("name", row.label.as_str().into())];
        let response = primary_button(ui, &model.texts.say("workshop-examples-copy"), true);
        let label = model
            .texts
            .say_with("workshop-examples-copy-named", &values);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &label));
        response.clicked()
    })
    .inner
}
