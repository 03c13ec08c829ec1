//! The scene: how a world is opened and stepped.

use std::sync::Arc;

use antipode_geometry::strategy;
use antipode_storage::{StorageError, WorldState, WorldStore};
use antipode_streaming::{Config, Streamer};
use antipode_terrain::Field;

use crate::actions::Actions;
use crate::actors::Actors;
use crate::hand::HandStep;
use crate::keeping::Keeping;
use crate::lens::Lens;
use crate::notice::Notice;
use crate::outbox::Outbox;
use crate::persist::{self, finite_or};
use crate::player::{Look, Player};
use crate::presentation::Presentation;
use crate::setup::{SceneError, WorldSetup};
use crate::simulation::Simulation;
use crate::situation::Situation;
use crate::spawn::first_pitch_rad;
#[cfg(doc)]
use crate::tuning::STEP_S;
use crate::world::World;

/// How many damaged places of a save are told one by one.
const MOST_PROBLEMS_TOLD: usize = 3;

/// One world being played.
pub struct Scene {
    pub(crate) sim: Simulation,
    pub(crate) shown: Presentation,
    pub(crate) kept: Keeping,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Scene")
            .field("setup", &self.sim.world.setup)
            .field("simulated_s", &self.sim.world.simulated_s)
            .finish_non_exhaustive()
    }
}

impl Scene {
    /// Opens a world: the state its store holds if it has one, else a new player on fresh ground. What is damaged
    /// in the store is left out and told in the notices.
    ///
    /// # Errors
    /// When the store cannot be read at all or the chunk workers cannot start.
    pub fn open(setup: WorldSetup, store: Option<Arc<WorldStore>>) -> Result<Self, SceneError> {
        Self::open_with(setup, store, Config::default().workers)
    }

    /// As [`Scene::open`], with so many chunk workers.
    ///
    /// # Errors
    /// As [`Scene::open`].
    pub fn open_with(
        setup: WorldSetup,
        store: Option<Arc<WorldStore>>,
        workers: usize,
    ) -> Result<Self, SceneError> {
        let strategy = strategy(setup.geometry, setup.radius_m);
        let field = Arc::new(Field::new(setup.seed, Arc::clone(&strategy)));
        let (saved, notices) = match &store {
            Some(store) => saved_state(store)?,
            None => (None, Vec::new()),
        };
        let meta = store.as_ref().map(|s| s.meta()).unwrap_or_default();
        let stored = store.is_some();
        let config = Config {
            workers,
            ..Config::default()
        };
        let streamer = Streamer::start(Arc::clone(&field), strategy, store, config)?;
        let mut scene = Self::fresh(setup, &field, streamer);
        scene.sim.outbox.notices = notices;
        scene.kept.stored = stored;
        scene.kept.created_unix_s = meta.created_unix_s;
        scene.kept.cheated = meta.cheated;
        if let Some(state) = saved {
            scene.restore(&state);
        } else {
            // Of a world whose state is damaged that much is known.
            scene.sim.world.set_simulated_s(meta.played_s);
            let pitch = first_pitch_rad(&field, &scene.head(), &*scene.now().aiming().strategy);
            let actors = &mut scene.sim.actors;
            if let Ok(mut look) = actors.ecs.get::<&mut Look>(actors.player) {
                look.pitch = pitch;
            }
        }
        scene.kept.saved_at_s = scene.sim.world.simulated_s;
        scene.kept.changed = false;
        scene.request_ground();
        Ok(scene)
    }

    /// A world that nobody has played yet, and that is kept nowhere.
    fn fresh(setup: WorldSetup, field: &Arc<Field>, streamer: Streamer) -> Self {
        let lens = Lens::new(setup.geometry, setup.radius_m);
        Self {
            sim: Simulation {
                world: World::new(setup.within_range(), field, streamer),
                actors: Actors::new(field),
                player: Player::new(lens),
                outbox: Outbox::default(),
            },
            shown: Presentation::default(),
            kept: Keeping::default(),
        }
    }

    /// Takes a saved state in. Numbers that no play could have produced are replaced by the start's.
    fn restore(&mut self, state: &WorldState) {
        let Simulation {
            world,
            actors,
            player,
            outbox,
        } = &mut self.sim;
        let unknown = &mut self.kept.unknown;
        let placed = persist::restore_player(world, actors, player, &state.player);
        outbox.notices.extend(placed.err());
        world.centre_on_body(actors.feet());
        let notices = persist::restore_belongings(world, player, unknown, state);
        outbox.notices.extend(notices);
        let notices = persist::restore_things(world, actors, unknown, state);
        outbox.notices.extend(notices);
        persist::restore_cars(world, actors, player, state);
        world.set_time_of_day_s(finite_or(state.time_of_day_s, 0.0));
        let pictured = persist::restore_lens(&mut player.gaze.lens, state);
        outbox.notices.extend(pictured.err());
        world.set_simulated_s(state.simulated_s);
    }

    /// How things stand.
    pub(crate) fn now(&self) -> Situation<'_> {
        self.sim.now()
    }

    /// Advances the world by one step of [`STEP_S`] seconds.
    ///
    /// While the ground around the player is not there yet the body is held still; everything else goes on.
    pub fn step(&mut self, actions: &Actions) {
        self.kept.changed = true;
        self.sim.step(actions);
        self.renew_picture();
        let still = self.shown.viewing.reduced_motion;
        self.shown.hand.step(&HandStep::of(&self.sim), still);
        self.autosave();
    }
}

/// The state a store holds, and what is damaged in it. A damaged player must not lock a whole world.
fn saved_state(store: &WorldStore) -> Result<(Option<WorldState>, Vec<Notice>), StorageError> {
    let state = match store.state() {
        Err(StorageError::Damaged { .. }) => {
            // The next autosave writes over it.
            match store.keep_copy() {
                Ok(kept) => tracing::warn!("the damaged world is kept as {}", kept.display()),
                Err(error) => tracing::error!("the damaged world could not be kept: {error}"),
            }
            None
        }
        other => other?,
    };
    let problems = store.problems();
    let more = problems.len().saturating_sub(MOST_PROBLEMS_TOLD);
    let told = problems.into_iter().take(MOST_PROBLEMS_TOLD);
    let more = (more > 0).then_some(Notice::MoreDamaged(more));
    Ok((state, told.map(Notice::Damaged).chain(more).collect()))
}
