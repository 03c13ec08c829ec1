//! The block of field samples that one chunk is meshed from.

use glam::DVec3;

/// Samples along an edge of a chunk's block: 33 corners of its 32 cells and one sample of
/// border on each side, which central differences need.
pub const SAMPLES: usize = 35;

/// Field samples of one chunk: sample `(i, j, k)`, each in `0..35`, stands at the chunk's
/// origin plus `(i - 1, j - 1, k - 1)` metres. Below zero is solid.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    values: Box<[f32]>,
    editable_y_m: (f64, f64),
}

/// Index of sample `(i, j, k)`: columns are contiguous, since the field is filled by columns.
pub(crate) const fn index(i: usize, j: usize, k: usize) -> usize {
    (i * SAMPLES + k) * SAMPLES + j
}

impl Samples {
    /// Samples of any function of the position relative to the chunk's origin, metres.
    pub fn from_fn(density: impl Fn(DVec3) -> f32) -> Self {
        let mut samples = Self::empty((f64::NEG_INFINITY, f64::INFINITY));
        for i in 0..SAMPLES {
            for k in 0..SAMPLES {
                for j in 0..SAMPLES {
                    let local = DVec3::new(i as f64, j as f64, k as f64) - 1.0;
                    samples.values[index(i, j, k)] = density(local);
                }
            }
        }
        samples
    }

    pub(crate) fn empty(editable_y_m: (f64, f64)) -> Self {
        Self {
            values: vec![0.0; SAMPLES * SAMPLES * SAMPLES].into_boxed_slice(),
            editable_y_m,
        }
    }

    /// Sample `(i, j, k)`, each in `0..35`; indices past the block read its last sample.
    #[inline]
    pub fn get(&self, i: usize, j: usize, k: usize) -> f32 {
        const LAST: usize = SAMPLES - 1;
        self.values[index(i.min(LAST), j.min(LAST), k.min(LAST))]
    }

    /// All samples, columns along y contiguous: `(i * 35 + k) * 35 + j`.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    pub(crate) fn values_mut(&mut self) -> &mut [f32] {
        &mut self.values
    }

    /// Samples of the column `(i, k)`, upward.
    pub(crate) fn column_mut(&mut self, i: usize, k: usize) -> &mut [f32] {
        let first = index(i, 0, k);
        &mut self.values[first..first + SAMPLES]
    }

    /// Lowest and highest height, metres, at which edits count.
    pub(crate) fn editable_y_m(&self) -> (f64, f64) {
        self.editable_y_m
    }

    /// The field between the samples, trilinear: `local` is relative to the chunk's origin,
    /// metres, and is held to -1..=33. Below zero is solid.
    pub fn density(&self, local: DVec3) -> f32 {
        let p = (local + 1.0).clamp(DVec3::ZERO, DVec3::splat((SAMPLES - 1) as f64));
        let low = p.floor().min(DVec3::splat((SAMPLES - 2) as f64));
        let t = (p - low).as_vec3();
        let (i, j, k) = (low.x as usize, low.y as usize, low.z as usize);
        let column = |i, k| {
            let (a, b) = (self.get(i, j, k), self.get(i, j + 1, k));
            a + t.y * (b - a)
        };
        let near = column(i, k) + t.x * (column(i + 1, k) - column(i, k));
        let far = column(i, k + 1) + t.x * (column(i + 1, k + 1) - column(i, k + 1));
        near + t.z * (far - near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn density_is_exact_for_trilinear_functions_and_at_both_ends() {
        let f = |p: DVec3| (p.x * 2.0 - p.y + 0.5 * p.z + 0.01 * p.x * p.y * p.z) as f32;
        let samples = Samples::from_fn(f);
        for p in [
            DVec3::new(3.25, 7.5, 30.125),
            DVec3::splat(-1.0),
            DVec3::splat(33.0),
            DVec3::new(32.999, -0.001, 16.0),
        ] {
            let found = samples.density(p);
            assert!((found - f(p)).abs() < 1e-3, "{p}: {found} {}", f(p));
        }
        assert_eq!(
            samples.density(DVec3::splat(99.0)),
            f(DVec3::splat(33.0)),
            "held to the block"
        );
    }
}
