//! What an octave adds to samples anywhere: its cells are put together once for a whole block of
//! columns and looked up after.
//!
//! Nothing comes apart by axes here, so the eight corners of a sample's cell are worked on as
//! vectors. The work is cut into loops of short chains of operations over many vectors: a
//! processor keeps its units busy with those, and waits in long chains for one result after the
//! other.

use glam::{DVec3, Vec4, Vec4Swizzles};

use crate::fixed::{FRACTION_BITS, PART_BITS, Positions, fixed};
use crate::fractal::Octave;
use crate::lattice::{Cell, Lattice, SCALE, blend};

/// Vectors of a batch: their places stay in the nearest cache.
pub(crate) const LIMIT: usize = 72;
/// Stands for a cell that was not met yet; a block has fewer samples.
const UNKNOWN: u16 = u16::MAX;
/// Most cells that a block of columns may run through. A chunk's run through a tenth of that;
/// the places far from any world where they would be more are not worth the room.
const SLOT_LIMIT: f64 = 131_072.0;
/// Half a cell, in units of a position's last place.
const HALF: f32 = (1_u32 << (PART_BITS - 1)) as f32;
/// Such a unit in cells.
const UNIT: f32 = 0.5 / HALF;

/// Samples by fours that octaves are added to one after the other.
pub(crate) struct Batch {
    pub positions: Vec<Positions>,
    pub sums: Vec<Vec4>,
    /// Row of each four in its column.
    rows: [u8; LIMIT],
    /// The fours whose sums are still of interest.
    open: Vec<u8>,
    fours: Vec<Four>,
}

/// Cells of one octave that a block of columns meets, put together when first met.
pub(crate) struct Region {
    /// Whole octaves above the first.
    doublings: u32,
    half_m: f32,
    first: [u8; 3],
    strides: [f32; 2],
    slots: Vec<u16>,
    cells: Vec<Cell>,
}

/// Four samples in the lattice of one octave. Lengths are in units of a position's last place:
/// powers of two of cells, so that everything rounds as it does in cells.
#[derive(Clone, Copy, Default)]
struct Four {
    /// Which of the region's slots each is in, then which of its cells.
    cells: [u32; 4],
    /// Distances from the middle of the cell by axis, then weights of the upper lattice points.
    fade: [Vec4; 3],
    /// Distances along x from the lower and the upper lattice points in turn: of two samples, and
    /// of the other two.
    x: [Vec4; 2],
    /// The same along y.
    y: [Vec4; 2],
    /// Distances along z from the lower and from the upper lattice points.
    z: [Vec4; 2],
    /// What [`Cell::corners_at`] gives for each.
    corners: [Vec4; 4],
}

impl Batch {
    /// For columns of so many fours, at least one.
    pub(crate) fn new(rows: usize) -> Self {
        Self {
            positions: Vec::with_capacity(LIMIT),
            sums: Vec::with_capacity(LIMIT),
            rows: std::array::from_fn(|n| (n % rows.max(1)) as u8),
            open: Vec::with_capacity(LIMIT),
            fours: vec![Four::default(); LIMIT],
        }
    }

    /// So many fours, at most [`LIMIT`], whose sums are nothing yet.
    pub(crate) fn restart(&mut self, count: usize) {
        self.positions.resize(count, Positions::default());
        self.sums.clear();
        self.sums.resize(count, Vec4::ZERO);
        self.open.clear();
        self.open.extend(0..count as u8);
    }

    /// Leaves the sums of all fours as they are for which this, told row and sum, is false.
    pub(crate) fn retain(&mut self, of_interest: impl Fn(usize, Vec4) -> bool) {
        let mut kept = 0;
        for n in 0..self.open.len() {
            let four = self.open[n];
            let (row, sum) = (self.rows[usize::from(four)], self.sums[usize::from(four)]);
            // Without a branch, which would be foreseen badly.
            self.open[kept] = four;
            kept += usize::from(of_interest(usize::from(row), sum));
        }
        self.open.truncate(kept);
    }
}

impl Region {
    /// Room for the cells between `min` and `max`, lattice coordinates of the first octave.
    /// `None` where they are too many, or not numbers.
    pub(crate) fn new(octave: Octave, doublings: u32, min: DVec3, max: DVec3) -> Option<Self> {
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

    /// The octave's noise is held to this on either side of zero, metres.
    pub(crate) fn half_m(&self) -> f32 {
        self.half_m
    }

    /// Adds the octave to the open fours of a batch.
    pub(crate) fn add(&mut self, lattice: &Lattice, batch: &mut Batch) {
        // Vectors are shifted by a constant at half the cost.
        match self.doublings {
            0 => self.place(batch, |at| at),
            1 => self.place(batch, |at| at << 1),
            2 => self.place(batch, |at| at << 2),
            3 => self.place(batch, |at| at << 3),
            doublings => self.place(batch, |at| at.wrapping_shl(doublings)),
        }
        self.look_up(lattice, batch);
        let fours = &mut batch.fours[..batch.open.len()];
        for four in fours.iter_mut() {
            four.spread();
        }
        for four in fours.iter_mut() {
            four.meet(&self.cells);
        }
        let weight = self.half_m * SCALE * UNIT;
        let (least, most) = (Vec4::splat(-self.half_m), Vec4::splat(self.half_m));
        for (four, &n) in fours.iter().zip(&batch.open) {
            let noise = blend(four.corners, four.fade[0], four.fade[1]) * weight;
            batch.sums[usize::from(n)] += noise.clamp(least, most);
        }
    }

    /// Finds where the open fours lie; positions in the octave's lattice are `finer` than in the
    /// first's.
    #[expect(
        clippy::inline_always,
        reason = "only among its callers' constants it is shifts by those"
    )]
    #[inline(always)]
    fn place(&self, batch: &mut Batch, finer: impl Fn(u64) -> u64 + Copy) {
        let Batch {
            positions,
            open,
            fours,
            ..
        } = batch;
        let first = self.first.map(|first| u32::from(first) << PART_BITS);
        for (four, &n) in fours.iter_mut().zip(&*open) {
            four.place(&positions[usize::from(n)], finer, first, self.strides);
        }
    }

    /// Finds the cells of the open fours.
    fn look_up(&mut self, lattice: &Lattice, batch: &mut Batch) {
        for (four, &n) in batch.fours.iter_mut().zip(&batch.open) {
            let at = &batch.positions[usize::from(n)];
            let [a, b, c, d] = four.cells;
            four.cells = [
                self.cell(lattice, at, 0, a),
                self.cell(lattice, at, 1, b),
                self.cell(lattice, at, 2, c),
                self.cell(lattice, at, 3, d),
            ];
        }
    }

    /// The cell of a slot, in which a lane's position is.
    #[inline]
    fn cell(&mut self, lattice: &Lattice, at: &Positions, lane: usize, slot: u32) -> u32 {
        let mut cell = self.slots[slot as usize];
        if cell == UNKNOWN {
            cell = self.put_together(lattice, at, lane, slot);
        }
        u32::from(cell)
    }

    /// Makes the cell of a position.
    #[cold]
    fn put_together(&mut self, lattice: &Lattice, at: &Positions, lane: usize, slot: u32) -> u16 {
        let low = at.map(|axis| (axis[lane].wrapping_shl(self.doublings) >> FRACTION_BITS) as u8);
        let cell = self.cells.len() as u16;
        self.cells.push(Cell::new(lattice, low));
        self.slots[slot as usize] = cell;
        cell
    }
}

impl Four {
    /// Slots, and distances from the middle, of positions that are made `finer`. The region
    /// begins at `first`, and its slots are so far apart along x and y.
    #[inline(always)]
    fn place(
        &mut self,
        at: &Positions,
        finer: impl Fn(u64) -> u64,
        first: [u32; 3],
        [a, b]: [f32; 2],
    ) {
        /// Adding this to a small whole number leaves it in the low bits.
        const ROUNDS: f32 = 8_388_608.0;
        const MIDDLE: i32 = 1 << (PART_BITS - 1);
        let mut whole = [Vec4::ZERO; 3];
        for axis in 0..3 {
            let at = at[axis].map(
                #[inline(always)]
                |at| (finer(at) >> 32) as u32,
            );
            let cell = at.map(|at| at.wrapping_sub(first[axis]) >> PART_BITS);
            whole[axis] = Vec4::from(cell.map(|cell| cell.cast_signed() as f32));
            let part = at.map(|at| (at & ((1 << PART_BITS) - 1)).cast_signed());
            self.fade[axis] = Vec4::from(part.map(|part| part.wrapping_sub(MIDDLE) as f32));
        }
        let slots = whole[0] * a + whole[1] * b + whole[2] + ROUNDS;
        self.cells = slots.to_array().map(|slot| slot.to_bits() & 0x7f_ffff);
    }

    /// Distances from the lattice points and weights.
    #[inline]
    fn spread(&mut self) {
        let in_turn =
            |[a, b]: [Vec4; 2]| [Vec4::new(a.x, b.x, a.y, b.y), Vec4::new(a.z, b.z, a.w, b.w)];
        let [x, y, z] = self.fade.map(|middle| [middle + HALF, middle - HALF]);
        (self.x, self.y, self.z) = (in_turn(x), in_turn(y), z);
        self.fade = self.fade.map(fades);
    }

    /// What the corners of each sample's cell contribute.
    #[inline]
    fn meet(&mut self, cells: &[Cell]) {
        let [a, b, c, d] = self.cells.map(|cell| &cells[cell as usize]);
        let ([x, u], [y, v], [z, over], w) = (self.x, self.y, self.z, self.fade[2]);
        self.corners = [
            a.corners_at(x.xyxy(), y.xxyy(), [z.xxxx(), over.xxxx()], w.xxxx()),
            b.corners_at(x.zwzw(), y.zzww(), [z.yyyy(), over.yyyy()], w.yyyy()),
            c.corners_at(u.xyxy(), v.xxyy(), [z.zzzz(), over.zzzz()], w.zzzz()),
            d.corners_at(u.zwzw(), v.zzww(), [z.wwww(), over.wwww()], w.wwww()),
        ];
    }
}

/// [`crate::lattice::fade`], bit for bit, of distances from the middle of a cell.
#[inline(always)]
fn fades(s: Vec4) -> Vec4 {
    const FIRST: f32 = 1.875 * UNIT;
    const THIRD: f32 = 5.0 * UNIT * UNIT * UNIT;
    const FIFTH: f32 = 6.0 * UNIT * UNIT * UNIT * UNIT * UNIT;
    let q = s * s;
    s * (q * (q * FIFTH - THIRD) + FIRST) + 0.5
}

#[cfg(test)]
#[expect(clippy::expect_used, reason = "tests fail by panicking")]
mod tests {
    use super::*;
    use crate::lattice::fade;

    #[test]
    fn weights_are_those_of_the_parts_bit_for_bit() {
        for part in (0..1_u32 << PART_BITS)
            .step_by(997)
            .chain([1, (1 << PART_BITS) - 1])
        {
            let found = fades(Vec4::splat(part as f32 - HALF)).x;
            assert_eq!(found, fade(part as f32 * UNIT), "{part}");
        }
    }

    #[test]
    fn sums_of_no_interest_stay_as_they_are() {
        let lattice = Lattice::new(5);
        let octave = Octave {
            frequency: 0.0,
            amplitude_m: 2.0,
        };
        let mut region = Region::new(octave, 0, DVec3::ZERO, DVec3::splat(9.0)).expect("few cells");
        let mut batch = Batch::new(3);
        batch.restart(6);
        for (n, four) in (1_u64..).zip(&mut batch.positions) {
            *four = [[n << 54; 4], [n << 55; 4], [n << 53; 4]];
        }
        region.add(&lattice, &mut batch);
        let once = batch.sums.clone();
        batch.retain(|row, sum| row != 1 && sum == once[row]);
        region.add(&lattice, &mut batch);
        for (n, (&before, &after)) in once.iter().zip(&batch.sums).enumerate() {
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
