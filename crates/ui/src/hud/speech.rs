//! What somebody says, on a plate over his head.

use egui::{Align2, FontId, Painter, Rect, Shape, Stroke, pos2, vec2};

use super::plate::plate;
use crate::theme::{PLATE, TEXT};

/// Side of the point that shows who speaks, in points.
const POINT: f32 = 8.0;
/// Where the words stand without the speaker, as a share of the screen's height from above.
const ASIDE: f32 = 0.68;

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
    let aside = pos2(screen.center().x, screen.min.y + ASIDE * screen.height());
    let foot = head.map_or(aside, |head| head - vec2(0.0, POINT));
    let font = FontId::proportional(16.0);
    let words = plate(
        painter,
        room,
        foot,
        Align2::CENTER_BOTTOM,
        &speech.text,
        font,
        TEXT,
    );
    // Where the plate had to give way it has no point.
    if head.is_some() && (words.max.y - foot.y).abs() < 1.0 {
        let x = foot
            .x
            .clamp(words.min.x + 2.0 * POINT, words.max.x - 2.0 * POINT);
        let ends = [
            pos2(x - POINT, words.max.y),
            pos2(x + POINT, words.max.y),
            pos2(x, words.max.y + POINT),
        ];
        painter.add(Shape::convex_polygon(ends.to_vec(), PLATE, Stroke::NONE));
    }
}
