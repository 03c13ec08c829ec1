//! What is looked at in the workshop, from where, and what is chosen and kept of it.

use antipode_rooms::What;
use antipode_ui::workshop::{ViewEvent, ViewSide, WorkshopWish};

use super::workshop::{ask, building, chosen, drag, put, scene};
use super::*;

/// How high one looks from, metres.
fn eye_m(game: &Game) -> f64 {
    let visit = game.play.phase.visit().unwrap();
    let eye = visit.workshop_view(None).unwrap().moment.eye;
    eye.place.point.y
}

#[test]
fn a_frame_takes_what_is_whole_in_it_and_not_the_ground_below() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let above = WorkshopWish::Face(ViewSide::Top);
    ask(
        &mut game,
        [
            put("box"),
            WorkshopWish::Focus,
            above,
            WorkshopWish::ChooseAll(false),
        ],
    );
    let far = WorkshopWish::View(ViewEvent::Zoom(-12.0));
    ask(&mut game, [far]);
    let visit = game.play.phase.visit().unwrap();
    let workshop = visit.workshop.as_ref().unwrap();
    let middle = workshop.seen_in_view(visit.scene(), "floor").unwrap();
    assert!(
        middle.abs().max_element() < 0.9,
        "the ground's is in the frame: {middle}"
    );
    drag(&mut game, [-0.95, 0.95], [0.95, -0.95]);
    assert_eq!(chosen(&game), ["box"]);
}

#[test]
fn who_looks_at_something_from_low_down_does_not_look_from_within_the_ground() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    // One looks up at the box from the height of its foot.
    ask(&mut game, [put("box"), WorkshopWish::Focus]);
    let low = WorkshopWish::View(ViewEvent::Orbit([0.0, -400.0]));
    ask(&mut game, [low, WorkshopWish::Focus]);
    let eye = eye_m(&game);
    assert!(eye > 0.1, "{eye} m over the ground");
}

#[test]
fn what_is_put_before_a_wall_stands_on_the_ground() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let near = WorkshopWish::View(ViewEvent::Zoom(3.0));
    ask(&mut game, [put("wall"), WorkshopWish::Focus, near]);
    let wall_z = scene(&game).room().find("wall").unwrap().1.at.z;
    for id in ["arch", "box", "wall"] {
        ask(&mut game, [put(id)]);
        let room = scene(&game).room();
        let made = room.find(&chosen(&game)[0]).unwrap().1;
        let half_m = match made.what {
            What::Box { size } | What::Arch { size, .. } => size.y / 2.0,
            _ => panic!("{id} is something else"),
        };
        assert!((made.at.y - half_m).abs() < 0.02, "{id}: {}", made.at);
        assert!(
            (wall_z..wall_z + 1.0).contains(&made.at.z),
            "{id}: {}",
            made.at
        );
        ask(&mut game, [WorkshopWish::Undo]);
    }
}

#[test]
fn the_list_gets_a_picture_of_a_room_that_is_left_from_the_workshop() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let view = game.room_view(1.5).unwrap();
    assert!(game.room_portrait(&view).is_none());
    ask(&mut game, [put("box"), WorkshopWish::Leave]);
    assert!(game.room_portrait(&view).is_some());
}

#[test]
fn a_second_portal_has_another_frame_and_a_copied_house_stands_before_none() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let choose = |name: &str| WorkshopWish::Choose {
        name: name.to_owned(),
        adds: false,
    };
    ask(&mut game, [put("portal"), put("portal")]);
    let colour = |name: &str| scene(&game).room().find(name).unwrap().1.surface.colour;
    assert_ne!(colour("lintel"), colour("lintel 2"));
    let mut game = building(&dir);
    ask(&mut game, [put("house"), WorkshopWish::Copy]);
    let house = scene(&game).room().find("house").unwrap().1.at;
    // Right beside the house, where a copy would stand.
    ask(&mut game, [put("portal")]);
    for axis in [0, 2] {
        let there = house[axis] + if axis == 0 { 5.5 } else { 1.0 };
        let value = antipode_ui::workshop::FieldValue::Number(axis, there);
        let key = "at".to_owned();
        let set = WorkshopWish::Set {
            key,
            value,
            done: true,
        };
        ask(&mut game, [choose("portal frame"), set]);
    }
    ask(&mut game, [WorkshopWish::Paste]);
    let copy = scene(&game).room().find("house 2").unwrap().1.at;
    assert!(copy.x - house.x > 8.0, "{house} {copy}");
}

#[test]
fn what_is_no_number_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let set = WorkshopWish::Set {
        key: "at".to_owned(),
        value: antipode_ui::workshop::FieldValue::Misread("abc".to_owned()),
        done: true,
    };
    ask(&mut game, [put("box"), set]);
    assert!(words(&mut game).contains("“abc” is no number"));
}
