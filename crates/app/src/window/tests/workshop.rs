//! The workshop in the window, without a window: gone into and out of, built in by what its panes ask for, and kept.

use antipode_room_scene::RoomScene;
use antipode_rooms::What;
use antipode_ui::workshop::{FieldValue, ToolChoice, ViewEvent, WorkshopWish};

use super::*;

/// A game that builds in a new room.
pub fn building(dir: &TempDir) -> Game {
    let mut game = Game::new(worlds(&dir.path().join("saves")), None, None);
    game.follow(Intent::BuildNewRoom);
    arrive(&mut game);
    game
}

fn arrive(game: &mut Game) {
    tick_until(game, |game| game.play.phase.visit().is_some());
    game.play.room_drawn(&mut game.menus, false);
}

pub fn scene(game: &Game) -> &RoomScene {
    game.play.phase.visit().unwrap().scene()
}

pub fn names(game: &Game) -> Vec<&str> {
    let objects = scene(game).room().objects.iter();
    objects.map(|it| it.name.as_str()).collect()
}

pub fn chosen(game: &Game) -> &[String] {
    scene(game).document().selection()
}

pub fn made(game: &Game) -> usize {
    scene(game).document().history().made()
}

/// Has the workshop do what its panes ask for.
pub fn ask(game: &mut Game, wishes: impl IntoIterator<Item = WorkshopWish>) {
    for wish in wishes {
        game.follow_workshop(vec![wish]);
    }
}

pub fn put(id: &str) -> WorkshopWish {
    WorkshopWish::Put(id.to_owned())
}

pub fn press(game: &mut Game, key: &'static str) {
    game.press(&Press::of(Input::Key(key), true));
    game.press(&Press::of(Input::Key(key), false));
}

/// The pointer goes down, moves and comes up.
pub fn drag(game: &mut Game, from: [f64; 2], to: [f64; 2]) {
    let is_click = from == to;
    let mut events = vec![ViewEvent::Hover(from), ViewEvent::Grab(from)];
    if !is_click {
        let half = [0, 1].map(|it| f64::midpoint(from[it], to[it]));
        events.push(ViewEvent::Pull {
            at: half,
            free: true,
        });
        events.push(ViewEvent::Pull { at: to, free: true });
    }
    events.push(ViewEvent::Let {
        at: to,
        adds: false,
        is_click,
    });
    ask(game, events.into_iter().map(WorkshopWish::View));
}

#[test]
fn one_key_leads_from_building_to_playing_and_back_where_one_is() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    assert!(!game.is_playing() && game.play.phase.is_built());
    ask(
        &mut game,
        [WorkshopWish::View(ViewEvent::Fly(
            [1.0, 0.0, 0.0],
            1.0,
            false,
        ))],
    );
    let eye = game.room_view(1.5).unwrap().moment.eye.place.point;
    assert!((eye.z + 5.0).abs() < 1e-6, "{eye}");
    press(&mut game, "F5");
    assert!(game.is_playing());
    let walks = scene(&game).eye().place.point;
    assert!(walks.distance(eye) < 0.05, "{walks} {eye}");
    press(&mut game, "F5");
    assert!(game.play.phase.is_built());
    game.focus(true);
    game.focus(false);
    assert!(game.play.phase.is_built(), "nothing has to wait there");
    press(&mut game, "Escape");
    assert!(game.play.phase.is_paused());
    game.follow(Intent::Resume);
    assert!(game.play.phase.is_built());
}

#[test]
fn in_a_room_of_the_game_it_says_that_one_builds_in_copies() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = Game::new(worlds(&dir.path().join("saves")), None, None);
    game.follow(Intent::EnterRoom {
        slug: "game:long-house".to_owned(),
    });
    arrive(&mut game);
    press(&mut game, "F5");
    assert!(game.is_playing());
    assert!(words(&mut game).contains("Duplicate it"));
}

#[test]
fn parts_are_put_before_the_camera_chosen_taken_back_and_done_again() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("tunnel")]);
    assert_eq!(names(&game), ["floor", "tunnel"]);
    assert_eq!(chosen(&game), ["tunnel"]);
    let said = words(&mut game);
    assert!(
        said.contains("4.00 m long outside and feels 20 m"),
        "{said}"
    );
    ask(&mut game, [WorkshopWish::Undo]);
    assert_eq!(names(&game), ["floor"]);
    ask(
        &mut game,
        [
            WorkshopWish::Redo,
            WorkshopWish::Duplicate,
            WorkshopWish::Group,
        ],
    );
    assert_eq!(names(&game).len(), 4);
    let carried = scene(&game)
        .room()
        .objects
        .iter()
        .find(|it| it.group.is_some());
    assert_eq!(carried.unwrap().name, "tunnel 2");
    ask(&mut game, [WorkshopWish::GoTo(0)]);
    assert_eq!(names(&game), ["floor"]);
    ask(&mut game, [WorkshopWish::GoTo(3)]);
    assert_eq!(names(&game).len(), 4);
}

#[test]
fn a_click_chooses_what_is_seen_and_a_drag_moves_it_under_the_pointer_as_one_step() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box"), WorkshopWish::ChooseAll(false)]);
    let at = [-0.05, -0.4];
    drag(&mut game, at, at);
    assert_eq!(chosen(&game), ["box"]);
    let (before, steps) = (scene(&game).room().objects[1].at, made(&game));
    let away = [0.3, -0.4];
    drag(&mut game, at, away);
    let after = scene(&game).room().objects[1].at;
    assert!(
        after.x > before.x + 0.3 && (after.y - before.y).abs() < 1e-6,
        "{after}"
    );
    assert_eq!(made(&game), steps + 1);
    // It is where the pointer has left it.
    ask(&mut game, [WorkshopWish::ChooseAll(false)]);
    drag(&mut game, away, away);
    assert_eq!(chosen(&game), ["box"]);
    ask(&mut game, [WorkshopWish::Undo]);
    assert_eq!(scene(&game).room().objects[1].at, before);
}

#[test]
fn a_frame_chooses_what_has_its_middle_in_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("box"), WorkshopWish::Nudge([-8, 0, 0]), put("ball")],
    );
    ask(&mut game, [WorkshopWish::ChooseAll(false)]);
    drag(&mut game, [-0.95, 0.1], [0.9, -0.4]);
    assert_eq!(chosen(&game), ["box", "ball"]);
    ask(&mut game, [WorkshopWish::ChooseAll(false)]);
    drag(&mut game, [-0.15, 0.1], [0.15, -0.4]);
    assert_eq!(chosen(&game), ["ball"]);
}

#[test]
fn esc_gives_up_a_drag_then_the_choice_and_then_leads_to_the_menu() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box")]);
    let before = scene(&game).room().objects[1].at;
    let at = [0.0, -0.3];
    let events = [
        ViewEvent::Grab(at),
        ViewEvent::Pull {
            at: [0.3, -0.35],
            free: true,
        },
    ];
    ask(&mut game, events.map(WorkshopWish::View));
    assert!(scene(&game).room().objects[1].at != before);
    press(&mut game, "Escape");
    assert_eq!(scene(&game).room().objects[1].at, before);
    assert_eq!(chosen(&game), ["box"]);
    press(&mut game, "Escape");
    assert!(chosen(&game).is_empty());
    press(&mut game, "Escape");
    assert!(game.play.phase.is_paused());
}

#[test]
fn what_is_hidden_is_not_met_by_clicks_and_comes_back_when_one_plays() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("box"), WorkshopWish::Hide("box".to_owned(), true)],
    );
    ask(&mut game, [WorkshopWish::ChooseAll(false)]);
    drag(&mut game, [0.0, -0.3], [0.0, -0.3]);
    assert_eq!(chosen(&game), ["floor"]);
    let stands = |game: &Game| {
        let probe = scene(game).pick().object;
        probe.unwrap_or_default()
    };
    press(&mut game, "F5");
    let visit = game.play.phase.visit_mut().unwrap();
    visit.room.scene.aim(-90.0, -14.0);
    assert_eq!(stands(&game), "box");
}

#[test]
fn a_number_that_is_dragged_is_one_step_and_what_cannot_be_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("tunnel"), WorkshopWish::Tool(ToolChoice::Scale)],
    );
    let steps = made(&game);
    let set = |number: f64, done: bool| WorkshopWish::Set {
        key: "felt".to_owned(),
        value: FieldValue::Number(0, number),
        done,
    };
    ask(
        &mut game,
        [set(30.0, false), set(40.0, false), set(50.0, true)],
    );
    assert_eq!(made(&game), steps + 1);
    let What::Aberration(it) = &scene(&game).room().objects[1].what else {
        panic!("it is no tunnel")
    };
    assert!((it.stretch().z - 12.5).abs() < 1e-9);
    ask(
        &mut game,
        [WorkshopWish::Rename(
            "tunnel".to_owned(),
            "floor".to_owned(),
        )],
    );
    assert_eq!(names(&game), ["floor", "tunnel"]);
    assert!(words(&mut game).contains("floor"));
}

#[test]
fn what_is_wrong_is_said_and_leads_there() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("portals")]);
    let door = WorkshopWish::Set {
        key: "size".to_owned(),
        value: FieldValue::Number(0, 3.0),
        done: true,
    };
    ask(
        &mut game,
        [
            WorkshopWish::Choose {
                name: "portal".to_owned(),
                adds: false,
            },
            door,
        ],
    );
    ask(&mut game, [WorkshopWish::ChooseAll(false)]);
    let mut now = Instant::now();
    let began = now;
    let mut said = String::new();
    while !said.contains("sizes in proportion") {
        assert!(began.elapsed() < Duration::from_mins(2), "{said}");
        now += Duration::from_millis(20);
        game.tick(now);
        said = words(&mut game);
    }
    ask(&mut game, [WorkshopWish::ShowMessage(0)]);
    assert!(
        chosen(&game).contains(&"portal".to_owned()),
        "{:?}",
        chosen(&game)
    );
}

#[test]
fn nothing_is_drawn_anew_where_nothing_happens() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box")]);
    assert!(!game.is_still());
    let mut now = Instant::now();
    let began = now;
    while !game.is_still() {
        assert!(began.elapsed() < Duration::from_mins(2), "it never rests");
        now += Duration::from_millis(20);
        game.tick(now);
    }
    ask(&mut game, [WorkshopWish::Nudge([1, 0, 0])]);
    game.tick(now + Duration::from_millis(20));
    assert!(!game.is_still());
}

#[test]
fn what_was_built_is_kept_with_its_history() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let slug = game.play.phase.visit().unwrap().slug();
    ask(&mut game, [put("portals"), put("light")]);
    let before = scene(&game).room().clone();
    game.follow(Intent::SaveAndQuitToMenu);
    assert_eq!(game.menus.shell.screen(), &Screen::Workshop);
    let free = |game: &Game| {
        let again = game.play.worlds.rooms().path().join(&slug);
        antipode_workshop::Document::open(&again).is_ok()
    };
    tick_until(&mut game, free);
    game.follow(Intent::BuildIn { slug });
    arrive(&mut game);
    assert_eq!(scene(&game).room(), &before);
    ask(&mut game, [WorkshopWish::Undo, WorkshopWish::Undo]);
    assert_eq!(names(&game), ["floor"]);
}

#[test]
fn every_step_that_can_be_told_has_words_in_every_language() {
    for language in antipode_language::Language::ALL {
        let texts = antipode_language::Texts::new(language);
        for id in antipode_workshop::STEPS {
            let values = [
                ("name", "x".into()),
                ("count", 2_usize.into()),
                ("new", "y".into()),
            ];
            let key = format!("workshop-step-{id}");
            let said = texts.say_with(&key, &values);
            assert!(!said.is_empty() && !said.contains("workshop-step"), "{key}");
        }
        for id in antipode_workshop::FINDINGS {
            let values = [
                ("name", "x".into()),
                ("other", "y".into()),
                ("metres", 3_usize.into()),
            ];
            let key = format!("workshop-finding-{id}");
            let said = texts.say_with(&key, &values);
            assert!(
                !said.is_empty() && !said.contains("workshop-finding"),
                "{key}"
            );
        }
    }
}
