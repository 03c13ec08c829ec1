//! Shows damage to the player: a red edge with a mark towards its origin, and a cross where a shot struck.

use std::f32::consts::{FRAC_PI_2, PI};

use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, pos2, vec2};

use crate::theme::BAD;

/// Share of the shorter side of the screen that the red edge is wide.
const EDGE: f32 = 0.22;
/// Opacity of the edge at its strongest, 0 to 255.
const EDGE_COVER: f32 = 150.0;
/// Width of a solid edge, in points.
const SOLID_EDGE: f32 = 6.0;
/// Distance of the mark from the middle, as a share of the shorter side, and half of its arc, radians.
const MARK: (f32, f32) = (0.22, 0.32);
/// How far beyond the mark of damage that of a hidden foe begins, in points.
const HIDDEN_BEYOND: f32 = 18.0;
/// Lines of the mark's arc.
const MARK_LINES: u16 = 12;

/// Damage that the player has just taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamageModel {
    /// How fresh it is, from 1 fading to 0.
    pub strength: f32,
    /// Whether it is drawn with solid lines, for high contrast, in which nothing shines through.
    pub solid: bool,
    /// Where it came from, clockwise from straight ahead, radians; none for a fall.
    pub from_rad: Option<f32>,
}

/// Draws the red edge and the mark.
pub(super) fn show(painter: &Painter, screen: Rect, model: DamageModel) {
    let strength = model.strength.clamp(0.0, 1.0);
    if strength.is_nan() || strength <= 0.0 {
        return;
    }
    // A fade would not be seen where everything is black or white.
    let strength = if model.solid { 1.0 } else { strength };
    if model.solid {
        let line = Stroke::new(SOLID_EDGE, BAD);
        painter.rect_stroke(screen, 0, line, StrokeKind::Inside);
    } else {
        painter.add(edge(screen, strength));
    }
    if let Some(from_rad) = model.from_rad.filter(|from| from.is_finite()) {
        mark(painter, screen, from_rad, strength);
    }
}

/// A frame that is red outside and fades to nothing inwards.
fn edge(screen: Rect, strength: f32) -> Shape {
    let width = EDGE * screen.width().min(screen.height());
    let outer = Color32::from_rgba_unmultiplied(0xC8, 0x10, 0x18, (EDGE_COVER * strength) as u8);
    let inside = screen.shrink(width);
    let mut mesh = Mesh::default();
    for corner in corners(screen) {
        mesh.colored_vertex(corner, outer);
    }
    for corner in corners(inside) {
        mesh.colored_vertex(corner, Color32::TRANSPARENT);
    }
    for side in 0..4 {
        let next = (side + 1) % 4;
        mesh.add_triangle(side, next, side + 4);
        mesh.add_triangle(next, next + 4, side + 4);
    }
    Shape::mesh(mesh)
}

fn corners(rect: Rect) -> [Pos2; 4] {
    [
        rect.left_top(),
        rect.right_top(),
        rect.right_bottom(),
        rect.left_bottom(),
    ]
}

/// An arc about the crosshair on the side that the damage came from, with a tip outwards.
fn mark(painter: &Painter, screen: Rect, from_rad: f32, strength: f32) {
    let centre = screen.center();
    let radius = MARK.0 * screen.width().min(screen.height());
    let at = |bearing: f32, radius: f32| {
        let (sin, cos) = bearing.sin_cos();
        pos2(centre.x + radius * sin, centre.y - radius * cos)
    };
    let arc: Vec<Pos2> = (0..=MARK_LINES)
        .map(|line| {
            let share = f32::from(line) / f32::from(MARK_LINES) * 2.0 - 1.0;
            at(from_rad + MARK.1 * share, radius)
        })
        .collect();
    let opaque = |colour: Color32| colour.gamma_multiply(strength.clamp(0.3, 1.0));
    painter.add(Shape::line(
        arc.clone(),
        Stroke::new(7.0, opaque(Color32::BLACK)),
    ));
    painter.add(Shape::line(arc, Stroke::new(4.0, opaque(BAD))));
    let tip = vec![
        at(from_rad, radius + 14.0),
        at(from_rad - 0.12, radius + 3.0),
        at(from_rad + 0.12, radius + 3.0),
    ];
    painter.add(Shape::convex_polygon(
        tip,
        opaque(BAD),
        Stroke::new(1.5, opaque(Color32::BLACK)),
    ));
}

/// A tip on the side where somebody is who could shoot and is not to be seen; beyond the arc of what has hurt.
pub(super) fn hidden(painter: &Painter, screen: Rect, from_rad: f32) {
    if !from_rad.is_finite() {
        return;
    }
    let centre = screen.center();
    let radius = MARK.0 * screen.width().min(screen.height()) + HIDDEN_BEYOND;
    let at = |bearing: f32, radius: f32| {
        let (sin, cos) = bearing.sin_cos();
        pos2(centre.x + radius * sin, centre.y - radius * cos)
    };
    let tip = vec![
        at(from_rad, radius + 18.0),
        at(from_rad - 0.1, radius),
        at(from_rad + 0.1, radius),
    ];
    let line = Stroke::new(2.0, Color32::BLACK);
    painter.add(Shape::convex_polygon(tip, BAD, line));
}

/// Four strokes about the crosshair: a shot of the player's has struck someone.
pub(super) fn struck(painter: &Painter, centre: Pos2) {
    for (width, colour, from, to) in [
        (4.5, Color32::from_black_alpha(170), 6.0, 14.0),
        (2.2, Color32::WHITE, 7.0, 13.0),
    ] {
        for quarter in 0..4u8 {
            let (sin, cos) = (f32::from(quarter) * FRAC_PI_2 + PI / 4.0).sin_cos();
            let way = vec2(cos, sin);
            painter.line_segment(
                [centre + from * way, centre + to * way],
                Stroke::new(width, colour),
            );
        }
    }
}
