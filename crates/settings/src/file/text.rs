//! The file's text: one thing a line, so that a damaged file can be read line by line.

use ron::ser::PrettyConfig;
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::SCHEMA;
use crate::Config;
use crate::action::actions;
use crate::field::{Kind, Value, fields};
use crate::profile::Profile;
use crate::settings::Settings;

const HEADING: &str = "// Antipode's settings, written by the game. Each line may be changed or deleted by hand while the\n\
                       // game is not running; what is not here, or cannot be read, is as it comes.\n";

#[derive(serde::Serialize)]
struct File<'a> {
    schema: u32,
    settings: AllSettings<'a>,
    /// Names of lessons; before the profiles, so that it is no list of one's keys in a damaged file.
    learnt: Vec<&'static str>,
    /// How the panes of the workshop lie.
    panes: &'a str,
    taught_to_build: bool,
    profile: &'a str,
    profiles: Vec<OneProfile<'a>>,
}

#[derive(serde::Serialize)]
struct OneProfile<'a> {
    name: &'a str,
    keys: AllKeys<'a>,
}

struct AllSettings<'a>(&'a Settings);
struct AllKeys<'a>(&'a Profile);

/// The file's text.
///
/// # Errors
/// In words, should the writer of RON fail.
pub fn write(config: &Config) -> Result<String, String> {
    let profiles = &config.profiles;
    let file = File {
        schema: SCHEMA,
        settings: AllSettings(&config.settings),
        learnt: config.learnt.iter().map(|lesson| lesson.id()).collect(),
        panes: &config.panes,
        taught_to_build: config.taught_to_build,
        profile: profiles.chosen().name(),
        profiles: profiles
            .all()
            .iter()
            .map(|profile| OneProfile {
                name: profile.name(),
                keys: AllKeys(profile),
            })
            .collect(),
    };
    let style = PrettyConfig::new().compact_arrays(true).new_line("\n");
    ron::ser::to_string_pretty(&file, style)
        .map(|text| format!("{HEADING}{text}\n"))
        .map_err(|error| error.to_string())
}

impl Serialize for AllSettings<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(fields().len()))?;
        for field in fields() {
            let whole = matches!(field.kind, Kind::Slider { whole: true, .. });
            match field.value(self.0) {
                Value::Switch(on) => map.serialize_entry(field.id, &on)?,
                Value::Number(number) if whole => {
                    map.serialize_entry(field.id, &(number as i64))?;
                }
                Value::Number(number) => map.serialize_entry(field.id, &number)?,
                Value::Choice(word) => map.serialize_entry(field.id, word)?,
            }
        }
        map.end()
    }
}

impl Serialize for AllKeys<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(actions().len()))?;
        for info in actions() {
            let names: Vec<_> = self
                .0
                .inputs(info.action)
                .iter()
                .map(|i| i.name())
                .collect();
            map.serialize_entry(info.id, &names)?;
        }
        map.end()
    }
}
