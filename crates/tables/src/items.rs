//! The rows of `assets/tables/items.ron`.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::reader::{Assets, Fault, Row, need};
use crate::source::{Names, Source, embedded};

/// What the fields are, the head of the table says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Item {
    id: String,
    what: String,
    model: String,
    icon: String,
    most_in_slot: u32,
    at_start: u32,
    #[serde(default)]
    at_start_gathering: u32,
    lies: Lies,
    held: Held,
    #[serde(default)]
    digs_per_s: Option<f32>,
    #[serde(default)]
    power: Option<u8>,
    #[serde(default)]
    made: Vec<Made>,
    #[serde(default)]
    is_of: Option<(String, f64)>,
    #[serde(default)]
    rolls_m: Option<f64>,
    #[serde(default)]
    shines: bool,
    #[serde(default)]
    stands: Option<Stands>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
enum Lies {
    Upright { height_m: f64 },
    OnItsSide { height_m: f64 },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "its form is what is read")]
struct Held {
    place_m: [f32; 3],
    turn_rad: [f32; 3],
    grip_m: [f32; 3],
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "its form is what is read")]
struct Stands {
    most: usize,
    heights_m: [f64; 2],
    radius_m: f64,
    middle_m: f64,
    marker_m: f64,
    level_up: f64,
    turned_deg: Option<f64>,
    #[serde(default)]
    is_solid: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Made {
    count: u32,
    of: BTreeMap<String, f64>,
}

impl Made {
    fn check(&self) -> Result<(), Fault> {
        need("made.count", self.count > 0, "is to be 1 or more")?;
        let is_some = !self.of.is_empty() && self.of.values().all(|m3| *m3 > 0.0);
        need(
            "made.of",
            is_some,
            "is to name kinds of ground, more than 0 of each",
        )
    }

    fn expression(&self) -> String {
        let parts: Vec<_> = self.of.iter().collect();
        format!("Made {{ count: {}, of: &{parts:?} }}", self.count)
    }
}

impl Stands {
    fn check(&self) -> Result<(), Fault> {
        let [low_m, high_m] = self.heights_m;
        need("stands.most", self.most > 0, "is to be 1 or more")?;
        let fits =
            self.radius_m > 0.0 && low_m >= 0.0 && low_m + 2.0 * self.radius_m <= high_m + 1e-9;
        need(
            "stands.radius_m",
            fits,
            "is to be more than 0, and a ball of it to fit between the heights",
        )?;
        let is_in = (low_m..=high_m).contains(&self.middle_m);
        need("stands.middle_m", is_in, "is to be between the heights")?;
        need(
            "stands.marker_m",
            self.marker_m > 0.0,
            "is to be more than 0",
        )?;
        let is_share = (0.0..=1.0).contains(&self.level_up);
        need("stands.level_up", is_share, "is to be 0 to 1")
    }
}

impl Row for Item {
    const FILE: &'static str = "assets/tables/items.ron";

    fn id(&self) -> &str {
        &self.id
    }

    fn check(&self, assets: Assets<'_>) -> Result<(), Fault> {
        let (Lies::Upright { height_m } | Lies::OnItsSide { height_m }) = self.lies;
        assets.need("model", "models", &self.model)?;
        assets.need("icon", "models", &self.icon)?;
        need("most_in_slot", self.most_in_slot > 0, "is to be 1 or more")?;
        let is_low = (0.0..=2.0).contains(&height_m);
        need("lies.height_m", is_low, "is to be 0 to 2 m over the ground")?;
        let digs = self.digs_per_s.is_none_or(|rate| rate > 0.0);
        need("digs_per_s", digs, "is to be more than 0")?;
        let has_power = self.power.is_some() == self.digs_per_s.is_some();
        need(
            "power",
            has_power,
            "is what only what digs has, and all of that",
        )?;
        self.made.iter().try_for_each(Made::check)?;
        let is_some = self.is_of.as_ref().is_none_or(|(_, m3)| *m3 > 0.0);
        need("is_of", is_some, "is to be more than 0 of a kind of ground")?;
        let is_round = self
            .rolls_m
            .is_none_or(|radius_m| (0.02..=1.0).contains(&radius_m));
        need("rolls_m", is_round, "is to be 0.02 to 1 m")?;
        self.stands.as_ref().map_or(Ok(()), Stands::check)
    }
}

impl Source for Item {
    const NAMES: Option<Names> = Some(Names {
        name: "Item",
        about: "A kind of thing that the player can hold.",
        derives: "PartialOrd, Ord, serde::Serialize, serde::Deserialize",
        is_written: true,
        list: (
            "ALL",
            "Every item, in the order in which a new player finds them in the slots.",
        ),
        other: "",
    });

    fn what(&self) -> &str {
        &self.what
    }

    fn expression(&self, _: &dyn Fn(&Fault) -> String) -> String {
        let made: Vec<_> = self.made.iter().map(Made::expression).collect();
        let is_of = self.is_of.as_ref();
        let is_of = is_of.map(|(kind, m3)| format!("Some(({kind:?}, {m3:?}))"));
        format!(
            "Row {{ id: {:?}, model: {}, icon: {}, most_in_slot: {}, at_start: {}, at_start_gathering: {}, lies: Lies::{:?}, \
             held: {:?}, digs_per_s: {:?}, power: {:?}, made: &[{}], is_of: {}, rolls_m: {:?}, shines: {}, \
             stands: {:?} }}",
            self.id,
            embedded("models", &self.model),
            embedded("models", &self.icon),
            self.most_in_slot,
            self.at_start,
            self.at_start_gathering,
            self.lies,
            self.held,
            self.digs_per_s,
            self.power,
            made.join(", "),
            is_of.unwrap_or_else(|| "None".to_owned()),
            self.rolls_m,
            self.shines,
            self.stands,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::testing::refuses;

    const TWO: &str = r#"[
  (id: "a",
   what: "A.",
   model: "a.glb",
   icon: "a.png",
   most_in_slot: 1,
   at_start: 0,
   lies: Upright(height_m: 0.5),
   held: (place_m: (0, 0, 1), turn_rad: (0, 0, 0), grip_m: (0, 0, 0))),
  (
   id: "b-c",
   what: "B.",
   model: "b.glb",
   icon: "b.png",
   most_in_slot: 2,
   at_start: 3,
   lies: OnItsSide(height_m: 0.25),
   held: (place_m: (0, 0, 1), turn_rad: (0, 0, 0), grip_m: (0, 0, 0)),
   digs_per_s: 2, power: 1, made: [(count: 3, of: {"rock": 1.5})], rolls_m: 0.2, is_of: ("rock", 0.7),
   stands: (
     most: 9,
     heights_m: (0, 1),
     radius_m: 0.3,
     middle_m: 0.4,
     marker_m: 0.2,
     level_up: 0.5,
     turned_deg: 1,
   ),
  ),
]"#;

    #[test]
    fn an_unsound_item_is_told_by_file_line_and_field() {
        let many = "\n   icon: \"b.png\",";
        refuses::<Item>(
            TWO,
            &[
                ("\"b-c\"", "\"B\"", "11: id of \"B\" is to be words"),
                (
                    "\"b-c\"",
                    "\"a\"",
                    "11: id of \"a\" is the id of an earlier row, too",
                ),
                (
                    "b.glb",
                    "none.glb",
                    "13: model of \"b-c\" is \"none.glb\", and assets/models has no such file",
                ),
                ("b.png", "none.png", "14: icon of \"b-c\" is \"none.png\""),
                (many, "", "11: icon of \"b-c\" is missing"),
                (
                    "most_in_slot: 2",
                    "most_in_slot: 0",
                    "15: most_in_slot of \"b-c\"",
                ),
                ("at_start: 3", "at_start: many", "16: at_start of \"b-c\": "),
                (
                    "height_m: 0.25",
                    "height_m: 7",
                    "17: lies.height_m of \"b-c\"",
                ),
                (
                    "height_m: 0.25",
                    "height_m: NaN",
                    "17: lies.height_m of \"b-c\" is to be a number",
                ),
                (
                    "digs_per_s: 2",
                    "digs_per_s: -2",
                    "19: digs_per_s of \"b-c\"",
                ),
                (
                    "digs_per_s",
                    "dogs_per_s",
                    "19: \"b-c\": Unexpected field named `dogs_per_s`",
                ),
                ("power: 1, ", "", "11: power of \"b-c\""),
                ("count: 3", "count: 0", "19: made.count of \"b-c\""),
                ("1.5}", "0}", "19: made.of of \"b-c\""),
                ("0.7", "0", "19: is_of of \"b-c\""),
                ("rolls_m: 0.2", "rolls_m: 2", "19: rolls_m of \"b-c\""),
                ("most: 9", "most: 0", "21: stands.most of \"b-c\""),
                (
                    "radius_m: 0.3",
                    "radius_m: 0.6",
                    "23: stands.radius_m of \"b-c\"",
                ),
                (
                    "middle_m: 0.4",
                    "middle_m: 1.4",
                    "24: stands.middle_m of \"b-c\"",
                ),
                (
                    "level_up: 0.5",
                    "level_up: 5",
                    "26: stands.level_up of \"b-c\"",
                ),
            ],
        );
    }
}
