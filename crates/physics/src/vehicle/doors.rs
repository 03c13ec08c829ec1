//! Vehicles in doors: who stands in one collides on both sides of it at once.
//!
//! A leaf leads on from either side, so that a pair has two **junctions**, where half of the land about one leaf goes on as half of
//! that about the other. For a step everything near a junction that somebody stands in is written in the chart about one
//! leaf, in whose arena it collides: the ground of both sides, each cut at the leaf, and the bodies of both. Afterwards each
//! is taken back. As a leaf's own axes are kept by who passes, the way there leads by these, without
//! regard to edges of charts.

use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{Atlas, ChartPoint, Crossing, Doorway, Leaf};
use glam::DVec3;

use super::role::{JUNCTIONS, Role};
use super::{Vehicle, VehicleInput, VehicleMotion, VehiclePhysics};

/// A vehicle whose middle is nearer to a leaf than this may reach through it, metres.
const ASTRIDE_M: f64 = 2.2;
/// Vehicles so near to a leaf that somebody stands in are brought together, metres.
const NEAR_M: f64 = 9.0;

/// A pair of doors, and how the charts hang together that they stand in.
#[derive(Clone, Copy, Debug)]
pub struct VehicleDoors<'a> {
    /// The charts.
    pub atlas: &'a dyn Atlas,
    /// The pair.
    pub pair: &'a Doorway,
}

/// Where half of the land about one leaf goes on as half of that about the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Junction {
    /// The leaf in whose chart all is brought together.
    pub host: Leaf,
    /// The other one.
    pub far: Leaf,
    /// The sign of x in the host's axes where its own land lies.
    pub side: f64,
    /// Which leaf the host is.
    leaf: usize,
}

impl Junction {
    /// A place in the chart of the other leaf as it lies about the host.
    pub fn brought(&self, pos: DVec3) -> DVec3 {
        self.host.place(self.far.local(pos)).pos
    }

    /// The reverse.
    pub fn taken_back(&self, pos: DVec3) -> DVec3 {
        self.far.place(self.host.local(pos)).pos
    }

    /// The turn about +y of what is brought, radians.
    pub fn turn_rad(&self) -> f64 {
        self.far.yaw - self.host.yaw
    }
}

/// Where a vehicle is to the leaf that is nearest to it.
struct Standing {
    leaf: usize,
    /// The vehicle's place in the leaf's chart.
    near: Crossing,
    /// And in its own axes.
    local: DVec3,
}

impl Standing {
    fn of(doors: &VehicleDoors<'_>, point: ChartPoint) -> Option<Self> {
        let about = |leaf: usize| {
            let door = &doors.pair.leaves[leaf];
            let near = doors.atlas.carry_near(point, door.foot)?;
            let local = door.local(near.point.pos);
            (local.length() < NEAR_M).then_some(Self { leaf, near, local })
        };
        let both = [about(0), about(1)].into_iter().flatten();
        both.min_by(|a, b| a.local.length().total_cmp(&b.local.length()))
    }

    fn is_astride(&self) -> bool {
        self.local.x.abs() < ASTRIDE_M
            && self.local.z.abs() < HALF_WIDTH_M
            && (-BELOW_FOOT_M..HEIGHT_M).contains(&self.local.y)
    }

    /// Which junction it is at: the first has the older leaf's land before it and the newer one's behind it.
    fn junction(&self) -> usize {
        usize::from((self.leaf == 0) != (self.local.x < 0.0))
    }
}

/// A vehicle that is brought somewhere for a step.
pub(super) struct Stay {
    vehicle: usize,
    leaf: usize,
    junction: Junction,
    /// Where it was and where it is, and what it was given by springs and tyres there.
    home: (VehicleMotion, DVec3),
    brought: VehicleMotion,
}

/// Who takes part in a step: vehicles, and what is asked of each.
type All<'a, 'b> = &'a mut [(&'b mut Vehicle, Option<VehicleInput>)];

/// The junctions that somebody stands in who moves.
pub(super) fn junctions(
    doors: &VehicleDoors<'_>,
    all: &[(&mut Vehicle, Option<VehicleInput>)],
) -> [Option<Junction>; JUNCTIONS] {
    let mut found = [None; JUNCTIONS];
    for (vehicle, input) in all {
        if input.is_none() || vehicle.is_asleep() {
            continue;
        }
        let standing = Standing::of(doors, vehicle.motion.point());
        let Some(it) = standing.filter(Standing::is_astride) else {
            continue;
        };
        found[it.junction()].get_or_insert(Junction {
            host: doors.pair.leaves[it.leaf],
            far: doors.pair.leaves[1 - it.leaf],
            side: if it.local.x < 0.0 { -1.0 } else { 1.0 },
            leaf: it.leaf,
        });
    }
    found
}

impl VehiclePhysics {
    /// Brings all that is near a junction about its host, and says what each is there.
    pub(super) fn bring(
        &mut self,
        doors: &VehicleDoors<'_>,
        junctions: &[Option<Junction>; JUNCTIONS],
        all: All<'_, '_>,
    ) -> Vec<Stay> {
        let mut stays = Vec::new();
        for (number, (vehicle, input)) in all.iter_mut().enumerate() {
            vehicle.role = Role::Free;
            let standing = Standing::of(doors, vehicle.motion.point());
            let Some(it) = standing.filter(|_| input.is_some()) else {
                continue;
            };
            let at = it.junction();
            let Some(junction) = junctions[at] else {
                continue;
            };
            let is_native = it.leaf == junction.leaf;
            vehicle.role = match (it.is_astride(), is_native) {
                (true, _) => Role::Astride(at),
                (false, true) => Role::Native(at),
                (false, false) => Role::Guest(at),
            };
            if is_native && it.near.point.chart == vehicle.motion.chart {
                continue;
            }
            let home = (vehicle.motion, vehicle.rolled);
            let own = &doors.pair.leaves[it.leaf];
            self.carry(
                vehicle,
                &Crossing {
                    point: junction.host.place(it.local),
                    turn_rad: it.near.turn_rad + own.yaw - junction.host.yaw,
                },
            );
            stays.push(Stay {
                vehicle: number,
                leaf: it.leaf,
                junction,
                home,
                brought: vehicle.motion,
            });
        }
        stays
    }

    /// Takes those back that were brought, each to its own chart; who did not move is where it was to the bit.
    pub(super) fn take_back(
        &mut self,
        doors: &VehicleDoors<'_>,
        stays: Vec<Stay>,
        all: All<'_, '_>,
    ) {
        for stay in stays {
            let Some((vehicle, _)) = all.get_mut(stay.vehicle) else {
                continue;
            };
            let (host, own) = (&stay.junction.host, &doors.pair.leaves[stay.leaf]);
            let there = own.place(host.local(vehicle.motion.place));
            let home = doors.atlas.carry(there, stay.home.0.chart);
            let home = home.unwrap_or(Crossing::within(there));
            let has_moved = vehicle.motion != stay.brought;
            let turn_rad = host.yaw - own.yaw + home.turn_rad;
            self.carry(vehicle, &Crossing { turn_rad, ..home });
            if !has_moved {
                (vehicle.motion, vehicle.rolled) = stay.home;
            }
        }
    }
}
