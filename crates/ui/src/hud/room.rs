//! What the display says of a room: what is strange in it, how far off it feels what one looks at, how it is looked at, and
//! how large one is.

use egui::{Align2, FontId, Painter, Rect, pos2, vec2};

use super::plate::{height_of, plate};
use crate::theme::{ACCENT, GRID, TEXT, WEAK, small};

/// What the display says of a room, in words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoomModel {
    /// The room's name, while one has just entered.
    pub title: Option<String>,
    /// What is strange in it, meanwhile.
    pub sentence: Option<String>,
    /// How far off what is under the crosshair is; none for the sky.
    pub ahead: Option<String>,
    /// How the picture is made, where that is not by the game's own rule, and what that changes.
    pub look: Option<String>,
    /// Words over the left and the right half of a picture that is made by two rules.
    pub halves: Option<[String; 2]>,
    /// How large one is here, where that is not one's own size, and other things about oneself.
    pub state: Vec<String>,
}

/// Below this size of the screen, in points, words are smaller.
const ROOMY: (f32, f32) = (560.0, 420.0);
/// How much smaller.
const SMALLER: f32 = 0.8;
/// What stays free about the middle of the screen, up and down, in points: one aims there, and reads how far off it is.
const FREE: f32 = 44.0;

/// Draws the words within the `screen`, those at the top below `top`.
pub(super) fn show(painter: &Painter, screen: Rect, top: f32, room: &RoomModel) {
    let is_small = screen.width() < ROOMY.0 || screen.height() < ROOMY.1;
    let scale = if is_small { SMALLER } else { 1.0 };
    show_heading(painter, screen, top, (room, scale));
    if let Some(halves) = &room.halves {
        let y = screen.max.y - 0.22 * screen.height();
        for (words, x) in halves.iter().zip([0.25, 0.75]) {
            let at = pos2(screen.min.x + x * screen.width(), y);
            let anchor = Align2::CENTER_CENTER;
            plate(painter, screen, at, anchor, words, small(), TEXT);
        }
    }
    // Above the crosshair: below it stands who walks, seen from behind.
    if let Some(ahead) = &room.ahead {
        let at = painter.clip_rect().center() - vec2(0.0, 18.0);
        let anchor = Align2::CENTER_BOTTOM;
        plate(painter, screen, at, anchor, ahead, small(), WEAK);
    }
    show_state(painter, screen, &room.state, scale);
}

/// What the room is, at the top, as far as the middle stays free.
fn show_heading(painter: &Painter, screen: Rect, top: f32, (room, scale): (&RoomModel, f32)) {
    let mut at = pos2(screen.center().x, top);
    // The name stands in the corner, too.
    let title = room.title.clone().filter(|_| scale == 1.0);
    for (words, points, colour) in [
        (&title, 22.0, ACCENT),
        (&room.sentence, 16.0, TEXT),
        (&room.look, 15.0, TEXT),
    ] {
        let font = FontId::proportional(points * scale);
        let fits = |words: &&String| {
            let height = height_of(painter, screen, words, font.clone());
            at.y + height < screen.center().y - FREE
        };
        if let Some(words) = words.as_ref().filter(fits) {
            let anchor = Align2::CENTER_TOP;
            let drawn = plate(painter, screen, at, anchor, words, font, colour);
            at.y = drawn.max.y + 0.5 * GRID;
        }
    }
}

/// What there is to say of oneself, at the bottom, as far as the middle stays free: what is told first is left out last.
fn show_state(painter: &Painter, screen: Rect, state: &[String], scale: f32) {
    let font = FontId::proportional(small().size * scale);
    let most = screen.max.y - screen.center().y - FREE;
    let height = |words: &String| height_of(painter, screen, words, font.clone()) + 0.5 * GRID;
    let fitting = state.iter().map(height).scan(0.0, |sum, height| {
        *sum += height;
        (*sum < most).then_some(())
    });
    let shown = &state[..fitting.count()];
    let mut at = screen.left_bottom();
    for words in shown.iter().rev() {
        let anchor = Align2::LEFT_BOTTOM;
        let drawn = plate(painter, screen, at, anchor, words, font.clone(), TEXT);
        at.y = drawn.min.y - 0.5 * GRID;
    }
}

#[cfg(test)]
mod tests {
    use egui::{Context, LayerId, RawInput, Shape, vec2};

    use super::*;

    /// The plates that are drawn on a screen of that size.
    fn plates(size: (f32, f32)) -> Vec<Rect> {
        let screen = Rect::from_min_size(egui::Pos2::ZERO, vec2(size.0, size.1));
        let model = RoomModel {
            title: Some("Four tunnels".to_owned()),
            sentence: Some("All four tunnels are 79 metres long, ".repeat(4)),
            state: vec![
                "You are smaller here".to_owned(),
                "H: look · F: anew · ".repeat(12),
            ],
            ..RoomModel::default()
        };
        let context = Context::default();
        let input = RawInput {
            screen_rect: Some(screen),
            ..RawInput::default()
        };
        let output = context.run_pass(input, |context| {
            let painter = context.layer_painter(LayerId::background());
            show(&painter, screen, 8.0, &model);
        });
        let rect = |it: egui::epaint::ClippedShape| match it.shape {
            Shape::Rect(rect) => Some(rect.rect),
            _ => None,
        };
        output.shapes.into_iter().filter_map(rect).collect()
    }

    #[test]
    fn the_middle_of_a_small_window_stays_free() {
        assert_eq!(plates((1280.0, 720.0)).len(), 4, "there is room for all");
        let small = plates((420.0, 300.0));
        assert!(small.len() >= 2, "{small:?}");
        for plate in small {
            let is_clear = plate.max.y < 150.0 - FREE || plate.min.y > 150.0 + FREE;
            assert!(is_clear, "{plate:?}");
        }
    }
}
