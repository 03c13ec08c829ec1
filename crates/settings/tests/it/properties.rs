//! What holds for every file and all settings.

use antipode_settings::{
    Condition, Config, Given, Input, Kind, Lesson, MouseButton, PadButton, actions, fields, read,
    write,
};
use proptest::prelude::*;

fn input() -> impl Strategy<Value = Input> {
    prop_oneof![
        (0..Input::KEYS.len()).prop_map(|at| Input::key(Input::KEYS[at]).unwrap()),
        (0..5usize).prop_map(|at| Input::Mouse(MouseButton::ALL[at])),
        Just(Input::WheelUp),
        Just(Input::WheelDown),
        (0..PadButton::ALL.len()).prop_map(|at| Input::Pad(PadButton::ALL[at])),
    ]
}

/// Shares of each field's range, bindings to add and to take away, names of profiles.
fn config() -> impl Strategy<Value = Config> {
    let shares = prop::collection::vec(0.0..1.0, fields().len());
    let strokes = prop::collection::vec((0..actions().len(), input(), any::<bool>()), 0..40);
    let names = prop::collection::vec(".{0,45}", 0..4);
    let learnt = prop::collection::btree_set(0..Lesson::ALL.len(), 0..Lesson::ALL.len());
    let all = (shares, strokes, names, 0..5usize, learnt, ".{0,80}");
    all.prop_map(|(shares, strokes, names, chosen, learnt, panes)| {
        let mut config = Config {
            learnt: learnt.into_iter().map(|at| Lesson::ALL[at]).collect(),
            panes,
            ..Config::default()
        };
        for (field, share) in fields().iter().zip(&shares) {
            let given = match field.kind {
                Kind::Toggle => Given::Switch(*share < 0.5),
                Kind::Slider {
                    min, max, whole, ..
                } => {
                    let number = min + share * (max - min);
                    Given::Number(if whole { number.round() } else { number })
                }
                Kind::Choice { options } => {
                    Given::Word(options[(share * options.len() as f64) as usize])
                }
            };
            config.settings.set(field.id, given).unwrap();
        }
        let mut names = names.iter();
        for (place, (action, input, add)) in strokes.into_iter().enumerate() {
            let action = actions()[action].action;
            let own = config.profiles.chosen_mut();
            let _ = if add {
                own.bind(action, input)
            } else {
                own.unbind(action, input)
            };
            if place % 10 == 9 {
                let _ = names.next().map(|name| config.profiles.add(name));
            }
        }
        config.profiles.choose(chosen);
        config
    })
}

proptest! {
    #[test]
    fn every_config_comes_back_as_it_was(config in config()) {
        let text = write(&config).unwrap();
        let reading = read(text.as_bytes());
        prop_assert_eq!(&reading.config, &config, "{}", text);
        prop_assert_eq!(reading.condition, Condition::Sound);
        prop_assert!(reading.notices.is_empty(), "{:?}", reading.notices);
    }

    #[test]
    fn no_bytes_are_too_odd(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        let reading = read(&bytes);
        prop_assert!(write(&reading.config).is_ok());
    }

    /// Whatever happens to a file of ours, what comes of it is a sound config, and what is far from the damage holds.
    #[test]
    fn no_damage_is_too_odd(
        config in config(),
        at in 0.0..1.0,
        length in 0..200usize,
        into in prop::collection::vec(any::<u8>(), 0..50),
    ) {
        let mut bytes = write(&config).unwrap().into_bytes();
        let start = (at * bytes.len() as f64) as usize;
        let end = (start + length).min(bytes.len());
        bytes.splice(start..end, into);
        let reading = read(&bytes);
        let again = read(write(&reading.config).unwrap().as_bytes());
        prop_assert_eq!(again.config, reading.config);
        prop_assert!(again.notices.is_empty());
    }

    /// Brackets as deep as a file is long are refused, not followed down.
    #[test]
    fn no_depth_is_too_deep(bracket in prop::sample::select(vec!["(", "[", "{", "Some(", "{\"a\":", "/*"]), depth in 0..20_000usize) {
        let reading = read(bracket.repeat(depth).as_bytes());
        prop_assert_eq!(reading.config, Config::default());
    }

    #[test]
    fn bindings_never_lock_the_menu_away(config in config()) {
        for profile in config.profiles.all() {
            prop_assert!(!profile.inputs(antipode_settings::Action::Menu).is_empty());
        }
    }
}
