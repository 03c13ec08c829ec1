//! Who and what lives, moves or lies about in a world.

use antipode_physics::CharacterTuning;
use antipode_terrain::Field;
use hecs::Entity;

use crate::car::Cars;
use crate::drops::Drop;
use crate::lamp::Lamp;
use crate::npc::Npcs;
use crate::player::{self, Look};
use crate::projectile::Projectiles;
use crate::spawn::{FIRST_YAW_RAD, spawn_point};

/// All actors of a world.
pub(crate) struct Actors {
    pub ecs: hecs::World,
    pub player: Entity,
    pub tuning: CharacterTuning,
    pub cars: Cars,
    pub projectiles: Projectiles,
    pub lamps: Vec<Lamp>,
    pub drops: Vec<Drop>,
    /// Whether the ground may have changed below lamps, or below things that lie about.
    pub lamps_unchecked: bool,
    pub drops_unchecked: bool,
    /// The number that the next bot gets.
    pub next_bot: u32,
    /// What other figures have in common.
    pub npcs: Npcs,
}

impl Actors {
    /// A player who has just come, alone.
    pub fn new(field: &Field) -> Self {
        let mut ecs = hecs::World::new();
        let look = Look {
            yaw: FIRST_YAW_RAD,
            pitch: 0.0,
        };
        let player = ecs.spawn(player::components(spawn_point(field), look));
        Self {
            ecs,
            player,
            tuning: CharacterTuning::default(),
            cars: Cars::default(),
            projectiles: Projectiles::default(),
            lamps: Vec::new(),
            drops: Vec::new(),
            lamps_unchecked: false,
            drops_unchecked: false,
            next_bot: 0,
            npcs: Npcs::default(),
        }
    }
}
