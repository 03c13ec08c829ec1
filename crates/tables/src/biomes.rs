//! The rows of `assets/tables/biomes.ron`.

use serde::Deserialize;

use crate::reader::{Assets, Fault, Row, need};
use crate::source::{Names, Source};

/// What the fields are, the head of the table says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Biome {
    id: String,
    alone: Option<Alone>,
    climate: [f32; 3],
    begins: bool,
    rise_m: f32,
    waves_m: [f32; 4],
    terraces: f32,
    levels_m: [f32; 2],
    covers: [Cover; 3],
    kinds: Kinds,
    palette: Palette,
}

/// As `Alone` of the terrain.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Alone {
    octaves: usize,
    first_frequency: f64,
    first_amplitude_m: f64,
    middle_m: f64,
    top_m: f64,
    level_errors_m: [f64; 3],
    kinds: Kinds,
}

/// As `Cover` of the terrain.
#[derive(Debug, Clone, Copy, Deserialize)]
enum Cover {
    Rock,
    Gravel,
    Sand,
    Soil,
    Grass,
}

/// As `Kinds` of the terrain.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Kinds {
    low: Kind,
    middle: Kind,
    high: Kind,
    cap: Kind,
    patch: Kind,
    under: Kind,
    stone: Kind,
}

/// As those `Kind` of the terrain that lie at the surface.
#[derive(Debug, Clone, Copy, Deserialize)]
enum Kind {
    Grass,
    Soil,
    Sand,
    Gravel,
    Rock,
    Ash,
    Snow,
    Moss,
    Clay,
    Basalt,
}

/// As `Palette` of the terrain.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "its form is what is read")]
struct Palette {
    bottom: [u8; 3],
    middle: [u8; 3],
    top: [u8; 3],
    rock: [u8; 3],
    strata: [u8; 3],
}

impl Kinds {
    fn expression(&self) -> String {
        let Self {
            low,
            middle,
            high,
            cap,
            patch,
            under,
            stone,
        } = self;
        format!(
            "Kinds {{ low: Kind::{low:?}, middle: Kind::{middle:?}, high: Kind::{high:?}, cap: Kind::{cap:?}, \
             patch: Kind::{patch:?}, under: Kind::{under:?}, stone: Kind::{stone:?} }}"
        )
    }
}

impl Row for Biome {
    const FILE: &'static str = "assets/tables/biomes.ron";

    fn id(&self) -> &str {
        &self.id
    }

    fn check(&self, _: Assets<'_>) -> Result<(), Fault> {
        if let Some(alone) = &self.alone {
            alone.check()?;
        }
        let is_within = self.climate.iter().all(|it| it.abs() <= 1.0);
        need("climate", is_within, "is to be -1 to 1")?;
        let is_high = self.waves_m.iter().all(|wave| *wave >= 0.0);
        need("waves_m", is_high, "is to be 0 or more")?;
        // With more, terraces would hang over.
        let is_share = (0.0..=0.8).contains(&self.terraces);
        need("terraces", is_share, "is to be 0 to 0.8")?;
        let rise = self.levels_m.is_sorted();
        need("levels_m", rise, "is to rise")
    }
}

impl Alone {
    fn expression(&self) -> String {
        format!(
            "Some(Alone {{ octaves: {}, first_frequency: {:?}, first_amplitude_m: {:?}, middle_m: {:?}, top_m: {:?}, \
             level_errors_m: {:?}, kinds: {} }})",
            self.octaves,
            self.first_frequency,
            self.first_amplitude_m,
            self.middle_m,
            self.top_m,
            self.level_errors_m,
            self.kinds.expression(),
        )
    }

    fn check(&self) -> Result<(), Fault> {
        need(
            "alone.octaves",
            (1..=4).contains(&self.octaves),
            "is to be 1 to 4",
        )?;
        let is_positive = |field, number: f64| need(field, number > 0.0, "is to be more than 0");
        is_positive("alone.first_frequency", self.first_frequency)?;
        is_positive("alone.first_amplitude_m", self.first_amplitude_m)?;
        is_positive("alone.middle_m", self.middle_m)?;
        let is_over = self.top_m > self.middle_m;
        need("alone.top_m", is_over, "is to be over middle_m")?;
        let errors_m = &self.level_errors_m;
        let rise = errors_m[0] > 0.0 && errors_m.is_sorted();
        need(
            "alone.level_errors_m",
            rise,
            "is to be more than 0 and to rise",
        )
    }
}

impl Source for Biome {
    const NAMES: Option<Names> = None;

    fn what(&self) -> &'static str {
        ""
    }

    fn expression(&self, _: &dyn Fn(&Fault) -> String) -> String {
        let alone = self
            .alone
            .as_ref()
            .map_or("None".to_owned(), Alone::expression);
        let covers = self.covers.map(|cover| format!("Cover::{cover:?}"));
        format!(
            "Row {{ name: {:?}, alone: {}, climate: {:?}, begins: {:?}, rise_m: {:?}, waves_m: {:?}, terraces: {:?}, levels_m: {:?}, \
             covers: [{}], kinds: {}, palette: {:?} }}",
            self.id,
            alone,
            self.climate,
            self.begins,
            self.rise_m,
            self.waves_m,
            self.terraces,
            self.levels_m,
            covers.join(", "),
            self.kinds.expression(),
            self.palette,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::testing::refuses;

    const ONE: &str = r#"[
  (
    id: "tundra",
    alone: Some((
      octaves: 4,
      first_frequency: 0.3,
      first_amplitude_m: 20,
      middle_m: 15,
      top_m: 23,
      level_errors_m: (0.8, 2.2, 4.3), kinds: (low: Rock, middle: Ash, high: Gravel, cap: Snow, patch: Moss, under: Soil, stone: Rock),
    )),
    climate: (0.1, -0.4, 0),
    rise_m: 1, begins: true,
    waves_m: (8, 4, 2, 1),
    terraces: 0.5,
    levels_m: (-3, 5),
    covers: (Rock, Gravel, Grass),
    kinds: (low: Rock, middle: Ash, high: Grass, cap: Snow, patch: Moss, under: Soil, stone: Rock),
    palette: (
      bottom: (206, 92, 48),
      middle: (96, 74, 78),
      top: (132, 120, 130),
      rock: (56, 46, 56),
      strata: (150, 66, 48),
    ),
  ),
]"#;

    #[test]
    fn an_unsound_biome_is_told_by_file_line_and_field() {
        let twin = ONE.trim_start_matches('[');
        refuses::<Biome>(
            ONE,
            &[
                ("tundra", "Tundra", "3: id of \"Tundra\" is to be words"),
                (
                    "  ),\n]",
                    &format!("  ),{twin}"),
                    "28: id of \"tundra\" is the id of an earlier row, too",
                ),
                (
                    "octaves: 4",
                    "octaves: 9",
                    "5: alone.octaves of \"tundra\" is to be 1 to 4",
                ),
                (
                    "octaves: 4",
                    "octaves: -4",
                    "5: alone.octaves of \"tundra\": ",
                ),
                (
                    "0.3,",
                    "0,",
                    "6: alone.first_frequency of \"tundra\" is to be more than 0",
                ),
                (
                    "20,",
                    "inf,",
                    "7: alone.first_amplitude_m of \"tundra\" is to be a number",
                ),
                (
                    "23,",
                    "15,",
                    "9: alone.top_m of \"tundra\" is to be over middle_m",
                ),
                (
                    "(0.8, 2.2",
                    "(2.8, 2.2",
                    "10: alone.level_errors_m of \"tundra\" is to be more than 0 and to rise",
                ),
                (
                    "(0.1, -0.4",
                    "(0.1, -1.4",
                    "12: climate of \"tundra\" is to be -1 to 1",
                ),
                (
                    "(8, 4",
                    "(8, -4",
                    "14: waves_m of \"tundra\" is to be 0 or more",
                ),
                (
                    "0.5,",
                    "0.9,",
                    "15: terraces of \"tundra\" is to be 0 to 0.8",
                ),
                ("(-3, 5)", "(6, 5)", "16: levels_m of \"tundra\" is to rise"),
                (
                    "Rock, Gravel",
                    "Rock, Lava",
                    "17: covers of \"tundra\": Unexpected ",
                ),
                (
                    "high: Grass",
                    "high: Coal",
                    "18: kinds.high of \"tundra\": ",
                ),
                (
                    "(206, 92, 48)",
                    "(206, 92, 480)",
                    "20: palette.bottom of \"tundra\": ",
                ),
                (
                    "strata",
                    "stripes",
                    "24: \"tundra\": Unexpected field named `stripes`",
                ),
            ],
        );
    }
}
