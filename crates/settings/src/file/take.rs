//! Reads settings from a file's values: updates older schemas and checks every value.

use std::collections::BTreeSet;

use ron::Value;

use super::notice::Notice;
use super::raw::{self, Raw, RawProfile};
use super::{MAX_BYTES, SCHEMA};
use crate::Config;
use crate::action::Action;
use crate::field::{Given, field};
use crate::input::Input;
use crate::lesson::Lesson;
use crate::settings::Settings;

/// Most notices of single values; a file that is all wrong need not be told line by line.
const MOST_NOTICES: usize = 40;
/// Longest text that says how panes lie, bytes.
const MOST_PANES: usize = 2000;
/// Most characters that are quoted from a file.
const MOST_QUOTED: usize = 60;

/// What kind of file it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Of this version.
    Sound,
    /// Not RON, torn, or too long.
    Damaged,
    /// Of an older schema.
    Older,
    /// Of a newer schema.
    Newer,
}

/// What a file has come to.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The settings; defaults where the file says nothing that can be used.
    pub config: Config,
    /// What kind of file it was.
    pub condition: Condition,
    /// The single values that could not be used.
    pub notices: Vec<Notice>,
}

/// Reads a file's bytes, whatever they are.
pub fn read(bytes: &[u8]) -> Reading {
    let text = String::from_utf8_lossy(bytes);
    let too_long = bytes.len() as u64 > MAX_BYTES;
    let whole = if too_long { None } else { raw::whole(&text) };
    let damaged = whole.is_none();
    let mut raw = whole.unwrap_or_else(|| {
        if too_long {
            Raw::default()
        } else {
            raw::lines(&text)
        }
    });
    let schema = raw
        .schema
        .take()
        .map_or(Some(0), |value| whole_number(&value));
    let condition = match schema {
        _ if damaged => Condition::Damaged,
        None => Condition::Damaged,
        Some(SCHEMA) => Condition::Sound,
        Some(older) if older < SCHEMA => Condition::Older,
        Some(_) => Condition::Newer,
    };
    if condition == Condition::Older {
        migrate(&mut raw, schema.unwrap_or(SCHEMA));
    }
    let mut config = Config::default();
    let mut notices = Vec::new();
    take_settings(&mut config.settings, &raw.settings, &mut notices);
    take_profiles(&mut config, &raw, &mut notices);
    config.learnt = learnt(raw.learnt.as_ref());
    config.panes = panes(raw.panes.as_ref());
    config.taught_to_build = raw.taught_to_build == Some(Value::Bool(true));
    notices.extend(raw.others.iter().map(|(name, _)| unknown(name)));
    notices.truncate(MOST_NOTICES);
    Reading {
        config,
        condition,
        notices,
    }
}

/// Brings a file up to date, one schema after another.
fn migrate(raw: &mut Raw, from: u32) {
    let steps: [fn(&mut Raw); SCHEMA as usize] = [from_0_to_1];
    for step in steps.iter().skip(from as usize) {
        step(raw);
    }
}

/// Schema 0 had no number, no sections and underscores in names, as somebody writes it by hand.
fn from_0_to_1(raw: &mut Raw) {
    let flat = raw
        .others
        .drain(..)
        .map(|(name, value)| (name.replace('_', "-"), value));
    raw.settings.extend(flat);
}

fn take_settings(settings: &mut Settings, said: &[(String, Value)], notices: &mut Vec<Notice>) {
    for (name, value) in said {
        let Some(field) = field(name) else {
            notices.push(unknown(name));
            continue;
        };
        let taken = given(value).is_some_and(|given| field.assign(settings, given).is_ok());
        if !taken {
            notices.push(Notice::Value {
                id: field.id,
                given: quoted(value),
            });
        }
    }
}

/// The lessons of a list. One that is unknown only means that a hint comes once more, and nobody needs to hear of it.
fn learnt(said: Option<&Value>) -> BTreeSet<Lesson> {
    let Some(Value::Seq(said)) = said else {
        return BTreeSet::new();
    };
    let named = said.iter().filter_map(|one| match one {
        Value::String(name) => Lesson::from_id(name),
        _ => None,
    });
    named.collect()
}

/// How panes lie. Whoever draws them sees whether that can be.
fn panes(said: Option<&Value>) -> String {
    match said {
        Some(Value::String(text)) if text.len() <= MOST_PANES => text.clone(),
        _ => String::new(),
    }
}

fn take_profiles(config: &mut Config, raw: &Raw, notices: &mut Vec<Notice>) {
    let mut first = true;
    for profile in &raw.profiles {
        let name = match &profile.name {
            Some(Value::String(name)) => name.as_str(),
            _ => "",
        };
        match config.profiles.take_in(name, first) {
            Ok(own) => {
                first = false;
                take_keys(profile, |action, inputs| own.put(action, inputs), notices);
            }
            Err(why) => notices.push(Notice::Profile {
                name: shortened(name),
                why,
            }),
        }
    }
    let Some(chosen) = &raw.chosen else { return };
    let place = config
        .profiles
        .all()
        .iter()
        .position(|profile| matches!(chosen, Value::String(name) if name == profile.name()));
    if !place.is_some_and(|place| config.profiles.choose(place)) {
        notices.push(Notice::Unknown {
            name: quoted(chosen),
        });
    }
}

fn take_keys(
    profile: &RawProfile,
    mut put: impl FnMut(Action, &[Input]),
    notices: &mut Vec<Notice>,
) {
    for (id, value) in &profile.keys {
        let Some(action) = Action::named(id) else {
            notices.push(unknown(id));
            continue;
        };
        let wrong = |value: &Value| Notice::Input {
            action: action.info().id,
            given: quoted(value),
        };
        let Value::Seq(said) = value else {
            notices.push(wrong(value));
            continue;
        };
        let mut inputs = Vec::new();
        for one in said {
            let named = match one {
                Value::String(name) => Input::named(name),
                _ => None,
            };
            match named {
                Some(input) => inputs.push(input),
                None => notices.push(wrong(one)),
            }
        }
        // Where nothing of a list is known its defaults are worth more than no key at all.
        if !inputs.is_empty() || said.is_empty() {
            put(action, &inputs);
        }
    }
    notices.extend(profile.others.iter().map(|(name, _)| unknown(name)));
}

fn given(value: &Value) -> Option<Given<'_>> {
    match value {
        Value::Bool(on) => Some(Given::Switch(*on)),
        Value::Number(number) => Some(Given::Number(number.into_f64())),
        Value::String(word) => Some(Given::Word(word)),
        _ => None,
    }
}

fn whole_number(value: &Value) -> Option<u32> {
    let Value::Number(number) = value else {
        return None;
    };
    let number = number.into_f64();
    (number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number))
        .then_some(number as u32)
}

fn unknown(name: &str) -> Notice {
    Notice::Unknown {
        name: shortened(name),
    }
}

fn quoted(value: &Value) -> String {
    shortened(&match value {
        Value::Bool(on) => on.to_string(),
        Value::Number(number) => number.into_f64().to_string(),
        Value::String(word) => format!("\"{word}\""),
        other => ron::to_string(other).unwrap_or_default(),
    })
}

/// One line of at most so many characters.
fn shortened(text: &str) -> String {
    let line = text.chars().map(|c| if c.is_control() { ' ' } else { c });
    let mut short: String = line.take(MOST_QUOTED).collect();
    if text.chars().nth(MOST_QUOTED).is_some() {
        short.push('…');
    }
    short
}
