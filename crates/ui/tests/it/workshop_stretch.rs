//! The slider of how many times as long something feels: as wide as the pane, the same way for twice as much everywhere, and slow
//! with Shift.

use antipode_language::{Language, Texts};
use antipode_ui::workshop::{Amount, FieldKind, FieldValue, Unit, WorkshopWish};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use crate::workshop::{Bench, asked, bench, field, harness, wide};

#[test]
fn a_number_that_was_typed_stays_though_it_is_between_steps_of_the_slider() {
    let mut harness = wide();
    let fields = &mut harness.state_mut().fields;
    let row = fields.iter_mut().find(|it| it.key == "times").unwrap();
    row.kind = FieldKind::Stretch(Some(10.0));
    harness.run();
    harness.run();
    assert_eq!(follow(&mut harness), []);
}

/// What the slider asks for is done, and told: each value, and whether it is the last of a drag.
fn follow(harness: &mut Harness<'static, Bench>) -> Vec<(f64, bool)> {
    let all = asked(harness).into_iter();
    let set: Vec<_> = all
        .filter_map(|wish| match wish {
            WorkshopWish::Set {
                key,
                value: FieldValue::Number(0, times),
                done,
            } if key == "times" => Some((times, done)),
            _ => None,
        })
        .collect();
    if let Some((times, _)) = set.last() {
        let fields = &mut harness.state_mut().fields;
        let row = fields.iter_mut().find(|it| it.key == "times").unwrap();
        row.kind = FieldKind::Stretch(Some(*times));
    }
    set
}

fn slider(harness: &Harness<'static, Bench>) -> Rect {
    harness.get_by_role(egui::Role::Slider).rect()
}

fn go(harness: &mut Harness<'static, Bench>, to: Pos2) -> Vec<(f64, bool)> {
    harness.event(Event::PointerMoved(to));
    harness.run();
    follow(harness)
}

fn press(harness: &mut Harness<'static, Bench>, at: Pos2, pressed: bool) -> Vec<(f64, bool)> {
    harness.event(Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    });
    harness.run();
    follow(harness)
}

fn shift(harness: &mut Harness<'static, Bench>, down: bool) {
    let modifiers = if down {
        Modifiers::SHIFT
    } else {
        Modifiers::NONE
    };
    harness.event(Event::ModifiersChanged(modifiers));
}

#[test]
fn the_whole_width_of_the_pane_leads_from_a_32nd_to_32_in_round_steps() {
    let mut harness = wide();
    let rect = slider(&harness);
    let pane = harness.get_by_label("Place x").rect().left();
    assert!(
        rect.width() > 250.0 && (rect.left() - pane).abs() < 4.0,
        "{rect}"
    );
    let at = |share: f32| pos2(rect.left() + share * rect.width(), rect.center().y);
    go(&mut harness, at(0.5));
    let pressed = press(&mut harness, at(0.5), true);
    assert!(
        (pressed.last().unwrap().0 - 1.0).abs() < 0.02,
        "{pressed:?}"
    );
    let (half, _) = *go(&mut harness, at(0.6)).last().unwrap();
    assert!(
        (half - 2.0).abs() < 0.11,
        "a tenth of the width doubles: {half}"
    );
    assert!((half * 10.0 - (half * 10.0).round()).abs() < 1e-9, "{half}");
    let (round, _) = *go(&mut harness, at(0.63)).last().unwrap();
    assert!(
        (round * 10.0 - (round * 10.0).round()).abs() < 1e-9,
        "{round}"
    );
    assert_eq!(go(&mut harness, at(1.1)).last(), Some(&(32.0, false)));
    let (least, _) = *go(&mut harness, at(-0.1)).last().unwrap();
    assert!((least - 1.0 / 32.0).abs() < 5e-4, "{least}");
    let let_go = press(&mut harness, at(-0.1), false);
    assert!(let_go.last().unwrap().1, "the drag is one step: {let_go:?}");
}

#[test]
fn with_shift_the_slider_goes_a_tenth_as_fast_and_on_from_there_without() {
    let mut harness = wide();
    let rect = slider(&harness);
    let at = |share: f32| pos2(rect.left() + share * rect.width(), rect.center().y);
    go(&mut harness, at(0.6));
    press(&mut harness, at(0.6), true);
    let (before, _) = *go(&mut harness, at(0.61)).last().unwrap();
    shift(&mut harness, true);
    let (fine, _) = *go(&mut harness, at(0.71)).last().unwrap();
    let octaves = (fine / before).log2();
    assert!((octaves - 0.1).abs() < 0.03, "{before} to {fine}");
    shift(&mut harness, false);
    let (on, _) = *go(&mut harness, at(0.72)).last().unwrap();
    let octaves = (on / fine).log2();
    assert!((octaves - 0.1).abs() < 0.08, "{fine} to {on}: it jumps");
}

#[test]
fn the_slider_is_moved_by_keys_and_its_number_is_typed_beside_the_name() {
    let mut harness = wide();
    harness.get_by_role(egui::Role::Slider).focus();
    harness.run();
    follow(&mut harness);
    harness.key_press(Key::ArrowRight);
    harness.run();
    let asked = follow(&mut harness);
    assert_eq!(asked, [(5.2, true)], "an arrow is a small step");
    let number = harness.query_all_by_label("Stretch").last().unwrap().rect();
    assert!(number.bottom() <= slider(&harness).top() + 1.0, "{number}");
}

#[test]
fn a_long_name_leaves_its_button_and_its_number_free_in_every_language() {
    for language in Language::ALL {
        let mut bench = bench(language, 1280.0);
        let say = |words: &str| Texts::new(language).say(words);
        let label = say("workshop-field-times-all");
        bench.fields = vec![field("times-all", &label, FieldKind::Stretch(Some(2.0)))];
        let mut harness = harness(bench, vec2(1280.0, 720.0));
        harness.run();
        let values = [("name", label.as_str().into())];
        let reset = Texts::new(language).say_with("workshop-reset", &values);
        let reset = harness.get_by_label(&reset).rect();
        let all: Vec<_> = harness.get_all_by_label(&label).collect();
        assert_eq!(all.len(), 2, "{language:?}");
        for one in all {
            let rect = one.rect();
            assert!(
                !rect.shrink(0.5).intersects(reset),
                "{language:?}: {rect} {reset}"
            );
        }
    }
}

#[test]
fn in_a_narrow_window_all_fields_of_a_tunnel_are_whole_in_every_language() {
    for language in Language::ALL {
        let mut bench = bench(language, 1280.0);
        let say = |words: &str| Texts::new(language).say(words);
        let metres = |value: f64| Amount {
            value: Some(value),
            range: (-1000.0, 1000.0),
        };
        let choice = |id: &str| FieldKind::Choice(vec![(id.to_owned(), say(id))], Some(0));
        let named =
            |key: &str, kind: FieldKind| field(key, &say(&format!("workshop-field-{key}")), kind);
        let place = [1.5, 2.0, -3.25].map(metres).to_vec();
        bench.fields = vec![
            named("name", FieldKind::Text(Some("tunnel".to_owned()))),
            named("at", FieldKind::Numbers(place.clone(), Unit::Metres)),
            named("turn", FieldKind::Numbers(place.clone(), Unit::Degrees)),
            named("half", FieldKind::Numbers(place, Unit::Metres)),
            named("colour", FieldKind::Colour(Some([1, 2, 3]))),
            named("outline", FieldKind::Switch(Some(true))),
            named("lengths", choice("workshop-choice-lengths-felt")),
            named("sides", choice("workshop-choice-sides-walls")),
            named("felt", FieldKind::Numbers(vec![metres(39.6)], Unit::Metres)),
            named("times", FieldKind::Stretch(Some(9.9))),
            named(
                "thesis",
                FieldKind::Numbers(vec![metres(-0.899)], Unit::Plain),
            ),
        ];
        let mut harness = harness(bench, vec2(800.0, 600.0));
        for _ in 0..4 {
            harness.run();
        }
        let place = say("workshop-field-at");
        let last = harness.get_by_label(&format!("{place} z")).rect();
        let stretch = say("workshop-field-times");
        let times = harness.query_all_by_label(&stretch).last().unwrap().rect();
        for (what, rect) in [
            ("place", last),
            ("stretch", times),
            ("slider", slider(&harness)),
        ] {
            assert!(rect.right() <= 792.0, "{language:?}, {what}: {rect}");
        }
    }
}
