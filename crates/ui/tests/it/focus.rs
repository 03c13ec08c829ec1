//! Where the focus goes: into questions, back to what was left, round lists; and that it cannot be taken for the
//! pointer.

use crate::common::{Game, click, decisions, focused, intents, press, type_text, window, world};
use antipode_settings::Action;
use antipode_ui::{Intent, Screen};
use egui::{Color32, Key, Shape, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn with_worlds(count: usize) -> Harness<'static, Game> {
    let mut game = Game::new();
    game.worlds = (0..count).map(world).collect();
    window(game)
}

/// Walks down from the focus until it is on this, and presses it.
fn walk_to(harness: &mut Harness<'_, Game>, label: &str) {
    for _ in 0..40 {
        if focused(harness) == label {
            return press(harness, Key::Enter);
        }
        press(harness, Key::ArrowDown);
    }
    panic!("“{label}” is not reached, only “{}”", focused(harness));
}

fn escape(harness: &mut Harness<'_, Game>) {
    let running = harness.state().running.is_some();
    harness.state_mut().shell.escape(running);
    harness.run();
}

#[test]
fn escape_gives_the_focus_back_to_the_button_of_the_screen_that_was_left() {
    for label in ["Load", "Delete", "Settings", "Controls", "About"] {
        let mut harness = with_worlds(3);
        walk_to(&mut harness, label);
        escape(&mut harness);
        assert_eq!(focused(&harness), label, "by keys");
        let mut harness = with_worlds(3);
        click(&mut harness, label);
        escape(&mut harness);
        assert_eq!(focused(&harness), label, "by the pointer");
    }
}

#[test]
fn from_one_screen_to_the_next_the_last_one_is_what_was_left() {
    let mut harness = with_worlds(3);
    click(&mut harness, "Settings");
    click(&mut harness, "Controls");
    escape(&mut harness);
    assert_eq!(focused(&harness), "Controls");
}

#[test]
fn back_on_a_page_gives_the_focus_back_to_what_led_there() {
    let mut harness = with_worlds(30);
    click(&mut harness, "Load");
    for _ in 0..20 {
        press(&mut harness, Key::ArrowDown);
    }
    press(&mut harness, Key::ArrowRight);
    let manage = focused(&harness);
    assert!(manage.contains("World 20"), "{manage}");
    press(&mut harness, Key::Enter);
    click(&mut harness, "Rename");
    escape(&mut harness);
    assert_eq!(focused(&harness), "Rename");
    escape(&mut harness);
    assert_eq!(focused(&harness), manage);
    let rect = harness.get_by_label(&manage).rect();
    assert!(rect.min.y > 0.0 && rect.max.y < 720.0, "in sight: {rect}");
    escape(&mut harness);
    assert_eq!(focused(&harness), "Load");
}

#[test]
fn what_is_gone_when_one_comes_back_leaves_the_focus_to_the_first() {
    let mut harness = with_worlds(3);
    walk_to(&mut harness, "Delete");
    walk_to(&mut harness, "Delete “World 1”");
    assert_eq!(focused(&harness), "Keep");
    harness.state_mut().worlds.remove(1);
    harness.run();
    assert_eq!(focused(&harness), "Delete “World 0”");
}

#[test]
fn a_button_that_goes_when_it_is_pressed_leaves_the_focus_to_the_first() {
    let mut game = Game::new();
    game.running = Some("World 0".to_owned());
    game.config.settings.hints = true;
    let mut harness = window(game);
    harness.run();
    walk_to(&mut harness, "Skip the hints");
    assert!(harness.query_by_label("Skip the hints").is_none());
    assert_eq!(focused(&harness), "Resume");
}

#[test]
fn a_message_gives_the_focus_back_to_the_row_it_was_about() {
    let mut harness = with_worlds(3);
    harness.state_mut().worlds[2].problem = Some("Its file is truncated.".to_owned());
    click(&mut harness, "Load");
    walk_to(&mut harness, "Load “World 2”");
    assert_eq!(focused(&harness), "OK");
    press(&mut harness, Key::Enter);
    assert_eq!(focused(&harness), "Load “World 2”");
}

#[test]
fn a_message_can_be_answered_by_enter_however_it_came_up() {
    let mut harness = with_worlds(2);
    harness.state_mut().worlds[1].problem = Some("Its file is truncated.".to_owned());
    click(&mut harness, "Load");
    click(&mut harness, "Load “World 1”");
    assert_eq!(focused(&harness), "OK");
}

#[test]
fn the_pause_menu_begins_anew_with_resume() {
    let mut harness = with_worlds(1);
    harness.state_mut().running = Some("World 0".to_owned());
    harness.run();
    click(&mut harness, "Settings");
    escape(&mut harness);
    assert_eq!(focused(&harness), "Settings");
    escape(&mut harness);
    assert_eq!(harness.state().shell.screen(), &Screen::Hidden);
    escape(&mut harness);
    assert_eq!(focused(&harness), "Resume");
}

#[test]
fn lists_go_round_at_both_ends() {
    let mut harness = with_worlds(30);
    assert_eq!(focused(&harness), "New Game");
    press(&mut harness, Key::ArrowUp);
    assert_eq!(focused(&harness), "Quit");
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "New Game");
    click(&mut harness, "Load");
    escape(&mut harness);
    press(&mut harness, Key::Enter);
    assert_eq!(focused(&harness), "Load “World 0”");
    press(&mut harness, Key::ArrowUp);
    assert_eq!(focused(&harness), "Load “World 29”");
    let rect = harness.get_by_label("Load “World 29”").rect();
    assert!(rect.max.y < 720.0, "in sight: {rect}");
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "Import", "under the list");
    press(&mut harness, Key::ArrowUp);
    assert_eq!(focused(&harness), "Load “World 29”");
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "Load “World 0”");
    let rect = harness.get_by_label("Load “World 0”").rect();
    assert!(rect.min.y > 0.0, "in sight: {rect}");
}

/// The Controls with two profiles, and the focus on a button above the list.
fn profiles(button: &str) -> Harness<'static, Game> {
    let mut harness = with_worlds(0);
    click(&mut harness, "Controls");
    click(&mut harness, "New profile");
    type_text(&mut harness, "Left hand");
    press(&mut harness, Key::Enter);
    intents(&mut harness);
    harness.get_by_label(button).focus();
    harness.run();
    harness
}

#[test]
fn questions_in_the_controls_take_the_focus_and_give_it_back() {
    for (button, yes) in [
        ("Delete profile", "Delete it"),
        ("Reset all keys", "Reset all"),
    ] {
        let mut harness = profiles(button);
        press(&mut harness, Key::Enter);
        assert_eq!(focused(&harness), "Cancel", "{button}");
        // What one does without reading is what changes nothing.
        press(&mut harness, Key::Enter);
        assert!(!harness.state().shell.wants_input(), "{button}");
        assert_eq!(decisions(&mut harness), [], "{button}");
        assert_eq!(focused(&harness), button);
        press(&mut harness, Key::Enter);
        press(&mut harness, Key::ArrowLeft);
        assert_eq!(focused(&harness), yes);
        press(&mut harness, Key::Enter);
        assert!(matches!(&decisions(&mut harness)[..], [Intent::Bind(_)]));
        assert!(!harness.state().shell.wants_input(), "{button}");
    }
}

#[test]
fn what_was_bound_has_the_focus_again() {
    let mut harness = with_worlds(0);
    click(&mut harness, "Controls");
    click(&mut harness, "Sprint: Left Shift");
    let key = antipode_settings::Input::named("KeyZ").unwrap();
    harness.state_mut().shell.take_input(key);
    harness.run();
    assert_eq!(focused(&harness), "Sprint: Z");
    let own = harness.state().config.profiles.chosen();
    assert!(own.inputs(Action::Sprint).contains(&key));
}

/// Colours of the outlines that are drawn about a place on the screen, with their widths.
fn outlines(harness: &Harness<'_, Game>, at: egui::Rect) -> Vec<(Color32, f32)> {
    let mut found = Vec::new();
    for clipped in &harness.output().shapes {
        if let Shape::Rect(rect) = &clipped.shape
            && rect.stroke.width > 0.0
            && at.expand(4.0).contains_rect(rect.rect)
            && rect.rect.contains_rect(at.shrink(4.0))
        {
            found.push((rect.stroke.color, rect.stroke.width));
        }
    }
    found
}

/// How much warmer than neutral a colour is, 0 to 255.
fn warmth(colour: Color32) -> u8 {
    colour.r().saturating_sub(colour.b())
}

#[test]
fn what_the_pointer_is_on_cannot_be_taken_for_what_has_the_focus() {
    let mut harness = with_worlds(3);
    assert_eq!(focused(&harness), "New Game");
    let [focused, pointed] =
        ["New Game", "Settings"].map(|label| harness.get_by_label(label).rect());
    let plain = outlines(&harness, pointed);
    harness.hover_at(pointed.center());
    harness.run();
    let ring = outlines(&harness, focused);
    let hover = outlines(&harness, pointed);
    let widest = |lines: &[(Color32, f32)]| lines.iter().fold(0.0, |most, line| line.1.max(most));
    assert!(
        widest(&ring) >= 2.0 && widest(&hover) < 2.0,
        "{ring:?} {hover:?}"
    );
    assert!(ring.iter().any(|line| warmth(line.0) > 40), "{ring:?}");
    assert!(hover.iter().all(|line| warmth(line.0) < 10), "{hover:?}");
    assert_ne!(hover, plain, "the pointer is seen, too");
}

#[test]
fn a_screen_fits_its_window_with_the_focus_anywhere() {
    // 800 by 600 and 1280 by 720 pixels at a scale of 2.
    for size in [
        vec2(400.0, 300.0),
        vec2(640.0, 360.0),
        Vec2::new(800.0, 600.0),
    ] {
        let mut game = Game::new();
        game.worlds = (0..30).map(world).collect();
        game.shell.open(Screen::Controls);
        let mut harness = crate::common::harness(game, size);
        harness.run();
        for _ in 0..60 {
            press(&mut harness, Key::ArrowDown);
            let label = focused(&harness);
            let rect = harness.get_by_label(&label).rect();
            assert!(
                rect.min.y >= 0.0 && rect.max.y <= size.y,
                "“{label}” at {rect} is out of sight at {size}"
            );
        }
    }
}
