//! Where the ground crosses the lattice of one chunk: which edges have a vertex, and which.
//!
//! Signs are kept as bits, a column of samples in one word, so that empty cells cost nothing and
//! a vertex is found by counting the bits before its own: no table of a chunk's edges is needed.

use antipode_geometry::{ChunkCoord, Domain};
use glam::{DVec2, Vec3Swizzles};

use crate::field::{Field, RIM_REACH_M};
use crate::level::Level;
use crate::samples::Samples;

/// The edges of a column's corners that run along x, y and z and have a vertex.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Lines {
    /// By axis, the corners as bits, the lowest first.
    pub masks: [u64; 3],
    /// By axis, the vertex of the lowest.
    pub first: [u32; 3],
}

/// The solid samples of a chunk's corners as bits.
#[derive(Debug, Default)]
pub(crate) struct Signs {
    /// Corners along an edge of the chunk.
    corners: usize,
    /// By `i * corners + k`, corner `j` as bit `j`.
    columns: Vec<u64>,
}

impl Signs {
    /// Takes the signs of a chunk's samples.
    pub(crate) fn read(&mut self, samples: &Samples) {
        let corners = samples.level().cells() + 1;
        self.corners = corners;
        self.columns.clear();
        let rows = samples
            .values()
            .chunks_exact(samples.side() * samples.side());
        for row in rows.skip(1).take(corners) {
            let columns = row.chunks_exact(samples.side()).skip(1).take(corners);
            let bits = columns.map(|column| solid_bits(&column[1..=corners]));
            self.columns.extend(bits);
        }
    }

    /// The column over corner `(i, k)`, each from 0 to the number of cells.
    #[inline]
    pub(crate) fn column(&self, i: usize, k: usize) -> u64 {
        self.columns[i * self.corners + k]
    }

    /// The edges along x, y and z from the corners of column `(i, k)` whose ends differ.
    #[inline]
    pub(crate) fn crossed(&self, i: usize, k: usize) -> [u64; 3] {
        let here = self.column(i, k);
        let all = (1 << self.corners) - 1;
        let beside = |there: usize| {
            self.columns
                .get(there)
                .map_or(0, |&other| (here ^ other) & all)
        };
        let last = self.corners - 1;
        let at = i * self.corners + k;
        [
            if i < last {
                beside(at + self.corners)
            } else {
                0
            },
            (here ^ here >> 1) & (all >> 1),
            if k < last { beside(at + 1) } else { 0 },
        ]
    }

    /// The four columns around the column of cells `(i, k)`, x first.
    #[inline]
    pub(crate) fn around(&self, i: usize, k: usize) -> [u64; 4] {
        [
            self.column(i, k),
            self.column(i + 1, k),
            self.column(i, k + 1),
            self.column(i + 1, k + 1),
        ]
    }

    /// The cells between four columns that are neither all solid nor all air, as bits.
    #[inline]
    pub(crate) fn crossed_cells(&self, columns: [u64; 4]) -> u64 {
        let any = columns.iter().fold(0, |a, &b| a | b);
        let all = columns.iter().fold(u64::MAX, |a, &b| a & b);
        (any | any >> 1) & !(all & all >> 1) & ((1 << (self.corners - 1)) - 1)
    }
}

/// Samples below zero as bits, of at most 64. Four lanes are kept apart up to the end, so that
/// compilers compare four samples at once.
pub(crate) fn solid_bits(values: &[f32]) -> u64 {
    let (fours, rest) = values.as_chunks::<4>();
    let mut bits = 0;
    for (half, fours) in fours.chunks(8).enumerate() {
        let mut lanes = [0_u32; 4];
        for (n, four) in fours.iter().enumerate() {
            for (lane, bits) in lanes.iter_mut().enumerate() {
                let bit = if four[lane] < 0.0 { 1 << lane } else { 0 };
                *bits |= bit << (4 * n);
            }
        }
        let [a, b, c, d] = lanes;
        bits |= u64::from(a | b | c | d) << (32 * half);
    }
    let first = 4 * fours.len();
    for (n, &value) in rest.iter().enumerate() {
        bits |= u64::from(value < 0.0) << (first + n);
    }
    bits
}

/// The case of cell `j` between four columns, which run x first.
#[inline]
pub(crate) fn case(columns: [u64; 4], j: usize) -> usize {
    let pair = |column: usize| (columns[column] >> j & 3) as usize;
    let layer = |side: usize| {
        let (near, far) = (pair(2 * side), pair(2 * side + 1));
        near & 1 | (far & 1) << 1 | (near >> 1) << 2 | (far >> 1) << 3
    };
    layer(0) | layer(1) << 4
}

/// Which columns of a chunk's cells are meshed: those that touch the ground up to [`RIM_REACH_M`] past the domain of
/// their chart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    domain: Domain,
    origin: DVec2,
    step_m: f64,
    cells: usize,
}

impl Reach {
    pub(crate) fn new(field: &Field, coord: ChunkCoord, level: Level) -> Self {
        let origin = coord.origin();
        let domain = field.domain(coord.chart);
        let is_whole = domain.most_outside_m(coord.min().xz(), coord.max().xz()) <= RIM_REACH_M;
        Self {
            // What has every column need not ask for any.
            domain: if is_whole { Domain::Everywhere } else { domain },
            origin: DVec2::new(origin.x, origin.z),
            step_m: f64::from(level.step_m()),
            cells: level.cells(),
        }
    }

    /// Whether the column of cells `(i, k)` is meshed.
    #[inline]
    pub(crate) fn has_cell(&self, i: usize, k: usize) -> bool {
        let low = self.origin + DVec2::new(i as f64, k as f64) * self.step_m;
        self.domain.least_outside_m(low, low + self.step_m) <= RIM_REACH_M
    }

    /// Whether edges along x, y and z from the corners of column `(i, k)` belong to cells that
    /// are meshed.
    #[inline]
    pub(crate) fn has_edges(&self, i: usize, k: usize) -> [bool; 3] {
        if self.domain == Domain::Everywhere {
            return [true; 3];
        }
        let cell = |di: usize, dk: usize| {
            let (Some(i), Some(k)) = (i.checked_sub(di), k.checked_sub(dk)) else {
                return false;
            };
            i < self.cells && k < self.cells && self.has_cell(i, k)
        };
        let (here, left, below) = (cell(0, 0), cell(1, 0), cell(0, 1));
        [
            here || below,
            here || left || below || cell(1, 1),
            here || left,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_the_samples_below_zero() {
        let value = |n: usize| [-1.0, 0.0, 2.0, -0.0, f32::NAN, -1e-30, -3.0][n * n % 7];
        for count in 0..=64 {
            let values: Vec<_> = (0..count).map(value).collect();
            let expected = (0..count).fold(0, |bits, n| bits | u64::from(value(n) < 0.0) << n);
            assert_eq!(solid_bits(&values), expected, "{count}");
        }
    }
}
