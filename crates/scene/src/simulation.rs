//! The simulation: a world, its actors, the player and what is to be told of them. It is a pure function of save, seed
//! and actions; how it is shown has no part in it.

use antipode_geometry::ChunkCoord;

use crate::actors::Actors;
use crate::outbox::Outbox;
use crate::player::Player;
use crate::situation::Situation;
use crate::world::World;
use crate::{body, ground_changed, tool};

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

    /// Marks anew where the tool in hand works, as after the view was set from outside a step.
    pub fn mark_tool(&mut self) {
        self.player.tool = tool::mark(self.now());
    }

    /// Frees a body that was put somewhere, or is stuck; returns whether that moved it.
    pub fn free_body(&mut self) -> bool {
        body::free(&self.world, &mut self.actors, &mut self.player)
    }

    /// Tells all that stands on it that the ground of these chunks has changed.
    pub fn tell_of_changed_ground(&mut self, chunks: &[ChunkCoord]) {
        ground_changed::tell(&self.world, &mut self.actors, chunks);
        body::lift_out(&self.world, &mut self.actors, &self.player);
    }
}
