//! The small instruments beside the hotbar: curvature, hemisphere, brush.

use std::f32::consts::TAU;

use antipode_language::{Texts, Value};
use egui::{Align2, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};

use super::{BrushModel, CurvatureView, DialKind, HudModel, brush, plate::plate};
use crate::theme::{ACCENT, GRID, LINE, PLATE, TEXT, small};

/// Side of an instrument without its caption, in points.
const SIDE: f32 = 56.0;
/// Speed at the end of a car's dial, km/h.
const MOST_KM_H: f64 = 120.0;
/// Width an instrument needs beside the hotbar, its caption included.
const WIDTH: f32 = 136.0;

/// Draws those the model asks for at the left and right of `screen`; they end at `bottom`. Returns what those at the
/// right cover.
pub(super) fn show(
    painter: &Painter,
    screen: Rect,
    bottom: f32,
    texts: &Texts,
    model: &HudModel,
) -> Rect {
    // They give way to the rest on screens too small for everything.
    if bottom - 2.0 * SIDE < screen.min.y {
        return Rect::NOTHING;
    }
    let mut covered = Rect::NOTHING;
    let mut right = pos2(screen.max.x, bottom);
    if let Some(curvature) = model.curvature {
        let dial = |centre| curvature_dial(painter, centre, texts, curvature);
        let words = dial_caption(texts, curvature);
        covered = instrument(painter, screen, right, Align2::RIGHT_BOTTOM, &words, dial);
        right.y = covered.min.y - GRID;
    }
    if let Some(hemisphere) = model.hemisphere {
        let ball = |centre| hemisphere_ball(painter, centre, hemisphere);
        let words = texts.say_with("display-hemisphere", &[("letter", hemisphere.into())]);
        let drawn = instrument(painter, screen, right, Align2::RIGHT_BOTTOM, &words, ball);
        covered = covered.union(drawn);
    }
    let left = pos2(screen.min.x, bottom);
    if let Some(speed_km_h) = model.speed_km_h {
        let shown = speed_km_h.abs().round();
        let words = texts.say_with("display-speed", &[("speed", Value::decimals(shown, 0))]);
        let dial = |centre| speed_dial(painter, centre, speed_km_h);
        instrument(painter, screen, left, Align2::LEFT_BOTTOM, &words, dial);
    } else if let Some(radius_m) = model.brush_radius_m {
        let ring = |centre| brush_ring(painter, centre, radius_m, &model.brush);
        let words = if model.brush.words.is_empty() {
            texts.say_with("display-brush", &[("radius", Value::decimals(radius_m, 1))])
        } else {
            model.brush.words.clone()
        };
        instrument(painter, screen, left, Align2::LEFT_BOTTOM, &words, ring);
    }
    covered
}

/// Where the lowest instruments end: beside the hotbar where there is room, else above it.
pub(super) fn bottom(screen: Rect, bar: Rect) -> f32 {
    if screen.max.x - bar.max.x >= WIDTH {
        screen.max.y
    } else {
        bar.min.y - GRID
    }
}

/// A caption at the corner and the instrument over it; returns what they cover.
fn instrument(
    painter: &Painter,
    screen: Rect,
    corner: Pos2,
    anchor: Align2,
    words: &str,
    draw: impl FnOnce(Pos2),
) -> Rect {
    let caption = plate(painter, screen, corner, anchor, words, small(), TEXT);
    let centre = pos2(caption.center().x, caption.min.y - 4.0 - 0.5 * SIDE);
    painter.circle_filled(centre, 0.5 * SIDE, PLATE);
    draw(centre);
    caption.union(Rect::from_center_size(centre, Vec2::splat(SIDE)))
}

/// What the dial turns, and in a bent world which way space curves.
fn dial_caption(texts: &Texts, view: CurvatureView) -> String {
    texts.say(match view.kind {
        DialKind::Raised => "dial-raised",
        DialKind::Horizon => "dial-horizon",
        DialKind::Bend if tenths(view) > 0.0 => "dial-bend-hyperbolic",
        DialKind::Bend if tenths(view) < 0.0 => "dial-bend-spherical",
        DialKind::Bend => "dial-bend-flat",
    })
}

/// The value as it is read: with its sign where both signs mean something.
fn value_text(texts: &Texts, view: CurvatureView) -> String {
    let text = texts.number(view.value, 1);
    match view.kind {
        DialKind::Bend if tenths(view) > 0.0 => format!("+{text}"),
        _ => text,
    }
}

/// The value in steps of what is shown of it.
fn tenths(view: CurvatureView) -> f64 {
    (view.value * 10.0).round_ties_even()
}

/// How fast a car goes, forwards or backwards.
fn speed_dial(painter: &Painter, centre: Pos2, speed_km_h: f64) {
    let part = (speed_km_h.abs() / MOST_KM_H).clamp(0.0, 1.0) as f32;
    let part = if part.is_finite() { part } else { 0.0 };
    let needle = arc_dial(painter, centre, [0.0, part]);
    painter.line_segment([centre, needle], Stroke::new(2.0, TEXT));
    painter.circle_filled(centre, 3.0, TEXT);
}

/// An arc of three quarters of a turn from bottom left to bottom right, lit between two parts of it; returns where the
/// second is.
fn arc_dial(painter: &Painter, centre: Pos2, [zero, part]: [f32; 2]) -> Pos2 {
    let radius = 0.5 * SIDE - 6.0;
    let direction = |part: f32| {
        let angle = TAU * (0.375 + 0.75 * part);
        vec2(angle.cos(), angle.sin())
    };
    let arc = |from: f32, to: f32| -> Vec<Pos2> {
        let share = |step: i32| from + (to - from) * step as f32 / 24.0;
        let at = |step: i32| centre + radius * direction(share(step));
        (0..=24).map(at).collect()
    };
    painter.add(Shape::line(arc(0.0, 1.0), Stroke::new(4.0, LINE)));
    painter.add(Shape::line(arc(zero, part), Stroke::new(4.0, ACCENT)));
    let needle = centre + radius * direction(part);
    painter.circle_filled(needle, 4.0, TEXT);
    needle
}

/// Lit from zero to the value.
fn curvature_dial(painter: &Painter, centre: Pos2, texts: &Texts, view: CurvatureView) {
    let part = dial_part(view);
    let zero = dial_part(CurvatureView { value: 0.0, ..view });
    arc_dial(painter, centre, [zero, part]);
    painter.text(
        centre,
        Align2::CENTER_CENTER,
        value_text(texts, view),
        FontId::monospace(13.0),
        TEXT,
    );
}

/// Where the needle stands, 0 to 1, whatever the numbers.
fn dial_part(view: CurvatureView) -> f32 {
    let part = (view.value - view.min) / (view.max - view.min);
    if part.is_finite() {
        part.clamp(0.0, 1.0) as f32
    } else {
        0.0
    }
}

/// The world as a ball, the half with the player lit: A above, B below.
fn hemisphere_ball(painter: &Painter, centre: Pos2, hemisphere: char) {
    let radius = 0.5 * SIDE - 8.0;
    let start = if hemisphere == 'B' { 0.0 } else { 0.5 };
    let half = (0..=24)
        .map(|step| {
            let angle = TAU * (start + 0.5 * step as f32 / 24.0);
            centre + radius * vec2(angle.cos(), angle.sin())
        })
        .collect();
    painter.add(Shape::convex_polygon(half, ACCENT, Stroke::NONE));
    painter.circle_stroke(centre, radius, Stroke::new(1.5, TEXT));
    let equator = (0..=24).map(|step| {
        let angle = TAU * 0.5 * step as f32 / 24.0;
        centre + radius * vec2(angle.cos(), 0.3 * angle.sin())
    });
    painter.add(Shape::line(equator.collect(), Stroke::new(1.5, TEXT)));
}

/// The brush's form, which grows with it, 1 to 10 m, in the colour of what it builds.
fn brush_ring(painter: &Painter, centre: Pos2, radius_m: f64, brush: &BrushModel) {
    let widest = 0.5 * SIDE - 6.0;
    let part = if radius_m.is_finite() {
        (radius_m / 10.0).clamp(0.1, 1.0) as f32
    } else {
        0.1
    };
    brush::form(painter, centre, part * widest, brush.form, brush.tint);
    painter.circle_filled(centre, 1.5, TEXT);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_needle_stays_on_the_dial() {
        let part = |value, min, max| {
            dial_part(CurvatureView {
                kind: DialKind::Raised,
                value,
                min,
                max,
            })
        };
        assert_eq!(part(15.0, 10.0, 20.0), 0.5);
        assert_eq!(part(-3.0, 10.0, 20.0), 0.0);
        assert_eq!(part(99.0, 10.0, 20.0), 1.0);
        assert_eq!(part(1.0, 1.0, 1.0), 0.0);
        assert_eq!(part(f64::NAN, 0.0, 1.0), 0.0);
    }

    #[test]
    fn a_bend_says_its_sign_and_which_way_space_curves() {
        let texts = Texts::default();
        let bend = |value| CurvatureView {
            kind: DialKind::Bend,
            value,
            min: -20.0,
            max: 20.0,
        };
        for (value, text, way) in [
            (3.0, "+3.0", "hyperbolic"),
            (-12.25, "-12.2", "spherical"),
            (0.04, "0.0", "flat"),
            (-0.04, "0.0", "flat"),
            (f64::NAN, "NaN", "flat"),
        ] {
            assert_eq!(value_text(&texts, bend(value)), text);
            assert!(dial_caption(&texts, bend(value)).ends_with(way), "{value}");
        }
    }
}
