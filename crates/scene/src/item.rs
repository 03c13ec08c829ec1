//! Items and the hotbar: what exists so far is the three pickaxes, each with its digging strength.

use serde::{Deserialize, Serialize};

/// Slots of the hotbar.
pub const HOTBAR_SLOTS: u8 = 10;

/// A kind of thing the player can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Item {
    /// Weak pickaxe.
    #[serde(rename = "pickaxe-wood")]
    PickaxeWood,
    /// Medium pickaxe.
    #[serde(rename = "pickaxe-iron")]
    PickaxeIron,
    /// Strong pickaxe.
    #[serde(rename = "pickaxe-diamond")]
    PickaxeDiamond,
}

impl Item {
    /// Every item.
    pub const ALL: [Self; 3] = [Self::PickaxeWood, Self::PickaxeIron, Self::PickaxeDiamond];

    /// The name used by scripts and saves, such as `pickaxe-iron`.
    pub fn id(self) -> &'static str {
        match self {
            Self::PickaxeWood => "pickaxe-wood",
            Self::PickaxeIron => "pickaxe-iron",
            Self::PickaxeDiamond => "pickaxe-diamond",
        }
    }

    /// The name shown to the player.
    pub fn label(self) -> &'static str {
        match self {
            Self::PickaxeWood => "Wooden pickaxe",
            Self::PickaxeIron => "Iron pickaxe",
            Self::PickaxeDiamond => "Diamond pickaxe",
        }
    }

    /// The item with this id, if there is one.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|item| item.id() == id)
    }

    /// How fast the centre of the brush changes, in field units (metres of gentle ground) per second.
    pub fn brush_strength_per_s(self) -> f32 {
        match self {
            Self::PickaxeWood => 1.0,
            Self::PickaxeIron => 3.0,
            Self::PickaxeDiamond => 5.0,
        }
    }
}

/// What one slot holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stack {
    /// The item.
    pub item: Item,
    /// How many, at least one.
    pub count: u32,
}

/// The player's hotbar and which slot is in hand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inventory {
    slots: [Option<Stack>; HOTBAR_SLOTS as usize],
    selected: u8,
}

impl Default for Inventory {
    /// The start: pickaxes in slots 2 to 4 as the keys count them, the first in hand.
    fn default() -> Self {
        let mut slots = [None; HOTBAR_SLOTS as usize];
        for (slot, item) in (1..).zip(Item::ALL) {
            slots[slot] = Some(Stack { item, count: 1 });
        }
        Self { slots, selected: 1 }
    }
}

impl Inventory {
    /// An empty hotbar with the first slot selected.
    pub fn empty() -> Self {
        Self {
            slots: [None; HOTBAR_SLOTS as usize],
            selected: 0,
        }
    }

    /// What lies in each slot, left to right.
    pub fn slots(&self) -> &[Option<Stack>] {
        &self.slots
    }

    /// The selected slot, 0 to 9.
    pub fn selected(&self) -> u8 {
        self.selected
    }

    /// What is in hand.
    pub fn held(&self) -> Option<Item> {
        self.slots[usize::from(self.selected)].map(|stack| stack.item)
    }

    /// Takes a slot in hand; a number past the last slot is ignored.
    pub fn select(&mut self, slot: u8) {
        if slot < HOTBAR_SLOTS {
            self.selected = slot;
        }
    }

    /// Moves the selection along the hotbar, round its ends.
    pub fn step(&mut self, by: i32) {
        self.selected = (i32::from(self.selected) + by).rem_euclid(i32::from(HOTBAR_SLOTS)) as u8;
    }

    /// Puts a stack into a slot, replacing what was there; a slot past the last is ignored.
    pub fn put(&mut self, slot: u8, stack: Stack) {
        if let Some(place) = self.slots.get_mut(usize::from(slot)) {
            *place = Some(stack);
        }
    }

    /// Adds `count` of an item to its stack or the first free slot. Returns false when there is no room.
    pub fn give(&mut self, item: Item, count: u32) -> bool {
        if let Some(stack) = self
            .slots
            .iter_mut()
            .flatten()
            .find(|stack| stack.item == item)
        {
            stack.count = stack.count.saturating_add(count);
            return true;
        }
        match self.slots.iter_mut().find(|slot| slot.is_none()) {
            Some(free) => {
                *free = Some(Stack { item, count });
                true
            }
            None => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_player_holds_the_wooden_pickaxe_and_finds_the_rest_beside_it() {
        let bag = Inventory::default();
        assert_eq!(bag.held(), Some(Item::PickaxeWood));
        assert_eq!(bag.slots()[2].map(|s| s.item), Some(Item::PickaxeIron));
        assert_eq!(bag.slots()[3].map(|s| s.item), Some(Item::PickaxeDiamond));
    }

    #[test]
    fn every_slot_can_be_reached_by_number_and_by_step() {
        let mut bag = Inventory::default();
        for slot in 0..HOTBAR_SLOTS {
            bag.select(slot);
            assert_eq!(bag.selected(), slot);
        }
        bag.step(1);
        assert_eq!(bag.selected(), 0);
        bag.step(-1);
        assert_eq!(bag.selected(), 9);
        bag.select(10);
        assert_eq!(bag.selected(), 9);
    }

    #[test]
    fn ids_round_trip_and_differ() {
        for item in Item::ALL {
            assert_eq!(Item::from_id(item.id()), Some(item));
        }
        assert_eq!(Item::from_id("pickaxe"), None);
    }

    #[test]
    fn giving_adds_the_whole_count_to_a_stack_and_says_when_full() {
        let mut bag = Inventory::default();
        assert!(bag.give(Item::PickaxeIron, 5));
        assert_eq!(bag.slots()[2].map(|s| s.count), Some(6));
        let mut full = Inventory::empty();
        for slot in 0..HOTBAR_SLOTS {
            full.put(
                slot,
                Stack {
                    item: Item::PickaxeWood,
                    count: 1,
                },
            );
        }
        assert!(!full.give(Item::PickaxeIron, 1));
    }
}
