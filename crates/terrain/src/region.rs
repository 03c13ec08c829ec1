//! What an octave adds to samples anywhere: what its cells are like is looked up once for a whole
//! block of columns.
//!
//! Nothing comes apart by axes here, so every sample is worked on by itself, many side by side.
//! The work is cut into three: where samples lie, which cells those are, and what noise they have
//! there. The first and the last are plain loops over numbers that lie one after the other, which
//! compilers turn into the widest instructions of the processor ([`crate::wide`]).

use glam::{DVec3, Vec4};

use crate::fixed::{FRACTION_BITS, PART_BITS, fixed};
use crate::fractal::Octave;
use crate::lattice::{Lattice, SCALE};
use crate::wide::{Extent, Width};

/// Fours of a batch: their places stay in the nearest cache.
pub(crate) const LIMIT: usize = 72;
/// Samples of a batch, whole vectors of the widest instructions.
const ROOM: usize = 4 * LIMIT;
/// Samples beside each other in the widest instructions.
const WIDEST: usize = 16;
const _: () = assert!(ROOM.is_multiple_of(WIDEST));
/// Most cells that a block of columns may run through. A chunk's run through a tenth of that;
/// the places far from any world where they would be more are not worth the room.
const SLOT_LIMIT: f64 = 131_072.0;

/// A number for each sample of a batch, where vectors of any width lie within one line of the cache.
#[repr(align(64))]
struct Lane<T>([T; ROOM]);

/// Samples by fours that octaves are added to one after the other.
pub(crate) struct Batch {
    width: Width,
    /// In the lattice of the first octave, by axis; those of the open fours.
    positions: [Box<Lane<u64>>; 3],
    /// Of the open fours.
    sums: Box<Lane<f32>>,
    /// Of all fours, once they are no longer of interest.
    settled: Vec<Vec4>,
    /// Row of each four in its column.
    rows: [u8; LIMIT],
    /// The fours whose sums are still of interest.
    open: Vec<u8>,
    /// What the octave that is added is multiplied by.
    shares: Box<Lane<f32>>,
    slots: Box<Lane<u32>>,
    codes: Box<Lane<u32>>,
    middles: [Box<Lane<f32>>; 3],
}

/// The cells of one octave that a block of columns may run through.
pub(crate) struct Region {
    extent: Extent,
    half_m: f32,
    /// What [`Lattice::code`] gives for each.
    codes: Vec<u32>,
}

impl<T: Copy + Default> Lane<T> {
    fn new() -> Self {
        Self([T::default(); ROOM])
    }
}

impl Batch {
    /// For columns of so many fours, at least one.
    pub(crate) fn new(rows: usize) -> Self {
        Self {
            width: Width::widest(),
            positions: std::array::from_fn(|_| Box::new(Lane::new())),
            sums: Box::new(Lane::new()),
            settled: Vec::with_capacity(LIMIT),
            rows: std::array::from_fn(|n| (n % rows.max(1)) as u8),
            open: Vec::with_capacity(LIMIT),
            shares: Box::new(Lane::new()),
            slots: Box::new(Lane::new()),
            codes: Box::new(Lane::new()),
            middles: std::array::from_fn(|_| Box::new(Lane::new())),
        }
    }

    /// So many fours, at most [`LIMIT`], with what their sums begin with; their positions by axis are
    /// to be filled in.
    pub(crate) fn restart(
        &mut self,
        count: usize,
        start: impl Fn(usize) -> Vec4,
    ) -> [&mut [u64]; 3] {
        for (n, sums) in self.sums.0[..4 * count].chunks_exact_mut(4).enumerate() {
            start(n).write_to_slice(sums);
        }
        self.settled.clear();
        self.settled.resize(count, Vec4::ZERO);
        self.open.clear();
        self.open.extend(0..count as u8);
        self.positions
            .each_mut()
            .map(|axis| &mut axis.0[..4 * count])
    }

    /// Leaves the sums of all fours as they are for which this, told row and sum, is false.
    pub(crate) fn retain(&mut self, of_interest: impl Fn(usize, Vec4) -> bool) {
        let mut kept = 0;
        let sums = self.sums.0.as_chunks_mut::<4>().0;
        let mut positions = self
            .positions
            .each_mut()
            .map(|axis| axis.0.as_chunks_mut::<4>().0);
        for n in 0..self.open.len() {
            let four = self.open[n];
            let sum = Vec4::from(sums[n]);
            self.settled[usize::from(four)] = sum;
            let row = self.rows[usize::from(four)];
            // Without a branch, which would be foreseen badly.
            self.open[kept] = four;
            sums[kept] = sums[n];
            for axis in &mut positions {
                axis[kept] = axis[n];
            }
            kept += usize::from(of_interest(usize::from(row), sum));
        }
        self.open.truncate(kept);
    }

    /// The sums of all fours, when nothing more is to be added.
    pub(crate) fn finish(&mut self) -> &[Vec4] {
        let sums = self.sums.0.as_chunks::<4>().0;
        for (&four, &sum) in self.open.iter().zip(sums) {
            self.settled[usize::from(four)] = sum.into();
        }
        &self.settled
    }
}

impl Region {
    /// Room for the cells between `min` and `max`, lattice coordinates of the first octave.
    /// `None` where they are too many, or not numbers.
    pub(crate) fn new(
        lattice: &Lattice,
        octave: Octave,
        doublings: u32,
        min: DVec3,
        max: DVec3,
    ) -> Option<Self> {
        let scale = f64::from(1_u32 << doublings);
        let low = (min * scale).floor() - 1.0;
        let size = (max * scale).floor() + 2.0 - low;
        let cells = size.element_product();
        if cells > SLOT_LIMIT || cells.is_nan() {
            return None;
        }
        let first = low.to_array().map(|v| (fixed(v) >> FRACTION_BITS) as u8);
        Some(Self {
            extent: Extent {
                doublings,
                first: first.map(|low| u32::from(low) << PART_BITS),
                strides: [(size.y * size.z) as f32, size.z as f32],
            },
            half_m: octave.half_m(),
            codes: lattice.codes(first, size.to_array().map(|cells| cells as usize)),
        })
    }

    /// The octave's noise is held to this on either side of zero, metres.
    pub(crate) fn half_m(&self) -> f32 {
        self.half_m
    }

    /// Adds the octave to the open fours of a batch, so many times of each.
    pub(crate) fn add(&self, batch: &mut Batch, share: impl Fn(usize) -> Vec4) {
        let count = 4 * batch.open.len();
        // What lies past the last sample is worked on too, and never looked at.
        let room = count.next_multiple_of(WIDEST);
        let lanes = batch.shares.0.chunks_exact_mut(4);
        for (&four, lane) in batch.open.iter().zip(lanes) {
            share(usize::from(four)).write_to_slice(lane);
        }
        let positions = batch.positions.each_ref().map(|axis| &axis.0[..room]);
        let middles = batch.middles.each_mut().map(|axis| &mut axis.0[..room]);
        let slots = &mut batch.slots.0[..room];
        batch.width.place(&self.extent, positions, middles, slots);
        let (slots, codes) = (&batch.slots.0[..count], &mut batch.codes.0[..count]);
        for (code, &slot) in codes.iter_mut().zip(slots) {
            *code = self.codes[slot as usize];
        }
        let middles = batch.middles.each_ref().map(|axis| &axis.0[..room]);
        let (codes, shares) = (&batch.codes.0[..room], &batch.shares.0[..room]);
        let (sums, weight) = (
            &mut batch.sums.0[..room],
            [self.half_m * SCALE, self.half_m],
        );
        batch.width.add(codes, middles, weight, shares, sums);
    }
}

#[cfg(test)]
#[expect(clippy::expect_used, reason = "tests fail by panicking")]
mod tests {
    use super::*;

    #[test]
    fn sums_of_no_interest_stay_as_they_are() {
        let lattice = Lattice::new(5);
        let octave = Octave {
            frequency: 0.0,
            amplitude_m: 2.0,
        };
        let region =
            Region::new(&lattice, octave, 0, DVec3::ZERO, DVec3::splat(9.0)).expect("few cells");
        let mut batch = Batch::new(3);
        for (axis, shift) in batch
            .restart(6, |_| Vec4::ZERO)
            .into_iter()
            .zip([54, 55, 53])
        {
            for (n, four) in (1_u64..).zip(axis.chunks_exact_mut(4)) {
                four.fill(n << shift);
            }
        }
        region.add(&mut batch, |_| Vec4::ONE);
        let once = batch.finish().to_vec();
        batch.retain(|row, sum| row != 1 && sum == once[row]);
        region.add(&mut batch, |_| Vec4::ONE);
        for (n, (&before, &after)) in once.iter().zip(batch.finish()).enumerate() {
            let added = if [0, 2].contains(&n) {
                before
            } else {
                Vec4::ZERO
            };
            assert!(
                before.x != 0.0 && after == before + added,
                "{n}: {before} {after}"
            );
        }
    }
}
