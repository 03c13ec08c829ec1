//! The list of rooms and the page of one, and what differs from worlds there.

use crate::common::{Game, click, focused, intents, painted, press, room, window};
use antipode_ui::{Intent, Screen, WorldsIntent};
use egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// A room of the player's own and one of the game.
fn with_rooms() -> Game {
    let mut game = Game::new();
    game.rooms = vec![room(0, false), room(1, true)];
    game.shell.open(Screen::Rooms);
    game
}

fn says(harness: &Harness<'_, Game>, words: &str) -> bool {
    let texts = painted(harness.output());
    texts.iter().any(|text| text.text.contains(words))
}

/// What the buttons of a page are called that can be reached.
fn reached(harness: &mut Harness<'_, Game>, count: usize) -> Vec<String> {
    let mut passed = vec![focused(harness)];
    for _ in 1..count {
        press(harness, Key::Tab);
        passed.push(focused(harness));
    }
    passed
}

#[test]
fn rooms_are_reached_from_the_main_menu_and_entered() {
    let mut game = with_rooms();
    game.shell.open(Screen::Main);
    let mut harness = window(game);
    click(&mut harness, "Rooms");
    assert_eq!(harness.state().shell.screen(), &Screen::Rooms);
    assert!(says(&harness, "longer than the house"));
    click(&mut harness, "Enter “Room 1”");
    let slug = "game:room-1".to_owned();
    assert_eq!(intents(&mut harness), [Intent::EnterRoom { slug }]);
    click(&mut harness, "New room");
    assert_eq!(intents(&mut harness), [Intent::NewRoom]);
}

#[test]
fn the_workshop_leads_to_the_rooms_of_the_game_that_one_can_copy() {
    let mut game = with_rooms();
    game.shell.open(Screen::Workshop);
    let mut harness = window(game);
    click(&mut harness, "Rooms of the game");
    assert_eq!(harness.state().shell.screen(), &Screen::Rooms);
    assert!(says(&harness, "longer than the house"));
}

#[test]
fn a_room_of_the_game_can_be_entered_and_copied_only() {
    let mut harness = window(with_rooms());
    click(&mut harness, "Manage “Room 1”");
    assert!(says(&harness, "comes with the game"));
    assert!(!says(&harness, "/home/me/rooms"));
    assert_eq!(reached(&mut harness, 3), ["Enter", "Duplicate", "Export"]);
    intents(&mut harness);
    click(&mut harness, "Duplicate");
    let slug = "game:room-1".to_owned();
    assert_eq!(
        intents(&mut harness),
        [Intent::Rooms(WorldsIntent::Duplicate { slug })]
    );
}

#[test]
fn a_room_of_ones_own_is_renamed_and_deleted_after_a_question() {
    let mut harness = window(with_rooms());
    click(&mut harness, "Manage “Room 0”");
    assert!(says(&harness, "12 objects") && says(&harness, "/home/me/rooms/room-0"));
    let all = [
        "Enter",
        "Rename",
        "Duplicate",
        "Export",
        "Open folder",
        "Delete",
    ];
    assert_eq!(reached(&mut harness, 6), all);
    press(&mut harness, Key::Enter);
    assert!(says(&harness, "Delete “Room 0”?"));
    intents(&mut harness);
    click(&mut harness, "Delete");
    let slug = "room-0".to_owned();
    assert_eq!(intents(&mut harness), [Intent::DeleteRoom { slug }]);
    harness.get_by_label("Manage “Room 1”");
}

#[test]
fn in_a_room_one_leaves_it_and_saves_nothing() {
    let mut game = with_rooms();
    game.running = Some("The long house".to_owned());
    game.in_room = true;
    game.shell.open(Screen::Main);
    let mut harness = window(game);
    assert!(says(&harness, "The long house") && says(&harness, "Rooms"));
    assert!(!says(&harness, "Save"));
    click(&mut harness, "Start over");
    assert_eq!(intents(&mut harness), [Intent::BeginAnew]);
    click(&mut harness, "Leave the room");
    assert_eq!(intents(&mut harness), [Intent::SaveAndQuitToMenu]);
}
