//! The items that a player can carry.
//!
//! The table `assets/tables/items.ron` has a row for each item. The build script makes the enum [`Item`] of it and
//! refuses a faulty table with its file, line and field.
//!
//! A new item needs a row, a model and an icon in `assets/models`, and its words in the five locales. What it *does*,
//! beyond digging, is a rule of the scene.

use serde::{Deserialize, Serialize};

include!(concat!(env!("OUT_DIR"), "/item.rs"));

/// What the table says of an item.
struct Properties {
    id: &'static str,
    model: &'static [u8],
    icon: &'static [u8],
    most_in_slot: u32,
    at_start: u32,
    lies: Lies,
    held: Held,
    digs_per_s: Option<f32>,
    shines: bool,
}

/// How something lies on level ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lies {
    /// Whether it lies on its side, as what has a grip does, and not as it stands.
    pub on_its_side: bool,
    /// How high its origin is over the ground, metres.
    pub height_m: f64,
}

/// How something is held before the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Where the hand is: to the right, up and ahead, metres.
    pub place_m: [f32; 3],
    /// Turns about the thing's height (to the left positive), then about the way to the right (its front up), then about
    /// the way ahead (its top to the right), radians.
    pub turn_rad: [f32; 3],
    /// Where the hand takes hold, from the thing's origin in its own axes, x ahead, y up, z to the right, metres.
    pub grip_m: [f32; 3],
}

impl Item {
    fn properties(self) -> &'static Properties {
        &PROPERTIES[self as usize]
    }

    /// The name used by scripts and saves, such as `pickaxe-iron`.
    pub fn id(self) -> &'static str {
        self.properties().id
    }

    /// The item with this id, if there is one.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|item| item.id() == id)
    }

    /// Its model, a glTF file.
    pub fn model(self) -> &'static [u8] {
        self.properties().model
    }

    /// Its picture, a PNG.
    pub fn icon(self) -> &'static [u8] {
        self.properties().icon
    }

    /// How many of it fit into one slot.
    pub fn most_in_slot(self) -> u32 {
        self.properties().most_in_slot
    }

    /// How many of it a new player has.
    pub fn at_start(self) -> u32 {
        self.properties().at_start
    }

    /// How it lies on level ground.
    pub fn lies(self) -> Lies {
        self.properties().lies
    }

    /// How it is held before the eye.
    pub fn held(self) -> Held {
        self.properties().held
    }

    /// How fast the centre of the brush changes, in field units (metres of gentle ground) per second; `None` for what
    /// does not dig.
    pub fn brush_strength_per_s(self) -> Option<f32> {
        self.properties().digs_per_s
    }

    /// Whether its glowing parts are drawn as bright as a lamp, for others to see by.
    pub fn shines(self) -> bool {
        self.properties().shines
    }
}

#[cfg(test)]
#[allow(dead_code, reason = "the build uses the rest of it")]
mod table;

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn ids_round_trip_and_differ() {
        for item in Item::ALL {
            assert_eq!(Item::from_id(item.id()), Some(item));
        }
        assert_eq!(Item::from_id("pickaxe"), None);
    }

    const TWO: &str = "[\n  (id: \"a\",\n   what: \"A.\",\n   model: \"a.glb\",\n   icon: \"a.png\",\n   most_in_slot: 1,\n   \
                       at_start: 0,\n   lies: Upright(height_m: 0.5),\n   held: (place_m: (0, 0, 1), turn_rad: (0, 0, 0), grip_m: (0, 0, 0))),\n  (\n   id: \"b-c\",\n   what: \"B.\",\n   model: \
                       \"b.glb\",\n   icon: \"b.png\",\n   most_in_slot: 2,\n   at_start: 3,\n   lies: \
                       OnItsSide(height_m: 0),\n   held: (place_m: (0, 0, 1), turn_rad: (0, 0, 0), grip_m: (0, 0, 0)),\n   digs_per_s: 2,\n  ),\n]";

    fn error(text: &str) -> String {
        let read = table::read("items.ron", text, |name| name != "none.glb");
        read.unwrap_err()
    }

    #[test]
    fn an_unsound_table_is_told_by_file_line_and_field() {
        let rows = table::read("items.ron", TWO, |_| true).unwrap();
        assert_eq!(rows[1].digs_per_s, Some(2.0));
        assert_eq!(table::variant(&rows[1].id), "BC");
        let cases = [
            (
                "\"b-c\"",
                "\"B\"",
                "items.ron:11: id of \"B\" is to be words",
            ),
            (
                "\"b-c\"",
                "\"a\"",
                "items.ron:11: id of \"a\" is the id of an earlier row",
            ),
            (
                "\"b.glb\"",
                "\"none.glb\"",
                "items.ron:13: model of \"b-c\" is \"none.glb\"",
            ),
            (
                "most_in_slot: 2",
                "most_in_slot: 0",
                "items.ron:15: most_in_slot of \"b-c\"",
            ),
            (
                "height_m: 0)",
                "height_m: 7)",
                "items.ron:17: lies of \"b-c\"",
            ),
            (
                "digs_per_s: 2",
                "digs_per_s: -2",
                "items.ron:19: digs_per_s of \"b-c\"",
            ),
            (
                "digs_per_s: 2",
                "dogs_per_s: 2",
                "items.ron:19: Unexpected field named `dogs_per_s`",
            ),
            ("at_start: 3", "at_start: many", "items.ron:16: "),
        ];
        for (sound, unsound, told) in cases {
            let message = error(&TWO.replace(sound, unsound));
            assert!(message.starts_with(told), "{message}");
        }
        let missing = error(&TWO.replace("   icon: \"b.png\",\n", ""));
        assert!(missing.contains("`icon`"), "{missing}");
    }
}
