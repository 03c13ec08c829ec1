//! The main menu, the lists of worlds, the controls, dialogs and Esc.

use crate::common::{Game, click, decisions, focused, intents, painted, press, window, world};
use antipode_ui::{Intent, Screen, ToastKind};
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn with_worlds(count: usize) -> Game {
    let mut game = Game::new();
    game.worlds = (0..count).map(world).collect();
    game
}

fn running(count: usize) -> Game {
    let mut game = with_worlds(count);
    game.running = Some("World 0".to_owned());
    game.worlds[0].running = true;
    game
}

fn screen<'a>(harness: &'a Harness<'_, Game>) -> &'a Screen {
    harness.state().shell.screen()
}

#[test]
fn the_pause_menu_adds_what_a_running_world_needs() {
    let mut harness = window(with_worlds(1));
    for label in ["New Game", "Load", "Delete", "Controls", "Quit"] {
        harness.get_by_label(label);
    }
    for label in ["Resume", "Save", "Save and quit to menu"] {
        assert!(harness.query_by_label(label).is_none(), "{label}");
    }
    harness.state_mut().running = Some("World 0".to_owned());
    harness.run();
    for label in ["Save", "Save and quit to menu", "Quit", "Resume"] {
        click(&mut harness, label);
    }
    let asked = [
        Intent::Save,
        Intent::SaveAndQuitToMenu,
        Intent::Quit,
        Intent::Resume,
    ];
    assert_eq!(intents(&mut harness), asked);
    assert_eq!(screen(&harness), &Screen::Hidden);
}

#[test]
fn the_first_button_has_the_focus_and_arrows_walk_on() {
    let mut harness = window(running(1));
    assert_eq!(focused(&harness), "Resume");
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "Save");
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), [Intent::Resume]);
}

#[test]
fn a_key_held_down_presses_a_button_once() {
    let mut harness = window(with_worlds(3));
    press(&mut harness, Key::ArrowDown);
    // Down and never up: egui tells repeats from presses by that.
    harness.key_down(Key::Enter);
    harness.run();
    assert_eq!(focused(&harness), "Load “World 0”");
    harness.key_down(Key::Enter);
    harness.run();
    assert_eq!(intents(&mut harness), []);
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
    press(&mut harness, Key::Enter);
    let slug = "world-0".to_owned();
    assert_eq!(intents(&mut harness), [Intent::Load { slug }]);
}

#[test]
fn escape_goes_one_level_back_and_out_of_the_pause_menu() {
    let mut harness = window(running(2));
    click(&mut harness, "Delete");
    click(&mut harness, "Delete “World 1”");
    harness.get_by_label("Keep");
    harness.state_mut().shell.escape(true);
    harness.run();
    assert_eq!(screen(&harness), &Screen::Delete);
    assert!(harness.query_by_label("Keep").is_none());
    harness.state_mut().shell.escape(true);
    assert_eq!(screen(&harness), &Screen::Main);
    harness.state_mut().shell.escape(true);
    assert!(!harness.state().shell.is_open());
    harness.state_mut().shell.escape(true);
    harness.run();
    assert_eq!(focused(&harness), "Resume");
    harness.state_mut().shell.escape(false);
    assert_eq!(
        screen(&harness),
        &Screen::Main,
        "without a world there is nothing to go back to"
    );
    assert_eq!(decisions(&mut harness), []);
}

#[test]
fn work_in_progress_ignores_escape_and_shows_its_state() {
    let mut harness = window(Game::new());
    let busy = |progress, detail: &str| Screen::Busy {
        title: "Loading Foo".to_owned(),
        progress,
        detail: detail.to_owned(),
    };
    harness
        .state_mut()
        .shell
        .open(busy(Some(0.5), "Making land"));
    harness.run();
    harness.state_mut().shell.escape(true);
    harness.get_by_label("50 %  ·  Making land");
    assert!(matches!(screen(&harness), Screen::Busy { .. }));
    // Unknown progress moves for ever, so it never settles.
    harness.state_mut().shell.open(busy(None, ""));
    harness.run_steps(3);
    harness.get_by_role_and_label(egui::Role::ProgressIndicator, "Loading Foo");
}

#[test]
fn a_message_is_dismissed_by_enter_and_by_escape() {
    let message = || Screen::Message {
        title: "Oh".to_owned(),
        text: "A sentence.".to_owned(),
    };
    let mut harness = window(running(1));
    harness.state_mut().shell.open(Screen::Hidden);
    harness.state_mut().shell.open(message());
    harness.run();
    harness.get_by_label("A sentence.");
    assert_eq!(focused(&harness), "OK");
    press(&mut harness, Key::Enter);
    assert_eq!(screen(&harness), &Screen::Hidden);
    harness.state_mut().shell.open(message());
    harness.state_mut().running = None;
    harness.state_mut().shell.escape(false);
    harness.run();
    assert_eq!(
        screen(&harness),
        &Screen::Main,
        "the world went away meanwhile"
    );
    assert_eq!(
        intents(&mut harness),
        [Intent::DismissMessage, Intent::DismissMessage]
    );
}

#[test]
fn an_unsaved_world_can_be_saved_again_stayed_in_or_lost() {
    let mut harness = window(running(1));
    for (label, intent) in [
        ("Try again", Intent::TrySavingAgain),
        ("Stay in the world", Intent::DismissMessage),
        ("Leave without saving", Intent::LeaveUnsaved),
    ] {
        harness.state_mut().shell.open(Screen::Main);
        harness.state_mut().shell.open(Screen::Unsaved {
            text: "The disk is full.".to_owned(),
        });
        harness.run();
        harness.get_by_label("The disk is full.");
        assert_eq!(focused(&harness), "Try again");
        click(&mut harness, label);
        assert_eq!(intents(&mut harness), [intent]);
    }
    harness.state_mut().shell.open(Screen::Main);
    harness.state_mut().shell.open(Screen::Unsaved {
        text: String::new(),
    });
    harness.state_mut().shell.escape(true);
    harness.run();
    assert_eq!(screen(&harness), &Screen::Main);
    assert_eq!(intents(&mut harness), [Intent::DismissMessage]);
}

#[test]
fn fifty_worlds_are_all_reached_by_the_arrow_key() {
    for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0), vec2(427.0, 240.0)] {
        let mut harness = crate::common::harness(with_worlds(50), size);
        harness.state_mut().shell.open(Screen::Load);
        harness.run();
        for index in 0..50 {
            let label = format!("Load “World {index}”");
            assert_eq!(focused(&harness), label, "at {size}");
            let rect = harness.get_by_label(&label).rect();
            let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, size);
            assert!(
                screen.contains_rect(rect),
                "{label} at {rect} is out of sight at {size}"
            );
            press(&mut harness, Key::ArrowDown);
        }
        press(&mut harness, Key::ArrowUp);
        press(&mut harness, Key::Enter);
        let slug = "world-49".to_owned();
        assert_eq!(intents(&mut harness), [Intent::Load { slug }], "at {size}");
    }
}

#[test]
fn page_keys_scroll_a_list() {
    let mut harness = window(with_worlds(50));
    click(&mut harness, "Load");
    let last = |harness: &Harness<'_, Game>| harness.get_by_label("Load “World 49”").rect().max.y;
    assert!(last(&harness) > 720.0);
    press(&mut harness, Key::End);
    assert!(last(&harness) < 720.0);
    press(&mut harness, Key::Home);
    assert!(last(&harness) > 720.0);
}

#[test]
fn a_row_tells_space_time_date_and_size() {
    let mut harness = window(with_worlds(1));
    click(&mut harness, "Load");
    let facts = "Spherical  ·  played 12 min  ·  2026-01-31  ·  1.2 MB";
    assert!(
        painted(harness.output())
            .iter()
            .any(|text| text.text == facts)
    );
}

#[test]
fn a_broken_world_says_why_and_is_not_loaded() {
    let mut game = with_worlds(2);
    game.worlds[1].problem = Some("Its file is truncated. Try: antipode saves repair.".to_owned());
    let mut harness = window(game);
    click(&mut harness, "Load");
    let said = |harness: &Harness<'_, Game>| {
        painted(harness.output())
            .iter()
            .any(|text| text.text.contains("truncated"))
    };
    assert!(said(&harness));
    click(&mut harness, "Load “World 1”");
    assert!(matches!(screen(&harness), Screen::Message { text, .. } if text.contains("truncated")));
    assert_eq!(intents(&mut harness), []);
}

#[test]
fn loading_the_running_world_goes_back_to_it() {
    let mut harness = window(running(2));
    click(&mut harness, "Load");
    click(&mut harness, "Load “World 0”");
    assert_eq!(intents(&mut harness), [Intent::Resume]);
}

#[test]
fn deleting_asks_first() {
    let mut harness = window(with_worlds(2));
    click(&mut harness, "Delete");
    click(&mut harness, "Delete “World 1”");
    harness.get_by_label("Delete “World 1”?");
    harness.get_by_label("This cannot be undone.");
    assert_eq!(focused(&harness), "Keep");
    press(&mut harness, Key::Enter);
    assert_eq!(decisions(&mut harness), []);
    click(&mut harness, "Delete “World 1”");
    click(&mut harness, "Delete");
    let slug = "world-1".to_owned();
    assert_eq!(decisions(&mut harness), [Intent::Delete { slug }]);
    assert_eq!(screen(&harness), &Screen::Delete);
}

#[test]
fn the_running_world_cannot_be_deleted() {
    let mut harness = window(running(2));
    click(&mut harness, "Delete");
    click(&mut harness, "Delete “World 0”");
    harness.get_by_label_contains("Save and quit to the menu first");
    assert!(harness.query_by_label("Keep").is_none());
    click(&mut harness, "OK");
    assert_eq!(screen(&harness), &Screen::Delete);
    assert_eq!(intents(&mut harness), [Intent::DismissMessage]);
}

#[test]
fn an_empty_list_says_what_to_do() {
    let mut harness = window(Game::new());
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    harness.get_by_label("There are no worlds yet. New Game makes one.");
    assert_eq!(focused(&harness), "Back");
}

#[test]
fn toasts_come_and_go_even_while_playing() {
    let mut harness = window(running(1));
    harness.state_mut().shell.open(Screen::Hidden);
    harness.state_mut().shell.toast("Saved.", ToastKind::Info);
    harness
        .state_mut()
        .shell
        .toast("The disk is full.", ToastKind::Problem);
    harness.step();
    harness.get_by_label("Saved.");
    // A step is a quarter of a second.
    harness.run_steps(20);
    assert!(harness.query_by_label("Saved.").is_none());
    harness.get_by_label("The disk is full.");
    harness.run_steps(16);
    assert!(harness.query_by_label("The disk is full.").is_none());
}
