//! A game that stands still, is slow, sleeps, or is closed while its picture is drawn.

use std::time::Duration;

use antipode_settings::MouseButton;
use image::RgbaImage;

use super::super::phase::Next;
use super::super::veil::Veil;
use super::*;

#[test]
fn a_paused_world_stands_still_once_its_land_is_there_and_no_sooner() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    assert!(!game.is_still());
    input(&mut game, Input::Key("Escape"), true);
    assert!(!game.is_still(), "its picture is still to be taken");
    assert!(std::mem::take(&mut game.play.portrait.is_wanted));
    tick_until(&mut game, Game::is_still);
    assert!(game.menus.shell.take_changed());
    game.tick(Instant::now());
    assert!(!game.menus.shell.take_changed());
    game.follow(Intent::Save);
    assert!(!game.is_still(), "somebody waits for an answer");
    tick_until(&mut game, Game::is_still);
    assert!(game.menus.shell.take_changed(), "the answer is to be seen");
    game.follow(Intent::Resume);
    assert!(!game.is_still());
    game.finish();
}

#[test]
fn a_veil_that_has_begun_to_lift_is_gone_behind_the_menu_too() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    game.play.veil = Veil::Lifting(1.0);
    input(&mut game, Input::Key("Escape"), true);
    assert!(is_paused(&game) && !game.is_still());
    tick_until(&mut game, |game| game.play.veil == Veil::Up);
    assert!(is_paused(&game));
    // Ground that is missing farther off is no reason to hide the world again.
    game.follow(Intent::Resume);
    assert!(game.is_playing());
    game.play.veil = Veil::Lifting(1.0);
    game.leave(Next::Menu);
    tick_until(&mut game, |game| matches!(game.play.phase, Phase::Menu));
    game.tick(Instant::now());
    assert_eq!(
        game.play.veil,
        Veil::Up,
        "the picture behind the menu is bright"
    );
    game.finish();
}

#[test]
fn a_slow_frame_is_at_most_six_steps_and_the_figures_tell_what_was_left_out() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let simulated = |game: &Game| game.play.phase.session().unwrap().scene.simulated_s();
    let mut now = Instant::now() + Duration::from_secs(1);
    game.tick(now);
    let before = simulated(&game);
    input(&mut game, Input::Key("F4"), true);
    now += Duration::from_millis(2_600);
    game.tick(now);
    let steps = (simulated(&game) - before) * 60.0;
    assert!((5.9..6.1).contains(&steps), "{steps}");
    let dropped_s = game.play.pace.dropped_s();
    assert!(dropped_s > 2.4, "{dropped_s}");
    let said = words(&mut game);
    assert!(
        said.contains(&format!("{dropped_s:.1} s of time")),
        "{said}"
    );
    game.finish();
}

#[test]
fn hours_between_two_frames_are_no_time_of_the_world() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let times = |game: &Game| {
        let scene = &game.play.phase.session().unwrap().scene;
        (scene.simulated_s(), scene.time_of_day_s())
    };
    let mut now = Instant::now() + Duration::from_secs(1);
    game.tick(now);
    let before = times(&game);
    let dropped_s = game.play.pace.dropped_s();
    now += Duration::from_hours(11);
    game.tick(now);
    assert_eq!(times(&game), before);
    assert_eq!(game.play.pace.dropped_s(), dropped_s);
    for _ in 0..60 {
        now += Duration::from_micros(16_667);
        game.tick(now);
    }
    let passed = times(&game).0 - before.0;
    assert!((0.9..1.1).contains(&passed), "{passed}");
    game.finish();
}

/// The world's picture as it lies on disk.
fn picture_of(dir: &TempDir) -> Option<image::RgbImage> {
    let listed = worlds(dir.path()).list().unwrap();
    let path = listed[0].thumbnail.clone()?;
    Some(image::open(path).unwrap().to_rgb8())
}

#[test]
fn a_world_that_is_closed_says_so_at_once_and_gets_its_last_picture_later() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let world = game.play.portrait.expect(game.play.opened);
    game.close_window();
    assert!(matches!(game.menus.shell.screen(), Screen::Busy { .. }));
    assert!(matches!(game.play.phase, Phase::Closing(..)));
    let red = image::Rgba([200, 30, 40, 255]);
    game.play
        .keep_picture(world, RgbaImage::from_pixel(4, 4, red));
    tick_until(&mut game, Game::is_over);
    assert_eq!(game.play.last_words, None);
    let kept = picture_of(&dir).unwrap();
    assert_eq!(kept.get_pixel(1, 1).0, [200, 30, 40]);
}

#[test]
fn a_world_that_is_closed_does_without_a_picture_that_never_comes() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    game.play.portrait.expect(game.play.opened);
    game.close_window();
    game.play.portrait.miss();
    tick_until(&mut game, Game::is_over);
    worlds(dir.path()).load("x").unwrap().close().unwrap();
}

#[test]
fn closing_the_window_while_a_world_is_opened_says_that_it_is_saved() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = begun(&dir);
    game.close_window();
    let Screen::Busy { title, .. } = game.menus.shell.screen() else {
        panic!("{:?}", game.menus.shell.screen());
    };
    assert_eq!(*title, game.menus.texts.say("busy-saving"));
    tick_until(&mut game, Game::is_over);
    worlds(dir.path()).load("x").unwrap().close().unwrap();
}

#[test]
fn a_new_world_is_covered_until_a_picture_has_all_of_its_land() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = begun(&dir);
    let is_made = |game: &Game| match &game.play.phase {
        Phase::Loading(session) => session.scene.loading_progress() >= 1.0,
        _ => false,
    };
    // A deadline for what hangs, on however busy a machine.
    let began = Instant::now();
    while !is_made(&game) && began.elapsed() < Duration::from_mins(2) {
        game.tick(Instant::now());
        game.play.drawn(true);
    }
    // The land is made; some of it is not in the pictures yet.
    game.play.veil = Veil::Down;
    for _ in 0..50 {
        game.play.drawn(false);
        game.tick(Instant::now());
        assert!(is_made(&game), "{:?}", game.play.phase);
    }
    game.play.drawn(true);
    game.tick(Instant::now());
    assert!(game.is_playing(), "{:?}", game.play.phase);
}

#[test]
fn a_lamp_is_put_down_and_taken_up_at_five_frames_a_second_also_between_two_of_them() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    let mut now = Instant::now() + Duration::from_secs(1);
    game.tick(now);
    let scene = &mut game.play.phase.session_mut().unwrap().scene;
    scene.inventory_mut().select(5);
    scene.aim(0.0, -1.0);
    // What is clicked before a frame, and the lamps that stand and that are left after it.
    let (left, right) = (MouseButton::Left, MouseButton::Right);
    for (clicks, standing, carried) in [
        (&[left][..], 1, 9),
        (&[right], 0, 10),
        (&[left, right], 0, 10),
        (&[left], 1, 9),
        (&[right, left], 1, 9),
    ] {
        for button in clicks {
            input(&mut game, Input::Mouse(*button), true);
            input(&mut game, Input::Mouse(*button), false);
        }
        now += Duration::from_millis(200);
        game.tick(now);
        let scene = &game.play.phase.session().unwrap().scene;
        let kept = scene.inventory().slots()[5].map(|stack| stack.count);
        assert_eq!(
            (scene.lamps().len(), kept),
            (standing, Some(carried)),
            "{clicks:?}"
        );
    }
    game.finish();
}
