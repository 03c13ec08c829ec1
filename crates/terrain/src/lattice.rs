//! The seeded lattice of gradient noise: hashes, gradients, and the noise at one point.
//!
//! Perlin's improved noise with the permutation table, gradients and scale of the `noise`
//! crate, and tested against it.

use glam::{Mat4, Vec4};
use noise::permutationtable::{NoiseHasher, PermutationTable};

use crate::wide::{FIRST_MINUS, FIRST_Y, SECOND_MINUS, SECOND_Y};

/// Brings three-dimensional gradient noise to -1..=1: 2/sqrt(3).
pub(crate) const SCALE: f32 = 1.154_700_5;
/// The sixteen hashes' gradients, filled up to vectors; twelve cube edges, four of them twice.
const GRADIENTS: [[f32; 4]; 16] = [
    [1.0, 1.0, 0.0, 0.0],
    [-1.0, 1.0, 0.0, 0.0],
    [1.0, -1.0, 0.0, 0.0],
    [-1.0, -1.0, 0.0, 0.0],
    [1.0, 0.0, 1.0, 0.0],
    [-1.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, -1.0, 0.0],
    [-1.0, 0.0, -1.0, 0.0],
    [0.0, 1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0, 0.0],
    [0.0, 1.0, -1.0, 0.0],
    [0.0, -1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0, 0.0],
    [-1.0, 1.0, 0.0, 0.0],
    [0.0, -1.0, 1.0, 0.0],
    [0.0, -1.0, -1.0, 0.0],
];

/// The gradients as [`crate::wide`] has them, in four bits.
const CODES: [u8; 16] = {
    let mut codes = [0; 16];
    let mut n = 0;
    while n < 16 {
        let [x, y, z, _] = GRADIENTS[n];
        let (first, second) = (if x == 0.0 { y } else { x }, if z == 0.0 { y } else { z });
        codes[n] |= if first < 0.0 { FIRST_MINUS } else { 0 };
        codes[n] |= if second < 0.0 { SECOND_MINUS } else { 0 };
        codes[n] |= if x == 0.0 { FIRST_Y } else { 0 };
        codes[n] |= if z == 0.0 { SECOND_Y } else { 0 };
        n += 1;
    }
    codes
};

/// Seeded gradients on the whole points of noise space.
pub(crate) struct Lattice {
    table: [u8; 256],
    /// By key, the gradient of its hash as [`crate::wide`] has it.
    codes: [u8; 256],
}

impl std::fmt::Debug for Lattice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lattice").finish_non_exhaustive()
    }
}

/// A lattice cell: the gradients of its corners by axis, first the four corners of lower z, then
/// the four of upper, each `x + 2 y`.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Cell {
    x: [Vec4; 2],
    y: [Vec4; 2],
    z: [Vec4; 2],
}

/// Where a coordinate lies between the lattice's points.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct LatticeCoord {
    /// The lattice coordinate below, modulo the table's 256.
    pub low: u8,
    /// What is left, 0..1.
    pub part: f32,
}

impl LatticeCoord {
    /// Adding 1.5 * 2^52 rounds to a whole number whose low bits are then the sum's: cheaper
    /// than `floor`, which is a call without SSE4.1, and than a saturating cast. Past 2^51 the
    /// rest means nothing, but the noise is clamped.
    #[inline]
    pub(crate) fn new(v: f64) -> Self {
        const ROUNDS: f64 = 6_755_399_441_055_744.0;
        let shifted = v + ROUNDS;
        let nearest = shifted - ROUNDS;
        let above = nearest > v;
        let whole = nearest - f64::from(u8::from(above));
        Self {
            low: (shifted.to_bits() as u8).wrapping_sub(u8::from(above)),
            part: (v - whole) as f32,
        }
    }
}

/// Perlin's quintic `6 t^5 - 15 t^4 + 10 t^3`: how much the upper lattice point weighs. Written
/// about its centre, which loses a tenth of the digits: near one the other form cancels.
#[inline]
pub(crate) fn fade(t: f32) -> f32 {
    let s = t - 0.5;
    let q = s * s;
    s * (q * (q * 6.0 - 5.0) + 1.875) + 0.5
}

/// [`fade`] of four.
#[inline]
pub(crate) fn fades(t: Vec4) -> Vec4 {
    let s = t - 0.5;
    let q = s * s;
    s * (q * (q * 6.0 - 5.0) + 1.875) + 0.5
}

/// All 64 bits of a world's seed stirred into the 32 that the table's generator takes, so that neighbouring seeds have
/// unrelated tables.
pub(crate) fn table_seed(seed: u64) -> u32 {
    (stirred(seed) >> 32) as u32
}

/// A number whose every bit hangs on every bit of another (the finaliser of splitmix64).
pub(crate) fn stirred(seed: u64) -> u64 {
    let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Lattice {
    pub(crate) fn new(seed: u64) -> Self {
        let hasher = PermutationTable::new(table_seed(seed));
        let mut table = [0; 256];
        for (index, entry) in table.iter_mut().enumerate() {
            *entry = hasher.hash(&[index as isize]) as u8;
        }
        let codes = table.map(|hash| CODES[usize::from(hash & 0b1111)]);
        Self { table, codes }
    }

    #[inline]
    fn hash(&self, key: u8) -> u8 {
        self.table[usize::from(key)]
    }

    /// Hashes of the lattice's columns along z at `x` and `x + 1`, both at `y`.
    #[inline]
    pub(crate) fn pair(&self, x: u8, y: u8) -> [u8; 2] {
        [x, x.wrapping_add(1)].map(|x| self.hash(self.hash(x) ^ y))
    }

    #[inline]
    fn entry(&self, column: u8, z: u8) -> [f32; 4] {
        GRADIENTS[usize::from(self.hash(column ^ z) & 0b1111)]
    }

    /// The gradients of so many cells along each axis, from the one whose lowest corner stands at
    /// the lattice coordinates `first`; those beside each other along z follow each other, then
    /// come those along y. Four bits each, the lowest of corner 0: corners `x + 2 y + 4 z`.
    pub(crate) fn codes(&self, first: [u8; 3], [wide, high, deep]: [usize; 3]) -> Vec<u32> {
        let [x, y, z] = first;
        let mut codes = Vec::with_capacity(wide * high * deep);
        for i in 0..wide {
            let x = x.wrapping_add(i as u8);
            for j in 0..high {
                let y = y.wrapping_add(j as u8);
                let ([a, b], [c, d]) = (self.pair(x, y), self.pair(x, y.wrapping_add(1)));
                let side = |k: usize| {
                    let z = z.wrapping_add(k as u8);
                    let code = |column: u8| u32::from(self.codes[usize::from(column ^ z)]);
                    code(a) | code(b) << 4 | code(c) << 8 | code(d) << 12
                };
                let mut low = side(0);
                for k in 1..=deep {
                    let high = side(k);
                    codes.push(low | high << 16);
                    low = high;
                }
            }
        }
        codes
    }

    /// The gradients of the four corners `x + 2 z` of a cell in a lattice plane of constant y, by axis.
    #[inline]
    pub(crate) fn around(&self, x: u8, y: u8, z: u8) -> [Vec4; 3] {
        let [a, b] = self.pair(x, y);
        let [c, d] = [a, b].map(|column| Vec4::from(self.entry(column, z.wrapping_add(1))));
        let [a, b] = [a, b].map(|column| Vec4::from(self.entry(column, z)));
        let by_axis = Mat4::from_cols(a, b, c, d).transpose();
        [by_axis.x_axis, by_axis.y_axis, by_axis.z_axis]
    }

    /// The gradient at `z` in a column of [`Self::pair`].
    #[inline]
    pub(crate) fn gradient(&self, column: u8, z: u8) -> [f32; 3] {
        let [x, y, z, _] = self.entry(column, z);
        [x, y, z]
    }
}

impl Cell {
    /// The cell whose lowest corner stands at these lattice coordinates.
    pub(crate) fn new(lattice: &Lattice, [x, y, z]: [u8; 3]) -> Self {
        let ([a, b], [c, d]) = (lattice.pair(x, y), lattice.pair(x, y.wrapping_add(1)));
        let side = |z: u8| {
            let [a, b, c, d] = [a, b, c, d].map(|column| Vec4::from(lattice.entry(column, z)));
            Mat4::from_cols(a, b, c, d).transpose()
        };
        let (low, high) = (side(z), side(z.wrapping_add(1)));
        Self {
            x: [low.x_axis, high.x_axis],
            y: [low.y_axis, high.y_axis],
            z: [low.z_axis, high.z_axis],
        }
    }

    /// What the corners contribute to the noise at fractions of the cell, already interpolated
    /// over z with the weight `w`: corners `x + 2 y`.
    #[inline]
    pub(crate) fn corners(&self, x: f32, y: f32, z: f32, w: f32) -> Vec4 {
        let across = Vec4::splat(x) - Vec4::new(0.0, 1.0, 0.0, 1.0);
        let along = Vec4::splat(y) - Vec4::new(0.0, 0.0, 1.0, 1.0);
        let deep = [Vec4::splat(z), Vec4::splat(z - 1.0)];
        self.corners_at(across, along, deep, Vec4::splat(w))
    }

    /// [`Self::corners`] at distances from the corners: along x and y for each, along z from the
    /// lower and from the upper. The unit of length is the caller's.
    #[inline]
    pub(crate) fn corners_at(&self, across: Vec4, along: Vec4, deep: [Vec4; 2], w: Vec4) -> Vec4 {
        let [low, high] = [0, 1].map(
            #[inline(always)]
            |n: usize| self.x[n] * across + self.y[n] * along + self.z[n] * deep[n],
        );
        low + w * (high - low)
    }
}

/// Noise, before its scale, of four points from what the [`Cell::corners`] of each contribute
/// and the points' weights over x and y.
#[inline]
pub(crate) fn blend(corners: [Vec4; 4], u: Vec4, v: Vec4) -> Vec4 {
    let [a, b, c, d] = corners;
    let at = Mat4::from_cols(a, b, c, d).transpose();
    let low = at.x_axis + u * (at.y_axis - at.x_axis);
    let high = at.z_axis + u * (at.w_axis - at.z_axis);
    low + v * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splits_numbers_at_the_whole_number_below() {
        for (v, low, part) in [
            (2.25, 2, 0.25),
            (-0.25, 255, 0.75),
            (-3.0, 253, 0.0),
            (0.5, 0, 0.5),
            (1.5, 1, 0.5),
            (-256.5, 255, 0.5),
        ] {
            assert_eq!(LatticeCoord::new(v), LatticeCoord { low, part }, "{v}");
        }
    }

    #[test]
    fn neighbouring_seeds_have_unrelated_tables() {
        let (a, b) = (Lattice::new(1).table, Lattice::new(2).table);
        let same = a.iter().zip(&b).filter(|(a, b)| a == b).count();
        assert!(same < 12, "{same} of 256 entries agree");
    }
}
