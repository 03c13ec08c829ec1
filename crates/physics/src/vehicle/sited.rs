//! Vehicles that move in metres of the space: in arenas about places near them, which are laid anew as they go.
//!
//! Those near each other share an arena, whichever charts of the world they belong to. It lies about the first of them that moves; when one gets near to the end
//! of the ground that was laid, or that ground changes, all of it is laid again about where they are now. Places are carried exactly, and what turns
//! is turned by the angle between both frames, so that nothing is felt of it. To cross from chart to chart is a change of address.

use std::collections::BTreeSet;
use std::sync::Arc;

use antipode_geometry::{BodyFrame, ChartPoint, Crossing, Strategy};
use glam::{DQuat, DVec3};

use super::arena::Arena;
use super::doors::Junction;
use super::laid::Want;
use super::needed::STEPS_AHEAD;
use super::role::{Earth, JUNCTIONS, Role};
use super::site::{Site, Sited};
use super::{Room, Vehicle, VehicleInput, VehicleMotion, VehiclePhysics};
use crate::PhysicsWorld;

/// Vehicles within this of each other come into one arena, and stay in it to within the second, in metres.
const JOIN_M: (f64, f64) = (10.0, 14.0);
/// A vehicle that is carried to within this of where its arena has it anyway has got another address, in metres.
const SAME_M: f64 = 1e-3;

/// Ground within this of a vehicle's middle is needed, in metres: no part of it is farther off, nor where a wheel's ray ends.
const GROUND_AROUND: DVec3 = DVec3::splat(2.0);

/// Who takes part in a step.
type All<'a, 'b> = &'a mut [(&'b mut Vehicle, Option<VehicleInput>)];

/// How far it is between two vehicles, in metres of the space, or of their chart where bodies move in that.
pub(super) fn apart_m(space: Option<&dyn Strategy>, a: ChartPoint, b: ChartPoint) -> f64 {
    let Some(space) = space else {
        return if a.chart == b.chart {
            a.pos.distance(b.pos)
        } else {
            f64::INFINITY
        };
    };
    let far = || b.chart != a.chart && space.carry_near(b, a).is_none();
    if far() {
        return f64::INFINITY;
    }
    BodyFrame::way(space, a, b).length()
}

impl Role {
    fn junction(self) -> Option<usize> {
        match self {
            Self::Free => None,
            Self::Native(at) | Self::Guest(at) | Self::Astride(at) => Some(at),
        }
    }
}

impl Vehicle {
    /// Its motion as the arena has it that it is in.
    pub(super) fn own_motion(&self) -> VehicleMotion {
        self.sited.map_or(self.motion, |sited| sited.own)
    }

    /// In which arena it has its body.
    pub(super) fn room(&self) -> Room {
        let chart = Room::Chart(self.motion.chart);
        self.sited.map_or(chart, |sited| Room::Site(sited.room))
    }

    /// It moves so now, as its arena has it.
    pub(super) fn take(&mut self, own: VehicleMotion, site: Option<&Site>) {
        self.motion = match (&mut self.sited, site) {
            (Some(sited), Some(site)) => {
                let (told, turn_rad) = site.told(&own, self.motion.chart);
                (sited.own, sited.turn_rad) = (own, turn_rad);
                told
            }
            _ => own,
        };
    }

    /// A place of its chart and a vector there as its arena has them.
    pub(super) fn taken_in(&self, site: Option<&Site>, at: DVec3, way: DVec3) -> (DVec3, DVec3) {
        let (Some(sited), Some(site)) = (&self.sited, site) else {
            return (at, way);
        };
        let back = DQuat::from_rotation_y(-sited.turn_rad);
        let arm = site.way(self.motion.point(), at - self.motion.place);
        (sited.own.place + back * arm, back * way)
    }

    /// A vector of its arena as its motion is told.
    pub(super) fn told(&self, way: DVec3) -> DVec3 {
        self.sited
            .map_or(way, |it| DQuat::from_rotation_y(it.turn_rad) * way)
    }
}

impl VehiclePhysics {
    /// An arena of its own for a vehicle without a body, and its motion there.
    pub(super) fn site_about(
        &mut self,
        space: &Arc<dyn Strategy>,
        vehicle: &mut Vehicle,
    ) -> (Room, VehicleMotion) {
        let room = self.new_site(Site::about(space, vehicle.motion.point()));
        let at = ChartPoint::new(vehicle.motion.chart, DVec3::ZERO);
        let own = vehicle.motion.carried(&Crossing::within(at));
        vehicle.sited = Some(Sited {
            room,
            own,
            turn_rad: 0.0,
        });
        vehicle.rolled = own.velocity;
        vehicle.hold.let_go();
        (Room::Site(room), own)
    }

    fn new_site(&mut self, site: Site) -> u64 {
        let number = self.sites_made;
        self.sites_made += 1;
        self.arenas.insert(Room::Site(number), Arena::about(site));
        number
    }

    /// Has the body of a vehicle move so, in an arena of its own about there. The vehicle's motion is the caller's to set.
    pub(super) fn put_about(&mut self, vehicle: &mut Vehicle, motion: &VehicleMotion) {
        let Some(space) = self.curved.clone() else {
            return;
        };
        let room = self.new_site(Site::about(&space, motion.point()));
        let at = ChartPoint::new(motion.chart, DVec3::ZERO);
        let own = motion.carried(&Crossing::within(at));
        self.move_body(vehicle, room, &own);
        vehicle.sited = Some(Sited {
            room,
            own,
            turn_rad: 0.0,
        });
    }

    /// A vehicle's motion has been carried: if it is elsewhere now, its body is, too.
    pub(super) fn follow(&mut self, vehicle: &mut Vehicle, crossing: &Crossing) {
        let room = vehicle.room();
        let Some(sited) = &mut vehicle.sited else {
            return;
        };
        sited.turn_rad += crossing.turn_rad;
        let site = self.arenas.get(&room).and_then(Arena::site);
        let seen = site.and_then(|site| site.seen(vehicle.motion.point()));
        let is_there =
            |it: Crossing| it.point.pos.distance(sited.own.place) < SAME_M && is_turned(&it, sited);
        if seen.is_some_and(is_there) {
            return;
        }
        if let Some(space) = self.curved.clone() {
            let room = self.new_site(Site::about(&space, vehicle.motion.point()));
            self.shift(vehicle, room);
        }
    }

    /// Takes a vehicle as it moves into an arena that sees it, or into the same one when that has come to lie elsewhere.
    fn shift(&mut self, vehicle: &mut Vehicle, room: u64) {
        let to = self.arenas.get(&Room::Site(room)).and_then(Arena::site);
        let seen = to.and_then(|site| site.seen(vehicle.motion.point()));
        let (Some(seen), Some(sited), Some((body, _))) = (seen, vehicle.sited, &vehicle.body)
        else {
            return;
        };
        let from = self.arenas.get(&vehicle.room());
        let moves = from.and_then(|arena| arena.motion(*body));
        let moves = moves.unwrap_or_else(|| sited.own.stopped());
        let turn_rad = sited.turn_rad - seen.turn_rad;
        let over = Crossing { turn_rad, ..seen };
        self.move_body(vehicle, room, &moves.carried(&over));
        vehicle.hold.carry(sited.own.place, &over);
        vehicle.rolled = over.turn_vector(vehicle.rolled);
        vehicle.sited = Some(Sited {
            room,
            own: sited.own.carried(&over),
            turn_rad: seen.turn_rad,
        });
    }

    /// Has a vehicle's body move so, in an arena that may be another one.
    fn move_body(&mut self, vehicle: &mut Vehicle, room: u64, own: &VehicleMotion) {
        let from = vehicle.room();
        let Some((body, controller)) = &mut vehicle.body else {
            return;
        };
        let Some(arena) = self.arenas.get_mut(&Room::Site(room)) else {
            return;
        };
        if from == Room::Site(room) {
            arena.set_motion(*body, own);
            return;
        }
        let entered = arena.put_in(&self.hull, &self.tuning, own);
        arena.set_still(entered, vehicle.rests_s >= super::SLEEPS_AFTER_S);
        arena.set_role(entered, vehicle.role);
        controller.chassis = entered;
        let left = std::mem::replace(body, entered);
        self.take_out(from, left);
    }

    /// Advances all that move, each group in its arena.
    pub(super) fn step_sited(
        &mut self,
        space: &Arc<dyn Strategy>,
        world: &PhysicsWorld,
        junctions: &[Option<Junction>; JUNCTIONS],
        all: All<'_, '_>,
        dt_s: f64,
    ) {
        let mut claimed = BTreeSet::new();
        for group in groups(&**space, all) {
            let first = group.iter().find(|&&at| all[at].0.is_moving()).copied();
            let room = self.bring_together(space, &group, all, &mut claimed);
            let (Some(first), Some(room)) = (first, room) else {
                continue;
            };
            let about = Site::about(space, all[first].0.motion.point());
            let needs = wants(&group, all, dt_s);
            let key = Room::Site(room);
            let arena = self.arenas.get_mut(&key);
            if arena.is_some_and(|arena| !arena.is_laid(world, &needs)) {
                if let Some(arena) = self.arenas.get_mut(&key) {
                    arena.set_site(about);
                }
                for &at in &group {
                    self.shift(all[at].0, room);
                }
                let needs = wants(&group, all, dt_s);
                if let Some(arena) = self.arenas.get_mut(&key) {
                    arena.lay_about(world, &needs, junctions);
                }
            }
            if let Some(arena) = self.arenas.get_mut(&key) {
                let is_astride = |at: usize| {
                    let role = Role::Astride(at);
                    group.iter().any(|&it| all[it].0.role == role)
                };
                arena.take_sills(world, junctions, is_astride);
                arena.step(self.tuning.gravity_m_s2, dt_s);
            }
        }
        for (vehicle, input) in all.iter_mut().filter(|(it, _)| it.is_moving()) {
            self.advance(vehicle, &input.unwrap_or_default(), dt_s);
        }
    }

    /// The arena of a group, with all of it in it and nobody else.
    fn bring_together(
        &mut self,
        space: &Arc<dyn Strategy>,
        group: &[usize],
        all: All<'_, '_>,
        claimed: &mut BTreeSet<u64>,
    ) -> Option<u64> {
        let first = &all[*group.first()?].0;
        let own = first.sited?.room;
        let room = if claimed.contains(&own) {
            let site = Site::about(space, first.motion.point());
            self.new_site(site)
        } else {
            own
        };
        claimed.insert(room);
        for &at in group {
            let vehicle = &mut *all[at].0;
            if vehicle.sited.is_some_and(|it| it.room != room) {
                self.shift(vehicle, room);
            }
        }
        Some(room)
    }
}

/// Whether the turn that a vehicle's arena has from it is what its site sees.
fn is_turned(seen: &Crossing, sited: &Sited) -> bool {
    (0.5 * (seen.turn_rad - sited.turn_rad)).sin().abs() < SAME_M
}

/// Those that collide with each other, by their places in the list. Two that sleep do not, as nothing moves.
fn groups(space: &dyn Strategy, all: &[(&mut Vehicle, Option<VehicleInput>)]) -> Vec<Vec<usize>> {
    let there: Vec<usize> = (0..all.len())
        .filter(|&at| all[at].0.sited.is_some())
        .collect();
    let mut group_of: Vec<usize> = (0..all.len()).collect();
    for (nth, &a) in there.iter().enumerate() {
        for &b in &there[nth + 1..] {
            if group_of[a] != group_of[b] && are_together(space, all[a].0, all[b].0) {
                let (kept, gone) = (group_of[a], group_of[b]);
                group_of
                    .iter_mut()
                    .filter(|it| **it == gone)
                    .for_each(|it| *it = kept);
            }
        }
    }
    let mut found: Vec<(usize, Vec<usize>)> = Vec::new();
    for &at in &there {
        match found.iter_mut().find(|(of, _)| *of == group_of[at]) {
            Some((_, group)) => group.push(at),
            None => found.push((group_of[at], vec![at])),
        }
    }
    found.into_iter().map(|(_, group)| group).collect()
}

fn are_together(space: &dyn Strategy, a: &Vehicle, b: &Vehicle) -> bool {
    if !a.is_moving() && !b.is_moving() {
        return false;
    }
    if a.role.junction().is_some() && a.role.junction() == b.role.junction() {
        return true;
    }
    let most_m = if a.room() == b.room() {
        JOIN_M.1
    } else {
        JOIN_M.0
    };
    apart_m(Some(space), a.motion.point(), b.motion.point()) < most_m
}

/// The ground that those of a group need in the next steps who move, each with its velocity.
fn wants(
    group: &[usize],
    all: &[(&mut Vehicle, Option<VehicleInput>)],
    dt_s: f64,
) -> Vec<(Want, DVec3)> {
    let moving = group.iter().map(|&at| &*all[at].0);
    let moving = moving.filter(|vehicle| vehicle.is_moving());
    moving
        .filter_map(|vehicle| {
            let earth = match vehicle.role {
                Role::Free | Role::Native(_) => Earth::Own,
                Role::Guest(at) => Earth::Far(at),
                Role::Astride(_) => return None,
            };
            let own = vehicle.own_motion();
            let way = own.velocity * (STEPS_AHEAD * dt_s);
            let want = Want {
                earth,
                chart: vehicle.motion.chart,
                middle: own.middle() + 0.5 * way,
                half: GROUND_AROUND + 0.5 * way.abs(),
                way: DVec3::ZERO,
            };
            Some((want, own.velocity))
        })
        .collect()
}
