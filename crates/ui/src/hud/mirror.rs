//! The place of a car's rear mirror, and the frame about it. What it shows is a part of the picture under the display.

use egui::{Color32, Painter, Pos2, Rect, Stroke, StrokeKind, vec2};

/// How wide it is, as shares of the picture's width and height: the smaller of the two.
const WIDTH: (f32, f32) = (0.34, 0.75);
/// Width over height.
const ASPECT: f32 = 4.0;
/// How far it is below the picture's upper edge, as a share of its height.
const BELOW: f32 = 0.014;
/// Where a display is lower than this, the compass makes room for it; points.
pub(super) const COMPASS_FROM: f32 = 420.0;
/// Width of its frame, points.
const FRAME: f32 = 3.0;
const FRAME_COLOUR: Color32 = Color32::from_rgb(16, 17, 20);

/// Where the mirror is in a picture of that width and height, in the same unit, from its upper left corner.
pub fn mirror_place(width: f32, height: f32) -> Rect {
    let wide = (WIDTH.0 * width).min(WIDTH.1 * height);
    let corner = Pos2::new(0.5 * (width - wide), BELOW * height);
    Rect::from_min_size(corner, vec2(wide, wide / ASPECT))
}

/// Draws its frame; returns what it covers.
pub(super) fn show(painter: &Painter, picture: Rect) -> Rect {
    let place = mirror_place(picture.width(), picture.height());
    let place = place.translate(picture.min.to_vec2());
    let stroke = Stroke::new(FRAME, FRAME_COLOUR);
    // Half a point over the edge, so that none of the picture shows between them.
    painter.rect_stroke(place.shrink(0.5), 3, stroke, StrokeKind::Outside);
    place.expand(FRAME)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_wide_and_flat_in_the_middle_at_the_top_of_every_picture() {
        for (width, height) in [(1280.0, 720.0), (400.0, 900.0), (3440.0, 1440.0)] {
            let place = mirror_place(width, height);
            assert!((place.center().x - 0.5 * width).abs() < 1e-3);
            assert!(place.min.y > 0.0 && place.max.y < 0.25 * height);
            assert!((place.width() / place.height() - ASPECT).abs() < 1e-3);
        }
    }
}
