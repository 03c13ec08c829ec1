//! What newcomers do in the workshop: the lesson, a line from portal to portal, clicks that mean the group, and the way there.

use antipode_rooms::What;
use antipode_ui::workshop::{FieldValue, ViewEvent, WorkshopWish};

use super::workshop::{ask, building, chosen, drag, made, press, put, scene};
use super::*;

#[test]
fn the_lesson_comes_once_goes_on_by_ones_own_deeds_and_ends_inside_the_house() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let said = |game: &mut Game| {
        let now = Instant::now();
        game.tick(now);
        words(game)
    };
    assert!(said(&mut game).contains("step 1 of 5"));
    ask(&mut game, [put("house")]);
    assert!(said(&mut game).contains("step 2 of 5"));
    ask(&mut game, [WorkshopWish::Nudge([2, 0, 0])]);
    assert!(said(&mut game).contains("step 3 of 5"));
    ask(
        &mut game,
        [WorkshopWish::Choose {
            name: "house inside".to_owned(),
            adds: false,
        }],
    );
    assert!(said(&mut game).contains("step 4 of 5"));
    let larger = WorkshopWish::Set {
        key: "times-all".to_owned(),
        value: FieldValue::Number(0, 4.0),
        done: true,
    };
    ask(&mut game, [larger]);
    assert!(said(&mut game).contains("step 5 of 5"));
    assert!(!game.options.config.taught_to_build);
    press(&mut game, "F5");
    assert!(words(&mut game).contains("Walk in through the door"));
    let room = scene(&game).room();
    let (index, _) = room.find("house inside").unwrap();
    let inside = antipode_rooms::poses(room)[index].translation - glam::DVec3::Y * 1.2;
    let visit = game.play.phase.visit_mut().unwrap();
    visit.room.scene.teleport(inside).unwrap();
    let _ = said(&mut game);
    assert!(words(&mut game).contains("You have built a house"));
    assert!(game.options.config.taught_to_build);
    press(&mut game, "F5");
    assert!(!said(&mut game).contains("of 5"));
    ask(&mut game, [WorkshopWish::BeginLesson]);
    assert!(said(&mut game).contains("step 1 of 5"));
    ask(&mut game, [WorkshopWish::EndLesson]);
    assert!(!said(&mut game).contains("of 5"));
}

#[test]
fn a_line_dragged_from_a_portal_to_another_makes_them_partners_and_says_what_that_does() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("portals"), put("portals-of-size")]);
    let choose = |name: &str| WorkshopWish::Choose {
        name: name.to_owned(),
        adds: false,
    };
    ask(
        &mut game,
        [
            choose("small door"),
            WorkshopWish::Face(antipode_ui::workshop::ViewSide::Front),
        ],
    );
    let knob = |game: &mut Game| {
        let said = words(game);
        assert!(said.contains("Leads to"), "{said}");
    };
    knob(&mut game);
    let steps = made(&game);
    let visit = game.play.phase.visit_mut().unwrap();
    let workshop = visit.workshop.take().unwrap();
    let (from, to) = workshop.link_places(&visit.room.scene, "door").unwrap();
    visit.workshop = Some(workshop);
    let (from, to) = (from.to_array(), to.to_array());
    ask(
        &mut game,
        [
            WorkshopWish::View(ViewEvent::Grab(from)),
            WorkshopWish::View(ViewEvent::Pull {
                at: to,
                free: false,
            }),
        ],
    );
    let said = words(&mut game);
    assert!(
        said.contains("It is closed: “door” has another shape"),
        "{said}"
    );
    ask(
        &mut game,
        [WorkshopWish::View(ViewEvent::Let {
            at: to,
            adds: false,
            is_click: false,
        })],
    );
    assert_eq!(made(&game), steps + 1);
    let to_of = |name: &str| match &scene(&game).room().find(name).unwrap().1.what {
        What::Portal(it) => it.to.clone(),
        _ => panic!("no portal"),
    };
    assert_eq!(
        (to_of("small door"), to_of("door")),
        ("door".to_owned(), "small door".to_owned())
    );
    assert_eq!(to_of("door 2"), "door 2");
}

#[test]
fn a_click_on_a_things_group_means_the_group_and_an_opening_comes_before_the_floor_behind_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("tunnel"), WorkshopWish::ChooseAll(false)]);
    // The floor in the tunnel is the room's own.
    let at = [0.0, -0.3];
    drag(&mut game, at, at);
    assert_eq!(chosen(&game), ["tunnel"]);
    drag(&mut game, at, at);
    assert_eq!(chosen(&game), ["floor"]);
    ask(
        &mut game,
        [
            WorkshopWish::Undo,
            put("house"),
            WorkshopWish::ChooseAll(false),
        ],
    );
    let at = [-0.15, 0.0];
    drag(&mut game, at, at);
    assert_eq!(chosen(&game), ["house"]);
    drag(&mut game, at, at);
    assert_eq!(chosen(&game), ["house front"]);
}

#[test]
fn without_walls_one_sees_what_is_in_a_tunnel_where_it_lies() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("tunnel")]);
    assert_eq!(scene(&game).space().placed().len(), 1);
    ask(&mut game, [WorkshopWish::HideWalls(true)]);
    assert_eq!(scene(&game).space().placed().len(), 0);
    ask(
        &mut game,
        [WorkshopWish::Nudge([1, 0, 0]), WorkshopWish::Focus],
    );
    press(&mut game, "F5");
    assert_eq!(
        scene(&game).space().placed().len(),
        1,
        "who walks meets them"
    );
}

#[test]
fn the_menu_over_a_room_of_ones_own_leads_to_building_and_over_the_workshop_not_to_walking() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    press(&mut game, "Escape");
    let said = words(&mut game);
    assert!(
        said.contains("Resume") && !said.contains("Start over"),
        "{said}"
    );
    assert_eq!(
        game.room_view(1.5).unwrap().tile,
        None,
        "all of the window shows the room"
    );
    game.follow(Intent::Resume);
    press(&mut game, "F5");
    press(&mut game, "Escape");
    let said = words(&mut game);
    assert!(
        said.contains("Start over") && said.contains("Build here"),
        "{said}"
    );
    game.follow(Intent::BuildHere);
    assert!(game.play.phase.is_built());
}
