//! The panel of the photo mode: reached and changed by keys, and the mouse that turns the view beside it.

use crate::common::painted;
use antipode_language::{Language, Texts};
use antipode_ui::{DialKind, PhotoModel, PhotoValues, PhotoWishes, apply_theme, show_photo};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

struct Mode {
    texts: Texts,
    values: PhotoValues,
    dial: Option<(DialKind, f64, f64)>,
    saving: Option<f32>,
    fresh: bool,
    wishes: PhotoWishes,
    looked: Vec2,
}

fn mode() -> Mode {
    Mode {
        texts: Texts::default(),
        values: PhotoValues {
            field_of_view_deg: 75.0,
            time_of_day_s: 100.0,
            dial: 10.0,
            hide_figures: false,
            thirds: false,
            times: 1,
        },
        dial: Some((DialKind::Raised, 0.0, 20.0)),
        saving: None,
        fresh: true,
        wishes: PhotoWishes::default(),
        looked: Vec2::ZERO,
    }
}

fn show(ctx: &egui::Context, mode: &mut Mode) {
    let model = PhotoModel {
        texts: &mode.texts,
        dial: mode.dial,
        day_s: Some(600.0),
        clock: &|time_s| format!("{time_s:.0} s"),
        size: (1280, 720),
        most_times: 4,
        keys: "W A S D".to_owned(),
        saving: mode.saving,
    };
    let fresh = std::mem::take(&mut mode.fresh);
    let wishes = show_photo(ctx, &model, &mut mode.values, fresh);
    mode.looked += wishes.look;
    mode.wishes.save |= wishes.save;
    mode.wishes.leave |= wishes.leave;
}

fn harness(mode: Mode, size: Vec2) -> Harness<'static, Mode> {
    Harness::builder()
        .with_size(size)
        .with_max_steps(8)
        .allow_missing_glyphs()
        .with_context_setup(apply_theme)
        .build_ui_state(|ui, mode: &mut Mode| show(ui.ctx(), mode), mode)
}

fn focused(harness: &Harness<'_, Mode>) -> String {
    harness
        .root()
        .children_recursive()
        .map(|node| node.accesskit_node())
        .find(|node| node.is_focused() && node.role() != egui::Role::Window)
        .and_then(|node| node.label())
        .unwrap_or_default()
}

fn press(harness: &mut Harness<'_, Mode>, key: Key) {
    harness.key_press(key);
    harness.run();
}

#[test]
fn every_slider_and_button_is_reached_and_changed_by_keys() {
    let mut harness = harness(mode(), vec2(1280.0, 720.0));
    harness.run();
    assert!(
        focused(&harness).starts_with("Field of view"),
        "{}",
        focused(&harness)
    );
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowLeft);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    let values = harness.state().values;
    assert_eq!(values.field_of_view_deg, 76.0);
    assert!(values.time_of_day_s < 100.0, "{values:?}");
    assert!(values.dial > 10.0, "{values:?}");
    assert!(values.hide_figures && values.thirds, "{values:?}");
    assert_eq!(values.times, 2);
    harness.get_by_label("2 × (2560 × 1440)");
    harness.get_by_label("Save the picture").click();
    harness.get_by_label("Leave").click();
    harness.run();
    assert!(harness.state().wishes.save && harness.state().wishes.leave);
}

fn drag(harness: &mut Harness<'_, Mode>, from: Pos2, way: Vec2) {
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    harness.event(Event::PointerMoved(from));
    harness.run_steps(1);
    harness.event(button(from, true));
    harness.run_steps(1);
    harness.event(Event::PointerMoved(from + way));
    harness.run_steps(1);
    harness.event(button(from + way, false));
    harness.run_steps(1);
}

#[test]
fn a_drag_over_the_picture_turns_the_view_and_one_over_the_panel_does_not() {
    let mut harness = harness(mode(), vec2(1280.0, 720.0));
    harness.run();
    drag(&mut harness, pos2(300.0, 300.0), vec2(40.0, -10.0));
    assert_eq!(harness.state().looked, vec2(40.0, -10.0));
    drag(&mut harness, pos2(1200.0, 600.0), vec2(-30.0, 5.0));
    assert_eq!(harness.state().looked, vec2(40.0, -10.0));
}

#[test]
fn while_a_picture_is_made_it_tells_how_far_and_nothing_can_be_changed() {
    let mut mode = mode();
    mode.saving = Some(0.25);
    let mut harness = harness(mode, vec2(1280.0, 720.0));
    harness.run();
    harness.get_by_label("Saving: 25 %");
    press(&mut harness, Key::ArrowRight);
    drag(&mut harness, pos2(300.0, 300.0), vec2(40.0, -10.0));
    assert_eq!(harness.state().values.field_of_view_deg, 75.0);
    assert_eq!(harness.state().looked, Vec2::ZERO);
}

#[test]
fn it_fits_every_window_and_language() {
    for language in Language::ALL {
        for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0)] {
            let mut mode = mode();
            mode.texts = Texts::new(language);
            mode.values.thirds = true;
            let mut harness = harness(mode, size);
            harness.run();
            for text in painted(harness.output()) {
                let sticks_out =
                    text.rect.max.x > size.x + 0.5 || text.rect.min.x < 0.4 * size.x - 16.0;
                assert!(!sticks_out, "{}: {}", language.id(), text.text);
            }
        }
    }
}
