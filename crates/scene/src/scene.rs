//! The scene: one world, its player and its ground, and what others may ask of it.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Eye, Strategy, strategy};
use antipode_storage::{Records, StorageError, WorldStore};
use antipode_streaming::{Config, Streamer};
use antipode_terrain::{Biome, Field};
use glam::DVec3;

use crate::actors::Actors;
use crate::aimed::Optics;
use crate::camera::{self, CameraMode, CameraPose};
use crate::day;
use crate::frame::{Marker, Quality};
use crate::inventory::Inventory;
use crate::keeping::Keeping;
use crate::lens::Lens;
use crate::notice::{Hint, Notice};
use crate::outbox::Outbox;
use crate::player::{self, Appearance, Body, Health, Look, Player, Position};
use crate::presentation::Presentation;
use crate::setup::{SceneError, WorldSetup};
use crate::tuning::VIEW_DISTANCE_CHUNKS;
use crate::world::World;

/// How many damaged places of a save are told one by one.
const MOST_PROBLEMS_TOLD: usize = 3;

/// One world being played.
pub struct Scene {
    pub(crate) world: World,
    pub(crate) actors: Actors,
    pub(crate) player: Player,
    pub(crate) shown: Presentation,
    pub(crate) kept: Keeping,
    pub(crate) outbox: Outbox,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Scene")
            .field("setup", &self.world.setup)
            .field("simulated_s", &self.world.simulated_s)
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
        let strategy = strategy(setup.geometry, setup.radius_m);
        let field = Arc::new(Field::new(setup.seed, Arc::clone(&strategy)));
        let (saved, notices) = match &store {
            Some(store) => saved_records(store)?,
            None => Default::default(),
        };
        let meta = store.as_ref().map(|s| s.meta()).unwrap_or_default();
        let stored = store.is_some();
        let streamer = Streamer::start(Arc::clone(&field), strategy, store, Config::default())?;
        let mut scene = Self::fresh(setup, &field, streamer);
        scene.outbox.notices = notices;
        scene.kept.stored = stored;
        scene.kept.created_unix_s = meta.created_unix_s;
        scene.kept.cheated = meta.cheated;
        let has_player = saved.player().is_some();
        scene.restore(saved, meta.played_s);
        if !has_player {
            scene.look_at_ground(&field);
        }
        scene.kept.changed = false;
        scene.request_ground();
        Ok(scene)
    }

    /// A world that nobody has played yet, and that is kept nowhere.
    fn fresh(setup: WorldSetup, field: &Arc<Field>, streamer: Streamer) -> Self {
        let lens = Lens::new(setup.geometry, setup.radius_m);
        Self {
            world: World::new(setup.within_range(), field, streamer),
            actors: Actors::new(field),
            player: Player::new(lens),
            shown: Presentation::default(),
            kept: Keeping::default(),
            outbox: Outbox::default(),
        }
    }

    /// What makes this world the one it is.
    pub fn setup(&self) -> &WorldSetup {
        &self.world.setup
    }

    /// Name of the biome of this seed.
    pub fn biome(&self) -> &'static str {
        Biome::from_seed(self.world.setup.seed).name()
    }

    /// The strategy of the world itself; pictures are taken with that of [`Scene::lens`].
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.world.strategy
    }

    /// The player's hotbar.
    pub fn inventory(&self) -> &Inventory {
        &self.player.inventory
    }

    /// The player's hotbar, to change it.
    pub fn inventory_mut(&mut self) -> &mut Inventory {
        self.kept.changed = true;
        &mut self.player.inventory
    }

    /// Radius of the brush in metres.
    pub fn brush_radius_m(&self) -> f64 {
        self.player.brush_radius_m
    }

    /// Time of day in seconds, 0 to 600.
    pub fn time_of_day_s(&self) -> f64 {
        self.world.time_of_day_s
    }

    /// The time of day where the player is, in seconds, 0 to 600; none at the poles of the sun's way.
    pub fn local_time_s(&self) -> Option<f64> {
        day::local_time_s(self.world.time_of_day_s, &*self.world.strategy, self.feet())
    }

    /// Sets the time of day in seconds; it wraps at a day's length.
    pub fn set_time_of_day_s(&mut self, time_s: f64) {
        self.world.time_of_day_s = time_s.rem_euclid(crate::tuning::DAY_S);
        self.kept.changed = true;
    }

    /// Simulated time since the world was made, in seconds.
    pub fn simulated_s(&self) -> f64 {
        self.world.simulated_s
    }

    /// Whether a command that cheats was ever used in this world.
    pub fn cheated(&self) -> bool {
        self.kept.cheated
    }

    /// Marks the world as one in which a command that cheats was used, for ever.
    pub fn mark_cheated(&mut self) {
        self.kept.cheated = true;
        self.kept.changed = true;
    }

    /// Whether the player flies as a spectator.
    pub fn flying(&self) -> bool {
        self.player.flying
    }

    /// Lets the player fly as a spectator, out of a car, through everything and without weight, or walk again. Whose
    /// flight ends inside the ground is lifted out of it in the next step.
    pub fn set_flying(&mut self, flying: bool) {
        if flying {
            self.get_out();
        }
        self.player.body_unchecked |= self.player.flying && !flying;
        self.player.flying = flying;
        self.kept.changed = true;
    }

    /// How far chunks are loaded.
    pub fn view_distance(&self) -> u32 {
        self.world.setup.view_distance
    }

    /// Sets how far chunks are loaded, within the allowed range.
    pub fn set_view_distance(&mut self, chunks: u32) {
        let (least, most, _) = VIEW_DISTANCE_CHUNKS;
        self.world.setup.view_distance = chunks.clamp(least, most);
        self.kept.changed = true;
        self.request_ground();
    }

    /// Sets the player's health, kept within 0 and full.
    pub fn set_health(&mut self, health: f64) {
        if let Ok(mut own) = self.actors.ecs.get::<&mut Health>(self.actors.player) {
            own.0 = health.clamp(0.0, crate::tuning::FULL_HEALTH);
        }
        self.kept.changed = true;
    }

    /// Points the view, in radians.
    pub fn aim(&mut self, yaw_rad: f64, pitch_rad: f64) {
        if let Ok(mut look) = self.actors.ecs.get::<&mut Look>(self.actors.player) {
            *look = Look {
                yaw: 0.0,
                pitch: 0.0,
            };
            look.turn(yaw_rad, pitch_rad);
        }
        if let Some(driving) = &mut self.actors.cars.driving {
            driving.chase.aim(yaw_rad, pitch_rad);
        }
        self.kept.changed = true;
        self.update_marker();
    }

    /// The player's feet, view and body.
    pub(crate) fn player_parts(&self) -> (Position, Look, Body, Appearance) {
        let fallback = || {
            let (p, l, b, _, a) = player::components(
                ChartPoint::a(DVec3::ZERO),
                Look {
                    yaw: 0.0,
                    pitch: 0.0,
                },
            );
            (p, l, b, a)
        };
        self.actors
            .ecs
            .query_one::<(&Position, &Look, &Body, &Appearance)>(self.actors.player)
            .get()
            .map_or_else(|_| fallback(), |(p, l, b, a)| (*p, *l, b.clone(), *a))
    }

    /// Where the player's feet are.
    pub fn feet(&self) -> ChartPoint {
        self.player_parts().0.0
    }

    /// The eye in the player's head, as the simulation has it.
    pub fn head(&self) -> Eye {
        self.head_through(&self.aiming())
    }

    /// The eye in the player's head, looking through that.
    pub(crate) fn head_through(&self, optics: &Optics) -> Eye {
        if let Some(head) = self.driver_head(optics) {
            return head;
        }
        let (position, look, ..) = self.player_parts();
        // Seen from behind, the body does not dip, and the camera would shake without a cause.
        let dip_m = match self.shown.camera {
            CameraMode::First if optics.dips => self.shown.dip.depth_m(),
            CameraMode::First | CameraMode::Third => 0.0,
        };
        let height_m = self.actors.tuning.eye_height_m() - dip_m;
        player::eye(&position, &look, optics.dial, height_m)
    }

    /// The eye the picture is taken from.
    pub fn eye(&self) -> Eye {
        self.camera_pose().eye
    }

    /// The camera that pictures are taken with.
    pub(crate) fn camera_pose(&self) -> CameraPose {
        self.camera_through(&self.picturing())
    }

    /// The camera, looking through that.
    pub(crate) fn camera_through(&self, optics: &Optics) -> CameraPose {
        if let Some(camera) = self.driver_camera(optics) {
            return camera;
        }
        let mut head = self.head_through(optics);
        if let Some(dead_s) = self
            .dead_s()
            .filter(|_| self.shown.camera == CameraMode::First)
        {
            head = camera::fallen(
                &head,
                if optics.reduced_motion {
                    f64::INFINITY
                } else {
                    dead_s
                },
            );
        }
        camera::place(
            self.shown.camera,
            &head,
            &*optics.strategy,
            &self.world.physics,
        )
    }

    /// From where the player sees the world.
    pub fn camera_mode(&self) -> CameraMode {
        self.shown.camera
    }

    /// Where the brush of a tool in hand would work.
    pub fn marker(&self) -> Option<Marker> {
        self.shown.marker
    }

    /// How much exactness pictures trade for speed.
    pub fn quality(&self) -> Quality {
        self.shown.quality
    }

    /// Sets how much exactness pictures trade for speed; no part of the world, so nothing of it is saved.
    pub fn set_quality(&mut self, quality: Quality) {
        self.shown.quality = quality;
    }

    /// What has gone wrong since they were last taken.
    pub fn take_notices(&mut self) -> Vec<Notice> {
        std::mem::take(&mut self.outbox.notices)
    }

    /// Short answers to what the player did that have come up since they were last taken.
    pub fn take_hints(&mut self) -> Vec<Hint> {
        std::mem::take(&mut self.outbox.hints)
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
