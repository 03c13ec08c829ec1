//! High contrast and calm: how the interface is drawn for those who ask for it.
//!
//! Contrast is heightened after everything is drawn, shape by shape, so that no widget has to know of it.

use egui::epaint::{ClippedShape, shape_transform::adjust_colors};
use egui::{Color32, Context, ecolor::Rgba};

use crate::theme::{ACCENT, BAD, FOCUS, GOOD, LINE};

const WHITE: Color32 = Color32::WHITE;
const BLACK: Color32 = Color32::BLACK;
/// What is chosen, focused or headed.
const YELLOW: Color32 = Color32::from_rgb(0xFF, 0xE0, 0x00);
const RED: Color32 = Color32::from_rgb(0xFF, 0xB4, 0xB4);
const GREEN: Color32 = Color32::from_rgb(0x80, 0xFF, 0x80);
/// Fill of what can be pressed: dark enough for white words, light enough to be seen on black.
const BUTTON: Color32 = Color32::from_rgb(0x30, 0x30, 0x30);
/// Luminance above which a colour is one that something is written or outlined in.
const LIGHT: f32 = 0.4;
/// Outlines of panels and buttons.
const OUTLINE: Color32 = Color32::from_rgb(0xA0, 0xA0, 0xA0);
/// Opacity, 0 to 1, of a light fill that is more than a tint of what it lies on; from the first on it is something
/// that is not to be pressed now, which egui draws half through.
const FADED: f32 = 0.35;
const FILLED: f32 = 0.6;
/// Words on what is not to be pressed now.
const GREY: Color32 = Color32::from_rgb(0x90, 0x90, 0x90);

/// Redraws shapes in white and yellow on black, nothing shining through.
pub fn heighten_contrast(shapes: &mut [ClippedShape]) {
    for clipped in shapes {
        adjust_colors(&mut clipped.shape, |colour| *colour = heightened(*colour));
    }
}

/// The colour that stands for another in high contrast.
fn heightened(colour: Color32) -> Color32 {
    if colour == Color32::PLACEHOLDER || colour == Color32::TRANSPARENT {
        return colour;
    }
    let pairs = [
        (ACCENT, YELLOW),
        (FOCUS, YELLOW),
        (BAD, RED),
        (GOOD, GREEN),
        (LINE, OUTLINE),
    ];
    for (of, into) in pairs {
        if colour == of {
            return into;
        }
    }
    let alpha = f32::from(colour.a()) / 255.0;
    let [r, g, b, _] = colour.to_srgba_unmultiplied();
    let whole = Rgba::from(Color32::from_rgb(r, g, b));
    let luminance = 0.2126 * whole.r() + 0.7152 * whole.g() + 0.0722 * whole.b();
    match (luminance >= LIGHT, alpha >= FILLED) {
        (true, true) => WHITE,
        (true, false) if alpha >= FADED => GREY,
        (true, false) => tinted(colour),
        (false, _) => BLACK,
    }
}

/// Accent tints mark what is chosen; white ones are buttons and outlines.
fn tinted(colour: Color32) -> Color32 {
    let [r, _, b, _] = colour.to_srgba_unmultiplied();
    if r > b.saturating_add(40) {
        Color32::from_rgb(0x60, 0x50, 0x00)
    } else {
        BUTTON
    }
}

/// Lets nothing fade or slide where the player wants less motion.
pub fn set_calm(context: &Context, calm: bool) {
    context.all_styles_mut(|style| {
        style.animation_time = if calm { 0.0 } else { crate::theme::ANIMATION_S };
        if calm {
            style.scroll_animation = egui::style::ScrollAnimation::none();
        } else {
            style.scroll_animation = egui::style::ScrollAnimation::default();
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::{ON_ACCENT, PANEL, PLATE, SCRIM, TEXT, WEAK};

    /// The contrast of the Web Content Accessibility Guidelines.
    fn contrast(a: Color32, b: Color32) -> f32 {
        let luminance = |colour: Color32| {
            let rgba = Rgba::from(colour);
            0.2126 * rgba.r() + 0.7152 * rgba.g() + 0.0722 * rgba.b()
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn words_stand_out_seven_to_one_from_whatever_they_are_on() {
        let button = Color32::from_rgba_unmultiplied(255, 255, 255, 22);
        let grounds = [PANEL, PLATE, SCRIM, button];
        for ground in grounds.map(heightened) {
            assert_eq!(ground.a(), 255, "nothing shines through {ground:?}");
            for words in [TEXT, WEAK, ACCENT, BAD, GOOD, FOCUS].map(heightened) {
                assert!(contrast(words, ground) >= 7.0, "{words:?} on {ground:?}");
            }
        }
        assert!(contrast(heightened(ON_ACCENT), heightened(ACCENT)) >= 7.0);
    }

    #[test]
    fn lines_stay_visible_on_panels_and_nothing_stays_nothing() {
        assert!(contrast(heightened(LINE), heightened(PANEL)) >= 7.0);
        assert_eq!(heightened(Color32::TRANSPARENT), Color32::TRANSPARENT);
        assert_eq!(heightened(Color32::PLACEHOLDER), Color32::PLACEHOLDER);
    }

    #[test]
    fn all_that_is_painted_is_redrawn() {
        let context = Context::default();
        let output = context.run_ui(egui::RawInput::default(), |ui| {
            ui.painter().rect_filled(egui::Rect::EVERYTHING, 0, PANEL);
        });
        let mut shapes = output.shapes;
        heighten_contrast(&mut shapes);
        let black = |clipped: &ClippedShape| matches!(&clipped.shape, egui::Shape::Rect(rect) if rect.fill == BLACK);
        assert!(shapes.iter().any(black), "{shapes:?}");
    }
}
