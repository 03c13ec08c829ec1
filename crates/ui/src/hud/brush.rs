//! The brush: its shape and what it builds of, the rows in which they are chosen, and what a stroke has moved.

use egui::{Align2, Color32, Painter, Pos2, Rect, Stroke, StrokeKind, Vec2, pos2, vec2};

use super::plate::plate;
use crate::theme::{ACCENT, GRID, LINE, PLATE, TEXT, small};

/// What ground looks like on so small a field that its surface has no room, sRGB: kinds of like colours have specks by
/// which they are told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tint {
    /// Its colour.
    pub ground: [u8; 3],
    /// That of the specks in it.
    pub specks: [u8; 3],
}

/// What a brush is like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BrushForm {
    /// A ball.
    #[default]
    Ball,
    /// A cube.
    Box,
    /// A cylinder.
    Cylinder,
    /// What makes ground level.
    Flatten,
    /// What makes ground smooth.
    Smooth,
}

/// The brush in hand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BrushModel {
    /// Its shape.
    pub form: BrushForm,
    /// Its shape, its radius and what it builds, in words; empty where its radius says it all.
    pub words: String,
    /// The colour of what it builds; none for what is found at each place.
    pub tint: Option<Tint>,
    /// The row in which something is being chosen.
    pub row: Option<BrushRow>,
    /// What the last stroke has moved.
    pub heaps: Vec<HeapModel>,
}

/// What can be chosen, and what is.
#[derive(Clone, Debug, PartialEq)]
pub enum BrushRow {
    /// Shapes.
    Forms(Vec<BrushForm>, usize, String),
    /// Kinds of ground by their colours; none for what is found at each place.
    Kinds(Vec<Option<Tint>>, usize, String),
}

/// Ground that was moved.
#[derive(Clone, Debug, PartialEq)]
pub struct HeapModel {
    /// How much of what.
    pub words: String,
    /// Its colour.
    pub tint: Tint,
}

/// Largest side of a field of a row, in points.
const FIELD: f32 = 26.0;
/// Between the fields.
const GAP: f32 = 3.0;

/// Where specks lie in a field, and how large they are, as shares of its side.
const SPECKS: [([f32; 2], f32); 5] = [
    ([0.24, 0.28], 0.11),
    ([0.68, 0.2], 0.08),
    ([0.5, 0.52], 0.1),
    ([0.2, 0.76], 0.07),
    ([0.76, 0.76], 0.12),
];

fn colour([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// Fills a square field with ground.
fn fill(painter: &Painter, field: Rect, rounding: u8, tint: Tint) {
    painter.rect_filled(field, rounding, colour(tint.ground));
    for ([x, y], radius) in SPECKS {
        let at = field.min + vec2(x, y) * field.width();
        painter.circle_filled(at, radius * field.width(), colour(tint.specks));
    }
}

/// Draws the row over the hotbar, which covers `bar`; returns what both cover.
pub(super) fn row(painter: &Painter, screen: Rect, bar: Rect, model: &BrushModel) -> Rect {
    let Some(row) = &model.row else { return bar };
    let (count, chosen, name) = match row {
        BrushRow::Forms(forms, chosen, name) => (forms.len(), *chosen, name),
        BrushRow::Kinds(kinds, chosen, name) => (kinds.len(), *chosen, name),
    };
    let side = (screen.width() / count.max(1) as f32 - GAP).clamp(4.0, FIELD);
    let size = vec2(count as f32 * (side + GAP) + GAP, side + 2.0 * GAP);
    let middle = pos2(screen.center().x, bar.min.y - GRID - 0.5 * size.y);
    let whole = Rect::from_center_size(middle, size);
    painter.rect_filled(whole, 6, PLATE);
    for n in 0..count {
        let corner = whole.min + vec2(GAP + n as f32 * (side + GAP), GAP);
        let field = Rect::from_min_size(corner, Vec2::splat(side));
        match row {
            BrushRow::Forms(forms, ..) => form(painter, field.center(), 0.4 * side, forms[n], None),
            BrushRow::Kinds(kinds, ..) => swatch(painter, field, kinds[n]),
        }
        let frame = if n == chosen {
            Stroke::new(2.0, ACCENT)
        } else {
            Stroke::new(1.0, LINE)
        };
        painter.rect_stroke(field, 4, frame, StrokeKind::Outside);
    }
    let at = pos2(middle.x, whole.min.y - GAP);
    let words = plate(
        painter,
        screen,
        at,
        Align2::CENTER_BOTTOM,
        name,
        small(),
        TEXT,
    );
    bar.union(whole).union(words)
}

/// A colour of ground; what is found at each place is crossed out.
fn swatch(painter: &Painter, field: Rect, tint: Option<Tint>) {
    if let Some(tint) = tint {
        fill(painter, field, 4, tint);
    } else {
        let stroke = Stroke::new(1.5, TEXT);
        painter.line_segment([field.left_bottom(), field.right_top()], stroke);
    }
}

/// What a brush is like as seen from the side, `half` its half width.
pub(super) fn form(
    painter: &Painter,
    centre: Pos2,
    half: f32,
    form: BrushForm,
    tint: Option<Tint>,
) {
    let fill = tint.map_or(Color32::from_white_alpha(30), |tint| colour(tint.ground));
    let stroke = Stroke::new(2.0, ACCENT);
    let square = Rect::from_center_size(centre, Vec2::splat(1.8 * half));
    match form {
        BrushForm::Ball => {
            painter.circle(centre, half, fill, stroke);
        }
        BrushForm::Box => {
            painter.rect(square, 0, fill, stroke, StrokeKind::Middle);
        }
        BrushForm::Cylinder => {
            let upright = Rect::from_center_size(centre, vec2(1.3 * half, 1.8 * half));
            painter.rect(upright, 5, fill, stroke, StrokeKind::Middle);
        }
        BrushForm::Flatten => {
            let level = [square.left_center(), square.right_center()];
            painter.rect_filled(square.with_min_y(centre.y), 0, fill);
            painter.line_segment(level, stroke);
        }
        BrushForm::Smooth => {
            let wave = (0..=16).map(|n| {
                let share = n as f32 / 16.0;
                let rise = 0.4 * half * (share * std::f32::consts::TAU).sin();
                pos2(square.min.x + share * square.width(), centre.y - rise)
            });
            painter.add(egui::Shape::line(wave.collect(), stroke));
        }
    }
}

/// A colour of ground about a place, beside words on it.
pub(crate) fn dot(painter: &Painter, centre: Pos2, tint: Tint) {
    let rect = Rect::from_center_size(centre, Vec2::splat(10.0));
    let line = Stroke::new(1.0, LINE);
    fill(painter, rect, 3, tint);
    painter.rect_stroke(rect, 3, line, StrokeKind::Outside);
}

/// What the last stroke has moved, beside the crosshair.
pub(super) fn heaps(painter: &Painter, screen: Rect, centre: Pos2, model: &BrushModel) {
    let mut at = centre + vec2(22.0, 16.0);
    for heap in &model.heaps {
        let words = plate(
            painter,
            screen,
            at + vec2(14.0, 0.0),
            Align2::LEFT_TOP,
            &heap.words,
            small(),
            TEXT,
        );
        dot(painter, pos2(at.x + 4.0, words.center().y), heap.tint);
        at.y = words.max.y + 2.0;
    }
}
