//! Which hints a newcomer is given, in which order, and what ends them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use antipode_language::Language;
use antipode_settings::PadButton;

use super::*;

fn told(hints: &Hints, has_dial: bool) -> String {
    let model = hints.model(&Texts::default(), &Profiles::default(), has_dial);
    model.map_or_else(String::new, |model| {
        format!("{} | {}", model.text, model.footer)
    })
}

fn pass(hints: &mut Hints, actions: &Actions, time_s: f64) {
    for _ in 0..(time_s / STEP_S).round() as u32 {
        hints.step(actions, true);
    }
}

/// What teaches each lesson, for long enough.
fn lessons() -> [Actions; 6] {
    let actions = Actions::default();
    [
        Actions {
            look_yaw: 0.05,
            ..actions
        },
        Actions {
            forward: 1.0,
            ..actions
        },
        Actions {
            jump: true,
            ..actions
        },
        Actions {
            primary: true,
            ..actions
        },
        Actions {
            secondary: true,
            ..actions
        },
        Actions {
            dial: 1.0,
            ..actions
        },
    ]
}

#[test]
fn each_hint_goes_when_it_was_done_and_the_next_one_comes() {
    let mut hints = Hints::default();
    let words = [
        "Look around: Mouse | 1 of 8 · skip: N",
        "Walk: W A S D | 2 of 8 · skip: N",
        "Jump: Space | 3 of 8 · skip: N",
        "Dig, held down: Left button | 4 of 8 · skip: N",
        "Build, held down: Right button | 5 of 8 · skip: N",
        "Change how space is pictured: Wheel up and Wheel down | 6 of 8 · skip: N",
    ];
    for (words, actions) in words.iter().zip(lessons()) {
        assert_eq!(told(&hints, true), *words);
        pass(&mut hints, &Actions::default(), 5.0);
        assert_eq!(told(&hints, true), *words, "waiting is not doing");
        pass(&mut hints, &actions, 1.0);
        pass(&mut hints, &Actions::default(), REST_S);
    }
    assert!(told(&hints, true).starts_with("Open the backpack: E | 7 of 8"));
    hints.finish(Lesson::Backpack);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, true).starts_with("Pause"));
    hints.finish(Lesson::Menu);
    assert_eq!(hints.current(true), None);
}

#[test]
fn what_a_world_has_not_is_not_told_and_not_counted() {
    let mut hints = Hints::default();
    assert!(told(&hints, false).contains("1 of 7"));
    for actions in &lessons()[..5] {
        pass(&mut hints, actions, 1.0);
    }
    pass(&mut hints, &Actions::default(), REST_S);
    hints.finish(Lesson::Backpack);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, false).starts_with("Pause"));
}

#[test]
fn the_last_hint_goes_when_it_was_there_long_enough_and_no_other_does() {
    let mut hints = Hints::default();
    pass(&mut hints, &Actions::default(), 10.0 * LAST_S);
    assert!(
        told(&hints, true).contains("1 of 8"),
        "that is not the last"
    );
    for lesson in Lesson::ALL {
        if lesson != Lesson::Menu {
            hints.finish(lesson);
        }
    }
    pass(&mut hints, &Actions::default(), 0.9 * LAST_S);
    assert!(told(&hints, true).starts_with("Pause"));
    pass(&mut hints, &Actions::default(), 0.2 * LAST_S);
    assert_eq!(hints.current(true), None);
}

#[test]
fn what_was_done_before_its_turn_is_not_asked_for() {
    let mut hints = Hints::default();
    pass(&mut hints, &lessons()[1], 1.0);
    pass(&mut hints, &lessons()[0], 1.0);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, true).starts_with("Jump"));
}

#[test]
fn hints_name_the_keys_that_are_bound_and_the_buttons_of_a_pad_in_use() {
    let mut profiles = Profiles::default();
    let own = profiles.chosen_mut();
    let (old, new) = (Input::key("Space").unwrap(), Input::key("KeyJ").unwrap());
    own.rebind(Action::Jump, old, new).unwrap();
    own.unbind(Action::SkipHint, Input::key("KeyN").unwrap())
        .unwrap();
    let mut hints = Hints::default();
    for actions in &lessons()[..2] {
        pass(&mut hints, actions, 1.0);
    }
    pass(&mut hints, &Actions::default(), REST_S);
    let texts = Texts::default();
    let model = hints.model(&texts, &profiles, true).unwrap();
    assert_eq!(
        (model.text.as_str(), model.footer.as_str()),
        ("Jump: J", "3 of 8")
    );
    hints.use_pad(true);
    let model = hints.model(&texts, &profiles, true).unwrap();
    assert_eq!(model.text, "Jump: Pad A, lower");
    assert!(
        told(
            &Hints {
                by_pad: true,
                ..Hints::default()
            },
            true
        )
        .contains("right stick")
    );
    assert_eq!(PadButton::South.name(), "pad-south");
}

#[test]
fn every_language_names_the_keys_in_every_hint() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        let mut hints = Hints::default();
        for lesson in Lesson::ALL {
            hints.rest_s = 0.0;
            let model = hints.model(&texts, &Profiles::default(), true).unwrap();
            let action = match lesson {
                Lesson::Look => None,
                Lesson::Walk => Some(Action::Right),
                Lesson::Jump => Some(Action::Jump),
                Lesson::Dig => Some(Action::Use),
                Lesson::Build => Some(Action::SecondUse),
                Lesson::Curve => Some(Action::DialDown),
                Lesson::Backpack => Some(Action::Backpack),
                Lesson::Menu => Some(Action::Menu),
            };
            let key = action.map_or_else(
                || texts.say("key-Mouse"),
                |action| first_input_label(&texts, &Profiles::default(), action),
            );
            assert!(model.text.contains(&key), "{language:?}: {}", model.text);
            assert!(model.footer.contains('N') && model.footer.contains('8'));
            hints.finish(lesson);
        }
    }
}
