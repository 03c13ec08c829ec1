//! Rooms in the window, without a window: entered, played, paused, left, copied.

use antipode_rays::View;
use antipode_room_scene::{RoomScene, ThingKind};
use antipode_settings::{MouseButton, Value};
use antipode_ui::WorldsIntent;
use image::RgbaImage;

use super::super::portrait::PortraitView;
use super::*;
use crate::script::{obey, parse_line};

/// Lets the background work until the room is there, and says that its picture is.
fn enter(game: &mut Game, slug: &str) {
    game.follow(Intent::EnterRoom {
        slug: slug.to_owned(),
    });
    tick_until(game, |game| game.play.phase.visit().is_some());
    game.play.room_drawn(&mut game.menus, false);
}

fn in_menu(dir: &TempDir) -> Game {
    Game::new(worlds(&dir.path().join("saves")), None, None)
}

fn scene(game: &Game) -> &RoomScene {
    game.play.phase.visit().unwrap().scene()
}

/// Lets frames of that many milliseconds pass.
fn pass(game: &mut Game, now: &mut Instant, frames: u32) {
    for _ in 0..frames {
        *now += Duration::from_millis(20);
        game.tick(*now);
    }
}

#[test]
fn a_room_is_walked_through_paused_and_left_without_a_question() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    game.follow(Intent::EnterRoom {
        slug: "game:long-house".to_owned(),
    });
    tick_until(&mut game, |game| game.play.phase.visit().is_some());
    assert!(!game.is_playing(), "there is no picture yet");
    assert!(matches!(game.menus.shell.screen(), Screen::Busy { .. }));
    game.play.room_drawn(&mut game.menus, false);
    assert!(game.is_playing() && !game.menus.shell.is_open());
    let began = scene(&game).feet();
    let mut now = Instant::now();
    pass(&mut game, &mut now, 5);
    input(&mut game, Input::Key("KeyW"), true);
    pass(&mut game, &mut now, 50);
    let walked = scene(&game).feet().distance(began);
    assert!(walked > 2.0, "{walked} m");
    input(&mut game, Input::Key("Escape"), true);
    assert!(game.play.phase.is_paused());
    tick_until(&mut game, Game::is_still);
    now = Instant::now();
    let stood = scene(&game).feet();
    pass(&mut game, &mut now, 20);
    assert_eq!(scene(&game).feet(), stood, "it stands still");
    game.follow(Intent::Resume);
    assert!(game.is_playing());
    game.follow(Intent::SaveAndQuitToMenu);
    assert!(matches!(game.play.phase, Phase::Menu));
}

#[test]
fn a_room_begins_anew_each_time() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:big-house");
    let began = scene(&game).feet();
    let mut now = Instant::now();
    input(&mut game, Input::Key("KeyW"), true);
    pass(&mut game, &mut now, 60);
    assert!(scene(&game).feet() != began);
    enter(&mut game, "game:big-house");
    assert_eq!(scene(&game).feet(), began);
}

#[test]
fn a_room_of_the_game_is_copied_renamed_and_deleted_from_the_list() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    let idle = |game: &Game| game.menus.are_lists_idle();
    tick_until(&mut game, idle);
    let shipped = game.menus.rooms.known().len();
    let slug = "game:long-house".to_owned();
    game.follow(Intent::Rooms(WorldsIntent::Duplicate { slug }));
    tick_until(&mut game, idle);
    let own = |game: &Game| {
        let rows = game.menus.rooms.rows(&game.menus.texts, None);
        let own = rows.into_iter().filter(|row| !row.shipped);
        own.map(|row| (row.slug, row.name)).collect::<Vec<_>>()
    };
    let made = own(&game);
    assert_eq!(made.len(), 1);
    let slug = made[0].0.clone();
    game.follow(Intent::Rooms(WorldsIntent::Rename {
        slug: slug.clone(),
        name: "Mine".to_owned(),
    }));
    tick_until(&mut game, idle);
    assert_eq!(own(&game), [(slug.clone(), "Mine".to_owned())]);
    enter(&mut game, &slug);
    assert_eq!(scene(&game).room().name, "Mine");
    game.leave(super::super::phase::Next::Menu);
    game.follow(Intent::DeleteRoom { slug });
    tick_until(&mut game, idle);
    assert_eq!(game.menus.rooms.known().len(), shipped);
}

#[test]
fn a_new_room_is_kept_under_a_name_that_nobody_has() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    for name in ["Room 1", "Room 2"] {
        game.follow(Intent::NewRoom);
        tick_until(&mut game, |game| {
            let visit = game.play.phase.visit();
            visit.is_some_and(|visit| visit.scene().room().name == name)
        });
    }
    game.leave(super::super::phase::Next::Menu);
    tick_until(&mut game, |game| game.menus.are_lists_idle());
    let names = game.menus.rooms.names();
    assert!(names.contains(&"Room 1".to_owned()) && names.contains(&"Room 2".to_owned()));
}

#[test]
fn a_room_that_is_gone_or_broken_is_told_in_the_menu() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    game.follow(Intent::EnterRoom {
        slug: "nowhere".to_owned(),
    });
    tick_until(&mut game, |game| matches!(game.play.phase, Phase::Menu));
    assert!(matches!(game.menus.shell.screen(), Screen::Message { .. }));
    let broken = game.play.worlds.rooms().path().join("broken");
    fs::create_dir_all(&broken).unwrap();
    fs::write(broken.join("room.ron"), "(version: 1, nome: \"x\")").unwrap();
    game.menus.open_main();
    tick_until(&mut game, |game| game.menus.are_lists_idle());
    let rows = game.menus.rooms.rows(&game.menus.texts, None);
    let row = rows.iter().find(|row| row.slug == "broken").unwrap();
    assert!(
        row.problem
            .as_ref()
            .is_some_and(|said| said.contains("room.ron:1"))
    );
    enter_refused(&mut game, "broken");
}

fn enter_refused(game: &mut Game, slug: &str) {
    game.follow(Intent::EnterRoom {
        slug: slug.to_owned(),
    });
    tick_until(game, |game| matches!(game.play.phase, Phase::Menu));
    match game.menus.shell.screen() {
        Screen::Message { text, .. } => assert!(text.contains("room.ron"), "{text}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_for_worlds_does_nothing_in_a_room() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:twelve-rooms");
    for key in ["KeyE", "KeyP", "F3", "F4", "KeyN"] {
        input(&mut game, Input::Key(key), true);
        input(&mut game, Input::Key(key), false);
        assert!(game.is_playing(), "{key}");
    }
    game.tick(Instant::now());
    assert!(game.hint().is_none());
    game.focus(true);
    game.focus(false);
    assert!(game.play.phase.is_paused());
}

#[test]
fn the_console_leads_from_room_to_room_and_refuses_what_is_for_worlds() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:twelve-rooms");
    let mut order = |line: &str| {
        let order = parse_line(line).unwrap().unwrap();
        obey(&mut game, &order)
    };
    order("aim 30 10").unwrap();
    order("probe").unwrap();
    let refused = order("give lamp 1").unwrap_err().to_string();
    assert!(refused.contains("is for worlds"), "{refused}");
    assert_eq!(scene(&game).probe().player.yaw.round(), 30.0);
    game.enter("room load \"Nested boxes\"");
    tick_until(&mut game, |game| {
        let visit = game.play.phase.visit();
        visit.is_some_and(|visit| visit.scene().room().name == "Nested boxes")
    });
}

#[test]
fn keys_shoot_throw_turn_the_view_and_change_the_way_to_look() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:four-tunnels");
    let mut now = Instant::now();
    pass(&mut game, &mut now, 20);
    let view = |game: &mut Game| game.room_view(1.5).unwrap();
    let before = view(&mut game);
    assert!(before.moment.figure.unseen_by_eye);
    for (key, look) in [
        ("KeyH", View::Split),
        ("KeyH", View::Thesis),
        ("KeyH", View::Plain),
        ("KeyH", View::Exact),
    ] {
        input(&mut game, Input::Key(key), true);
        input(&mut game, Input::Key(key), false);
        pass(&mut game, &mut now, 2);
        assert_eq!(view(&mut game).options.view, look);
    }
    input(&mut game, Input::Key("Tab"), true);
    pass(&mut game, &mut now, 2);
    assert!(!view(&mut game).moment.figure.unseen_by_eye);
    for (pressed, kind) in [
        (Input::Mouse(MouseButton::Left), ThingKind::Bullet),
        (Input::Key("KeyQ"), ThingKind::Ball),
    ] {
        input(&mut game, pressed, true);
        pass(&mut game, &mut now, 1);
        input(&mut game, pressed, false);
        let things = scene(&game).things();
        assert!(things.iter().any(|it| it.kind == kind), "{things:?}");
    }
    game.motion(300.0, 0.0);
    let turned = view(&mut game);
    assert!(
        turned.moment.eye.front.distance(before.moment.eye.front) > 0.1,
        "a turn is seen in the next picture"
    );
}

#[test]
fn what_is_held_is_seen_but_with_the_display_hidden_or_by_another_rule() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:four-tunnels");
    let mut now = Instant::now();
    pass(&mut game, &mut now, 20);
    let has_hand = |game: &mut Game| game.room_view(1.5).unwrap().moment.hand.is_some();
    assert!(has_hand(&mut game));
    for key in ["F1", "KeyH", "Tab"] {
        input(&mut game, Input::Key(key), true);
        input(&mut game, Input::Key(key), false);
        pass(&mut game, &mut now, 2);
        assert!(!has_hand(&mut game), "{key}");
        for _ in 0..if key == "KeyH" { 3 } else { 1 } {
            input(&mut game, Input::Key(key), true);
            input(&mut game, Input::Key(key), false);
            pass(&mut game, &mut now, 2);
        }
        assert!(has_hand(&mut game), "{key}");
    }
}

#[test]
fn rooms_are_seen_at_the_angle_that_the_player_has_chosen() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:long-house");
    for degrees in [60.0, 90.0] {
        game.set_option("field-of-view", Value::Number(degrees));
        let fov_y_rad = game.room_view(1.5).unwrap().moment.eye.fov_y_rad;
        assert!((fov_y_rad.to_degrees() - degrees).abs() < 1e-9);
    }
}

#[test]
fn one_begins_anew_by_a_key_and_by_the_menu_and_is_told_again_what_is_strange() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:long-house");
    let began = scene(&game).feet();
    let mut now = Instant::now();
    let is_new = |game: &Game| game.play.phase.visit().unwrap().is_new();
    let walk = |game: &mut Game, now: &mut Instant| {
        input(game, Input::Key("KeyW"), true);
        pass(game, now, 500);
        input(game, Input::Key("KeyW"), false);
        assert!(scene(game).feet().distance(began) > 5.0 && !is_new(game));
    };
    walk(&mut game, &mut now);
    input(&mut game, Input::Key("KeyT"), true);
    pass(&mut game, &mut now, 2);
    assert!(is_new(&game) && scene(&game).feet().distance(began) > 5.0);
    input(&mut game, Input::Key("KeyF"), true);
    pass(&mut game, &mut now, 2);
    assert!(scene(&game).feet().distance(began) < 0.1);
    walk(&mut game, &mut now);
    input(&mut game, Input::Key("Escape"), true);
    game.follow(Intent::BeginAnew);
    assert!(game.is_playing() && is_new(&game));
    assert_eq!(scene(&game).feet(), began);
}

#[test]
fn what_does_nothing_in_a_room_says_why() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    enter(&mut game, "game:long-house");
    let mut now = Instant::now();
    pass(&mut game, &mut now, 5);
    for key in ["KeyP", "F4"] {
        input(&mut game, Input::Key(key), true);
        let said = words(&mut game);
        assert!(said.contains("is for worlds"), "{said}");
    }
    game.motion(0.0, -2000.0);
    input(&mut game, Input::Mouse(MouseButton::Right), true);
    pass(&mut game, &mut now, 3);
    let said = words(&mut game);
    assert!(said.contains("within eight metres"), "{said}");
    let visit = game.play.phase.visit_mut().unwrap();
    visit
        .room
        .scene
        .teleport(glam::DVec3::new(0.0, -200.0, 0.0))
        .unwrap();
    pass(&mut game, &mut now, 3);
    let said = words(&mut game);
    assert!(said.contains("fell out of the room"), "{said}");
}

/// A copy of a room of the game, and its slug.
fn copied(game: &mut Game, id: &str) -> String {
    let idle = |game: &Game| game.menus.are_lists_idle();
    tick_until(game, idle);
    let slug = format!("game:{id}");
    game.follow(Intent::Rooms(WorldsIntent::Duplicate { slug }));
    tick_until(game, idle);
    let rows = game.menus.rooms.rows(&game.menus.texts, None);
    let own = rows.into_iter().find(|row| !row.shipped);
    own.unwrap().slug
}

#[test]
fn what_is_read_in_a_room_and_in_its_copy_follows_the_language() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    let slug = copied(&mut game, "long-house");
    for slug in ["game:long-house", &slug] {
        game.set_option("language", Value::Choice("en"));
        enter(&mut game, slug);
        let (before, _, _) = game.room().unwrap();
        assert!(
            words(&mut game).contains("From outside this house"),
            "{slug}"
        );
        game.set_option("language", Value::Choice("de"));
        let (after, _, _) = game.room().unwrap();
        assert!(
            before.0 == after.0 && before != after,
            "signs are drawn anew"
        );
        let said = words(&mut game);
        assert!(said.contains("Von außen ist"), "{slug}: {said}");
        let rows = game.menus.rooms.rows(&game.menus.texts, None);
        let row = rows.iter().find(|row| row.slug == *slug).unwrap();
        assert!(row.sentence.starts_with("Von außen"), "{}", row.sentence);
    }
}

#[test]
fn pausing_in_a_room_of_ones_own_gives_the_list_a_picture_of_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    let slug = copied(&mut game, "long-house");
    let rooms = game.play.worlds.rooms();
    let file = rooms.path().join(&slug).join("picture.png");
    let games = fs::read(&file).unwrap();
    let pause = |game: &mut Game, slug: &str| {
        enter(game, slug);
        input(game, Input::Key("Escape"), true);
        let view = game.room_view(1.5).unwrap();
        game.room_portrait(&view)
    };
    assert!(
        pause(&mut game, "game:long-house").is_none(),
        "those of the game have theirs"
    );
    let Some((number, PortraitView::Room(view))) = pause(&mut game, &slug) else {
        panic!("there is to be one")
    };
    assert!(view.moment.hand.is_none());
    game.leave(super::super::phase::Next::Menu);
    game.play.keep_picture(number, RgbaImage::new(320, 180));
    tick_until(&mut game, |_| fs::read(&file).unwrap() != games);
    // Nobody who gets the room gets the picture.
    let found = rooms.list().unwrap().into_iter().find(|it| it.slug == slug);
    let opened = rooms.open(&found.unwrap()).unwrap();
    assert_eq!(opened.files, ["room.ron"]);
}

#[test]
fn a_room_of_ones_own_is_changed_and_kept_from_the_console_and_one_of_the_game_is_not() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = in_menu(&dir);
    let slug = copied(&mut game, "long-house");
    let order = |game: &mut Game, line: &str| {
        let order = parse_line(line).unwrap().unwrap();
        obey(game, &order).map_err(|why| why.to_string())
    };
    let has_wall = |game: &Game| scene(game).room().find("wall").is_some();
    enter(&mut game, "game:long-house");
    let add = "add box name=wall at=0,1.5,9 size=6,3,0.2";
    let refused = order(&mut game, add).unwrap_err();
    assert!(
        refused.contains("comes with the game") && !has_wall(&game),
        "{refused}"
    );
    enter(&mut game, &slug);
    order(&mut game, add).unwrap();
    assert!(has_wall(&game));
    order(&mut game, "undo").unwrap();
    assert!(!has_wall(&game));
    order(&mut game, "redo").unwrap();
    assert!(
        order(&mut game, "add box name=wall").is_err(),
        "the name is taken"
    );
    order(&mut game, "room save").unwrap();
    // As another room, which it is then; nothing of that holds a frame up.
    order(&mut game, "room save name=\"Second hut\"").unwrap();
    tick_until(&mut game, |game| {
        game.play
            .phase
            .visit()
            .is_some_and(|visit| visit.slug() != slug && visit.scene().room().name == "Second hut")
    });
    order(&mut game, "remove wall").unwrap();
    assert!(!has_wall(&game));
    game.leave(super::super::phase::Next::Menu);
    assert!(matches!(game.menus.shell.screen(), Screen::Rooms));
    enter(&mut game, &slug);
    assert!(has_wall(&game), "it was kept");
}
