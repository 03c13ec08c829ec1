//! Noise along columns that run through the lattice at any slant, as curved spaces have them.
//!
//! Nothing comes apart by axes here, so the eight corners of a sample's cell are worked on as
//! vectors, and cells are put together once for a whole block of columns and looked up after.
//!
//! Positions are fixed-point: 8 bits of lattice coordinate, which wrap as the table of hashes
//! does, and 56 of fraction. Sums of them are exact, so a sample is the same bit for bit wherever
//! its column starts, and doubling the frequency is a shift.

use glam::{DVec3, Vec4};

use crate::fractal::{Column, Octave};
use crate::lattice::{Cell, Lattice, SCALE, blend, fade};
use crate::relief::{BLOCK, Relief, Rows};

/// Bits of a position's fraction.
const FRACTION_BITS: u32 = 56;
/// A fraction keeps this many bits, as many as `f32` holds exactly.
const PART_BITS: u32 = 24;
/// Stands for a cell that was not met yet; a block has fewer samples.
const UNKNOWN: u16 = u16::MAX;
/// Most cells that a block of columns may run through. A chunk's run through a tenth of that;
/// the places far from any world where they would be more are not worth the room.
const SLOT_LIMIT: f64 = 131_072.0;

/// A column through the lattice of the first octave, in fixed point.
#[derive(Debug, Clone, Copy)]
struct Ray {
    start: [u64; 3],
    rise: [u64; 3],
}

/// Cells of one octave that a block of columns meets, put together when first met.
struct Region {
    /// Whole octaves above the first.
    doublings: u32,
    half_m: f32,
    first: [u8; 3],
    strides: [f32; 2],
    slots: Vec<u16>,
    cells: Vec<Cell>,
}

/// Positions of a column's rows along one axis of the first octave: upper and lower halves.
#[derive(Clone, Copy)]
struct Positions {
    upper: [u32; BLOCK],
    lower: [u32; BLOCK],
}

/// Rows of a column in the lattice of one octave: room to work in.
struct Line {
    axes: [Axis; 3],
    /// Which of the region's cells each row is in.
    slot: [u32; BLOCK],
}

/// Rows along one axis of an octave's lattice.
#[derive(Clone, Copy)]
struct Axis {
    /// Whole lattice points above the region's first.
    whole: [f32; BLOCK],
    part: [f32; BLOCK],
    fade: [f32; BLOCK],
}

impl Positions {
    fn new() -> Self {
        Self {
            upper: [0; BLOCK],
            lower: [0; BLOCK],
        }
    }

    fn at(&self, n: usize) -> u64 {
        u64::from(self.upper[n]) << 32 | u64::from(self.lower[n])
    }
}

impl Line {
    fn new() -> Self {
        let axis = Axis {
            whole: [0.0; BLOCK],
            part: [0.0; BLOCK],
            fade: [0.0; BLOCK],
        };
        Self {
            axes: [axis; 3],
            slot: [0; BLOCK],
        }
    }
}

/// Fills columns of `height` samples, at most [`BLOCK`], at `first_m + step_m * n` above each of
/// `columns`, which hold lattice coordinates of the first octave.
pub(crate) fn fill(
    lattice: &Lattice,
    octaves: &[Octave],
    (relief, rows): (&Relief, &Rows),
    columns: &[Column],
    (first_m, step_m, height): (f64, f64, usize),
    out: &mut [f32],
) {
    let Some(mut regions) = regions(octaves, columns, first_m, step_m) else {
        for (column, out) in columns.iter().zip(out.chunks_exact_mut(height.max(1))) {
            for (n, value) in out.iter_mut().enumerate() {
                let y = first_m + n as f64 * step_m;
                *value = relief.value(y, sum_at(lattice, octaves, column, y));
            }
        }
        return;
    };
    let mut line = Line::new();
    let mut positions = [Positions::new(); 3];
    for (column, out) in columns.iter().zip(out.chunks_exact_mut(height.max(1))) {
        let mut sums = [0.0; BLOCK];
        let mut open = rows.open;
        let mut rest = relief.sum_m();
        Ray::new(column, first_m, step_m).fill(&mut positions);
        for region in &mut regions {
            if open.0 == open.1 {
                break;
            }
            let vectors = (open.0 & !3, open.1.next_multiple_of(4));
            region.add(lattice, &positions, vectors, &mut line, &mut sums);
            rest -= region.half_m;
            open = rows.narrow(open, rest, &sums);
        }
        let mut values = rows.edge;
        for first in (rows.open.0 & !3..rows.open.1).step_by(4) {
            let sums = Vec4::from_slice(&sums[first..first + 4]);
            relief
                .values(rows.base_m(first), sums)
                .write_to_slice(&mut values[first..first + 4]);
        }
        out.copy_from_slice(&values[..height]);
    }
}

/// The sum of the octaves at height `y` of a column: bit for bit what [`fill`] finds there.
pub(crate) fn sum_at(lattice: &Lattice, octaves: &[Octave], column: &Column, y: f64) -> f32 {
    let position = Ray::new(column, y, 0.0).start;
    let mut sum = 0.0;
    for (octave, doublings) in octaves.iter().zip(0..) {
        let at = position.map(|p| (p << doublings) >> (64 - 8 - PART_BITS));
        let [x, y, z] = at.map(|p| part(p as u32));
        let cell = Cell::new(lattice, at.map(|p| (p >> PART_BITS) as u8));
        let corners = cell.corners(x, y, z, fade(z));
        let noise = blend([corners; 4], Vec4::splat(fade(x)), Vec4::splat(fade(y))).x;
        let half = octave.half_m();
        sum += (noise * (half * SCALE)).clamp(-half, half);
    }
    sum
}

/// The fraction of a position of [`PART_BITS`] bits of it.
#[inline]
fn part(position: u32) -> f32 {
    const SHARE: f32 = 1.0 / (1_u32 << PART_BITS) as f32;
    (position & ((1 << PART_BITS) - 1)).cast_signed() as f32 * SHARE
}

/// Where the columns of a block run, for each octave.
fn regions(
    octaves: &[Octave],
    columns: &[Column],
    first_m: f64,
    step_m: f64,
) -> Option<Vec<Region>> {
    let last_m = first_m + step_m * (BLOCK - 1) as f64;
    let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for column in columns {
        for y in [first_m, last_m] {
            let end = column.base + column.slope * y;
            (min, max) = (min.min(end), max.max(end));
        }
    }
    let octaves = octaves.iter().zip(0..);
    octaves
        .map(|(&octave, doublings)| Region::new(octave, doublings, min, max))
        .collect()
}

fn fixed(v: f64) -> u64 {
    let turn = v / 256.0;
    ((turn - turn.floor()) * (256.0 * (1_u64 << FRACTION_BITS) as f64)) as u64
}

impl Ray {
    /// The samples of a column at heights `first_m + step_m * n`.
    fn new(&Column { base, slope }: &Column, first_m: f64, step_m: f64) -> Self {
        let rises = slope.to_array().map(fixed);
        let whole = first_m.floor();
        let ahead = (slope * (first_m - whole)).to_array().map(fixed);
        let steps = |n: f64| (n as i64).cast_unsigned();
        let mut start = base.to_array().map(fixed);
        for axis in 0..3 {
            start[axis] = start[axis]
                .wrapping_add(rises[axis].wrapping_mul(steps(whole)))
                .wrapping_add(ahead[axis]);
        }
        Self {
            start,
            rise: rises.map(|rise| rise.wrapping_mul(steps(step_m))),
        }
    }

    /// Where the rows lie.
    fn fill(&self, positions: &mut [Positions; 3]) {
        for (axis, rows) in positions.iter_mut().enumerate() {
            let mut position = self.start[axis];
            for (upper, lower) in rows.upper.iter_mut().zip(&mut rows.lower) {
                (*upper, *lower) = ((position >> 32) as u32, position as u32);
                position = position.wrapping_add(self.rise[axis]);
            }
        }
    }
}

impl Region {
    /// Room for the cells between `min` and `max`, lattice coordinates of the first octave.
    /// `None` where they are too many, or not numbers.
    fn new(octave: Octave, doublings: u32, min: DVec3, max: DVec3) -> Option<Self> {
        let scale = f64::from(1_u32 << doublings);
        let low = (min * scale).floor() - 1.0;
        let size = (max * scale).floor() + 2.0 - low;
        let slots = size.element_product();
        (slots <= SLOT_LIMIT).then(|| Self {
            doublings,
            half_m: octave.half_m(),
            first: low.to_array().map(|v| (fixed(v) >> FRACTION_BITS) as u8),
            strides: [(size.y * size.z) as f32, size.z as f32],
            slots: vec![UNKNOWN; slots as usize],
            cells: Vec::new(),
        })
    }

    /// Works out where the rows `from..to` of a column lie in this octave's lattice.
    fn place(&self, positions: &[Positions; 3], from: usize, to: usize, line: &mut Line) {
        /// Adding this to a small whole number leaves it in the low bits.
        const ROUNDS: f32 = 8_388_608.0;
        let (up, down) = (self.doublings, 31 - self.doublings);
        for ((position, first), axis) in positions.iter().zip(self.first).zip(&mut line.axes) {
            let first = u32::from(first) << PART_BITS;
            let upper = position.upper[from..to].iter();
            let lower = position.lower[from..to].iter();
            let parts = axis.part[from..to].iter_mut();
            let fades = axis.fade[from..to].iter_mut();
            let wholes = axis.whole[from..to].iter_mut();
            for ((((upper, lower), rest), faded), whole) in
                upper.zip(lower).zip(parts).zip(fades).zip(wholes)
            {
                let p = upper.wrapping_shl(up) | (lower >> 1).wrapping_shr(down);
                let p = p.wrapping_sub(first);
                *rest = part(p);
                *faded = fade(*rest);
                *whole = (p >> PART_BITS).cast_signed() as f32;
            }
        }
        let [a, b] = self.strides;
        let [x, y, z] = line.axes.each_ref().map(|axis| &axis.whole);
        for n in from..to {
            let slot = x[n] * a + y[n] * b + z[n];
            line.slot[n] = (slot + ROUNDS).to_bits() & 0x7f_ffff;
        }
    }

    /// Adds the octave to the rows `from..to` of a column, whole vectors of rows.
    fn add(
        &mut self,
        lattice: &Lattice,
        positions: &[Positions; 3],
        (from, to): (usize, usize),
        line: &mut Line,
        sums: &mut [f32; BLOCK],
    ) {
        self.place(positions, from, to, line);
        let weight = self.half_m * SCALE;
        let (least, most) = (Vec4::splat(-self.half_m), Vec4::splat(self.half_m));
        let [x, y, z] = line.axes.each_ref().map(|axis| &axis.part);
        let [u, v, w] = line.axes.each_ref().map(|axis| &axis.fade);
        for first in (from..to).step_by(4) {
            let mut corners = [Vec4::ZERO; 4];
            for (lane, corners) in corners.iter_mut().enumerate() {
                let n = first + lane;
                let mut cell = self.slots[line.slot[n] as usize];
                if cell == UNKNOWN {
                    cell = self.meet(
                        lattice,
                        [0, 1, 2].map(|axis: usize| positions[axis].at(n)),
                        line.slot[n],
                    );
                }
                *corners = self.cells[usize::from(cell)].corners(x[n], y[n], z[n], w[n]);
            }
            let at = |values: &[f32; BLOCK]| Vec4::from_slice(&values[first..first + 4]);
            let noise = blend(corners, at(u), at(v)) * weight;
            let sum = at(sums) + noise.clamp(least, most);
            sum.write_to_slice(&mut sums[first..first + 4]);
        }
    }

    /// Puts together the cell of a position.
    #[cold]
    fn meet(&mut self, lattice: &Lattice, position: [u64; 3], slot: u32) -> u16 {
        let low = position.map(|p| ((p << self.doublings) >> FRACTION_BITS) as u8);
        let at = self.cells.len() as u16;
        self.cells.push(Cell::new(lattice, low));
        self.slots[slot as usize] = at;
        at
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lattice::table_seed;
    use noise::{NoiseFn, Perlin};

    /// Columns through the lattice of the first octave of 0.6 times the axes' frequencies.
    fn columns() -> Vec<Column> {
        let column = |n: i32| {
            let t = f64::from(n);
            let base = DVec3::new(t * 7.3 - 900.0, 31.0 - t * 1.9, t * t * 0.03 - 2000.0);
            let slope = [DVec3::Y, DVec3::new(0.4, -0.7, 0.59)][(n % 2) as usize];
            let octave = Octave {
                frequency: 0.6,
                amplitude_m: 1.0,
            };
            Column {
                base: base * octave.frequencies(),
                slope: slope * octave.frequencies(),
            }
        };
        (0..400).map(column).collect()
    }

    #[test]
    fn agrees_with_the_noise_crate_octave_by_octave() {
        let lattice = Lattice::new(77);
        let perlin = Perlin::new(table_seed(77));
        for doublings in 0..4 {
            // All octaves but one are silent.
            let octaves: Vec<_> = (0..4)
                .map(|n| Octave {
                    frequency: 0.0,
                    amplitude_m: if n == doublings { 2.0 } else { 0.0 },
                })
                .collect();
            for column in columns() {
                for y in -5..30 {
                    let y = f64::from(y);
                    let q = (column.base + column.slope * y) * f64::from(1 << doublings);
                    let expected = perlin.get(q.to_array());
                    let found = f64::from(sum_at(&lattice, &octaves, &column, y));
                    assert!((found - expected).abs() < 2e-6, "{q}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn blocks_of_columns_hold_what_single_samples_do() {
        let lattice = Lattice::new(3);
        let octaves = [8.0, 4.0, 2.0].map(|amplitude_m| Octave {
            frequency: 0.0,
            amplitude_m,
        });
        let relief = Relief::new(7.0, Some((9.0, 5.0)));
        let far = columns();
        let near: Vec<_> = (0..30)
            .map(|n| Column {
                base: DVec3::new(0.02, 0.4, -0.3) * f64::from(n),
                slope: DVec3::new(0.03, 0.05, -0.01),
            })
            .collect();
        for columns in [far, near] {
            for (first_m, step_m, height) in [(-11.0, 1.0, 35), (1.0, 8.0, 3), (4.25, 1.0, 1)] {
                let rows = relief.rows(first_m, step_m, height);
                let mut out = vec![0.0; columns.len() * height];
                let heights = (first_m, step_m, height);
                fill(
                    &lattice,
                    &octaves,
                    (&relief, &rows),
                    &columns,
                    heights,
                    &mut out,
                );
                for (column, found) in columns.iter().zip(out.chunks_exact(height)) {
                    for (n, &found) in found.iter().enumerate() {
                        let y = first_m + n as f64 * step_m;
                        let sum = sum_at(&lattice, &octaves, column, y);
                        assert_eq!(found, relief.value(y, sum), "{column:?} {y}");
                    }
                }
            }
        }
    }
}
