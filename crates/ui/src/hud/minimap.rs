//! The round map of the land around the player. The direction that the player faces is up. It stands at the left, in
//! the lower half of the screen, where nothing else stands; the large one stands over the middle of the picture.

use std::f32::consts::TAU;
use std::sync::Arc;

use antipode_language::Texts;
use egui::{Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use super::compass::{QUARTERS, arrow};
use super::plate::plate;
use crate::theme::{ACCENT, BAD, GRID, PLATE, TEXT, small};

/// Largest and smallest diameter, in points, and its share of the screen's height between them.
const SIDE: (f32, f32) = (148.0, 60.0);
const SHARE: f32 = 0.24;
/// Width of the ring around the land, in points.
const RING: f32 = 7.0;
/// Width of the edges of squares, in points, and how much of that a point of a piece's length makes.
const EDGE: f32 = 1.4;
const THIN: f32 = 0.2;
/// What the large map lies on: it is looked at instead of the picture.
const SHEET: Color32 = Color32::from_rgba_premultiplied(10, 13, 22, 240);
/// How much of what is behind the land is covered, 0 to 255.
const COVER: u8 = 225;
/// The smallest diameter of the large map, in points.
const LARGE_SIDE: f32 = 120.0;
/// Height over the lower half's beginning, the middle of the screen: there hints end.
const BELOW_MIDDLE: f32 = 2.0;
/// Between the map and the land's name over it, and how much room both take, in points.
const GAP: f32 = 4.0;
const NAME: f32 = 30.0;
/// How far beside a mark its name begins, in points.
const NAME_BESIDE: f32 = 9.0;
/// How light the land is by its height, from the lowest, 0 to 255.
const LIGHTNESS: [f32; 5] = [48.0, 76.0, 110.0, 150.0, 214.0];
/// How much a land's own lightness counts beside that of a middling one, 0 to 255, and the lightest that ground gets.
const OWN_SHARE: f32 = 0.6;
const MIDDLE_GREY: f32 = 110.0;
const LIGHTEST: f32 = 235.0;
/// Which of a land's three colours each of these has, from 0 for low ground to 2 for high.
const HUES: [f32; 5] = [0.0, 0.0, 1.0, 1.5, 2.0];
/// How light the ground is where nothing of the sky is left, of what it would be under all of it.
const PIT: f32 = 0.15;
/// How much of a colour the map keeps: on so small a picture full ones would drown the marks.
const SATURATION: f32 = 0.75;

/// Colours of a land by its height, from the lowest, 0 to 255.
pub type Tints = [[f32; 3]; 5];

/// The colours in which a map shows a land whose low, middle and high ground has these, sRGB: their hues, lighter the
/// higher it is, and the lighter they are themselves: snow is white on it wherever it lies.
pub fn tints_of(ground: [[u8; 3]; 3]) -> Tints {
    std::array::from_fn(|stop| {
        let below = (HUES[stop] as usize).min(1);
        let part = HUES[stop] - below as f32;
        let colour = [0, 1, 2].map(|channel| {
            let [low, high] = [below, below + 1].map(|which| f32::from(ground[which][channel]));
            low + (high - low) * part
        });
        let grey = lightness(colour).max(1.0);
        let own = 1.0 + OWN_SHARE * (grey / MIDDLE_GREY - 1.0);
        let lightness = (LIGHTNESS[stop] * own).min(LIGHTEST);
        colour.map(|channel| (grey + (channel - grey) * SATURATION) * lightness / grey)
    })
}

/// Luma by the weights of BT.709.
fn lightness([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// A column of the land.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReliefNode {
    /// Metres from the player along two axes at a right angle; the second is a quarter turn clockwise from the first.
    pub at: [f32; 2],
    /// Its height, 0 lowest to 1 highest.
    pub share: f32,
    /// How much it faces the light, -1 to 1.
    pub light: f32,
    /// How much of the sky is left where the ground lies below untouched land, 0 to 1.
    pub sky: f32,
    /// The land's colours there.
    pub tints: Tints,
}

/// The land as it is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Relief {
    /// How far it reaches, metres.
    pub reach_m: f32,
    /// Columns.
    pub nodes: Vec<ReliefNode>,
    /// Four of them each, in the order of a Z: what is filled.
    pub patches: Vec<[u32; 4]>,
    /// Lines of equal height.
    pub contours: Vec<[[f32; 2]; 2]>,
    /// Pieces of the edges of squares that the world is in.
    pub edges: Vec<[[f32; 2]; 2]>,
}

/// What a mark on the map stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A lamp.
    Lamp,
    /// Someone who means no harm.
    Neutral,
    /// Someone who does.
    Hostile,
    /// A car.
    Car,
    /// A flag.
    Flag,
    /// A door.
    Door,
    /// A breadcrumb.
    Crumb,
    /// Home.
    Home,
}

/// A mark on the map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapMark {
    /// What it stands for.
    pub kind: MarkKind,
    /// What it is called, written beside it on the large map; may be empty.
    pub name: String,
    /// Where, as of [`ReliefNode`].
    pub at: [f32; 2],
}

/// The map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapModel {
    /// Whether it is the large one.
    pub is_large: bool,
    /// The land.
    pub relief: Arc<Relief>,
    /// Where the player looks, clockwise from the first axis, radians.
    pub heading_rad: f32,
    /// Where north is, clockwise from straight ahead, radians.
    pub north_rad: f32,
    /// What stands about.
    pub marks: Vec<MapMark>,
}

/// From metres of the map to points of the screen.
struct Projection {
    centre: Pos2,
    points_per_m: f32,
    turn: (f32, f32),
}

impl Projection {
    fn at(&self, [first, second]: [f32; 2]) -> Pos2 {
        let (sin, cos) = self.turn;
        let ahead = first * cos + second * sin;
        let right = second * cos - first * sin;
        self.centre + self.points_per_m * vec2(right, -ahead)
    }
}

/// Where the map stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// What its disc covers.
    pub disc: Rect,
    /// Whether there is room for the land's name over it.
    pub is_named: bool,
}

/// At the left below the middle of the screen, over the brush's instrument, or in its place where the screen is too low
/// for both. `bottom`: where instruments end. Where there is no room, there is no map.
pub(super) fn place(screen: Rect, bottom: f32) -> Option<Place> {
    let top = screen.center().y + BELOW_MIDDLE;
    let wanted = (SHARE * screen.height()).clamp(SIDE.1, SIDE.0);
    [bottom - OVER_BRUSH, bottom]
        .into_iter()
        .find_map(|bottom| {
            let side = wanted.min(bottom - top).min(0.3 * screen.width());
            let corner = pos2(screen.min.x, bottom - side);
            let disc = Rect::from_min_size(corner, vec2(side, side));
            let is_named = disc.min.y - NAME >= top;
            (side >= SIDE.1).then_some(Place { disc, is_named })
        })
}

/// Over the middle of the picture between `top` and `bottom`.
pub(super) fn large_place(screen: Rect, top: f32, bottom: f32) -> Option<Place> {
    let side = (bottom - top).min(screen.width());
    let centre = pos2(screen.center().x, f32::midpoint(top, bottom));
    (side >= LARGE_SIDE).then(|| Place {
        disc: Rect::from_center_size(centre, vec2(side, side)),
        is_named: false,
    })
}

/// Draws it, under the `name` of the land about the player where there is room for that.
pub(super) fn show(painter: &Painter, place: Place, texts: &Texts, model: &MapModel, name: &str) {
    let Place { disc, is_named } = place;
    if is_named && !name.is_empty() {
        let room = disc.with_min_y(disc.min.y - NAME).with_max_x(f32::INFINITY);
        let foot = disc.center_top() - vec2(0.0, GAP);
        plate(
            painter,
            room,
            foot,
            Align2::CENTER_BOTTOM,
            name,
            small(),
            TEXT,
        );
    }
    if !model.heading_rad.is_finite() {
        return;
    }
    let (centre, radius) = (disc.center(), 0.5 * disc.width());
    painter.circle_filled(centre, radius, if model.is_large { SHEET } else { PLATE });
    let inner = radius - RING;
    let projection = Projection {
        centre,
        points_per_m: inner / model.relief.reach_m.max(1.0),
        turn: model.heading_rad.sin_cos(),
    };
    // Where patches of two charts lie on each other nothing is to shine through.
    let cover = if model.is_large { u8::MAX } else { COVER };
    painter.add(land(&model.relief, &projection, cover));
    for line in &model.relief.contours {
        let ends = line.map(|end| projection.at(end));
        painter.line_segment(ends, Stroke::new(0.8, Color32::from_black_alpha(90)));
    }
    for piece in &model.relief.edges {
        let ends = piece.map(|end| projection.at(end));
        // Far ones are small on a disc that holds a whole plane.
        let width = (THIN * ends[0].distance(ends[1])).clamp(0.3, 1.0) * EDGE;
        painter.line_segment(ends, Stroke::new(width, TEXT.gamma_multiply(0.7)));
    }
    painter.circle_stroke(
        centre,
        inner,
        Stroke::new(2.0, Color32::from_rgb(8, 11, 19)),
    );
    marks(painter, disc, &projection, model);
    painter.circle_filled(centre, 6.5, Color32::from_rgb(8, 11, 19));
    arrow(painter, centre, 5.5, 0.0);
    rim(painter, centre, radius, texts, model.north_rad);
}

/// What stands about; on the large map with names.
fn marks(painter: &Painter, disc: Rect, projection: &Projection, model: &MapModel) {
    for mark in &model.marks {
        let at = projection.at(mark.at);
        paint_mark(painter, at, mark.kind);
        if model.is_large && !mark.name.is_empty() {
            let beside = at + vec2(NAME_BESIDE, 0.0);
            let (anchor, name) = (Align2::LEFT_CENTER, &mark.name);
            plate(painter, disc, beside, anchor, name, small(), TEXT);
        }
    }
}

fn land(relief: &Relief, projection: &Projection, cover: u8) -> Shape {
    let mut mesh = Mesh::default();
    for node in &relief.nodes {
        mesh.colored_vertex(projection.at(node.at), tint(node, cover));
    }
    let count = relief.nodes.len() as u32;
    for [a, b, c, d] in &relief.patches {
        if [a, b, c, d].into_iter().all(|corner| *corner < count) {
            mesh.add_triangle(*a, *b, *c);
            mesh.add_triangle(*b, *d, *c);
        }
    }
    Shape::mesh(mesh)
}

fn tint(node: &ReliefNode, cover: u8) -> Color32 {
    let ReliefNode {
        share,
        light,
        sky,
        tints,
        ..
    } = node;
    if !share.is_finite() {
        return Color32::TRANSPARENT;
    }
    let last = tints.len() - 1;
    let place = share.clamp(0.0, 1.0) * last as f32;
    let below = (place as usize).min(last - 1);
    let part = place - below as f32;
    let lit = (1.0 + 0.45 * light.clamp(-1.0, 1.0)) * (PIT + (1.0 - PIT) * sky.clamp(0.0, 1.0));
    let [r, g, b] = [0, 1, 2].map(|channel| {
        let (low, high) = (tints[below][channel], tints[below + 1][channel]);
        ((low + (high - low) * part) * lit).clamp(0.0, 255.0) as u8
    });
    Color32::from_rgba_unmultiplied(r, g, b, cover)
}

/// Told apart by shape as well as by colour: lamps are round, neutral figures square, hostile ones three-cornered, cars broad,
/// flags fly from a pole, doors are open frames, breadcrumbs are dots, and home is a house.
fn paint_mark(painter: &Painter, at: Pos2, kind: MarkKind) {
    let edge = Stroke::new(1.5, Color32::BLACK);
    match kind {
        MarkKind::Lamp => {
            painter.circle(at, 2.6, ACCENT, edge);
        }
        MarkKind::Neutral => {
            let square = Rect::from_center_size(at, vec2(6.5, 6.5));
            painter.rect(square, 0, TEXT, edge, egui::StrokeKind::Outside);
        }
        MarkKind::Car => {
            let body = Rect::from_center_size(at, vec2(11.0, 5.5));
            painter.rect(body, 2, ACCENT, edge, egui::StrokeKind::Outside);
        }
        MarkKind::Flag => pennant(painter, at + vec2(-2.0, 5.0), 5.0),
        MarkKind::Door => gate(painter, at + vec2(0.0, 5.0), 5.0),
        MarkKind::Crumb => {
            painter.circle(at, 2.0, TEXT, Stroke::new(1.0, Color32::BLACK));
        }
        MarkKind::Home => house(painter, at, edge),
        MarkKind::Hostile => {
            let corner = |turn: f32| {
                let (sin, cos) = (turn * TAU).sin_cos();
                at + 5.0 * vec2(sin, -cos)
            };
            let corners = vec![corner(0.0), corner(1.0 / 3.0), corner(2.0 / 3.0)];
            painter.add(Shape::convex_polygon(corners, BAD, edge));
        }
    }
}

/// A wall with a gable.
fn house(painter: &Painter, at: Pos2, edge: Stroke) {
    let corners = [
        (-4.5, 4.5),
        (-4.5, -1.0),
        (0.0, -5.5),
        (4.5, -1.0),
        (4.5, 4.5),
    ];
    let corners = corners.map(|(x, y)| at + vec2(x, y));
    painter.add(Shape::convex_polygon(corners.to_vec(), ACCENT, edge));
}

/// The mark of a flag or a door of that half height, which stands on a place; of anything else a mark over it.
pub(super) fn mark_on(painter: &Painter, foot: Pos2, size: f32, kind: MarkKind) {
    match kind {
        MarkKind::Flag => pennant(painter, foot, size),
        MarkKind::Door => gate(painter, foot, size),
        _ => paint_mark(painter, foot - vec2(0.0, size), kind),
    }
}

/// A flag of that half height, whose pole stands at a place.
fn pennant(painter: &Painter, foot: Pos2, size: f32) {
    let edge = Stroke::new(1.0, Color32::BLACK);
    let top = foot - vec2(0.0, 2.0 * size);
    painter.line_segment([foot, top], Stroke::new(3.0, Color32::BLACK));
    painter.line_segment([foot, top], Stroke::new(1.5, TEXT));
    let cloth = vec![
        top,
        top + vec2(1.5 * size, 0.5 * size),
        top + vec2(0.0, size),
    ];
    painter.add(Shape::convex_polygon(cloth, ACCENT, edge));
}

/// An open frame of that half height, which stands on a place.
fn gate(painter: &Painter, foot: Pos2, size: f32) {
    let corners = [(-0.8, 0.0), (-0.8, 2.0), (0.8, 2.0), (0.8, 0.0)];
    let corners = corners.map(|(x, y)| foot + vec2(x * size, -y * size));
    for (width, colour) in [(4.0, Color32::BLACK), (2.0, ACCENT)] {
        for side in corners.windows(2) {
            painter.line_segment([side[0], side[1]], Stroke::new(width, colour));
        }
    }
}

/// The letter of north on the ring, and ticks of the other quarters.
fn rim(painter: &Painter, centre: Pos2, radius: f32, texts: &Texts, north_rad: f32) {
    if !north_rad.is_finite() {
        return;
    }
    let way = |turn: f32| {
        let (sin, cos) = (north_rad + turn).sin_cos();
        vec2(sin, -cos)
    };
    for quarter in 1..4u8 {
        let way = way(f32::from(quarter) * 0.25 * TAU);
        let ends = [
            centre + (radius - RING) * way,
            centre + (radius - 2.0) * way,
        ];
        painter.line_segment(ends, Stroke::new(2.0, TEXT));
    }
    let at = centre + (radius - RING) * way(0.0);
    painter.circle_filled(at, 8.0, Color32::from_rgb(8, 11, 19));
    let letter = texts.say(QUARTERS[0]);
    let font = FontId::proportional(12.0);
    painter.text(at, Align2::CENTER_CENTER, letter, font, ACCENT);
}

/// How much room the brush's instrument takes at the lower left, and a gap over it, in points.
const OVER_BRUSH: f32 = 56.0 + 4.0 + 24.0 + GRID;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_player_looks_at_is_above_and_what_is_to_the_right_is_right() {
        for heading in [0.0f32, 1.0, 3.0, -2.0] {
            let projection = Projection {
                centre: pos2(50.0, 50.0),
                points_per_m: 1.0,
                turn: heading.sin_cos(),
            };
            let (sin, cos) = heading.sin_cos();
            let ahead = projection.at([10.0 * cos, 10.0 * sin]);
            assert!((ahead - pos2(50.0, 40.0)).length() < 1e-4, "{ahead:?}");
            // A quarter turn clockwise.
            let right = projection.at([-10.0 * sin, 10.0 * cos]);
            assert!((right - pos2(60.0, 50.0)).length() < 1e-4, "{right:?}");
        }
    }

    #[test]
    fn higher_land_is_lighter_and_slopes_that_face_the_light_are_lit() {
        let luminance = |colour: Color32| {
            u32::from(colour.r()) * 2 + u32::from(colour.g()) * 7 + u32::from(colour.b())
        };
        let tints = tints_of([[206, 92, 48], [96, 74, 78], [132, 120, 130]]);
        let node = |share: f32, light: f32, sky: f32| ReliefNode {
            at: [0.0; 2],
            share,
            light,
            sky,
            tints,
        };
        let heights: Vec<u32> = (0..=20)
            .map(|step| luminance(tint(&node(step as f32 / 20.0, 0.0, 1.0), COVER)))
            .collect();
        assert!(heights.is_sorted(), "{heights:?}");
        let lit = |light, sky| luminance(tint(&node(0.5, light, sky), COVER));
        assert!(lit(0.8, 1.0) > lit(-0.8, 1.0));
        assert!(
            lit(0.8, 0.0) < lit(-0.8, 1.0),
            "a pit is darker than any slope"
        );
        assert_eq!(tint(&node(f32::NAN, 0.0, 1.0), COVER), Color32::TRANSPARENT);
    }

    #[test]
    fn a_desert_is_not_green_on_the_map_and_a_jungle_is() {
        let mostly = |ground| {
            let [r, g, b] = tints_of(ground)[2];
            if g > r && g > b {
                "green"
            } else if r > g && g > b {
                "sand"
            } else {
                "else"
            }
        };
        assert_eq!(
            mostly([[166, 96, 66], [220, 164, 102], [244, 214, 156]]),
            "sand"
        );
        assert_eq!(
            mostly([[108, 88, 66], [78, 104, 66], [56, 108, 74]]),
            "green"
        );
    }
}
