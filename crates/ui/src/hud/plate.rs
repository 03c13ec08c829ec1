//! Words on a small dark plate: readable over snow, sky and night alike.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2, vec2};

use crate::theme::PLATE;

const PADDING: Vec2 = vec2(8.0, 4.0);

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
    let galley = painter.layout(text.to_owned(), font, colour, wrap_width(screen));
    let rect = background(painter, screen, at, anchor, galley.size());
    painter.galley(rect.min + PADDING, galley, colour);
    rect
}

/// How high the plate of a text is on a screen, in points.
pub(super) fn height_of(painter: &Painter, screen: Rect, text: &str, font: FontId) -> f32 {
    let galley = painter.layout(text.to_owned(), font, PLATE, wrap_width(screen));
    galley.size().y + 2.0 * PADDING.y
}

/// Lines of a name and what there is to say of it, laid out; the latter begin one below another, whatever the
/// script. A line without a name takes the whole width.
pub(super) struct Lines {
    rows: Vec<Row>,
    size: Vec2,
    colour: Color32,
}

struct Row {
    /// Where it begins below the first.
    y: f32,
    name: Arc<Galley>,
    /// Where its text begins beside the name.
    x: f32,
    text: Arc<Galley>,
}

impl Lines {
    /// Lays them out so that they fit on the `screen`.
    pub(super) fn new(
        painter: &Painter,
        screen: Rect,
        lines: &[(String, String)],
        font: &FontId,
        colour: Color32,
    ) -> Self {
        let layout = |text: &str, wrap: f32| {
            painter.layout(text.to_owned(), font.clone(), colour, wrap.max(1.0))
        };
        let wrap = wrap_width(screen);
        let names: Vec<_> = lines.iter().map(|(name, _)| layout(name, wrap)).collect();
        let widths = names.iter().map(|galley| galley.size().x);
        let indent = widths.fold(0.0, f32::max) + font.size;
        let mut size = Vec2::ZERO;
        let mut rows = Vec::with_capacity(lines.len());
        for ((words, text), name) in lines.iter().zip(names) {
            let x = if words.is_empty() { 0.0 } else { indent };
            let text = layout(text, wrap - x);
            let y = size.y;
            size.x = size.x.max(x + text.size().x);
            size.y += name.size().y.max(text.size().y);
            rows.push(Row { y, name, x, text });
        }
        Self { rows, size, colour }
    }

    /// The width of the plate that they take.
    pub(super) fn width(&self) -> f32 {
        self.size.x + 2.0 * PADDING.x
    }

    /// Draws them with their `anchor` at `at`, moved so that they stay on the `screen`; returns what they cover.
    pub(super) fn paint(self, painter: &Painter, screen: Rect, at: Pos2, anchor: Align2) -> Rect {
        let rect = background(painter, screen, at, anchor, self.size);
        let corner = rect.min + PADDING;
        for Row { y, name, x, text } in self.rows {
            if !name.is_empty() {
                painter.galley(corner + vec2(0.0, y), name, self.colour);
            }
            painter.galley(corner + vec2(x, y), text, self.colour);
        }
        rect
    }
}

fn wrap_width(screen: Rect) -> f32 {
    (screen.width() - 2.0 * PADDING.x).clamp(1.0, 560.0)
}

/// Paints the plate for contents of that `size`, and returns what it covers.
fn background(painter: &Painter, screen: Rect, at: Pos2, anchor: Align2, size: Vec2) -> Rect {
    let rect = anchor.anchor_size(at, size + 2.0 * PADDING);
    let into = |low: f32, high: f32, from: f32, to: f32| (to - high).min(0.0).max(from - low);
    let rect = rect.translate(vec2(
        into(rect.min.x, rect.max.x, screen.min.x, screen.max.x),
        into(rect.min.y, rect.max.y, screen.min.y, screen.max.y),
    ));
    painter.rect_filled(rect, 6, PLATE);
    rect
}
