//! What a player is given, and what is made.

use antipode_scene::{Item, Kind, Recipe};

use super::{Order, number, quoted, whole};

/// Most cubic metres that are given at once.
const MOST_M3: f64 = 1e6;

/// `give ITEM N` and `give KIND M3`.
pub(super) fn give(what: &str, count: &str) -> Result<Order, String> {
    if let Some(kind) = Kind::of_name(what) {
        return Ok(Order::GiveGround(kind, number(count, 0.0, MOST_M3)?));
    }
    let item = Item::from_id(what).ok_or_else(|| {
        let ids = Item::ALL.map(Item::id).join(", ");
        format!(
            "there is neither an item nor ground {}; there are the items {ids} and kinds such as coal",
            quoted(what)
        )
    })?;
    Ok(Order::Give(item, whole(count, 1, 9999)?))
}

/// `make ITEM`.
pub(super) fn make(item: &str) -> Result<Order, String> {
    let known = Item::from_id(item).filter(|item| !Recipe::of(*item).is_empty());
    let order = known.map(Order::Make);
    order.ok_or_else(|| {
        let all = Recipe::all();
        let ids: Vec<_> = all.iter().map(|recipe| recipe.made.item.id()).collect();
        format!("{} is not made; there are {}", quoted(item), ids.join(", "))
    })
}
