//! What the display says of a room: what is strange in it, how far off it feels what one looks at, how it is looked at, and
//! how large one is.

use egui::{Align2, FontId, Painter, Rect, pos2, vec2};

use super::plate::plate;
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

/// Draws the words within the `screen`, those at the top below `top`.
pub(super) fn show(painter: &Painter, screen: Rect, top: f32, room: &RoomModel) {
    let mut at = pos2(screen.center().x, top);
    for (words, font, colour) in [
        (&room.title, FontId::proportional(22.0), ACCENT),
        (&room.sentence, FontId::proportional(16.0), TEXT),
        (&room.look, FontId::proportional(15.0), TEXT),
    ] {
        if let Some(words) = words {
            let drawn = plate(painter, screen, at, Align2::CENTER_TOP, words, font, colour);
            at.y = drawn.max.y + 0.5 * GRID;
        }
    }
    if let Some([left, right]) = &room.halves {
        let y = screen.max.y - 0.22 * screen.height();
        for (words, x) in [(left, 0.25), (right, 0.75)] {
            let at = pos2(screen.min.x + x * screen.width(), y);
            plate(
                painter,
                screen,
                at,
                Align2::CENTER_CENTER,
                words,
                small(),
                TEXT,
            );
        }
    }
    if let Some(ahead) = &room.ahead {
        let at = painter.clip_rect().center() + vec2(0.0, 18.0);
        plate(
            painter,
            screen,
            at,
            Align2::CENTER_TOP,
            ahead,
            small(),
            WEAK,
        );
    }
    let mut at = screen.left_bottom();
    for words in room.state.iter().rev() {
        let drawn = plate(
            painter,
            screen,
            at,
            Align2::LEFT_BOTTOM,
            words,
            small(),
            TEXT,
        );
        at.y = drawn.min.y - 0.5 * GRID;
    }
}
