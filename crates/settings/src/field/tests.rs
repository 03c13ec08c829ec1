//! Tests of the fields: ranges, words and resets.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use super::*;

#[test]
fn every_setting_has_a_name_of_its_own_and_a_default_that_it_would_take() {
    for (place, field) in FIELDS.iter().enumerate() {
        assert!(FIELDS[place + 1..].iter().all(|other| other.id != field.id));
        let default = field.default_value();
        assert_eq!(field.checked(default.into()), Ok(default), "{}", field.id);
    }
}

#[test]
fn what_is_set_is_what_is_got_and_a_reset_touches_nothing_else() {
    for field in fields() {
        let mut settings = Settings::default();
        let other = match field.kind {
            Kind::Toggle => Given::Switch(field.default_value() != Value::Switch(true)),
            Kind::Slider { max, .. } => Given::Number(max),
            Kind::Choice { options } => {
                let at = options.len() - 1;
                let last = field.default_value() == Value::Choice(options[at]);
                Given::Word(options[if last { 0 } else { at }])
            }
        };
        settings.set(field.id, other).unwrap();
        assert_eq!(Given::from(settings.get(field)), other, "{}", field.id);
        for unchanged in fields().iter().filter(|f| f.id != field.id) {
            assert!(
                settings.is_default(unchanged),
                "{} moved with {}",
                unchanged.id,
                field.id
            );
        }
        assert!(!settings.is_default(field) && settings.reset(field.id));
        assert_eq!(settings, Settings::default());
    }
}

#[test]
fn what_does_not_fit_is_refused_in_words_and_changes_nothing() {
    let mut settings = Settings::default();
    for (id, given, says) in [
        ("field-of-view", Given::Number(39.9), "40"),
        ("field-of-view", Given::Number(f64::NAN), "40"),
        ("field-of-view", Given::Number(f64::INFINITY), "110"),
        ("field-of-view", Given::Switch(true), "numbers from 40"),
        ("view-distance", Given::Number(2.5), "whole numbers"),
        ("quality", Given::Word("best"), "fast, balanced, exact"),
        ("vsync", Given::Word("on"), "on or off"),
        ("colour-of-money", Given::Switch(true), "colour-of-money"),
    ] {
        let said = settings.set(id, given).unwrap_err().to_string();
        assert!(said.contains(says), "{said}");
    }
    assert!(!settings.reset("colour-of-money"));
    assert_eq!(settings, Settings::default());
}

#[test]
fn commands_set_by_words() {
    let mut settings = Settings::default();
    for (id, word) in [
        ("invert-look", "on"),
        ("field-of-view", "90"),
        ("msaa", "off"),
    ] {
        settings.set_word(id, word).unwrap();
        assert_eq!(settings.get(field(id).unwrap()).to_string(), word);
    }
    for (id, word) in [
        ("invert-look", "yes"),
        ("field-of-view", "wide"),
        ("field-of-view", "nan"),
        ("msaa", ""),
        ("", "on"),
    ] {
        assert!(settings.set_word(id, word).is_err(), "{id} took {word}");
    }
}

#[test]
fn land_reaches_as_far_as_the_adapter_can_unless_somebody_chose() {
    let mut settings = Settings::default();
    assert_eq!(settings.view_distance(true), 4);
    // The haze takes the last quarter of a chunk.
    assert!((f64::from(settings.view_distance(false)) - 0.25) * 32.0 >= 300.0);
    settings.preset = Preset::Software;
    assert_eq!(settings.view_distance(false), 4);
    settings.view_distance_chunks = 6;
    assert_eq!(
        (settings.view_distance(true), settings.view_distance(false)),
        (6, 6)
    );
}
