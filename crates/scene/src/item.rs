//! Kinds of things the player can hold, and what each is good for.

use serde::{Deserialize, Serialize};

use crate::frame::ModelId;

/// A kind of thing the player can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Item {
    /// Shoots bullets.
    #[serde(rename = "gun")]
    Gun,
    /// Weak pickaxe.
    #[serde(rename = "pickaxe-wood")]
    PickaxeWood,
    /// Medium pickaxe.
    #[serde(rename = "pickaxe-iron")]
    PickaxeIron,
    /// Strong pickaxe.
    #[serde(rename = "pickaxe-diamond")]
    PickaxeDiamond,
    /// What the gun shoots.
    #[serde(rename = "bullet")]
    Bullet,
    /// A lamp to put down.
    #[serde(rename = "lamp")]
    Lamp,
}

impl Item {
    /// Every item, in the order in which a new player finds them in the slots.
    pub const ALL: [Self; 6] = [
        Self::Gun,
        Self::PickaxeWood,
        Self::PickaxeIron,
        Self::PickaxeDiamond,
        Self::Bullet,
        Self::Lamp,
    ];

    /// The name used by scripts and saves, such as `pickaxe-iron`.
    pub fn id(self) -> &'static str {
        match self {
            Self::Gun => "gun",
            Self::PickaxeWood => "pickaxe-wood",
            Self::PickaxeIron => "pickaxe-iron",
            Self::PickaxeDiamond => "pickaxe-diamond",
            Self::Bullet => "bullet",
            Self::Lamp => "lamp",
        }
    }

    /// The item with this id, if there is one.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|item| item.id() == id)
    }

    /// How fast the centre of the brush changes, in field units (metres of gentle ground) per second; `None` for what
    /// does not dig.
    pub fn brush_strength_per_s(self) -> Option<f32> {
        match self {
            Self::PickaxeWood => Some(1.0),
            Self::PickaxeIron => Some(3.0),
            Self::PickaxeDiamond => Some(5.0),
            Self::Gun | Self::Bullet | Self::Lamp => None,
        }
    }

    /// How many of it fit into one slot.
    pub fn most_in_slot(self) -> u32 {
        match self {
            Self::Bullet | Self::Lamp => 64,
            _ => 1,
        }
    }

    /// How many of it a new player has.
    pub fn at_start(self) -> u32 {
        match self {
            Self::Bullet => 64,
            Self::Lamp => 10,
            _ => 1,
        }
    }
}

impl From<Item> for ModelId {
    fn from(item: Item) -> Self {
        match item {
            Item::Gun => Self::Gun,
            Item::PickaxeWood => Self::PickaxeWood,
            Item::PickaxeIron => Self::PickaxeIron,
            Item::PickaxeDiamond => Self::PickaxeDiamond,
            Item::Bullet => Self::Bullet,
            Item::Lamp => Self::Lamp,
        }
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
