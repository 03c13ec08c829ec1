//! Shows the words of a figure on a plate over its head.

use egui::{Align2, FontId, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use super::plate::{height_of, plate};
use crate::theme::{PLATE, TEXT};

/// Side of the point that shows who speaks, in points.
const POINT: f32 = 8.0;
/// Where the words stand without the speaker, as a share of the screen's height from above.
const ASIDE: f32 = 0.68;

/// Widest that words get over a head, in points.
const WIDTH: f32 = 340.0;
/// How far beside a head words stand that have no room over it, in points.
const BESIDE: f32 = 80.0;

/// Words that are said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeechModel {
    /// The words.
    pub text: String,
    /// Over the speaker's head, from the screen's middle to the right and up, in halves of the screen's height; none
    /// where he is not in the picture.
    pub at: Option<[f32; 2]>,
}

/// Draws the words within the `room` of the screen that is free for them.
pub(super) fn show(painter: &Painter, screen: Rect, room: Rect, speech: &SpeechModel) {
    let half = 0.5 * screen.height();
    let head = speech
        .at
        .map(|at| screen.center() + vec2(at[0], -at[1]) * half)
        .filter(|head| !head.any_nan() && screen.contains(*head));
    let font = || FontId::proportional(16.0);
    let say = |room: Rect, at: Pos2, anchor: Align2| {
        plate(painter, room, at, anchor, &speech.text, font(), TEXT)
    };
    let Some(head) = head else {
        let aside = pos2(screen.center().x, screen.min.y + ASIDE * screen.height());
        say(room, aside, Align2::CENTER_BOTTOM);
        return;
    };
    let foot = head - vec2(0.0, POINT);
    let over = narrowed(room, foot.x);
    let height = height_of(painter, over, &speech.text, font());
    if foot.y - height < room.min.y {
        let (at, anchor) = beside(room, head);
        say(
            narrowed(room, at.x - 0.5 * WIDTH * anchor.x().to_sign()),
            at,
            anchor,
        );
        return;
    }
    let words = say(over, foot, Align2::CENTER_BOTTOM);
    let x = foot
        .x
        .clamp(words.min.x + 2.0 * POINT, words.max.x - 2.0 * POINT);
    let ends = [
        pos2(x - POINT, words.max.y),
        pos2(x + POINT, words.max.y),
        pos2(x, words.max.y + POINT),
    ];
    if (words.max.y - foot.y).abs() < 1.0 {
        painter.add(Shape::convex_polygon(ends.to_vec(), PLATE, Stroke::NONE));
    }
}

/// The part of the room that words about a speaker there may take, as near to him as the room allows.
fn narrowed(room: Rect, x: f32) -> Rect {
    let width = WIDTH.min(room.width());
    let least = room.min.x;
    let from = (x - 0.5 * width).clamp(least, (room.max.x - width).max(least));
    room.with_min_x(from).with_max_x(from + width)
}

/// Where words stand whose speaker is too near to have room over his head: at his side that has more of it.
fn beside(room: Rect, head: Pos2) -> (Pos2, Align2) {
    if room.max.x - head.x > head.x - room.min.x {
        (pos2(head.x + BESIDE, room.min.y), Align2::LEFT_TOP)
    } else {
        (pos2(head.x - BESIDE, room.min.y), Align2::RIGHT_TOP)
    }
}
