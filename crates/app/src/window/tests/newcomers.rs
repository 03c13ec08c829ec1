//! Hints for newcomers in the game: they come in the world, are remembered when done, and come again when asked for.

use antipode_settings::Value;

use super::super::phase::Next;
use super::*;

const KEY_N: Input = Input::Key("KeyN");

fn set_hints(game: &mut Game, on: bool) {
    let value = Value::Switch(on);
    game.follow(Intent::Set { id: "hints", value });
}

fn told(game: &Game) -> String {
    game.hint().map_or_else(String::new, |hint| hint.text)
}

#[test]
fn hints_skipped_to_the_end_are_switched_off_and_begin_anew_when_switched_on() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    assert!(told(&game).starts_with("Look"));
    // A flat world has no dial and no way round, and at first it is day: twelve hints, and the others in the first worlds
    // that have these.
    for _ in 0..12 {
        input(&mut game, KEY_N, true);
        input(&mut game, KEY_N, false);
        game.tick(Instant::now());
    }
    assert!(game.options.config.settings.hints && told(&game).is_empty());
    game.leave(Next::Open(Request::New(NewWorld {
        geometry: Geometry::Hyperbolic,
        name: Some("y".to_owned()),
        seed: Some(7),
        radius_m: None,
        generator: None,
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    })));
    tick_until(&mut game, |game| told(game).starts_with("Change how space"));
    input(&mut game, KEY_N, true);
    input(&mut game, KEY_N, false);
    game.leave(Next::Open(Request::New(NewWorld {
        geometry: Geometry::Spherical,
        name: Some("z".to_owned()),
        seed: Some(7),
        radius_m: Some(16.0),
        generator: None,
        mode: antipode_scene::Mode::Gathering,
        start: Beginning::Middle,
    })));
    for words in ["Look up", "You build with", "Walk straight on"] {
        tick_until(&mut game, |game| told(game).starts_with(words));
        input(&mut game, KEY_N, true);
        input(&mut game, KEY_N, false);
    }
    game.tick(Instant::now());
    assert!(game.options.config.settings.hints && told(&game).is_empty());
    game.leave(Next::Open(Request::New(NewWorld {
        geometry: Geometry::HyperbolicWorld,
        name: Some("s".to_owned()),
        seed: Some(7),
        radius_m: None,
        generator: None,
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    })));
    tick_until(&mut game, |game| told(game).starts_with("Five squares"));
    input(&mut game, KEY_N, true);
    input(&mut game, KEY_N, false);
    let session = game.play.phase.session_mut().unwrap();
    session.scene.set_time_of_day_s(450.0);
    tick_until(&mut game, |game| told(game).starts_with("It is dark"));
    input(&mut game, KEY_N, true);
    game.tick(Instant::now());
    assert!(!game.options.config.settings.hints && told(&game).is_empty());
    set_hints(&mut game, true);
    tick_until(&mut game, |game| told(game).starts_with("Look"));
}

#[test]
fn opening_the_menu_is_remembered_though_it_is_told_last() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    input(&mut game, Input::Key("Escape"), true);
    game.tick(Instant::now());
    game.follow(Intent::Resume);
    for _ in 0..11 {
        input(&mut game, KEY_N, true);
        game.tick(Instant::now());
    }
    let learnt = &game.options.config.learnt;
    assert_eq!(learnt.len(), 12, "the last is done already: {learnt:?}");
    assert!(told(&game).is_empty());
}

#[test]
fn what_was_learnt_in_one_run_is_not_told_in_the_next() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("settings.ron");
    let common = worlds_options(dir.path());
    let begin = |game: &mut Game| {
        game.begin_with(antipode_settings::open(Some(file.clone())), &common);
    };
    let mut game = begun(&dir);
    begin(&mut game);
    tick_until(&mut game, Game::is_playing);
    for _ in 0..2 {
        input(&mut game, KEY_N, true);
        game.tick(Instant::now());
    }
    game.finish();
    drop(game);
    let mut game = Game::new(
        worlds(dir.path()),
        None,
        Some(Request::Load("x".to_owned())),
    );
    begin(&mut game);
    tick_until(&mut game, |game| told(game).starts_with("Jump"));
    // Switched off and on they begin anew, for later runs too.
    set_hints(&mut game, false);
    game.tick(Instant::now());
    assert!(game.options.config.learnt.is_empty());
    set_hints(&mut game, true);
    tick_until(&mut game, |game| told(game).starts_with("Look"));
    game.finish();
}

#[test]
fn no_world_flies_behind_a_menu_with_less_motion_or_while_one_is_played() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = Game::new(worlds(dir.path()), None, None);
    game.backdrop.enable(true);
    tick_until(&mut game, |game| game.backdrop.model().live);
    assert!(game.frame(1.5, 400).is_some() && !game.is_still());
    let value = Value::Switch(true);
    game.follow(Intent::Set {
        id: "reduced-motion",
        value,
    });
    game.tick(Instant::now());
    assert!(game.frame(1.5, 400).is_none() && !game.backdrop.model().live);
    tick_until(&mut game, Game::is_still);
    let value = Value::Switch(false);
    game.follow(Intent::Set {
        id: "reduced-motion",
        value,
    });
    tick_until(&mut game, |game| game.backdrop.model().live);
    let request = Request::New(NewWorld {
        geometry: Geometry::Euclidean,
        name: Some("x".to_owned()),
        seed: Some(7),
        radius_m: None,
        generator: None,
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    });
    game.play.open(request, &mut game.menus);
    game.tick(Instant::now());
    assert!(!game.backdrop.model().live, "it makes way at once");
    tick_until(&mut game, Game::is_playing);
    assert_eq!(
        worlds(dir.path()).list().unwrap().len(),
        1,
        "the flights leave nothing on disk"
    );
}
