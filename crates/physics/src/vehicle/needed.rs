//! The ground that a step of vehicles needs in a chart: its own, and where somebody stands in a door, that of the other side.

use std::collections::BTreeMap;

use antipode_geometry::{ChartId, ChunkCoord};
use glam::DVec3;

use super::VehicleMotion;
use super::doors::Junction;
use super::role::{Earth, JUNCTIONS, Role};
use crate::PhysicsWorld;
use crate::collider::Block;

/// Ground within this of a vehicle's middle is taken in, in metres, and what it covers in the next steps besides.
const GROUND_AROUND_M: f64 = 4.0;
pub(super) const STEPS_AHEAD: f64 = 3.0;

/// Which block of the ground: of which side of a door, its chunk, and its number there.
pub(super) type BlockName = (Earth, ChunkCoord, usize);

/// Where a block lies: its corner, metres of the chart, and its turn about +y, radians.
pub(super) type Lie = (DVec3, f64);

/// The ground that a step needs in a chart.
#[derive(Default)]
pub(super) struct Needed {
    /// Boxes of the chart.
    pub own: Vec<(DVec3, DVec3)>,
    /// Junctions that have their host in it.
    pub junctions: [Option<Gathered>; JUNCTIONS],
}

/// What is needed of the ground at a junction.
pub(super) struct Gathered {
    pub junction: Junction,
    /// Boxes about the host, for who comes from the other side.
    pub guests: Vec<(DVec3, DVec3)>,
    /// Whether somebody stands in it.
    pub is_stood_in: bool,
}

impl Needed {
    /// The ground that those need who move in a chart.
    pub fn of(
        here: &[(Role, &VehicleMotion)],
        junctions: &[Option<Junction>; JUNCTIONS],
        dt_s: f64,
    ) -> Self {
        let of = |role: Role| here.iter().filter(move |(own, _)| *own == role);
        let boxes = |role: Role| of(role).map(|(_, it)| ground_box(it, dt_s));
        let natives = (0..JUNCTIONS).flat_map(|at| boxes(Role::Native(at)));
        let about = |at: usize| {
            let is_stood_in = of(Role::Astride(at)).next().is_some();
            let guests: Vec<_> = boxes(Role::Guest(at)).collect();
            let is_needed = is_stood_in || !guests.is_empty();
            let junction = junctions[at].filter(|_| is_needed);
            junction.map(|junction| Gathered {
                junction,
                guests,
                is_stood_in,
            })
        };
        Self {
            own: boxes(Role::Free).chain(natives).collect(),
            junctions: std::array::from_fn(about),
        }
    }

    /// The blocks that are needed in a chart, and how they lie there.
    pub fn blocks<'a>(
        &self,
        world: &'a PhysicsWorld,
        chart: ChartId,
    ) -> BTreeMap<BlockName, (Lie, &'a Block)> {
        let mut wanted = BTreeMap::new();
        for (min, max) in &self.own {
            for ground in world.chart(chart).grounds_in(*min, *max) {
                let name = (Earth::Own, ground.coord, ground.number());
                wanted.insert(name, ((ground.origin, 0.0), &ground.block));
            }
        }
        for (at, gathered) in self.junctions.iter().enumerate() {
            let Some(Gathered {
                junction, guests, ..
            }) = gathered
            else {
                continue;
            };
            for (min, max) in guests {
                let middle = junction.taken_back(0.5 * (*min + *max));
                // However the box is turned there.
                let half = DVec3::splat(0.5 * (*max - *min).length());
                let ground = world.chart(junction.far.foot.chart);
                for ground in ground.grounds_in(middle - half, middle + half) {
                    let name = (Earth::Far(at), ground.coord, ground.number());
                    let lie = (junction.brought(ground.origin), junction.turn_rad());
                    wanted.insert(name, (lie, &ground.block));
                }
            }
        }
        wanted
    }
}

/// The box of the chart whose ground a vehicle may touch in the next steps.
fn ground_box(motion: &VehicleMotion, dt_s: f64) -> (DVec3, DVec3) {
    let way = motion.velocity * (STEPS_AHEAD * dt_s);
    let around = DVec3::splat(GROUND_AROUND_M);
    let middle = motion.middle();
    (
        middle.min(middle + way) - around,
        middle.max(middle + way) + around,
    )
}
