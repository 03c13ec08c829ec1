//! The clock in a closed world: of the place, in the display and in the photo mode.

use antipode_geometry::{ChartId, ChartPoint};
use glam::DVec3;

use super::*;

/// A closed world that is noon at its middle, the player over the far side of it.
fn over_the_far_side(dir: &TempDir) -> Game {
    let request = Request::New(NewWorld {
        geometry: Geometry::Spherical,
        name: Some("x".to_owned()),
        seed: Some(7),
        radius_m: Some(16.0),
        generator: None,
        mode: antipode_scene::Mode::default(),
        start: Beginning::Middle,
    });
    let mut game = Game::new(worlds(dir.path()), None, Some(request));
    tick_until(&mut game, Game::is_playing);
    let scene = &mut game.play.phase.session_mut().unwrap().scene;
    scene.set_flying(true);
    scene.teleport(ChartPoint::new(ChartId::SECOND, DVec3::new(0.5, 8.0, 0.0)));
    scene.set_time_of_day_s(150.0);
    game
}

/// The clocks that are written, without the minutes.
fn hours(game: &mut Game) -> Vec<String> {
    let said = words(game);
    let clocks = said.lines().filter_map(|line| {
        let clock = line.split_whitespace().find(|word| {
            let digits = |part: &str| part.len() == 2 && part.bytes().all(|b| b.is_ascii_digit());
            word.split_once(':')
                .is_some_and(|(h, m)| digits(h) && digits(m))
        })?;
        clock.split(':').next().map(str::to_owned)
    });
    clocks.collect()
}

#[test]
fn at_noon_of_one_side_the_display_and_the_photo_mode_tell_midnight_on_the_other() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = over_the_far_side(&dir);
    assert_eq!(hours(&mut game), ["00"]);
    input(&mut game, Input::Key("KeyP"), true);
    assert!(game.overlays.is_photographing());
    assert_eq!(hours(&mut game), ["00"]);
}
