//! The whole path of a first evening, with real clicks and keys: make a world, dig, save, come back, find it.

use antipode_testing::may_skip;
use antipode_tests::program::{field, number, run};
use antipode_tests::seam::compare;
use antipode_tests::window::{Window, display, settle_settings, with_hints};

/// Places of buttons in a window of 1280 by 720.
const NEW_GAME: (u32, u32) = (132, 102);
const NAME: (u32, u32) = (640, 114);
const SEED: (u32, u32) = (640, 498);
const SPHERICAL: (u32, u32) = (870, 250);
const CREATE: (u32, u32) = (332, 672);
const SAVE_AND_QUIT: (u32, u32) = (132, 220);
const LOAD: (u32, u32) = (132, 150);
const FIRST_WORLD: (u32, u32) = (640, 100);
const QUIT: (u32, u32) = (132, 487);

/// What it says of what is done in its menus and of what it shows is what the test waits for.
const TOLD: [&str; 6] = [
    "--size",
    "1280x720",
    "--view-distance",
    "2",
    "--log",
    "debug",
];

/// The main menu: a dark column, and the painted dusk beside it, which reduced motion keeps in place of live worlds.
fn shows_main_menu(picture: &image::RgbImage) -> bool {
    let [r, g, b] = picture.get_pixel(930, 560).0;
    let column_is_dark = picture.get_pixel(240, 690).0.iter().all(|c| *c < 50);
    column_is_dark && r > 150 && r > g && g > b
}

/// A world: where the menu's dark column and panel stand there is bright land, and over it the compass has its white
/// pointer, which the picture of a world that is being made has not.
fn shows_world(picture: &image::RgbImage) -> bool {
    let bright = |x, y, width, height| {
        let part = image::imageops::crop_imm(picture, x, y, width, height).to_image();
        let sum: u64 = part
            .pixels()
            .map(|p| p.0.iter().map(|c| u64::from(*c)).sum::<u64>())
            .sum();
        sum / u64::from(3 * width * height) > 55
    };
    let pointer = picture.get_pixel(640, 10).0;
    let has_compass = pointer.iter().all(|channel| *channel > 200);
    !shows_main_menu(picture)
        && has_compass
        && bright(20, 420, 220, 200)
        && bright(320, 480, 200, 100)
}

/// The New Game form with a valid name: its hint is green.
fn shows_free_name(picture: &image::RgbImage) -> bool {
    let hint = image::imageops::crop_imm(picture, 290, 136, 130, 20).to_image();
    hint.pixels()
        .filter(|p| p.0[1] > 150 && p.0[1] > p.0[0].saturating_add(40))
        .count()
        > 20
}

/// The empty New Game form: its fields are darker than anything in the picture behind it.
fn shows_new_game(picture: &image::RgbImage) -> bool {
    [(900, NAME.1), (900, SEED.1)]
        .iter()
        .all(|(x, y)| picture.get_pixel(*x, *y).0.iter().all(|c| *c < 20))
}

/// The list of worlds: its first row is lighter than the panel.
fn shows_row(picture: &image::RgbImage) -> bool {
    picture.get_pixel(FIRST_WORLD.0, FIRST_WORLD.1).0[0] > 30 && !shows_new_game(picture)
}

/// Where the New Game form offers the sizes of a spherical world.
fn size_shown(picture: &image::RgbImage) -> image::RgbImage {
    image::imageops::crop_imm(picture, 290, 515, 400, 130).to_image()
}

#[test]
fn a_world_made_and_dug_by_hand_is_there_again_after_save_and_load() {
    let Some(display) = display() else {
        may_skip("a test display (ANTIPODE_TEST_DISPLAY; `cargo xtask test` starts one)");
        return;
    };
    let saves = tempfile::tempdir().unwrap();
    settle_settings(saves.path(), "");
    with_hints(saves.path());
    let mut game = Window::open(&display, saves.path(), &TOLD);
    game.wait_until("the main menu", shows_main_menu);
    game.told_click(NEW_GAME, "pressed: New Game");
    game.wait_until("the New Game form", shows_new_game);
    game.told_click(NAME, "pressed: World 1");
    game.overwrite("Digs");
    game.wait_until("a free name", shows_free_name);
    game.told_click(SEED, "pressed: blank: text input");
    game.told_write("12");
    let before = size_shown(&game.look());
    game.told_click(SPHERICAL, "pressed: Spherical");
    game.wait_until("the sizes of a spherical world", |picture| {
        compare(&size_shown(picture), &before).mean > 1.0
    });
    game.told_click(CREATE, "pressed: Create");
    game.shows("the world");
    game.wait_until("the new world", shows_world);
    game.hold_key_for("w", "learnt Walk");
    game.look_down();
    game.key("4");
    game.hold_left_for("learnt Dig");
    // Who slides into the hole is still on the way down.
    game.calm();
    game.key("Escape");
    game.shows("the pause menu");
    game.told_click(SAVE_AND_QUIT, "pressed: Save and quit");
    game.shows("the main menu");
    game.wait_until("the main menu after saving", shows_main_menu);
    game.told_click(QUIT, "pressed: Quit");
    assert_eq!(game.ended(), Some(0));

    let saved = run(saves.path(), "load Digs\nprobe");
    assert_eq!(field(saved.probe(0), "geometry"), "spherical");
    assert!(
        number(saved.probe(0), "chunks.edited") >= 1.0,
        "the hole is not in the save"
    );

    let mut game = Window::open(&display, saves.path(), &TOLD);
    game.wait_until("the main menu", shows_main_menu);
    game.told_click(LOAD, "pressed: Load");
    game.wait_until("the list of worlds", shows_row);
    game.told_click(FIRST_WORLD, "pressed: Load “Digs”");
    game.shows("the world");
    game.wait_until("the loaded world", shows_world);
    game.key("Escape");
    game.shows("the pause menu");
    game.told_click(SAVE_AND_QUIT, "pressed: Save and quit");
    game.shows("the main menu");
    game.wait_until("the main menu after saving", shows_main_menu);
    game.told_click(QUIT, "pressed: Quit");
    assert_eq!(game.ended(), Some(0));

    let again = run(saves.path(), "load Digs\nprobe");
    for path in [
        "player.yaw",
        "player.pitch",
        "player.hemisphere",
        "chunks.edited",
        "seed",
    ] {
        assert_eq!(
            field(saved.probe(0), path),
            field(again.probe(0), path),
            "{path}"
        );
    }
    for axis in ["player.pos.0", "player.pos.1", "player.pos.2"] {
        let (a, b) = (number(saved.probe(0), axis), number(again.probe(0), axis));
        assert!((a - b).abs() < 0.05, "{axis}: {a} became {b}");
    }
}
