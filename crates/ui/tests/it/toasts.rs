//! Lines that come and go lie on nothing that can be pressed or read, on any screen of any size.

use std::collections::BTreeSet;

use crate::common::{Game, Painted, click, painted, world};
use antipode_language::{Language, Texts};
use antipode_ui::{Backpack, Console, Screen, ToastKind};
use egui::{Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;

/// Windows of 1280 by 720 and 800 by 600 pixels at scales of 1 and 2, and smaller and larger ones.
const SIZES: [Vec2; 7] = [
    vec2(1280.0, 720.0),
    vec2(800.0, 600.0),
    vec2(640.0, 360.0),
    vec2(400.0, 300.0),
    vec2(427.0, 240.0),
    vec2(1920.0, 1080.0),
    vec2(1024.0, 768.0),
];

fn screens() -> Vec<Screen> {
    vec![
        Screen::Main,
        Screen::NewGame,
        Screen::Load,
        Screen::Delete,
        Screen::Rooms,
        Screen::Settings,
        Screen::Controls,
        Screen::About,
    ]
}

fn game(language: Language, running: bool, toasts: usize) -> Game {
    let mut game = Game::new();
    game.texts = Texts::new(language);
    game.worlds = (0..40).map(world).collect();
    game.running = running.then(|| "World 0".to_owned());
    add_toasts(&mut game, toasts);
    game
}

fn add_toasts(game: &mut Game, toasts: usize) {
    for number in 0..toasts {
        let words = format!("Toast {number}: something that takes a whole line to say.");
        game.shell.toast(words, ToastKind::Info);
    }
}

/// Texts of toasts, and of everything else.
fn apart(harness: &Harness<'_, Game>) -> (Vec<Painted>, Vec<Painted>) {
    let all = painted(harness.output()).into_iter();
    all.partition(|text| text.text.starts_with("Toast"))
}

/// Where what is pressed or read is seen.
fn lies_on_nothing(harness: &Harness<'_, Game>, size: Vec2, what: &str) {
    let (toasts, others) = apart(harness);
    assert!(!toasts.is_empty(), "no toast on {what} at {size}");
    let whole = Rect::from_min_size(Pos2::ZERO, size);
    for toast in &toasts {
        // The plate is larger than the words.
        let plate = toast.rect.expand2(vec2(8.0, 7.0));
        assert!(whole.contains_rect(toast.rect), "{what} at {size}");
        for other in &others {
            // Buttons reach farther than their words, too.
            let seen = other.rect.expand2(vec2(8.0, 4.0)).intersect(other.clip);
            assert!(
                !plate.intersects(seen),
                "“{}” lies on “{}” of {what} at {size}",
                toast.text,
                other.text
            );
        }
    }
}

#[test]
fn a_message_lies_on_no_button_of_any_screen() {
    for size in SIZES {
        for screen in screens() {
            for (running, toasts) in [(false, 1), (true, 1), (true, 3)] {
                let mut game = game(Language::German, running, toasts);
                game.shell.open(screen.clone());
                let mut harness = crate::common::harness(game, size);
                harness.run_steps(3);
                lies_on_nothing(&harness, size, &format!("{screen:?}"));
            }
        }
    }
}

#[test]
fn a_message_lies_on_no_button_of_a_worlds_page_and_its_forms() {
    for size in SIZES {
        for form in ["Rename", "Export", "Import"] {
            let mut game = game(Language::English, false, 0);
            game.shell.open(Screen::Load);
            let mut harness = crate::common::harness(game, size);
            harness.run();
            if form == "Import" {
                let label = harness.state().texts.say("worlds-import");
                click(&mut harness, &label);
            } else {
                let values = [("name", "World 0".into())];
                let manage = harness.state().texts.say_with("worlds-manage", &values);
                click(&mut harness, &manage);
                add_toasts(harness.state_mut(), 1);
                harness.run_steps(3);
                lies_on_nothing(&harness, size, "a world's page");
                let key = format!("worlds-{}", form.to_lowercase());
                let label = harness.state().texts.say(&key);
                click(&mut harness, &label);
            }
            add_toasts(harness.state_mut(), 1);
            harness.run_steps(3);
            lies_on_nothing(&harness, size, form);
        }
    }
}

#[test]
fn a_message_keeps_off_what_covers_the_world() {
    for size in SIZES {
        let screen = Rect::from_min_size(Pos2::ZERO, size);
        for covered in [Backpack::panel(screen), Console::panel(screen)] {
            let mut game = game(Language::English, true, 2);
            game.shell.open(Screen::Hidden);
            game.shell.keep_toasts_off(Some(covered));
            let mut harness = crate::common::harness(game, size);
            let mut seen = BTreeSet::new();
            // A step is a quarter of a second. What finds no room at first waits for it.
            for step in 0..60 {
                if step == 40 {
                    harness.state_mut().shell.keep_toasts_off(None);
                }
                harness.step();
                for toast in apart(&harness).0 {
                    let plate = toast.rect.expand2(vec2(8.0, 7.0));
                    let keeps_off = step >= 40 || !plate.intersects(covered);
                    assert!(keeps_off && screen.contains_rect(plate), "{size}");
                    seen.insert(toast.text);
                }
            }
            assert_eq!(seen.len(), 2, "at {size}");
        }
    }
}

#[test]
fn when_the_message_has_gone_the_screen_has_its_room_again() {
    let mut game = game(Language::English, false, 1);
    game.shell.open(Screen::Load);
    let mut harness = crate::common::harness(game, vec2(800.0, 600.0));
    let back = |harness: &Harness<'_, Game>| {
        let texts = painted(harness.output()).into_iter();
        let backs = texts.filter(|text| text.text == "Back");
        backs.map(|text| text.rect.max.y).fold(0.0, f32::max)
    };
    harness.run_steps(3);
    let above = back(&harness);
    // A step is a quarter of a second.
    harness.run_steps(20);
    assert!(apart(&harness).0.is_empty());
    assert!(back(&harness) > above + 30.0, "{above} {}", back(&harness));
}
