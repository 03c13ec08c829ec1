//! The hotbar: ten slots, the one in hand lit.

use egui::{Align2, Color32, FontId, Painter, Rect, Stroke, StrokeKind, pos2, vec2};

use super::{HudModel, SlotView, plate::plate};
use crate::icons;
use crate::theme::{ACCENT, ACCENT_DIM, BAD, LINE, PLATE, TEXT, WEAK, small};

/// How many slots there are room for.
const SLOTS: usize = 10;
const GAP: f32 = 4.0;
/// Largest and smallest side of a slot, in points.
const SIDE: (f32, f32) = (48.0, 4.0);
/// Height of the bar of health, in points.
const HEALTH: f32 = 10.0;
/// Height of the screen below which there is no room for it over the bar, in points.
const SCARCE: f32 = 300.0;
/// From this width on a slot has room for words beside its thing, in points.
const WIDE: f32 = 18.0;

/// Draws it at the bottom and returns what it covers, the name of the item in
/// hand above it included.
pub(super) fn show(painter: &Painter, screen: Rect, model: &HudModel) -> Rect {
    let mut bar = row(painter, screen, model);
    let above = match model.health.filter(|share| *share < 1.0) {
        // Where height is scarce it lies in the gap over the slots.
        Some(share) if screen.height() < SCARCE => {
            let gap = bar.with_max_y(bar.min.y + GAP);
            health(painter, gap.expand2(vec2(0.0, 1.0)), share);
            bar.min.y
        }
        Some(share) => {
            let over = bar.with_min_y(bar.min.y - GAP - HEALTH);
            let over = over.with_max_y(bar.min.y - GAP);
            health(painter, over, share);
            over.min.y
        }
        None => bar.min.y,
    };
    bar.min.y = above;
    let label = model
        .slots
        .get(model.selected)
        .map_or("", |slot| slot.label.as_str());
    if !label.is_empty() {
        let at = pos2(screen.center().x, bar.min.y - GAP);
        bar = bar.union(plate(
            painter,
            screen,
            at,
            Align2::CENTER_BOTTOM,
            label,
            small(),
            TEXT,
        ));
    }
    bar
}

/// Draws the slots, if the model has any, and returns what they cover: with none the line that they would stand on.
fn row(painter: &Painter, screen: Rect, model: &HudModel) -> Rect {
    let gaps = (SLOTS - 1) as f32 * GAP + 2.0 * GAP;
    let side = ((screen.width() - gaps) / SLOTS as f32)
        .clamp(SIDE.1, SIDE.0)
        .floor();
    let size = vec2(SLOTS as f32 * side + gaps, side + 2.0 * GAP);
    let bar = Rect::from_min_size(
        pos2(screen.center().x - 0.5 * size.x, screen.max.y - size.y),
        size,
    );
    if model.slots.is_empty() {
        return bar.with_min_y(bar.max.y);
    }
    painter.rect_filled(bar, 8, PLATE);
    for index in 0..SLOTS {
        let corner = bar.min + vec2(GAP + index as f32 * (side + GAP), GAP);
        let rect = Rect::from_min_size(corner, vec2(side, side));
        slot(
            painter,
            rect,
            index,
            model.slots.get(index),
            index == model.selected,
        );
    }
    bar
}

/// How much health is left.
fn health(painter: &Painter, plate: Rect, share: f32) {
    painter.rect_filled(plate, 4, PLATE);
    let rail = plate.shrink(2.0);
    let left = share.clamp(0.0, 1.0) * rail.width();
    painter.rect_filled(rail.with_max_x(rail.min.x + left), 3, BAD);
    // Where a quarter, half and three quarters are left.
    for quarter in 1..4u8 {
        let x = rail.min.x + 0.25 * f32::from(quarter) * rail.width();
        let ends = [pos2(x, rail.min.y), pos2(x, rail.max.y)];
        painter.line_segment(ends, Stroke::new(1.0, Color32::BLACK));
    }
}

/// Draws one slot: its number among the ten, what lies in it and how many; `lit` if it is in hand.
fn slot(painter: &Painter, rect: Rect, index: usize, view: Option<&SlotView>, lit: bool) {
    frame(painter, rect, lit);
    if let Some(view) = view {
        contents(painter, rect, view);
    }
    number(painter, rect, index, lit);
}

/// The ground that a thing lies on.
pub(crate) fn frame(painter: &Painter, rect: Rect, lit: bool) {
    let (fill, stroke) = if lit {
        (ACCENT_DIM, Stroke::new(2.0, ACCENT))
    } else {
        (Color32::from_black_alpha(70), Stroke::new(1.0, LINE))
    };
    painter.rect(rect, 6, fill, stroke, StrokeKind::Inside);
}

/// The key that takes a slot of the hotbar in hand.
pub(crate) fn number(painter: &Painter, rect: Rect, index: usize, lit: bool) {
    if rect.width() >= WIDE {
        let at = rect.min + vec2(4.0, 1.0);
        let colour = if lit { TEXT } else { WEAK };
        let key = (index + 1) % SLOTS;
        painter.text(
            at,
            Align2::LEFT_TOP,
            key,
            FontId::proportional(11.0),
            colour,
        );
    }
}

/// A thing, and how many of it there are.
pub(crate) fn contents(painter: &Painter, rect: Rect, view: &SlotView) {
    if let Some(item) = view.item {
        icons::paint(painter, item, rect.shrink(0.1 * rect.width()));
    }
    if let Some(count) = view.count.filter(|_| rect.width() >= WIDE) {
        let at = rect.max - vec2(4.0, 1.0);
        let font = FontId::proportional(if rect.width() < 40.0 { 11.0 } else { 13.0 });
        let words = painter.layout_no_wrap(count.to_string(), font, TEXT);
        let place = Align2::RIGHT_BOTTOM.anchor_size(at, words.size());
        // Readable over a bright thing, too.
        painter.rect_filled(
            place.expand2(vec2(2.0, 0.0)),
            3,
            Color32::from_black_alpha(140),
        );
        painter.galley(place.min, words, TEXT);
    }
}
