//! The bodies that stand for vehicles, each in the arena of its chart: how they get there, out of it, and into another's.

use antipode_geometry::Crossing;
use glam::DVec3;
use rapier3d::dynamics::RigidBodyHandle;

use super::arena::Arena;
use super::controller;
use super::{Room, Vehicle, VehicleInput, VehicleMotion, VehiclePhysics};

impl VehiclePhysics {
    /// Puts a vehicle elsewhere, and wakes it. A motion that is not finite is ignored.
    pub fn set_motion(&mut self, vehicle: &mut Vehicle, motion: VehicleMotion) {
        if !motion.is_finite() {
            return;
        }
        self.put_body(vehicle, &motion);
        vehicle.motion = motion;
        vehicle.rolled = vehicle.own_motion().velocity;
        vehicle.rests_s = 0.0;
        vehicle.hold.let_go();
    }

    /// Has the body that a vehicle has move so, in the arena of the motion's chart.
    fn put_body(&mut self, vehicle: &mut Vehicle, motion: &VehicleMotion) {
        if vehicle.sited.is_some() {
            self.put_about(vehicle, motion);
            return;
        }
        let (from, to) = (vehicle.motion.chart, motion.chart);
        let Some((body, controller)) = &mut vehicle.body else {
            return;
        };
        if from == to {
            if let Some(arena) = self.arenas.get_mut(&Room::Chart(from)) {
                arena.set_motion(*body, motion);
            }
            return;
        }
        let arena = self.arenas.entry(Room::Chart(to));
        let arena = arena.or_insert_with(|| Arena::new(to));
        let entered = arena.put_in(&self.hull, &self.tuning, motion);
        controller.chassis = entered;
        let left = std::mem::replace(body, entered);
        self.take_out(Room::Chart(from), left);
    }

    /// Removes a body, and the arena that has none left, if there are others.
    pub(super) fn take_out(&mut self, room: Room, body: RigidBodyHandle) {
        let Some(arena) = self.arenas.get_mut(&room) else {
            return;
        };
        arena.take_out(body);
        if self.arenas.len() > 1 {
            self.arenas.retain(|_, arena| !arena.is_empty());
        }
    }

    /// Pushes a vehicle at a point of its chart (m) by an impulse (N s).
    pub fn push(&mut self, vehicle: &mut Vehicle, at: DVec3, impulse: DVec3) {
        vehicle.rests_s = 0.0;
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get_mut(&vehicle.room())
            && at.is_finite()
            && impulse.is_finite()
        {
            let (at, impulse) = vehicle.taken_in(arena.site(), at, impulse);
            arena.set_still(*body, false);
            arena.push(*body, at, impulse);
            if let Some(motion) = arena.motion(*body) {
                let pushed = motion.velocity - vehicle.rolled;
                vehicle.motion.velocity += vehicle.told(pushed);
                vehicle.rolled = motion.velocity;
            }
        }
    }

    /// Takes a vehicle into another chart, where everything is turned: how it stands, its velocity,
    /// its spin, and what its springs are about to do.
    pub fn carry(&mut self, vehicle: &mut Vehicle, crossing: &Crossing) {
        if vehicle.sited.is_some() {
            vehicle.motion = vehicle.motion.carried(crossing);
            self.follow(vehicle, crossing);
            return;
        }
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get(&vehicle.room())
            && let Some(motion) = arena.motion(*body)
        {
            self.put_body(vehicle, &motion.carried(crossing));
        }
        vehicle.hold.carry(vehicle.motion.place, crossing);
        vehicle.motion = vehicle.motion.carried(crossing);
        vehicle.rolled = crossing.turn_vector(vehicle.rolled);
    }

    /// Makes a vehicle so many times as fast, without a jolt: a metre of the chart may be longer or shorter where it was
    /// carried. A share that is not finite is ignored, and so is any where vehicles go by metres of the space.
    pub fn hasten(&mut self, vehicle: &mut Vehicle, share: f64) {
        if !share.is_finite() || self.curved.is_some() {
            return;
        }
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get_mut(&vehicle.room())
            && let Some(motion) = arena.motion(*body)
        {
            let velocity = motion.velocity * share;
            arena.set_motion(*body, &VehicleMotion { velocity, ..motion });
        }
        vehicle.motion.velocity *= share;
        vehicle.rolled *= share;
    }

    /// Gives a vehicle that has ground a body, and takes it from one that has none.
    pub(super) fn admit(&mut self, vehicle: &mut Vehicle, input: Option<VehicleInput>) {
        if input.is_some_and(|input| !input.parked) {
            vehicle.rests_s = 0.0;
        }
        match (&vehicle.body, input) {
            (None, Some(_)) => self.put_in(vehicle),
            (Some((body, _)), None) => {
                self.take_out(vehicle.room(), *body);
                vehicle.body = None;
                vehicle.sited = None;
                vehicle.settle();
            }
            _ => {}
        }
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get_mut(&vehicle.room())
        {
            arena.set_still(*body, vehicle.is_asleep());
            arena.set_role(*body, vehicle.role);
        }
    }

    /// Gives a vehicle a body, in the arena of its chart or in one of its own.
    fn put_in(&mut self, vehicle: &mut Vehicle) {
        let (room, motion) = if let Some(space) = self.curved.clone() {
            self.site_about(&space, vehicle)
        } else {
            let chart = vehicle.motion.chart;
            let room = Room::Chart(chart);
            self.arenas.entry(room).or_insert_with(|| Arena::new(chart));
            (room, vehicle.motion)
        };
        if let Some(arena) = self.arenas.get_mut(&room) {
            let body = arena.put_in(&self.hull, &self.tuning, &motion);
            vehicle.body = Some((body, controller::controller(body, &self.tuning)));
        }
    }
}
