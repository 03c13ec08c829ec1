//! Marching cubes, at every level.
//!
//! Positions on the faces of a chunk equal its neighbour's bit for bit: a vertex depends on the
//! two samples at its edge's ends and on nothing of the cell, always from the lower end, and
//! coordinates are whole units. Vertices come in the order of their columns, and cells in strips
//! of columns, so that a triangle's corners were used shortly before.

use antipode_geometry::ChunkCoord;

use crate::crossings::{Lines, Reach, Signs, case};
use crate::field::Field;
use crate::maker::Maker;
use crate::mesh::{ChunkMesh, Vertex};
use crate::samples::Samples;
use crate::seam::SeamMesher;
use crate::tables::{Slot, TRIANGLES, TURNS, Turn};

/// Columns of cells side by side in a strip: as many as leave two rows of their vertices in the
/// cache of a GPU.
const STRIP: usize = 4;

/// The mesh of a chunk's samples, coloured as the field's biome, at the samples' level; with
/// seams, if that is not [`crate::Level::FULL`]. On the sphere only cells that touch the ground up
/// to [`crate::RIM_REACH_M`] past the rim are meshed.
pub fn march(samples: &Samples, field: &Field, coord: ChunkCoord) -> ChunkMesh {
    Mesher::default().march(samples, field, coord)
}

/// What marching needs room for; kept from chunk to chunk, it is allocated once.
#[derive(Debug, Default)]
pub struct Mesher {
    signs: Signs,
    /// By `i * corners + k`.
    lines: Vec<Lines>,
    vertices: Vec<Vertex>,
    indices: Vec<u32>,
    seams: SeamMesher,
}

impl Mesher {
    /// As [`march`].
    pub fn march(&mut self, samples: &Samples, field: &Field, coord: ChunkCoord) -> ChunkMesh {
        let level = samples.level();
        let reach = Reach::new(field, coord, level);
        let maker = Maker::new(samples, field, coord);
        self.signs.read(samples);
        let turn = &TURNS[field.quarter_turns(coord.chart)];
        self.make_surface(&maker, &reach, turn, level.cells());
        let seams = self
            .seams
            .sew(&maker, &reach, &mut self.vertices, &mut self.indices);
        ChunkMesh {
            level,
            vertices: self.vertices.clone(),
            indices: self.indices.clone(),
            seams,
            error_m: field.level_error_m(level) as f32,
            things: Vec::new(),
            tufts: Vec::new(),
        }
    }

    /// Compiled for newer processors too: they count bits and round in one instruction each.
    fn make_surface(&mut self, maker: &Maker<'_>, reach: &Reach, turn: &Turn, cells: usize) {
        #[cfg(target_arch = "x86_64")]
        if crate::wide::has_newer() {
            #[expect(unsafe_code, reason = "a function that not every processor can run")]
            // SAFETY: the processor has just been asked for what the function is compiled for.
            return unsafe { self.make_surface_newer(maker, reach, turn, cells) };
        }
        self.make_surface_plain(maker, reach, turn, cells);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,bmi1,bmi2,lzcnt,popcnt")]
    fn make_surface_newer(&mut self, maker: &Maker<'_>, reach: &Reach, turn: &Turn, cells: usize) {
        self.make_surface_plain(maker, reach, turn, cells);
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn make_surface_plain(&mut self, maker: &Maker<'_>, reach: &Reach, turn: &Turn, cells: usize) {
        self.vertices.clear();
        self.indices.clear();
        self.make_vertices(maker, reach, cells + 1);
        if !self.vertices.is_empty() {
            self.make_triangles(reach, turn, cells);
        }
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn make_vertices(&mut self, maker: &Maker<'_>, reach: &Reach, corners: usize) {
        self.lines.clear();
        for i in 0..corners {
            for k in 0..corners {
                let mut lines = Lines {
                    masks: self.signs.crossed(i, k),
                    first: [0; 3],
                };
                if lines.masks != [0; 3] {
                    let needed = reach.has_edges(i, k);
                    for (axis, needed) in needed.into_iter().enumerate() {
                        lines.first[axis] = self.vertices.len() as u32;
                        lines.masks[axis] *= u64::from(needed);
                        let mut left = lines.masks[axis];
                        while left != 0 {
                            let j = left.trailing_zeros() as usize;
                            left &= left - 1;
                            self.vertices.push(maker.on_edge([i, j, k], axis));
                        }
                    }
                }
                self.lines.push(lines);
            }
        }
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn make_triangles(&mut self, reach: &Reach, turn: &Turn, cells: usize) {
        for strip in (0..cells).step_by(STRIP) {
            for i in 0..cells {
                for k in strip..strip + STRIP {
                    let columns = self.signs.around(i, k);
                    let mut crossed = self.signs.crossed_cells(columns);
                    if crossed == 0 || !reach.has_cell(i, k) {
                        continue;
                    }
                    let around = self.lines_around(i, k, cells + 1, turn);
                    while crossed != 0 {
                        let j = crossed.trailing_zeros() as usize;
                        crossed &= crossed - 1;
                        let row = TRIANGLES[usize::from(turn.cases[case(columns, j)])];
                        self.indices
                            .extend(row.iter().map(|&edge| around.vertex(edge, j)));
                    }
                }
            }
        }
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn lines_around<'a>(&self, i: usize, k: usize, corners: usize, turn: &'a Turn) -> Around<'a> {
        let at = i * corners + k;
        let mut around = Around {
            lines: [(0, 0); 16],
            slots: &turn.slots,
        };
        let columns = [at, at + corners, at + 1, at + corners + 1];
        for (to, column) in around.lines.as_chunks_mut::<4>().0.iter_mut().zip(columns) {
            let Lines { masks, first } = self.lines[column];
            *to = [
                (masks[0], first[0]),
                (masks[1], first[1]),
                (masks[2], first[2]),
                (0, 0),
            ];
        }
        around
    }
}

/// The edges over a column of cells.
struct Around<'a> {
    /// By [`Slot::line`] the corners that have a vertex, as bits, and the vertex of the lowest.
    lines: [(u64, u32); 16],
    /// Where the edges are that a turn's rows name.
    slots: &'a [Slot; 16],
}

impl Around<'_> {
    /// The vertex on one of the edges of cell `j`.
    #[inline]
    fn vertex(&self, edge: u8, j: usize) -> u32 {
        let Slot { line, upper } = self.slots[usize::from(edge & 15)];
        let (mask, first) = self.lines[usize::from(line & 15)];
        let below = (1 << (j & 31) << upper) - 1;
        first + (mask & below).count_ones()
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{CHUNK_CELLS, ChartId, Geometry, strategy};
    use glam::IVec3;

    use super::*;

    #[test]
    fn meshes_are_the_same_on_every_processor() {
        for (geometry, radius_m) in [(Geometry::Euclidean, 20.0), (Geometry::Spherical, 32.0)] {
            for seed in 0..5 {
                let field = Field::new(seed, strategy(geometry, radius_m));
                let ground_m = field.surface_height(ChartId::SECOND, -16.0, 48.0);
                let layer = (ground_m / f64::from(CHUNK_CELLS)).floor() as i32;
                let coord = ChunkCoord::new(ChartId::SECOND, IVec3::new(-1, layer, 1));
                let samples = field.samples(coord);
                let found = march(&samples, &field, coord);
                let mut plain = Mesher::default();
                plain.signs.read(&samples);
                let maker = Maker::new(&samples, &field, coord);
                let reach = Reach::new(&field, coord, samples.level());
                plain.make_surface_plain(&maker, &reach, &TURNS[0], samples.level().cells());
                assert!(!found.is_empty() && found.vertices == plain.vertices);
                assert_eq!(found.indices, plain.indices);
            }
        }
    }
}
