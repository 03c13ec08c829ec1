//! Where and how a world begins that is made in New Game or by the command line.

use antipode_scene::Mode;
use antipode_ui::{GeometryChoice, ModeChoice};

use super::super::{Start, first_request};
use super::*;

/// Whether the player of a new world looks 15 degrees up to the land overhead, with a car and somebody there.
fn has_a_view(game: &mut Game) -> bool {
    tick_until(game, Game::is_playing);
    let scene = &game.play.phase.session().unwrap().scene;
    let up_deg = scene.head().pitch.to_degrees();
    (up_deg - 15.0).abs() < 0.1 && scene.cars().len() == 1 && !scene.bots().is_empty()
}

fn mode(game: &Game) -> Mode {
    game.play.phase.session().unwrap().scene.setup().mode
}

#[test]
fn a_world_made_in_new_game_begins_with_a_view() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = Game::new(worlds(dir.path()), None, None);
    game.follow(Intent::NewGame {
        name: "x".to_owned(),
        geometry: GeometryChoice::Spherical,
        seed: Some(5),
        radius_m: Some(100.0),
        mode: ModeChoice::Gathering,
    });
    assert!(has_a_view(&mut game));
    assert_eq!(mode(&game), Mode::Gathering);
    game.finish();
}

#[test]
fn a_world_made_by_the_command_line_begins_with_a_view_and_is_small_unless_told() {
    let dir = tempfile::tempdir().unwrap();
    let start = Start::New {
        geometry: Geometry::Spherical,
        seed: Some(5),
        name: Some("x".to_owned()),
        radius_m: None,
        mode: Mode::default(),
    };
    let first = first_request(start, &worlds(dir.path())).unwrap();
    let mut game = Game::new(worlds(dir.path()), None, first);
    assert!(has_a_view(&mut game));
    let radius_m = game.play.phase.session().unwrap().scene.setup().radius_m;
    assert_eq!(radius_m.to_bits(), 32.0_f64.to_bits());
    assert_eq!(mode(&game), Mode::Creative);
    game.finish();
}
