//! The world itself: its space, its land and its day. Nobody lives in it; who does is in `actors`.

use std::sync::Arc;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord, Strategy};
use antipode_physics::PhysicsWorld;
use antipode_streaming::{Reach, Streamer};
use antipode_terrain::Field;
use glam::DVec3;

use crate::ground::Ground;
use crate::setup::WorldSetup;
use crate::tuning::{BODIES_WITHIN_CHUNKS, DAY_START_S};

/// A reach that ends where a chunk does ends short of it by so much, metres.
const SHORT_OF_NEXT_M: f64 = 1e-3;

/// A space with land in it.
pub(crate) struct World {
    pub setup: WorldSetup,
    pub strategy: Arc<dyn Strategy>,
    pub streamer: Streamer,
    /// Finished land waits: see [`crate::Scene::hold_land`].
    pub holds_land: bool,
    pub physics: PhysicsWorld,
    pub ground: Ground,
    /// The chunk of the player's head when the step began: bodies move about it.
    pub bodies_about: ChunkCoord,
    pub time_of_day_s: f64,
    pub simulated_s: f64,
}

impl World {
    /// A world that has just begun, with no land in it yet.
    pub fn new(setup: WorldSetup, field: &Arc<Field>, streamer: Streamer) -> Self {
        let strategy = Arc::clone(field.strategy());
        Self {
            setup,
            ground: Ground::new(Arc::clone(field), Arc::clone(&strategy)),
            strategy,
            streamer,
            holds_land: false,
            physics: PhysicsWorld::new(),
            bodies_about: ChunkCoord::containing(ChartPoint::a(DVec3::ZERO)),
            time_of_day_s: DAY_START_S,
            simulated_s: 0.0,
        }
    }

    /// Whether bodies move in a chunk: in an open world within a distance of the player that is always the same, however
    /// far the view is; in a closed one everywhere.
    pub fn lets_move(&self, coord: ChunkCoord) -> bool {
        let about = self.bodies_about;
        let apart = coord.index.as_i64vec3() - about.index.as_i64vec3();
        self.strategy.rim_m().is_some()
            || coord.hemisphere == about.hemisphere
                && apart.abs().max_element() <= i64::from(BODIES_WITHIN_CHUNKS)
    }

    /// Whether a body may move in a chunk now: it is near enough, and all that it has of ground is there.
    pub fn is_firm(&self, coord: ChunkCoord) -> bool {
        self.lets_move(coord) && self.streamer.is_ready(coord)
    }

    /// What of a reach lies where bodies move.
    pub fn within_bodies(&self, reach: &Reach) -> Option<Reach> {
        if self.strategy.rim_m().is_some() {
            return Some(*reach);
        }
        let (cell, within) = (f64::from(CHUNK_CELLS), f64::from(BODIES_WITHIN_CHUNKS));
        let low = self.bodies_about.origin() - cell * within;
        // The least of a reach is its own chunk's, so it has to end short of the next.
        let high = self.bodies_about.origin() + cell * (within + 1.0) - SHORT_OF_NEXT_M;
        let (min, max) = (reach.min.max(low), reach.max.min(high));
        let there = reach.hemisphere == self.bodies_about.hemisphere && min.cmple(max).all();
        there.then_some(Reach { min, max, ..*reach })
    }
}
