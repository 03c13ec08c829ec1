//! What newcomers do in the workshop: the lesson, a line from portal to portal, clicks that mean the group, and the way there.

use antipode_rooms::{Colour, What};
use antipode_ui::workshop::{
    ChooserWish, FieldKind, FieldValue, LessonChoice, ViewEvent, WorkshopWish,
};

use super::workshop::{ask, building, chosen, drag, made, press, put, scene};
use super::*;
use crate::window::workshop::Told;

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
    ask(&mut game, [put("tunnel"), put("hall")]);
    assert!(
        said(&mut game).contains("step 1 of 5"),
        "these are no house"
    );
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
    // The house is there, so none is asked for.
    ask(&mut game, [WorkshopWish::BeginLesson(LessonChoice::House)]);
    assert!(said(&mut game).contains("step 2 of 5"));
    ask(&mut game, [WorkshopWish::EndLesson]);
    assert!(!said(&mut game).contains("of 5"));
}

/// Walks from before a portal into it.
fn walk_into(game: &mut Game, pose: &glam::DAffine3) {
    let walker = &mut game.play.phase.visit_mut().unwrap().room.scene;
    let front = pose.matrix3.x_axis;
    let feet = pose.translation + front * 0.8 - glam::DVec3::Y * 1.25;
    walker.teleport(feet).unwrap();
    walker.aim((-front.z).atan2(-front.x).to_degrees(), 0.0);
    let steer = antipode_room_scene::Steer {
        forward: 1.0,
        ..Default::default()
    };
    for _ in 0..60 {
        walker.step(&steer);
    }
}

#[test]
fn the_second_lesson_leads_to_a_tunnel_and_two_portals_and_through_one() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let said = |game: &mut Game| {
        game.tick(Instant::now());
        words(game)
    };
    let begin = WorkshopWish::BeginLesson(LessonChoice::Doors);
    ask(&mut game, [WorkshopWish::EndLesson, begin, put("portals")]);
    assert!(said(&mut game).contains("step 1 of 7"));
    ask(&mut game, [put("tunnel")]);
    assert!(said(&mut game).contains("step 2 of 7"));
    let longer = WorkshopWish::Set {
        key: "times".to_owned(),
        value: FieldValue::Number(0, 8.0),
        done: true,
    };
    ask(&mut game, [longer]);
    assert!(said(&mut game).contains("step 3 of 7"));
    ask(&mut game, [put("portal")]);
    assert!(said(&mut game).contains("step 4 of 7"));
    ask(&mut game, [put("portal"), WorkshopWish::Undo]);
    assert!(said(&mut game).contains("step 4 of 7"));
    ask(&mut game, [put("portal")]);
    // Nor does more time lead on.
    said(&mut game);
    assert!(said(&mut game).contains("step 5 of 7"));
    // The line is dragged from one to the other, so both are seen.
    let visit = game.play.phase.visit().unwrap();
    for name in ["portal", "portal 2"] {
        let at = visit
            .workshop
            .as_ref()
            .unwrap()
            .seen_in_view(visit.scene(), name);
        assert!(at.unwrap().abs().max_element() < 0.95, "{name}: {at:?}");
    }
    let room = scene(&game).room();
    let to_itself = room
        .portals()
        .filter(|(index, it)| it.to == room.objects[*index].name);
    let names: Vec<_> = to_itself
        .map(|(index, _)| room.objects[index].name.clone())
        .collect();
    let choose = WorkshopWish::Choose {
        name: names[0].clone(),
        adds: false,
    };
    let link = WorkshopWish::Set {
        key: "to".to_owned(),
        value: FieldValue::Text(names[1].clone()),
        done: true,
    };
    ask(&mut game, [choose, link]);
    assert!(said(&mut game).contains("step 6 of 7"));
    let room = scene(&game).room();
    let pose = antipode_rooms::poses(room)[room.find(&names[0]).unwrap().0];
    press(&mut game, "F5");
    assert!(words(&mut game).contains("Walk through the tunnel"));
    let tunnel = scene(&game).room().find("tunnel").unwrap().1.at;
    let walker = &mut game.play.phase.visit_mut().unwrap().room.scene;
    walker.teleport(tunnel - glam::DVec3::Y).unwrap();
    let _ = said(&mut game);
    assert!(words(&mut game).contains("Walk through the tunnel"));
    let walker = &mut game.play.phase.visit_mut().unwrap().room.scene;
    walker
        .teleport(tunnel - glam::DVec3::new(0.0, 1.0, 4.0))
        .unwrap();
    let _ = said(&mut game);
    assert!(words(&mut game).contains("That was the tunnel"));
    walk_into(&mut game, &pose);
    let _ = said(&mut game);
    assert!(words(&mut game).contains("You have built a tunnel"));
}

#[test]
fn both_of_a_pair_of_portals_are_seen_when_it_is_put_in() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    // One looks at a wall from near by, and they stand elsewhere.
    let near = WorkshopWish::View(ViewEvent::Fly([1.0, 0.0, 0.0], 1.0, false));
    ask(&mut game, [put("house"), near, put("portals")]);
    let visit = game.play.phase.visit_mut().unwrap();
    let workshop = visit.workshop.take().unwrap();
    for name in ["portal", "portal 2"] {
        let at = workshop.seen_in_view(&visit.room.scene, name).unwrap();
        assert!(at.abs().max_element() < 0.9, "{name}: {at}");
    }
    visit.workshop = Some(workshop);
}

#[test]
fn a_tunnel_is_looked_at_from_outside() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("house"), put("tunnel"), WorkshopWish::Focus],
    );
    let eye = game.room_view(1.5).unwrap().moment.eye;
    assert!(eye.place.stack.is_empty(), "one looks from within a space");
    let made = scene(&game).room().find("tunnel").unwrap().1;
    let way = made.at - eye.place.point;
    assert!(way.length() > 4.0, "{way}");
    let ahead = eye.front.dot(way.normalize());
    assert!(ahead > 0.99, "{ahead}");
}

#[test]
fn what_is_put_in_from_the_front_stands_on_the_ground_that_one_looks_at() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let front = WorkshopWish::Face(antipode_ui::workshop::ViewSide::Front);
    ask(&mut game, [front, put("box")]);
    let made = scene(&game).room().find("box").unwrap().1;
    assert_eq!(made.at.y, 0.5, "{}", made.at);
    assert!(made.at.length() < 12.0, "{}", made.at);
}

#[test]
fn a_house_that_is_dragged_to_the_side_goes_neither_nearer_nor_farther() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("house")]);
    let place = |game: &Game| scene(game).room().find("house").unwrap().1.at;
    let before = place(&game);
    let pull = |x: f64| ViewEvent::Pull {
        at: [x, -0.198],
        free: false,
    };
    let events = [
        ViewEvent::Hover([-0.22, -0.198]),
        ViewEvent::Grab([-0.22, -0.198]),
        pull(-0.1),
        pull(0.013),
        // No hand is level to the pixel.
        ViewEvent::Pull {
            at: [0.013, -0.25],
            free: false,
        },
        ViewEvent::Let {
            at: [0.013, -0.25],
            adds: false,
            is_click: false,
        },
    ];
    ask(&mut game, events.map(WorkshopWish::View));
    let after = place(&game);
    assert!(after.x > before.x + 0.7, "{before} {after}");
    assert_eq!(after.z, before.z, "{before} {after}");
    assert_eq!(after.y, before.y, "it sinks into no ground: {after}");
}

#[test]
fn a_picture_is_chosen_from_the_disk_and_lies_on_what_is_selected() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let file = dir.path().join("brick.png");
    image::RgbImage::new(4, 4).save(&file).unwrap();
    let typed = ChooserWish::Go(file.display().to_string());
    ask(&mut game, [put("box"), WorkshopWish::ChooseFile]);
    ask(&mut game, [WorkshopWish::Chooser(typed)]);
    let texture = |game: &Game| {
        let made = scene(game).room().find("box").unwrap().1;
        made.surface.texture.as_ref().map(|it| it.file.clone())
    };
    tick_until(&mut game, |game| texture(game).is_some());
    assert_eq!(texture(&game).unwrap(), "textures/brick.png");
    // It has the colours of its file, though a box has one of its own.
    let made = scene(&game).room().find("box").unwrap().1;
    assert_eq!(made.surface.colour, Colour::WHITE);
    // The inspector shows it, changes its size, and takes it away.
    let size = |game: &Game| {
        let made = scene(game).room().find("box").unwrap().1;
        made.surface.texture.as_ref().map(|it| it.size)
    };
    let set = |key: &str, value| WorkshopWish::Set {
        key: key.to_owned(),
        value,
        done: true,
    };
    ask(&mut game, [set("texture-size", FieldValue::Number(0, 2.5))]);
    assert_eq!(size(&game), Some(2.5));
    let mut told = Told::default();
    told.renew(&game.menus.texts, scene(&game));
    let file = told.fields.iter().find(|it| it.key == "texture-file");
    let shown = FieldKind::Text(Some("textures/brick.png".to_owned()));
    assert_eq!(file.unwrap().kind, shown);
    ask(&mut game, [WorkshopWish::Reset("texture-file".to_owned())]);
    assert_eq!(texture(&game), None);
    assert!(
        !words(&mut game).contains("Folder above"),
        "the page is gone"
    );
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
            choose("small portal"),
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
    let (from, to) = workshop.link_places(&visit.room.scene, "portal").unwrap();
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
        said.contains("It is closed: “portal” has another shape"),
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
        (to_of("small portal"), to_of("portal")),
        ("portal".to_owned(), "small portal".to_owned())
    );
    assert_eq!(to_of("portal 2"), "portal 2");
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
