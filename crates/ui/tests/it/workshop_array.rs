//! The form of how what is chosen is repeated in a row.

use antipode_ui::workshop::{ArrayForm, WorkshopWish};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use crate::workshop::{asked, wide};

#[test]
fn one_says_how_often_which_way_and_how_far_apart() {
    let mut harness = wide();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::R);
    harness.run();
    harness.run();
    harness.get_by_label("  z  ").click();
    harness.run();
    let count = harness.get_by_role_and_label(egui::Role::TextInput, "How many");
    count.focus();
    harness.run();
    for _ in 0..2 {
        harness.key_press(Key::ArrowUp);
        harness.run();
    }
    harness.get_by_label("Make them").click();
    harness.run();
    let form = ArrayForm {
        count: 6,
        axis: 2,
        ..ArrayForm::default()
    };
    assert_eq!(asked(&mut harness), [WorkshopWish::Array(form)]);
    harness.run();
    assert!(harness.query_by_label("Make them").is_none());
}

#[test]
fn escape_closes_the_form_and_nothing_is_made() {
    let mut harness = wide();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::R);
    harness.run();
    harness.run();
    assert!(harness.state().panes.has_page());
    harness.key_press(Key::Escape);
    harness.run();
    harness.run();
    assert!(!harness.state().panes.has_page());
    assert_eq!(asked(&mut harness), []);
}
