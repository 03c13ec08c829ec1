//! The game without a window: worlds that cannot be saved, loading without the keyboard, ends.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use antipode_geometry::Geometry;
use antipode_ui::{Intent, Screen};
use clap::Parser;
use tempfile::TempDir;

use super::game::Game;
use super::phase::{Phase, Request};
use crate::bindings::Input;
use crate::cli::Cli;
use crate::session::{NewWorld, Worlds};

fn worlds(dir: &Path) -> Worlds {
    let path = dir.to_str().unwrap();
    let cli = Cli::try_parse_from(["antipode", "--saves-dir", path, "--view-distance", "1"]);
    Worlds::new(&cli.unwrap().common)
}

/// A game that begins in a new world called x.
fn begun(dir: &TempDir) -> Game {
    let request = Request::New(NewWorld {
        geometry: Geometry::Euclidean,
        name: Some("x".to_owned()),
        seed: Some(7),
        radius_m: None,
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
    for _ in 0..1_000_000 {
        if there(game) {
            return;
        }
        game.tick(Instant::now());
        std::thread::yield_now();
    }
    panic!("the game never got there: {:?}", game.phase);
}

fn is_paused(game: &Game) -> bool {
    matches!(game.phase, Phase::Paused(_))
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
    assert!(matches!(game.shell.screen(), Screen::Unsaved { .. }));
    fs::rename(aside, home).unwrap();
    game.follow(Intent::TrySavingAgain);
    tick_until(&mut game, |game| matches!(game.phase, Phase::Menu));
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
    assert_eq!(game.last_words(), None);
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
    assert!(!matches!(game.shell.screen(), Screen::Unsaved { .. }));
    fs::rename(aside, home).unwrap();
    game.finish();
    assert_eq!(game.last_words(), None);
}

#[test]
fn where_nothing_can_be_shown_the_game_ends_with_what_it_could_not_save() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    take_away(&dir);
    game.end_unseen();
    tick_until(&mut game, Game::is_over);
    assert!(game.last_words().is_some());
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
    assert_eq!(game.shell.screen(), &Screen::Main);
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
    game.input(Input::Key(winit::keyboard::KeyCode::Escape), true);
    tick_until(&mut game, is_saved);
    let (aside, home) = take_away(&dir);
    game.follow(Intent::Save);
    tick_until(&mut game, |game| !game.saving);
    assert!(!is_saved(&game));
    fs::rename(aside, home).unwrap();
    game.follow(Intent::Save);
    tick_until(&mut game, |game| !game.saving);
    assert!(is_saved(&game));
    game.finish();
}

fn is_saved(game: &Game) -> bool {
    game.phase
        .session()
        .is_some_and(|session| session.scene.is_saved())
}
