//! Lines of text that the screens about worlds have filled in.

use egui::{Color32, EventFilter, Response, RichText, TextEdit, Ui};

use crate::theme::small;

/// Longest text a field takes: as long as paths get.
const LIMIT: usize = 4096;

/// A line of text that up and down leave: in a single line they mean nothing.
pub(super) fn line(ui: &mut Ui, text: &mut String) -> Response {
    let filter = EventFilter {
        horizontal_arrows: true,
        ..Default::default()
    };
    let edit = TextEdit::singleline(text)
        .char_limit(LIMIT)
        .desired_width(f32::INFINITY)
        .event_filter(filter);
    let response = ui.add(edit);
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    response
}

/// What there is to say of a field, under it.
pub(super) fn note(ui: &mut Ui, words: &str, colour: Color32) {
    ui.add(egui::Label::new(RichText::new(words).font(small()).color(colour)).wrap());
}
