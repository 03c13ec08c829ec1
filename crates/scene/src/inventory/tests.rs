//! Stacks in slots: nothing is lost or made by any way of moving them.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
use proptest::prelude::*;

use super::*;

fn stack(item: Item, count: u32) -> Stack {
    Stack { item, count }
}

#[test]
fn a_new_player_has_everything_in_the_first_slots() {
    let bag = Inventory::default();
    assert_eq!(bag.held(), Some(Item::PickaxeWood));
    let counts: Vec<_> = bag.slots().iter().flatten().map(|s| s.count).collect();
    assert_eq!(counts, [1, 1, 1, 1, 64, 10, 5, 2, 10, 16, 16, 64]);
    assert_eq!(bag.hotbar().len(), 10);
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
fn giving_fills_stacks_then_slots_and_says_what_found_no_room() {
    let mut bag = Inventory::empty();
    assert_eq!(bag.give(Item::Lamp, 100), 0);
    assert_eq!(
        bag.slots()[..3],
        [
            Some(stack(Item::Lamp, 64)),
            Some(stack(Item::Lamp, 36)),
            None
        ]
    );
    assert_eq!(bag.give(Item::Lamp, 30), 0);
    assert_eq!(bag.count(Item::Lamp), 130);
    assert_eq!(bag.give(Item::Gun, 100), 63);
    assert_eq!(bag.count(Item::Gun), 37);
}

#[test]
fn spending_takes_what_is_in_hand_first_and_empties_the_slot_with_the_last() {
    let mut bag = Inventory::empty();
    bag.put(0, stack(Item::Bullet, 5));
    bag.put(3, stack(Item::Bullet, 1));
    bag.select(3);
    assert!(bag.spend(Item::Bullet));
    assert_eq!(bag.slots()[3], None);
    for _ in 0..5 {
        assert!(bag.spend(Item::Bullet));
    }
    assert!(!bag.spend(Item::Bullet));
}

#[test]
fn stacks_are_dragged_swapped_merged_and_split() {
    let mut bag = Inventory::default();
    bag.click(4);
    assert_eq!(
        (bag.carried(), bag.slots()[4]),
        (Some(stack(Item::Bullet, 64)), None)
    );
    bag.click(5);
    assert_eq!(bag.slots()[5], Some(stack(Item::Bullet, 64)));
    assert_eq!(bag.carried(), Some(stack(Item::Lamp, 10)));
    bag.click(20);
    assert_eq!(
        (bag.carried(), bag.slots()[20]),
        (None, Some(stack(Item::Lamp, 10)))
    );
    bag.click_other(5);
    bag.click_other(21);
    assert_eq!(bag.slots()[21], Some(stack(Item::Bullet, 1)));
    bag.click(21);
    assert_eq!(bag.slots()[21], Some(stack(Item::Bullet, 32)));
    bag.click_other(5);
    assert_eq!(bag.carried(), Some(stack(Item::Bullet, 16)));
    bag.click(21);
    assert_eq!(
        (bag.carried(), bag.slots()[21]),
        (None, Some(stack(Item::Bullet, 48)))
    );
}

#[test]
fn a_full_stack_takes_no_more_and_the_rest_stays_at_the_pointer() {
    let mut bag = Inventory::empty();
    bag.put(0, stack(Item::Bullet, 60));
    bag.put(1, stack(Item::Bullet, 10));
    bag.click(1);
    bag.click(0);
    assert_eq!(
        (bag.slots()[0], bag.carried()),
        (Some(stack(Item::Bullet, 64)), Some(stack(Item::Bullet, 6)))
    );
    assert_eq!(bag.put_back(), None);
    assert_eq!(bag.slots()[1], Some(stack(Item::Bullet, 6)));
}

#[test]
fn a_stack_is_sent_to_the_other_part_and_back() {
    let mut bag = Inventory::default();
    // The first free one of the backpack: what is last begins there.
    bag.send(4);
    assert_eq!(
        (bag.slots()[4], bag.slots()[12]),
        (None, Some(stack(Item::Bullet, 64)))
    );
    bag.send(12);
    assert_eq!(
        (bag.slots()[12], bag.slots()[4]),
        (None, Some(stack(Item::Bullet, 64)))
    );
}

#[test]
fn a_drag_swaps_two_stacks_and_what_does_not_fit_goes_back() {
    let mut bag = Inventory::default();
    bag.click(4);
    bag.end_drag(0);
    assert_eq!(
        (bag.slots()[0], bag.slots()[4], bag.carried()),
        (
            Some(stack(Item::Bullet, 64)),
            Some(stack(Item::Gun, 1)),
            None
        )
    );
    // Half of a stack cannot swap: the other half lies where it came from.
    bag.click_other(5);
    bag.end_drag(0);
    assert_eq!(
        (bag.slots()[5], bag.carried()),
        (Some(stack(Item::Lamp, 10)), None)
    );
    bag.click_other(5);
    bag.end_drag(30);
    assert_eq!(
        (bag.slots()[5], bag.slots()[30]),
        (Some(stack(Item::Lamp, 5)), Some(stack(Item::Lamp, 5)))
    );
    bag.put(31, stack(Item::Lamp, 62));
    bag.click(30);
    bag.end_drag(31);
    assert_eq!(
        (bag.slots()[30], bag.slots()[31]),
        (Some(stack(Item::Lamp, 3)), Some(stack(Item::Lamp, 64)))
    );
    bag.click(31);
    bag.end_drag(SLOTS);
    assert_eq!(bag.slots()[31], Some(stack(Item::Lamp, 64)));
    bag.swap(31, 0);
    assert_eq!(
        (bag.slots()[0], bag.slots()[31]),
        (Some(stack(Item::Lamp, 64)), Some(stack(Item::Bullet, 64)))
    );
}

proptest! {
    /// Whatever is done, every thing is in a slot, at the pointer, or was handed out.
    #[test]
    fn nothing_is_lost_whatever_is_clicked(moves in prop::collection::vec((0u8..9, 0u8..45), 0..200)) {
        let mut bag = Inventory::default();
        let mut out = [0u32; Item::ALL.len()];
        let mut gone = |stack: Option<Stack>| {
            if let Some(stack) = stack {
                out[Item::ALL.iter().position(|item| *item == stack.item).unwrap()] += stack.count;
            }
        };
        for (kind, slot) in moves {
            match kind {
                0 | 1 => bag.click(slot),
                2 => bag.click_other(slot),
                3 => bag.send(slot),
                4 => gone(bag.let_go(slot % 2 == 0)),
                7 => bag.end_drag(slot),
                8 => bag.swap(slot, slot ^ 0b1_0101),
                5 => { bag.select(slot); gone(bag.take_held(slot % 3 == 0)); }
                _ => gone(bag.put_back()),
            }
        }
        gone(bag.put_back());
        for (item, out) in Item::ALL.into_iter().zip(out) {
            prop_assert_eq!(bag.count(item) + out, item.at_start());
        }
        prop_assert!(bag.slots().iter().flatten().all(|s| s.count > 0 && s.count <= s.item.most_in_slot()));
    }
}
