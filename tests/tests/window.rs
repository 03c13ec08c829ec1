//! The whole path of a first evening, with real clicks and keys: make a world, dig, save, come back, find it.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::time::Duration;

use antipode_tests::program::{field, may_skip, number, run};
use antipode_tests::seam::{colours, compare};
use antipode_tests::window::{Window, display};

/// Places of buttons in a window of 1280 by 720.
const NEW_GAME: (u32, u32) = (132, 102);
const SPHERICAL: (u32, u32) = (870, 250);
const CREATE: (u32, u32) = (332, 672);
const SAVE_AND_QUIT: (u32, u32) = (132, 220);
const LOAD: (u32, u32) = (132, 150);
const FIRST_WORLD: (u32, u32) = (640, 120);
const QUIT: (u32, u32) = (132, 294);

/// The brightness of the middle of the menu's picture: bright dusk while no world is open.
fn shows_main_menu(picture: &image::RgbImage) -> bool {
    let [r, g, b] = picture.get_pixel(930, 560).0;
    r > 150 && r > g && g > b
}

/// A world in the middle of the window: no panel, no dusk, some land.
fn shows_world(picture: &image::RgbImage) -> bool {
    let hotbar = picture.view_colours(390, 650, 500, 60);
    !shows_main_menu(picture) && hotbar > 40 && colours(picture) > 2000
}

trait View {
    fn view_colours(&self, x: u32, y: u32, width: u32, height: u32) -> usize;
}

impl View for image::RgbImage {
    fn view_colours(&self, x: u32, y: u32, width: u32, height: u32) -> usize {
        colours(&image::imageops::crop_imm(self, x, y, width, height).to_image())
    }
}

#[test]
fn a_world_made_and_dug_by_hand_is_there_again_after_save_and_load() {
    let Some(display) = display() else {
        may_skip("a test display (ANTIPODE_TEST_DISPLAY; `cargo xtask test` starts one)");
        return;
    };
    let saves = tempfile::tempdir().unwrap();
    let mut game = Window::open(&display, saves.path(), &["--size", "1280x720", "--view-distance", "2"]);
    game.wait_until("the main menu", shows_main_menu);
    game.click(NEW_GAME.0, NEW_GAME.1);
    game.write("Digs");
    game.click(SPHERICAL.0, SPHERICAL.1);
    game.click(CREATE.0, CREATE.1);
    let fresh = game.wait_until("the new world", shows_world);
    game.hold_key("w", Duration::from_secs(1));
    game.turn(0, 200);
    game.turn(0, 150);
    game.key("4");
    game.hold_left(Duration::from_secs(3));
    let dug = game.wait_until("the hole", |picture| compare(picture, &fresh).mean > 5.0);
    game.key("Escape");
    game.wait_until("the pause menu", |picture| compare(picture, &dug).mean > 10.0);
    game.click(SAVE_AND_QUIT.0, SAVE_AND_QUIT.1);
    game.wait_until("the main menu after saving", shows_main_menu);
    game.click(QUIT.0, QUIT.1);
    assert_eq!(game.ended(), Some(0));

    let saved = run(saves.path(), "load Digs\nprobe");
    assert_eq!(field(saved.probe(0), "geometry"), "spherical");
    assert!(number(saved.probe(0), "chunks.edited") >= 1.0, "the hole is not in the save");

    let mut game = Window::open(&display, saves.path(), &["--size", "1280x720", "--view-distance", "2"]);
    game.wait_until("the main menu", shows_main_menu);
    game.click(LOAD.0, LOAD.1);
    std::thread::sleep(Duration::from_millis(500));
    game.click(FIRST_WORLD.0, FIRST_WORLD.1);
    let back = game.wait_until("the loaded world", shows_world);
    game.key("Escape");
    game.wait_until("the pause menu", |picture| compare(picture, &back).mean > 10.0);
    game.click(SAVE_AND_QUIT.0, SAVE_AND_QUIT.1);
    game.wait_until("the main menu after saving", shows_main_menu);
    game.click(QUIT.0, QUIT.1);
    assert_eq!(game.ended(), Some(0));

    let again = run(saves.path(), "load Digs\nprobe");
    for path in ["player.yaw", "player.pitch", "player.hemisphere", "chunks.edited", "seed"] {
        assert_eq!(field(saved.probe(0), path), field(again.probe(0), path), "{path}");
    }
    for axis in ["player.pos.0", "player.pos.1", "player.pos.2"] {
        let (a, b) = (number(saved.probe(0), axis), number(again.probe(0), axis));
        assert!((a - b).abs() < 0.05, "{axis}: {a} became {b}");
    }
}
