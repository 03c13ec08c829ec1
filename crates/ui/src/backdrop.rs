//! What stands behind the menus when no world does: dusk over one land, with
//! another hanging overhead, as in a small closed world.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, pos2, vec2};

use crate::model::Backdrop;

/// Height (0 top, 1 bottom) and colour of the sky's bands.
const SKY: [(f32, Color32); 5] = [
    (0.0, Color32::from_rgb(0x0B, 0x0E, 0x20)),
    (0.35, Color32::from_rgb(0x1B, 0x1D, 0x3E)),
    (0.60, Color32::from_rgb(0x45, 0x2E, 0x4E)),
    (0.78, Color32::from_rgb(0x9A, 0x53, 0x45)),
    (1.0, Color32::from_rgb(0xD9, 0x86, 0x4A)),
];
const GLOW: Color32 = Color32::from_rgba_unmultiplied_const(0xFF, 0xC4, 0x80, 120);
const LAND_FAR: Color32 = Color32::from_rgb(0x35, 0x24, 0x3C);
const LAND_NEAR: Color32 = Color32::from_rgb(0x14, 0x12, 0x20);
const LAND_ABOVE: Color32 = Color32::from_rgb(0x12, 0x15, 0x2C);
/// Between two worlds.
const DARK: Color32 = Color32::from_rgb(0x0B, 0x0E, 0x20);
const STARS: u32 = 90;

/// Darkens a live world as the backdrop says, or paints our own picture over `rect`, darkened alike.
pub(crate) fn show(painter: &Painter, rect: Rect, backdrop: Backdrop) {
    if !backdrop.live {
        paint(painter, rect);
    }
    let shade = (backdrop.shade.clamp(0.0, 1.0) * 255.0).round() as u8;
    if shade > 0 {
        let colour = Color32::from_rgba_unmultiplied(DARK.r(), DARK.g(), DARK.b(), shade);
        painter.rect_filled(rect, 0, colour);
    }
}

/// Paints it over `rect`.
fn paint(painter: &Painter, rect: Rect) {
    let painter = painter.with_clip_rect(rect);
    sky(&painter, rect);
    stars(&painter, rect);
    let (width, height) = (rect.width(), rect.height());
    let at = |x: f32, y: f32| pos2(rect.min.x + x * width, rect.min.y + y * height);
    glow(&painter, at(0.72, 0.80), 0.34 * width.max(height));
    // Circles far larger than the screen: only their limbs show, as curved horizons.
    let span = width.max(height);
    painter.circle_filled(
        at(0.30, 0.0) - vec2(0.0, 1.42 * span),
        1.55 * span,
        LAND_ABOVE,
    );
    painter.circle_filled(
        at(0.80, 0.80) + vec2(0.0, 1.60 * span),
        1.60 * span,
        LAND_FAR,
    );
    painter.circle_filled(
        at(0.25, 0.88) + vec2(0.0, 1.30 * span),
        1.30 * span,
        LAND_NEAR,
    );
}

fn sky(painter: &Painter, rect: Rect) {
    let mut mesh = Mesh::default();
    for (row, (height, colour)) in SKY.into_iter().enumerate() {
        let y = rect.min.y + height * rect.height();
        mesh.colored_vertex(pos2(rect.min.x, y), colour);
        mesh.colored_vertex(pos2(rect.max.x, y), colour);
        if row > 0 {
            let first = 2 * row as u32 - 2;
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 3, first + 2);
        }
    }
    painter.add(Shape::mesh(mesh));
}

/// A soft disc: bright in the middle, nothing at its rim.
fn glow(painter: &Painter, centre: Pos2, radius: f32) {
    let mut mesh = Mesh::default();
    mesh.colored_vertex(centre, GLOW);
    let sides = 48;
    for side in 0..=sides {
        let angle = side as f32 / sides as f32 * std::f32::consts::TAU;
        mesh.colored_vertex(
            centre + radius * vec2(angle.cos(), angle.sin()),
            Color32::TRANSPARENT,
        );
        if side > 0 {
            mesh.add_triangle(0, side, side + 1);
        }
    }
    painter.add(Shape::mesh(mesh));
}

fn stars(painter: &Painter, rect: Rect) {
    for star in 0..STARS {
        let (x, y) = (scatter(star * 3), scatter(star * 3 + 1));
        let light = scatter(star * 3 + 2);
        let at = rect.min + vec2(x * rect.width(), y * y * 0.6 * rect.height());
        let alpha = ((1.0 - y) * (60.0 + 160.0 * light)) as u8;
        let colour = Color32::from_rgba_unmultiplied(0xFF, 0xF2, 0xE0, alpha);
        painter.circle_filled(at, 0.6 + 0.8 * light, colour);
    }
}

/// The same well-spread number in 0..1 for the same index: the sky must not
/// twinkle from frame to frame. (The finaliser of MurmurHash3.)
fn scatter(index: u32) -> f32 {
    let mut bits = index.wrapping_add(1).wrapping_mul(0x9E37_79B9);
    bits = (bits ^ (bits >> 16)).wrapping_mul(0x85EB_CA6B);
    bits = (bits ^ (bits >> 13)).wrapping_mul(0xC2B2_AE35);
    (bits ^ (bits >> 16)) as f32 / u32::MAX as f32
}
