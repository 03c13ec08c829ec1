//! The photo mode and screenshots in a running world, without an adapter.

use antipode_geometry::ChartId;
use antipode_render::RenderError;
use image::{Rgba, RgbaImage};

use winit::keyboard::KeyCode;

use super::super::press::Down;
use super::*;
use crate::screenshots::Album;

const PHOTO: Input = Input::Key("KeyP");

fn photographing(dir: &TempDir) -> Game {
    let mut game = playing(dir);
    game.begin_in("test", Album::at(dir.path().join("pictures")), None);
    game.overlays.photo.set_canvas((640, 360), 1280);
    input(&mut game, PHOTO, true);
    assert!(game.overlays.is_photographing() && !game.is_playing());
    game
}

fn pictures(dir: &TempDir) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(dir.path().join("pictures")) else {
        return Vec::new();
    };
    entries.map(|entry| entry.unwrap().path()).collect()
}

/// Ticks for a while by a clock of its own: a 60th of a second each.
fn ticks(game: &mut Game, from: Instant, count: u32) -> Instant {
    let mut now = from;
    for _ in 0..count {
        now += Duration::from_micros(16_667);
        game.tick(now);
    }
    now
}

#[test]
fn the_world_stands_still_while_the_camera_flies_and_all_is_as_it_was_afterwards() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = photographing(&dir);
    let scene = |game: &Game| {
        let scene = &game.play.phase.session().unwrap().scene;
        (
            scene.simulated_s(),
            scene.feet(),
            scene.time_of_day_s(),
            scene.lens().value(),
            scene.eye(),
        )
    };
    let before = scene(&game);
    let first = game.frame(1.5, 360).unwrap();
    assert!(take_key(&mut game, Input::Key("KeyW"), true, false));
    let now = ticks(&mut game, Instant::now(), 60);
    let flown = game.frame(1.5, 360).unwrap();
    let way_m = flown.view.eye.point.pos.distance(first.view.eye.point.pos);
    assert!((4.0..8.0).contains(&way_m), "flew {way_m} m");
    assert!(
        !take_key(&mut game, Input::Key("ArrowDown"), true, false),
        "the arrows are the panel's"
    );
    ticks(&mut game, now, 1);
    assert_eq!(scene(&game), before);
    assert!(take_key(&mut game, PHOTO, true, false));
    assert!(game.is_playing());
    let after = game.frame(1.5, 360).unwrap();
    assert_eq!(
        (after.view.eye, after.view.projection),
        (first.view.eye, first.view.projection)
    );
    assert_eq!(after.content.sky, first.content.sky);
    input(&mut game, PHOTO, true);
    assert!(take_key(&mut game, Input::Key("Escape"), true, false) && game.is_playing());
}

#[test]
fn the_panel_names_what_can_be_changed_and_the_display_gives_way_to_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = photographing(&dir);
    let said = words(&mut game);
    for name in [
        "Photo mode",
        "Field of view",
        "Time of day",
        "Hide figures",
        "Grid of thirds",
    ] {
        assert!(said.contains(name), "{name} in {said}");
    }
    assert!(
        said.contains("1280 × 720") && !said.contains("1920"),
        "{said}"
    );
    assert!(
        !said.contains("Curvature") && !said.contains("chart"),
        "{said}"
    );
    game.shots.want_of(&game.play.phase);
    assert!(
        !words(&mut game).contains("Photo mode"),
        "the panel is in the picture"
    );
}

#[test]
fn a_picture_is_made_tile_by_tile_and_kept_whole() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = photographing(&dir);
    game.overlays.photo.set_canvas((8, 6), 8192);
    game.overlays.photo.begin_of(&mut game.play, 2);
    for shade in 0..4 {
        let (_, tile, size) = game.overlays.photo.next_tile().unwrap();
        assert_eq!(tile.corner, (shade % 2 * 8, shade / 2 * 6));
        assert!(
            game.overlays.photo.next_tile().is_none(),
            "one tile at a time"
        );
        let colour = Rgba([shade as u8, 0, 0, 255]);
        let tile = RgbaImage::from_pixel(size.0, size.1, colour);
        let photo = &mut game.overlays.photo;
        photo.keep_tile(Ok(tile), &mut game.shots, &mut game.menus);
    }
    tick_until(&mut game, |_| pictures(&dir).len() == 1);
    game.finish();
    let picture = image::open(&pictures(&dir)[0]).unwrap().to_rgba8();
    assert_eq!(picture.dimensions(), (16, 12));
    for (x, y, shade) in [(0, 0, 0), (15, 5, 1), (7, 6, 2), (8, 11, 3)] {
        assert_eq!(picture.get_pixel(x, y).0[0], shade);
    }
}

#[test]
fn a_screenshot_is_kept_and_told_and_a_failure_is_told_too() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    game.begin_in("test", Album::at(dir.path().join("pictures")), None);
    input(&mut game, Input::Key("F12"), true);
    words(&mut game);
    assert!(game.shots.begin() && !game.shots.begin());
    game.shots.keep(Ok(RgbaImage::new(4, 3)), &mut game.menus);
    tick_until(&mut game, |game| game.shots.is_idle());
    let said = words(&mut game);
    assert!(
        said.contains("Picture kept as") && said.contains("x 20"),
        "{said}"
    );
    game.shots.want_of(&game.play.phase);
    words(&mut game);
    assert!(game.shots.begin());
    let error = RenderError::Readback("no memory".to_owned());
    game.shots.keep(Err(error), &mut game.menus);
    assert!(words(&mut game).contains("no memory"));
    assert_eq!(pictures(&dir).len(), 1);
}

#[test]
fn the_camera_crosses_the_equator_of_a_closed_world() {
    let dir = tempfile::tempdir().unwrap();
    let request = Request::New(NewWorld {
        geometry: Geometry::Spherical,
        name: Some("ball".to_owned()),
        seed: Some(7),
        radius_m: Some(16.0),
        generator: Some(antipode_scene::Generator::OneBiome),
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    });
    let mut game = Game::new(worlds(dir.path()), None, Some(request));
    tick_until(&mut game, Game::is_playing);
    game.overlays.photo.set_canvas((640, 360), 1280);
    input(&mut game, PHOTO, true);
    take_key(&mut game, Input::Key("KeyW"), true, false);
    take_key(&mut game, Input::Key("ShiftLeft"), true, false);
    let mut now = Instant::now();
    let mut last = game.frame(1.5, 360).unwrap();
    let mut crossed = false;
    for _ in 0..300 {
        now = ticks(&mut game, now, 1);
        let frame = game.frame(1.5, 360).unwrap();
        let eye = &last.view.eye;
        let step_m = frame
            .view
            .strategy
            .distance_m(eye.point, frame.view.eye.point, eye);
        assert!(step_m < 1.0, "leapt {step_m} m");
        crossed |= frame.view.eye.point.chart == ChartId::SECOND;
        last = frame;
    }
    assert!(crossed);
}

#[test]
fn turning_to_another_window_leaves_the_photo_as_it_was_composed() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = photographing(&dir);
    game.focus(true);
    game.focus(false);
    game.focus(true);
    assert!(game.overlays.is_photographing(), "{:?}", game.play.phase);
    assert!(take_key(&mut game, Input::Key("Escape"), true, false));
    assert!(game.is_playing(), "one Esc leaves the photo mode only");
    game.finish();
}

#[test]
fn an_escape_that_is_held_leaves_the_photo_mode_and_no_more() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = photographing(&dir);
    let mut down = Down::default();
    // As a window that gets the keyboard while the key is held is told of it: twice, and not as repeated.
    for _ in 0..2 {
        let repeats = down.repeats(KeyCode::Escape, true, false);
        if !take_key(&mut game, Input::Key("Escape"), true, repeats) && !repeats {
            input(&mut game, Input::Key("Escape"), true);
        }
    }
    assert!(game.is_playing(), "{:?}", game.play.phase);
    game.finish();
}
