//! Fractal gradient noise over columns of samples.
//!
//! Perlin's improved noise with the permutation table, gradients and scale of the `noise`
//! crate, and tested against it. It is evaluated here, because a column of a chunk stays in
//! one lattice cell for many samples, whose eight hashes and gradients are then found once,
//! and because `f32` is enough inside a cell: a chunk takes a third of the time.

use glam::DVec3;
use noise::permutationtable::{NoiseHasher, PermutationTable};

/// Frequencies per metre of the three axes, which the octaves multiply.
pub(crate) const AXIS_FREQUENCY: DVec3 = DVec3::new(0.1553, 0.1271, 0.0916);
/// Brings three-dimensional gradient noise to -1..=1: 2/sqrt(3).
const SCALE: f32 = 1.154_700_5;
/// The sixteen hashes' gradients; twelve cube edges, four of them twice.
const GRADIENTS: [[f32; 3]; 16] = [
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [-1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [-1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, -1.0, 1.0],
    [0.0, 1.0, -1.0],
    [0.0, -1.0, -1.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0],
    [0.0, -1.0, -1.0],
];

/// One octave of a fractal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Octave {
    /// Multiplies [`AXIS_FREQUENCY`].
    pub frequency: f64,
    /// Weight of this octave's noise in 0..=1, metres.
    pub amplitude_m: f64,
}

/// Points `base + slope * y` of noise space, as `y` runs up a column of the chart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Column {
    /// The point at `y = 0`.
    pub base: DVec3,
    /// Its change per metre of height.
    pub slope: DVec3,
}

/// Seeded gradient noise.
pub(crate) struct Lattice {
    table: [u8; 256],
}

/// The eight corners of a lattice cell: gradients by axis and their constant terms, corner
/// `x + 2 y + 4 z`, so that corner `c` contributes `gx fx + gy fy + gz fz + rest`.
struct Cell {
    index: [i64; 3],
    gx: [f32; 8],
    gy: [f32; 8],
    gz: [f32; 8],
    rest: [f32; 8],
}

impl std::fmt::Debug for Lattice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lattice").finish_non_exhaustive()
    }
}

/// Greatest whole number at most `v`, and what is left. A cast and a comparison: without
/// SSE4.1, the baseline, `floor` is a call.
fn split(v: f64) -> (i64, f32) {
    let truncated = v as i64;
    let whole = truncated.wrapping_sub(i64::from(v < truncated as f64));
    (whole, (v - whole as f64) as f32)
}

fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// All 64 bits of a world's seed stirred into the 32 that the table's generator takes
/// (the finaliser of splitmix64), so that neighbouring seeds have unrelated tables.
pub(crate) fn table_seed(seed: u64) -> u32 {
    let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 32) as u32
}

impl Lattice {
    pub(crate) fn new(seed: u64) -> Self {
        let hasher = PermutationTable::new(table_seed(seed));
        let mut table = [0; 256];
        for (index, entry) in table.iter_mut().enumerate() {
            *entry = hasher.hash(&[index as isize]) as u8;
        }
        Self { table }
    }

    fn cell(&self, index: [i64; 3]) -> Cell {
        let mut cell = Cell {
            index,
            gx: [0.0; 8],
            gy: [0.0; 8],
            gz: [0.0; 8],
            rest: [0.0; 8],
        };
        for corner in 0..8 {
            let offset = [corner & 1, (corner >> 1) & 1, corner >> 2];
            let at = |axis: usize| index[axis].wrapping_add(offset[axis] as i64) & 0xff;
            let x = self.table[at(0) as usize];
            let y = self.table[usize::from(x) ^ at(1) as usize];
            let z = self.table[usize::from(y) ^ at(2) as usize];
            let [gx, gy, gz] = GRADIENTS[usize::from(z & 0b1111)];
            cell.gx[corner] = gx;
            cell.gy[corner] = gy;
            cell.gz[corner] = gz;
            cell.rest[corner] =
                -(gx * offset[0] as f32 + gy * offset[1] as f32 + gz * offset[2] as f32);
        }
        cell
    }

    /// Adds an octave, `(noise - 0.5) * amplitude` with noise in 0..=1, to the samples of a
    /// column at heights `first_m`, `first_m + 1`, ...
    pub(crate) fn add_octave(
        &self,
        octave: Octave,
        column: &Column,
        first_m: f64,
        out: &mut [f32],
    ) {
        let base = column.base * AXIS_FREQUENCY * octave.frequency;
        let slope = column.slope * AXIS_FREQUENCY * octave.frequency;
        let half = (octave.amplitude_m / 2.0) as f32;
        let mut cell: Option<Cell> = None;
        for (step, value) in out.iter_mut().enumerate() {
            let q = base + slope * (first_m + step as f64);
            let ((x, fx), (y, fy), (z, fz)) = (split(q.x), split(q.y), split(q.z));
            let here = match cell.take() {
                Some(here) if here.index == [x, y, z] => here,
                _ => self.cell([x, y, z]),
            };
            *value += half * here.noise(fx, fy, fz);
            cell = Some(here);
        }
    }

    /// Noise in -1..=1 at a point of noise space, at `frequency` times the axes'.
    pub(crate) fn at(&self, point: DVec3, frequency: f64) -> f32 {
        let octave = Octave {
            frequency,
            amplitude_m: 2.0,
        };
        let column = Column {
            base: point,
            slope: DVec3::ZERO,
        };
        let mut out = [0.0];
        self.add_octave(octave, &column, 0.0, &mut out);
        out[0]
    }
}

impl Cell {
    /// Noise in -1..=1 at fractions of the cell.
    #[inline]
    fn noise(&self, fx: f32, fy: f32, fz: f32) -> f32 {
        let mut dots = [0.0; 8];
        for (corner, dot) in dots.iter_mut().enumerate() {
            *dot = self.gx[corner] * fx
                + self.gy[corner] * fy
                + self.gz[corner] * fz
                + self.rest[corner];
        }
        let (u, v, w) = (fade(fx), fade(fy), fade(fz));
        let mut rows = [0.0; 4];
        for (corner, row) in rows.iter_mut().enumerate() {
            *row = dots[corner] + w * (dots[corner + 4] - dots[corner]);
        }
        let near = rows[0] + v * (rows[2] - rows[0]);
        let far = rows[1] + v * (rows[3] - rows[1]);
        ((near + u * (far - near)) * SCALE).clamp(-1.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use noise::{NoiseFn, Perlin};

    #[test]
    fn agrees_with_the_noise_crate() {
        let lattice = Lattice::new(77);
        let perlin = Perlin::new(table_seed(77));
        for n in 0..4000 {
            let t = f64::from(n);
            let p = DVec3::new(t * 0.73 - 900.0, 31.0 - t * 0.19, t * t * 0.003 - 4000.0);
            let expected = perlin.get((p * AXIS_FREQUENCY * 0.6).to_array());
            let found = f64::from(lattice.at(p, 0.6));
            assert!((found - expected).abs() < 2e-6, "{p}: {found} {expected}");
        }
    }

    #[test]
    fn a_sample_does_not_depend_on_where_its_column_starts() {
        let lattice = Lattice::new(3);
        let octave = Octave {
            frequency: 1.7,
            amplitude_m: 9.0,
        };
        let column = Column {
            base: DVec3::new(12.5, -3.0, 99.0),
            slope: DVec3::new(0.3, 0.9, -0.2),
        };
        let (mut long, mut short) = ([0.0; 35], [0.0; 3]);
        lattice.add_octave(octave, &column, -17.0, &mut long);
        lattice.add_octave(octave, &column, 5.0, &mut short);
        assert_eq!(long[22..25], short);
    }

    #[test]
    fn neighbouring_seeds_have_unrelated_tables() {
        let (a, b) = (Lattice::new(1).table, Lattice::new(2).table);
        let same = a.iter().zip(&b).filter(|(a, b)| a == b).count();
        assert!(same < 12, "{same} of 256 entries agree");
    }
}
