//! Words on a small dark plate: readable over snow, sky and night alike.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, vec2};

use crate::theme::PLATE;

const PADDING: egui::Vec2 = vec2(8.0, 4.0);

/// Draws `text` with its `anchor` at `at`, wrapped and moved so that it stays
/// on the `screen`; returns what it covers.
pub(super) fn plate(
    painter: &Painter,
    screen: Rect,
    at: Pos2,
    anchor: Align2,
    text: &str,
    font: FontId,
    colour: Color32,
) -> Rect {
    let wrap = (screen.width() - 2.0 * PADDING.x).clamp(1.0, 560.0);
    let galley = painter.layout(text.to_owned(), font, colour, wrap);
    let mut rect = anchor.anchor_size(at, galley.size() + 2.0 * PADDING);
    let into = |low: f32, high: f32, from: f32, to: f32| (to - high).min(0.0).max(from - low);
    rect = rect.translate(vec2(
        into(rect.min.x, rect.max.x, screen.min.x, screen.max.x),
        into(rect.min.y, rect.max.y, screen.min.y, screen.max.y),
    ));
    painter.rect_filled(rect, 6, PLATE);
    painter.galley(rect.min + PADDING, galley, colour);
    rect
}
