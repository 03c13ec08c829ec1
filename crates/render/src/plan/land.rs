//! A chunk's mesh as the planner knows it.

use antipode_geometry::{CHUNK_CELLS, ChunkCoord};
use antipode_terrain::{ChunkMesh, Level, UNITS_PER_M};
use glam::{DVec3, U16Vec3};

use super::choice::LONGEST_EDGE_M;
use crate::things::with_things;

/// A mesh that keeps this far from its chunk's floor does not go on below it, metres.
const FLOOR_CLEARANCE_M: f64 = 0.01;

/// What the planner knows of a chunk's land.
#[derive(Clone, Copy, Debug)]
pub struct ChunkLand {
    /// Which chunk.
    pub coord: ChunkCoord,
    /// The resolution of its mesh.
    pub level: Level,
    /// Lowest corner of its mesh, chart metres.
    pub min: DVec3,
    /// Highest corner of its mesh, chart metres.
    pub max: DVec3,
    /// Lowest and highest corner of that and of what stands on it, chart metres.
    pub whole: [DVec3; 2],
    /// Triangles of its surface.
    pub triangles: usize,
    /// What its level is off by, metres.
    pub error_m: f64,
    /// What of it is certainly solid.
    pub ground: Ground,
}

/// Parts of a chunk's ground plan along each side, 8 m wide: as wide as the widest cells of a mesh, so that no
/// triangle lies in two.
pub const PARTS: usize = 4;
/// Units of a part's width, and of a chunk's height.
const PART_UNITS: u16 = (CHUNK_CELLS as u32 * UNITS_PER_M / PARTS as u32) as u16;
const TOP: u16 = (CHUNK_CELLS as u32 * UNITS_PER_M) as u16;

/// What of a chunk is certainly solid, by parts of its ground plan, row by row along x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ground {
    /// Whether its floor lies in the ground throughout, and so do the chunks below.
    is_floor_solid: bool,
    /// The lowest place of the mesh over each part, in units over the floor: [`TOP`] where there is none.
    lowest: [u16; PARTS * PARTS],
}

impl Ground {
    /// Nothing is certain.
    pub const UNKNOWN: Self = Self {
        is_floor_solid: false,
        lowest: [0; PARTS * PARTS],
    };

    /// Any, mostly solid below.
    #[cfg(test)]
    pub fn random(numbers: &mut super::testing::Numbers) -> Self {
        let mut lowest = || {
            numbers
                .between(-4000.0, 36_000.0)
                .clamp(0.0, f64::from(TOP)) as u16
        };
        Self {
            lowest: std::array::from_fn(|_| lowest()),
            is_floor_solid: numbers.between(0.0, 1.0) < 0.8,
        }
    }

    fn of(mesh: &ChunkMesh) -> Self {
        let mut lowest = [TOP; PARTS * PARTS];
        for vertex in &mesh.vertices {
            let [x, y, z] = vertex.units;
            // A place between two parts belongs to both.
            let around = |u: u16| usize::from(u.saturating_sub(1) / PART_UNITS)..=last(u);
            for at in around(z).flat_map(|z| around(x).map(move |x| x + PARTS * z)) {
                lowest[at] = lowest[at].min(y);
            }
        }
        // Below the mesh's lowest place lies ground, if that place is a floor; and all the way down, if the mesh
        // stays clear of the chunk's own floor.
        let least = mesh.vertices.iter().min_by_key(|v| v.units[1]);
        Self {
            is_floor_solid: least.is_some_and(|v| v.normal().y > 0.0 && is_clear(v.units[1])),
            lowest,
        }
    }

    /// The heights up to which a column is solid, by parts, chart metres, from what is known of its chunks upwards;
    /// `None` where the lowest does not say.
    ///
    /// Over a solid floor a part of a chunk is solid up to its mesh, or up to the chunk's top where there is none; and
    /// then so is the floor of that part of the next chunk.
    pub fn solid_below_m<'a>(
        mut upwards: impl Iterator<Item = &'a ChunkLand>,
    ) -> Option<[f64; PARTS * PARTS]> {
        let lowest = upwards.next().filter(|chunk| chunk.ground.is_floor_solid)?;
        let height = |chunk: &ChunkLand, units: u16| {
            chunk.coord.origin().y + f64::from(units) / f64::from(UNITS_PER_M)
        };
        let mut solid = lowest.ground.lowest.map(|units| height(lowest, units));
        let mut goes_on = lowest.ground.lowest.map(|units| units == TOP);
        for (below, chunk) in (lowest.coord.index.y..).zip(upwards) {
            if chunk.coord.index.y != below + 1 {
                break;
            }
            for (part, units) in chunk.ground.lowest.into_iter().enumerate() {
                goes_on[part] &= is_clear(units);
                if goes_on[part] {
                    solid[part] = height(chunk, units);
                    goes_on[part] = units == TOP;
                }
            }
        }
        Some(solid)
    }
}

/// The last part that a place along a side belongs to.
fn last(units: u16) -> usize {
    usize::from(units / PART_UNITS).min(PARTS - 1)
}

fn is_clear(units: u16) -> bool {
    f64::from(units) > FLOOR_CLEARANCE_M * f64::from(UNITS_PER_M)
}

/// How high reeds may stand, metres.
const LOW_GROWTH_M: f64 = 2.6;

impl ChunkLand {
    /// The land of a mesh.
    pub fn of(coord: ChunkCoord, mesh: &ChunkMesh) -> Self {
        let origin = coord.origin();
        let metres = |units: u16| f64::from(units) / f64::from(UNITS_PER_M);
        let (mut min, mut max) = (U16Vec3::MAX, U16Vec3::MIN);
        for vertex in &mesh.vertices {
            let units = U16Vec3::from(vertex.units);
            min = min.min(units);
            max = max.max(U16Vec3::from(vertex.units_above()));
        }
        let corner = |units: U16Vec3| origin + DVec3::from(units.to_array().map(metres));
        let is_empty = mesh.vertices.is_empty();
        let (min, max) = if is_empty {
            (origin, origin)
        } else {
            (corner(min), corner(max))
        };
        let low_m = if mesh.tufts.is_empty() {
            0.0
        } else {
            LOW_GROWTH_M
        };
        Self {
            coord,
            level: mesh.level,
            min,
            max,
            whole: with_things([min, max + DVec3::Y * low_m], origin, &mesh.things),
            triangles: mesh.triangles().len(),
            error_m: f64::from(mesh.error_m),
            ground: Ground::of(mesh),
        }
    }

    /// Whether something that stands on it reaches farther than its land.
    pub fn is_outgrown(&self) -> bool {
        self.whole != [self.min, self.max]
    }

    /// Longest edge of its triangles, metres: the diagonal of a cell.
    pub fn longest_edge_m(&self) -> f64 {
        LONGEST_EDGE_M * f64::from(self.level.step_m())
    }
}
