//! Asks before a world or room is deleted, and lists everything that would be gone.

use egui::{Rect, RichText, Ui, vec2};

use super::{Kind, edits, facts, picture};
use crate::dialog::dialog;
use crate::model::WorldRow;
use crate::shell::Pass;
use crate::theme::{BAD, GRID};
use crate::widgets::{button, focus_ring};

/// Height of the picture where there is room, in points.
const PICTURE_HEIGHT: f32 = 108.0;

/// Draws the question: `Some(true)` to delete it, `Some(false)` to keep it.
pub(super) fn show(ui: &mut Ui, pass: &mut Pass<'_>, kind: Kind, row: &WorldRow) -> Option<bool> {
    let texts = pass.model.texts;
    let title = texts.say_with(
        "worlds-delete-question",
        &[("name", row.name.as_str().into())],
    );
    let words = [facts(pass, row), edits(pass, kind, row), row.path.clone()];
    let words: Vec<_> = words.into_iter().filter(|line| !line.is_empty()).collect();
    let line = ui.fonts_mut(|fonts| fonts.row_height(&egui::FontId::proportional(16.0)));
    let buttons = ui.spacing().interact_size.y + line + 2.0 * GRID;
    let pictured = pass.regions.whole.height() >= 480.0;
    let below = buttons + if pictured { PICTURE_HEIGHT + GRID } else { 0.0 };
    let mut answer = None;
    let mut safe = None;
    dialog(ui, pass, &title, &words.join("\n"), below, |ui| {
        if pictured {
            let size = picture::size(PICTURE_HEIGHT);
            let size = size.min(vec2(ui.available_width(), size.y));
            let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
            picture::paint(ui.painter(), Rect::from_min_size(rect.min, size), kind, row);
        }
        ui.label(texts.say("worlds-delete-final"));
        ui.horizontal(|ui| {
            let label = RichText::new(texts.say("worlds-delete")).color(BAD);
            let delete = ui.add(egui::Button::new(label));
            focus_ring(ui, &delete);
            let keep = button(ui, &texts.say("worlds-keep"));
            if delete.clicked() {
                answer = Some(true);
            } else if keep.clicked() {
                answer = Some(false);
            }
            safe = Some(keep);
        });
    });
    if let Some(keep) = safe {
        pass.offer_focus(&keep);
    }
    answer
}
