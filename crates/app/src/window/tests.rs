//! The game without a window: worlds that cannot be saved, loading without the keyboard, ends.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod backpack;
mod beginnings;
mod clock;
mod console;
mod flags;
mod flow;
mod newcomers;
mod options;
mod photo;
mod rooms;
mod sprint;
mod standing;
mod views;
mod workshop;
mod workshop_hands;
mod workshop_lists;
mod workshop_newcomers;
mod workshop_pictures;
mod workshop_reading;
mod workshop_views;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use antipode_geometry::Geometry;
use antipode_render::DrawStats;
use antipode_scene::frame::Quality;
use antipode_ui::{Intent, Screen};
use clap::Parser;
use tempfile::TempDir;

use super::game::Game;
use super::phase::{Phase, Request};
use super::press::Press;
use crate::bindings::Input;
use crate::cli::Cli;
use crate::common::Common;
use crate::drawn::Drawn;
use crate::session::{Beginning, NewWorld, Worlds};

/// A key or button for the world that is played.
fn input(game: &mut Game, input: Input, down: bool) {
    if game.is_playing() {
        game.press(&Press::of(input, down));
    }
}

/// A key in the window; whether it is nothing for the interface.
fn take_key(game: &mut Game, input: Input, down: bool, repeats: bool) -> bool {
    let press = Press {
        repeats,
        ..Press::of(input, down)
    };
    !game.press(&press).is_heard()
}

fn worlds(dir: &Path) -> Worlds {
    Worlds::new(&worlds_options(dir))
}

fn worlds_options(dir: &Path) -> Common {
    let path = dir.to_str().unwrap();
    let cli = Cli::try_parse_from(["antipode", "--saves-dir", path, "--view-distance", "1"]);
    cli.unwrap().common
}

/// A game that begins in a new world called x.
fn begun(dir: &TempDir) -> Game {
    let request = Request::New(NewWorld {
        geometry: Geometry::Euclidean,
        name: Some("x".to_owned()),
        seed: Some(7),
        radius_m: None,
        generator: None,
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    });
    Game::new(worlds(dir.path()), None, Some(request))
}

fn playing(dir: &TempDir) -> Game {
    let mut game = begun(dir);
    tick_until(&mut game, Game::is_playing);
    game
}

/// Lets the background work; how long it takes decides nothing.
fn tick_until(game: &mut Game, there: impl Fn(&Game) -> bool) {
    // A deadline for what hangs, on however busy a machine.
    let began = Instant::now();
    while began.elapsed() < Duration::from_mins(2) {
        if there(game) {
            return;
        }
        game.tick(Instant::now());
        game.play.drawn(true);
        std::thread::yield_now();
    }
    panic!("the game never got there: {:?}", game.play.phase);
}

fn is_paused(game: &Game) -> bool {
    matches!(game.play.phase, Phase::Paused(_))
}

/// Takes the world's folder away, so that nothing can be saved in it. Returns the way back.
fn take_away(dir: &TempDir) -> (PathBuf, PathBuf) {
    let way = (dir.path().join("aside"), dir.path().join("x"));
    fs::rename(&way.1, &way.0).unwrap();
    way
}

#[test]
fn a_world_that_cannot_be_saved_is_kept_open_until_it_can() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let (aside, home) = take_away(&dir);
    game.follow(Intent::SaveAndQuitToMenu);
    tick_until(&mut game, is_paused);
    assert!(matches!(game.menus.shell.screen(), Screen::Unsaved { .. }));
    fs::rename(aside, home).unwrap();
    game.follow(Intent::TrySavingAgain);
    tick_until(&mut game, |game| matches!(game.play.phase, Phase::Menu));
    let again = worlds(dir.path()).load("x").unwrap();
    again.close().unwrap();
}

#[test]
fn one_may_leave_without_saving_to_where_one_was_going() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    take_away(&dir);
    game.close_window();
    tick_until(&mut game, is_paused);
    assert!(!game.is_over());
    game.follow(Intent::LeaveUnsaved);
    tick_until(&mut game, Game::is_over);
    assert_eq!(game.play.last_words, None);
}

#[test]
fn staying_in_an_unsaved_world_leads_to_its_pause_menu() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let (aside, home) = take_away(&dir);
    game.follow(Intent::Quit);
    tick_until(&mut game, is_paused);
    game.escape();
    game.follow(Intent::DismissMessage);
    assert!(!matches!(game.menus.shell.screen(), Screen::Unsaved { .. }));
    fs::rename(aside, home).unwrap();
    game.finish();
    assert_eq!(game.play.last_words, None);
}

#[test]
fn where_nothing_can_be_shown_the_game_ends_with_what_it_could_not_save() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    take_away(&dir);
    game.end_unseen();
    tick_until(&mut game, Game::is_over);
    assert!(game.play.last_words.is_some());
}

#[test]
fn a_world_that_is_still_being_opened_is_closed_before_the_end() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = begun(&dir);
    game.finish();
    assert!(game.is_over());
    worlds(dir.path()).load("x").unwrap().close().unwrap();
}

#[test]
fn a_world_that_loads_while_the_player_is_elsewhere_waits_in_the_menu() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = begun(&dir);
    game.focus(true);
    game.focus(false);
    tick_until(&mut game, is_paused);
    assert_eq!(game.menus.shell.screen(), &Screen::Main);
    game.focus(true);
    assert!(is_paused(&game));
    game.follow(Intent::Resume);
    assert!(game.is_playing());
    game.finish();
}

#[test]
fn a_window_that_never_had_the_keyboard_begins_to_play_all_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = begun(&dir);
    game.focus(false);
    tick_until(&mut game, Game::is_playing);
    game.finish();
}

#[test]
fn a_save_that_fails_is_never_called_saved() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    input(&mut game, Input::Key("Escape"), true);
    tick_until(&mut game, is_saved);
    let (aside, home) = take_away(&dir);
    game.follow(Intent::Save);
    tick_until(&mut game, |game| !game.play.saving);
    assert!(!is_saved(&game));
    fs::rename(aside, home).unwrap();
    game.follow(Intent::Save);
    tick_until(&mut game, |game| !game.play.saving);
    assert!(is_saved(&game));
    game.finish();
}

fn is_saved(game: &Game) -> bool {
    game.play
        .phase
        .session()
        .is_some_and(|session| session.scene.is_saved())
}

fn gather(shape: &egui::Shape, into: &mut String) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, into)),
        egui::Shape::Text(text) => {
            into.push_str(text.galley.text());
            into.push('\n');
        }
        _ => {}
    }
}

/// Everything that the display and the menus write.
fn words(game: &mut Game) -> String {
    words_of(game, Drawn::new(&DrawStats::default(), Quality::Fast))
}

/// As [`words`], after a picture that was drawn with that.
fn words_of(game: &mut Game, drawn: Drawn) -> String {
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    let mut said = String::new();
    // A toast is laid out in one pass and seen in the next.
    for _ in 0..2 {
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(
                egui::Pos2::ZERO,
                egui::vec2(1280.0, 720.0),
            )),
            ..Default::default()
        };
        let output = context.run_pass(input, |context| {
            game.interface(context, Some((drawn, None)));
        });
        said.clear();
        for clipped in &output.shapes {
            gather(&clipped.shape, &mut said);
        }
    }
    said
}

#[test]
fn frame_figures_come_and_go_with_their_key_and_never_without() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let figures = "by frame";
    assert!(!words(&mut game).contains(figures));
    input(&mut game, Input::Key("F4"), true);
    let said = words(&mut game);
    assert!(
        said.contains(figures) && said.contains("gpu n/a") && said.contains("fast"),
        "{said}"
    );
    input(&mut game, Input::Key("F4"), true);
    assert!(!words(&mut game).contains(figures));
}

#[test]
fn the_map_key_is_answered_in_words_and_the_dial_appears() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    assert!(!words(&mut game).contains("Bend"));
    input(&mut game, Input::Key("KeyH"), true);
    let bends = |game: &Game| {
        let session = game.play.phase.session();
        session.is_some_and(|session| session.scene.lens().bend().is_some())
    };
    tick_until(&mut game, bends);
    let said = words(&mut game);
    assert!(
        said.contains("Bend, flat") && said.contains("bends the picture"),
        "{said}"
    );
    game.wheel(-1.0);
    input(&mut game, Input::Key("KeyH"), false);
    let turned = |game: &Game| {
        let session = game.play.phase.session();
        session.is_some_and(|session| session.scene.lens().bend() == Some(-1.0))
    };
    tick_until(&mut game, turned);
}
