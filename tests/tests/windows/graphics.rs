//! What can go wrong between the game and the graphics: the world goes on, or is saved and words are said.
#![cfg(unix)]

use std::cell::RefCell;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::{Mutex, MutexGuard, PoisonError};

use antipode_testing::may_skip;
use antipode_tests::background::{Background, signal};
use antipode_tests::program::{game, number, run};
use antipode_tests::seam::{colours, compare};
use antipode_tests::window::{Window, display, settle_settings};
use image::RgbImage;
use tempfile::TempDir;

/// A small window on software: a world called Felt, by day.
const SMALL: [&str; 6] = [
    "--size",
    "640x360",
    "--view-distance",
    "1",
    "--adapter",
    "software",
];

/// A saves directory with a world called Felt, of bare land: nothing that grows is before its sky.
fn felt() -> TempDir {
    let saves = tempfile::tempdir().unwrap();
    let made = run(
        saves.path(),
        "new euclidean seed=8 generator=2 name=Felt\nwait 0.5\nsave",
    );
    assert_eq!(made.status, Some(0), "{}", made.stderr);
    settle_settings(saves.path(), "");
    saves
}

fn open(screen: &Screen, saves: &Path, fault: &str) -> Window {
    let options = [&SMALL[..], &["--load", "Felt", "--inject", fault]].concat();
    Window::open(&screen.display, saves, &options)
}

/// A bright sky over land; the menu's backdrop is dark, and nothing at all is black.
fn shows_day(picture: &RgbImage) -> bool {
    let sky = picture.get_pixel(320, 40).0;
    sky.iter().all(|channel| *channel > 90) && colours(picture) > 500
}

/// The display, while it is one test's: a window that loses the keyboard to another's pauses its game.
struct Screen {
    display: String,
    _turn: MutexGuard<'static, ()>,
}

fn screen() -> Option<Screen> {
    static TURN: Mutex<()> = Mutex::new(());
    let Some(display) = display() else {
        may_skip("a test display (ANTIPODE_TEST_DISPLAY; `cargo xtask test` starts one)");
        return None;
    };
    let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    Some(Screen {
        display,
        _turn: turn,
    })
}

/// The world with all its land, where nothing strikes.
fn whole_world(screen: &Screen, saves: &Path) -> RgbImage {
    let options = [&SMALL[..], &["--load", "Felt"]].concat();
    let mut game = Window::open(&screen.display, saves, &options);
    let last = RefCell::new(game.wait_until("the world", shows_day));
    let whole = game.wait_until("all its land", |picture| {
        let changed = compare(picture, &last.replace(picture.clone())).mean;
        shows_day(picture) && changed < 1.0
    });
    signal("TERM", game.process());
    assert_eq!(game.ended(), Some(143));
    whole
}

/// The fault strikes in the open world, the same world is seen afterwards, and the game does what it is told.
fn goes_on_after(fault: &str, words: &str) {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let before = whole_world(&screen, saves.path());
    let mut game = open(&screen, saves.path(), fault);
    game.wait_for(words);
    let after = game.wait_until("the same world", |picture| {
        shows_day(picture) && compare(picture, &before).mean < 8.0
    });
    game.key("Escape");
    game.wait_until("the pause menu", |picture| {
        compare(picture, &after).mean > 10.0
    });
    signal("TERM", game.process());
    assert_eq!(game.ended(), Some(143));
}

/// The game has started itself anew and says over its menu what happened; pressing Return there leads to the menu.
fn tells_in_a_dialog(screen: &Screen, saves: &Path) {
    let mut told = Window::follow(&screen.display, saves, "--after-graphics");
    // A box of words in the middle of the painted dusk, which is bright there.
    let middle = |picture: &RgbImage| {
        let part = image::imageops::crop_imm(picture, 230, 60, 180, 30).to_image();
        let sum: u64 = part.pixels().map(|p| u64::from(p.0[0])).sum();
        sum / u64::from(part.width() * part.height())
    };
    told.wait_until("words about the graphics", |picture| {
        colours(picture) > 50 && middle(picture) < 40
    });
    told.stillness();
    told.step("Return");
    signal("TERM", told.process());
    told.gone();
}

#[test]
fn a_lost_adapter_is_opened_anew_and_the_world_is_drawn_as_before() {
    goes_on_after("lost-device", "drawing goes on with");
}

#[test]
fn a_lost_surface_is_made_anew() {
    goes_on_after("lost-surface", "made anew");
}

#[test]
fn an_adapter_that_is_lost_for_good_ends_the_game_in_words_with_the_world_saved() {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let before = number(run(saves.path(), "load Felt\nprobe").probe(0), "t");
    let game = open(&screen, saves.path(), "dead-device");
    let words = saves.path().join("stderr.txt");
    assert_eq!(game.ended(), Some(1));
    let words = std::fs::read_to_string(words).unwrap();
    let says = |line: &str| {
        line.starts_with("antipode: ") && line.contains("was lost") && line.contains("safe")
    };
    assert!(words.lines().any(says), "{words}");
    tells_in_a_dialog(&screen, saves.path());
    let after = number(run(saves.path(), "load Felt\nprobe").probe(0), "t");
    assert!(after > before, "{before} to {after}");
}

#[test]
fn a_shader_that_the_adapter_refuses_ends_the_game_in_words() {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let game = open(&screen, saves.path(), "broken-shader");
    let words = saves.path().join("stderr.txt");
    assert_eq!(game.ended(), Some(1));
    let words = std::fs::read_to_string(words).unwrap();
    let says =
        |line: &str| line.contains("refuses a shader") && line.contains("--adapter software");
    assert!(words.lines().any(says), "{words}");
    tells_in_a_dialog(&screen, saves.path());
    assert_eq!(run(saves.path(), "load Felt\nprobe").status, Some(0));
}

#[test]
fn a_night_of_the_machine_is_no_time_of_the_world() {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let mut game = open(&screen, saves.path(), "suspend");
    game.wait_for("Suspend");
    game.wait_until("the world", shows_day);
    signal("TERM", game.process());
    assert_eq!(game.ended(), Some(143));
    let t = number(run(saves.path(), "load Felt\nprobe").probe(0), "t");
    assert!((0.5..600.0).contains(&t), "{t} s");
}

#[test]
fn on_a_monitor_with_other_pixels_the_game_goes_on() {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let mut game = open(&screen, saves.path(), "rescale");
    let before = game.wait_until("the world", shows_day);
    game.wait_for("Rescale");
    // The hotbar is twice as large, under a sky that is there.
    game.wait_until("a larger display", |picture| {
        let bar =
            |picture: &RgbImage| image::imageops::crop_imm(picture, 0, 240, 640, 120).to_image();
        let sky = picture.get_pixel(60, 100).0;
        sky.iter().all(|channel| *channel > 90) && compare(&bar(picture), &bar(&before)).mean > 3.0
    });
    signal("TERM", game.process());
    assert_eq!(game.ended(), Some(143));
}

/// The program where no graphics driver is installed.
fn without_drivers(saves: &Path) -> Command {
    let mut command = game(saves);
    for (name, path) in [
        ("VK_DRIVER_FILES", "/nonexistent.json"),
        ("VK_ICD_FILENAMES", "/nonexistent.json"),
        ("LIBGL_DRIVERS_PATH", "/nonexistent"),
        ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json"),
    ] {
        command.env(name, path);
    }
    command
}

fn says_what_to_install(output: &Output) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    let last = said.trim().lines().last().unwrap();
    assert!(
        last.starts_with("antipode: ") && last.contains("nstall"),
        "{said}"
    );
}

#[test]
fn without_a_driver_a_script_that_takes_pictures_says_what_to_install() {
    let saves = felt();
    let script = saves.path().join("shot.txt");
    std::fs::write(&script, "load Felt\nshot a.png").unwrap();
    for adapter in ["auto", "gpu", "software"] {
        let output = without_drivers(saves.path())
            .args(["script", script.to_str().unwrap(), "--adapter", adapter])
            .output()
            .unwrap();
        says_what_to_install(&output);
        let lines = String::from_utf8_lossy(&output.stderr)
            .trim()
            .lines()
            .count();
        assert_eq!(lines, 1, "{adapter}");
    }
}

#[test]
fn without_a_driver_the_window_says_what_to_install() {
    let Some(screen) = screen() else {
        return;
    };
    let saves = felt();
    let output = without_drivers(saves.path())
        .args(["--config", "settings.ron"])
        .env("DISPLAY", &screen.display)
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .unwrap();
    says_what_to_install(&output);
}

/// Takes a picture where no folder is told for Wayland. Returns what was said on standard error, or nothing without an
/// adapter.
fn said_without_a_folder_for_wayland(card: Option<&str>) -> Option<String> {
    let saves = tempfile::tempdir().unwrap();
    let picture = saves.path().join("x.png");
    let mut command = game(saves.path());
    command.env("ANTIPODE_CONFIG", saves.path());
    for variable in [
        "XDG_RUNTIME_DIR",
        "WAYLAND_DISPLAY",
        "WAYLAND_SOCKET",
        "DRI_PRIME",
        "MESA_VK_DEVICE_SELECT",
        "NODEVICE_SELECT",
    ] {
        command.env_remove(variable);
    }
    command.envs(card.map(|card| ("DRI_PRIME", card)));
    command.args(["--adapter", "software", "--size", "64x64"]);
    command.args(["--view-distance", "1", "script", "-"]);
    let script = format!("new euclidean seed=8\nshot \"{}\"", picture.display());
    let ended = Background::begin_as(command, &script).ended();
    if !picture.exists() {
        assert!(ended.stderr.contains("adapter"), "{}", ended.stderr);
        return None;
    }
    assert_eq!(ended.status, Some(0), "{}", ended.stderr);
    Some(ended.stderr)
}

#[test]
fn without_a_folder_for_wayland_the_drivers_say_nothing() {
    let complaint = "XDG_RUNTIME_DIR";
    let Some(said) = said_without_a_folder_for_wayland(None) else {
        may_skip("a software adapter");
        return;
    };
    assert!(!said.contains(complaint), "{said}");
    // Who chooses a card has Mesa's layer asked, complaint and all: without it, silence is no merit.
    let asked = said_without_a_folder_for_wayland(Some("1")).unwrap_or_default();
    if !asked.contains(complaint) {
        antipode_testing::skipped("Mesa's device-select layer is missing");
    }
}
