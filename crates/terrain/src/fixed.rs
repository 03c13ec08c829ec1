//! Positions in the lattice in fixed point: 8 bits of lattice coordinate, which wrap as the table
//! of hashes does, and 56 of fraction. Sums of them are exact, so a sample is the same bit for bit
//! wherever its column starts, and doubling the frequency is a shift.

use crate::fractal::Column;
use crate::relief::VECTORS;

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

/// Positions of a column's rows along one axis of the first octave: upper and lower halves.
#[derive(Clone, Copy)]
pub(crate) struct Positions {
    /// Lattice coordinate and the upper 24 bits of fraction.
    upper: [[u32; 4]; VECTORS],
    /// The rest of the fraction.
    lower: [[u32; 4]; VECTORS],
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

impl Positions {
    pub(crate) fn new() -> Self {
        Self {
            upper: [[0; 4]; VECTORS],
            lower: [[0; 4]; VECTORS],
        }
    }

    pub(crate) fn set(&mut self, n: usize, position: u64) {
        let (vector, lane) = (n / 4, n % 4);
        self.upper[vector][lane] = (position >> 32) as u32;
        self.lower[vector][lane] = position as u32;
    }

    /// Four positions in a lattice of so many octaves above, in [`PART_BITS`] bits of fraction.
    #[inline]
    pub(crate) fn four(&self, vector: usize, doublings: u32) -> [u32; 4] {
        let (upper, lower) = (self.upper[vector], self.lower[vector]);
        std::array::from_fn(|lane| {
            upper[lane].wrapping_shl(doublings) | (lower[lane] >> 1).wrapping_shr(31 - doublings)
        })
    }

    pub(crate) fn at(&self, n: usize) -> u64 {
        let (vector, lane) = (n / 4, n % 4);
        u64::from(self.upper[vector][lane]) << 32 | u64::from(self.lower[vector][lane])
    }
}

impl Ray {
    /// The samples of a column at heights `first_m + step_m * n`.
    pub(crate) fn new(&Column { base, slope }: &Column, first_m: f64, step_m: f64) -> Self {
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
    pub(crate) fn fill(&self, positions: &mut [Positions; 3]) {
        for (axis, rows) in positions.iter_mut().enumerate() {
            let mut position = self.start[axis];
            let upper = rows.upper.as_flattened_mut().iter_mut();
            for (upper, lower) in upper.zip(rows.lower.as_flattened_mut()) {
                (*upper, *lower) = ((position >> 32) as u32, position as u32);
                position = position.wrapping_add(self.rise[axis]);
            }
        }
    }
}
