//! Cards side by side, or one over another where they would be narrow, of which one is chosen.

use std::sync::Arc;

use egui::{
    FontId, Galley, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2,
    vec2,
};

use crate::layout::Stops;
use crate::model::GeometryChoice;
use crate::theme::{ACCENT, GRID, TEXT, WEAK, small};
use crate::widgets::paint_card;

/// Side of a card's picture, in points.
const ICON: f32 = 40.0;
/// Least width of a card that has others beside it, in points.
const LEAST: f32 = 160.0;

/// Between its label and the sentence below, in points.
const BELOW_LABEL: f32 = 3.0;

/// What one says.
pub(super) struct Card {
    pub label: String,
    /// One sentence below the label.
    pub about: String,
    /// The space that it has a picture of.
    pub space: Option<GeometryChoice>,
    pub chosen: bool,
}

/// How all cards of a row stand.
#[derive(Clone, Copy)]
struct Place {
    size: Vec2,
    across: bool,
}

/// Draws them under a heading; returns the index of the one that was chosen now.
pub(super) fn choose(
    ui: &mut Ui,
    heading: &str,
    cards: &[Card],
    stops: &mut Stops,
) -> Option<usize> {
    ui.label(heading);
    let count = cards.len() as f32;
    let room = ui.available_width();
    let across = room >= count * LEAST;
    let width = if across {
        (room - (count - 1.0) * GRID) / count
    } else {
        room
    };
    let heights = cards.iter().map(|card| card.height(ui, width, across));
    let place = Place {
        size: vec2(width, heights.fold(0.0, f32::max)),
        across,
    };
    let mut clicked = None;
    let mut draw = |ui: &mut Ui| {
        for (index, card) in cards.iter().enumerate() {
            let response = card.show(ui, place);
            stops.add(&response);
            if response.clicked() {
                clicked = Some(index);
            }
        }
    };
    if across {
        ui.horizontal(draw);
    } else {
        draw(ui);
    }
    clicked
}

impl Card {
    /// How far the words lie from the corner of what is inside.
    fn words_at(&self, across: bool) -> Vec2 {
        match self.space {
            None => Vec2::ZERO,
            Some(_) if across => vec2(0.0, ICON + GRID),
            Some(_) => vec2(ICON + 12.0, 0.0),
        }
    }

    /// The label, and the sentence below it.
    fn words(&self, ui: &Ui, width: f32, across: bool) -> [Arc<Galley>; 2] {
        let wrap = (width - 24.0 - self.words_at(across).x).max(1.0);
        let label = FontId::proportional(16.0);
        [(&self.label, label, TEXT), (&self.about, small(), WEAK)]
            .map(|(words, font, colour)| ui.painter().layout(words.clone(), font, colour, wrap))
    }

    fn height(&self, ui: &Ui, width: f32, across: bool) -> f32 {
        let [label, about] = self.words(ui, width, across);
        let words = label.size().y + BELOW_LABEL + about.size().y + 24.0 + self.words_at(across).y;
        let least = self.space.map_or(0.0, |_| ICON + 20.0);
        words.max(least)
    }

    fn show(&self, ui: &mut Ui, place: Place) -> Response {
        let (rect, response) = ui.allocate_exact_size(place.size, Sense::click());
        response.widget_info(|| {
            WidgetInfo::selected(Role::RadioButton, true, self.chosen, &self.label)
        });
        paint_card(ui, &response, self.chosen);
        let painter = ui.painter().with_clip_rect(ui.clip_rect().intersect(rect));
        let corner = rect.min + vec2(12.0, 10.0);
        if let Some(space) = self.space {
            let icon = Rect::from_min_size(corner, vec2(ICON, ICON));
            let colour = if self.chosen { ACCENT } else { TEXT };
            ui.painter()
                .extend(icon_shapes(space, icon, Stroke::new(1.5, colour)));
        }
        let words = corner + self.words_at(place.across);
        let [label, about] = self.words(ui, place.size.x, place.across);
        let below = words + vec2(0.0, label.size().y + BELOW_LABEL);
        painter.galley(words, label, TEXT);
        painter.galley(below, about, WEAK);
        response
    }
}

/// Five squares about a corner in lines.
fn about_a_corner(rect: Rect, stroke: Stroke) -> Vec<Shape> {
    let at = |tenths: i32, far: f32| -> Pos2 {
        let (sine, cosine) = (tenths as f32 * 0.2 * std::f32::consts::PI).sin_cos();
        rect.center() + vec2(sine, -cosine) * (far * 0.5 * rect.width())
    };
    let sides = (0..5).flat_map(|n| {
        let (side, corner, next) = (at(2 * n, 0.72), at(2 * n + 1, 1.0), at(2 * n + 2, 0.72));
        [[rect.center(), side], [side, corner], [corner, next]]
    });
    sides
        .map(|ends| Shape::line_segment(ends, stroke))
        .collect()
}

/// A patch of each space in lines: geodesics that part, stay apart, or meet.
fn icon_shapes(choice: GeometryChoice, rect: Rect, stroke: Stroke) -> Vec<Shape> {
    let bend = match choice {
        GeometryChoice::HyperbolicWorld => return about_a_corner(rect, stroke),
        GeometryChoice::Hyperbolic => -0.45,
        GeometryChoice::Euclidean => 0.0,
        GeometryChoice::Spherical => 1.0,
    };
    let at = |x: f32, y: f32| -> Pos2 {
        pos2(
            rect.center().x + 0.5 * x * rect.width(),
            rect.center().y + 0.5 * y * rect.height(),
        )
    };
    // A line at offset d runs at d * width(t): narrow ends where geodesics meet.
    let width = |t: f32| {
        if bend > 0.0 {
            (1.0 - t * t).max(0.0).sqrt()
        } else {
            0.62 - bend * (t * t - 0.4)
        }
    };
    let mut shapes = Vec::new();
    for d in [-1.0, -0.5, 0.0, 0.5, 1.0_f32] {
        let steps = (-8..=8).map(|step| step as f32 / 8.0);
        shapes.push(Shape::line(
            steps.clone().map(|t| at(d * width(t), t)).collect(),
            stroke,
        ));
        if bend <= 0.0 {
            shapes.push(Shape::line(
                steps.map(|t| at(t, d * width(t))).collect(),
                stroke,
            ));
        } else if d.abs() < 1.0 {
            let half = (1.0 - d * d).sqrt();
            shapes.push(Shape::line(
                steps.map(|t| at(t * half, d)).collect(),
                stroke,
            ));
        }
    }
    shapes
}
