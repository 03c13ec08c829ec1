//! Lines of text to fill in, and numbers typed there.

use egui::{EventFilter, Response, Role, TextEdit, Ui, WidgetInfo};

/// Longest text it takes: far beyond what is of use, but a pasted book stays out.
const LIMIT: usize = 200;

/// A line of text that up and down leave: in a single line they mean nothing.
pub(crate) fn line(ui: &mut Ui, text: &mut String, hint: &str, limit: usize) -> Response {
    let filter = EventFilter {
        horizontal_arrows: true,
        ..Default::default()
    };
    let edit = TextEdit::singleline(text)
        .hint_text(hint)
        .char_limit(limit)
        .desired_width(f32::INFINITY)
        .event_filter(filter);
    let response = ui.add(edit);
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    response
}

/// The same with a name, which is what screen readers call it.
pub(crate) fn entry(ui: &mut Ui, text: &mut String, name: &str, hint: &str) -> Response {
    named_line(ui, text, name, hint, LIMIT)
}

/// The same for so many characters.
pub(crate) fn named_line(
    ui: &mut Ui,
    text: &mut String,
    name: &str,
    hint: &str,
    limit: usize,
) -> Response {
    let response = line(ui, text, hint, limit);
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, name));
    response
}

/// What somebody types as a number, with its unit or without, with a point or a comma.
pub(crate) fn parse_number(text: &str) -> Option<f64> {
    let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '-');
    let end = digits
        .find(|c: char| !c.is_ascii_digit() && !"-.,".contains(c))
        .unwrap_or(digits.len());
    digits[..end].replace(',', ".").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_their_units_and_in_every_manner() {
        for (text, number) in [
            ("75", Some(75.0)),
            ("75°", Some(75.0)),
            (" 0,12 ° na piksel", Some(0.12)),
            ("× 1.5", Some(1.5)),
            ("-3", Some(-3.0)),
            ("4 chunks", Some(4.0)),
            ("", None),
            ("wide", None),
        ] {
            assert_eq!(parse_number(text), number, "{text}");
        }
    }
}
