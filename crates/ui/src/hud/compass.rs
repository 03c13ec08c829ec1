//! The compass: a strip between the plates at the top, with the quarters of the horizon and the way to the equator, or home.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use antipode_language::{Texts, Value};
use egui::{Align2, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};

use super::minimap::{MarkKind, mark_on};
use super::plate::plate;
use crate::theme::{ACCENT, GRID, PLATE, TEXT, WEAK, small};

/// Widest and narrowest strip, in points; where there is less room there is none.
const WIDTH: (f32, f32) = (320.0, 84.0);
const HEIGHT: f32 = 26.0;
/// Room below it for the way to the equator or home.
const CAPTION: f32 = 30.0;
/// Where there is less room between the plates, that way is left out, in points.
const CAPTION_WIDTH: f32 = 190.0;
/// What the strip shows of the horizon from end to end, radians.
const SHOWN_RAD: f64 = 0.75 * PI;
/// Ticks of a full turn.
const TICKS: u32 = 24;

/// Which way the player looks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CompassModel {
    /// Heading from north, clockwise, radians.
    pub heading_rad: f64,
    /// Where it leads in a world of this kind.
    pub guide: Option<GuideView>,
    /// The flags, doors and cars of the world, and the way back.
    pub flags: Vec<FlagView>,
}

/// The way to a flag, a door or a car, or back along breadcrumbs.
#[derive(Clone, Debug, PartialEq)]
pub struct FlagView {
    /// What it is called; of what is only marked nothing.
    pub name: String,
    /// How far it is, metres.
    pub distance_m: f64,
    /// Where it is from straight ahead, clockwise, radians.
    pub bearing_rad: f64,
    /// As what it is marked.
    pub mark: MarkKind,
}

/// The flag that is named below the strip is no farther from straight ahead than this, radians.
const NAMED_RAD: f64 = 0.12;
/// Characters of its name that are shown at most.
const MOST_NAMED: usize = 24;

/// A place that the compass leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GuidePlace {
    /// The nearest point of the equator.
    Equator {
        /// The player's hemisphere, 'A' or 'B'.
        hemisphere: char,
    },
    /// Where one began in a world in squares.
    Home {
        /// How many squares away it is.
        squares: usize,
    },
}

/// The way there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuideView {
    /// Where it leads.
    pub to: GuidePlace,
    /// How far it is, metres.
    pub distance_m: f64,
    /// Where it is from straight ahead, clockwise, radians.
    pub bearing_rad: f64,
}

/// What is beside it is taken to be so many points wide, or a multiple of that.
const STEP: f32 = 16.0;

/// Draws it between `left` and `right`, two rectangles at the top of the screen; returns what it covers, nothing where
/// it has no room.
pub(super) fn show(
    painter: &Painter,
    screen: Rect,
    left: Rect,
    right: Rect,
    texts: &Texts,
    model: &CompassModel,
) -> Rect {
    let from = if left.is_positive() {
        // In steps, so that it does not jump about with every digit of what stands beside it.
        (left.max.x / STEP).ceil() * STEP + GRID
    } else {
        screen.min.x
    };
    // The line of flags is kept free whether one is straight ahead or not, so that nothing hops as one looks round.
    let has_names = model.flags.iter().any(|flag| !flag.name.is_empty());
    let captions = u8::from(model.guide.is_some()) + u8::from(has_names);
    let caption = f32::from(captions) * CAPTION;
    let low = screen.min.y + HEIGHT + caption;
    let to = if right.is_positive() && right.min.y < low {
        right.min.x - GRID
    } else {
        screen.max.x
    };
    let (centre, width) = in_gap(screen.center().x, from, to);
    let width = width.min(WIDTH.0);
    if width < WIDTH.1 || screen.height() < 4.0 * HEIGHT || !model.heading_rad.is_finite() {
        return Rect::NOTHING;
    }
    let size = vec2(width, HEIGHT);
    let strip = Rect::from_center_size(pos2(centre, screen.min.y + 0.5 * HEIGHT), size);
    painter.rect_filled(strip, 6, PLATE);
    quarters(painter, strip, texts, model.heading_rad);
    for flag in &model.flags {
        if let Some(x) = place(strip.shrink2(vec2(8.0, 0.0)), flag.bearing_rad) {
            mark_on(painter, pos2(x, strip.max.y - 2.0), 4.5, flag.mark);
        }
    }
    pointer(painter, strip);
    let mut covered = strip;
    if to - from >= CAPTION_WIDTH {
        if let Some(guide) = model.guide {
            let way = way_to_guide(painter, screen, strip, texts, guide);
            covered = covered.union(way);
        }
        if has_names {
            let at = pos2(strip.center().x, covered.max.y + 3.0);
            if let Some(flag) = named_flag(&model.flags) {
                way_to_flag(painter, screen, to - from, at, texts, flag);
            }
            covered.max.y = low.max(covered.max.y);
        }
    }
    covered
}

/// Where the strip's middle is between `from` and `to`, and its width: in the middle of the screen where that is not too
/// narrow, else in the middle of the gap.
fn in_gap(middle: f32, from: f32, to: f32) -> (f32, f32) {
    let even = 2.0 * (middle - from).min(to - middle);
    if even >= 0.6 * WIDTH.0 {
        (middle, even)
    } else {
        (f32::midpoint(from, to), to - from)
    }
}

/// The flag nearest to straight ahead, if one is about there.
fn named_flag(flags: &[FlagView]) -> Option<&FlagView> {
    let off = |flag: &FlagView| near_zero(flag.bearing_rad).abs();
    let named = flags.iter().filter(|flag| !flag.name.is_empty());
    let ahead = named.filter(|flag| off(flag) <= NAMED_RAD);
    ahead.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// What a flag is called, as far as there is room for it, and how far it is.
fn way_to_flag(
    painter: &Painter,
    screen: Rect,
    width: f32,
    at: Pos2,
    texts: &Texts,
    flag: &FlagView,
) -> Rect {
    let words = |name: &str| {
        let values = [
            ("name", name.into()),
            ("metres", Value::decimals(flag.distance_m, 0)),
        ];
        texts.say_with("compass-flag", &values)
    };
    let fits = |words: &str| {
        let galley = painter.layout_no_wrap(words.to_owned(), small(), TEXT);
        galley.size().x + 2.0 * GRID <= width
    };
    let mut name: String = flag.name.chars().take(MOST_NAMED).collect();
    while !fits(&words(&name)) && name.pop().is_some() {}
    let words = words(&name);
    plate(
        painter,
        screen,
        at,
        Align2::CENTER_TOP,
        &words,
        small(),
        TEXT,
    )
}

/// Angle within half a turn of zero.
fn near_zero(angle_rad: f64) -> f64 {
    PI - (PI - angle_rad).rem_euclid(TAU)
}

/// Where on the strip a bearing from straight ahead is, if it is shown.
fn place(strip: Rect, bearing_rad: f64) -> Option<f32> {
    let share = near_zero(bearing_rad) / SHOWN_RAD;
    (share.abs() <= 0.5).then(|| strip.center().x + share as f32 * strip.width())
}

fn quarters(painter: &Painter, strip: Rect, texts: &Texts, heading_rad: f64) {
    let inner = strip.shrink2(vec2(8.0, 0.0));
    for tick in 0..TICKS {
        let bearing = f64::from(tick) * TAU / f64::from(TICKS) - heading_rad;
        let Some(x) = place(inner, bearing) else {
            continue;
        };
        if tick % 6 != 0 {
            let low = strip.max.y - 4.0;
            let high = low - if tick % 3 == 0 { 7.0 } else { 4.0 };
            painter.line_segment([pos2(x, low), pos2(x, high)], Stroke::new(1.0, WEAK));
        }
    }
    for (quarter, key) in QUARTERS.into_iter().enumerate() {
        let bearing = quarter as f64 * FRAC_PI_2 - heading_rad;
        if let Some(x) = place(inner, bearing) {
            let colour = if quarter == 0 { ACCENT } else { TEXT };
            let at = pos2(x, strip.center().y);
            let words = painter.layout_no_wrap(texts.say(key), FontId::proportional(15.0), colour);
            let letter = Align2::CENTER_CENTER.anchor_size(at, words.size());
            let shift = (strip.min.x + 3.0 - letter.min.x).max(0.0)
                + (strip.max.x - 3.0 - letter.max.x).min(0.0);
            painter.galley(letter.min + vec2(shift, 0.0), words, colour);
        }
    }
}

/// Keys of the letters of north, east, south and west.
pub(super) const QUARTERS: [&str; 4] = [
    "compass-north",
    "compass-east",
    "compass-south",
    "compass-west",
];

/// Where straight ahead is.
fn pointer(painter: &Painter, strip: Rect) {
    let tip = pos2(strip.center().x, strip.min.y + 5.0);
    let base = strip.min.y - 1.0;
    let corners = vec![tip, pos2(tip.x - 5.0, base), pos2(tip.x + 5.0, base)];
    painter.add(Shape::convex_polygon(corners, TEXT, Stroke::NONE));
}

/// Below the strip: how far the place is, what is told with it, and an arrow that leads there.
fn way_to_guide(
    painter: &Painter,
    screen: Rect,
    strip: Rect,
    texts: &Texts,
    guide: GuideView,
) -> Rect {
    let metres = ("metres", Value::decimals(guide.distance_m, 0));
    let words = match guide.to {
        GuidePlace::Equator { hemisphere } => {
            texts.say_with("compass-equator", &[("letter", hemisphere.into()), metres])
        }
        GuidePlace::Home { squares } => {
            texts.say_with("compass-home", &[("squares", squares.into()), metres])
        }
    };
    let at = pos2(strip.center().x + 9.0, strip.max.y + 3.0);
    let said = plate(
        painter,
        screen,
        at,
        Align2::CENTER_TOP,
        &words,
        small(),
        TEXT,
    );
    let side = said.height();
    let plate_of_arrow =
        Rect::from_min_size(said.left_top() - vec2(side + 2.0, 0.0), Vec2::splat(side));
    painter.rect_filled(plate_of_arrow, 6, PLATE);
    arrow(
        painter,
        plate_of_arrow.center(),
        0.34 * side,
        guide.bearing_rad as f32,
    );
    said.union(plate_of_arrow)
}

/// An arrow of that half length that points at a bearing from straight up, clockwise.
pub(super) fn arrow(painter: &Painter, centre: Pos2, size: f32, bearing_rad: f32) {
    if !bearing_rad.is_finite() {
        return;
    }
    let (sin, cos) = bearing_rad.sin_cos();
    let at =
        |right: f32, up: f32| centre + size * vec2(right * cos + up * sin, right * sin - up * cos);
    // Two halves: a notch makes the whole concave.
    for side in [-1.0, 1.0] {
        let half = vec![at(0.0, 1.0), at(0.75 * side, -0.85), at(0.0, -0.45)];
        painter.add(Shape::convex_polygon(half, ACCENT, Stroke::NONE));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_flag_nearest_to_straight_ahead_is_named_and_none_that_is_aside() {
        let flag = |name: &str, bearing_rad| FlagView {
            name: name.to_owned(),
            distance_m: 10.0,
            bearing_rad,
            mark: MarkKind::Flag,
        };
        let flags = [
            flag("left", TAU - 0.1),
            flag("right", 0.05),
            flag("back", PI),
        ];
        assert_eq!(named_flag(&flags).map(|it| it.name.as_str()), Some("right"));
        assert_eq!(named_flag(&flags[2..]), None);
        assert_eq!(named_flag(&[flag("", 0.0)]), None, "it is only marked");
    }

    #[test]
    fn what_is_ahead_is_in_the_middle_and_what_is_behind_is_not_shown() {
        let strip = Rect::from_min_size(pos2(100.0, 0.0), vec2(200.0, HEIGHT));
        assert_eq!(place(strip, 0.0), Some(200.0));
        assert_eq!(place(strip, 8.0 * TAU), Some(200.0));
        assert!(
            place(strip, 0.5).is_some_and(|x| x > 200.0),
            "right is right"
        );
        assert!(place(strip, TAU - 0.5).is_some_and(|x| x < 200.0));
        assert_eq!(place(strip, PI), None);
        assert_eq!(place(strip, -FRAC_PI_2 - 0.01), None);
    }
}
