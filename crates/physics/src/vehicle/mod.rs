//! Vehicles, and the step that moves all of them together.
//!
//! A vehicle's state is plain data in `f64`. While it has ground to stand on, a body of Rapier's represents it. A vehicle
//! that nobody drives and that has come to rest costs nothing until something comes near.

mod arena;
mod bodies;
mod controller;
mod cut;
mod doors;
mod drive;
mod hold;
mod hull;
mod laid;
mod needed;
mod part;
mod place;
mod role;
mod sill;
mod site;
mod sited;
mod state;
mod steady;
mod tuning;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, LevelMap, Strategy};
use glam::DVec3;
use rapier3d::control::DynamicRayCastVehicleController;
use rapier3d::dynamics::RigidBodyHandle;

use crate::PhysicsWorld;
use arena::Arena;
use doors::Junction;
pub use doors::VehicleDoors;
use hold::Hold;
use hull::Hull;
use needed::Needed;
pub use part::{Side, VehiclePart};
use role::{JUNCTIONS, Role};
use site::Sited;
pub use state::{VehicleInput, VehicleMotion, VehicleWheel};
pub use tuning::VehicleTuning;

/// Below these, in m/s and rad/s, a vehicle that nobody drives is at rest, and falls asleep after so many seconds.
const RESTS_M_S: f64 = 0.06;
const RESTS_RAD_S: f64 = 0.06;
const SLEEPS_AFTER_S: f64 = 1.0;
/// A sleeper wakes when another comes within this, in metres.
const WAKES_WITHIN_M: f64 = 6.0;

/// A vehicle.
pub struct Vehicle {
    motion: VehicleMotion,
    wheels: [VehicleWheel; 4],
    steer_rad: f64,
    brakes: bool,
    jolt_m_s: f64,
    /// Its body's velocity with what springs and tyres gave it after the last step, m/s.
    rolled: DVec3,
    rests_s: f64,
    hold: Hold,
    /// What it met in the last step.
    role: Role,
    body: Option<(RigidBodyHandle, DynamicRayCastVehicleController)>,
    /// In what it moves where that is not the chart, as long as it has a body; what it rolled by and where it holds are told there, too.
    sited: Option<Sited>,
}

/// Which arena it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Room {
    /// Of all of a chart.
    Chart(ChartId),
    /// About a place, by its number.
    Site(u64),
}

impl Vehicle {
    /// Where it is and how it moves.
    pub fn motion(&self) -> VehicleMotion {
        self.motion
    }

    /// Front left, front right, rear left, rear right.
    pub fn wheels(&self) -> &[VehicleWheel; 4] {
        &self.wheels
    }

    /// How far the front wheels are turned to the right, radians.
    pub fn steer_rad(&self) -> f64 {
        self.steer_rad
    }

    /// Whether its driver brakes.
    pub fn brakes(&self) -> bool {
        self.brakes
    }

    /// By how much its velocity was changed in the last step by what it ran into, m/s.
    pub fn jolt_m_s(&self) -> f64 {
        self.jolt_m_s
    }

    /// Whether it has come to rest and is not stepped.
    pub fn is_asleep(&self) -> bool {
        self.rests_s >= SLEEPS_AFTER_S
    }

    /// Wakes it, as when the ground below it may have changed.
    pub fn wake(&mut self) {
        self.rests_s = 0.0;
    }
}

impl std::fmt::Debug for Vehicle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Vehicle")
            .field("motion", &self.motion)
            .field("wheels", &self.wheels)
            .finish_non_exhaustive()
    }
}

/// What the vehicles of a world have in common: how they drive, their hull, and where those of a chart collide. A vehicle is
/// stepped by the one that made it, and its body stays in there.
pub struct VehiclePhysics {
    tuning: VehicleTuning,
    hull: Hull,
    /// Of the charts in which vehicles have bodies. The last one stays when it has none left, so that one that comes back
    /// finds the frame that he left.
    arenas: BTreeMap<Room, Arena>,
    /// The space, where bodies do not move in the chart.
    curved: Option<Arc<dyn Strategy>>,
    /// How many arenas about places there have been.
    sites_made: u64,
}

impl Default for VehiclePhysics {
    fn default() -> Self {
        Self::new(VehicleTuning::default())
    }
}

impl std::fmt::Debug for VehiclePhysics {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VehiclePhysics")
            .field("tuning", &self.tuning)
            .finish_non_exhaustive()
    }
}

impl VehiclePhysics {
    /// Without vehicles yet.
    pub fn new(tuning: VehicleTuning) -> Self {
        Self {
            tuning,
            hull: Hull::new(),
            arenas: BTreeMap::new(),
            curved: None,
            sites_made: 0,
        }
    }

    /// Has those that it makes from now on move in metres of a space, where bodies do not move in the chart: velocities and spins are then
    /// told in them, along the frame of the chart at the vehicle, and so is how it is turned.
    #[must_use]
    pub fn in_space(self, space: &Arc<dyn Strategy>) -> Self {
        Self {
            curved: (!space.moves_in_chart()).then(|| Arc::clone(space)),
            ..self
        }
    }

    /// How the metres of a vehicle at a place lie in the chart.
    pub fn level_at(&self, place: ChartPoint) -> LevelMap {
        let space = self.curved.as_deref();
        space.map_or(LevelMap::SAME, |space| LevelMap::at(space, place))
    }

    /// How all of them drive.
    pub fn tuning(&self) -> &VehicleTuning {
        &self.tuning
    }

    /// A new vehicle. A motion that is not finite becomes one at rest at the origin.
    pub fn vehicle(&self, motion: VehicleMotion) -> Vehicle {
        let motion = if motion.is_finite() {
            motion
        } else {
            VehicleMotion::default()
        };
        Vehicle {
            motion,
            wheels: self.tuning.hubs.map(|hub| VehicleWheel {
                hub,
                ..VehicleWheel::default()
            }),
            steer_rad: 0.0,
            brakes: false,
            jolt_m_s: 0.0,
            rolled: motion.velocity,
            rests_s: 0.0,
            hold: Hold::default(),
            role: Role::Free,
            body: None,
            sited: None,
        }
    }

    /// Gives a vehicle back how its front wheels were turned (rad, to the right), how far its springs were pushed in
    /// (m, zero in the air) and whether it rested. Numbers that are not finite are left out.
    pub fn restore(&self, vehicle: &mut Vehicle, steer_rad: f64, springs_m: [f64; 4], rests: bool) {
        let tuning = &self.tuning;
        if steer_rad.is_finite() {
            let most = tuning.steer_most_rad;
            vehicle.steer_rad = steer_rad.clamp(-most, most);
        }
        for (place, (wheel, spring_m)) in vehicle.wheels.iter_mut().zip(springs_m).enumerate() {
            if !(spring_m > 0.0 && spring_m <= tuning.spring_m()) {
                continue;
            }
            wheel.contact = true;
            wheel.compression_m = spring_m;
            wheel.hub = tuning.mount(place) - DVec3::Y * (tuning.spring_m() - spring_m);
            if place < 2 {
                wheel.steer_rad = vehicle.steer_rad;
            }
        }
        if rests {
            vehicle.rests_s = SLEEPS_AFTER_S;
        }
    }

    /// Advances all vehicles by `dt_s` seconds, always in the same order. One without an input is held still where it
    /// is, as long as the ground below it is not there. Whose middle goes through a door is to be carried by the caller.
    pub fn step(
        &mut self,
        world: &PhysicsWorld,
        doors: Option<&VehicleDoors<'_>>,
        all: &mut [(&mut Vehicle, Option<VehicleInput>)],
        dt_s: f64,
    ) {
        if dt_s.is_nan() || dt_s <= 0.0 {
            return;
        }
        let junctions = doors.map_or([None; JUNCTIONS], |doors| doors::junctions(doors, all));
        let stays = doors.map(|doors| self.bring(doors, &junctions, all));
        wake_near(self.curved.as_deref(), all);
        for (vehicle, input) in &mut *all {
            self.admit(vehicle, *input);
        }
        if let Some(space) = self.curved.clone() {
            self.step_sited(&space, world, &junctions, all, dt_s);
        } else {
            self.step_brought(world, &junctions, all, dt_s);
        }
        if let Some((doors, stays)) = doors.zip(stays) {
            self.take_back(doors, stays, all);
        }
    }

    /// Advances all that move, in the arenas where they are.
    fn step_brought(
        &mut self,
        world: &PhysicsWorld,
        junctions: &[Option<Junction>; JUNCTIONS],
        all: &mut [(&mut Vehicle, Option<VehicleInput>)],
        dt_s: f64,
    ) {
        let moving = all.iter_mut().filter(|(vehicle, _)| vehicle.is_moving());
        let moving: Vec<_> = moving.collect();
        let charts: BTreeSet<ChartId> = moving.iter().map(|(it, _)| it.motion.chart).collect();
        for chart in charts {
            let here = moving.iter().map(|(it, _)| (it.role, &it.motion));
            let here: Vec<_> = here.filter(|(_, it)| it.chart == chart).collect();
            let (Some(arena), Some((_, first))) =
                (self.arenas.get_mut(&Room::Chart(chart)), here.first())
            else {
                continue;
            };
            arena.recentre(first.place);
            arena.take_ground(world, &Needed::of(&here, junctions, dt_s));
            arena.step(self.tuning.gravity_m_s2, dt_s);
        }
        for (vehicle, input) in moving {
            self.advance(vehicle, &input.unwrap_or_default(), dt_s);
        }
    }

    /// Reads out what a step has made of a vehicle, and lets its wheels act.
    fn advance(&mut self, vehicle: &mut Vehicle, input: &VehicleInput, dt_s: f64) {
        let tuning = &self.tuning;
        let before = vehicle.own_motion();
        let room = vehicle.room();
        let (Some((body, controller)), Some(arena)) =
            (&mut vehicle.body, self.arenas.get_mut(&room))
        else {
            return;
        };
        let Some(mut motion) = arena.motion(*body) else {
            // Rapier has lost it: it stays where it was.
            arena.set_motion(*body, &before.stopped());
            vehicle.settle();
            return;
        };
        let expected = vehicle.rolled - DVec3::Y * (tuning.gravity_m_s2 * dt_s);
        vehicle.jolt_m_s = (motion.velocity - expected).length();
        if motion.velocity.y < -tuning.terminal_speed_m_s {
            motion.velocity.y = -tuning.terminal_speed_m_s;
            arena.set_motion(*body, &motion);
        }
        let speed_m_s = motion.speed_m_s();
        let effort = drive::effort(tuning, input, speed_m_s);
        vehicle.steer_rad = drive::steer(tuning, vehicle.steer_rad, input, speed_m_s, dt_s);
        vehicle.brakes = effort.brakes;
        drive::apply(controller, tuning, &effort, vehicle.steer_rad, dt_s);
        let stood_on = normals(controller);
        let pull = vehicle.hold.pull(motion.place, &stood_on, effort.holds);
        arena.roll(controller, vehicle.role, pull, dt_s);
        // What nobody drives lies and leans as it fell, so that it comes to rest.
        if !input.parked {
            steady::steady(arena, *body, &normals(controller), tuning, dt_s);
        }
        vehicle.wheels = wheels(controller, tuning, &motion);
        // Within a step springs and weight take turns, so the speed at its end is not that of the way made.
        let way = tuning.mass_place(&motion) - tuning.mass_place(&before);
        motion.velocity = way / dt_s;
        vehicle.rolled = arena
            .motion(*body)
            .map_or(motion.velocity, |rolled| rolled.velocity);
        let still = motion.velocity.length() < RESTS_M_S && motion.spin.length() < RESTS_RAD_S;
        vehicle.rests_s = if still && input.parked {
            vehicle.rests_s + dt_s
        } else {
            0.0
        };
        if vehicle.rests_s >= SLEEPS_AFTER_S {
            motion = motion.stopped();
            arena.set_motion(*body, &motion);
        }
        vehicle.take(motion, arena.site());
    }
}

impl Vehicle {
    /// Nothing happens to it in a step in which it is held: the jolt of the step before is not felt again.
    fn settle(&mut self) {
        self.jolt_m_s = 0.0;
        self.rolled = self.own_motion().velocity;
        self.hold.let_go();
    }

    fn is_moving(&self) -> bool {
        self.body.is_some() && !self.is_asleep()
    }
}

/// Wakes sleepers that another comes near to.
fn wake_near(space: Option<&dyn Strategy>, all: &mut [(&mut Vehicle, Option<VehicleInput>)]) {
    let moving: Vec<ChartPoint> = all
        .iter()
        // A vehicle that stands and is about to sleep wakes nobody: two side by side would keep each other awake for ever.
        .filter(|(it, _)| it.is_moving() && it.rests_s <= 0.0)
        .map(|(it, _)| it.motion.point())
        .collect();
    for (sleeper, _) in all.iter_mut().filter(|(it, _)| it.is_asleep()) {
        let own = sleeper.motion.point();
        let is_near = |at: &ChartPoint| sited::apart_m(space, own, *at) < WAKES_WITHIN_M;
        if moving.iter().any(is_near) {
            sleeper.wake();
        }
    }
}

/// Upward from the ground below each wheel that touched it when the controller last looked.
fn normals(controller: &DynamicRayCastVehicleController) -> Vec<DVec3> {
    let infos = controller
        .wheels()
        .iter()
        .map(rapier3d::control::Wheel::raycast_info);
    infos
        .filter(|info| info.is_in_contact)
        .map(|info| info.contact_normal_ws.as_dvec3())
        .collect()
}

/// The wheels as the controller left them.
fn wheels(
    controller: &DynamicRayCastVehicleController,
    tuning: &VehicleTuning,
    motion: &VehicleMotion,
) -> [VehicleWheel; 4] {
    let one = |number: usize| {
        let Some(wheel) = controller.wheels().get(number) else {
            return VehicleWheel::default();
        };
        let info = wheel.raycast_info();
        let length_m = f64::from(info.suspension_length).min(tuning.spring_m());
        let axle = wheel.axle().as_dvec3();
        let hub = tuning.mount(number) - DVec3::Y * length_m;
        let slides = motion.velocity + motion.spin.cross(motion.turn * (hub - tuning.mass_centre));
        VehicleWheel {
            hub,
            steer_rad: -f64::from(wheel.steering),
            roll_rad: f64::from(wheel.rotation).rem_euclid(std::f64::consts::TAU),
            contact: info.is_in_contact,
            compression_m: tuning.spring_m() - length_m,
            slide_m_s: if info.is_in_contact {
                slides.dot(axle).abs()
            } else {
                0.0
            },
        }
    };
    [0, 1, 2, 3].map(one)
}
