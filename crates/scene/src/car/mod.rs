//! Cars: their components, where they appear, and what other rules may know of them.

mod bushes;
pub(crate) mod camera;
pub(crate) mod damage;
pub(crate) mod doors;
pub(crate) mod drive;
pub(crate) mod lights;
pub(crate) mod mirror;
pub mod tuning;

use std::f64::consts::TAU;

use antipode_geometry::{ChartPoint, LevelMap};
use antipode_physics::{
    Obstacle, Vehicle, VehicleMotion, VehiclePart, VehiclePhysics, VehicleWheel,
};
use antipode_storage::CarRecord;
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::actors::{ActorId, Actors};
use crate::body;
use crate::camera::CameraMode;
use crate::door_astride::car_parts;
use crate::ground_changed::OnGround;
use crate::restore::{self, FASTEST_RESTORED_M_S};
use crate::spawn::FIRST_YAW_RAD;
use crate::world::World;
use camera::Chase;
use tuning::{FIRST_CAR_RINGS_M, MOST_CARS};

/// Directions in which a place for a new world's car is looked for.
const FIRST_CAR_TURNS: u32 = 12;
/// A saved car that turns faster was not saved by the game.
const FASTEST_RESTORED_RAD_S: f64 = 50.0;
/// Height of its middle over the ground, in metres.
const MIDDLE_UP_M: f64 = 0.8;
/// No part of it is farther from the ground below its middle, in metres, and somebody who touches it stands no farther off.
const BODY_REACH_M: f64 = 4.0;
/// Half of the rectangle that it stands on, in metres.
const FOOTPRINT_M: (f64, f64) = (1.5, 0.8);

/// A car. Its number is its [`ActorId`].
#[derive(Debug)]
pub(crate) struct Car {
    vehicle: Vehicle,
    lights: bool,
    /// It was put somewhere, perhaps into the ground: a free place is to be found when the ground is there.
    unplaced: bool,
}

/// Someone at the wheel.
#[derive(Clone, Debug)]
pub(crate) struct Driving {
    pub car: ActorId,
    pub chase: Chase,
    /// From where the player saw the world before.
    pub camera_before: CameraMode,
    /// What the pedals ask for, -1 to 1; for the sound of the engine.
    pub throttle: f64,
    /// For how long the car has lain on its side or roof, seconds.
    pub lies_s: f64,
}

/// What the cars of a world have in common.
#[derive(Debug, Default)]
pub(crate) struct Cars {
    pub physics: VehiclePhysics,
    pub driving: Option<Driving>,
    /// Whether this world has been given its first car.
    pub given: bool,
    /// Whom cars have hurt lately, and how long ago, seconds.
    hurt: Vec<(Entity, f64)>,
}

impl Cars {
    /// The car that the player drives.
    pub fn driven(&self) -> Option<ActorId> {
        self.driving.as_ref().map(|driving| driving.car)
    }

    /// Whether the player sits in a car.
    pub fn is_driving(&self) -> bool {
        self.driving.is_some()
    }
}

impl Actors {
    /// What others may know of all cars, in the order in which they came.
    pub fn car_views(&self) -> Vec<CarView> {
        self.map(|id, car| self.view_of(id, car))
    }

    /// What others may know of one car.
    pub fn car_view(&self, id: ActorId) -> Option<CarView> {
        self.map_one(id, |car| self.view_of(id, car))
    }

    /// The car that the player drives.
    pub fn driven_car(&self) -> Option<CarView> {
        self.car_view(self.cars.driven()?)
    }

    /// How all cars move, in the order in which they came.
    pub fn car_motions(&self) -> Vec<(ActorId, VehicleMotion)> {
        self.map(|id, car: &Car| (id, car.vehicle.motion()))
    }

    /// What of all cars is to be met, where it is: of one that stands in a door, a part on either side.
    pub fn car_parts(&self, world: &World) -> Vec<(ActorId, VehiclePart)> {
        let (space, physics) = (&*world.strategy, &self.cars.physics);
        let parts = |(id, motion): (ActorId, VehicleMotion)| {
            let parts = car_parts(space, world.doors.as_ref(), physics, &motion);
            parts.into_iter().map(move |part| (id, part))
        };
        self.car_motions().into_iter().flat_map(parts).collect()
    }

    /// The bodies of all cars, which nobody walks through, in every chart that they reach into.
    pub fn car_bodies(&self, world: &World) -> Vec<Obstacle> {
        let bodies = |(_, part): (ActorId, VehiclePart)| {
            let images = world
                .strategy
                .images(part.motion().point(), BODY_REACH_M)
                .into_iter();
            let others = images.map(|image| part.carried(&*world.strategy, &image).obstacle());
            others.chain([part.obstacle()]).collect::<Vec<_>>()
        };
        self.car_parts(world).into_iter().flat_map(bodies).collect()
    }

    fn view_of(&self, id: ActorId, car: &Car) -> CarView {
        let (vehicle, motion) = (&car.vehicle, car.vehicle.motion());
        CarView {
            id,
            point: car.point(),
            turn: motion.turn,
            velocity: motion.velocity,
            spin: motion.spin,
            speed_m_s: motion.speed_m_s(),
            steer_rad: vehicle.steer_rad(),
            lights: car.lights,
            brakes: vehicle.brakes(),
            driven: self.cars.driven() == Some(id),
            rests: vehicle.is_asleep(),
            wheels: *vehicle.wheels(),
            level: self.cars.physics.level_at(car.point()),
        }
    }
}

impl Car {
    /// The ground below its middle, when it stands on level ground.
    fn point(&self) -> ChartPoint {
        self.vehicle.motion().point()
    }

    /// What is to be saved of it.
    pub fn record(&self) -> CarRecord {
        let (vehicle, motion) = (&self.vehicle, self.vehicle.motion());
        CarRecord {
            chart: motion.chart.number(),
            pos: self.point().pos.to_array(),
            turn: motion.turn.to_array(),
            vel: motion.velocity.to_array(),
            spin: motion.spin.to_array(),
            lights: self.lights,
            steer: vehicle.steer_rad(),
            springs: vehicle.wheels().map(|wheel| wheel.compression_m),
            rests: vehicle.is_asleep(),
        }
    }
}

impl OnGround for Car {
    fn stands_at(&self) -> ChartPoint {
        self.point()
    }

    fn is_falling(&self) -> bool {
        // One that falls is awake.
        false
    }

    fn wake(&mut self) {
        self.vehicle.wake();
    }
}

/// Puts a car at a point of the ground, facing along `yaw` radians; as high up as it takes to be free, once the
/// ground is there. Returns whether there was room for one more.
pub(crate) fn spawn(world: &World, actors: &mut Actors, point: ChartPoint, yaw: f64) -> bool {
    if actors.count::<Car>() >= MOST_CARS {
        return false;
    }
    let point = body::within_world(&*world.strategy, point);
    let motion = VehicleMotion::at(point, DQuat::from_rotation_y(-yaw));
    actors.enter(Car {
        vehicle: actors.cars.physics.vehicle(motion),
        lights: false,
        unplaced: true,
    });
    true
}

/// Puts a saved car where it was; false if its numbers are not fit to be used.
pub(crate) fn restore(world: &World, actors: &mut Actors, record: &CarRecord) -> bool {
    let turn = DQuat::from_array(record.turn);
    let velocity = DVec3::from_array(record.vel);
    let spin = DVec3::from_array(record.spin);
    let is_sound =
        turn.is_finite() && turn.length() > 0.1 && velocity.is_finite() && spin.is_finite();
    let point = restore::point(world, record.chart, record.pos);
    let Some(point) = point.filter(|_| is_sound) else {
        return false;
    };
    let physics = &actors.cars.physics;
    let mut vehicle = physics.vehicle(VehicleMotion {
        velocity: velocity.clamp_length_max(FASTEST_RESTORED_M_S),
        spin: spin.clamp_length_max(FASTEST_RESTORED_RAD_S),
        ..VehicleMotion::at(point, unit(turn))
    });
    physics.restore(&mut vehicle, record.steer, record.springs, record.rests);
    actors.enter(Car {
        vehicle,
        lights: record.lights,
        unplaced: false,
    });
    true
}

/// What others may know of a car.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarView {
    /// Which car it is.
    pub id: ActorId,
    /// The ground below its middle, when it stands on level ground.
    pub point: ChartPoint,
    /// How it is turned from looking along +x with its right-hand side at +z, along the frame of its chart.
    pub turn: DQuat,
    /// Velocity, m/s of the space along that frame, or of the chart where bodies move in that.
    pub velocity: DVec3,
    /// Angular velocity, rad/s, told likewise.
    pub spin: DVec3,
    /// Speed ahead, m/s; backwards negative.
    pub speed_m_s: f64,
    /// How far the front wheels are turned to the right, radians.
    pub steer_rad: f64,
    /// Whether its lights are on.
    pub lights: bool,
    /// Whether its driver brakes.
    pub brakes: bool,
    /// Whether the player drives it.
    pub driven: bool,
    /// Whether it has come to rest, and costs nothing.
    pub rests: bool,
    /// Front left, front right, rear left, rear right.
    pub wheels: [VehicleWheel; 4],
    /// How its metres lie in the chart.
    pub level: LevelMap,
}

impl CarView {
    /// Its heading, radians: 0 along +x, a quarter turn along +z.
    pub fn yaw(&self) -> f64 {
        let ahead = self.turn * DVec3::X;
        ahead.z.atan2(ahead.x)
    }

    /// Its middle, in the chart.
    pub(crate) fn middle(&self) -> ChartPoint {
        self.place(DVec3::Y * MIDDLE_UP_M)
    }

    /// A place of the car's own axes (metres of the space) in the chart.
    pub fn place(&self, own: DVec3) -> ChartPoint {
        self.point.moved(self.level.in_chart(self.turn * own))
    }

    /// A place of the chart in the car's own axes.
    pub(crate) fn own(&self, pos: DVec3) -> DVec3 {
        let off = self.level.in_space(pos - self.point.pos);
        self.turn.inverse() * off
    }
}

/// Gives the world its first car, near the start, if it has had none yet; returns whether it did.
pub(crate) fn give_first(world: &World, actors: &mut Actors, start: ChartPoint) -> bool {
    if actors.cars.given {
        return false;
    }
    actors.cars.given = true;
    let heights = |at: DVec3| {
        let (x, z) = FOOTPRINT_M;
        [(0.0, 0.0), (x, z), (x, -z), (-x, z), (-x, -z)].map(|(dx, dz)| {
            let beside = at + DVec3::new(dx, 0.0, dz);
            world
                .ground
                .untouched_height(ChartPoint::new(start.chart, beside))
        })
    };
    let mut best: Option<(f64, DVec3)> = None;
    for ring_m in FIRST_CAR_RINGS_M {
        for turn in 0..FIRST_CAR_TURNS {
            // From a little to the right of where a new player looks, so that the car is seen at once.
            let angle = FIRST_YAW_RAD + 0.35 + TAU * f64::from(turn) / f64::from(FIRST_CAR_TURNS);
            let at = start.pos + DVec3::new(angle.cos(), 0.0, angle.sin()) * ring_m;
            let heights = heights(at);
            let high = heights.into_iter().fold(f64::MIN, f64::max);
            let low = heights.into_iter().fold(f64::MAX, f64::min);
            let steep = high - low + 0.3 * (high - start.pos.y).abs();
            if best.is_none_or(|(least, _)| steep < least - 0.2) {
                best = Some((steep, at.with_y(high)));
            }
        }
    }
    best.is_some_and(|(_, at)| {
        let point = ChartPoint::new(start.chart, at);
        spawn(world, actors, point, FIRST_YAW_RAD)
    })
}

/// A turn of unit length; one that is so already keeps its bits, so that a world comes back as it was saved.
fn unit(turn: DQuat) -> DQuat {
    if (turn.length_squared() - 1.0).abs() < 1e-12 {
        turn
    } else {
        turn.normalize()
    }
}
