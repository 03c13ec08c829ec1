//! A flight over a world that nobody plays.

use std::f64::consts::PI;
use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{ChartPoint, DEFAULT_HYPERBOLIC_RADIUS_M, Geometry, strategy};
use antipode_scene::frame::{Frame, Quality};
use antipode_scene::{Scene, SceneError, Viewpoint, WorldSetup};
use antipode_terrain::{Field, Generator};
use glam::DVec3;

/// Vertical field of view, radians.
const FOV_Y_RAD: f64 = 65.0 * PI / 180.0;
/// Speed over the ground, metres of the chart a second.
const SPEED_M_S: f64 = 3.0;
/// The flight is a wide curve, radians a second.
const TURN_RAD_PER_S: f64 = 0.02;
/// Share of the way to the height it should have that the flight makes up in a second.
const CLIMB_PER_S: f64 = 0.5;
/// Where the ground ahead is looked at, metres: it must not come as a surprise.
const AHEAD_M: [f64; 4] = [0.0, 6.0, 12.0, 20.0];
/// Radius of the closed worlds, metres: hills are small beside them, and by night land in the sun hangs overhead.
const SPHERE_RADIUS_M: f64 = 100.0;
/// How fast the day goes by, seconds a second.
const DAY_SPEED: f64 = 1.0;
/// View distance in chunks where the processor draws, and where a graphics card does.
const VIEW_DISTANCE: (u32, u32) = (3, 5);

/// A world to fly over.
#[derive(Clone, Copy, Debug)]
pub struct BackdropWorld {
    geometry: Geometry,
    radius_m: f64,
    seed: u64,
    /// Height above the ground, metres.
    clearance_m: f64,
    /// Pitch of the view, radians.
    pitch_rad: f64,
    /// Time of day to begin with, seconds.
    time_of_day_s: f64,
}

/// The worlds, in the order in which they are shown: the one that no other game has comes first, and each is followed
/// by one in another space.
pub const WORLDS: [BackdropWorld; 6] = [
    SPHERICAL.of(5, 440.0),
    HYPERBOLIC.of(7, 95.0),
    FLAT.of(3, 40.0),
    SPHERICAL.of(1, 420.0),
    HYPERBOLIC.of(21, 200.0),
    FLAT.of(18, 240.0),
];

const FLAT: BackdropWorld = over(Geometry::Euclidean, f64::INFINITY, 12.0, -0.24);
const HYPERBOLIC: BackdropWorld =
    over(Geometry::Hyperbolic, DEFAULT_HYPERBOLIC_RADIUS_M, 7.0, -0.4);
const SPHERICAL: BackdropWorld = over(Geometry::Spherical, SPHERE_RADIUS_M, 9.0, 0.2);

const fn over(
    geometry: Geometry,
    radius_m: f64,
    clearance_m: f64,
    pitch_rad: f64,
) -> BackdropWorld {
    BackdropWorld {
        geometry,
        radius_m,
        seed: 0,
        clearance_m,
        pitch_rad,
        time_of_day_s: 0.0,
    }
}

impl BackdropWorld {
    const fn of(self, seed: u64, time_of_day_s: f64) -> Self {
        Self {
            seed,
            time_of_day_s,
            ..self
        }
    }
}

/// A world and the camera over it.
#[derive(Debug)]
pub struct Flight {
    scene: Scene,
    field: Field,
    view: Viewpoint,
    clearance_m: f64,
    number: u64,
    shown_s: f64,
}

impl Flight {
    /// Opens the world without a store. Slow enough to be done on a thread. `number` is that of the frames' world.
    ///
    /// # Errors
    /// When the chunk workers cannot start.
    pub fn open(
        world: BackdropWorld,
        number: u64,
        software: bool,
        quality: Quality,
    ) -> Result<Self, SceneError> {
        let setup = WorldSetup {
            name: String::new(),
            seed: world.seed,
            geometry: world.geometry,
            radius_m: world.radius_m,
            generator: Generator::OneBiome,
            mode: antipode_scene::Mode::default(),
            view_distance: if software {
                VIEW_DISTANCE.0
            } else {
                VIEW_DISTANCE.1
            },
        };
        let field = Field::made_by(
            Generator::OneBiome,
            world.seed,
            strategy(world.geometry, world.radius_m),
        );
        let mut scene = Scene::open(setup, None)?;
        scene.set_quality(quality);
        let mut view = Viewpoint::of(&scene);
        view.eye.pitch = world.pitch_rad;
        view.time_of_day_s = world.time_of_day_s;
        let mut flight = Self {
            scene,
            field,
            view,
            clearance_m: world.clearance_m,
            number,
            shown_s: 0.0,
        };
        flight.view.eye.point.pos.y = flight.height_m();
        flight.scene.watch_from(Some(flight.view.eye));
        Ok(flight)
    }

    /// Takes finished land in until `budget` is used up. Never blocks.
    pub fn pump(&mut self, budget: Duration) {
        self.scene.pump(budget);
    }

    /// Whether all the land around is there.
    pub fn is_complete(&self) -> bool {
        self.scene.pending() == 0 && self.scene.loading_progress() >= 1.0
    }

    /// How long it has been flown, seconds.
    pub fn shown_s(&self) -> f64 {
        self.shown_s
    }

    /// Flies on.
    pub fn fly(&mut self, by_s: f64) {
        self.shown_s += by_s;
        self.view.time_of_day_s += DAY_SPEED * by_s;
        self.view.turn(TURN_RAD_PER_S * by_s, 0.0);
        let way_m = SPEED_M_S * by_s;
        let too_low_m = self.height_m() - self.view.eye.point.pos.y;
        let climb_m = too_low_m * (1.0 - (-CLIMB_PER_S * by_s).exp());
        // The way the camera looks is not level, the flight is.
        let level_m = way_m * self.view.eye.pitch.sin();
        let by = DVec3::new(0.0, climb_m - level_m, way_m);
        let strategy = Arc::clone(self.scene.strategy());
        self.view.fly(&*strategy, by);
        self.scene.watch_from(Some(self.view.eye));
    }

    /// The snapshot to draw. Terrain changes are handed over once.
    pub fn frame(&mut self, aspect: f64, height_px: u32) -> Frame {
        self.scene.set_picture_height_px(height_px);
        self.scene
            .frame_from(&self.view, FOV_Y_RAD, aspect, self.number)
    }

    /// The space of a world.
    #[cfg(test)]
    pub fn geometry_of(world: BackdropWorld) -> Geometry {
        world.geometry
    }

    /// Where the camera is.
    #[cfg(test)]
    pub fn point(&self) -> ChartPoint {
        self.view.eye.point
    }

    /// Height of the camera above the ground below it, metres.
    #[cfg(test)]
    pub fn above_ground_m(&self) -> f64 {
        self.view.eye.point.pos.y - self.ground_m(self.view.eye.point)
    }

    /// Height that the camera should have: that far above the highest ground on its way.
    fn height_m(&self) -> f64 {
        let eye = &self.view.eye;
        let front = DVec3::new(eye.yaw.cos(), 0.0, eye.yaw.sin());
        let ground = AHEAD_M.map(|ahead_m| self.ground_m(eye.point.moved(front * ahead_m)));
        ground.into_iter().fold(f64::MIN, f64::max) + self.clearance_m
    }

    fn ground_m(&self, point: ChartPoint) -> f64 {
        let crossing = self.scene.strategy().cross(point);
        let point = crossing.map_or(point, |crossing| crossing.point);
        self.field
            .surface_height(point.chart, point.pos.x, point.pos.z)
    }
}
