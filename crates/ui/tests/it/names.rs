//! Names that the fonts cannot write: no boxes, and something to tell the worlds apart by.

use crate::common::{Game, click, painted, type_text, world};
use antipode_ui::{Screen, ToastKind, WorldRow, apply_theme, legible_name};
use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

const NAMES: [&str; 8] = [
    "عالمي الجديد",
    "שלום עולם",
    "🫠🫠🫠",
    "👩\u{200d}🚀 base",
    "❤\u{fe0f}",
    "नमस्ते",
    "한국어 세계",
    "にほん",
];

fn row(index: usize, name: &str) -> WorldRow {
    let row = world(index);
    WorldRow {
        name: legible_name(name, &row.slug).into_owned(),
        full_name: name.to_owned(),
        ..row
    }
}

fn game() -> Game {
    let mut game = Game::new();
    let rows = NAMES.iter().enumerate();
    game.worlds = rows.map(|(index, name)| row(index, name)).collect();
    game
}

/// A window that fails where a character has no glyph.
fn strict(game: Game) -> Harness<'static, Game> {
    Harness::builder()
        .with_size(vec2(1280.0, 720.0))
        .with_max_steps(8)
        .with_context_setup(apply_theme)
        .build_ui_state(|ui, game: &mut Game| game.show(ui.ctx()), game)
}

#[test]
fn no_name_comes_out_as_boxes_in_lists_pages_questions_and_messages() {
    for screen in [Screen::Load, Screen::Delete] {
        let mut game = game();
        game.running = Some(game.worlds[0].name.clone());
        game.shell.open(screen);
        let names: Vec<_> = game.worlds.iter().map(|row| row.name.clone()).collect();
        for name in &names {
            game.shell
                .toast(format!("Renamed: {name}"), ToastKind::Info);
        }
        let mut harness = strict(game);
        harness.run_ok();
        let said = painted(harness.output());
        for (index, name) in names.iter().enumerate() {
            assert!(said.iter().any(|text| text.text == *name), "{name}");
            assert!(name == NAMES[index] || name.contains(&format!("(world-{index})")));
        }
    }
    let mut harness = strict(game());
    click(&mut harness, "Delete");
    click(&mut harness, "Delete “… (world-1)”");
    harness.get_by_label("Delete “… (world-1)”?");
}

#[test]
fn a_name_is_changed_as_it_is_written() {
    // The line of text itself has to show what is in it, boxes or not.
    let mut harness = crate::common::window(game());
    click(&mut harness, "Load");
    let manage = harness
        .state()
        .texts
        .say_with("worlds-manage", &[("name", "… (world-1)".into())]);
    click(&mut harness, &manage);
    click(&mut harness, "Rename");
    let typed = painted(harness.output());
    assert!(
        typed.iter().any(|text| text.text == NAMES[1]),
        "the whole name"
    );
    assert!(
        typed
            .iter()
            .any(|text| text.text.contains("name of its folder"))
    );
}

#[test]
fn the_form_for_a_new_world_says_what_will_not_be_shown() {
    let mut harness = crate::common::window(Game::new());
    click(&mut harness, "New Game");
    type_text(&mut harness, "Base");
    assert!(harness.query_by_label("This name is free.").is_some());
    type_text(&mut harness, " שלום");
    assert!(harness.query_by_label("This name is free.").is_none());
    harness.get_by_label_contains("name of its folder");
}
