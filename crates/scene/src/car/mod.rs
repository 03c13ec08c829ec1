//! Cars: those of the world, where they stand, and what others may know of them.

pub(crate) mod camera;
pub(crate) mod doors;
pub(crate) mod drive;
pub(crate) mod harm;
pub(crate) mod lights;
pub mod tuning;

use std::f64::consts::TAU;

use antipode_geometry::{ChartPoint, ChunkCoord, Hemisphere, Strategy};
use antipode_physics::{VehicleMotion, VehicleWheel, Vehicles};
use antipode_storage::CarRecord;
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::body;
use crate::camera::CameraMode;
use crate::ground_changed::may_stand_on;
use crate::persist::hemisphere_record;
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
/// Half of the rectangle that it stands on, in metres.
const FOOTPRINT_M: (f64, f64) = (1.5, 0.8);

/// What a car is besides its body.
#[derive(Clone, Copy, Debug, PartialEq)]
struct CarState {
    /// Its number in saves, which no other car of the world has had while it was open.
    id: u32,
    hemisphere: Hemisphere,
    lights: bool,
    /// It was put somewhere, perhaps into the ground: a free place is to be found when the ground is there.
    unplaced: bool,
}

/// Someone at the wheel.
#[derive(Clone, Debug)]
pub(crate) struct Driving {
    pub car: usize,
    pub chase: Chase,
    /// From where the player saw the world before.
    pub camera_before: CameraMode,
    /// What the pedals ask for, -1 to 1; for the sound of the engine.
    pub throttle: f64,
    /// For how long the car has lain on its side or roof, seconds.
    pub lies_s: f64,
}

/// The cars of a world.
#[derive(Debug, Default)]
pub(crate) struct Cars {
    vehicles: Vehicles,
    states: Vec<CarState>,
    /// The number in saves that the next one gets.
    pub next: u32,
    pub driving: Option<Driving>,
    /// Whether this world has been given its first car.
    pub given: bool,
    /// Whom cars have hurt lately, and how long ago, seconds.
    hurt: Vec<(Entity, f64)>,
}

impl Cars {
    /// Their bodies.
    pub fn vehicles(&self) -> &Vehicles {
        &self.vehicles
    }

    /// All cars, in the order in which they came.
    pub fn views(&self, world: &World) -> Vec<CarView> {
        (0..self.states.len())
            .filter_map(|number| self.view(world, number))
            .collect()
    }

    /// One car by its number.
    pub fn view(&self, world: &World, number: usize) -> Option<CarView> {
        let state = self.states.get(number)?;
        let vehicle = self.vehicles.all().get(number)?;
        let motion = vehicle.motion();
        let origin = world.strategy.chart_origin_m(state.hemisphere);
        Some(CarView {
            point: ChartPoint::new(state.hemisphere, motion.place - origin),
            turn: motion.turn,
            velocity: motion.velocity,
            spin: motion.spin,
            speed_m_s: motion.speed_m_s(),
            steer_rad: vehicle.steer_rad(),
            lights: state.lights,
            brakes: vehicle.brakes(),
            driven: self.driven_number() == Some(number),
            rests: vehicle.is_asleep(),
            wheels: *vehicle.wheels(),
        })
    }

    /// The car that the player drives.
    pub fn driven(&self, world: &World) -> Option<CarView> {
        self.view(world, self.driven_number()?)
    }

    /// Its number.
    pub fn driven_number(&self) -> Option<usize> {
        self.driving.as_ref().map(|driving| driving.car)
    }

    /// Whether the player sits in a car.
    pub fn is_driving(&self) -> bool {
        self.driving.is_some()
    }

    /// Puts a car at a point of the ground, facing along `yaw` radians; as high up as it takes to be free, once the
    /// ground is there. Returns whether there was room for one more.
    pub fn spawn(&mut self, world: &World, point: ChartPoint, yaw: f64) -> bool {
        if self.states.len() >= MOST_CARS {
            return false;
        }
        let point = body::within_world(&*world.strategy, point);
        let motion = VehicleMotion {
            place: point.pos + world.strategy.chart_origin_m(point.hemisphere),
            turn: DQuat::from_rotation_y(-yaw),
            ..VehicleMotion::default()
        };
        self.add(point.hemisphere, motion, false, true);
        true
    }

    /// Returns the number of the car.
    fn add(
        &mut self,
        hemisphere: Hemisphere,
        motion: VehicleMotion,
        lights: bool,
        unplaced: bool,
    ) -> usize {
        let id = self.next;
        self.next += 1;
        self.states.push(CarState {
            id,
            hemisphere,
            lights,
            unplaced,
        });
        self.vehicles.add(motion)
    }

    /// What is to be saved of each, with its number there.
    pub fn records(&self, strategy: &dyn Strategy) -> impl Iterator<Item = (u32, CarRecord)> {
        let all = self.states.iter().zip(self.vehicles.all());
        all.map(|(state, vehicle)| {
            let motion = vehicle.motion();
            let place = motion.place - strategy.chart_origin_m(state.hemisphere);
            let record = CarRecord {
                hemisphere: hemisphere_record(state.hemisphere),
                pos: place.to_array(),
                turn: motion.turn.to_array(),
                vel: motion.velocity.to_array(),
                spin: motion.spin.to_array(),
                lights: state.lights,
                steer: vehicle.steer_rad(),
                springs: vehicle.wheels().map(|wheel| wheel.compression_m),
                rests: vehicle.is_asleep(),
            };
            (state.id, record)
        })
    }

    /// Puts a saved car where it was; false if its numbers are not fit to be used.
    pub fn restore(&mut self, world: &World, record: &CarRecord) -> bool {
        let turn = DQuat::from_array(record.turn);
        let velocity = DVec3::from_array(record.vel);
        let spin = DVec3::from_array(record.spin);
        let is_sound =
            turn.is_finite() && turn.length() > 0.1 && velocity.is_finite() && spin.is_finite();
        let point = restore::point(world, record.hemisphere, record.pos);
        let Some(point) = point.filter(|_| is_sound) else {
            return false;
        };
        let motion = VehicleMotion {
            place: point.pos + world.strategy.chart_origin_m(point.hemisphere),
            turn: unit(turn),
            velocity: velocity.clamp_length_max(FASTEST_RESTORED_M_S),
            spin: spin.clamp_length_max(FASTEST_RESTORED_RAD_S),
        };
        let added = self.add(point.hemisphere, motion, record.lights, false);
        self.vehicles
            .restore(added, record.steer, record.springs, record.rests);
        true
    }

    /// The number in saves of the car that the player drives.
    pub fn driven_id(&self) -> Option<u32> {
        let state = self.states.get(self.driven_number()?)?;
        Some(state.id)
    }

    /// Which car has that number in saves.
    pub fn number_of(&self, id: u32) -> Option<usize> {
        self.states.iter().position(|state| state.id == id)
    }

    /// Ground has changed in these chunks: what rests on it is to fall.
    pub fn wake(&mut self, world: &World, changed: &[ChunkCoord]) {
        let places: Vec<_> = self
            .vehicles
            .all()
            .iter()
            .map(|vehicle| vehicle.motion().place)
            .collect();
        for (number, (place, state)) in places.into_iter().zip(&self.states).enumerate() {
            let origin = world.strategy.chart_origin_m(state.hemisphere);
            let point = ChartPoint::new(state.hemisphere, place - origin);
            if may_stand_on(world, point, changed) {
                self.vehicles.wake(number);
            }
        }
    }
}

/// What others may know of a car.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarView {
    /// The ground below its middle, when it stands on level ground.
    pub point: ChartPoint,
    /// How it is turned from looking along +x with its right-hand side at +z, in the chart.
    pub turn: DQuat,
    /// Velocity in its chart, m/s.
    pub velocity: DVec3,
    /// Angular velocity in its chart, rad/s.
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

    /// A place of the car's own axes (m) in the chart.
    pub fn place(&self, own: DVec3) -> ChartPoint {
        self.point.moved(self.turn * own)
    }
}

/// Gives the world its first car, near the start, if it has had none yet; returns whether it did.
pub(crate) fn give_first(world: &World, cars: &mut Cars, start: ChartPoint) -> bool {
    if cars.given {
        return false;
    }
    cars.given = true;
    let heights = |at: DVec3| {
        let (x, z) = FOOTPRINT_M;
        [(0.0, 0.0), (x, z), (x, -z), (-x, z), (-x, -z)].map(|(dx, dz)| {
            let beside = at + DVec3::new(dx, 0.0, dz);
            world
                .ground
                .untouched_height(ChartPoint::new(start.hemisphere, beside))
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
        let point = ChartPoint::new(start.hemisphere, at);
        cars.spawn(world, point, FIRST_YAW_RAD)
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
