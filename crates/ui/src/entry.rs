//! A line of text to fill in.

use egui::{EventFilter, Response, Role, TextEdit, Ui, WidgetInfo};

/// Longest text it takes: far beyond what is of use, but a pasted book stays out.
const LIMIT: usize = 200;

/// A line of text that up and down leave: in a single line they mean nothing. `name` is what screen readers call it.
pub(crate) fn entry(ui: &mut Ui, text: &mut String, name: &str, hint: &str) -> Response {
    let filter = EventFilter {
        horizontal_arrows: true,
        ..Default::default()
    };
    let edit = TextEdit::singleline(text)
        .hint_text(hint)
        .char_limit(LIMIT)
        .desired_width(f32::INFINITY)
        .event_filter(filter);
    let response = ui.add(edit);
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, name));
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    response
}
