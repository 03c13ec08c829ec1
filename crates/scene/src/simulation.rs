//! The simulation: a world, its actors, the player and what is to be told of them. It is a pure function of save, seed
//! and actions; how it is shown has no part in it.

use crate::actors::Actors;
use crate::outbox::Outbox;
use crate::player::Player;
use crate::situation::Situation;
use crate::world::World;

/// All that a step changes.
pub(crate) struct Simulation {
    pub world: World,
    pub actors: Actors,
    pub player: Player,
    pub outbox: Outbox,
}

impl Simulation {
    /// How things stand, for a rule to ask before it changes anything.
    pub fn now(&self) -> Situation<'_> {
        Situation::of(&self.world, &self.actors, &self.player)
    }
}
