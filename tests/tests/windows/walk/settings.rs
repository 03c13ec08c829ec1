//! Settings and keys, found and changed by the keyboard; what came of them is asked of the disk and of a save.

use std::fs;

use antipode_tests::program::{number, run};
use antipode_tests::seam::compare;
use antipode_tests::window::{settings_file, with_hints};
use tempfile::TempDir;

use super::{IN_A_WORLD, is_set, leave_world, open, ready, saves, shows_main_menu};

#[test]
fn settings_are_found_changed_and_reset_and_a_key_does_what_it_was_given() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let saves = saves(&place);
    let mut game = open(&display, &place, &[]);
    game.wait_until("the main menu", shows_main_menu);
    game.told_steps(&[
        ("Tab", "focus: Load"),
        ("Tab", "focus: Delete"),
        ("Tab", "focus: Rooms"),
        ("Tab", "focus: Workshop"),
        ("Tab", "focus: Settings"),
        ("Return", "pressed: Settings"),
    ]);
    game.shows("the settings");
    game.told_write("field of view");
    game.told_steps(&[
        ("Tab", "focus: Field of view"),
        ("Right", "changed: Field of view: 76"),
        ("Right", "changed: Field of view: 77"),
        ("Right", "changed: Field of view: 78"),
    ]);
    game.wait_while("a wider view on disk", || {
        !is_set(&saves, "field-of-view", "78")
    });
    game.told_steps(&[
        ("shift+Tab", "focus: Reset “Field of view”"),
        ("Return", "pressed: Reset “Field of view”"),
    ]);
    game.wait_while("the view as it comes", || {
        !is_set(&saves, "field-of-view", "75")
    });
    game.step("Escape");
    let english = game.stillness();
    game.told_write("polski");
    game.told_steps(&[
        ("Tab", "focus: Reset “Language”"),
        ("Tab", "focus: Language: System"),
        ("Tab", "focus: Language: English"),
        ("Tab", "focus: Language: Polski"),
        ("Return", "pressed: Language: Polski"),
    ]);
    game.wait_while("Polish on disk", || !is_set(&saves, "language", "\"pl\""));
    game.step("Escape");
    let polish = game.stillness();
    let far_off = compare(&english, &polish).far_off;
    assert!(far_off > 0.005, "the words are others: {far_off}");

    game.key("Escape");
    game.shows("the main menu");
    game.told_steps(&[
        ("Tab", "focus: Wczytaj"),
        ("Tab", "focus: Usuń"),
        ("Tab", "focus: Pokoje"),
        ("Tab", "focus: Warsztat"),
        ("Tab", "focus: Ustawienia"),
        ("Tab", "focus: Sterowanie"),
        ("Return", "pressed: Sterowanie"),
    ]);
    game.shows("the controls");
    // The first line has the focus: walking forward, which W does.
    game.told_steps(&[("Return", "pressed: Idź naprzód: W")]);
    game.key("i");
    game.wait_while("the key on disk", || {
        let text = fs::read_to_string(settings_file(&saves)).unwrap();
        !text.contains("\"forward\": [\"KeyI\"]")
    });
    drop(game);
    walks_with_i(&display, &place);
}

/// A new world in which I walks; where the player got to is asked of the save.
fn walks_with_i(display: &str, place: &TempDir) {
    let saves = saves(place);
    let start = run(&saves, "new euclidean seed=11\nprobe");
    // The first hints end with what was walked, however slowly the machine plays.
    with_hints(&saves);
    let mut game = open(display, place, &IN_A_WORLD);
    game.shows("the world");
    game.hold_key_for("i", "learnt Walk");
    leave_world(&mut game);
    drop(game);
    let walked = run(&saves, "load Walk\nprobe");
    let along = |axis: &str| number(walked.probe(0), axis) - number(start.probe(0), axis);
    let walked_m = along("player.pos.0").hypot(along("player.pos.2"));
    assert!(walked_m > 1.0, "{walked_m} m with I");
}
