//! Walks through the whole game in its window, with real keys and clicks; what came of them is asked of the disk.

use std::fs;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

use antipode_testing::may_skip;
use antipode_tests::program::{game, number, run};
use antipode_tests::seam::compare;
use antipode_tests::window::{Window, display, settings_file, settle_settings, with_hints};
use image::RgbImage;
use tempfile::TempDir;

mod backpack;
mod rooms;
mod settings;

/// Small, so that software draws it quickly; the menu has both its columns.
const SMALL: [&str; 4] = ["--size", "800x600", "--view-distance", "1"];
/// What it says of what is done in its menus and of what it shows is what these tests wait for.
const TOLD: [&str; 2] = ["--log", "debug"];
/// Nor is it shaded: these tests are about what one can do, others about pictures.
const PLAIN: &str = r#", "render-scale": "50", "msaa": "off", "shadows": "off""#;
/// What the display of the tests shows, pixels.
const SCREEN: (u32, u32) = (2560, 1440);
/// Most of a core that a game may use while nobody sees it.
const MOST_UNSEEN: f64 = 0.05;
/// Begins in a flat world by day.
/// On a shore, where little grows before the sky.
const IN_A_WORLD: [&str; 6] = ["--geometry", "euclidean", "--seed", "11", "--name", "Walk"];

/// An empty saves directory with settings for tests, and a display; `None` where there is none.
fn ready(more: &str) -> Option<(String, TempDir)> {
    let Some(display) = display() else {
        may_skip("a test display (ANTIPODE_TEST_DISPLAY; `cargo xtask test` starts one)");
        return None;
    };
    // A directory of its own for the worlds: pictures are kept beside it.
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(saves(&place)).unwrap();
    settle_settings(&saves(&place), &[PLAIN, more].concat());
    Some((display, place))
}

fn saves(place: &TempDir) -> std::path::PathBuf {
    place.path().join("worlds")
}

fn open(display: &str, place: &TempDir, more: &[&str]) -> Window {
    Window::open(display, &saves(place), &[&SMALL[..], &TOLD, more].concat())
}

/// Mean of a part of the picture; the part is in thousandths of its sides.
fn mean(picture: &RgbImage, (x, y): (u32, u32), (width, height): (u32, u32)) -> [f64; 3] {
    let (w, h) = picture.dimensions();
    let part = image::imageops::crop_imm(
        picture,
        x * w / 1000,
        y * h / 1000,
        (width * w / 1000).max(1),
        (height * h / 1000).max(1),
    )
    .to_image();
    let count = f64::from(part.width() * part.height());
    [0, 1, 2].map(|c| part.pixels().map(|p| f64::from(p.0[c])).sum::<f64>() / count)
}

/// The main menu: the column is dark, and the painted dusk glows low beside it.
fn shows_main_menu(picture: &RgbImage) -> bool {
    let [r, g, b] = mean(picture, (600, 680), (60, 60));
    mean(picture, (30, 900), (150, 60))
        .iter()
        .all(|c| *c < 60.0)
        && r > 110.0
        && r > g
        && g > b
}

/// A world that is played: no dark column on the left, but bright land beside the hotbar, and a sky.
fn shows_world(picture: &RgbImage) -> bool {
    let [r, g, b] = mean(picture, (20, 870), (120, 60));
    let [_, _, sky] = mean(picture, (300, 60), (300, 100));
    r + g + b > 240.0 && sky > 100.0
}

/// The lines of `antipode saves list`.
fn listed(saves: &Path) -> Vec<String> {
    let output = game(saves).args(["saves", "list"]).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Whether the settings on disk say this of a setting.
fn is_set(saves: &Path, id: &str, value: &str) -> bool {
    let text = fs::read_to_string(settings_file(saves)).unwrap();
    text.contains(&format!("\"{id}\": {value}"))
}

/// Whether nothing but black is shown.
fn is_black(picture: &RgbImage) -> bool {
    mean(picture, (100, 100), (800, 800))
        .iter()
        .all(|c| *c < 8.0)
}

/// The pictures in the album beside the worlds.
fn pictures(place: &TempDir) -> Vec<(u32, u32)> {
    let Ok(files) = fs::read_dir(place.path().join("screenshots")) else {
        return Vec::new();
    };
    let sizes = files.filter_map(|file| image::image_dimensions(file.unwrap().path()).ok());
    sizes.collect()
}

/// Whether the dark plate with a hint is up, in the middle under the upper edge.
fn shows_hint(picture: &RgbImage) -> bool {
    mean(picture, (440, 130), (120, 70))
        .iter()
        .all(|c| *c < 80.0)
}

/// From a world through the pause menu to the main menu.
fn leave_world(game: &mut Window) {
    game.shows("the world");
    game.key("Escape");
    game.shows("the pause menu");
    save_and_quit(game);
}

/// From the pause menu, in any language, to the main menu: past Save to Save and quit.
fn save_and_quit(game: &mut Window) {
    game.told_steps(&[
        ("Tab", "focus: "),
        ("Tab", "focus: "),
        ("Return", "pressed: "),
    ]);
    game.shows("the main menu");
    game.wait_until("the main menu", shows_main_menu);
    game.stillness();
}

#[test]
fn worlds_are_made_renamed_copied_exported_deleted_and_imported_by_hand() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let saves = saves(&place);
    let archive = place.path().join("kept.antipode");
    let mut game = open(&display, &place, &[]);
    game.wait_until("the main menu", shows_main_menu);
    game.told_steps(&[("Return", "pressed: New Game")]);
    game.overwrite("Alpha");
    let to_the_seed = [
        "focus: Hyperbolic lens",
        "focus: Hyperbolic world",
        "focus: Euclidean",
        "focus: Spherical",
        "focus: Creative",
        "focus: Gathering",
        "focus: blank",
    ];
    game.told_steps(&to_the_seed.map(|words| ("Tab", words)));
    game.overwrite("12");
    game.key("Return");
    game.wait_until("the new world", shows_world);
    leave_world(&mut game);

    game.told_steps(&[
        ("Tab", "focus: Load"),
        ("Return", "pressed: Load"),
        ("Tab", "focus: Manage “Alpha”"),
        ("Return", "pressed: Manage “Alpha”"),
        ("Tab", "focus: Rename"),
        ("Return", "pressed: Rename"),
    ]);
    game.overwrite("Beta");
    game.key("Return");
    game.wait_while("the new name", || !listed(&saves)[0].starts_with("Beta "));
    assert_eq!(listed(&saves).len(), 1, "it has another name only");
    game.stillness();
    game.told_steps(&[
        ("Tab", "focus: Rename"),
        ("Tab", "focus: Duplicate"),
        ("Return", "pressed: Duplicate"),
    ]);
    game.wait_while("the copy", || listed(&saves).len() != 2);
    game.stillness();
    game.told_steps(&[("Tab", "focus: Export"), ("Return", "pressed: Export")]);
    game.overwrite(archive.to_str().unwrap());
    game.key("Return");
    game.wait_while("the file", || !archive.exists());
    game.stillness();
    game.steps(&["Escape", "Escape"]);

    // Keep has the focus, so deleting takes a step aside.
    game.told_steps(&[
        ("Tab", "focus: Delete"),
        ("Return", "pressed: Delete"),
        ("Return", "pressed: Delete “Beta"),
        ("Return", "pressed: Keep"),
    ]);
    assert_eq!(listed(&saves).len(), 2, "the world is kept");
    game.told_steps(&[("Return", "pressed: Delete “Beta")]);
    game.told_steps(&[
        ("shift+Tab", "focus: Delete"),
        ("Return", "pressed: Delete"),
    ]);
    game.wait_while("the end of a world", || listed(&saves).len() != 1);
    game.stillness();
    game.step("Escape");

    game.told_steps(&[
        ("shift+Tab", "focus: Load"),
        ("Return", "pressed: Load"),
        ("Tab", "focus: Manage “Beta"),
        ("Tab", "focus: Back"),
        ("Tab", "focus: Import"),
        ("Return", "pressed: Import"),
    ]);
    game.overwrite(archive.to_str().unwrap());
    game.key("Return");
    game.wait_while("the world from the file", || listed(&saves).len() != 2);
    game.stillness();
    drop(game);
    let worlds = listed(&saves);
    assert!(
        worlds
            .iter()
            .all(|world| world.starts_with("Beta") && world.ends_with("sound")),
        "{worlds:?}"
    );
    assert!(
        worlds.iter().all(|world| world.contains("hyperbolic")),
        "{worlds:?}"
    );
}

/// Processor time that a process has used so far, seconds.
fn processor_s(process: u32) -> f64 {
    let text = fs::read_to_string(format!("/proc/{process}/stat")).unwrap();
    let fields: Vec<_> = text
        .rsplit_once(')')
        .unwrap()
        .1
        .split_whitespace()
        .collect();
    // User and system time are the 14th and 15th of all, in ticks that Linux has fixed at a hundredth.
    let ticks: f64 = fields[11..13]
        .iter()
        .map(|f| f.parse::<f64>().unwrap())
        .sum();
    ticks / 100.0
}

#[test]
fn a_world_survives_whatever_is_done_to_its_window() {
    let Some((display, place)) = ready("") else {
        return;
    };
    with_hints(&saves(&place));
    let mut game = open(&display, &place, &IN_A_WORLD);
    game.shows("the world");
    game.hold_key_for("w", "learnt Walk");
    game.look_down();
    game.key("4");
    game.hold_left_for("learnt Dig");

    game.key("F11");
    game.wait_until("a full screen", |picture| {
        picture.dimensions() == SCREEN && !is_black(picture)
    });
    game.key("F11");
    game.wait_until("a window again", |picture| {
        picture.dimensions() == (800, 600) && !is_black(picture)
    });
    for (asked, shown) in [
        ((1280, 720), (1280, 720)),
        ((1, 1), (320, 200)),
        ((800, 600), (800, 600)),
    ] {
        game.resize(asked.0, asked.1);
        let what = format!("a window of {shown:?}");
        // Without a manager of windows nobody keeps it from getting smaller than it wants.
        game.wait_until(&what, |picture| {
            let size = picture.dimensions();
            (size == shown && !is_black(picture)) || (asked == (1, 1) && size == asked)
        });
    }
    game.minimise();
    sleep(Duration::from_secs(1));
    // What it had begun it may end first, which takes a busy machine longer.
    let window_s = 5.0;
    let mut shares = Vec::new();
    while shares.len() < 6 && shares.last().is_none_or(|share| *share >= MOST_UNSEEN) {
        let used_s = processor_s(game.process());
        sleep(Duration::from_secs_f64(window_s));
        shares.push((processor_s(game.process()) - used_s) / window_s);
    }
    let least = shares.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(least < MOST_UNSEEN, "shares of a core unseen: {shares:?}");
    assert!(game.is_alive());
    game.restore();
    game.wait_until("the window", |picture| {
        picture.dimensions() == (800, 600) && !is_black(picture)
    });
    // The keyboard was elsewhere, so the game has paused.
    game.shows("the pause menu");
    save_and_quit(&mut game);
    drop(game);
    let saved = run(&saves(&place), "load Walk\nprobe");
    let edited = number(saved.probe(0), "chunks.edited");
    assert!(edited >= 1.0, "the hole is not in the save");
}

#[test]
fn photos_screenshots_and_the_console_are_had_from_the_keyboard() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let mut game = open(&display, &place, &IN_A_WORLD);
    game.shows("the world");
    game.wait_until("the world", shows_world);
    game.key("F12");
    game.wait_while("a screenshot", || pictures(&place) != [(800, 600)]);

    let world = game.look();
    game.key("p");
    game.shows("the photo mode");
    game.wait_until("the panel of the photo mode", |picture| {
        compare(picture, &world).mean > 8.0
    });
    // The button at the foot of the panel.
    game.click(537, 560);
    game.wait_while("a photo beside it", || pictures(&place).len() != 2);
    game.key("p");
    game.shows("the world");
    game.wait_until("the world again", shows_world);

    game.key("grave");
    game.shows("the console");
    game.wait_until("the console", |picture| {
        mean(picture, (100, 100), (800, 250))
            .iter()
            .all(|c| *c < 70.0)
    });
    // The rest of the word and the blank after it are put there by Tab.
    game.write("tel");
    game.key("Tab");
    game.write("40 40 30");
    game.key("Return");
    game.write("sho");
    game.key("Tab");
    game.write("typed.png");
    game.key("Return");
    let typed = place.path().join("screenshots/typed.png");
    game.wait_while("the picture that was asked for", || !typed.exists());
    game.key("Escape");
    game.wait_until("no console", |picture| {
        mean(picture, (100, 100), (800, 250))[2] > 70.0
    });
    leave_world(&mut game);
    drop(game);
    let saved = run(&saves(&place), "load Walk\nprobe");
    for (axis, wanted) in [("player.pos.0", 40.0), ("player.pos.2", 30.0)] {
        let at = number(saved.probe(0), axis);
        assert!((at - wanted).abs() < 0.5, "{axis}: {at}");
    }
}

#[test]
fn newcomers_are_told_what_to_do_and_what_the_game_is() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let saves = saves(&place);
    with_hints(&saves);
    let mut game = open(&display, &place, &IN_A_WORLD);
    game.wait_until("the first hint", |picture| {
        shows_world(picture) && shows_hint(picture)
    });
    for _ in 0..3 {
        game.turn(150, 0);
    }
    game.wait_for("learnt Look");
    game.hold_key_for("w", "learnt Walk");
    game.hold_key_for("space", "learnt Jump");
    game.hold_left_for("learnt Dig");
    // What is left, but for the menu.
    let mut skipped = game.look();
    for lesson in ["Talk", "Car", "Build", "Map", "Camera", "Backpack", "Photo"] {
        skipped = game.wait_until(&format!("the hint about {lesson}"), shows_hint);
        game.key("n");
        game.wait_for(&format!("learnt {lesson}"));
    }
    game.wait_until("the last hint", |picture| {
        let plate = |picture| image::imageops::crop_imm(picture, 350, 80, 100, 30).to_image();
        shows_hint(picture) && compare(&plate(picture), &plate(&skipped)).far_off > 0.02
    });
    assert!(is_set(&saves, "hints", "true"), "not all was told yet");
    game.key("Escape");
    // The one about curvature waits for a world that has a dial, so hints stay on.
    game.wait_while("the last lesson on disk", || {
        !fs::read_to_string(settings_file(&saves))
            .unwrap()
            .contains("\"menu\"")
    });
    game.stillness();
    game.key("Escape");
    game.wait_until("the world without hints", |picture| {
        shows_world(picture) && !shows_hint(picture)
    });
    leave_world(&mut game);
    let menu = game.stillness();
    game.told_steps(&[
        ("Tab", "focus: Load"),
        ("Tab", "focus: Delete"),
        ("Tab", "focus: Rooms"),
        ("Tab", "focus: Workshop"),
        ("Tab", "focus: Settings"),
        ("Tab", "focus: Controls"),
        ("Tab", "focus: About"),
        ("Return", "pressed: About"),
    ]);
    game.shows("the about screen");
    let about = game.stillness();
    assert!(compare(&about, &menu).mean > 10.0, "a pane over the dusk");
    let scrolled = game.step("Down");
    assert!(compare(&scrolled, &about).far_off > 0.005, "the words move");
    game.step("Escape");
    assert!(shows_main_menu(&game.look()));
}
