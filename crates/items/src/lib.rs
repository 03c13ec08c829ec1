//! The items that a player can carry.
//!
//! The table `assets/tables/items.ron` has a row for each item. The build of `antipode-tables` makes the enum [`Item`] of it
//! and refuses a faulty table with its file, line and field.
//!
//! A new item needs a row, a model and an icon in `assets/models`, and its words in the five locales. What it *does*,
//! beyond digging, shining and standing where it was put, is a rule of the scene.

antipode_tables::items!();

/// What the table says of an item.
struct Row {
    id: &'static str,
    model: &'static [u8],
    icon: &'static [u8],
    most_in_slot: u32,
    at_start: u32,
    at_start_gathering: u32,
    lies: Lies,
    held: Held,
    digs_per_s: Option<f32>,
    power: Option<u8>,
    made: &'static [Made],
    is_of: Option<(&'static str, f64)>,
    rolls_m: Option<f64>,
    shines: bool,
    stands: Option<Stands>,
}

/// How something lies on level ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lies {
    /// As it stands.
    Upright {
        /// How high its origin is over the ground, metres.
        height_m: f64,
    },
    /// On its side, as what has a grip does.
    OnItsSide {
        /// How high its origin is over the ground, metres.
        height_m: f64,
    },
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

/// How something is made of ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Made {
    /// How many come of it.
    pub count: u32,
    /// The names of kinds of ground, and how much of each it takes, cubic metres.
    pub of: &'static [(&'static str, f64)],
}

/// How something stands where it was put down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stands {
    /// So many stand in a world at most.
    pub most: usize,
    /// From where to where the upright capsule reaches within which the crosshair covers it, metres over its foot.
    pub heights_m: [f64; 2],
    /// Radius of that, metres.
    pub radius_m: f64,
    /// The height over its foot that must be free of ground, and from which it shines, metres.
    pub middle_m: f64,
    /// Radius of the ball about that which shows where it would be put, metres.
    pub marker_m: f64,
    /// Ground with less than this upright in its unit normal is too steep for it.
    pub level_up: f64,
    /// How it is turned to the right of where who puts it down looks, degrees; none where all look the same way.
    pub turned_deg: Option<f64>,
    /// Whether a prism about that capsule stops all that land stops.
    pub is_solid: bool,
}

/// What fits in a hand is held before the eye no farther off than this, metres.
const FARTHEST_IN_HAND_M: f32 = 4.0;

impl Item {
    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// The name used by scripts and saves, such as `pickaxe-iron`.
    pub fn id(self) -> &'static str {
        self.row().id
    }

    /// The item with this id, if there is one.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|item| item.id() == id)
    }

    /// Its model, a glTF file.
    pub fn model(self) -> &'static [u8] {
        self.row().model
    }

    /// Its picture, a PNG.
    pub fn icon(self) -> &'static [u8] {
        self.row().icon
    }

    /// How many of it fit into one slot.
    pub fn most_in_slot(self) -> u32 {
        self.row().most_in_slot
    }

    /// How many of it a new player has.
    pub fn at_start(self) -> u32 {
        self.row().at_start
    }

    /// How many of it a new player of a gathering world has.
    pub fn at_start_gathering(self) -> u32 {
        self.row().at_start_gathering
    }

    /// The ways in which it is made of ground; none for what is not.
    pub fn made(self) -> &'static [Made] {
        self.row().made
    }

    /// Of what kind of ground it is, by name, and how much, cubic metres, where who gathers takes it up as that.
    pub fn is_of(self) -> Option<(&'static str, f64)> {
        self.row().is_of
    }

    /// The radius on which it rolls about its height when it lies on its side, metres; `None` for what stays where it falls.
    pub fn rolls_m(self) -> Option<f64> {
        self.row().rolls_m
    }

    /// How hard ground it digs in gathering worlds; `None` for what does not dig.
    pub fn power(self) -> Option<u8> {
        self.row().power
    }

    /// How it lies on level ground.
    pub fn lies(self) -> Lies {
        self.row().lies
    }

    /// How it is held before the eye.
    pub fn held(self) -> Held {
        self.row().held
    }

    /// Whether it can be shown in a figure's hand at its own size. What is larger is shown to who holds it from so far off that it
    /// seems small; from behind, it would stand around who carries it.
    pub fn fits_in_hand(self) -> bool {
        let [_, _, ahead_m] = self.held().place_m;
        ahead_m < FARTHEST_IN_HAND_M
    }

    /// How fast the centre of the brush changes, in field units (metres of gentle ground) per second; `None` for what
    /// does not dig.
    pub fn brush_strength_per_s(self) -> Option<f32> {
        self.row().digs_per_s
    }

    /// Whether its glowing parts are drawn as bright as a lamp, for others to see by.
    pub fn shines(self) -> bool {
        self.row().shines
    }

    /// How it stands where it was put down; `None` for what is not.
    pub fn stands(self) -> Option<&'static Stands> {
        self.row().stands.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_round_trip_and_differ() {
        for item in Item::ALL {
            assert_eq!(Item::from_id(item.id()), Some(item));
        }
        assert_eq!(Item::from_id("pickaxe"), None);
    }
}
