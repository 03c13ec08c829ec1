//! Rooms: entered from the menu and from the command line, paused, left, and made by hand.

use super::*;

/// The names of the player's own rooms.
fn own_rooms(place: &TempDir) -> Vec<String> {
    let output = game(&saves(place))
        .args(["rooms", "list"])
        .output()
        .unwrap();
    let listed = String::from_utf8(output.stdout).unwrap();
    let own = listed.lines().filter(|line| !line.contains("the game's"));
    own.map(str::to_owned).collect()
}

#[test]
fn a_room_is_entered_from_the_menu_paused_and_left_and_one_is_made() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let mut game = open(&display, &place, &[]);
    game.shows("the main menu");
    game.told_steps(&[
        ("Tab", "focus: Load"),
        ("Tab", "focus: Delete"),
        ("Tab", "focus: Rooms"),
        ("Return", "pressed: Rooms"),
    ]);
    game.shows("the rooms");
    game.told_steps(&[("Return", "pressed: Enter “The long house”")]);
    game.shows("the room");
    game.wait_until("a picture of the room", |picture| !is_black(picture));
    game.key("Escape");
    game.shows("the pause menu");
    game.told_steps(&[("Tab", "focus: Start over")]);
    game.key("Return");
    game.shows("the room");
    game.key("Escape");
    game.shows("the pause menu");
    game.told_steps(&[
        ("Tab", "focus: Start over"),
        ("Tab", "focus: Leave the room"),
        ("Return", "pressed: Leave the room"),
    ]);
    game.shows("the rooms");
    assert_eq!(own_rooms(&place), Vec::<String>::new(), "nothing was saved");
    drop(game);
}

#[test]
fn a_room_is_entered_from_the_command_line() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let mut game = open(&display, &place, &["--room", "nested boxes"]);
    game.shows("the room");
    game.wait_until("a picture of the room", |picture| !is_black(picture));
    assert!(game.is_alive());
}
