//! The player's inventory: the hotbar, the backpack below it, and the stack that the pointer holds.
//!
//! Nothing is ever lost here. Every move returns the items that found no room, and closing the backpack puts the
//! pointer's stack back.

use serde::{Deserialize, Serialize};

use antipode_items::Item;

use crate::setup::Mode;

/// Slots of the hotbar.
pub const HOTBAR_SLOTS: u8 = 10;
/// Slots of the backpack.
pub const BACKPACK_SLOTS: u8 = 30;
/// All slots: those of the hotbar come first.
pub const SLOTS: u8 = HOTBAR_SLOTS + BACKPACK_SLOTS;

/// What one slot holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stack {
    /// The item.
    pub item: Item,
    /// How many, at least one.
    pub count: u32,
}

/// What the player carries, and which slot of the hotbar is in hand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inventory {
    slots: [Option<Stack>; SLOTS as usize],
    selected: u8,
    /// What the pointer holds while the backpack is open, and the slot that it came from.
    carried: Option<(Stack, u8)>,
}

impl Default for Inventory {
    /// As at the start of a creative world.
    fn default() -> Self {
        Self::at_start(Mode::Creative)
    }
}

impl Inventory {
    /// What one begins with, in the first slots in the order of the items, a pickaxe in hand.
    pub fn at_start(mode: Mode) -> Self {
        let count = |item: Item| match mode {
            Mode::Creative => item.at_start(),
            Mode::Gathering => item.at_start_gathering(),
        };
        let stacks = Item::ALL.map(|item| Stack {
            item,
            count: count(item),
        });
        let mut start = Self::empty();
        for (slot, stack) in (0..).zip(stacks.into_iter().filter(|stack| stack.count > 0)) {
            start.put(slot, stack);
        }
        let digs = |slot: &Option<Stack>| slot.is_some_and(|it| it.item.power().is_some());
        let pickaxe = start.slots.iter().position(digs);
        start.selected = pickaxe
            .and_then(|at| u8::try_from(at).ok())
            .unwrap_or_default();
        start
    }

    /// Nothing at all, with the first slot selected.
    pub fn empty() -> Self {
        Self {
            slots: [None; SLOTS as usize],
            selected: 0,
            carried: None,
        }
    }

    /// What lies in each slot: the hotbar from left to right, then the backpack line by line.
    pub fn slots(&self) -> &[Option<Stack>] {
        &self.slots
    }

    /// What lies in each slot of the hotbar, left to right.
    pub fn hotbar(&self) -> &[Option<Stack>] {
        &self.slots[..usize::from(HOTBAR_SLOTS)]
    }

    /// The selected slot, 0 to 9.
    pub fn selected(&self) -> u8 {
        self.selected
    }

    /// What is in hand.
    pub fn held(&self) -> Option<Item> {
        self.slots[usize::from(self.selected)].map(|stack| stack.item)
    }

    /// How many of an item there are in all slots and at the pointer.
    pub fn count(&self, item: Item) -> u32 {
        let carried = self.carried.map(|(stack, _)| stack);
        self.slots
            .iter()
            .flatten()
            .chain(&carried)
            .filter(|stack| stack.item == item)
            .fold(0, |sum, stack| sum.saturating_add(stack.count))
    }

    /// Takes a slot in hand; a number past the hotbar is ignored.
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
            *place = Some(stack).filter(|stack| stack.count > 0);
        }
    }

    /// Adds `count` of an item: to stacks of its kind first, then to free slots. Returns how many found no room.
    pub fn give(&mut self, item: Item, count: u32) -> u32 {
        let most = item.most_in_slot();
        let mut left = count;
        for stack in self.slots.iter_mut().flatten() {
            if stack.item == item {
                let moved = left.min(most.saturating_sub(stack.count));
                stack.count += moved;
                left -= moved;
            }
        }
        for slot in self.slots.iter_mut().filter(|slot| slot.is_none()) {
            if left == 0 {
                break;
            }
            let moved = left.min(most);
            *slot = Some(Stack { item, count: moved });
            left -= moved;
        }
        left
    }

    /// Uses one of an item up, from the slot in hand if it is there, else from the first that has it. Returns whether
    /// there was one.
    pub fn spend(&mut self, item: Item) -> bool {
        let has = |slot: &Option<Stack>| slot.is_some_and(|stack| stack.item == item);
        let in_hand = usize::from(self.selected);
        let found = if has(&self.slots[in_hand]) {
            Some(in_hand)
        } else {
            self.slots.iter().position(has)
        };
        let Some(found) = found else { return false };
        let slot = &mut self.slots[found];
        *slot = slot
            .map(|stack| Stack {
                count: stack.count.saturating_sub(1),
                ..stack
            })
            .filter(|stack| stack.count > 0);
        true
    }

    /// What the pointer holds.
    pub fn carried(&self) -> Option<Stack> {
        self.carried.map(|(stack, _)| stack)
    }

    /// The main button on a slot: takes the stack, puts the carried one down, merges it with one of its kind as far as
    /// there is room, or swaps the two. A slot past the last is ignored.
    pub fn click(&mut self, slot: u8) {
        let Some(place) = self.slots.get_mut(usize::from(slot)) else {
            return;
        };
        let Some((carried, from)) = self.carried.take() else {
            self.carried = place.take().map(|stack| (stack, slot));
            return;
        };
        let left = match place {
            None => {
                *place = Some(carried);
                None
            }
            Some(there) if there.item == carried.item => merge(there, carried, carried.count),
            Some(there) => Some(std::mem::replace(there, carried)),
        };
        self.carried = left.map(|stack| (stack, from));
    }

    /// The other button on a slot: takes the larger half of the stack, or puts one of the carried ones down where
    /// there is room for it. A slot past the last is ignored.
    pub fn click_other(&mut self, slot: u8) {
        let Some(place) = self.slots.get_mut(usize::from(slot)) else {
            return;
        };
        let Some((carried, from)) = self.carried else {
            let Some(stack) = place.take() else { return };
            let taken = stack.count.div_ceil(2);
            *place = Some(Stack {
                count: stack.count - taken,
                ..stack
            })
            .filter(|rest| rest.count > 0);
            self.carried = Some((
                Stack {
                    count: taken,
                    ..stack
                },
                slot,
            ));
            return;
        };
        let left = match place {
            None => {
                *place = Some(Stack {
                    count: 1,
                    ..carried
                });
                less(carried, 1)
            }
            Some(there) if there.item == carried.item => merge(there, carried, 1),
            Some(_) => Some(carried),
        };
        self.carried = left.map(|stack| (stack, from));
    }

    /// Sends a whole stack to the other part: from the hotbar to the backpack, or back. What finds no room stays.
    pub fn send(&mut self, slot: u8) {
        let index = usize::from(slot);
        let Some(mut stack) = self.slots.get_mut(index).and_then(Option::take) else {
            return;
        };
        let (hotbar, backpack) = self.slots.split_at_mut(usize::from(HOTBAR_SLOTS));
        let goal = if slot < HOTBAR_SLOTS {
            backpack
        } else {
            hotbar
        };
        let item = stack.item;
        for there in goal.iter_mut().flatten().filter(|there| there.item == item) {
            match merge(there, stack, stack.count) {
                Some(left) => stack = left,
                None => return,
            }
        }
        let place = goal.iter().position(Option::is_none);
        match place {
            Some(free) => goal[free] = Some(stack),
            None => self.slots[index] = Some(stack),
        }
    }

    /// The end of a drag on a slot: puts the carried stack down there, or merges it with one of its kind. What was
    /// there goes to where the carried one came from; if that is not free, or something is left, the carried one goes
    /// back there itself. A slot past the last undoes the drag.
    pub fn end_drag(&mut self, slot: u8) {
        let Some((carried, from)) = self.carried.take() else {
            return;
        };
        let origin = usize::from(from);
        let is_free = self.slots[origin].is_none();
        let left = match self.slots.get_mut(usize::from(slot)) {
            Some(place @ None) => {
                *place = Some(carried);
                None
            }
            Some(Some(there)) if there.item == carried.item => merge(there, carried, carried.count),
            Some(Some(there)) if is_free => Some(std::mem::replace(there, carried)),
            None | Some(Some(_)) => Some(carried),
        };
        let Some(left) = left else { return };
        self.carried = match &mut self.slots[origin] {
            place @ None => {
                *place = Some(left);
                None
            }
            Some(there) if there.item == left.item => merge(there, left, left.count),
            Some(_) => Some(left),
        }
        .map(|left| (left, from));
    }

    /// Swaps what lies in two slots; where one is past the last nothing happens.
    pub fn swap(&mut self, one: u8, other: u8) {
        if one < SLOTS && other < SLOTS {
            self.slots.swap(usize::from(one), usize::from(other));
        }
    }

    /// Lets go of what the pointer holds, or of one of it, for it to be dropped.
    pub fn let_go(&mut self, whole: bool) -> Option<Stack> {
        let (stack, from) = self.carried.take()?;
        if whole {
            return Some(stack);
        }
        self.carried = less(stack, 1).map(|left| (left, from));
        Some(Stack { count: 1, ..stack })
    }

    /// Takes one, or the whole, out of the slot in hand, for it to be dropped.
    pub fn take_held(&mut self, whole: bool) -> Option<Stack> {
        self.take_from(self.selected, whole)
    }

    /// Takes one, or the whole, out of a slot, for it to be dropped.
    pub fn take_from(&mut self, slot: u8, whole: bool) -> Option<Stack> {
        let slot = self.slots.get_mut(usize::from(slot))?;
        let stack = slot.take()?;
        let count = if whole { stack.count } else { 1 };
        *slot = less(stack, count);
        Some(Stack { count, ..stack })
    }

    /// Puts back what the pointer holds, as when the backpack is closed: where it came from if that is free, else
    /// wherever there is room. Returns what found none, for it to be dropped.
    pub fn put_back(&mut self) -> Option<Stack> {
        let (stack, from) = self.carried.take()?;
        let place = &mut self.slots[usize::from(from)];
        if place.is_none() {
            *place = Some(stack);
            return None;
        }
        let left = self.give(stack.item, stack.count);
        (left > 0).then_some(Stack {
            count: left,
            ..stack
        })
    }
}

/// Moves up to `count` of `from` to a stack of the same item, as far as there is room. Returns what is left of `from`.
fn merge(there: &mut Stack, from: Stack, count: u32) -> Option<Stack> {
    let moved = count.min(there.item.most_in_slot().saturating_sub(there.count));
    there.count += moved;
    less(from, moved)
}

/// A stack with `count` fewer, if anything is left of it.
fn less(stack: Stack, count: u32) -> Option<Stack> {
    let left = stack.count.saturating_sub(count);
    (left > 0).then_some(Stack {
        count: left,
        ..stack
    })
}

#[cfg(test)]
mod tests;
