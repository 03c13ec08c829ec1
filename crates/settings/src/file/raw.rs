//! The file as it stands, before anything in it is believed: names and values, whole or line by line.

use ron::Value;

/// What a file says.
#[derive(Debug, Default)]
pub(super) struct Raw {
    pub schema: Option<Value>,
    pub settings: Vec<(String, Value)>,
    /// What was learnt.
    pub learnt: Option<Value>,
    /// How the panes of the workshop lie.
    pub panes: Option<Value>,
    /// Whether the lesson of the workshop was taken.
    pub taught_to_build: Option<Value>,
    /// The name of the profile in use.
    pub chosen: Option<Value>,
    pub profiles: Vec<RawProfile>,
    /// Whatever else stands at the top.
    pub others: Vec<(String, Value)>,
}

/// What a file says of one profile.
#[derive(Debug, Default)]
pub(super) struct RawProfile {
    pub name: Option<Value>,
    pub keys: Vec<(String, Value)>,
    pub others: Vec<(String, Value)>,
}

/// The file as a whole; `None` when it is no RON or no file of ours.
pub(super) fn whole(text: &str) -> Option<Raw> {
    let mut raw = Raw::default();
    for (name, value) in entries(ron::from_str(text).ok()?)? {
        match name.as_str() {
            "schema" => raw.schema = Some(value),
            "profile" => raw.chosen = Some(value),
            "learnt" => raw.learnt = Some(value),
            "panes" => raw.panes = Some(value),
            "taught_to_build" => raw.taught_to_build = Some(value),
            "settings" => raw.settings = entries(value)?,
            "profiles" => {
                let Value::Seq(profiles) = value else {
                    return None;
                };
                raw.profiles = profiles.into_iter().map(profile).collect::<Option<_>>()?;
            }
            _ => raw.others.push((name, value)),
        }
    }
    Some(raw)
}

fn profile(value: Value) -> Option<RawProfile> {
    let mut raw = RawProfile::default();
    for (name, value) in entries(value)? {
        match name.as_str() {
            "name" => raw.name = Some(value),
            "keys" => raw.keys = entries(value)?,
            _ => raw.others.push((name, value)),
        }
    }
    Some(raw)
}

fn entries(value: Value) -> Option<Vec<(String, Value)>> {
    let Value::Map(map) = value else { return None };
    map.into_iter()
        .map(|(name, value)| match name {
            Value::String(name) => Some((name, value)),
            _ => None,
        })
        .collect()
}

/// What can be read of a damaged file: every line of ours says one thing, so each is read on its own.
pub(super) fn lines(text: &str) -> Raw {
    let mut raw = Raw::default();
    for (name, value) in text.lines().filter_map(line) {
        match (name.as_str(), &value) {
            ("schema", Value::Number(_)) => raw.schema = Some(value),
            ("profile", Value::String(_)) => raw.chosen = Some(value),
            ("name", Value::String(_)) => raw.profiles.push(RawProfile {
                name: Some(value),
                ..RawProfile::default()
            }),
            ("learnt", Value::Seq(_)) => raw.learnt = Some(value),
            ("panes", Value::String(_)) => raw.panes = Some(value),
            ("taught_to_build", Value::Bool(_)) => raw.taught_to_build = Some(value),
            (_, Value::Seq(_)) => {
                if let Some(profile) = raw.profiles.last_mut() {
                    profile.keys.push((name, value));
                }
            }
            _ => raw.settings.push((name, value)),
        }
    }
    raw
}

fn line(line: &str) -> Option<(String, Value)> {
    let line = line.trim().trim_end_matches(',');
    if !line.contains(':') {
        return None;
    }
    let quoted = line.starts_with('"');
    let alone = if quoted {
        format!("{{{line}}}")
    } else {
        format!("({line})")
    };
    let mut found = entries(ron::from_str(&alone).ok()?)?.into_iter();
    found.next().filter(|_| found.next().is_none())
}
