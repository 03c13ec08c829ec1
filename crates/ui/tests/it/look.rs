//! What can be told apart by eye, and what stands still.

use std::time::Duration;

use crate::common::{Game, press, world};
use antipode_language::Texts;
use antipode_ui::{Screen, apply_theme, heighten_contrast};
use egui::ecolor::Rgba;
use egui::epaint::RectShape;
use egui::{Color32, Key, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;

const SIZES: [Vec2; 3] = [vec2(1280.0, 720.0), vec2(800.0, 600.0), vec2(640.0, 360.0)];

/// The contrast of the Web Content Accessibility Guidelines.
fn contrast(a: Rgba, b: Rgba) -> f32 {
    let luminance = |colour: Rgba| 0.2126 * colour.r() + 0.7152 * colour.g() + 0.0722 * colour.b();
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// A colour over another one, mixed as screens do it.
fn over(colour: Color32, below: Color32) -> Color32 {
    below.blend(colour)
}

/// The filled rectangles of the frame, with the colour that they show over all that was painted below.
fn painted_over(harness: &Harness<'_, Game>, high_contrast: bool) -> Vec<(Rect, Color32)> {
    let mut shapes = harness.output().shapes.clone();
    if high_contrast {
        heighten_contrast(&mut shapes);
    }
    let mut shown: Vec<(Rect, Color32)> = Vec::new();
    for clipped in shapes {
        if let Shape::Rect(RectShape { rect, fill, .. }) = clipped.shape
            && fill != Color32::TRANSPARENT
        {
            let rect = rect.intersect(clipped.clip_rect);
            let below = shown.iter().rev().find(|(it, _)| it.contains_rect(rect));
            // The worst there is to shine through: as light as the handle.
            let below = below.map_or(Color32::from_gray(200), |(_, colour)| *colour);
            shown.push((rect, over(fill, below)));
        }
    }
    shown
}

/// Track and handle of the scroll bar beside a pane's body, and their colours.
fn scroll_bar(harness: &Harness<'_, Game>, high_contrast: bool) -> [(Rect, Color32); 2] {
    let shown = painted_over(harness, high_contrast);
    let narrow = |rect: &Rect| (4.0..=16.0).contains(&rect.width()) && rect.height() > 24.0;
    let mut bars = shown.into_iter().filter(|(rect, _)| narrow(rect));
    let track = bars.next().expect("there is a track");
    let handle = bars.find(|(rect, _)| track.0.contains_rect(*rect));
    [track, handle.expect("there is a handle")]
}

fn long_list(size: Vec2) -> Harness<'static, Game> {
    let mut game = Game::new();
    game.worlds = (0..40).map(world).collect();
    game.shell.open(Screen::Load);
    let mut harness = crate::common::harness(game, size);
    harness.run();
    harness
}

#[test]
fn the_handle_of_a_scroll_bar_stands_out_and_the_track_does_not() {
    for size in SIZES {
        for high_contrast in [false, true] {
            let harness = long_list(size);
            let [track, handle] = scroll_bar(&harness, high_contrast);
            assert!(track.0.width() >= 10.0, "{}", track.0);
            let pane = painted_over(&harness, high_contrast)
                .into_iter()
                .find(|(rect, _)| rect.width() > 200.0 && rect.contains_rect(track.0.shrink(1.0)));
            let (_, pane) = pane.expect("there is a pane");
            let [track, handle, pane] = [track.1, handle.1, pane].map(Rgba::from);
            assert!(contrast(handle, track) >= 3.0, "{handle:?} on {track:?}");
            assert!(contrast(handle, pane) >= 3.0, "{handle:?} on {pane:?}");
            assert!(
                contrast(track, pane) < contrast(handle, pane) / 2.0,
                "the handle, not the track, is what one sees"
            );
        }
    }
}

#[test]
fn the_handle_goes_down_as_one_scrolls_down() {
    let mut harness = long_list(vec2(1280.0, 720.0));
    let [track, first] = scroll_bar(&harness, false).map(|(rect, _)| rect);
    assert!((first.min.y - track.min.y).abs() < 1.0 && first.height() < 0.6 * track.height());
    press(&mut harness, Key::End);
    let [track, last] = scroll_bar(&harness, false).map(|(rect, _)| rect);
    assert!((last.max.y - track.max.y).abs() < 1.0, "{last} in {track}");
    assert!(last.height() >= 32.0, "{last}");
}

#[test]
fn a_line_of_text_with_the_cursor_in_it_stands_still() {
    // Drawn anew, the world behind a paused menu costs a third of a core. The harness has a steady cursor of its own.
    for screen in [Screen::NewGame, Screen::Settings] {
        let mut game = Game::new();
        game.running = Some("World 0".to_owned());
        game.shell.open(screen.clone());
        let context = egui::Context::default();
        apply_theme(&context);
        let mut waits = Duration::ZERO;
        for step in 0..12 {
            let size = vec2(1280.0, 720.0);
            let input = egui::RawInput {
                screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, size)),
                time: Some(f64::from(step) * 0.25),
                focused: true,
                ..egui::RawInput::default()
            };
            let output = context.run_pass(input, |context| game.show(context));
            waits = output.viewport_output[&egui::ViewportId::ROOT].repaint_delay;
        }
        assert!(context.text_edit_focused(), "{screen:?}");
        assert_eq!(waits, Duration::MAX, "{screen:?}");
    }
}

#[test]
fn every_long_page_has_its_scroll_bar_in_sight() {
    for (language, size) in
        crate::common::everywhere(&[vec2(400.0, 300.0), SIZES[2], SIZES[1], SIZES[0]])
    {
        for screen in [Screen::Settings, Screen::Controls] {
            let mut game = Game::new();
            game.texts = Texts::new(language);
            game.running = Some("World 0".to_owned());
            game.shell.open(screen.clone());
            let mut harness = crate::common::harness(game, size);
            harness.run();
            let narrow = |rect: &Rect| (4.0..=16.0).contains(&rect.width());
            let tall = |rect: &Rect| rect.height() > 24.0 && rect.min.x > 0.5 * size.x;
            let shown = painted_over(&harness, false).into_iter();
            let bars = shown.filter(|(rect, _)| narrow(rect) && tall(rect));
            let bars: Vec<_> = bars.map(|(rect, _)| rect).collect();
            let whole: Vec<_> = bars.iter().filter(|bar| bar.width() >= 9.5).collect();
            assert!(
                whole.len() >= 2,
                "{screen:?} in {language:?} at {size}: {bars:?}"
            );
            let track = whole[whole.len() - 2];
            for text in crate::common::painted(harness.output()) {
                let seen = text.rect.intersect(text.clip);
                let lies = track.intersects(seen);
                assert!(!lies, "“{}” in {language:?} at {size}", text.text);
            }
        }
    }
}
