//! Describes the stack in the slot under the pointer: its name, its count, and what it does.

use antipode_language::Texts;
use egui::{FontId, Painter, Rect, pos2, vec2};

use super::item_name;
use crate::hud::SlotView;
use crate::theme::{GRID, PANEL, ROUNDING, TEXT, WEAK, small};

/// Widest it gets, in points.
const WIDTH: f32 = 280.0;

/// Paints it above or below the slot at `at`, within the screen.
pub(super) fn show(painter: &Painter, screen: Rect, at: Rect, texts: &Texts, view: &SlotView) {
    let Some(item) = view.item else {
        return;
    };
    let wrap = (WIDTH.min(screen.width()) - 4.0 * GRID).max(1.0);
    let name = painter.layout(
        item_name(texts, view),
        FontId::proportional(16.0),
        TEXT,
        wrap,
    );
    let about = painter.layout(
        texts.say(&format!("item-{}-about", item.id())),
        small(),
        WEAK,
        wrap,
    );
    let inner = vec2(
        name.size().x.max(about.size().x),
        name.size().y + 4.0 + about.size().y,
    );
    let size = inner + vec2(2.0 * GRID, 1.5 * GRID);
    let above = at.min.y - GRID - size.y;
    let top = if above >= screen.min.y {
        above
    } else {
        at.max.y + GRID
    };
    let most = (screen.max - size - vec2(GRID, 0.0)).max(screen.min);
    let left = (at.center().x - 0.5 * size.x).clamp(screen.min.x, most.x);
    let corner = pos2(left, top.clamp(screen.min.y, most.y));
    // Nothing shines through it: it lies on other slots.
    painter.rect_filled(
        Rect::from_min_size(corner, size),
        ROUNDING,
        PANEL.to_opaque(),
    );
    let text = corner + vec2(GRID, 0.75 * GRID);
    let below = text + vec2(0.0, name.size().y + 4.0);
    painter.galley(text, name, TEXT);
    painter.galley(below, about, WEAK);
}
