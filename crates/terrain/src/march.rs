//! Marching cubes.
//!
//! Positions on the faces of a chunk equal its neighbour's bit for bit once the origins are
//! added: a vertex depends on the two samples at its edge's ends and on nothing of the cell,
//! always from the lower end, and coordinates across the edge are whole numbers.

use antipode_geometry::{ChartPoint, ChunkCoord};
use glam::{DVec2, Vec3};

use crate::colour::Painter;
use crate::field::{Field, RIM_REACH_M};
use crate::mesh::{ChunkMesh, Vertex};
use crate::samples::{SAMPLES, Samples};
use crate::tables::{EDGES, TRIANGLES};

/// Cells along an edge of a chunk.
const CELLS: usize = 32;
/// Corners along an edge of a chunk.
const CORNERS: usize = CELLS + 1;
/// Vertices keep this share of their edge away from its ends, so that ground through a sample
/// gives small triangles, never empty ones that would have to be cut out of a closed surface.
const END_SHARE: f32 = 1.0 / 512.0;
/// The bits of a column's cells: cell `j` stands on sample `j + 1`.
const CELL_BITS: u64 = ((1 << CELLS) - 1) << 1;
const NO_VERTEX: u32 = u32::MAX;

/// The mesh of a chunk's samples, coloured as the field's biome. On the sphere only cells that
/// touch the ground up to [`RIM_REACH_M`] past the rim are meshed.
pub fn march(samples: &Samples, field: &Field, coord: ChunkCoord) -> ChunkMesh {
    let solid = solid_columns(samples);
    let mut mesher = Mesher {
        samples,
        coord,
        painter: Painter::new(field),
        made: Vec::new(),
        mesh: ChunkMesh::default(),
    };
    for i in 0..CELLS {
        for k in 0..CELLS {
            let at = |x, z| solid[(i + 1 + x) * SAMPLES + k + 1 + z];
            let columns = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
            let mut crossed = crossed_cells(columns);
            if crossed == 0 || !mesher.in_reach(i, k) {
                continue;
            }
            while crossed != 0 {
                let bit = crossed.trailing_zeros() as usize;
                crossed &= crossed - 1;
                mesher.cell([i, bit - 1, k], case(columns, bit));
            }
        }
    }
    mesher.mesh
}

/// For each column `(i, k)` of the block, the samples that are solid as bits.
fn solid_columns(samples: &Samples) -> Vec<u64> {
    samples
        .values()
        .chunks_exact(SAMPLES)
        .map(|column| {
            column
                .iter()
                .rev()
                .fold(0, |bits, &value| bits << 1 | u64::from(value < 0.0))
        })
        .collect()
}

/// The cells between four columns that are neither all solid nor all air.
fn crossed_cells(columns: [u64; 4]) -> u64 {
    let any = columns.iter().fold(0, |a, &b| a | b);
    let all = columns.iter().fold(u64::MAX, |a, &b| a & b);
    (any | any >> 1) & !(all & all >> 1) & CELL_BITS
}

/// The case of the cell that stands on sample `bit` of its columns, which run x first.
fn case(columns: [u64; 4], bit: usize) -> usize {
    let pair = |column: usize| (columns[column] >> bit & 3) as usize;
    let layer = |side: usize| {
        let (near, far) = (pair(2 * side), pair(2 * side + 1));
        near & 1 | (far & 1) << 1 | (near >> 1) << 2 | (far >> 1) << 3
    };
    layer(0) | layer(1) << 4
}

/// Where the field is zero between the samples at an edge's lower and upper end, as a share of
/// the edge. Samples that are not finite still give a place on it.
fn place_on_edge(low: f32, high: f32) -> f32 {
    let share = low / (low - high);
    if share.is_nan() {
        0.5
    } else {
        share.clamp(END_SHARE, 1.0 - END_SHARE)
    }
}

struct Mesher<'a> {
    samples: &'a Samples,
    coord: ChunkCoord,
    painter: Painter<'a>,
    /// Vertices by their edge's lower corner and axis; allocated when the first is made.
    made: Vec<u32>,
    mesh: ChunkMesh,
}

impl Mesher<'_> {
    fn in_reach(&self, i: usize, k: usize) -> bool {
        let Some(rim_m) = self.painter.rim_m() else {
            return true;
        };
        let origin = self.coord.origin();
        let low = DVec2::new(origin.x + i as f64, origin.z + k as f64);
        DVec2::ZERO.clamp(low, low + 1.0).length() <= rim_m + RIM_REACH_M
    }

    fn cell(&mut self, cell: [usize; 3], case: usize) {
        for &edge in TRIANGLES[case] {
            let edge = EDGES[usize::from(edge)];
            let corner = [
                cell[0] + (edge.corner & 1),
                cell[1] + (edge.corner >> 1 & 1),
                cell[2] + (edge.corner >> 2),
            ];
            let index = self.vertex(corner, edge.axis);
            self.mesh.indices.push(index);
        }
    }

    /// The vertex on the edge that runs from a corner, `0..=32` each, along an axis.
    fn vertex(&mut self, corner: [usize; 3], axis: usize) -> u32 {
        if self.made.is_empty() {
            self.made = vec![NO_VERTEX; CORNERS * CORNERS * CORNERS * 3];
        }
        let at = ((corner[0] * CORNERS + corner[2]) * CORNERS + corner[1]) * 3 + axis;
        if self.made[at] == NO_VERTEX {
            self.made[at] = self.mesh.vertices.len() as u32;
            let vertex = self.make_vertex(corner, axis);
            self.mesh.vertices.push(vertex);
        }
        self.made[at]
    }

    fn make_vertex(&self, corner: [usize; 3], axis: usize) -> Vertex {
        let low = corner.map(|c| c + 1);
        let mut high = low;
        high[axis] += 1;
        let (a, b) = (self.value(low), self.value(high));
        let share = place_on_edge(a, b);
        let mut position = corner.map(|c| c as f32);
        position[axis] += share;
        let slope = self.slope(low);
        let normal = (slope + (self.slope(high) - slope) * share).normalize_or(Vec3::Y);
        let point = ChartPoint {
            hemisphere: self.coord.hemisphere,
            pos: self.coord.origin() + Vec3::from(position).as_dvec3(),
        };
        let [x, y, z] = normal.to_array().map(|c| (c * 32767.0).round() as i16);
        Vertex {
            position,
            normal: [x, y, z, 0],
            colour: self.painter.paint(point, normal),
        }
    }

    fn value(&self, [i, j, k]: [usize; 3]) -> f32 {
        self.samples.get(i, j, k)
    }

    /// Twice the field's gradient at a sample, by central differences.
    fn slope(&self, [i, j, k]: [usize; 3]) -> Vec3 {
        Vec3::new(
            self.value([i + 1, j, k]) - self.value([i - 1, j, k]),
            self.value([i, j + 1, k]) - self.value([i, j - 1, k]),
            self.value([i, j, k + 1]) - self.value([i, j, k - 1]),
        )
    }
}
