//! The messages of one language, and English behind them.

use std::borrow::Cow;
use std::collections::HashSet;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use unic_langid::LanguageIdentifier;

use crate::locales::files;
use crate::value::{with_comma, with_point};
use crate::{Language, Value};

type Bundle = FluentBundle<FluentResource>;

/// The messages of one language; a copy is cheap and shares them.
#[derive(Clone)]
pub struct Texts(Arc<Inner>);

struct Inner {
    language: Language,
    own: Bundle,
    /// `None` where the language is English itself.
    english: Option<Bundle>,
    /// Keys whose gaps and faults are in the log already; messages are asked for every frame.
    told: Mutex<HashSet<String>>,
}

impl fmt::Debug for Texts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Texts").field(&self.0.language).finish()
    }
}

impl Default for Texts {
    fn default() -> Self {
        Self::new(Language::default())
    }
}

impl PartialEq for Texts {
    fn eq(&self, other: &Self) -> bool {
        self.0.language == other.0.language
    }
}

impl Texts {
    /// The messages of a language. Reads them anew, which takes milliseconds: keep them, or a copy.
    pub fn new(language: Language) -> Self {
        let of = |language| bundle(language, files(language));
        let english = (language != Language::English).then(|| of(Language::English));
        Self::of(language, of(language), english)
    }

    fn of(language: Language, own: Bundle, english: Option<Bundle>) -> Self {
        Self(Arc::new(Inner {
            language,
            own,
            english,
            told: Mutex::default(),
        }))
    }

    /// The language they are in.
    pub fn language(&self) -> Language {
        self.0.language
    }

    /// Whether there is a message of that key, be it in English.
    pub fn has(&self, key: &str) -> bool {
        self.0.bundles().any(|bundle| bundle.has_message(key))
    }

    /// Whether the language itself has a message of that key, English not asked.
    pub fn has_own(&self, key: &str) -> bool {
        self.0.own.has_message(key)
    }

    /// The message of that key; in English where the language lacks it, and the key itself where that does too.
    pub fn say(&self, key: &str) -> String {
        self.say_with(key, &[])
    }

    /// The message of that key with these values in place of `{ $name }`, numbers in the language's manner.
    pub fn say_with(&self, key: &str, values: &[(&str, Value<'_>)]) -> String {
        let mut args = FluentArgs::with_capacity(values.len());
        for (name, value) in values {
            args.set(Cow::Borrowed(*name), FluentValue::from(value));
        }
        for bundle in self.0.bundles() {
            let message = bundle.get_message(key);
            let Some(pattern) = message.and_then(|message| message.value()) else {
                self.0.tell(key, "is missing");
                continue;
            };
            let mut errors = Vec::new();
            let text = bundle.format_pattern(pattern, Some(&args), &mut errors);
            if let Some(error) = errors.first() {
                self.0.tell(key, &format!("is faulty: {error}"));
            }
            return text.into_owned();
        }
        key.to_owned()
    }

    /// A number by itself, rounded to so many digits (at most 6) behind the language's decimal mark.
    pub fn number(&self, number: f64, digits: usize) -> String {
        Value::decimals(number, digits).write(mark(self.0.language))
    }

    /// A number that was written with a decimal point, with the language's own mark.
    pub fn marked(&self, number: &str) -> String {
        number.replace('.', mark(self.0.language).encode_utf8(&mut [0; 4]))
    }

    /// What stands between numbers in a row: a comma, unless that is in the numbers already.
    pub fn between_numbers(&self) -> &'static str {
        match mark(self.0.language) {
            ',' => "; ",
            _ => ", ",
        }
    }
}

/// What stands between whole and part of a number.
fn mark(language: Language) -> char {
    match language {
        Language::English | Language::Chinese => '.',
        Language::Polish | Language::Spanish | Language::German => ',',
    }
}

impl Inner {
    /// Where a message is looked for, in this order.
    fn bundles(&self) -> impl Iterator<Item = &Bundle> {
        std::iter::once(&self.own).chain(&self.english)
    }

    fn tell(&self, key: &str, what: &str) {
        let mut told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        if told.insert(key.to_owned()) {
            tracing::warn!("the text \"{key}\" of {:?} {what}", self.language);
        }
    }
}

/// The messages of these files, each a path to name it by and its contents.
fn bundle(language: Language, files: &[(&str, &str)]) -> Bundle {
    let locale: LanguageIdentifier = language.id().parse().unwrap_or_default();
    let mut bundle = FluentBundle::new_concurrent(vec![locale]);
    // The marks round values are for mixed directions of writing, which no language here has.
    bundle.set_use_isolating(false);
    bundle.set_formatter(Some(match mark(language) {
        ',' => with_comma,
        _ => with_point,
    }));
    for (path, source) in files {
        let resource = FluentResource::try_new((*source).to_owned());
        let resource = resource.unwrap_or_else(|(rest, errors)| {
            tracing::error!("{path} is faulty: {errors:?}");
            rest
        });
        if let Err(errors) = bundle.add_resource(resource) {
            tracing::error!("{path} is faulty: {errors:?}");
        }
    }
    bundle
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(language: Language, own: &str, english: &str) -> Texts {
        let of = |language, source| bundle(language, &[("a test", source)]);
        Texts::of(
            language,
            of(language, own),
            Some(of(Language::English, english)),
        )
    }

    const CHUNKS: &str = "chunks = { $count ->
    [one] { $count } blok
    [few] { $count } bloki
    [many] { $count } bloków
   *[other] { $count } bloku
}";

    #[test]
    fn a_gap_is_filled_in_english_and_a_gap_there_by_the_key() {
        let texts = texts(Language::Polish, "own = Swoje", "own = Own\nlent = Lent");
        assert_eq!(texts.say("own"), "Swoje");
        assert_eq!(texts.say("lent"), "Lent");
        assert_eq!(texts.say("nowhere"), "nowhere");
        assert!(texts.has("lent") && !texts.has("nowhere"));
        assert!(texts.has_own("own") && !texts.has_own("lent"));
    }

    #[test]
    fn a_faulty_file_costs_only_what_is_faulty() {
        let texts = texts(Language::German, "good = Gut\n= bad\n", "bad = Bad");
        assert_eq!(texts.say("good"), "Gut");
        assert_eq!(texts.say("bad"), "Bad");
    }

    #[test]
    fn polish_counts_in_three_ways_and_parts_in_a_fourth() {
        let texts = texts(Language::Polish, CHUNKS, "");
        let say = |count: Value<'_>| texts.say_with("chunks", &[("count", count)]);
        for (count, words) in [
            (1, "1 blok"),
            (2, "2 bloki"),
            (5, "5 bloków"),
            (12, "12 bloków"),
            (22, "22 bloki"),
            (0, "0 bloków"),
        ] {
            assert_eq!(say(count.into()), words);
        }
        assert_eq!(say(Value::decimals(1.5, 1)), "1,5 bloku");
    }

    #[test]
    fn a_number_of_its_own_is_chosen_before_the_plural_that_counts_it() {
        let counted =
            "count = { $n ->\n    [0] none\n    [1.5] one and a half\n   *[other] { $n }\n}";
        let texts = texts(Language::English, counted, "");
        let say = |n: Value<'_>| texts.say_with("count", &[("n", n)]);
        assert_eq!(say(0.into()), "none");
        assert_eq!(say(Value::decimals(-0.0, 0)), "none");
        assert_eq!(say(Value::decimals(1.5, 1)), "one and a half");
        assert_eq!(say(3.into()), "3");
    }

    #[test]
    fn a_world_that_nobody_has_changed_says_so_in_every_language() {
        for language in Language::ALL {
            let texts = Texts::new(language);
            let say = |count: usize| texts.say_with("worlds-edits", &[("count", count.into())]);
            assert!(!say(0).contains('0'), "{}", say(0));
            assert!(say(30).contains("30"), "{}", say(30));
        }
    }

    #[test]
    fn numbers_have_the_languages_decimal_mark_and_no_sign_when_they_round_to_nothing() {
        let say = |language, number, digits| {
            let texts = texts(language, "length = { $m } m", "");
            texts.say_with("length", &[("m", Value::decimals(number, digits))])
        };
        assert_eq!(say(Language::Polish, 2.5, 2), "2,50 m");
        assert_eq!(say(Language::English, -2.25, 1), "-2.2 m");
        assert_eq!(say(Language::Chinese, -0.04, 1), "0.0 m");
        assert_eq!(Texts::new(Language::German).number(0.125, 2), "0,12");
        assert_eq!(Texts::default().number(f64::NAN, 2), "NaN");
        assert_eq!(Texts::new(Language::Polish).marked("-3.20e43"), "-3,20e43");
        assert_eq!(Texts::default().marked("1.00e5"), "1.00e5");
    }

    #[test]
    fn numbers_that_no_plural_rule_can_count_are_written_all_the_same() {
        let texts = texts(Language::Polish, CHUNKS, "");
        for number in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e300] {
            let said = texts.say_with("chunks", &[("count", Value::decimals(number, 99))]);
            assert!(said.ends_with(" bloku"), "{said}");
        }
        let most = texts.say_with("chunks", &[("count", u64::MAX.into())]);
        assert_eq!(most, "18446744073709551615 bloku");
        let large = Value::decimals(999_999_999_999_999.0, 6);
        assert!(!texts.say_with("chunks", &[("count", large)]).is_empty());
        assert!(!texts.say("chunks").is_empty(), "even without its value");
    }
}
