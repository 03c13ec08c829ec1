//! The field samples that one chunk is meshed from.
//!
//! At each level there is a block of samples a step apart. A chunk of coarse cells also has,
//! for each face, the samples that a neighbour of half the step has there: its seams go by them.

use antipode_geometry::{CHUNK_CELLS, ChunkCoord};
use glam::DVec3;

use crate::carve::Hollow;
use crate::edits::EDIT_STEP;
use crate::field::{Field, editable_y_m};
use crate::level::Level;
use crate::strata::depth_of;

/// Samples along an edge of a chunk's block at [`Level::FULL`]: 33 corners of its 32 cells and
/// one sample of border on each side, which central differences need.
pub const SAMPLES: usize = 35;
/// For a face across x, y or z, the axes along which its samples lie: the nearer ones, and the
/// rows of those. So lie the samples of [`crate::Field::fill_grid`].
pub(crate) const FACE_AXES: [(usize, usize); 3] = [(1, 2), (2, 0), (1, 0)];

/// Field samples of one chunk: sample `(i, j, k)`, each from 0 to below [`Self::side`], stands at
/// the chunk's origin plus `(i - 1, j - 1, k - 1)` steps. Below zero is solid.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    level: Level,
    values: Box<[f32]>,
    /// Face after face, each `face_side` squared; empty at [`Level::FULL`].
    faces: Box<[f32]>,
    editable_y_m: (f64, f64),
    /// What caves and edits have covered up, of each value; empty where there is neither.
    covered: Box<[Covered]>,
}

/// What a sample of the land was before caves and edits, and what it was made of by them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Covered {
    /// As [`crate::strata::depth_of`].
    pub depth: u8,
    /// The number of a kind; 0 where nobody built and nothing has grown.
    pub laid: u8,
}

/// Samples along an edge of a level's block.
const fn side(level: Level) -> usize {
    level.cells() + 3
}

/// Samples along an edge of a face, at half a level's step.
const fn face_side(level: Level) -> usize {
    2 * level.cells() + 1
}

impl Samples {
    /// Full samples of any function of the position relative to the chunk's origin, metres.
    pub fn from_fn(density: impl FnMut(DVec3) -> f32) -> Self {
        Self::from_fn_at(Level::FULL, density)
    }

    /// Samples at a level of any function of the position relative to the chunk's origin, metres.
    pub fn from_fn_at(level: Level, mut density: impl FnMut(DVec3) -> f32) -> Self {
        let mut samples = Self::at(level, (f64::NEG_INFINITY, f64::INFINITY));
        samples.fill_with(|first, step_m, counts, out| {
            let [_, height, depth] = counts;
            for (n, value) in out.iter_mut().enumerate() {
                let (column, j) = (n / height, n % height);
                let steps = [column / depth, j, column % depth].map(|c| c as f64);
                *value = density(first + DVec3::from(steps) * f64::from(step_m));
            }
        });
        samples
    }

    fn at(level: Level, editable_y_m: (f64, f64)) -> Self {
        let faces = match level.finer() {
            Some(_) => 6 * face_side(level).pow(2),
            None => 0,
        };
        Self {
            level,
            values: vec![0.0; side(level).pow(3)].into_boxed_slice(),
            faces: vec![0.0; faces].into_boxed_slice(),
            editable_y_m,
            covered: Box::default(),
        }
    }

    /// Fills the block and the faces with grids, as [`crate::Field::fill_grid`] does: each is
    /// asked for by its first sample relative to the chunk's origin, its step and its counts.
    pub(crate) fn fill_with(&mut self, mut fill: impl FnMut(DVec3, u32, [usize; 3], &mut [f32])) {
        let step_m = self.level.step_m();
        let first = DVec3::splat(-f64::from(step_m));
        fill(first, step_m, [self.side(); 3], &mut self.values);
        let Some(finer) = self.level.finer() else {
            return;
        };
        let n = face_side(self.level);
        for (face, values) in self.faces.chunks_exact_mut(n * n).enumerate() {
            let (axis, far) = (face / 2, face % 2);
            let mut first = DVec3::ZERO;
            first[axis] = f64::from(CHUNK_CELLS) * far as f64;
            let mut counts = [n; 3];
            counts[axis] = 1;
            fill(first, finer.step_m(), counts, values);
        }
    }

    /// The level whose step the samples are apart.
    pub fn level(&self) -> Level {
        self.level
    }

    /// Samples along an edge of the block: 35, 19, 11 or 7.
    #[inline]
    pub fn side(&self) -> usize {
        side(self.level)
    }

    /// Index of sample `(i, j, k)`: columns are contiguous, since the field is filled by columns.
    #[inline]
    pub(crate) fn index(&self, i: usize, j: usize, k: usize) -> usize {
        (i * self.side() + k) * self.side() + j
    }

    /// Sample `(i, j, k)`; indices past the block read its last sample.
    #[inline]
    pub fn get(&self, i: usize, j: usize, k: usize) -> f32 {
        let last = self.side() - 1;
        self.values[self.index(i.min(last), j.min(last), k.min(last))]
    }

    /// All samples, columns along y contiguous: `(i * side + k) * side + j`.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// Whether nothing was added to the block.
    #[inline]
    pub(crate) fn is_untouched(&self) -> bool {
        self.covered.is_empty()
    }

    /// Keeps what the block is before edits are added.
    fn cover(&mut self) {
        if self.covered.is_empty() {
            let depths = self.values.iter().map(|&value| Covered {
                depth: depth_of(value),
                laid: 0,
            });
            self.covered = depths.collect();
        }
    }

    /// Takes a cave's part out of a sample by its index.
    fn hollow(&mut self, at: usize, Hollow { value, grown }: Hollow) {
        if self.values.get(at).is_none_or(|&land| land >= value) {
            return;
        }
        self.cover();
        if let (Some(land), Some(covered)) = (self.values.get_mut(at), self.covered.get_mut(at)) {
            *land = value;
            covered.laid = grown;
        }
    }

    /// Adds an edit to a sample by its index, in units, with the number of the kind that was laid there.
    #[inline]
    pub(crate) fn edit(&mut self, at: usize, units: i16, laid: u8) {
        if units == 0 && laid == 0 {
            return;
        }
        self.cover();
        if let (Some(value), Some(covered)) = (self.values.get_mut(at), self.covered.get_mut(at)) {
            *value += f32::from(units) * EDIT_STEP;
            if laid != 0 {
                covered.laid = laid;
            }
        }
    }

    /// How deep untouched land has a sample by its index, and the kind that somebody laid there.
    #[inline]
    pub(crate) fn covered(&self, at: usize) -> Covered {
        match self.covered.get(at) {
            Some(covered) => *covered,
            None => Covered {
                depth: depth_of(self.values[at]),
                laid: 0,
            },
        }
    }

    /// The samples of a face, `0..6` for -x, +x, -y, +y, -z and +z, at half the step: rows of
    /// [`Self::face_side`] along the axes that [`FACE_AXES`] names. Empty at [`Level::FULL`].
    pub(crate) fn face(&self, face: usize) -> &[f32] {
        let n = self.face_side().pow(2);
        self.faces.get(face * n..(face + 1) * n).unwrap_or_default()
    }

    pub(crate) fn face_mut(&mut self, face: usize) -> &mut [f32] {
        let n = self.face_side().pow(2);
        self.faces
            .get_mut(face * n..(face + 1) * n)
            .unwrap_or_default()
    }

    /// Samples along an edge of a face.
    pub(crate) fn face_side(&self) -> usize {
        face_side(self.level)
    }

    /// Lowest and highest height, metres, at which edits count.
    pub(crate) fn editable_y_m(&self) -> (f64, f64) {
        self.editable_y_m
    }

    /// The field between the samples, trilinear: `local` is relative to the chunk's origin,
    /// metres, and is held to the block, -1..=33 at [`Level::FULL`]. Below zero is solid.
    pub fn density(&self, local: DVec3) -> f32 {
        let last = (self.side() - 1) as f64;
        let steps = local / f64::from(self.level.step_m());
        let p = (steps + 1.0).clamp(DVec3::ZERO, DVec3::splat(last));
        let low = p.floor().min(DVec3::splat(last - 1.0));
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

impl Field {
    /// The field over a chunk and its border.
    pub fn samples(&self, coord: ChunkCoord) -> Samples {
        self.samples_at(coord, Level::FULL)
    }

    /// The field over a chunk, its border and, of a coarse level, its faces. Values at places
    /// that levels share are the same bit for bit.
    pub fn samples_at(&self, coord: ChunkCoord, level: Level) -> Samples {
        let mut samples = Samples::at(level, editable_y_m(&**self.strategy()));
        let origin = coord.origin();
        samples.fill_with(|first, step_m, counts, out| {
            self.fill_grid(coord.chart, origin + first, step_m, counts, out);
        });
        let mut hollows = Vec::new();
        let mut is_block = true;
        samples.fill_with(|first, step_m, counts, out| {
            self.carve(coord.chart, origin + first, step_m, counts, |at, hollow| {
                if is_block {
                    hollows.push((at, hollow));
                } else if let Some(value) = out.get_mut(at) {
                    *value = value.max(hollow.value);
                }
            });
            is_block = false;
        });
        for (at, hollow) in hollows {
            samples.hollow(at, hollow);
        }
        samples
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn density_is_exact_for_trilinear_functions_and_at_both_ends() {
        let f = |p: DVec3| (p.x * 2.0 - p.y + 0.5 * p.z + 0.01 * p.x * p.y * p.z) as f32;
        for level in Level::ALL {
            let samples = Samples::from_fn_at(level, f);
            let step_m = f64::from(level.step_m());
            let end = 32.0 + step_m;
            for p in [
                DVec3::new(3.25, 7.5, 30.125),
                DVec3::splat(-step_m),
                DVec3::splat(end),
                DVec3::new(32.999, -0.001, 16.0),
            ] {
                let found = samples.density(p);
                assert!((found - f(p)).abs() < 2e-3, "{p}: {found} {}", f(p));
            }
            assert_eq!(
                samples.density(DVec3::splat(99.0)),
                f(DVec3::splat(end)),
                "held to the block"
            );
        }
    }

    #[test]
    fn faces_lie_in_the_chunks_planes_at_half_the_step() {
        let f = |p: DVec3| (p.x + 64.0 * p.y + 4096.0 * p.z) as f32;
        let samples = Samples::from_fn_at(Level::ALL[2], f);
        assert_eq!((samples.side(), samples.face_side()), (11, 17));
        for face in 0..6 {
            let (row, rows) = FACE_AXES[face / 2];
            for u in 0..17 {
                for v in 0..17 {
                    let mut p = DVec3::ZERO;
                    p[face / 2] = 32.0 * (face % 2) as f64;
                    (p[row], p[rows]) = (2.0 * u as f64, 2.0 * v as f64);
                    assert_eq!(samples.face(face)[v * 17 + u], f(p), "{face} {p}");
                }
            }
        }
        assert!(Samples::from_fn(f).face(0).is_empty());
    }
}
