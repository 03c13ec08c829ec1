//! The picture of a world or room, or a drawn place where it has none: land at dusk, or a passage that narrows.

use egui::{Color32, CornerRadius, Painter, Pos2, Rect, Shape, Vec2, pos2, vec2};

use super::Kind;
use crate::model::WorldRow;
use crate::theme::{LINE, ROUNDING};

/// Width over height of the pictures.
pub(crate) const ASPECT: f32 = 16.0 / 9.0;

const SKY: Color32 = Color32::from_rgb(0x45, 0x2E, 0x4E);
const SUN: Color32 = Color32::from_rgb(0xD9, 0x86, 0x4A);
const FAR: Color32 = Color32::from_rgb(0x35, 0x24, 0x3C);
const NEAR: Color32 = Color32::from_rgb(0x14, 0x12, 0x20);

/// The size of a picture of that height.
pub(crate) fn size(height: f32) -> Vec2 {
    vec2(height * ASPECT, height)
}

/// Paints the picture of a world or room over `rect`.
pub(crate) fn paint(painter: &Painter, rect: Rect, kind: Kind, row: &WorldRow) {
    if let Some(picture) = &row.picture {
        let whole = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
        let shape = egui::epaint::RectShape::filled(rect, ROUNDING / 2, Color32::WHITE)
            .with_texture(*picture, whole);
        painter.add(shape);
    } else {
        let inside = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
        match kind {
            Kind::World => placeholder(&inside, rect, &row.slug),
            Kind::Room | Kind::Own => passage(&inside, rect, &row.slug),
        }
    }
    let corners = CornerRadius::same(ROUNDING / 2);
    painter.rect_stroke(
        rect,
        corners,
        egui::Stroke::new(1.0, LINE),
        egui::StrokeKind::Inside,
    );
}

/// Two ranges of hills before a low sun; where they stand goes by the directory's name, so
/// that two worlds without a picture can be told apart.
fn placeholder(painter: &Painter, rect: Rect, slug: &str) {
    painter.rect_filled(rect, ROUNDING / 2, SKY);
    let shift = slug.bytes().fold(7_u32, |sum, byte| {
        sum.wrapping_mul(31).wrapping_add(u32::from(byte))
    });
    let phase = |n: u32| (shift.rotate_left(11 * n) % 628) as f32 / 100.0;
    let at = |x: f32, y: f32| rect.min + vec2(x * rect.width(), y * rect.height());
    painter.circle_filled(at(0.2 + phase(3) * 0.1, 0.58), 0.16 * rect.height(), SUN);
    hills(painter, &at, 0.62, 0.10, phase(0), FAR);
    hills(painter, &at, 0.80, 0.08, phase(1), NEAR);
}

/// Doorways in one another, ever smaller; how fast they shrink and where they lead goes by the folder's name.
fn passage(painter: &Painter, rect: Rect, slug: &str) {
    painter.rect_filled(rect, ROUNDING / 2, NEAR);
    let shift = slug.bytes().fold(7_u32, |sum, byte| {
        sum.wrapping_mul(31).wrapping_add(u32::from(byte))
    });
    let part = |n: u32| (shift.rotate_left(11 * n) % 101) as f32 / 100.0;
    let shrinks = 0.62 + 0.16 * part(0);
    let end = rect.min
        + vec2(
            (0.35 + 0.3 * part(1)) * rect.width(),
            (0.4 + 0.2 * part(2)) * rect.height(),
        );
    let mut size = 1.0;
    for door in 0..7 {
        let corner = |at: Pos2| end + size * (at - end);
        let frame = Rect::from_min_max(corner(rect.min), corner(rect.max));
        let colour = FAR.lerp_to_gamma(SUN, door as f32 / 6.0);
        painter.rect_filled(frame, 0, colour);
        painter.rect_filled(frame.shrink(0.05 * frame.height()), 0, NEAR);
        size *= shrinks;
    }
    painter.rect_filled(Rect::from_center_size(end, size * rect.size()), 0, SUN);
}

/// Ground up to a wavy line about `level` down from the top, all in parts of the picture.
fn hills(
    painter: &Painter,
    at: &impl Fn(f32, f32) -> Pos2,
    level: f32,
    height: f32,
    phase: f32,
    colour: Color32,
) {
    const STEPS: u32 = 16;
    let ridge = |x: f32| {
        level - height * (0.6 * (6.0 * x + phase).sin() + 0.4 * (11.0 * x + 2.0 * phase).sin())
    };
    for step in 0..STEPS {
        let (from, to) = (step as f32 / STEPS as f32, (step + 1) as f32 / STEPS as f32);
        let strip = vec![
            at(from, ridge(from)),
            at(to, ridge(to)),
            at(to, 1.0),
            at(from, 1.0),
        ];
        painter.add(Shape::convex_polygon(strip, colour, egui::Stroke::NONE));
    }
}
