//! The few widgets egui has not: menu buttons with a focus ring, and the row of
//! a world.

use egui::text::LayoutJob;
use egui::{
    Button, Color32, FontId, Response, RichText, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    vec2,
};

use crate::model::WorldRow;
use crate::theme::{ACCENT, BAD, FOCUS, ON_ACCENT, ROUNDING, TEXT, WEAK, small};

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
        response.scroll_to_me(None);
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

/// One world as one wide button, called "`verb` “name”" by screen readers.
/// `remark` is a line more, in words; `bad` colours it as a problem.
pub(crate) fn world_row(
    ui: &mut Ui,
    row: &WorldRow,
    verb: &str,
    remark: Option<&str>,
    bad: bool,
) -> Response {
    let width = ui.available_width();
    let inner = (width - 24.0).max(1.0);
    let painter = ui.painter().clone();
    let mut lines =
        vec![painter.layout_job(one_line(&row.name, FontId::proportional(16.0), TEXT, inner))];
    let facts = [
        row.geometry.as_str(),
        &format!("played {}", row.played),
        &row.last_played,
        &row.size,
    ]
    .iter()
    .filter(|fact| !fact.is_empty())
    .copied()
    .collect::<Vec<_>>()
    .join("  ·  ");
    lines.push(painter.layout(facts, small(), WEAK, inner));
    if let Some(remark) = remark {
        let colour = if bad { BAD } else { ACCENT };
        lines.push(painter.layout(remark.to_owned(), small(), colour, inner));
    }
    let height = lines.iter().map(|line| line.size().y + 2.0).sum::<f32>() + 14.0;
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
    let label = format!("{verb} “{}”", row.name);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
    if ui.is_rect_visible(rect) {
        paint_card(ui, &response, false);
        let mut at = rect.min + vec2(12.0, 8.0);
        for line in lines {
            let step = line.size().y + 2.0;
            painter.galley(at, line, TEXT);
            at.y += step;
        }
    } else {
        focus_ring(ui, &response);
    }
    response
}
