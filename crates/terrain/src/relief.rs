//! Turns sums of noise into the field, and knows where the band makes the rest of a sum needless.

use glam::Vec4;

use crate::field::FIELD_BAND_M;
use crate::form::terrace_wave;

/// Rows of a grid, and samples of a row, that are dealt with at once: a chunk's 35 in whole
/// vectors.
pub(crate) const BLOCK: usize = 36;
/// Vectors of rows.
pub(crate) const VECTORS: usize = BLOCK / 4;
/// How much the squeezed noise of a sphere is steepened: fractal noise rarely comes near its
/// bounds, and would leave most of the allowed heights unused.
const SPHERE_GAIN: f32 = 2.2;
/// Room for the rounding of `f32` sums, metres of field.
const ROUNDING_M: f64 = 1e-3;

/// How the ground rises with the noise: it lies at `middle - sum`, or, where the space bounds
/// it, at `middle - half * squeezed(sum)`.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::struct_field_names, reason = "units stand in names")]
pub(crate) struct Relief {
    /// The least and the greatest sum of noise, metres.
    sums_m: [f32; 2],
    /// What no sum is further from zero than, metres.
    sum_m: f32,
    middle_m: f64,
    /// Half range of bounded ground, metres.
    half_m: Option<f32>,
}

/// The rows of a grid in vectors: their heights, and which sums bring them into the band.
pub(crate) struct Rows {
    /// Heights above the middle of the ground, metres.
    pub base_m: [Vec4; VECTORS],
    /// What terraces add to the sums there, as [`terrace_wave`] says.
    pub waves: [Vec4; VECTORS],
    /// A sum of at least this puts a sample at the upper edge of the band.
    above: [Vec4; VECTORS],
    /// A sum of at most this puts a sample at the lower edge.
    below: [Vec4; VECTORS],
    /// The field in rows that no sum brings into the band; any other number in the rest.
    pub edge: [f32; BLOCK],
    /// First and one past the last of the vectors of rows that some sum may bring into it.
    pub open: [usize; 2],
}

impl Relief {
    /// Ground of sums of noise between these, its lowest at a height, or held to `bounds`: middle and half
    /// range. Metres.
    pub(crate) fn new(
        [least_m, most_m]: [f64; 2],
        lowest_m: f64,
        bounds: Option<(f64, f64)>,
    ) -> Self {
        Self {
            sums_m: [least_m as f32, most_m as f32],
            sum_m: most_m.max(-least_m) as f32,
            middle_m: bounds.map_or(lowest_m + most_m, |(middle, _)| middle),
            half_m: bounds.map(|(_, half)| half as f32),
        }
    }

    /// Lowest and highest height that ground can have, metres.
    pub(crate) fn range_m(&self) -> (f64, f64) {
        let [below, above] = match self.half_m {
            None => [self.sums_m[1], -self.sums_m[0]],
            Some(half) => [half; 2],
        };
        let middle = self.middle_m;
        (middle - f64::from(below), middle + f64::from(above))
    }

    /// Between which heights ground lies whose sums of noise lie between these, metres.
    pub(crate) fn heights_m(&self, [least, most]: [f32; 2]) -> [f64; 2] {
        [self.height_m(most), self.height_m(least)]
    }

    /// The height of ground with this sum of noise, metres.
    pub(crate) fn height_m(&self, sum: f32) -> f64 {
        self.middle_m - f64::from(self.lowered(Vec4::splat(sum)).x)
    }

    /// How many times as steep ground is as its sums of noise are, where it is near the middle of its range.
    pub(crate) fn steepness(&self) -> f64 {
        let gained = |half: f32| f64::from(SPHERE_GAIN) * f64::from(half / self.sum_m);
        self.half_m.map_or(1.0, gained)
    }

    /// How high the ground's range is over that of its sums.
    pub(crate) fn stretch(&self) -> f64 {
        let half = f64::from(self.half_m.unwrap_or(self.sum_m));
        half / f64::from(self.sum_m)
    }

    /// Height of ground whose sum of noise is zero, metres.
    pub(crate) fn middle_m(&self) -> f64 {
        self.middle_m
    }

    /// The least and the greatest sum of noise, metres.
    pub(crate) fn sums_m(&self) -> [f32; 2] {
        self.sums_m
    }

    /// The field at heights above the ground's middle with these sums of noise.
    #[inline]
    pub(crate) fn values(&self, base_m: Vec4, sum: Vec4) -> Vec4 {
        Vec4::from((base_m + self.lowered(sum)).to_array().map(banded))
    }

    /// How far sums of noise lower the ground, metres.
    #[inline]
    fn lowered(&self, sum: Vec4) -> Vec4 {
        let Some(half) = self.half_m else {
            return sum;
        };
        let t = sum * (SPHERE_GAIN / self.sum_m);
        t / (t * t + Vec4::ONE).sqrt() * half
    }

    /// The field at one height with this sum of noise.
    pub(crate) fn value(&self, y: f64, sum: f32) -> f32 {
        let base = (y - self.middle_m) as f32;
        self.values(Vec4::splat(base), Vec4::splat(sum)).x
    }

    /// The sum of noise that lowers the ground so far; infinite where none does.
    fn sum_for(&self, lowered_m: f64) -> f32 {
        let Some(half) = self.half_m else {
            return lowered_m as f32;
        };
        let share = lowered_m / f64::from(half);
        if share.abs() < 1.0 {
            (share / (1.0 - share * share).sqrt()) as f32 * (self.sum_m / SPHERE_GAIN)
        } else {
            f32::INFINITY * share.signum() as f32
        }
    }

    /// Rows at heights `first_m + step_m * n`, `count` of them, at most [`BLOCK`], for all sums there can be.
    pub(crate) fn rows(&self, first_m: f64, step_m: f64, count: usize) -> Rows {
        self.rows_within(self.sums_m, first_m, step_m, count)
    }

    /// [`Self::rows`] for sums from the least to the greatest of these.
    pub(crate) fn rows_within(
        &self,
        [least, most]: [f32; 2],
        first_m: f64,
        step_m: f64,
        count: usize,
    ) -> Rows {
        // Past the last row everything is certain.
        let (mut base_m, mut above, mut below) = ([0.0; BLOCK], [f32::MIN; BLOCK], [0.0; BLOCK]);
        let mut waves = [0.0; BLOCK];
        let band = f64::from(FIELD_BAND_M) + ROUNDING_M;
        for n in 0..count.min(BLOCK) {
            let base = first_m + n as f64 * step_m - self.middle_m;
            base_m[n] = base as f32;
            waves[n] = terrace_wave(first_m + n as f64 * step_m);
            above[n] = self.sum_for(band - base);
            below[n] = self.sum_for(-band - base);
        }
        let vectors = |values: [f32; BLOCK]| {
            std::array::from_fn(|v| Vec4::from_slice(&values[v * 4..v * 4 + 4]))
        };
        let mut rows = Rows {
            base_m: vectors(base_m),
            waves: vectors(waves),
            above: vectors(above),
            below: vectors(below),
            edge: [0.0; BLOCK],
            open: [0, VECTORS],
        };
        let middle = Vec4::splat(f32::midpoint(least, most));
        rows.open = rows.narrow(rows.open, 0.5 * (most - least), &[middle; VECTORS]);
        for (edge, base) in rows.edge.chunks_exact_mut(4).zip(rows.base_m) {
            self.values(base, middle).write_to_slice(edge);
        }
        rows
    }
}

/// What turns sums of noise into values of the field, for the rows of a grid.
#[derive(Clone, Copy)]
pub(crate) struct Ground<'a> {
    pub relief: &'a Relief,
    pub rows: &'a Rows,
}

impl Rows {
    /// Fills columns of `height` samples whose rows are all closed.
    pub(crate) fn fill_closed(&self, height: usize, out: &mut [f32]) {
        for column in out.chunks_exact_mut(height.max(1)) {
            column.copy_from_slice(&self.edge[..height]);
        }
    }

    /// Whether no sums within `rest` of `sum` bring a sample of four rows into the band.
    #[inline]
    pub(crate) fn certain(&self, vector: usize, sum: Vec4, rest: f32) -> bool {
        let above = (sum - rest).cmpge(self.above[vector]);
        let below = (sum + rest).cmple(self.below[vector]);
        (above | below).all()
    }

    /// The vectors `open` without those at the ends whose samples are certain to lie at an edge of
    /// the band while sums change by no more than `rest`: what is left out of their sums does not
    /// change them by a bit.
    #[inline]
    fn narrow(
        &self,
        [mut from, mut to]: [usize; 2],
        rest: f32,
        sums: &[Vec4; VECTORS],
    ) -> [usize; 2] {
        while from < to && self.certain(from, sums[from], rest) {
            from += 1;
        }
        while from < to && self.certain(to - 1, sums[to - 1], rest) {
            to -= 1;
        }
        [from, to]
    }
}

/// A value held to the band. A place that is not a number is solid, not contagious.
#[inline]
#[expect(clippy::manual_clamp, reason = "`clamp` keeps what is not a number")]
fn banded(value: f32) -> f32 {
    value.max(-FIELD_BAND_M).min(FIELD_BAND_M)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_certain_only_where_every_sum_gives_that_very_value() {
        for relief in [
            Relief::new([-18.75, 18.75], 0.0, None),
            Relief::new([-18.75, 18.75], 0.0, Some((10.4, 5.488))),
            Relief::new([-12.75, 12.75], 0.0, Some((83.2, 43.9))),
        ] {
            for first in [-40.0, -3.0, 30.0, 70.0, 120.0] {
                let rows = relief.rows(first, 1.0, 35);
                for row in 0..35 {
                    let (y, vector) = (first + row as f64, row / 4);
                    let inside = (rows.open[0]..rows.open[1]).contains(&vector);
                    for n in 0..=40 {
                        let sum = relief.sum_m * (n as f32 / 20.0 - 1.0);
                        let found = relief.value(y, sum);
                        assert!(inside || found == rows.edge[row], "{y} {sum}: {found}");
                        let certain = rows.certain(vector, Vec4::splat(sum), 0.0);
                        assert!(!certain || found.abs() == FIELD_BAND_M, "{y} {sum}");
                    }
                }
            }
        }
    }

    #[test]
    fn rows_far_from_the_ground_are_all_closed() {
        let relief = Relief::new([-15.0, 15.0], 0.0, Some((10.4, 5.5)));
        for (first, edge) in [(-100.0, -FIELD_BAND_M), (50.0, FIELD_BAND_M)] {
            let rows = relief.rows(first, 1.0, 35);
            assert_eq!(rows.open[0], rows.open[1]);
            assert_eq!(rows.edge[..35], [edge; 35]);
        }
    }

    #[test]
    fn no_number_is_solid() {
        let relief = Relief::new([-15.0, 15.0], 0.0, None);
        assert_eq!(relief.value(f64::NAN, 1.0), -FIELD_BAND_M);
        assert_eq!(relief.rows(f64::NAN, 1.0, 3).open, [0, 1]);
    }
}
