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

/// Where the corners of a cell stand: corner `x + 2 y + 4 z`.
const OFFSETS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [1.0, 1.0, 1.0],
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
#[derive(Default)]
struct Cell {
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

/// The lattice coordinate, modulo the table's 256, of the greatest whole number at most `v`, and
/// what is left. Adding 1.5 * 2^52 rounds to a whole number whose low bits are then the sum's:
/// cheaper than `floor`, which is a call without SSE4.1, and than a saturating cast. Past 2^51
/// the rest means nothing, but the noise's clamp still holds.
fn split(v: f64) -> (u8, f32) {
    const ROUNDS: f64 = 6_755_399_441_055_744.0;
    let shifted = v + ROUNDS;
    let nearest = shifted - ROUNDS;
    let above = nearest > v;
    let whole = nearest - f64::from(u8::from(above));
    let index = (shifted.to_bits() as u8).wrapping_sub(u8::from(above));
    (index, (v - whole) as f32)
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

    /// Fills in the cell whose lowest corner is `index`.
    fn enter(&self, cell: &mut Cell, index: [u8; 3]) {
        let [x, y, z] = index.map(|low| [low, low.wrapping_add(1)]);
        let hash = |key: u8| self.table[usize::from(key)];
        let by_x = x.map(hash);
        let by_xy = [0, 1, 2, 3].map(|c: usize| hash(by_x[c & 1] ^ y[c >> 1]));
        for corner in 0..8 {
            let last = hash(by_xy[corner & 3] ^ z[corner >> 2]);
            let [gx, gy, gz] = GRADIENTS[usize::from(last & 0b1111)];
            let at = OFFSETS[corner];
            cell.gx[corner] = gx;
            cell.gy[corner] = gy;
            cell.gz[corner] = gz;
            cell.rest[corner] = -(gx * at[0] + gy * at[1] + gz * at[2]);
        }
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
        if slope.x == 0.0 && slope.z == 0.0 {
            return self.add_upright(base, slope.y, half, first_m, out);
        }
        let mut cell = Cell::default();
        let mut known = None;
        for (step, value) in out.iter_mut().enumerate() {
            let q = base + slope * (first_m + step as f64);
            let ((x, fx), (y, fy), (z, fz)) = (split(q.x), split(q.y), split(q.z));
            if known != Some([x, y, z]) {
                known = Some([x, y, z]);
                self.enter(&mut cell, [x, y, z]);
            }
            *value += half * cell.noise(fx, fy, fz);
        }
    }

    /// [`Self::add_octave`] for columns along y, as flat spaces have them: what the corners
    /// contribute is interpolated over x and z once for each cell, and is linear in y.
    fn add_upright(&self, base: DVec3, rise: f64, half: f32, first_m: f64, out: &mut [f32]) {
        let ((x, fx), (z, fz)) = (split(base.x), split(base.z));
        let mut cell = Cell::default();
        let mut known = None;
        let mut lines = [(0.0, 0.0); 2];
        for (step, value) in out.iter_mut().enumerate() {
            let (y, fy) = split(base.y + rise * (first_m + step as f64));
            if known != Some(y) {
                known = Some(y);
                self.enter(&mut cell, [x, y, z]);
                lines = cell.lines(fx, fz);
            }
            let [(a, b), (c, d)] = lines;
            let (low, high) = (a + b * fy, c + d * fy);
            *value += half * ((low + fade(fy) * (high - low)) * SCALE).clamp(-1.0, 1.0);
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
    /// What the lower and the upper four corners contribute at fractions of x and z: each a
    /// constant and a factor of the fraction of y.
    fn lines(&self, fx: f32, fz: f32) -> [(f32, f32); 2] {
        let (u, w) = (fade(fx), fade(fz));
        let across = |at: [f32; 4]| {
            let (near, far) = (at[0] + u * (at[1] - at[0]), at[2] + u * (at[3] - at[2]));
            near + w * (far - near)
        };
        [[0, 1, 4, 5], [2, 3, 6, 7]].map(|corners| {
            let rest = |c: usize| self.gx[c] * fx + self.gz[c] * fz + self.rest[c];
            (
                across(corners.map(rest)),
                across(corners.map(|c| self.gy[c])),
            )
        })
    }

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
    fn agrees_with_the_noise_crate_along_upright_and_tilted_columns() {
        let lattice = Lattice::new(77);
        let perlin = Perlin::new(table_seed(77));
        let octave = Octave {
            frequency: 0.6,
            amplitude_m: 2.0,
        };
        for n in 0..400 {
            let t = f64::from(n);
            let base = DVec3::new(t * 7.3 - 900.0, 31.0 - t * 1.9, t * t * 0.03 - 2000.0);
            for slope in [DVec3::Y, DVec3::new(0.4, -0.7, 0.59)] {
                let mut found = [0.0; 35];
                lattice.add_octave(octave, &Column { base, slope }, -5.0, &mut found);
                for (step, found) in found.into_iter().enumerate() {
                    let p = base + slope * (step as f64 - 5.0);
                    let expected = perlin.get((p * AXIS_FREQUENCY * 0.6).to_array());
                    assert!(
                        (f64::from(found) - expected).abs() < 2e-6,
                        "{p}: {found} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn splits_numbers_at_the_whole_number_below() {
        for (v, index, rest) in [
            (2.25, 2, 0.25),
            (-0.25, 255, 0.75),
            (-3.0, 253, 0.0),
            (0.5, 0, 0.5),
            (1.5, 1, 0.5),
            (-256.5, 255, 0.5),
        ] {
            assert_eq!(split(v), (index, rest), "{v}");
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
