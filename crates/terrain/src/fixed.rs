//! Positions in the lattice in fixed point: 8 bits of lattice coordinate, which wrap as the table
//! of hashes does, and 56 of fraction. Sums of them are exact, so a sample is the same bit for bit
//! wherever its column starts, and doubling the frequency is a shift.

use crate::fractal::Column;

/// Bits of a position's fraction.
pub(crate) const FRACTION_BITS: u32 = 56;
/// A fraction keeps this many bits, as many as `f32` holds exactly.
pub(crate) const PART_BITS: u32 = 24;

/// A column through the lattice of the first octave, in fixed point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    /// The first row, by axis.
    pub start: [u64; 3],
    rise: [u64; 3],
}

/// A lattice coordinate in fixed point, less whole turns of the table.
pub(crate) fn fixed(v: f64) -> u64 {
    /// Adding 1.5 * 2^52 rounds to a whole number.
    const ROUNDS: f64 = 6_755_399_441_055_744.0;
    const TURN: f64 = (1_u64 << FRACTION_BITS) as f64 * 256.0;
    let turns = v / 256.0;
    let rest = turns - ((turns + ROUNDS) - ROUNDS);
    ((rest * TURN) as i64).cast_unsigned()
}

/// The fraction of a position of [`PART_BITS`] bits of it.
#[inline]
pub(crate) fn part(position: u32) -> f32 {
    const SHARE: f32 = 1.0 / (1_u32 << PART_BITS) as f32;
    (position & ((1 << PART_BITS) - 1)).cast_signed() as f32 * SHARE
}

impl Ray {
    /// The samples of a column at heights `first_m + step_m * n`.
    pub(crate) fn new(&Column { base, slope, .. }: &Column, first_m: f64, step_m: f64) -> Self {
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

    /// The rows, whole fours of them, but for the first `skipped` fours: by axis.
    pub(crate) fn fill(&self, skipped: usize, axes: [&mut [u64]; 3]) {
        for ((out, &start), &rise) in axes.into_iter().zip(&self.start).zip(&self.rise) {
            let ahead = |start: u64, rows: u64| start.wrapping_add(rise.wrapping_mul(rows));
            let first = ahead(start, 4 * skipped as u64);
            let mut rows = [0, 1, 2, 3].map(|row| ahead(first, row));
            let four_rows = rise.wrapping_mul(4);
            for four in out.as_chunks_mut::<4>().0 {
                *four = rows;
                rows = rows.map(|row| row.wrapping_add(four_rows));
            }
        }
    }
}
