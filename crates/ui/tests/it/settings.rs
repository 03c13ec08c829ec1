//! The settings screen: found, changed, described, reset.

use crate::common::{Game, click, focused, intents, painted, press, type_text, window};
use antipode_language::{Language, Texts};
use antipode_settings::{Kind, Value, fields};
use antipode_ui::{Intent, Screen};
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn settings() -> Harness<'static, Game> {
    let mut harness = window(Game::new());
    click(&mut harness, "Settings");
    assert_eq!(harness.state().shell.screen(), &Screen::Settings);
    harness
}

fn search(harness: &mut Harness<'_, Game>, words: &str) {
    harness.get_by_label("Search the settings").focus();
    harness.run();
    type_text(harness, words);
}

#[test]
fn every_setting_is_named_described_and_found_by_its_name() {
    let texts = Texts::default();
    for field in fields() {
        let mut harness = settings();
        let label = texts.say(&field.label_key());
        search(&mut harness, &label);
        let reset = format!("Reset “{label}”");
        assert!(
            harness.query_by_label(&reset).is_some(),
            "{label} is not found"
        );
        let about = texts.say(&field.about_key());
        let said = painted(harness.output());
        assert!(
            said.iter().any(|text| text.text == about),
            "{label} says nothing"
        );
    }
}

#[test]
fn every_word_of_a_setting_is_there_in_every_language() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        for field in fields() {
            let mut keys = vec![field.label_key(), field.about_key()];
            match field.kind {
                Kind::Toggle => {}
                Kind::Slider { unit_key, .. } => keys.push(unit_key.to_owned()),
                Kind::Choice { options } => {
                    keys.extend(options.iter().map(|option| field.option_key(option)));
                }
            }
            for key in keys {
                assert!(texts.has_own(&key), "{key} is missing in {}", language.id());
            }
        }
    }
}

#[test]
fn a_box_a_choice_and_a_slider_ask_for_their_values() {
    let mut harness = settings();
    search(&mut harness, "invert");
    click(&mut harness, "Invert up and down");
    let on = Value::Switch(true);
    let id = "invert-look";
    assert_eq!(intents(&mut harness), [Intent::Set { id, value: on }]);
    click(&mut harness, "Invert up and down");
    let value = Value::Switch(false);
    assert_eq!(intents(&mut harness), [Intent::Set { id, value }]);

    let mut harness = settings();
    search(&mut harness, "quality");
    click(&mut harness, "Quality: Exact");
    let (id, value) = ("quality", Value::Choice("exact"));
    assert_eq!(intents(&mut harness), [Intent::Set { id, value }]);

    let mut harness = settings();
    search(&mut harness, "field of view");
    let slider = egui::accesskit::Role::Slider;
    harness
        .get_by_role_and_label(slider, "Field of view: 75°")
        .focus();
    harness.run();
    assert_eq!(focused(&harness), "Field of view: 75°");
    press(&mut harness, Key::ArrowRight);
    let (id, value) = ("field-of-view", Value::Number(76.0));
    assert_eq!(intents(&mut harness), [Intent::Set { id, value }]);
    harness.get_by_role_and_label(slider, "Field of view: 76°");
}

#[test]
fn a_choice_that_holds_already_can_be_asked_for_again() {
    let mut harness = settings();
    search(&mut harness, "hyperbolic map");
    click(&mut harness, "Hyperbolic map: Raised");
    let (id, value) = ("hyperbolic-map", Value::Choice("raised"));
    assert_eq!(intents(&mut harness), [Intent::Set { id, value }]);
}

#[test]
fn each_setting_is_reset_by_itself_and_only_when_it_was_changed() {
    let mut game = Game::new();
    game.config.settings.field_of_view_deg = 90.0;
    game.config.settings.vsync = false;
    let mut harness = window(game);
    click(&mut harness, "Settings");
    search(&mut harness, "field of view");
    click(&mut harness, "Reset “Field of view”");
    assert_eq!(
        intents(&mut harness),
        [Intent::ResetSetting("field-of-view")]
    );
    let now = &harness.state().config.settings;
    assert_eq!((now.field_of_view_deg, now.vsync), (75.0, false));
    click(&mut harness, "Reset “Field of view”");
    assert_eq!(
        intents(&mut harness),
        [],
        "a default has nothing to be reset"
    );
}

#[test]
fn the_scale_of_the_interface_waits_until_the_slider_is_let_go() {
    let mut harness = settings();
    search(&mut harness, "size of text");
    let slider = harness
        .get_by_label("Size of text and buttons: 1.0 ×")
        .rect();
    let from = slider.left_center() + vec2(20.0, 0.0);
    let press = |pressed| egui::Event::PointerButton {
        pos: from,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    };
    harness.event(egui::Event::PointerMoved(from));
    harness.event(press(true));
    harness.run_steps(2);
    for x in [30.0, 60.0, 90.0] {
        harness.event(egui::Event::PointerMoved(from + vec2(x, 0.0)));
        harness.run_steps(1);
    }
    assert_eq!(intents(&mut harness), []);
    harness.event(egui::Event::PointerButton {
        pos: from + vec2(90.0, 0.0),
        button: egui::PointerButton::Primary,
        pressed: false,
        modifiers: egui::Modifiers::NONE,
    });
    harness.run();
    let asked = intents(&mut harness);
    assert!(
        matches!(&asked[..], [Intent::Set { id: "ui-scale", value: Value::Number(n) }] if *n != 1.0),
        "{asked:?}"
    );
}

#[test]
fn a_search_that_finds_nothing_says_so_and_escape_clears_it_first() {
    let mut harness = settings();
    search(&mut harness, "flux capacitor");
    harness.get_by_label("No setting matches “flux capacitor”.");
    harness.state_mut().shell.escape(false);
    harness.run();
    assert_eq!(harness.state().shell.screen(), &Screen::Settings);
    harness.get_by_label("Invert up and down");
    harness.state_mut().shell.escape(false);
    harness.run();
    assert_eq!(harness.state().shell.screen(), &Screen::Main);
}

#[test]
fn the_arrows_walk_through_the_settings() {
    let mut harness = window(Game::new());
    harness.run();
    harness.get_by_label("Settings").focus();
    harness.run();
    press(&mut harness, Key::Enter);
    assert_eq!(focused(&harness), "Search the settings");
    let mut seen = Vec::new();
    for _ in 0..8 {
        press(&mut harness, Key::ArrowDown);
        seen.push(focused(&harness));
    }
    for name in ["Mouse sensitivity: ", "Invert up and down", "Quality: "] {
        assert!(
            seen.iter().any(|focus| focus.starts_with(name)),
            "{name}: {seen:?}"
        );
    }
}

#[test]
fn who_hears_nothing_is_told_why_among_the_settings_of_sound() {
    let mut harness = settings();
    search(&mut harness, "music");
    let said = painted(harness.output());
    assert!(
        said.iter()
            .any(|text| text.text == "There is no sound device.")
    );
    let mut elsewhere = settings();
    search(&mut elsewhere, "language");
    let said = painted(elsewhere.output());
    assert!(
        said.iter()
            .all(|text| text.text != "There is no sound device.")
    );
}

#[test]
fn nothing_moves_after_the_first_frame_of_a_long_screen() {
    for screen in [Screen::Settings, Screen::Controls, Screen::About] {
        let mut harness = window(Game::new());
        harness.run();
        harness.state_mut().shell.open(screen.clone());
        let places = |harness: &Harness<'_, Game>| {
            let texts = painted(harness.output()).into_iter();
            texts.map(|text| (text.text, text.rect)).collect::<Vec<_>>()
        };
        harness.step();
        let first = places(&harness);
        assert!(first.len() > 10);
        // The scroll bar comes with the first frame, not beside words that are there already.
        harness.run_ok();
        assert_eq!(first, places(&harness), "{screen:?}");
    }
}

#[test]
fn changing_the_language_with_a_search_typed_keeps_the_row() {
    let mut game = Game::new();
    game.texts = Texts::new(Language::German);
    let hint = game.texts.say("settings-search");
    game.shell.open(Screen::Settings);
    let mut harness = window(game);
    harness.run();
    harness.get_by_label(&hint).focus();
    harness.run();
    type_text(&mut harness, "sprache");
    let label = harness.state().texts.say("setting-language");
    click(&mut harness, &format!("{label}: Polski"));
    let polish = Texts::new(Language::Polish);
    harness.state_mut().texts = polish.clone();
    harness.run();
    let label = polish.say("setting-language");
    harness.get_by_label(&format!("{label}: Deutsch"));
    assert!(
        harness
            .query_by_label(&polish.say("setting-quality"))
            .is_none()
    );
    // Another search goes by the new words.
    harness.get_by_label(&polish.say("settings-search")).focus();
    harness.run();
    type_text(&mut harness, "x");
    assert!(
        harness
            .query_by_label(&format!("{label}: Deutsch"))
            .is_none()
    );
}
