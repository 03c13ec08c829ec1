//! What the player can look at besides the world itself: hit boxes, compass and map, and how bullets fly, by settings.

use antipode_settings::{Value, open, read};

use super::super::portrait::portrait_of;
use super::*;

fn set(game: &mut Game, id: &'static str, on: bool) {
    let value = Value::Switch(on);
    game.follow(Intent::Set { id, value });
}

#[test]
fn hit_boxes_come_and_go_with_their_key() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let scene = &mut game.play.phase.session_mut().unwrap().scene;
    let lamp = scene.feet().moved(glam::DVec3::X);
    assert!(scene.spawn_lamp(lamp));
    let shapes = |game: &mut Game| game.frame(1.5, 400).unwrap().content.hit_shapes.len();
    assert_eq!(shapes(&mut game), 0);
    input(&mut game, Input::Key("F3"), true);
    assert_eq!(shapes(&mut game), 1);
    input(&mut game, Input::Key("F3"), true);
    assert_eq!(shapes(&mut game), 0);
}

#[test]
fn the_menus_picture_shows_the_world_and_nothing_of_the_display() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let scene = &mut game.play.phase.session_mut().unwrap().scene;
    assert!(scene.spawn_lamp(scene.feet().moved(glam::DVec3::X)));
    // In hand it shows where it would hang.
    scene.inventory_mut().select(5);
    scene.aim(0.0, -1.2);
    input(&mut game, Input::Key("F3"), true);
    let seen = game.frame(1.5, 400).unwrap();
    assert!(
        seen.view.hand.is_some()
            && seen.content.marker.is_some()
            && !seen.content.hit_shapes.is_empty()
    );
    let picture = portrait_of(&seen);
    assert!(picture.hand.is_none() && !picture.shows_marks);
    let tangent = |sx: f64, sy: f64| sy / sx;
    assert_eq!(
        tangent(picture.projection.sx, picture.projection.sy),
        16.0 / 9.0
    );
    assert_eq!(picture.eye, seen.view.eye);
}

/// Whether the land of the map is painted: there is no other shape of so many corners.
fn shows_map(game: &mut Game) -> bool {
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    let input = egui::RawInput {
        screen_rect: Some(egui::Rect::from_min_size(
            egui::Pos2::ZERO,
            egui::vec2(1280.0, 720.0),
        )),
        ..Default::default()
    };
    let output = context.run_pass(input, |context| game.interface(context, None));
    let many =
        |shape: &egui::Shape| matches!(shape, egui::Shape::Mesh(mesh) if mesh.vertices.len() > 100);
    output.shapes.iter().any(|clipped| many(&clipped.shape))
}

#[test]
fn compass_and_map_are_there_until_they_are_switched_off() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    // A quarter of the horizon has at least one letter on the strip.
    let letters = |game: &mut Game| {
        let said = words(game);
        let of = |letter: &str| said.lines().filter(|line| *line == letter).count();
        ["N", "E", "S", "W"].map(of).iter().sum::<usize>()
    };
    assert!(letters(&mut game) >= 2, "one on the strip, one on the map");
    assert!(shows_map(&mut game));
    set(&mut game, "minimap", false);
    assert!(!shows_map(&mut game) && letters(&mut game) >= 1);
    set(&mut game, "compass", false);
    assert_eq!(letters(&mut game), 0);
    game.follow(Intent::ResetSetting("minimap"));
    assert!(shows_map(&mut game));
}

#[test]
fn straight_shots_reach_the_world_at_once_and_are_kept() {
    let (dir, own) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let file = own.path().join("settings.ron");
    let cli = Cli::try_parse_from(["antipode"]).unwrap();
    let mut game = playing(&dir);
    game.begin_with(open(Some(file.clone())), &cli.common);
    let straight = |game: &Game| game.play.phase.session().unwrap().scene.straight_shots();
    assert!(!straight(&game), "bullets fall unless asked");
    set(&mut game, "straight-shots", true);
    assert!(straight(&game));
    game.follow(Intent::ResetSetting("straight-shots"));
    assert!(!straight(&game));
    set(&mut game, "straight-shots", true);
    game.finish();
    // The file is written when the last word of it is said.
    drop(game);
    let kept = read(&fs::read(file).unwrap()).config;
    assert!(kept.settings.straight_shots);
}
