//! The world itself: its space, its land and its day. Nobody lives in it; who does is in `actors`.

use std::sync::Arc;

use antipode_geometry::Strategy;
use antipode_physics::PhysicsWorld;
use antipode_streaming::Streamer;
use antipode_terrain::Field;

use crate::ground::Ground;
use crate::setup::WorldSetup;
use crate::tuning::DAY_START_S;

/// A space with land in it.
pub(crate) struct World {
    pub setup: WorldSetup,
    pub strategy: Arc<dyn Strategy>,
    pub streamer: Streamer,
    /// Finished land waits: see [`crate::Scene::hold_land`].
    pub holds_land: bool,
    pub physics: PhysicsWorld,
    pub ground: Ground,
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
            time_of_day_s: DAY_START_S,
            simulated_s: 0.0,
        }
    }
}
