//! Which hints a newcomer is given, in which order, and what ends them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use antipode_language::Language;
use antipode_settings::PadButton;

use super::*;
use crate::bindings::Input;

/// A hyperbolic world.
const DIAL: HintContext = HintContext {
    has_dial: true,
    only_view: false,
    closed: false,
    square: None,
    gathering: false,
    dark: false,
    answered: false,
    drives: false,
    pitch_rad: 0.0,
};
/// A flat one, unbent, and a closed one.
const FLAT: HintContext = HintContext {
    has_dial: false,
    ..DIAL
};
const CLOSED: HintContext = HintContext {
    only_view: true,
    closed: true,
    gathering: false,
    ..FLAT
};

/// One in squares.
const SQUARES: HintContext = HintContext {
    only_view: true,
    square: Some(ChartId::FIRST),
    ..FLAT
};

/// How long a hint that is only to be read is shown, seconds.
const READ_S: f64 = 15.0;

fn told(hints: &Hints, context: HintContext) -> String {
    let model = hints.model(&Texts::default(), &Profiles::default(), context);
    model.map_or_else(String::new, |model| {
        format!("{} | {}", model.text, model.footer)
    })
}

/// Whoever is talked to answers here, and every car can be got into.
fn pass(hints: &mut Hints, actions: &Actions, time_s: f64) {
    let context = HintContext {
        answered: actions.talk,
        drives: actions.enter_car,
        ..DIAL
    };
    for _ in 0..(time_s / STEP_S).round() as u32 {
        hints.step(actions, context);
    }
}

/// What teaches each lesson, for long enough.
fn lessons() -> [Actions; 10] {
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
            talk: true,
            ..actions
        },
        Actions {
            enter_car: true,
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
        Actions {
            turn_map: true,
            ..actions
        },
        Actions {
            toggle_camera: true,
            ..actions
        },
    ]
}

#[test]
fn each_hint_goes_when_it_was_done_and_the_next_one_comes() {
    let mut hints = Hints::default();
    let words = [
        "Look around: Mouse | 1 of 13 · skip: N",
        "Walk: W A S D | 2 of 13 · skip: N",
        "Jump: Space | 3 of 13 · skip: N",
        "Talk to somebody ahead: T | 4 of 13 · skip: N",
        "Get into a car, close by: C | 5 of 13 · skip: N",
        "Dig, held down: Left button | 6 of 13 · skip: N",
        "Build, held down: Right button | 7 of 13 · skip: N",
        "Change how space is pictured: Wheel up and Wheel down | 8 of 13 · skip: N",
        "Change to the other picture of this space: H | 9 of 13 · skip: N",
        "See yourself from behind, and back: Tab | 10 of 13 · skip: N",
    ];
    for (words, actions) in words.iter().zip(lessons()) {
        assert_eq!(told(&hints, DIAL), *words);
        pass(&mut hints, &Actions::default(), 5.0);
        assert_eq!(told(&hints, DIAL), *words, "waiting is not doing");
        pass(&mut hints, &actions, 1.0);
        pass(&mut hints, &Actions::default(), REST_S);
    }
    assert!(told(&hints, DIAL).starts_with("Open the backpack: E | 11 of 13"));
    hints.finish(Lesson::Backpack);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, DIAL).starts_with("Take pictures: P"));
    hints.finish(Lesson::Photo);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, DIAL).starts_with("Pause"));
    hints.finish(Lesson::Menu);
    assert_eq!(hints.current(DIAL), None);
}

#[test]
fn a_corner_is_rounded_by_five_squares_and_not_by_going_to_and_fro() {
    let is_done_by = |way: &[u128]| {
        let mut hints = Hints::default();
        for number in way {
            let square = Some(ChartId::new(*number));
            let context = HintContext { square, ..SQUARES };
            hints.step(&Actions::default(), context);
            hints.step(&Actions::default(), context);
        }
        hints.learnt().contains(&Lesson::Corner)
    };
    assert!(is_done_by(&[0, 1, 2, 3, 4, 0]));
    assert!(
        is_done_by(&[9, 0, 1, 7, 1, 2, 3, 4, 0]),
        "a step aside counts for nothing"
    );
    assert!(!is_done_by(&[0, 1, 2, 3, 4, 5]));
    assert!(!is_done_by(&[0, 1, 2, 3, 2, 1, 0]));
    assert!(!is_done_by(&[0, 1, 0, 1, 0, 1, 0]));
}

#[test]
fn who_goes_round_a_corner_is_told_how_many_squares_and_that_he_is_back() {
    let mut hints = Hints::default();
    for lesson in Lesson::ALL {
        if !matches!(lesson, Lesson::Corner | Lesson::Menu) {
            hints.finish(lesson);
        }
    }
    hints.rest_s = 0.0;
    let mut at = SQUARES;
    for (gone, number) in [0, 1, 2, 3, 4].into_iter().enumerate() {
        at.square = Some(ChartId::new(number));
        hints.step(&Actions::default(), at);
        let said = told(&hints, at);
        assert!(said.contains(&format!("Gone through: {gone} ")), "{said}");
    }
    for _ in 0..2 {
        hints.step(
            &Actions::default(),
            HintContext {
                square: Some(ChartId::new(0)),
                ..at
            },
        );
        assert!(told(&hints, at).starts_with("Five squares, and you are back."));
    }
    pass(&mut hints, &Actions::default(), BACK_S + 0.1);
    assert!(
        told(&hints, at).starts_with("Pause"),
        "{}",
        told(&hints, at)
    );
}

#[test]
fn what_a_world_has_not_is_not_told_and_not_counted() {
    let hints = Hints::default();
    for (context, count) in [(FLAT, 12), (DIAL, 13), (CLOSED, 13), (SQUARES, 12)] {
        assert!(told(&hints, context).contains(&format!("1 of {count}")));
        let has = |lesson| context.has(lesson);
        assert_eq!(has(Lesson::Curve), context == DIAL);
        assert_eq!(has(Lesson::Map), !context.only_view);
        assert_eq!(
            has(Lesson::Overhead) && has(Lesson::Home),
            context == CLOSED
        );
        assert_eq!(has(Lesson::Corner), context == SQUARES);
    }
}

#[test]
fn in_a_closed_world_one_is_told_to_look_up_and_to_walk_straight_on_until_one_is_home() {
    let mut hints = Hints::default();
    for lesson in [Lesson::Look, Lesson::Walk, Lesson::Jump] {
        hints.finish(lesson);
    }
    hints.rest_s = 0.0;
    assert!(told(&hints, CLOSED).starts_with("Look up"));
    let up = HintContext {
        pitch_rad: 1.0,
        ..CLOSED
    };
    hints.step(&Actions::default(), up);
    assert_eq!(hints.current(CLOSED).map(|it| it.0), Some(Lesson::Talk));
    for lesson in Lesson::ALL {
        if !matches!(lesson, Lesson::Home | Lesson::Menu) {
            hints.finish(lesson);
        }
    }
    hints.rest_s = 0.0;
    assert!(told(&hints, CLOSED).starts_with("Walk straight on"));
    for _ in 0..(1.1 * READ_S / STEP_S) as u32 {
        hints.step(&Actions::default(), CLOSED);
    }
    assert_eq!(hints.current(CLOSED).map(|it| it.0), Some(Lesson::Menu));
}

#[test]
fn who_skips_the_way_home_has_all_the_time_to_read_of_the_menu() {
    let mut hints = Hints::default();
    for lesson in Lesson::ALL {
        if !matches!(lesson, Lesson::Home | Lesson::Menu) {
            hints.finish(lesson);
        }
    }
    let pass = |hints: &mut Hints, time_s: f64| {
        for _ in 0..(time_s / STEP_S) as u32 {
            hints.step(&Actions::default(), CLOSED);
        }
    };
    pass(&mut hints, 0.9 * READ_S);
    hints.finish(Lesson::Home);
    pass(&mut hints, 0.9 * READ_S);
    assert_eq!(hints.current(CLOSED).map(|it| it.0), Some(Lesson::Menu));
}

#[test]
fn the_last_hint_goes_when_it_was_there_long_enough_and_no_other_does() {
    let mut hints = Hints::default();
    pass(&mut hints, &Actions::default(), 10.0 * READ_S);
    assert!(
        told(&hints, DIAL).contains("1 of 13"),
        "that is not the last"
    );
    for lesson in Lesson::ALL {
        if lesson != Lesson::Menu {
            hints.finish(lesson);
        }
    }
    pass(&mut hints, &Actions::default(), 0.9 * READ_S);
    assert!(told(&hints, DIAL).starts_with("Pause"));
    pass(&mut hints, &Actions::default(), 0.2 * READ_S);
    assert_eq!(hints.current(DIAL), None);
}

#[test]
fn of_the_flashlight_is_told_where_it_is_dark_until_it_was_switched() {
    let mut hints = Hints::default();
    hints.finish(Lesson::Look);
    hints.finish(Lesson::Walk);
    hints.finish(Lesson::Jump);
    hints.rest_s = 0.0;
    let dark = HintContext { dark: true, ..DIAL };
    assert!(told(&hints, DIAL).starts_with("Talk"));
    assert!(told(&hints, dark).starts_with("It is dark. Flashlight: Y | 4 of 14"));
    // Who has gone on since is told of it with a number that does not go back.
    let mut later = Hints::default();
    for lesson in Lesson::ALL {
        if !matches!(lesson, Lesson::Light | Lesson::Menu) {
            later.finish(lesson);
        }
    }
    later.rest_s = 0.0;
    assert!(told(&later, DIAL).contains("13 of 13"));
    assert!(told(&later, dark).contains("13 of 14"));
    let switch = Actions {
        toggle_light: true,
        ..Actions::default()
    };
    hints.step(&switch, dark);
    hints.rest_s = 0.0;
    assert!(told(&hints, dark).starts_with("Talk"));
}

#[test]
fn what_was_done_before_its_turn_is_not_asked_for() {
    let mut hints = Hints::default();
    pass(&mut hints, &lessons()[1], 1.0);
    pass(&mut hints, &lessons()[0], 1.0);
    pass(&mut hints, &Actions::default(), REST_S);
    assert!(told(&hints, DIAL).starts_with("Jump"));
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
    let model = hints.model(&texts, &profiles, DIAL).unwrap();
    assert_eq!(
        (model.text.as_str(), model.footer.as_str()),
        ("Jump: J", "3 of 13")
    );
    hints.use_pad(true);
    let model = hints.model(&texts, &profiles, DIAL).unwrap();
    assert_eq!(model.text, "Jump: Pad A, lower");
    assert!(
        told(
            &Hints {
                by_pad: true,
                ..Hints::default()
            },
            DIAL
        )
        .contains("right stick")
    );
    assert_eq!(PadButton::South.id(), "pad-south");
}

#[test]
fn every_language_names_the_keys_in_every_hint() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        let hints = Hints::default();
        let profiles = Profiles::default();
        let key = |action| first_input_label(&texts, &profiles, action);
        for lesson in Lesson::ALL {
            let action = match lesson {
                Lesson::Look | Lesson::Overhead | Lesson::Home => None,
                Lesson::Corner => Some(Action::LargeMap),
                Lesson::Walk => Some(Action::Right),
                Lesson::Jump => Some(Action::Jump),
                Lesson::Talk => Some(Action::Talk),
                Lesson::Car => Some(Action::EnterCar),
                Lesson::Dig => Some(Action::Use),
                Lesson::Build => Some(Action::SecondUse),
                Lesson::Curve => Some(Action::DialDown),
                Lesson::Map => Some(Action::OtherMap),
                Lesson::Camera => Some(Action::Camera),
                Lesson::Light => Some(Action::Flashlight),
                Lesson::Make | Lesson::Backpack => Some(Action::Backpack),
                Lesson::Photo => Some(Action::PhotoMode),
                Lesson::Menu => Some(Action::Menu),
            };
            let words = hints.words(&texts, lesson, key);
            let named = action.map_or_else(String::new, key);
            assert!(words.contains(&named), "{language:?}: {words}");
            assert!(words.chars().count() >= 4, "{language:?} {lesson:?}");
        }
        let model = hints.model(&texts, &profiles, DIAL).unwrap();
        assert!(model.text.contains(&texts.say("key-Mouse")));
        assert!(model.footer.contains('N') && model.footer.contains("13"));
    }
}

#[test]
fn who_talks_to_nobody_and_gets_into_no_car_has_not_learnt_it() {
    let mut hints = Hints::default();
    let tries = Actions {
        talk: true,
        enter_car: true,
        ..Actions::default()
    };
    hints.step(&tries, DIAL);
    assert!(hints.learnt().is_empty(), "{:?}", hints.learnt());
    pass(&mut hints, &tries, STEP_S);
    assert_eq!(hints.learnt().len(), 2, "{:?}", hints.learnt());
}
