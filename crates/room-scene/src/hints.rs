//! Short answers to what one does in a room, where it does nothing or something else than was asked for.

use crate::scene::RoomScene;

/// The most that is kept for a host that never asks, such as a script.
const MOST: usize = 16;

/// A short answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoomHint {
    /// There is nothing within reach that a lamp could be put on.
    NoPlaceForLamp,
    /// The room's own lamps are as many as can shine.
    TooManyLamps,
    /// There is nothing loose within reach.
    NothingToLift,
    /// It is too heavy to be lifted.
    TooHeavy,
    /// Who walks has fallen out of the room, and begins anew.
    FellOut,
}

impl RoomScene {
    /// What there is to answer since it was last asked.
    pub fn take_hints(&mut self) -> Vec<RoomHint> {
        std::mem::take(&mut self.hints)
    }

    pub(crate) fn hint(&mut self, hint: RoomHint) {
        if self.hints.len() < MOST {
            self.hints.push(hint);
        }
    }
}
