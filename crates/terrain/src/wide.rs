//! The two hot loops of noise at any slant. They are compiled for several widths of vectors, and the processor's
//! features choose among them.
//!
//! Both are written for one sample, and have compilers put 4, 8 or 16 side by side. None contracts
//! or reorders floating-point operations, so every width gives the same bits.
//!
//! Gradients are never looked at as numbers. They point to the middles of a cube's edges, so what
//! one contributes is two of the three distances, each with a sign, added up: four bits say which,
//! and those of a cell's eight corners make one word.

use crate::fixed::PART_BITS;

/// Half a cell, in units of a position's last place.
const HALF: f32 = (1_u32 << (PART_BITS - 1)) as f32;
/// Such a unit in cells.
const UNIT: f32 = 0.5 / HALF;

/// The first distance of two counts with the other sign.
pub(crate) const FIRST_MINUS: u8 = 1;
/// So does the second.
pub(crate) const SECOND_MINUS: u8 = 2;
/// The first is that along y; without, along x.
pub(crate) const FIRST_Y: u8 = 4;
/// The second is that along y; without, along z. Never together with [`FIRST_Y`].
pub(crate) const SECOND_Y: u8 = 8;

/// The cells of an octave that a block of columns may run through.
pub(crate) struct Extent {
    /// Whole octaves above the first, at most 31.
    pub doublings: u32,
    /// The lowest cell, its lattice coordinates above [`PART_BITS`] bits of fraction.
    pub first: [u32; 3],
    /// How far cells beside each other along x and y are apart in the table of cells.
    pub strides: [f32; 2],
}

/// How many samples go side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Width {
    /// As many as in vectors that every processor has.
    Plain,
    /// 8, by AVX2.
    #[cfg(target_arch = "x86_64")]
    Eight,
    /// 16, by AVX-512.
    #[cfg(target_arch = "x86_64")]
    Sixteen,
}

/// Whether the processor has the parts of AVX-512 that [`Width::Sixteen`] is compiled for.
#[cfg(target_arch = "x86_64")]
fn has_sixteen() -> bool {
    std::is_x86_feature_detected!("avx512f")
        && std::is_x86_feature_detected!("avx512vl")
        && std::is_x86_feature_detected!("avx512dq")
        && std::is_x86_feature_detected!("avx512bw")
}

/// Whether the processor has AVX2 and the instructions for single bits that came with it.
#[cfg(target_arch = "x86_64")]
pub(crate) fn has_newer() -> bool {
    let bits = std::is_x86_feature_detected!("bmi1")
        && std::is_x86_feature_detected!("bmi2")
        && std::is_x86_feature_detected!("lzcnt")
        && std::is_x86_feature_detected!("popcnt");
    bits && std::is_x86_feature_detected!("avx2")
}

impl Width {
    /// The widest that this processor has.
    pub(crate) fn widest() -> Self {
        Self::all().last().unwrap_or(Self::Plain)
    }

    /// All that this processor has, the widest last.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        #[cfg(target_arch = "x86_64")]
        let wider = [
            std::is_x86_feature_detected!("avx2").then_some(Self::Eight),
            has_sixteen().then_some(Self::Sixteen),
        ];
        #[cfg(not(target_arch = "x86_64"))]
        let wider: [Option<Self>; 0] = [];
        std::iter::once(Self::Plain).chain(wider.into_iter().flatten())
    }

    /// Where positions in the lattice of the first octave lie in an octave's: by axis the distance
    /// from the middle of the cell, in units of a position's last place, and the cell's place in
    /// the table. All slices have the same length.
    pub(crate) fn place(
        self,
        extent: &Extent,
        positions: [&[u64]; 3],
        middles: [&mut [f32]; 3],
        slots: &mut [u32],
    ) {
        match self {
            Self::Plain => place(extent, positions, middles, slots),
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "calls of functions that not every processor can run"
            )]
            // SAFETY: this width is only made where the processor has been asked for AVX2.
            Self::Eight => unsafe { place_8(extent, positions, middles, slots) },
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "calls of functions that not every processor can run"
            )]
            // SAFETY: this width is only made where the processor has been asked for AVX-512.
            Self::Sixteen => unsafe { place_16(extent, positions, middles, slots) },
        }
    }

    /// Adds the noise of samples in these cells, `weight` times and held to `most` on either side
    /// of zero, to `sums`, and each as many times as its share says. All slices have the same length.
    pub(crate) fn add(
        self,
        codes: &[u32],
        middles: [&[f32]; 3],
        weight: [f32; 2],
        shares: &[f32],
        sums: &mut [f32],
    ) {
        match self {
            Self::Plain => add(codes, middles, weight, shares, sums),
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "calls of functions that not every processor can run"
            )]
            // SAFETY: this width is only made where the processor has been asked for AVX2.
            Self::Eight => unsafe { add_8(codes, middles, weight, shares, sums) },
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "calls of functions that not every processor can run"
            )]
            // SAFETY: this width is only made where the processor has been asked for AVX-512.
            Self::Sixteen => unsafe { add_16(codes, middles, weight, shares, sums) },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn place_8(extent: &Extent, at: [&[u64]; 3], middles: [&mut [f32]; 3], slots: &mut [u32]) {
    place(extent, at, middles, slots);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn place_16(extent: &Extent, at: [&[u64]; 3], middles: [&mut [f32]; 3], slots: &mut [u32]) {
    place(extent, at, middles, slots);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn add_8(codes: &[u32], at: [&[f32]; 3], weight: [f32; 2], shares: &[f32], sums: &mut [f32]) {
    add(codes, at, weight, shares, sums);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn add_16(codes: &[u32], at: [&[f32]; 3], weight: [f32; 2], shares: &[f32], sums: &mut [f32]) {
    add(codes, at, weight, shares, sums);
}

#[inline(always)]
fn place(extent: &Extent, at: [&[u64]; 3], middles: [&mut [f32]; 3], slots: &mut [u32]) {
    /// Adding this to a small whole number leaves it in the low bits.
    const ROUNDS: f32 = 8_388_608.0;
    const PART: u32 = (1 << PART_BITS) - 1;
    let [x, y, z] = middles;
    let count = slots.len();
    let (x, y, z) = (&mut x[..count], &mut y[..count], &mut z[..count]);
    let [at_x, at_y, at_z] = at.map(|axis| &axis[..count]);
    let Extent {
        doublings,
        first,
        strides,
    } = *extent;
    // The octave's frequency doubles positions, and the upper half of them is looked at.
    let shift = 32 - doublings;
    let [first_x, first_y, first_z] = first;
    let split = |at: u64, first: u32| {
        let at = at.wrapping_shr(shift) as u32;
        let cell = (at.wrapping_sub(first) >> PART_BITS).cast_signed() as f32;
        (cell, (at & PART).cast_signed() as f32 - HALF)
    };
    for n in 0..count {
        let (a, b, c);
        (a, x[n]) = split(at_x[n], first_x);
        (b, y[n]) = split(at_y[n], first_y);
        (c, z[n]) = split(at_z[n], first_z);
        slots[n] = (a * strides[0] + b * strides[1] + c + ROUNDS).to_bits() & 0x7f_ffff;
    }
}

#[expect(clippy::inline_always, reason = "compiled for each width")]
#[inline(always)]
fn add(
    codes: &[u32],
    [x, y, z]: [&[f32]; 3],
    [weight, most]: [f32; 2],
    shares: &[f32],
    sums: &mut [f32],
) {
    let count = sums.len();
    let (codes, x, y, z) = (&codes[..count], &x[..count], &y[..count], &z[..count]);
    let shares = &shares[..count];
    let weight = weight * UNIT;
    for n in 0..count {
        let noise = noise(codes[n], [x[n], y[n], z[n]]) * weight;
        let noise = if noise < -most { -most } else { noise };
        sums[n] += shares[n] * if noise > most { most } else { noise };
    }
}

/// Noise, before its scale and in units of a position's last place, at distances from the middle
/// of the cell of this code: bit for bit what [`crate::lattice::Cell`] gives.
#[expect(clippy::inline_always, reason = "compiled for each width")]
#[inline(always)]
fn noise(code: u32, [x, y, z]: [f32; 3]) -> f32 {
    let [u, v, w] = [weight(x), weight(y), weight(z)];
    let [x, y, z] = [
        [x + HALF, x - HALF],
        [y + HALF, y - HALF],
        [z + HALF, z - HALF],
    ];
    let corner = |n: usize| {
        let at = [x[n & 1], y[n >> 1 & 1], z[n >> 2]];
        contribution(code, 4 * n as u32, at)
    };
    let along_z = |n: usize| {
        let (low, high) = (corner(n), corner(n + 4));
        low + w * (high - low)
    };
    let (a, b, c, d) = (along_z(0), along_z(1), along_z(2), along_z(3));
    let (low, high) = (a + u * (b - a), c + u * (d - c));
    low + v * (high - low)
}

/// What the gradient contributes whose four bits are `up` from the code's lowest, at distances
/// from its lattice point.
#[expect(clippy::inline_always, reason = "compiled for each width")]
#[inline(always)]
fn contribution(code: u32, up: u32, [x, y, z]: [f32; 3]) -> f32 {
    // Each bit is brought to the place of a sign, which is the cheapest to decide by.
    let has = |bit: u8| code << (31 - bit.trailing_zeros() - up);
    let minus = |bit: u8| has(bit) & (1 << 31);
    let first = if has(FIRST_Y).cast_signed() < 0 { y } else { x };
    let second = if has(SECOND_Y).cast_signed() < 0 {
        y
    } else {
        z
    };
    f32::from_bits(first.to_bits() ^ minus(FIRST_MINUS))
        + f32::from_bits(second.to_bits() ^ minus(SECOND_MINUS))
}

/// [`crate::lattice::fade`], bit for bit, of a distance from the middle of a cell.
#[inline(always)]
fn weight(s: f32) -> f32 {
    const FIRST: f32 = 1.875 * UNIT;
    const THIRD: f32 = 5.0 * UNIT * UNIT * UNIT;
    const FIFTH: f32 = 6.0 * UNIT * UNIT * UNIT * UNIT * UNIT;
    let q = s * s;
    s * (q * (q * FIFTH - THIRD) + FIRST) + 0.5
}

#[cfg(test)]
mod tests {
    use glam::Vec4;

    use super::*;
    use crate::lattice::{Cell, Lattice, blend, fade};

    /// A number of 32 bits from a counter: the finaliser of MurmurHash3.
    fn scattered(n: u32) -> u32 {
        let n = (n ^ n >> 16).wrapping_mul(0x85eb_ca6b);
        let n = (n ^ n >> 13).wrapping_mul(0xc2b2_ae35);
        n ^ n >> 16
    }

    #[test]
    fn every_width_finds_what_the_gradients_of_the_cell_give_bit_for_bit() {
        let lattice = Lattice::new(8);
        let (weight, most) = (1.25, 0.8);
        for width in Width::all() {
            for count in [0, 1, 15, 16, 144] {
                let cell = |n: usize| scattered(n as u32).to_le_bytes();
                let part =
                    |n: usize, axis: u32| scattered(n as u32 ^ axis << 20) >> (32 - PART_BITS);
                let cells = (0..count).map(|n| [0, 1, 2].map(|axis| cell(n)[axis]));
                let codes: Vec<_> = cells
                    .clone()
                    .map(|low| lattice.codes(low, [1; 3])[0])
                    .collect();
                let middles = [0, 1, 2].map(|axis| {
                    let middles = (0..count).map(|n| part(n, axis) as f32 - HALF);
                    middles.collect::<Vec<_>>()
                });
                let mut sums = vec![3.0; count];
                let shares: Vec<_> = (0..count).map(|n| 0.5 + n as f32).collect();
                let slices = middles.each_ref().map(|axis| &axis[..]);
                width.add(&codes, slices, [weight, most], &shares, &mut sums);
                for (n, low) in cells.enumerate() {
                    let [x, y, z] = [0, 1, 2].map(|axis| part(n, axis) as f32 * UNIT);
                    let corners = Cell::new(&lattice, low).corners(x, y, z, fade(z));
                    let noise = blend([corners; 4], Vec4::splat(fade(x)), Vec4::splat(fade(y))).x;
                    let expected = 3.0 + shares[n] * (noise * weight).clamp(-most, most);
                    assert_eq!(sums[n], expected, "{width:?} {n} of {count}");
                }
            }
        }
    }

    #[test]
    fn every_width_finds_the_same_cells_and_the_same_places_in_them() {
        let extent = Extent {
            doublings: 3,
            first: [250 << PART_BITS, 3 << PART_BITS, 0],
            strides: [35.0, 5.0],
        };
        // Five cells along each axis, over the end of the lattice's 256 along the first.
        let cell = |n: usize, axis: u32| scattered(n as u32 ^ axis << 20) % 5;
        let part = |n: usize, axis: u32| scattered(n as u32 ^ axis << 24) >> (32 - PART_BITS);
        let at = [0, 1, 2].map(|axis| {
            let low = |n| extent.first[axis as usize].wrapping_add(cell(n, axis) << PART_BITS);
            let at = (0..100).map(|n| u64::from(low(n) | part(n, axis)) << 32 >> extent.doublings);
            at.collect::<Vec<_>>()
        });
        for width in Width::all() {
            let mut middles = [(); 3].map(|()| vec![0.0; 100]);
            let mut slots = vec![0; 100];
            let places = middles.each_mut().map(|axis| &mut axis[..]);
            width.place(
                &extent,
                at.each_ref().map(|axis| &axis[..]),
                places,
                &mut slots,
            );
            for n in 0..100 {
                let slot = 35 * cell(n, 0) + 5 * cell(n, 1) + cell(n, 2);
                assert_eq!(slots[n], slot, "{width:?} {n}");
                for axis in 0..3 {
                    let expected = part(n, axis) as f32 - HALF;
                    assert_eq!(middles[axis as usize][n], expected, "{width:?} {n}");
                }
            }
        }
    }

    #[test]
    fn weights_are_those_of_the_parts_bit_for_bit() {
        for part in (0..1_u32 << PART_BITS)
            .step_by(997)
            .chain([1, (1 << PART_BITS) - 1])
        {
            let found = weight(part as f32 - HALF);
            assert_eq!(found, fade(part as f32 * UNIT), "{part}");
        }
    }
}
