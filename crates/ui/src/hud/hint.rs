//! Shows a newcomer one thing to do, and how to get the next hint.

use egui::{Color32, FontId, Painter, Rect, Stroke, StrokeKind, pos2, vec2};

use crate::theme::{ACCENT, GRID, PANEL, ROUNDING, TEXT, WEAK};

/// Widest it gets, in points.
const WIDTH: f32 = 460.0;
/// Half of the height around the middle of the screen that stays free for the crosshair and what it points at.
const CROSSHAIR: f32 = 24.0;
/// Font sizes of what is told and of the rest, and the margin round both, in points: those that fit first are taken.
const SIZES: [(f32, f32, f32); 3] = [(18.0, 13.0, 12.0), (15.0, 12.0, 6.0), (12.0, 10.0, 3.0)];

/// One hint for a newcomer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HintModel {
    /// What can be done, as a sentence.
    pub text: String,
    /// How it is skipped, and how many there are.
    pub footer: String,
}

/// Draws it in the middle between `top` and the crosshair, or not at all where even the smallest does not fit.
pub(super) fn show(painter: &Painter, screen: Rect, top: f32, hint: &HintModel) {
    let lowest = painter.clip_rect().center().y - CROSSHAIR;
    for (large, small, margin) in SIZES {
        let wrap = (WIDTH.min(screen.width() - GRID) - 2.0 * margin).max(1.0);
        let layout = |text: &str, size: f32, colour: Color32| {
            painter.layout(text.to_owned(), FontId::proportional(size), colour, wrap)
        };
        let text = layout(&hint.text, large, TEXT);
        let footer = layout(&hint.footer, small, WEAK);
        let inner = vec2(
            text.size().x.max(footer.size().x),
            text.size().y + margin / 2.0 + footer.size().y,
        );
        let size = inner + vec2(2.0 * margin + GRID, 2.0 * margin);
        if top + size.y > lowest {
            continue;
        }
        let rect = Rect::from_min_size(pos2(screen.center().x - size.x / 2.0, top), size);
        let line = Stroke::new(1.0, ACCENT);
        painter.rect(rect, ROUNDING, PANEL, line, StrokeKind::Inside);
        let corner = rect.min + vec2(margin + GRID / 2.0, margin);
        let below = corner + vec2(0.0, text.size().y + margin / 2.0);
        painter.galley(corner, text, TEXT);
        painter.galley(below, footer, WEAK);
        return;
    }
}
