//! The scene: how a world is opened and stepped.

use std::sync::Arc;

use antipode_geometry::{Strategy, strategy};
use antipode_storage::{CourseRecord, Records, SCHEMA_VERSION, StorageError, WorldStore};
use antipode_streaming::{Config, Streamer};
use antipode_terrain::Field;

use crate::actions::Actions;
use crate::actors::Actors;
use crate::door;
use crate::inventory::Inventory;
use crate::keeping::Keeping;
use crate::lens::Lens;
use crate::notice::Notice;
use crate::outbox::Outbox;
use crate::player::{Look, Player};
use crate::presentation::Presentation;
use crate::restore::{self, finite_or};
use crate::setup::{Mode, SceneError, WorldSetup};
use crate::situation::Situation;
use crate::spawn::first_pitch_rad;
use crate::step::Simulation;
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
        let space = strategy(setup.geometry, setup.radius_m);
        Self::open_in(space, setup, store, workers)
    }

    /// As [`Scene::open_with`], in a space that need not be the one that the setup names.
    ///
    /// # Errors
    /// As [`Scene::open`].
    pub fn open_in(
        space: Arc<dyn Strategy>,
        setup: WorldSetup,
        store: Option<Arc<WorldStore>>,
        workers: usize,
    ) -> Result<Self, SceneError> {
        let atlas = Arc::<dyn Strategy>::clone(&space);
        let field = Arc::new(Field::made_by(setup.generator, setup.seed, atlas));
        let (saved, notices) = match &store {
            Some(store) => saved_records(store)?,
            None => Default::default(),
        };
        let meta = store.as_ref().map(|s| s.meta()).unwrap_or_default();
        let player = saved.player().map(|kept| kept.body.chart);
        if player.is_some_and(|chart| restore::chart(&*space, chart).is_none()) {
            // Only a later game has put him where this space has nothing.
            return Err(SceneError::Storage(StorageError::Newer {
                world: meta.name,
                found: SCHEMA_VERSION + 1,
            }));
        }
        let stored = store.is_some();
        let config = Config {
            workers,
            ..Config::default()
        };
        let charts = Arc::<dyn Strategy>::clone(&space);
        let mut streamer = Streamer::start(Arc::clone(&field), charts, store, config)?;
        if setup.mode == Mode::Gathering {
            streamer.gather(saved.earth());
        }
        let mut scene = Self::fresh(setup, space, &field, streamer);
        scene.sim.outbox.notices = notices;
        scene.kept.stored = stored;
        scene.kept.created_unix_s = meta.created_unix_s;
        scene.kept.cheated = meta.cheated;
        let has_player = saved.player().is_some();
        scene.restore(saved, meta.played_s);
        if !has_player {
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
    fn fresh(
        setup: WorldSetup,
        space: Arc<dyn Strategy>,
        field: &Arc<Field>,
        streamer: Streamer,
    ) -> Self {
        let lens = Lens::new(Arc::clone(&space));
        let actors = Actors::new(field, &space);
        let player = Player::new(lens, Inventory::at_start(setup.mode));
        Self {
            sim: Simulation {
                world: World::new(setup.within_range(), space, field, streamer),
                actors,
                player,
                outbox: Outbox::default(),
            },
            shown: Presentation::default(),
            kept: Keeping::default(),
        }
    }

    /// Takes what a save holds in. Of a world whose course is damaged, or that nobody has played, it is known how long
    /// it was played, in seconds.
    fn restore(&mut self, records: Records, played_s: f64) {
        let Simulation {
            world,
            actors,
            player,
            outbox,
        } = &mut self.sim;
        let notices = &mut outbox.notices;
        if let Some(kept) = records.player() {
            self.kept.unknown_slots = restore::player(world, actors, player, kept, notices);
            world.centre_on_body(actors.feet());
        }
        let driving = records.player().and_then(|kept| kept.driving);
        let lens = &mut player.gaze.lens;
        let (taken, course) = restore::things(world, actors, lens, records, notices);
        self.kept.handed = taken;
        restore::seat(world, actors, player, driving);
        world.doors = door::pair(&*world.strategy, actors);
        let course = course.unwrap_or(CourseRecord {
            time_of_day_s: world.time_of_day_s,
            simulated_s: played_s,
            car_given: false,
        });
        actors.cars.given = course.car_given;
        world.set_time_of_day_s(finite_or(course.time_of_day_s, 0.0));
        // Not before: the minds of figures begin at the time of a world that was just opened.
        world.set_simulated_s(course.simulated_s);
        self.shown.sills.renew(world);
    }

    /// How things stand.
    pub(crate) fn now(&self) -> Situation<'_> {
        Situation::of(&self.sim.world, &self.sim.actors, &self.sim.player)
    }

    /// Advances the world by one step of [`STEP_S`] seconds.
    ///
    /// While the ground around the player is not there yet the body is held still; everything else goes on.
    pub fn step(&mut self, actions: &Actions) {
        self.kept.changed = true;
        self.sim.step(actions);
        self.renew_picture();
        let Simulation {
            world,
            actors,
            player,
            outbox,
        } = &mut self.sim;
        let now = Situation::of(world, actors, player);
        let still = self.shown.viewing.reduced_motion;
        crate::hand::step(&mut self.shown.hand, now, outbox.fired, still);
        let changed = std::mem::take(&mut outbox.ground_changed);
        if !changed.is_empty() {
            self.shown.particles.ground_changed(world, &changed);
        }
        self.shown.particles.step(now, &mut outbox.effects);
        self.shown.sills.renew(world);
        self.autosave();
    }
}

/// What a store holds, and what is damaged in it. A damaged player must not lock a whole world.
fn saved_records(store: &WorldStore) -> Result<(Records, Vec<Notice>), StorageError> {
    let records = store.records()?;
    let problems = store.problems();
    if records.player().is_none() && !problems.is_empty() {
        // The next autosave writes over it.
        match store.keep_copy() {
            Ok(kept) => tracing::warn!("the damaged world is kept as {}", kept.display()),
            Err(error) => tracing::error!("the damaged world could not be kept: {error}"),
        }
    }
    let more = problems.len().saturating_sub(MOST_PROBLEMS_TOLD);
    let told = problems.into_iter().take(MOST_PROBLEMS_TOLD);
    let more = (more > 0).then_some(Notice::MoreDamaged(more));
    Ok((records, told.map(Notice::Damaged).chain(more).collect()))
}
