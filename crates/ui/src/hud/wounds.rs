//! The health of others who are hurt, as small bars over their heads.

use egui::{Color32, Painter, Rect, pos2, vec2};

use crate::theme::{BAD, GOOD};

/// Least and greatest half width of a bar, and its height, in points.
const HALF_WIDTH: (f32, f32) = (14.0, 44.0);
const HEIGHT: f32 = 5.0;
/// Width of the dark edge, in points.
const EDGE: f32 = 1.5;
/// Share of health from which the bar is no longer red.
const WELL: f32 = 0.5;

/// A bar over someone's head.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WoundModel {
    /// Its middle, from the screen's middle to the right and up, in halves of the screen's height.
    pub at: [f32; 2],
    /// Half its width, in halves of the screen's height.
    pub half_width: f32,
    /// The share of it that is full, 0 to 1.
    pub share: f32,
}

/// Draws the bars.
pub(super) fn show(painter: &Painter, screen: Rect, wounds: &[WoundModel]) {
    let half = 0.5 * screen.height();
    for wound in wounds {
        let middle = screen.center() + vec2(wound.at[0], -wound.at[1]) * half;
        let half_width = (wound.half_width * half).clamp(HALF_WIDTH.0, HALF_WIDTH.1);
        if !middle.any_nan() && screen.expand(half_width).contains(middle) {
            bar(painter, middle, half_width, wound.share.clamp(0.0, 1.0));
        }
    }
}

fn bar(painter: &Painter, middle: egui::Pos2, half_width: f32, share: f32) {
    let whole = Rect::from_center_size(middle, vec2(2.0 * half_width, HEIGHT));
    painter.rect_filled(whole.expand(EDGE), 2.0, Color32::from_black_alpha(190));
    let colour = if share < WELL { BAD } else { GOOD };
    let end = pos2(whole.min.x + whole.width() * share, whole.max.y);
    painter.rect_filled(Rect::from_min_max(whole.min, end), 1.0, colour);
}
