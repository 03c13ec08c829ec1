//! Where things come to lie in the workshop, and what is said of what is kept.

use antipode_rooms::What;
use antipode_ui::workshop::{
    ArrayForm, LessonChoice, ToolChoice, ViewEvent, ViewSide, WorkshopWish,
};

use super::workshop::{ask, building, chosen, drag, press, put, scene};
use super::*;
use crate::window::workshop::Told;

fn place(game: &Game, name: &str) -> glam::DVec3 {
    scene(game).room().find(name).unwrap().1.at
}

#[test]
fn what_is_dragged_on_surfaces_goes_on_from_where_it_stands_and_stays_on_the_ground() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box"), WorkshopWish::OnSurfaces(true)]);
    assert_eq!(chosen(&game), ["box"]);
    let before = place(&game, "box");
    // At its front, well above its foot.
    let held = [-0.02, -0.3];
    let pull = |at: [f64; 2]| WorkshopWish::View(ViewEvent::Pull { at, free: false });
    ask(
        &mut game,
        [
            WorkshopWish::View(ViewEvent::Grab(held)),
            pull([held[0] + 0.002, held[1]]),
        ],
    );
    let begun = place(&game, "box");
    assert!(begun.distance(before) < 0.05, "{before} {begun}");
    // All the way its lower side lies in the ground's surface, which is met none the less.
    for step in 1..=60 {
        ask(
            &mut game,
            [pull([held[0] + 0.005 * f64::from(step), held[1]])],
        );
        let on = place(&game, "box");
        assert!((on.y - before.y).abs() < 1e-6, "step {step}: {on}");
    }
    let aside = place(&game, "box");
    assert!(aside.x > before.x + 0.3, "{aside}");
    // It stands on the grid, as Snap says; with Alt it does not.
    let off = |at: glam::DVec3| [at.x, at.z].map(|it| (it - (it * 4.0).round() / 4.0).abs());
    assert!(off(aside).iter().all(|it| *it < 1e-9), "{aside}");
    ask(
        &mut game,
        [WorkshopWish::View(ViewEvent::Pull {
            at: [held[0] + 0.32, held[1]],
            free: true,
        })],
    );
    let free = place(&game, "box");
    assert!(off(free).iter().any(|it| *it > 0.01), "{free}");
}

#[test]
fn what_may_stand_in_no_file_is_told_in_words_and_that_nothing_is_lost() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("tunnel"), put("portal")]);
    let into = place(&game, "tunnel") - place(&game, "portal frame") + glam::DVec3::Z * 2.0;
    let set = |axis: usize, game: &Game| WorkshopWish::Set {
        key: "at".to_owned(),
        value: antipode_ui::workshop::FieldValue::Number(
            axis,
            place(game, "portal frame")[axis] + into[axis],
        ),
        done: true,
    };
    let moves = [set(0, &game), set(2, &game)];
    ask(&mut game, moves);
    let mut now = Instant::now();
    let began = now;
    while !words(&mut game).contains("Your edits are kept") {
        assert!(
            began.elapsed() < Duration::from_mins(2),
            "{}",
            words(&mut game)
        );
        now += Duration::from_millis(20);
        game.tick(now);
    }
    let said = words(&mut game);
    assert!(said.contains("lies over a side of “tunnel”"), "{said}");
    assert!(
        !said.contains("at of") && !said.contains("aberration"),
        "{said}"
    );
}

#[test]
fn the_start_and_lamps_are_named_where_the_pointer_is_on_them() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let back = WorkshopWish::View(ViewEvent::Fly([-1.0, 0.0, 0.0], 1.0, false));
    let aside = WorkshopWish::Nudge([8, 0, 0]);
    let none = WorkshopWish::ChooseAll(false);
    ask(&mut game, [put("light"), aside, back, none]);
    let over = |game: &mut Game, at: glam::DVec2| {
        ask(game, [WorkshopWish::View(ViewEvent::Hover(at.to_array()))]);
        let visit = game.play.phase.visit().unwrap();
        let workshop = visit.workshop.as_ref().unwrap();
        let lines = workshop.lines(visit.scene(), &game.menus.texts);
        lines
            .into_iter()
            .filter_map(|it| it.label)
            .collect::<Vec<_>>()
    };
    let at = |game: &Game, name: &str| {
        let visit = game.play.phase.visit().unwrap();
        let workshop = visit.workshop.as_ref().unwrap();
        match name {
            "" => workshop.seen_start(visit.scene()),
            name => workshop.seen_in_view(visit.scene(), name),
        }
        .unwrap()
    };
    let (lamp, start) = (at(&game, "light"), at(&game, ""));
    assert_eq!(over(&mut game, lamp), ["light"]);
    assert_eq!(over(&mut game, start), ["Start"]);
    assert!(over(&mut game, glam::DVec2::new(0.7, 0.7)).is_empty());
    ask(&mut game, [WorkshopWish::Hide("light".to_owned(), true)]);
    assert!(
        over(&mut game, lamp).is_empty(),
        "it has no mark while it is hidden"
    );
}

#[test]
fn of_a_portal_that_is_out_of_sight_no_knob_hangs_at_the_border() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("portal")]);
    assert!(words(&mut game).contains("Leads to itself: drag"));
    ask(
        &mut game,
        [WorkshopWish::View(ViewEvent::Look([250.0, 0.0]))],
    );
    assert!(!words(&mut game).contains("Leads to itself: drag"));
}

#[test]
fn the_menu_of_the_room_leads_out_of_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box"), WorkshopWish::Leave]);
    tick_until(&mut game, |game| game.play.phase.visit().is_none());
    assert!(matches!(game.menus.shell.screen(), Screen::Workshop));
}

#[test]
fn a_copy_stands_free_of_what_it_is_of() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box"), WorkshopWish::Duplicate]);
    let copy = chosen(&game)[0].clone();
    let way = place(&game, &copy) - place(&game, "box");
    assert_eq!(way, glam::DVec3::X, "a box is 1 m wide");
    // A group counts by what it carries.
    ask(&mut game, [put("house")]);
    let room = scene(&game).room();
    let (low, high) = antipode_rooms::poses(room)
        .iter()
        .zip(&room.objects)
        .filter(|(_, it)| it.group.as_deref() == Some("house"))
        .map(|(pose, _)| pose.translation.x)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
    ask(&mut game, [WorkshopWish::Duplicate]);
    let copy = chosen(&game)[0].clone();
    let aside = place(&game, &copy).x - place(&game, "house").x;
    assert!(aside > high - low, "{aside} m, from {low} to {high}");
    // A floor's would be out of sight.
    let floor = WorkshopWish::Choose {
        name: "floor".to_owned(),
        adds: false,
    };
    ask(&mut game, [floor, WorkshopWish::Duplicate]);
    let copy = chosen(&game)[0].clone();
    let way = place(&game, &copy).distance(place(&game, "floor"));
    assert!(way > 0.0 && way < 2.0, "{way}");
}

/// What the history says of the last step.
fn said(game: &Game) -> String {
    let mut told = Told::default();
    told.renew(&game.menus.texts, scene(game));
    told.history.pop().unwrap().text
}

#[test]
fn what_is_pasted_twice_stands_free_and_the_history_has_its_own_name() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let paste = || WorkshopWish::Paste;
    ask(
        &mut game,
        [put("box"), WorkshopWish::Copy, paste(), paste()],
    );
    let x = |name: &str| place(&game, name).x - place(&game, "box").x;
    assert_eq!((x("box 2"), x("box 3")), (1.0, 2.0));
    assert_eq!(said(&game), "Paste “box 3”");
    ask(&mut game, [put("portal"), put("portal")]);
    assert_eq!(said(&game), "Add “portal frame 2”");
}

/// That of nine points of the handle upwards, and its end.
fn upwards(game: &Game, point: usize) -> ([f64; 2], [f64; 2]) {
    let visit = game.play.phase.visit().unwrap();
    let workshop = visit.workshop.as_ref().unwrap();
    let lines = workshop.lines(visit.scene(), &game.menus.texts);
    // Of those that have knobs it is green.
    let green = egui::Color32::from_rgb(0x7F, 0xD1, 0x6B);
    let up = lines.iter().find(|it| it.knob && it.colour == green);
    let at = |place: usize| up.unwrap().points[place].map(f64::from);
    (at(point), at(8))
}

#[test]
fn a_handle_makes_a_wall_higher_that_stands_where_it_stood() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("wall"), WorkshopWish::Tool(ToolChoice::Scale)],
    );
    let (from, to) = upwards(&game, 5);
    drag(&mut game, from, to);
    let What::Box { size } = scene(&game).room().find("wall").unwrap().1.what else {
        panic!("it is no wall")
    };
    assert!(size.y > 2.6, "{size}");
    let low = place(&game, "wall").y - size.y / 2.0;
    assert!(low.abs() < 1e-6, "its lower side is at {low} m");
}

#[test]
fn a_house_grows_as_far_as_its_handle_is_dragged() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("house"), WorkshopWish::Tool(ToolChoice::Scale)],
    );
    let high = |game: &Game| match scene(game).room().find("house left").unwrap().1.what {
        What::Box { size } => size.y,
        _ => panic!("it is no box"),
    };
    let before = high(&game);
    let (from, to) = upwards(&game, 7);
    // By steps of the grid, of which a group has none.
    let events = [
        ViewEvent::Hover(from),
        ViewEvent::Grab(from),
        ViewEvent::Pull {
            at: to,
            free: false,
        },
        ViewEvent::Let {
            at: to,
            adds: false,
            is_click: false,
        },
    ];
    ask(&mut game, events.map(WorkshopWish::View));
    let times = high(&game) / before;
    // From 0.8875 of its length to its end, seen in perspective.
    assert!((1.02..1.4).contains(&times), "{times} times");
    let told = words(&mut game);
    assert!(told.contains("all of it grows"), "{told}");
    assert_eq!(said(&game), "Size “house”");
    assert!(told.contains("All that it carries is"), "{told}");
}

#[test]
fn copies_come_into_view_and_of_a_floor_a_part_is_looked_at() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let paste = || WorkshopWish::Paste;
    ask(
        &mut game,
        [put("house"), WorkshopWish::Copy, paste(), paste(), paste()],
    );
    let visit = game.play.phase.visit().unwrap();
    let workshop = visit.workshop.as_ref().unwrap();
    let at = workshop.seen_in_view(visit.scene(), &chosen(&game)[0]);
    assert!(at.unwrap().abs().max_element() < 0.95, "{at:?}");
    let floor = WorkshopWish::Choose {
        name: "floor".to_owned(),
        adds: false,
    };
    ask(&mut game, [floor, WorkshopWish::Focus]);
    let eye = game.room_view(1.5).unwrap().moment.eye.place.point;
    assert!(eye.length() < 100.0, "{eye}");
}

#[test]
fn tools_stay_while_one_walks() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(
        &mut game,
        [put("box"), WorkshopWish::Tool(ToolChoice::Scale)],
    );
    press(&mut game, "F5");
    press(&mut game, "F5");
    let said = words(&mut game);
    assert!(said.contains("the other side stays"), "{said}");
}

#[test]
fn one_looks_from_the_start_again() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let away = WorkshopWish::View(ViewEvent::Fly([0.0, 1.0, 0.0], 1.0, true));
    ask(&mut game, [WorkshopWish::Face(ViewSide::Top), away]);
    ask(&mut game, [WorkshopWish::Face(ViewSide::Start)]);
    let eye = game.room_view(1.5).unwrap().moment.eye;
    let spawn = scene(&game).room().spawn;
    let feet = eye.place.point - glam::DVec3::Y * antipode_room_scene::tuning::EYE_M;
    assert!(feet.distance(spawn.at) < 1e-9, "{feet}");
    let ahead = antipode_rooms::direction(spawn.look);
    assert!(eye.front.distance(ahead) < 1e-9 && eye.parallel_m.is_none());
}

#[test]
fn saving_in_the_middle_of_a_drag_leaves_it_as_it_is() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box")]);
    let before = place(&game, "box");
    let pull = |x: f64| {
        let at = [x, -0.3];
        WorkshopWish::View(ViewEvent::Pull { at, free: true })
    };
    let grab = WorkshopWish::View(ViewEvent::Grab([-0.02, -0.3]));
    ask(&mut game, [grab.clone(), pull(0.2), pull(0.3)]);
    let meant = place(&game, "box");
    assert!(meant.x > before.x + 0.2, "{meant}");
    ask(&mut game, [pull(0.2), WorkshopWish::Keep, pull(0.3)]);
    assert!(place(&game, "box").distance(meant) < 1e-9, "{meant}");
}

#[test]
fn a_room_is_saved_when_that_is_asked_for_and_says_that_it_saves_itself() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let slug = game.play.phase.visit().unwrap().slug();
    let file = game.play.worlds.rooms().path().join(slug).join("room.ron");
    let has_box = |_: &Game| fs::read_to_string(&file).is_ok_and(|text| text.contains("\"box\""));
    ask(&mut game, [put("box"), WorkshopWish::Keep]);
    assert!(words(&mut game).contains("It saves itself"));
    tick_until(&mut game, has_box);
}

#[test]
fn a_lesson_that_is_begun_inside_a_house_begins_before_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("house")]);
    let room = scene(&game).room();
    let (index, _) = room.find("house inside").unwrap();
    let inside = antipode_rooms::poses(room)[index].translation - glam::DVec3::Y * 1.2;
    press(&mut game, "F5");
    let visit = game.play.phase.visit_mut().unwrap();
    visit.room.scene.teleport(inside).unwrap();
    press(&mut game, "F5");
    let is_inside = |game: &mut Game| {
        let view = game.room_view(1.5).unwrap();
        !view.moment.eye.place.stack.is_empty()
    };
    assert!(is_inside(&mut game));
    ask(&mut game, [WorkshopWish::BeginLesson(LessonChoice::Doors)]);
    assert!(!is_inside(&mut game));
}

#[test]
fn what_is_repeated_stands_as_far_apart_as_the_form_says() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let form = ArrayForm {
        count: 3,
        axis: 2,
        gap_m: 0.5,
        turn_deg: 15.0,
    };
    ask(&mut game, [put("box"), WorkshopWish::Array(form)]);
    let first = place(&game, "box");
    for (number, name) in ["box 2", "box 3", "box 4"].into_iter().enumerate() {
        let copy = scene(&game).room().find(name).unwrap().1;
        let times = number as f64 + 1.0;
        assert!(copy.at.distance(first + glam::DVec3::Z * 1.5 * times) < 1e-9);
        assert!((copy.turn.x - 15.0 * times).abs() < 1e-9);
    }
}
