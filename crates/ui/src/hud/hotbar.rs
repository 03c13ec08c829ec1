//! The hotbar: ten slots drawn with vector shapes, the one in hand lit.

use egui::{
    Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, pos2, vec2,
};

use super::{HudModel, SlotIcon, SlotView, plate::plate};
use crate::theme::{ACCENT, ACCENT_DIM, LINE, PLATE, TEXT, WEAK, small};

/// How many slots there are room for.
const SLOTS: usize = 10;
const GAP: f32 = 4.0;
/// Largest and smallest side of a slot, in points.
const SIDE: (f32, f32) = (48.0, 4.0);

const WOOD: Color32 = Color32::from_rgb(0xB8, 0x84, 0x4E);
const IRON: Color32 = Color32::from_rgb(0xCB, 0xD1, 0xDA);
const DIAMOND: Color32 = Color32::from_rgb(0x63, 0xE0, 0xE6);
const GUN: Color32 = Color32::from_rgb(120, 130, 146);
const SHOT: Color32 = Color32::from_rgb(186, 120, 84);
const BRASS: Color32 = Color32::from_rgb(216, 178, 92);
const GLOW: Color32 = Color32::from_rgb(255, 214, 138);
const HANDLE: Color32 = Color32::from_rgb(0x8A, 0x5B, 0x36);

/// Draws it at the bottom and returns what it covers, the name of the item in
/// hand above it included.
pub(super) fn show(painter: &Painter, screen: Rect, model: &HudModel) -> Rect {
    let gaps = (SLOTS - 1) as f32 * GAP + 2.0 * GAP;
    let side = ((screen.width() - gaps) / SLOTS as f32)
        .clamp(SIDE.1, SIDE.0)
        .floor();
    let size = vec2(SLOTS as f32 * side + gaps, side + 2.0 * GAP);
    let mut bar = Rect::from_min_size(
        pos2(screen.center().x - 0.5 * size.x, screen.max.y - size.y),
        size,
    );
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

fn slot(painter: &Painter, rect: Rect, index: usize, view: Option<&SlotView>, selected: bool) {
    let (fill, stroke) = if selected {
        (ACCENT_DIM, Stroke::new(2.0, ACCENT))
    } else {
        (Color32::from_black_alpha(70), Stroke::new(1.0, LINE))
    };
    painter.rect(rect, 6, fill, stroke, StrokeKind::Inside);
    let icon = view.map_or(SlotIcon::Empty, |view| view.icon);
    painter.extend(picture(icon, rect.shrink(0.12 * rect.width())));
    if rect.width() < 18.0 {
        return;
    }
    let font = FontId::proportional(11.0);
    let key = (index + 1) % SLOTS;
    painter.text(
        rect.min + vec2(4.0, 1.0),
        Align2::LEFT_TOP,
        key,
        font.clone(),
        if selected { TEXT } else { WEAK },
    );
    if let Some(count) = view.and_then(|view| view.count) {
        painter.text(
            rect.max - vec2(4.0, 1.0),
            Align2::RIGHT_BOTTOM,
            count,
            font,
            TEXT,
        );
    }
}

/// What an icon looks like, filling `rect`.
pub(crate) fn picture(icon: SlotIcon, rect: Rect) -> Vec<Shape> {
    match icon {
        SlotIcon::Empty => Vec::new(),
        SlotIcon::Gun => gun(rect),
        SlotIcon::Bullet => bullet(rect),
        SlotIcon::Lamp => lamp(rect),
        SlotIcon::PickaxeWood => pickaxe(rect, WOOD),
        SlotIcon::PickaxeIron => pickaxe(rect, IRON),
        SlotIcon::PickaxeDiamond => pickaxe(rect, DIAMOND),
    }
}

/// A short gun that points to the right.
fn gun(rect: Rect) -> Vec<Shape> {
    let at = |x: f32, y: f32| rect.min + vec2(x * rect.width(), y * rect.height());
    let outline = Stroke::new(1.0, Color32::from_black_alpha(150));
    let grip = vec![
        at(0.20, 0.46),
        at(0.44, 0.46),
        at(0.36, 0.86),
        at(0.14, 0.86),
    ];
    vec![
        Shape::convex_polygon(grip, HANDLE, outline),
        Shape::rect_filled(Rect::from_min_max(at(0.14, 0.26), at(0.72, 0.50)), 3, GUN),
        Shape::rect_filled(Rect::from_min_max(at(0.72, 0.30), at(0.94, 0.42)), 1, GUN),
        Shape::rect_filled(
            Rect::from_min_max(at(0.30, 0.32), at(0.60, 0.38)),
            1,
            ACCENT,
        ),
    ]
}

/// A bullet that points up.
fn bullet(rect: Rect) -> Vec<Shape> {
    let at = |x: f32, y: f32| rect.min + vec2(x * rect.width(), y * rect.height());
    let mut tip = arc(at(0.36, 0.46), at(0.38, 0.14), at(0.50, 0.10));
    tip.extend(arc(at(0.50, 0.10), at(0.62, 0.14), at(0.64, 0.46)));
    vec![
        Shape::convex_polygon(tip, SHOT, Stroke::NONE),
        Shape::rect_filled(Rect::from_min_max(at(0.36, 0.46), at(0.64, 0.84)), 1, BRASS),
        Shape::rect_filled(Rect::from_min_max(at(0.33, 0.84), at(0.67, 0.90)), 1, BRASS),
    ]
}

/// A glowing globe on a foot.
fn lamp(rect: Rect) -> Vec<Shape> {
    let at = |x: f32, y: f32| rect.min + vec2(x * rect.width(), y * rect.height());
    let radius = 0.27 * rect.width();
    vec![
        Shape::circle_filled(at(0.5, 0.38), 1.35 * radius, GLOW.gamma_multiply(0.25)),
        Shape::circle_filled(at(0.5, 0.38), radius, GLOW),
        Shape::circle_filled(at(0.44, 0.31), 0.35 * radius, Color32::WHITE),
        Shape::rect_filled(Rect::from_min_max(at(0.38, 0.66), at(0.62, 0.76)), 1, IRON),
        Shape::rect_filled(Rect::from_min_max(at(0.28, 0.78), at(0.72, 0.90)), 2, IRON),
    ]
}

/// A pickaxe filling `rect`, its head at the top right.
fn pickaxe(rect: Rect, head: Color32) -> Vec<Shape> {
    let at = |x: f32, y: f32| rect.min + vec2(x * rect.width(), y * rect.height());
    let width = rect.width();
    let handle = [at(0.16, 0.88), at(0.70, 0.34)];
    let outline = Color32::from_black_alpha(150);
    // Both edges of the head are arcs between its two points.
    let (tip, end) = (at(0.26, 0.14), at(0.90, 0.78));
    let outer = arc(tip, at(0.96, 0.08), end);
    let inner = arc(tip, at(0.74, 0.30), end);
    let mut mesh = Mesh::default();
    for (step, (out, inn)) in outer.iter().zip(&inner).enumerate() {
        mesh.colored_vertex(*out, head);
        mesh.colored_vertex(*inn, head.gamma_multiply(0.75).to_opaque());
        if step > 0 {
            let first = 2 * step as u32 - 2;
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 3, first + 2);
        }
    }
    vec![
        Shape::line_segment(handle, Stroke::new(0.15 * width, outline)),
        Shape::line_segment(handle, Stroke::new(0.10 * width, HANDLE)),
        Shape::mesh(mesh),
        Shape::line(outer, Stroke::new(1.0, outline)),
        Shape::line(inner, Stroke::new(1.0, outline)),
    ]
}

/// A quadratic Bézier curve.
fn arc(from: Pos2, control: Pos2, to: Pos2) -> Vec<Pos2> {
    (0..=12)
        .map(|step| {
            let t = step as f32 / 12.0;
            from.lerp(control, t).lerp(control.lerp(to, t), t)
        })
        .collect()
}
