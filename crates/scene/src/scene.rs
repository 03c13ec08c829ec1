//! The scene: one world, its player and its ground, and what others may ask of it.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Eye, Strategy, strategy};
use antipode_physics::{CharacterTuning, PhysicsWorld};
use antipode_storage::{StorageError, WorldState, WorldStore};
use antipode_streaming::{Config, Streamer};
use antipode_terrain::{Biome, Field};
use glam::DVec3;
use hecs::Entity;

use crate::camera::{self, CameraMode, CameraPose};
use crate::car::Cars;
use crate::day;
use crate::detail::Sight;
use crate::dip::HeadDip;
use crate::drops::Drop;
use crate::frame::{Marker, Quality};
use crate::ground::Ground;
use crate::hand::HandMotion;
use crate::harm::Condition;
use crate::inventory::Inventory;
use crate::lamp::Lamp;
use crate::lens::Lens;
use crate::notice::{Hint, Notice};
use crate::npc::Npcs;
use crate::persist::{LONGEST_PLAYED_S, Unknown, finite_or};
use crate::player::{self, Appearance, Body, Health, Look, Position};
use crate::projectile::Projectiles;
use crate::round::Round;
use crate::setup::{SceneError, WorldSetup};
use crate::sound::Sounds;
use crate::spawn::{FIRST_YAW_RAD, spawn_point};
use crate::tuning::{BRUSH_RADIUS_M, DAY_START_S, PICTURE_HEIGHT_PX, VIEW_DISTANCE_CHUNKS};
use crate::viewing::Viewing;

/// How many damaged places of a save are told one by one.
const MOST_PROBLEMS_TOLD: usize = 3;

/// One world being played.
pub struct Scene {
    pub(crate) setup: WorldSetup,
    pub(crate) strategy: Arc<dyn Strategy>,
    pub(crate) streamer: Streamer,
    pub(crate) physics: PhysicsWorld,
    pub(crate) ground: Ground,
    pub(crate) ecs: hecs::World,
    pub(crate) player: Entity,
    pub(crate) tuning: CharacterTuning,
    pub(crate) inventory: Inventory,
    pub(crate) lens: Lens,
    pub(crate) camera: CameraMode,
    pub(crate) brush_radius_m: f64,
    pub(crate) marker: Option<Marker>,
    pub(crate) flying: bool,
    pub(crate) time_of_day_s: f64,
    pub(crate) simulated_s: f64,
    /// No hostile figure comes before that time.
    pub(crate) peace_until_s: f64,
    pub(crate) saved_at_s: f64,
    pub(crate) viewing: Viewing,
    pub(crate) dip: HeadDip,
    pub(crate) quality: Quality,
    pub(crate) notices: Vec<Notice>,
    pub(crate) hints: Vec<Hint>,
    pub(crate) stored: bool,
    pub(crate) save_problem: Option<Notice>,
    pub(crate) created_unix_s: u64,
    /// Whether a command that cheats was ever used in this world.
    pub(crate) cheated: bool,
    /// Whether anything but the terrain may differ from what was last given to be saved.
    pub(crate) changed: bool,
    /// Where the player stands up again, unless the land alone decides.
    pub(crate) start: Option<ChartPoint>,
    pub(crate) round: Round,
    /// Whether the body was put where it is and may be stuck there.
    pub(crate) body_unchecked: bool,
    /// Lines of a picture.
    pub(crate) picture_height_px: u32,
    /// The sizes in the picture that the chunk workers go by; none if everything is to be full.
    pub(crate) sight: Option<Arc<Sight>>,
    /// A camera that is elsewhere than the player: land is made around it.
    pub(crate) watched: Option<Eye>,
    pub(crate) condition: Condition,
    pub(crate) cars: Cars,
    pub(crate) projectiles: Projectiles,
    /// Whether bullets follow the space's geodesics.
    pub(crate) straight_shots: bool,
    /// Until the gun can be fired again, seconds.
    pub(crate) gun_rests_s: f64,
    /// Whether each button was down in the step before.
    pub(crate) primary_before: bool,
    pub(crate) secondary_before: bool,
    /// How what is in the player's hand moves.
    pub(crate) hand: HandMotion,
    pub(crate) flashlight: bool,
    pub(crate) lamps: Vec<Lamp>,
    /// Whether the ground may have changed below lamps, or below things that lie about.
    pub(crate) lamps_unchecked: bool,
    pub(crate) drops_unchecked: bool,
    pub(crate) drops: Vec<Drop>,
    /// The number that the next bot gets.
    pub(crate) next_bot: u32,
    /// What other figures have in common.
    pub(crate) npcs: Npcs,
    /// What could be heard since somebody last listened.
    pub(crate) sounds: Sounds,
    pub(crate) unknown: Unknown,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Scene")
            .field("setup", &self.setup)
            .field("simulated_s", &self.simulated_s)
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
            Some(store) => saved_state(store)?,
            None => (None, Vec::new()),
        };
        let meta = store.as_ref().map(|s| s.meta()).unwrap_or_default();
        let stored = store.is_some();
        let streamer = Streamer::start(Arc::clone(&field), strategy, store, Config::default())?;
        let mut scene = Self {
            notices,
            stored,
            created_unix_s: meta.created_unix_s,
            cheated: meta.cheated,
            ..Self::fresh(setup, &field, streamer)
        };
        if let Some(state) = saved {
            scene.restore(&state);
        } else {
            // Of a world whose state is damaged that much is known.
            scene.simulated_s = finite_or(meta.played_s, 0.0).clamp(0.0, LONGEST_PLAYED_S);
            scene.saved_at_s = scene.simulated_s;
            scene.look_at_ground(&field);
        }
        scene.changed = false;
        scene.request_ground();
        Ok(scene)
    }

    /// A world that nobody has played yet, and that is kept nowhere.
    fn fresh(setup: WorldSetup, field: &Arc<Field>, streamer: Streamer) -> Self {
        let (ecs, player) = newcomer(field);
        let strategy = Arc::clone(field.strategy());
        Self {
            lens: Lens::new(setup.geometry, setup.radius_m),
            setup: setup.within_range(),
            ground: Ground::new(Arc::clone(field), Arc::clone(&strategy)),
            strategy,
            streamer,
            physics: PhysicsWorld::new(),
            ecs,
            player,
            tuning: CharacterTuning::default(),
            inventory: Inventory::default(),
            camera: CameraMode::First,
            brush_radius_m: BRUSH_RADIUS_M.2,
            marker: None,
            flying: false,
            time_of_day_s: DAY_START_S,
            simulated_s: 0.0,
            peace_until_s: crate::npc::tuning::PEACE_S,
            saved_at_s: 0.0,
            viewing: Viewing::default(),
            dip: HeadDip::default(),
            quality: Quality::default(),
            notices: Vec::new(),
            hints: Vec::new(),
            stored: false,
            save_problem: None,
            created_unix_s: 0,
            cheated: false,
            changed: false,
            start: None,
            round: Round::default(),
            body_unchecked: true,
            picture_height_px: PICTURE_HEIGHT_PX,
            sight: None,
            watched: None,
            condition: Condition::default(),
            cars: Cars::default(),
            projectiles: Projectiles::default(),
            straight_shots: false,
            gun_rests_s: 0.0,
            primary_before: false,
            secondary_before: false,
            hand: HandMotion::default(),
            flashlight: false,
            lamps: Vec::new(),
            lamps_unchecked: false,
            drops_unchecked: false,
            drops: Vec::new(),
            next_bot: 0,
            npcs: Npcs::default(),
            sounds: Sounds::default(),
            unknown: Unknown::default(),
        }
    }

    /// What makes this world the one it is.
    pub fn setup(&self) -> &WorldSetup {
        &self.setup
    }

    /// Name of the biome of this seed.
    pub fn biome(&self) -> &'static str {
        Biome::from_seed(self.setup.seed).name()
    }

    /// The strategy of the world itself; pictures are taken with that of [`Scene::lens`].
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.strategy
    }

    /// The player's hotbar.
    pub fn inventory(&self) -> &Inventory {
        &self.inventory
    }

    /// The player's hotbar, to change it.
    pub fn inventory_mut(&mut self) -> &mut Inventory {
        self.changed = true;
        &mut self.inventory
    }

    /// Radius of the brush in metres.
    pub fn brush_radius_m(&self) -> f64 {
        self.brush_radius_m
    }

    /// Time of day in seconds, 0 to 600.
    pub fn time_of_day_s(&self) -> f64 {
        self.time_of_day_s
    }

    /// The time of day where the player is, in seconds, 0 to 600; none at the poles of the sun's way.
    pub fn local_time_s(&self) -> Option<f64> {
        day::local_time_s(self.time_of_day_s, &*self.strategy, self.feet())
    }

    /// Sets the time of day in seconds; it wraps at a day's length.
    pub fn set_time_of_day_s(&mut self, time_s: f64) {
        self.time_of_day_s = time_s.rem_euclid(crate::tuning::DAY_S);
        self.changed = true;
    }

    /// Simulated time since the world was made, in seconds.
    pub fn simulated_s(&self) -> f64 {
        self.simulated_s
    }

    /// Whether a command that cheats was ever used in this world.
    pub fn cheated(&self) -> bool {
        self.cheated
    }

    /// Marks the world as one in which a command that cheats was used, for ever.
    pub fn mark_cheated(&mut self) {
        self.cheated = true;
        self.changed = true;
    }

    /// Whether the player flies as a spectator.
    pub fn flying(&self) -> bool {
        self.flying
    }

    /// Lets the player fly as a spectator, out of a car, through everything and without weight, or walk again. Whose
    /// flight ends inside the ground is lifted out of it in the next step.
    pub fn set_flying(&mut self, flying: bool) {
        if flying {
            self.get_out();
        }
        self.body_unchecked |= self.flying && !flying;
        self.flying = flying;
        self.changed = true;
    }

    /// How far chunks are loaded.
    pub fn view_distance(&self) -> u32 {
        self.setup.view_distance
    }

    /// Sets how far chunks are loaded, within the allowed range.
    pub fn set_view_distance(&mut self, chunks: u32) {
        let (least, most, _) = VIEW_DISTANCE_CHUNKS;
        self.setup.view_distance = chunks.clamp(least, most);
        self.changed = true;
        self.request_ground();
    }

    /// Sets the player's health, kept within 0 and full.
    pub fn set_health(&mut self, health: f64) {
        if let Ok(mut own) = self.ecs.get::<&mut Health>(self.player) {
            own.0 = health.clamp(0.0, crate::tuning::FULL_HEALTH);
        }
        self.changed = true;
    }

    /// Points the view, in radians.
    pub fn aim(&mut self, yaw_rad: f64, pitch_rad: f64) {
        if let Ok(mut look) = self.ecs.get::<&mut Look>(self.player) {
            *look = Look {
                yaw: 0.0,
                pitch: 0.0,
            };
            look.turn(yaw_rad, pitch_rad);
        }
        if let Some(driving) = &mut self.cars.driving {
            driving.chase.aim(yaw_rad, pitch_rad);
        }
        self.changed = true;
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
        self.ecs
            .query_one::<(&Position, &Look, &Body, &Appearance)>(self.player)
            .get()
            .map_or_else(|_| fallback(), |(p, l, b, a)| (*p, *l, b.clone(), *a))
    }

    /// Where the player's feet are.
    pub fn feet(&self) -> ChartPoint {
        self.player_parts().0.0
    }

    /// The eye in the player's head.
    pub fn head(&self) -> Eye {
        if let Some(head) = self.driver_head() {
            return head;
        }
        let (position, look, ..) = self.player_parts();
        // Seen from behind, the body does not dip, and the camera would shake without a cause.
        let dip_m = match self.camera {
            CameraMode::First => self.dip.depth_m(),
            CameraMode::Third => 0.0,
        };
        let height_m = self.tuning.eye_height_m() - dip_m;
        player::eye(&position, &look, self.lens.value(), height_m)
    }

    /// The eye the picture is taken from.
    pub fn eye(&self) -> Eye {
        self.camera_pose().eye
    }

    /// The camera that pictures are taken with.
    pub(crate) fn camera_pose(&self) -> CameraPose {
        if let Some(camera) = self.driver_camera() {
            return camera;
        }
        let mut head = self.head();
        if let Some(dead_s) = self.dead_s().filter(|_| self.camera == CameraMode::First) {
            let lies = self.viewing.reduced_motion;
            head = camera::fallen(&head, if lies { f64::INFINITY } else { dead_s });
        }
        camera::place(self.camera, &head, &**self.lens.strategy(), &self.physics)
    }

    /// From where the player sees the world.
    pub fn camera_mode(&self) -> CameraMode {
        self.camera
    }

    /// Where the brush of a tool in hand would work.
    pub fn marker(&self) -> Option<Marker> {
        self.marker
    }

    /// How much exactness pictures trade for speed.
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// Sets how much exactness pictures trade for speed; no part of the world, so nothing of it is saved.
    pub fn set_quality(&mut self, quality: Quality) {
        self.quality = quality;
    }

    /// What has gone wrong since they were last taken.
    pub fn take_notices(&mut self) -> Vec<Notice> {
        std::mem::take(&mut self.notices)
    }

    /// Short answers to what the player did that have come up since they were last taken.
    pub fn take_hints(&mut self) -> Vec<Hint> {
        std::mem::take(&mut self.hints)
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

/// A player who has just come.
fn newcomer(field: &Field) -> (hecs::World, Entity) {
    let mut ecs = hecs::World::new();
    let look = Look {
        yaw: FIRST_YAW_RAD,
        pitch: 0.0,
    };
    let player = ecs.spawn(player::components(spawn_point(field), look));
    (ecs, player)
}
