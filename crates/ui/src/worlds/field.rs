//! Lines of text that the screens about worlds have filled in.

use egui::{Color32, Response, RichText, Ui};

use crate::entry;
use crate::theme::small;

/// Longest text a field takes: as long as paths get.
const LIMIT: usize = 4096;

/// A line of text that up and down leave: in a single line they mean nothing.
pub(super) fn line(ui: &mut Ui, text: &mut String) -> Response {
    entry::line(ui, text, "", LIMIT)
}

/// What there is to say of a field, under it.
pub(super) fn note(ui: &mut Ui, words: &str, colour: Color32) {
    ui.add(egui::Label::new(RichText::new(words).font(small()).color(colour)).wrap());
}
