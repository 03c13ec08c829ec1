//! The rows of `assets/tables/sounds.ron`.

use serde::Deserialize;

use crate::reader::{Assets, Fault, Row, need};
use crate::source::{Names, Source, embedded};

/// What the fields are, the head of the table says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sound {
    id: String,
    what: String,
    files: Vec<String>,
    group: Group,
    gain: f32,
    #[serde(default)]
    least: Option<f32>,
    #[serde(default = "unchanged")]
    rate: f32,
    #[serde(default)]
    wavers: bool,
    #[serde(default)]
    by_ground: bool,
    #[serde(default)]
    loops: bool,
}

fn unchanged() -> f32 {
    1.0
}

/// As `Group` of the volumes.
#[derive(Debug, Deserialize)]
enum Group {
    Effects,
    Ambience,
    Music,
    Interface,
}

/// Each file once, in the order in which rows name them first.
fn files(sounds: &[Sound]) -> Vec<&str> {
    let mut files: Vec<&str> = Vec::new();
    for file in sounds.iter().flat_map(|sound| &sound.files) {
        if !files.contains(&file.as_str()) {
            files.push(file);
        }
    }
    files
}

impl Row for Sound {
    const FILE: &'static str = "assets/tables/sounds.ron";

    fn id(&self) -> &str {
        &self.id
    }

    fn check(&self, assets: Assets<'_>) -> Result<(), Fault> {
        need("files", !self.files.is_empty(), "is to name a file")?;
        for file in &self.files {
            assets.need("files", "sounds", file)?;
        }
        let is_audible = self.gain > 0.0 && self.gain <= 1.0;
        need("gain", is_audible, "is to be more than 0 and at most 1")?;
        let is_less = self
            .least
            .is_none_or(|least| (0.0..=self.gain).contains(&least));
        need("least", is_less, "is to be 0 to gain")?;
        let is_rate = (0.25..=4.0).contains(&self.rate);
        need("rate", is_rate, "is to be 0.25 to 4")?;
        let is_one = !self.loops || self.files.len() == 1;
        need("loops", is_one, "is for a sound of one file")
    }
}

impl Source for Sound {
    const NAMES: Option<Names> = Some(Names {
        name: "Sound",
        about: "Something to be heard.",
        derives: "",
        is_written: false,
        list: ("ALL", "Every sound."),
        other: "",
    });

    fn what(&self) -> &str {
        &self.what
    }

    fn preface(rows: &[Self]) -> String {
        let files = files(rows);
        let built_in = files.iter().map(|file| {
            let name = file.trim_end_matches(".wav");
            format!("({name:?}, {} as &[u8]), ", embedded("sounds", file))
        });
        let built_in: String = built_in.collect();
        let named = rows.iter().map(|row| {
            let own = row.files.iter();
            let places = own.filter_map(|file| files.iter().position(|it| it == file));
            let samples: Vec<_> = places.map(|place| format!("Sample({place})")).collect();
            format!("&[{}], ", samples.join(", "))
        });
        let named: String = named.collect();
        format!(
            "/// The files that are built in: their names, without `.wav`, and what is in them.\nstatic FILES: [(&str, &[u8]); \
             {}] = [{built_in}];\n/// Those of each sound.\nstatic SAMPLES: [&[Sample]; {}] = [{named}];\n",
            files.len(),
            rows.len(),
        )
    }

    fn expression(&self, _: &dyn Fn(&Fault) -> String) -> String {
        let least = self
            .least
            .unwrap_or(if self.loops { 0.0 } else { self.gain });
        format!(
            "Row {{ group: Group::{:?}, gain: {:?}, least: {:?}, rate: {:?}, wavers: {}, by_ground: {}, loops: {} }}",
            self.group, self.gain, least, self.rate, self.wavers, self.by_ground, self.loops,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::testing::refuses;

    const TWO: &str = r#"[
  (id: "wind", what: "Wind.", files: ["wind.wav"], group: Ambience, gain: 1, loops: true),
  (
    id: "dig",
    what: "A pickaxe bites.",
    files: ["dig-1.wav", "dig-2.wav"],
    group: Effects,
    gain: 0.5,
    least: 0.25,
    rate: 1.5,
  ),
]"#;

    #[test]
    fn an_unsound_sound_is_told_by_file_line_and_field() {
        refuses::<Sound>(
            TWO,
            &[
                (
                    "[\"wind.wav\"]",
                    "[\"wind.wav\", \"dig-1.wav\"]",
                    "2: loops of \"wind\" is for a sound of one",
                ),
                (
                    "\"dig\"",
                    "\"wind\"",
                    "4: id of \"wind\" is the id of an earlier row, too",
                ),
                (
                    "dig-2",
                    "none",
                    "6: files of \"dig\" is \"none.wav\", and assets/sounds has no such file",
                ),
                (
                    "\"dig-1.wav\", \"dig-2.wav\"",
                    "",
                    "6: files of \"dig\" is to name a file",
                ),
                ("\"dig-1.wav\"", "1", "6: files of \"dig\": "),
                ("Effects", "Music2", "7: group of \"dig\": Unexpected "),
                (
                    "gain: 0.5",
                    "gain: 1.5",
                    "8: gain of \"dig\" is to be more than 0 and at most 1",
                ),
                (
                    "least: 0.25",
                    "least: 0.75",
                    "9: least of \"dig\" is to be 0 to gain",
                ),
                (
                    "rate: 1.5",
                    "rate: 0",
                    "10: rate of \"dig\" is to be 0.25 to 4",
                ),
                (
                    "rate: 1.5",
                    "pitch: 1.5",
                    "10: \"dig\": Unexpected field named `pitch`",
                ),
            ],
        );
    }
}
