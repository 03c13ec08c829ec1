//! The controls screen: bindings shown, changed by pressing, in conflict, and in several profiles.

use crate::common::{Game, click, focused, intents, painted, press, type_text, window};
use antipode_language::{Language, Texts};
use antipode_settings::{Action, Input, actions};
use antipode_ui::{Intent, Screen, action_label, input_label};
use egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn controls() -> Harness<'static, Game> {
    let mut harness = window(Game::new());
    click(&mut harness, "Controls");
    assert_eq!(harness.state().shell.screen(), &Screen::Controls);
    harness
}

fn named(name: &str) -> Input {
    Input::named(name).unwrap()
}

/// Presses a button of the screen and then, as the window does, what it asks for.
fn answer(harness: &mut Harness<'_, Game>, button: &str, input: &str) {
    click(harness, button);
    assert!(harness.state().shell.wants_input());
    harness.state_mut().shell.take_input(named(input));
    harness.run();
    assert!(!harness.state().shell.wants_input());
}

fn inputs(harness: &Harness<'_, Game>, action: Action) -> Vec<String> {
    let profile = harness.state().config.profiles.chosen();
    profile
        .inputs(action)
        .iter()
        .map(Input::to_string)
        .collect()
}

#[test]
fn every_action_is_listed_with_what_does_it() {
    let harness = controls();
    let texts = Texts::default();
    for info in actions().iter().filter(|info| info.action != Action::Menu) {
        let label = action_label(&texts, info.action);
        for input in harness.state().config.profiles.chosen().inputs(info.action) {
            let key = input_label(&texts, *input);
            assert!(
                harness.query_by_label(&format!("{label}: {key}")).is_some(),
                "{label}"
            );
        }
    }
    assert!(
        harness.query_by_label("Menu and pause: Escape").is_none(),
        "cannot be changed"
    );
    let said = painted(harness.output());
    assert!(
        said.iter().all(|text| text.text != "W is also"),
        "no conflicts at first"
    );
}

#[test]
fn all_actions_and_common_keys_have_names_in_every_language() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        for info in actions() {
            let label = action_label(&texts, info.action);
            assert!(!label.starts_with("action-"), "{label} has no name");
        }
        for name in [
            "Mouse1",
            "Mouse5",
            "WheelUp",
            "ShiftLeft",
            "Space",
            "Tab",
            "ArrowUp",
            "Numpad7",
        ] {
            let key = if name == "Numpad7" {
                "key-Numpad".to_owned()
            } else {
                format!("key-{name}")
            };
            assert!(texts.has_own(&key), "{name} has no name");
        }
        assert_eq!(input_label(&texts, named("KeyW")), "W");
    }
}

#[test]
fn an_input_is_replaced_by_pressing_another() {
    let mut harness = controls();
    answer(&mut harness, "Walk forward: W", "Mouse4");
    assert_eq!(inputs(&harness, Action::Forward), ["Mouse4"]);
    harness.get_by_label("Walk forward: Side button back");
    assert!(
        focused(&harness).starts_with("Walk forward"),
        "{}",
        focused(&harness)
    );
    answer(&mut harness, "Walk forward: add", "WheelUp");
    assert_eq!(inputs(&harness, Action::Forward), ["Mouse4", "WheelUp"]);
    click(&mut harness, "Walk forward: remove Side button back");
    assert_eq!(inputs(&harness, Action::Forward), ["WheelUp"]);
    click(&mut harness, "Reset “Walk forward”");
    assert_eq!(inputs(&harness, Action::Forward), ["KeyW"]);
    assert!(harness.query_by_label("Reset “Walk forward”").is_none());
}

#[test]
fn escape_cancels_and_leaves_the_screen_only_then() {
    let mut harness = controls();
    click(&mut harness, "Walk forward: W");
    assert!(harness.state().shell.wants_input());
    harness.get_by_label("Press a key or a button, or turn the wheel, for “Walk forward”.");
    harness.state_mut().shell.escape(false);
    harness.run();
    assert!(!harness.state().shell.wants_input());
    assert_eq!(harness.state().shell.screen(), &Screen::Controls);
    assert_eq!(intents(&mut harness), []);
    harness.state_mut().shell.escape(false);
    assert_eq!(harness.state().shell.screen(), &Screen::Main);
}

#[test]
fn a_conflict_is_told_under_both_actions_in_words() {
    let mut harness = controls();
    answer(&mut harness, "Sprint: add", "KeyW");
    let said: Vec<_> = painted(harness.output())
        .into_iter()
        .map(|text| text.text)
        .collect();
    for words in ["W is also “Walk forward”.", "W is also “Sprint”."] {
        assert!(said.iter().any(|text| text == words), "{words} is missing");
    }
}

#[test]
fn what_cannot_be_bound_is_refused_in_words() {
    let mut harness = controls();
    for key in ["KeyI", "KeyJ", "KeyK"] {
        answer(&mut harness, "Walk forward: add", key);
    }
    let add = harness.query_by_label("Walk forward: add");
    assert!(add.is_none(), "four are all it can have");
    answer(&mut harness, "Walk forward: W", "Escape");
    harness.get_by_label("Escape always leads out of a screen, so it cannot do anything else.");
    assert_eq!(
        inputs(&harness, Action::Forward),
        ["KeyW", "KeyI", "KeyJ", "KeyK"]
    );
}

#[test]
fn profiles_are_added_renamed_chosen_and_deleted() {
    let mut harness = controls();
    click(&mut harness, "New profile");
    assert_eq!(focused(&harness), "Name of the profile");
    harness.get_by_label("A profile needs a name.");
    type_text(&mut harness, "Left hand");
    press(&mut harness, Key::Enter);
    harness.get_by_label("Profile: Left hand");
    answer(&mut harness, "Walk forward: W", "Numpad8");
    click(&mut harness, "Profile: Standard");
    assert_eq!(inputs(&harness, Action::Forward), ["KeyW"]);
    click(&mut harness, "Profile: Left hand");
    assert_eq!(inputs(&harness, Action::Forward), ["Numpad8"]);
    click(&mut harness, "Rename");
    type_text(&mut harness, " of mine");
    click(&mut harness, "OK");
    let name =
        |harness: &Harness<'_, Game>| harness.state().config.profiles.chosen().name().to_owned();
    assert!(name(&harness).contains("of mine"), "{}", name(&harness));
    click(&mut harness, "Delete profile");
    click(&mut harness, "Cancel");
    assert_eq!(harness.state().config.profiles.all().len(), 2);
    click(&mut harness, "Delete profile");
    click(&mut harness, "Delete it");
    assert_eq!(harness.state().config.profiles.all().len(), 1);
    assert!(
        harness.query_by_label("Delete profile").is_none(),
        "the last one stays"
    );
}

#[test]
fn all_keys_are_reset_only_after_a_question() {
    let mut harness = controls();
    answer(&mut harness, "Walk forward: W", "KeyI");
    intents(&mut harness);
    click(&mut harness, "Reset all keys");
    assert_eq!(inputs(&harness, Action::Forward), ["KeyI"]);
    click(&mut harness, "Reset all");
    assert_eq!(inputs(&harness, Action::Forward), ["KeyW"]);
    assert!(matches!(&intents(&mut harness)[..], [Intent::Bind(_)]));
}

#[test]
fn what_an_action_hangs_on_by_default_fits_in_one_line() {
    for language in Language::ALL {
        let mut game = Game::new();
        game.texts = Texts::new(language);
        game.shell.open(Screen::Controls);
        let mut harness = window(game);
        harness.run();
        let texts = Texts::new(language);
        for info in actions().iter().filter(|info| info.action != Action::Menu) {
            let label = action_label(&texts, info.action);
            let input = harness.state().config.profiles.chosen().inputs(info.action)[0];
            let first = format!("{label}: {}", input_label(&texts, input));
            let add = texts.say_with("controls-add", &[("action", label.as_str().into())]);
            let line = |name: &str| harness.get_by_label(name).rect().center().y;
            let apart = (line(&first) - line(&add)).abs();
            assert!(apart < 2.0, "{language:?}, {label}: {apart} points apart");
        }
    }
}
