//! The locale files beside one another: all can be read, English and Polish say the same, and no other language
//! says what English does not.

use std::collections::BTreeSet;

use crate::common::{Messages, messages, messages_of};
use antipode_language::{Language, Texts};

/// What differs between two languages, in words: keys that only one has, and arguments that differ.
fn differences(one: &Messages, other: &Messages) -> Vec<String> {
    let lacks = |these: &Messages, those: &Messages, whose: &str| -> Vec<String> {
        let missing = these.keys().filter(|key| !those.contains_key(*key));
        missing.map(|key| format!("{key} is {whose}")).collect()
    };
    let mut found = lacks(one, other, "missing");
    found.extend(lacks(other, one, "unknown"));
    for (key, message) in one {
        if let Some(translated) = other.get(key)
            && translated.arguments != message.arguments
        {
            found.push(format!(
                "{key} has the arguments {:?}, not {:?}",
                translated.arguments, message.arguments
            ));
        }
    }
    found
}

#[test]
fn every_language_can_be_read_and_names_no_message_twice() {
    for language in Language::ALL {
        assert_eq!(
            crate::common::faults(language),
            Vec::<String>::new(),
            "{language:?}"
        );
        let texts = Texts::new(language);
        for key in messages(language).keys() {
            assert!(texts.has_own(key), "{key} of {language:?}");
        }
    }
}

#[test]
fn polish_says_everything_that_english_says_with_the_same_values() {
    let found = differences(&messages(Language::English), &messages(Language::Polish));
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn the_other_languages_say_nothing_that_english_does_not() {
    let english = messages(Language::English);
    for language in [Language::Spanish, Language::German, Language::Chinese] {
        let found = differences(&english, &messages(language));
        let (missing, wrong): (Vec<_>, Vec<_>) = found
            .into_iter()
            .partition(|difference| difference.ends_with(" is missing"));
        println!("{language:?}: {} missing: {missing:#?}", missing.len());
        assert_eq!(wrong, Vec::<String>::new(), "{language:?}");
    }
}

#[test]
fn a_plural_form_for_every_way_a_language_counts() {
    // CLDR's categories for whole numbers; `other` is the default of a selector in Polish.
    let forms = |language| match language {
        Language::English | Language::Spanish | Language::German => vec!["one"],
        Language::Polish => vec!["few", "one"],
        Language::Chinese => vec![],
    };
    for language in Language::ALL {
        for (key, message) in messages(language) {
            for selected in &message.plurals {
                let has = |form: &str| selected.contains(form);
                let lacks: Vec<_> = forms(language)
                    .into_iter()
                    .filter(|form| !has(form))
                    .collect();
                assert!(lacks.is_empty(), "{key} of {language:?} lacks {lacks:?}");
            }
        }
    }
}

#[test]
fn differences_are_found() {
    let one = messages_of("a = A { $x }\nb = B\nc = { $n ->\n [one] x\n*[other] { $y }\n}");
    let other = messages_of("a = A { $z }\nc = { $n } { $y }\nd = D");
    assert_eq!(
        differences(&one, &other),
        [
            "b is missing",
            "d is unknown",
            "a has the arguments {\"z\"}, not {\"x\"}"
        ]
    );
    assert_eq!(
        one["c"].plurals,
        [BTreeSet::from(["one".to_owned(), "other".to_owned()])]
    );
}
