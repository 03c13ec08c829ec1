//! Fields of the workshop's inspector: typed in, dragged, chosen.

use antipode_ui::workshop::{Amount, FieldKind, FieldValue, Unit, WorkshopWish};
use egui::{Event, Key, Modifiers, PointerButton, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use crate::workshop::{Bench, asked, drag, field, wide};

#[test]
fn a_number_is_typed_with_its_unit_and_a_drag_of_it_tells_when_it_ends() {
    let mut harness = wide();
    let set = |place: usize, number: f64, done: bool| WorkshopWish::Set {
        key: "at".to_owned(),
        value: FieldValue::Number(place, number),
        done,
    };
    harness.get_by_label("Place y").click();
    harness.run();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("4,5 m".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(asked(&mut harness), [set(1, 4.5, true)]);
    let at = harness.get_by_label("Place x").rect().center();
    drag(&mut harness, at, vec2(50.0, 0.0), PointerButton::Primary);
    let told = asked(&mut harness);
    let ends: Vec<_> = told
        .iter()
        .map(|it| matches!(it, WorkshopWish::Set { done: true, .. }))
        .collect();
    assert!(ends.len() > 1, "{told:?}");
    assert_eq!(ends.iter().filter(|it| **it).count(), 1, "{told:?}");
    assert_eq!(ends.last(), Some(&true), "{told:?}");
}

#[test]
fn sizes_that_differ_stay_as_they_are_until_one_is_set() {
    let mut harness = wide();
    let differing = Amount {
        value: None,
        range: (0.01, 1000.0),
    };
    let sizes = FieldKind::Numbers(vec![differing; 3], Unit::Metres);
    harness.state_mut().fields = vec![field("size", "Size", sizes)];
    harness.run();
    assert_eq!(asked(&mut harness), []);
    harness.get_by_label("Size y").click();
    harness.run();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("2".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    let set = WorkshopWish::Set {
        key: "size".to_owned(),
        value: FieldValue::Number(1, 2.0),
        done: true,
    };
    assert_eq!(asked(&mut harness), [set]);
}

#[test]
fn a_text_is_kept_whole_when_enter_comes_with_its_last_letters_and_when_one_clicks_away() {
    let mut harness = wide();
    let text = FieldKind::Text(Some("old".to_owned()));
    harness.state_mut().fields = vec![field("text", "Text", text)];
    harness.run();
    let typed = |harness: &mut Harness<'_, Bench>, text: &str| {
        // Its name stands above it.
        harness.get_all_by_label("Text").last().unwrap().click();
        harness.run();
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(Event::Text(text.to_owned()));
    };
    let set = |text: &str| WorkshopWish::Set {
        key: "text".to_owned(),
        value: FieldValue::Text(text.to_owned()),
        done: true,
    };
    typed(&mut harness, "mind the step");
    harness.run();
    // In one pass, as a slow window has them.
    let enter = Event::Key {
        key: Key::Enter,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let late = Event::Text(", please".to_owned());
    harness.input_mut().events.extend([late, enter]);
    harness.step();
    harness.run();
    assert_eq!(asked(&mut harness), [set("mind the step, please")]);
    // Of what was chosen until then, so before another is.
    typed(&mut harness, "board");
    harness.run();
    harness.get_by_label("floor box").click();
    harness.run();
    let choose = WorkshopWish::Choose {
        name: "floor".to_owned(),
        adds: false,
    };
    assert_eq!(asked(&mut harness), [set("board"), choose]);
}

#[test]
fn a_colour_is_chosen_from_those_that_are_shown() {
    let mut harness = wide();
    let colour = FieldKind::Colour(Some([0x12, 0x34, 0x56]));
    harness.state_mut().fields = vec![field("colour", "Colour", colour)];
    harness.run();
    harness.get_by_label("Colour: #123456").click();
    harness.run();
    harness.get_by_label("#ffffff").click();
    harness.run();
    let white = WorkshopWish::Set {
        key: "colour".to_owned(),
        value: FieldValue::Colour([255; 3]),
        done: true,
    };
    // One step, which can be taken back at once.
    assert_eq!(asked(&mut harness), [white]);
}
