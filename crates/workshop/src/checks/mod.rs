//! What may be wrong with a room that is being edited, as far as rules cannot tell: each a finding in words, with the objects and
//! the place that it leads to. What rules tell ([`antipode_rooms::check_each`]) is refused when it is edited, and is not said again.

mod area;
mod cells;
mod fits;
mod flood;
mod ground;
mod parts;
mod sides;
mod spawn;
mod worker;

use antipode_deformation::WalkerShape;
use antipode_rooms::solids::{solids, standing};
use antipode_rooms::{Assets, Room, space_in_parts};
use glam::DVec3;

use crate::said::Said;
use ground::Ground;

pub use worker::{Checker, Findings};

/// The ids of all findings. Each has `name`, and `other` where a second object has a part in it; `spawn-in-air` and `fall-out`
/// have `metres` in place of names.
pub const FINDINGS: [&str; 21] = [
    "not-parallel",
    "too-deep",
    "tangled",
    "no-door",
    "out-of-range",
    "no-partner",
    "one-way",
    "other-sides",
    "not-similar",
    "other-size",
    "portal-shape",
    "over-side",
    "in-odd-box",
    "portals-touch",
    "walls-across",
    "same-place",
    "spawn-in-solid",
    "spawn-in-air",
    "open-sides",
    "fall-out",
    "unreached",
];

/// Something that may be wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// What, in words; its id is one of [`FINDINGS`].
    pub said: Said,
    /// Whether something does not work as it stands. Else it may be meant so.
    pub is_grave: bool,
    /// The names of the objects that it leads to; none for what concerns the room.
    pub objects: Vec<String>,
    /// Where it is, metres of the room.
    pub at: DVec3,
}

/// Whether the search may go on: false as soon as a newer room is to be looked at.
pub(crate) type GoesOn<'a> = &'a dyn Fn() -> bool;

/// Everything that is found in a room. `early` is shown what is found at once, before the search for ways begins, which takes
/// longest. `shape` is who walks in it.
pub fn find(
    room: &Room,
    assets: &Assets,
    shape: &WalkerShape,
    goes_on: &dyn Fn() -> bool,
    early: &mut dyn FnMut(&[Finding]),
) -> Vec<Finding> {
    let so_far = space_in_parts(room);
    let mut found = fits::find(room, &so_far);
    found.extend(fits::find_walls_across(room, &so_far));
    let solids = solids(&standing(room, assets));
    if !goes_on() {
        return found;
    }
    let ground = Ground {
        space: &so_far.space,
        solids: &solids,
        gravity: room.gravity,
        shape: *shape,
    };
    let start = spawn::find(room, &ground, &mut found);
    sides::find(room, &so_far, &ground, goes_on, &mut found);
    early(&found);
    if let Some(start) = start {
        parts::find(room, &so_far, &ground, &start, goes_on, &mut found);
    }
    found
}
