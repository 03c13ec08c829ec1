//! Every screen on every size of window: nothing panics, no words are cut off.

use crate::common::{Game, SIZES, SMALLEST, everywhere, painted, world};
use antipode_language::{Language, Texts};
use antipode_ui::{Screen, ToastKind};
use egui::{Pos2, Rect, vec2};

fn screens() -> Vec<Screen> {
    let sentence = "The world could not be opened: its file was written by a newer version. ";
    vec![
        Screen::Main,
        Screen::NewGame,
        Screen::Load,
        Screen::Delete,
        Screen::Rooms,
        Screen::Settings,
        Screen::Controls,
        Screen::About,
        Screen::Busy {
            title: "Loading Ωμέγα".to_owned(),
            progress: Some(f32::NAN),
            detail: "Making land".to_owned(),
        },
        Screen::Message {
            title: "No".repeat(60),
            text: sentence.repeat(12),
        },
        Screen::Unsaved {
            text: sentence.repeat(12),
        },
    ]
}

fn crowded(running: bool) -> Game {
    crowded_in(Language::English, running)
}

fn crowded_in(language: Language, running: bool) -> Game {
    let mut game = Game::new();
    game.texts = Texts::new(language);
    game.worlds = (0..50).map(world).collect();
    game.worlds[0].name = "Ж".repeat(40);
    game.worlds[1].name = "界".repeat(40);
    game.worlds[2].name = "W".repeat(40);
    game.worlds[2].problem = Some("Its file ends too early. ".repeat(6));
    game.worlds[3].running = running;
    game.running = running.then(|| "👩‍🚀".repeat(40));
    game
}

#[test]
fn no_size_makes_any_screen_panic() {
    for size in SIZES.into_iter().chain(SMALLEST) {
        for screen in screens() {
            let mut game = crowded(true);
            game.shell.open(screen);
            game.shell.toast(
                "A toast that is rather long for so small a window.",
                ToastKind::Info,
            );
            crate::common::harness(game, size).run_ok();
        }
    }
}

#[test]
fn no_words_are_cut_off_sideways_in_any_language() {
    for (language, size) in everywhere(&SIZES) {
        let window = Rect::from_min_size(Pos2::ZERO, size);
        for (screen, running) in screens()
            .into_iter()
            .flat_map(|screen| [(screen.clone(), false), (screen, true)])
        {
            let mut game = crowded_in(language, running);
            game.shell.open(screen.clone());
            let mut harness = crate::common::harness(game, size);
            harness.run_ok();
            let texts = painted(harness.output());
            assert!(!texts.is_empty(), "{screen:?} at {size} is bare");
            for text in texts {
                let seen = text.clip.intersect(window).expand(0.5).x_range();
                let whole = seen.contains(text.rect.min.x) && seen.contains(text.rect.max.x);
                assert!(whole, "“{}” is cut off on {screen:?} at {size}", text.text);
                let names = text.text.chars().count() == 40 || text.text.contains("🚀");
                assert!(
                    !text.elided || names,
                    "“{}” is shortened on {screen:?} at {size}",
                    text.text
                );
            }
        }
    }
}

#[test]
fn the_main_menu_needs_no_scrolling_at_640_by_360() {
    for language in Language::ALL {
        let label = Texts::new(language).say("menu-quit");
        let mut harness = crate::common::harness(crowded_in(language, true), vec2(640.0, 360.0));
        harness.run();
        let texts = painted(harness.output()).into_iter();
        let lowest = texts
            .filter(|text| text.text == label)
            .map(|text| text.rect.max.y);
        let lowest = lowest.fold(f32::NAN, f32::max);
        assert!(lowest < 356.0, "“{label}” ends at {lowest}");
    }
}

#[test]
fn the_note_on_the_adapter_is_seen_without_scrolling_at_800_by_600() {
    for (language, running) in Language::ALL
        .into_iter()
        .flat_map(|l| [(l, false), (l, true)])
    {
        let mut game = crowded_in(language, running);
        let values = [
            ("adapter", "llvmpipe (LLVM 20.1.2, 256 bits)".into()),
            ("percent", 50.into()),
        ];
        game.adapter_notice = game.texts.say_with("adapter-software", &values);
        let notice = game.adapter_notice.clone();
        let mut harness = crate::common::harness(game, vec2(800.0, 600.0));
        harness.run();
        let texts = painted(harness.output());
        let seen = texts.iter().find(|text| text.text == notice);
        let seen = seen.unwrap_or_else(|| panic!("{language:?}: not there"));
        assert!(
            seen.rect.max.y < 600.0,
            "{language:?} {running}: {}",
            seen.rect
        );
    }
}
