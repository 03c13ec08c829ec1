//! Noise along columns that run through the lattice at any slant, as curved spaces have them.
//!
//! Nothing comes apart by axes here, so the eight corners of a sample's cell are worked on as
//! vectors, and cells are put together once for a whole block of columns and looked up after.

use glam::{DVec3, Vec4};

use crate::fixed::{self, FRACTION_BITS, PART_BITS, Positions, Ray, fixed};
use crate::fractal::{Column, Octave};
use crate::lattice::{Cell, Lattice, SCALE, blend, fade, fades};
use crate::relief::{BLOCK, Relief, Rows, VECTORS};

/// Stands for a cell that was not met yet; a block has fewer samples.
const UNKNOWN: u16 = u16::MAX;
/// Most cells that a block of columns may run through. A chunk's run through a tenth of that;
/// the places far from any world where they would be more are not worth the room.
const SLOT_LIMIT: f64 = 131_072.0;
/// Columns of fewer samples than this would leave most of a vector empty.
const SHORT: usize = 3;

/// Cells of one octave that a block of columns meets, put together when first met.
struct Region {
    /// Whole octaves above the first.
    doublings: u32,
    half_m: f32,
    first: [u8; 3],
    strides: [f32; 2],
    slots: Vec<u16>,
    cells: Vec<Cell>,
    /// Room for the places of a column.
    fours: [Four; VECTORS],
}

/// Four samples in the lattice of one octave.
#[derive(Clone, Copy)]
struct Four {
    /// Fractions of the cells, by axis.
    part: [Vec4; 3],
    /// Weights of the upper lattice points.
    fade: [Vec4; 3],
    /// Which of the region's cells each is in.
    slots: [u32; 4],
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
    let ground = (relief, rows);
    if height < SHORT {
        return fill_short(
            lattice,
            &mut regions,
            ground,
            columns,
            (first_m, step_m),
            height,
            out,
        );
    }
    let mut positions = [Positions::new(); 3];
    for (column, out) in columns.iter().zip(out.chunks_exact_mut(height.max(1))) {
        let mut sums = [Vec4::ZERO; VECTORS];
        let mut open = rows.open;
        let mut rest = relief.sum_m();
        Ray::new(column, first_m, step_m).fill(&mut positions);
        for region in &mut regions {
            if open.0 == open.1 {
                break;
            }
            region.add(lattice, &positions, open, &mut sums);
            rest -= region.half_m;
            open = rows.narrow(open, rest, &sums);
        }
        let mut values = rows.edge;
        for vector in rows.open.0..rows.open.1 {
            let found = relief.values(rows.base_m[vector], sums[vector]);
            found.write_to_slice(&mut values[vector * 4..vector * 4 + 4]);
        }
        out.copy_from_slice(&values[..height]);
    }
}

/// [`fill`] of columns that are too short to fill vectors: rows go along the columns then.
fn fill_short(
    lattice: &Lattice,
    regions: &mut [Region],
    (relief, rows): (&Relief, &Rows),
    columns: &[Column],
    (first_m, step_m): (f64, f64),
    height: usize,
    out: &mut [f32],
) {
    let mut positions = [Positions::new(); 3];
    for (columns, out) in columns.chunks(BLOCK).zip(out.chunks_mut(BLOCK * height)) {
        let vectors = columns.len().div_ceil(4);
        for row in 0..height {
            let y = first_m + row as f64 * step_m;
            for n in 0..vectors * 4 {
                let column = &columns[n.min(columns.len() - 1)];
                let start = Ray::new(column, y, 0.0).start;
                for (positions, at) in positions.iter_mut().zip(start) {
                    positions.set(n, at);
                }
            }
            let mut sums = [Vec4::ZERO; VECTORS];
            for region in &mut *regions {
                region.add(lattice, &positions, (0, vectors), &mut sums);
            }
            let base = Vec4::splat(rows.base_m[row / 4][row % 4]);
            for (sum, out) in sums.into_iter().zip(out.chunks_mut(4 * height)) {
                let values = relief.values(base, sum).to_array();
                for (column, value) in out.chunks_exact_mut(height).zip(values) {
                    column[row] = value;
                }
            }
        }
    }
}

/// The sum of the octaves at height `y` of a column: bit for bit what [`fill`] finds there.
pub(crate) fn sum_at(lattice: &Lattice, octaves: &[Octave], column: &Column, y: f64) -> f32 {
    let position = Ray::new(column, y, 0.0).start;
    let mut sum = 0.0;
    for (octave, doublings) in octaves.iter().zip(0..) {
        let at = position.map(|p| (p << doublings) >> (64 - 8 - PART_BITS));
        let [x, y, z] = at.map(|p| fixed::part(p as u32));
        let cell = Cell::new(lattice, at.map(|p| (p >> PART_BITS) as u8));
        let corners = cell.corners(x, y, z, fade(z));
        let noise = blend([corners; 4], Vec4::splat(fade(x)), Vec4::splat(fade(y))).x;
        let half = octave.half_m();
        sum += (noise * (half * SCALE)).clamp(-half, half);
    }
    sum
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
            fours: [Four {
                part: [Vec4::ZERO; 3],
                fade: [Vec4::ZERO; 3],
                slots: [0; 4],
            }; VECTORS],
        })
    }

    /// Adds the octave to the samples of the vectors `from..to`.
    fn add(
        &mut self,
        lattice: &Lattice,
        positions: &[Positions; 3],
        (from, to): (usize, usize),
        sums: &mut [Vec4; VECTORS],
    ) {
        let weight = self.half_m * SCALE;
        let (least, most) = (Vec4::splat(-self.half_m), Vec4::splat(self.half_m));
        // First all places, then all cells: the processor overlaps the vectors better so.
        for (four, vector) in self.fours.iter_mut().zip(from..to) {
            *four = place(self.doublings, self.first, self.strides, positions, vector);
        }
        for (n, (vector, sum)) in (from..to).zip(&mut sums[from..to]).enumerate() {
            let Four { part, fade, slots } = self.fours[n];
            let [x, y, z] = part.map(|v| v.to_array());
            let w = fade[2].to_array();
            let mut corners = [Vec4::ZERO; 4];
            for (lane, corners) in corners.iter_mut().enumerate() {
                let mut cell = self.slots[slots[lane] as usize];
                if cell == UNKNOWN {
                    cell = self.meet(lattice, positions, vector * 4 + lane, slots[lane]);
                }
                let cell = &self.cells[usize::from(cell)];
                *corners = cell.corners(x[lane], y[lane], z[lane], w[lane]);
            }
            let noise = blend(corners, fade[0], fade[1]) * weight;
            *sum += noise.clamp(least, most);
        }
    }

    /// Puts together the cell of a position.
    #[cold]
    fn meet(&mut self, lattice: &Lattice, at: &[Positions; 3], n: usize, slot: u32) -> u16 {
        let low = at
            .each_ref()
            .map(|axis| ((axis.at(n) << self.doublings) >> FRACTION_BITS) as u8);
        let at = self.cells.len() as u16;
        self.cells.push(Cell::new(lattice, low));
        self.slots[slot as usize] = at;
        at
    }
}

/// Where four samples lie in the lattice of an octave.
#[inline(always)]
fn place(
    doublings: u32,
    first: [u8; 3],
    [a, b]: [f32; 2],
    positions: &[Positions; 3],
    vector: usize,
) -> Four {
    /// Adding this to a small whole number leaves it in the low bits.
    const ROUNDS: f32 = 8_388_608.0;
    let (mut part, mut whole) = ([Vec4::ZERO; 3], [Vec4::ZERO; 3]);
    for axis in 0..3 {
        let first = u32::from(first[axis]) << PART_BITS;
        let at = positions[axis].four(vector, doublings);
        let at = at.map(|p| p.wrapping_sub(first));
        whole[axis] = Vec4::from(at.map(|p| (p >> PART_BITS).cast_signed() as f32));
        part[axis] = Vec4::from(at.map(fixed::part));
    }
    let slots = whole[0] * a + whole[1] * b + whole[2] + ROUNDS;
    Four {
        part,
        fade: part.map(fades),
        slots: slots.to_array().map(|slot| slot.to_bits() & 0x7f_ffff),
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
            for (first_m, step_m, height) in [
                (-11.0, 1.0, 35),
                (1.0, 8.0, 3),
                (4.25, 1.0, 1),
                (-2.0, 4.0, 2),
            ] {
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
