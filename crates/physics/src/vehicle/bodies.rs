//! The bodies that stand for vehicles, each in the arena of its chart: how they get there, out of it, and into another's.

use antipode_geometry::{ChartId, Crossing};
use glam::DVec3;
use rapier3d::dynamics::RigidBodyHandle;

use super::arena::{self, Arena};
use super::{Vehicle, VehicleInput, VehicleMotion, VehiclePhysics};

impl VehiclePhysics {
    /// Puts a vehicle elsewhere, and wakes it. A motion that is not finite is ignored.
    pub fn set_motion(&mut self, vehicle: &mut Vehicle, motion: VehicleMotion) {
        if !motion.is_finite() {
            return;
        }
        self.put_body(vehicle, &motion);
        vehicle.motion = motion;
        vehicle.rolled = motion.velocity;
        vehicle.rests_s = 0.0;
        vehicle.hold.let_go();
    }

    /// Has the body that a vehicle has move so, in the arena of the motion's chart.
    fn put_body(&mut self, vehicle: &mut Vehicle, motion: &VehicleMotion) {
        let (from, to) = (vehicle.motion.chart, motion.chart);
        let Some((body, controller)) = &mut vehicle.body else {
            return;
        };
        if from == to {
            if let Some(arena) = self.arenas.get_mut(&from) {
                arena.set_motion(*body, motion);
            }
            return;
        }
        let arena = self.arenas.entry(to).or_insert_with(|| Arena::new(to));
        let entered = arena.put_in(&self.hull, &self.tuning, motion);
        controller.chassis = entered;
        let left = std::mem::replace(body, entered);
        self.take_out(from, left);
    }

    /// Removes a body, and the arena that has none left, if there are others.
    fn take_out(&mut self, chart: ChartId, body: RigidBodyHandle) {
        let Some(arena) = self.arenas.get_mut(&chart) else {
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
            && let Some(arena) = self.arenas.get_mut(&vehicle.motion.chart)
            && at.is_finite()
            && impulse.is_finite()
        {
            arena.set_still(*body, false);
            arena.push(*body, at, impulse);
            if let Some(motion) = arena.motion(*body) {
                let pushed = motion.velocity - vehicle.rolled;
                vehicle.motion.velocity += pushed;
                vehicle.rolled = motion.velocity;
            }
        }
    }

    /// Takes a vehicle into another chart, where everything is turned: how it stands, its velocity,
    /// its spin, and what its springs are about to do.
    pub fn carry(&mut self, vehicle: &mut Vehicle, crossing: &Crossing) {
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get(&vehicle.motion.chart)
            && let Some(motion) = arena.motion(*body)
        {
            self.put_body(vehicle, &motion.carried(crossing));
        }
        vehicle.hold.carry(vehicle.motion.place, crossing);
        vehicle.motion = vehicle.motion.carried(crossing);
        vehicle.rolled = crossing.turn_vector(vehicle.rolled);
    }

    /// Makes a vehicle so many times as fast, without a jolt: a metre of the chart may be longer or shorter where it was
    /// carried. A share that is not finite is ignored.
    pub fn hasten(&mut self, vehicle: &mut Vehicle, share: f64) {
        if !share.is_finite() {
            return;
        }
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get_mut(&vehicle.motion.chart)
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
        let chart = vehicle.motion.chart;
        match (&vehicle.body, input) {
            (None, Some(_)) => {
                let arena = self.arenas.entry(chart);
                let arena = arena.or_insert_with(|| Arena::new(chart));
                let body = arena.put_in(&self.hull, &self.tuning, &vehicle.motion);
                vehicle.body = Some((body, arena::controller(body, &self.tuning)));
            }
            (Some((body, _)), None) => {
                self.take_out(chart, *body);
                vehicle.body = None;
                vehicle.settle();
            }
            _ => {}
        }
        if let Some((body, _)) = &vehicle.body
            && let Some(arena) = self.arenas.get_mut(&chart)
        {
            arena.set_still(*body, vehicle.is_asleep());
            arena.set_role(*body, vehicle.role);
        }
    }
}
