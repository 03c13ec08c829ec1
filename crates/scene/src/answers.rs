//! Answers to a host's questions about a scene. They change nothing.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Eye, Strategy};
use antipode_items::Item;
use antipode_terrain::Field;

use crate::actors::ActorId;
use crate::bearings::{self, Bearings, FlagWay, Landmark};
use crate::bot::{self, BotView};
use crate::brush::{Brush, Choice};
use crate::camera::CameraMode;
use crate::car::CarView;
use crate::crumb;
use crate::damage;
use crate::day;
use crate::drops::Drop;
use crate::earthworks::{Earthworks, Heap};
use crate::fixture::{self, Fixture};
use crate::frame::{HitShape, Quality};
use crate::hit_shapes;
use crate::inventory::Inventory;
use crate::moment::Seen;
use crate::notice::Unfit;
use crate::npc::{self, Speech, Wound};
use crate::photo::Viewpoint;
use crate::probe::Probe;
use crate::probing;
use crate::projectile::Projectile;
use crate::scene::Scene;
use crate::setup::WorldSetup;
use crate::sighting::{self, Sighting};
use crate::situation::is_ground_ready;
use crate::sound::{self, Surroundings};
use crate::tuning::MOST_BOTS;
use crate::viewing::Viewing;

/// The row of shapes or kinds is shown so long after a choice, seconds.
const CHOICE_SHOWN_S: f64 = 2.0;
/// With less of the sky left than this share it is dark by day, too.
const DARK_SKY: f32 = 0.3;

/// The world.
impl Scene {
    /// What makes this world the one it is.
    pub fn setup(&self) -> &WorldSetup {
        &self.sim.world.setup
    }

    /// Name of the biome where the player is.
    pub fn biome(&self) -> &'static str {
        self.field().biome_at(self.feet()).name()
    }

    /// Name of the land that the player has come into, a biome's or `cave`, once it is known.
    pub fn land_name(&self) -> Option<&'static str> {
        self.sim.player.biome.name()
    }

    /// The land before any edit.
    pub fn field(&self) -> &Field {
        self.sim.world.ground.field()
    }

    /// The strategy of the world itself; pictures are taken with that of [`Scene::lens`].
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.sim.world.strategy
    }

    /// What is against putting what is in hand where the crosshair is, of what is shown as it would stand.
    pub fn against_placing(&self) -> Option<Unfit> {
        fixture::against(self.now())
    }

    /// Time of day in seconds, 0 to 600.
    pub fn time_of_day_s(&self) -> f64 {
        self.sim.world.time_of_day_s
    }

    /// The time of day where the player is, in seconds, 0 to 600; none at the poles of the sun's way.
    pub fn local_time_s(&self) -> Option<f64> {
        self.sim.world.local_time_s(self.feet())
    }

    /// Whether one sees little without a lamp where the player is: by night, and deep below untouched land.
    pub fn is_dark(&self) -> bool {
        let by_night = self.local_time_s().is_some_and(day::is_night);
        by_night || self.field().sky_left(self.head().point) < DARK_SKY
    }

    /// Simulated time since the world was made, in seconds.
    pub fn simulated_s(&self) -> f64 {
        self.sim.world.simulated_s
    }

    /// Whether a command that cheats was ever used in this world.
    pub fn cheated(&self) -> bool {
        self.kept.cheated
    }

    /// How far chunks are loaded.
    pub fn view_distance(&self) -> u32 {
        self.sim.world.setup.view_distance
    }

    /// Whether the ground around the player exists with its colliders.
    pub fn is_ground_ready(&self) -> bool {
        is_ground_ready(&self.sim.world, &self.sim.actors)
    }

    /// Height of the ground under the player's head, in metres of the chart; `None` where none is near, or where
    /// the head is in rock with no cave below. Beyond where bodies move it is that of untouched ground, whatever
    /// happens to be loaded there.
    pub fn ground_height(&self) -> Option<f64> {
        self.sim.world.ground_height(self.head().point)
    }

    /// The state of the world for a script.
    pub fn probe(&self) -> Probe {
        probing::probe(self.now(), &self.shown)
    }
}

/// The player.
impl Scene {
    /// Where the player's feet are.
    pub fn feet(&self) -> ChartPoint {
        self.sim.actors.feet()
    }

    /// The eye in the player's head, as the simulation has it.
    pub fn head(&self) -> Eye {
        self.now().head()
    }

    /// The player's hotbar.
    pub fn inventory(&self) -> &Inventory {
        &self.sim.player.inventory
    }

    /// The brush in hand.
    pub fn brush(&self) -> Brush {
        self.sim.player.brush
    }

    /// What of the brush was chosen just now, as long as that is to be shown.
    pub fn brush_chosen(&self) -> Option<Choice> {
        let (choice, at_s) = self.sim.player.chosen?;
        (self.sim.world.simulated_s - at_s < CHOICE_SHOWN_S).then_some(choice)
    }

    /// What was dug and built in this visit.
    pub fn earthworks(&self) -> &Earthworks {
        &self.sim.player.earthworks
    }

    /// What is to be shown of what the last stroke of the brush has moved, ores and then the largest heap first.
    pub fn heaps_shown(&self) -> Vec<Heap> {
        let now_s = self.sim.world.simulated_s;
        let gathers = self.stock().is_some();
        self.sim.player.earthworks.shown(gathers, now_s)
    }

    /// Radius of the brush in metres.
    pub fn brush_radius_m(&self) -> f64 {
        self.sim.player.brush_radius_m
    }

    /// Whether somebody whom the player has talked to is speaking.
    pub fn is_answered(&self) -> bool {
        npc::is_speaking(self.now())
    }

    /// Whether the player's flashlight is on.
    pub fn flashlight(&self) -> bool {
        self.sim.player.flashlight
    }

    /// Whether bullets follow the space's geodesics.
    pub fn straight_shots(&self) -> bool {
        self.sim.player.gaze.straight_shots
    }

    /// The player's health.
    pub fn health(&self) -> f64 {
        self.sim.actors.health()
    }

    /// Whether the player lies dead.
    pub fn is_dead(&self) -> bool {
        self.sim.player.is_dead()
    }

    /// The player's last damage: how long ago it was, seconds, and from which heading of the player's chart it came,
    /// radians, if from one.
    pub fn last_hurt(&self) -> Option<(f64, Option<f64>)> {
        damage::last(self.now())
    }

    /// Seconds since a shot of the player's struck someone.
    pub fn struck_s_ago(&self) -> Option<f64> {
        self.sim.player.condition.struck_s_ago
    }

    /// Which way the player looks, and where that is.
    pub fn bearings(&self) -> Bearings {
        bearings::bearings(self.now())
    }

    /// What surrounds the player.
    pub fn surroundings(&self) -> Surroundings {
        sound::surroundings(self.now(), &self.eye())
    }
}

/// Everyone and everything else.
impl Scene {
    /// All bots, by their numbers.
    pub fn bots(&self) -> Vec<BotView> {
        bot::views(&self.sim.actors)
    }

    /// Whether the world can have one more figure.
    pub fn has_room_for_bot(&self) -> bool {
        self.bots().len() < MOST_BOTS
    }

    /// All cars, in the order in which they came.
    pub fn cars(&self) -> Vec<CarView> {
        self.sim.actors.car_views()
    }

    /// The car that the player drives.
    pub fn driven_car(&self) -> Option<CarView> {
        self.sim.actors.driven_car()
    }

    /// Whether the player sits in a car.
    pub fn is_driving(&self) -> bool {
        self.sim.actors.cars.is_driving()
    }

    /// The lamps of the world, in the order in which they were put down.
    pub fn lamps(&self) -> Vec<Fixture> {
        fixture::map_of(&self.sim.actors, Item::Lamp, |_, it| it.clone())
    }

    /// The ways to the doors, to the older one first; none of them has a name.
    pub fn door_ways(&self) -> Vec<FlagWay> {
        bearings::door_ways(&self.sim.world, &self.sim.actors)
    }

    /// The ways to all flags, in the order in which they were planted.
    pub fn flag_ways(&self) -> Vec<FlagWay> {
        bearings::flag_ways(&self.sim.world, &self.sim.actors)
    }

    /// Things lying about.
    pub fn drops(&self) -> Vec<Drop> {
        self.sim.actors.each()
    }

    /// Bullets in flight, the oldest first.
    pub fn projectiles(&self) -> Vec<(ActorId, Projectile)> {
        self.sim.actors.all()
    }

    /// Everything that can be hit or stands on the ground; in first person without the player's own body, inside of
    /// which one looks.
    pub fn hit_shapes(&self) -> Vec<HitShape> {
        hit_shapes::hit_shapes(self.now())
    }

    /// Lamps, breadcrumbs and everyone alive but the player, within a distance on the map; and cars, flags, doors and home, of
    /// which those farther off are marked at the edge in their direction.
    pub fn landmarks(&self, reach_m: f64) -> Vec<Landmark> {
        bearings::landmarks(self.now(), reach_m)
    }

    /// The ways to the cars that nobody drives.
    pub fn car_ways(&self) -> Vec<FlagWay> {
        bearings::car_ways(&self.sim.world, &self.sim.actors)
    }

    /// The way back along the breadcrumbs that were laid, where some are about.
    pub fn way_back(&self) -> Option<FlagWay> {
        crumb::way_back(&self.sim.world, &self.sim.actors)
    }

    /// The triangle of flags that the player sights, if he stands at one and looks at another.
    pub fn sighting(&self) -> Option<Sighting> {
        sighting::sighting(self.now())
    }

    /// Headings of the player's chart, radians, to those who could shoot at the player and are not to be seen in the
    /// picture.
    pub fn hidden_foes(&self) -> Vec<f64> {
        npc::hidden_foes(self.now())
    }
}

/// What is laid over pictures, and how they are taken.
impl Scene {
    /// From where the player sees the world.
    pub fn camera_mode(&self) -> CameraMode {
        self.sim.player.gaze.camera
    }

    /// How much exactness pictures trade for speed.
    pub fn quality(&self) -> Quality {
        self.shown.quality
    }

    /// How the player wants to see the world.
    pub fn viewing(&self) -> Viewing {
        self.shown.viewing
    }

    /// What is being said, in a picture that was taken so, of that vertical field of view in radians.
    pub fn speech(&self, seen: &Seen, fov_y_rad: f64) -> Option<Speech> {
        npc::speech(self.now(), &**self.lens().strategy(), seen, fov_y_rad)
    }

    /// The health of living figures that are hurt and in sight, in a picture that was taken so, of that vertical
    /// field of view in radians.
    pub fn wounds(&self, seen: &Seen, fov_y_rad: f64) -> Vec<Wound> {
        npc::wounds(self.now(), &**self.lens().strategy(), seen, fov_y_rad)
    }

    /// Moves a camera as [`Viewpoint::fly`] does, but not into the ground: along it, and up where it rises. One that is in
    /// it, since land came where it was, gets out.
    pub fn fly_view(&self, view: &mut Viewpoint, by: glam::DVec3) {
        view.fly_around_ground(&self.sim.world, by);
    }
}
