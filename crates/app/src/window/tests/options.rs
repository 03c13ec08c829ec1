//! Settings in the game: what is changed holds at once, and is kept.

use antipode_language::Language;
use antipode_settings::{Action, Value, open, read};

use super::*;

fn set(game: &mut Game, id: &'static str, value: Value) {
    game.follow(Intent::Set { id, value });
}

#[test]
fn a_changed_setting_reaches_world_texts_controls_and_file_at_once() {
    let (dir, own) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let file = own.path().join("settings.ron");
    let cli = Cli::try_parse_from(["antipode", "--view-distance", "1", "--quality", "exact"]);
    let mut game = playing(&dir);
    game.begin_with(open(Some(file.clone())), &cli.unwrap().common);
    let scene = |game: &Game| {
        let scene = &game.play.phase.session().unwrap().scene;
        (scene.viewing(), scene.view_distance(), scene.quality())
    };
    let (viewing, distance, quality) = scene(&game);
    assert_eq!(
        (distance, quality),
        (1, Quality::Exact),
        "the command line holds"
    );
    assert!(!viewing.contour_bands && !viewing.reduced_motion);
    set(&mut game, "field-of-view", Value::Number(90.0));
    set(&mut game, "contour-bands", Value::Switch(true));
    set(&mut game, "reduced-motion", Value::Switch(true));
    set(&mut game, "view-distance", Value::Number(2.0));
    set(&mut game, "language", Value::Choice("pl"));
    let (viewing, distance, quality) = scene(&game);
    assert!((viewing.fov_y_rad.to_degrees() - 90.0).abs() < 1e-9);
    assert!(viewing.contour_bands && viewing.reduced_motion);
    assert_eq!(
        (distance, quality),
        (2, Quality::Exact),
        "only what was changed gives way"
    );
    assert_eq!(game.menus.texts.language(), Language::Polish);
    game.follow(Intent::ResetSetting("contour-bands"));
    assert!(!scene(&game).0.contour_bands);
    let mut profiles = game.options.config.profiles.clone();
    let key = Input::Key("KeyI");
    profiles
        .chosen_mut()
        .bind(Action::HideDisplay, key)
        .unwrap();
    game.follow(Intent::Bind(Box::new(profiles)));
    assert!(words(&mut game).contains("08:2"), "the clock is shown");
    input(&mut game, key, true);
    assert!(
        !words(&mut game).contains("08:2"),
        "the new key hides the display"
    );
    let config = game.options.config.clone();
    game.finish();
    drop(game);
    assert_eq!(read(&fs::read(file).unwrap()).config, config);
}

#[test]
fn what_is_wrong_with_the_file_is_told_and_the_game_goes_on() {
    let (dir, own) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let file = own.path().join("settings.ron");
    fs::write(&file, "\"field-of-view\": 90,\nnonsense").unwrap();
    let cli = Cli::try_parse_from(["antipode"]).unwrap();
    let mut game = playing(&dir);
    game.begin_with(open(Some(file)), &cli.common);
    assert!(words(&mut game).contains("settings file was damaged"));
    assert_eq!(game.options.config.settings.field_of_view_deg, 90.0);
    game.finish();
}
