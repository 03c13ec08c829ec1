//! Things are made of gathered ground, by the recipes in the table of items. In creative worlds nothing is gathered or made.

use antipode_items::{Item, Made};
use antipode_terrain::{Kind, Stock};

use crate::drops;
use crate::inventory::Stack;
use crate::notice::Hint;
use crate::scene::Scene;
use crate::sound::SoundEvent;

/// How an item is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// What is made, and how many come of it.
    pub made: Stack,
    /// Of what, cubic metres of each.
    pub parts: Vec<(Kind, f64)>,
}

impl Recipe {
    /// The ways in which an item is made; none of what is not, and of those for which the table has a kind that there is not.
    pub fn of(item: Item) -> Vec<Self> {
        let way = |Made { count, of }: &Made| {
            let parts = of
                .iter()
                .map(|(name, m3)| Some((Kind::of_name(name)?, *m3)));
            Some(Self {
                made: Stack {
                    item,
                    count: *count,
                },
                parts: parts.collect::<Option<_>>()?,
            })
        };
        item.made().iter().filter_map(way).collect()
    }

    /// All of them: those of soft ground first, as they come in reach.
    pub fn all() -> Vec<Self> {
        let mut all: Vec<_> = Item::ALL.into_iter().flat_map(Self::of).collect();
        all.sort_by_key(Self::hardness);
        all
    }

    fn hardness(&self) -> Option<u8> {
        self.parts.iter().map(|(kind, _)| kind.hardness()).max()
    }

    fn price(&self) -> Stock {
        let mut price = Stock::default();
        for (kind, m3) in &self.parts {
            price.add(*kind, *m3);
        }
        price
    }
}

impl Scene {
    /// The ground that was gathered; none in creative worlds.
    pub fn stock(&self) -> Option<&Stock> {
        self.sim.world.streamer.stock()
    }

    /// Gives cubic metres of a kind of ground, or takes them if there is as much. Says whether that was done; in creative
    /// worlds it is not.
    pub fn give_ground(&mut self, kind: Kind, m3: f64) -> bool {
        let mut price = Stock::default();
        price.add(kind, -m3);
        self.kept.changed = true;
        self.sim.world.streamer.spend(&price)
    }

    /// Whether there is enough of all that a recipe takes.
    pub fn can_make(&self, recipe: &Recipe) -> bool {
        let price = recipe.price().negative();
        self.stock().is_some_and(|stock| stock.allows(&price))
    }

    /// Makes what a recipe says, if there is enough for it, and says whether it did. What finds no room is thrown before the
    /// player's feet.
    pub fn make(&mut self, recipe: &Recipe) -> bool {
        if !self.sim.world.streamer.spend(&recipe.price()) {
            return false;
        }
        self.kept.changed = true;
        let Stack { item, count } = recipe.made;
        let head = self.head();
        let sim = &mut self.sim;
        let mut left = sim.player.inventory.give(item, count);
        while left > 0 {
            let count = left.min(item.most_in_slot());
            let slots = &mut sim.player.inventory;
            let stack = Stack { item, count };
            drops::throw_away(&mut sim.actors, slots, &mut sim.outbox, &head, stack);
            left -= count;
        }
        sim.outbox.sounds.push(SoundEvent::PickedUp);
        sim.outbox.hints.push(Hint::Made(item, recipe.made.count));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_at_most_a_dozen_recipes_of_kinds_that_there_are() {
        let known = Recipe::all().len();
        let told: usize = Item::ALL.iter().map(|item| item.made().len()).sum();
        assert_eq!(known, told);
        assert!((6..=12).contains(&known));
    }

    /// Each pickaxe is made of what the one before it digs, from the first on.
    #[test]
    fn no_pickaxe_is_needed_to_make_itself() {
        let mut power = 1;
        for item in [Item::PickaxeWood, Item::PickaxeIron, Item::PickaxeDiamond] {
            let digs = |it: &Recipe| it.parts.iter().all(|(kind, _)| kind.hardness() <= power);
            assert!(Recipe::of(item).iter().any(digs), "{item:?}");
            power = item.power().unwrap_or_default();
        }
        let hardest = Kind::ALL.into_iter().map(Kind::hardness).max();
        assert!(hardest.is_some_and(|hardest| hardest <= power));
    }
}
