//! What the planner is to know of a chunk's mesh.

use antipode_geometry::ChunkCoord;
use antipode_terrain::{ChunkMesh, Level, UNITS_PER_M};
use glam::{DVec3, U16Vec3};

use super::choice::LONGEST_EDGE_M;

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
    /// Triangles of its surface.
    pub triangles: usize,
    /// What its level is off by, metres.
    pub error_m: f64,
    /// Height below which the chunk's column is solid ground, if that is certain, chart metres.
    pub solid_below_m: Option<f64>,
}

impl ChunkLand {
    /// The land of a mesh.
    pub fn of(coord: ChunkCoord, mesh: &ChunkMesh) -> Self {
        let origin = coord.origin();
        let metres = |units: u16| f64::from(units) / f64::from(UNITS_PER_M);
        let (mut min, mut max) = (U16Vec3::MAX, U16Vec3::MIN);
        for vertex in &mesh.vertices {
            let units = U16Vec3::from(vertex.units);
            min = min.min(units);
            max = max.max(units);
        }
        let corner = |units: U16Vec3| origin + DVec3::from(units.to_array().map(metres));
        // Below the mesh's lowest place lies ground, if that place is a floor; and all the way down, if the mesh
        // stays clear of the chunk's own floor.
        let lowest = mesh.vertices.iter().min_by_key(|v| v.units[1]);
        let solid_below_m = lowest
            .filter(|v| v.normal().y > 0.0 && metres(v.units[1]) > FLOOR_CLEARANCE_M)
            .map(|v| origin.y + metres(v.units[1]));
        let is_empty = mesh.vertices.is_empty();
        Self {
            coord,
            level: mesh.level,
            min: if is_empty { origin } else { corner(min) },
            max: if is_empty { origin } else { corner(max) },
            triangles: mesh.triangles().len(),
            error_m: f64::from(mesh.error_m),
            solid_below_m,
        }
    }

    /// Longest edge of its triangles, metres: the diagonal of a cell.
    pub fn longest_edge_m(&self) -> f64 {
        LONGEST_EDGE_M * f64::from(self.level.step_m())
    }
}
