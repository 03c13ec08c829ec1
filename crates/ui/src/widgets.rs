//! The few widgets egui has not: menu buttons with a focus ring.

use egui::text::LayoutJob;
use egui::{Button, Color32, FontId, Response, RichText, Stroke, StrokeKind, Ui, vec2};

use crate::theme::{ACCENT, FOCUS, GRID, ON_ACCENT, ROUNDING};

/// Draws the ring round what has the focus, and brings it into view when it
/// has just got it.
pub(crate) fn focus_ring(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let stroke = Stroke::new(2.0, FOCUS);
        let rect = response.rect.expand(1.0);
        ui.painter()
            .rect_stroke(rect, ROUNDING + 1, stroke, StrokeKind::Outside);
    }
    if response.gained_focus() {
        ui.scroll_to_rect(response.rect.expand(GRID), None);
    }
}

/// A button of the common kind.
pub(crate) fn button(ui: &mut Ui, label: &str) -> Response {
    let response = ui.add(Button::new(label));
    focus_ring(ui, &response);
    response
}

/// The button that does what the screen is for.
pub(crate) fn primary_button(ui: &mut Ui, label: &str, enabled: bool) -> Response {
    let text = RichText::new(label).color(ON_ACCENT);
    let response = ui.add_enabled(enabled, Button::new(text).fill(ACCENT));
    focus_ring(ui, &response);
    response
}

/// A button as wide as its column; `chosen` marks the screen that is up.
pub(crate) fn column_button(ui: &mut Ui, label: &str, chosen: bool) -> Response {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let response = ui.add(Button::new(label).min_size(size).selected(chosen));
    focus_ring(ui, &response);
    response
}

/// Text on one line of at most `width`, ended by an ellipsis where it is cut.
pub(crate) fn one_line(text: &str, font: FontId, colour: Color32, width: f32) -> LayoutJob {
    let mut job = LayoutJob::simple_singleline(text.to_owned(), font, colour);
    job.wrap.max_width = width.max(0.0);
    job.wrap.max_rows = 1;
    job.wrap.break_anywhere = true;
    job
}

/// Whose fill and outline a row or card has in its present state.
pub(crate) fn paint_card(ui: &Ui, response: &Response, chosen: bool) {
    let visuals = ui.style().interact_selectable(response, chosen);
    let line = if chosen {
        ACCENT
    } else {
        visuals.bg_stroke.color
    };
    ui.painter().rect(
        response.rect,
        ROUNDING,
        visuals.weak_bg_fill,
        Stroke::new(if chosen { 2.0 } else { 1.0 }, line),
        StrokeKind::Inside,
    );
    focus_ring(ui, response);
}
