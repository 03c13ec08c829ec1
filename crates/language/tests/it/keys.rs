//! The keys in the program beside those in the locale files: every one that is asked for exists, and every one that
//! exists is asked for.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::{Messages, messages, messages_of, root};
use crate::tokens::Token;
use antipode_language::Language;

/// What a source file does with keys.
#[derive(Debug, Default)]
struct Uses {
    /// Keys written out where they are asked for.
    asked: BTreeSet<String>,
    /// Prefixes of keys made at run time where they are asked for, hyphen included.
    prefixes: BTreeSet<String>,
    /// Prefixes of strings made at run time anywhere, which may be keys.
    made: BTreeSet<String>,
    /// Every string that could be a key.
    strings: BTreeSet<String>,
}

impl Uses {
    /// Adds those of a source file, without its tests.
    fn add(&mut self, source: &str) {
        let tokens = crate::tokens::without_tests(crate::tokens::of(source));
        for text in tokens.iter().filter_map(Token::text) {
            self.strings.insert(text.to_owned());
            if let Some((prefix, hole)) = text.split_once("-{")
                && hole.find('}') == Some(hole.len() - 1)
            {
                self.made.insert(format!("{prefix}-"));
            }
        }
        for (index, window) in tokens.windows(4).enumerate() {
            let [of, Token::Mark('.'), Token::Word(name), Token::Mark('(')] = window else {
                continue;
            };
            if name != "say" && name != "say_with" {
                continue;
            }
            // Others may have something to say too; what is no key is no mistake there.
            let surely = *of == Token::Word("texts".to_owned());
            for text in first_argument(&tokens[index + 4..]) {
                if surely || is_key(text) {
                    self.ask(text);
                }
            }
        }
    }

    fn ask(&mut self, text: &str) {
        match text.split_once('{') {
            None => self.asked.insert(text.to_owned()),
            Some((prefix, _)) => self.prefixes.insert(prefix.to_owned()),
        };
    }

    /// What does not fit together, in words.
    fn faults(&self, english: &Messages) -> Vec<String> {
        let mut faults = Vec::new();
        for key in self.asked.iter().filter(|key| !english.contains_key(*key)) {
            faults.push(format!("{key} is asked for and does not exist"));
        }
        for prefix in &self.prefixes {
            if !prefix.ends_with('-') || !english.keys().any(|key| key.starts_with(prefix)) {
                faults.push(format!("no key begins with {prefix} and a hyphen"));
            }
        }
        let taken_in: BTreeSet<_> = english.values().flat_map(|m| &m.messages).collect();
        for key in english.keys() {
            let made = self.made.iter().any(|prefix| key.starts_with(prefix));
            if !made && !self.strings.contains(key) && !taken_in.contains(key) {
                faults.push(format!("{key} exists and is never asked for"));
            }
        }
        faults
    }
}

/// Whether a message may have this key.
fn is_key(text: &str) -> bool {
    let part = |c: char| c.is_ascii_alphanumeric() || c == '-';
    text.starts_with(|c: char| c.is_ascii_alphabetic()) && text.chars().all(part)
}

/// The strings in the first argument of a call whose bracket has just been opened.
fn first_argument(tokens: &[Token]) -> impl Iterator<Item = &str> {
    let mut depth = 0;
    let end = tokens.iter().position(|token| {
        match token {
            Token::Mark('(' | '[' | '{') => depth += 1,
            Token::Mark(')' | ']' | '}') => depth -= 1,
            Token::Mark(',') if depth == 0 => return true,
            _ => {}
        }
        depth < 0
    });
    tokens[..end.unwrap_or(tokens.len())]
        .iter()
        .filter_map(Token::text)
}

/// Every Rust source of the program; this crate asks for no key, and tests are no part of it.
fn sources(dir: &Path, into: &mut Vec<PathBuf>) {
    for entry in dir.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() {
            if !["tests", "benches", "examples", "language", "target"].contains(&name) {
                sources(&path, into);
            }
        } else if path.extension().is_some_and(|end| end == "rs") && name != "tests.rs" {
            into.push(path);
        }
    }
}

#[test]
fn every_key_that_is_asked_for_exists_and_the_other_way_round() {
    let mut paths = Vec::new();
    sources(&root().join("crates"), &mut paths);
    assert!(paths.len() > 50, "the sources were not found");
    let mut uses = Uses::default();
    for path in paths {
        uses.add(&fs::read_to_string(path).unwrap());
    }
    assert!(uses.asked.len() > 50, "{:?}", uses.asked);
    assert_eq!(
        uses.faults(&messages(Language::English)),
        Vec::<String>::new()
    );
}

#[test]
fn what_does_not_fit_together_is_found() {
    let english = messages_of(
        "one = 1\ntwo = 2\nkey-a = A\nkey-b = { three }\nnine-a = A\nthree = 3\nfour = 4",
    );
    let mut uses = Uses::default();
    uses.add(
        r#"
        fn a(texts: &Texts, id: &str) {
            texts.say_with("one", &[("five", 5.into())]); // texts.say("six")
            texts
                .say(match id { _ => "seven", });
            texts.say(&format!("key-{id}"));
            texts.say(&format!("eight-{id}"));
            let later = "four";
            view.say("Not a key");
            texts.say("No key either");
            let made = format!("nine-{id}");
        }
        #[cfg(test)]
        mod tests { fn b() { texts.say("two"); texts.say("nine") } }
        "#,
    );
    assert_eq!(
        uses.faults(&english),
        [
            "No key either is asked for and does not exist",
            "seven is asked for and does not exist",
            "no key begins with eight- and a hyphen",
            "two exists and is never asked for",
        ]
    );
}
