//! Noise over grids whose axes are the lattice's own, as flat spaces have them.
//!
//! Along such a grid the noise comes apart axis by axis. Between two lattice planes of constant
//! y it is `low + fade(y) (high - low)`, where a plane gives `rest + rise * (y - plane)`; both
//! are interpolated over x and z, and between lattice points of a plane `rest` is again linear
//! in z. So hashes are found once for each lattice point and slab of constant x, gradients are
//! interpolated once for each column and plane, and a sample costs ten operations an octave.

use glam::{DVec3, Mat4, Vec4};

use crate::fractal::Octave;
use crate::lattice::{Lattice, Place, SCALE, fade};
use crate::relief::{BLOCK, Relief, Rows};

/// Vectors along z that are dealt with at once.
const VECTORS: usize = BLOCK / 4;

/// Samples of constant x: rows of constant y, along z.
type Slab = [[Vec4; VECTORS]; BLOCK];

/// The points of a grid along one axis of one octave.
struct Axis {
    low: [u8; BLOCK],
    part: [f32; BLOCK],
    fade: [f32; BLOCK],
}

/// A lattice plane of constant y over a slab: noise is `rest + rise * (y - plane)`.
struct Plane {
    rest: [f32; BLOCK],
    rise: [f32; BLOCK],
}

/// One octave over a grid, as far as it is the same for every slab.
struct Layer {
    octave: Octave,
    ys: Axis,
    zs: Axis,
    depth: usize,
}

/// Fills a grid by `(i * counts[2] + k) * counts[1] + j`, at most [`BLOCK`] along y and z.
pub(crate) fn fill(
    lattice: &Lattice,
    octaves: &[Octave],
    (relief, rows): (&Relief, &Rows),
    (first, step_m): (DVec3, f64),
    [_, height, depth]: [usize; 3],
    out: &mut [f32],
) {
    let layers: Vec<_> = octaves
        .iter()
        .map(|&octave| Layer::new(octave, first, step_m, height, depth))
        .collect();
    let mut slab = [[Vec4::ZERO; VECTORS]; BLOCK];
    for (i, out) in out.chunks_exact_mut((height * depth).max(1)).enumerate() {
        let x = first.x + i as f64 * step_m;
        slab[rows.open.0..rows.open.1].fill([Vec4::ZERO; VECTORS]);
        for layer in &layers {
            layer.add(lattice, x, rows.open, &mut slab);
        }
        write(relief, rows, &slab, height, out);
    }
}

/// Turns the sums of a slab into columns of the field.
fn write(relief: &Relief, rows: &Rows, slab: &Slab, height: usize, out: &mut [f32]) {
    let height = height.max(1);
    let mut values = [rows.edge; 4];
    for (v, columns) in out.chunks_mut(4 * height).enumerate() {
        for first in (rows.open.0 & !3..rows.open.1).step_by(4) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|n: usize| slab[first + n][v]);
            let sums = Mat4::from_cols(a, b, c, d).transpose();
            for (lane, values) in values.iter_mut().enumerate() {
                relief
                    .values(rows.base_m(first), sums.col(lane))
                    .write_to_slice(&mut values[first..first + 4]);
            }
        }
        for (column, values) in columns.chunks_exact_mut(height).zip(&values) {
            column.copy_from_slice(&values[..height]);
        }
    }
}

impl Axis {
    fn new(first: f64, step: f64, count: usize, frequency: f64) -> Self {
        let mut axis = Self {
            low: [0; BLOCK],
            part: [0.0; BLOCK],
            fade: [0.0; BLOCK],
        };
        for n in 0..count.min(BLOCK) {
            let place = Place::new((first + n as f64 * step) * frequency);
            axis.low[n] = place.low;
            axis.part[n] = place.part;
            axis.fade[n] = fade(place.part);
        }
        axis
    }
}

impl Layer {
    fn new(octave: Octave, first: DVec3, step_m: f64, height: usize, depth: usize) -> Self {
        let frequency = octave.frequencies();
        Self {
            octave,
            ys: Axis::new(first.y, step_m, height, frequency.y),
            zs: Axis::new(first.z, step_m, depth, frequency.z),
            depth: depth.min(BLOCK),
        }
    }

    /// Adds the octave to the rows `from..to` of the slab at `x`.
    fn add(&self, lattice: &Lattice, x: f64, (from, to): (usize, usize), slab: &mut Slab) {
        let place = Place::new(x * self.octave.frequencies().x);
        let half = Vec4::splat(self.octave.half_m());
        let vectors = self.depth.div_ceil(4);
        let mut known = None;
        let (mut low, mut high) = (Plane::new(), Plane::new());
        for (row, sums) in slab.iter_mut().enumerate().take(to).skip(from) {
            let y = self.ys.low[row];
            if known != Some(y) {
                if known == Some(y.wrapping_sub(1)) {
                    std::mem::swap(&mut low, &mut high);
                } else {
                    self.fill_plane(lattice, place, y, &mut low);
                }
                self.fill_plane(lattice, place, y.wrapping_add(1), &mut high);
                known = Some(y);
            }
            let (near, fade) = (self.ys.part[row], Vec4::splat(self.ys.fade[row]));
            let lines = low.lines(near).zip(high.lines(near - 1.0));
            for (sum, (a, b)) in sums.iter_mut().zip(lines).take(vectors) {
                *sum += (a + fade * (b - a)).clamp(-half, half);
            }
        }
    }

    /// The lattice plane at `y` over the slab at `x`.
    fn fill_plane(&self, lattice: &Lattice, x: Place, y: u8, plane: &mut Plane) {
        let columns = lattice.pair(x.low, y);
        let weight = self.octave.half_m() * SCALE;
        let (near, far, u) = (x.part, x.part - 1.0, fade(x.part));
        let node = |z: u8| {
            let [a, b] = columns.map(|column| lattice.gradient(column, z));
            let across = |a: f32, b: f32| (a + u * (b - a)) * weight;
            [
                across(a[0] * near, b[0] * far),
                across(a[2], b[2]),
                across(a[1], b[1]),
            ]
        };
        let mut ends = [[0.0; 3]; 2];
        let mut known = None;
        for n in 0..self.depth {
            let z = self.zs.low[n];
            if known != Some(z) {
                ends = [node(z), node(z.wrapping_add(1))];
                known = Some(z);
            }
            let (part, w) = (self.zs.part[n], self.zs.fade[n]);
            let [[a, da, rise_a], [b, db, rise_b]] = ends;
            let (a, b) = (a + da * part, b + db * (part - 1.0));
            plane.rest[n] = a + w * (b - a);
            plane.rise[n] = rise_a + w * (rise_b - rise_a);
        }
    }
}

impl Plane {
    fn new() -> Self {
        Self {
            rest: [0.0; BLOCK],
            rise: [0.0; BLOCK],
        }
    }

    /// What the plane contributes at a distance above it, by vectors.
    fn lines(&self, above: f32) -> impl Iterator<Item = Vec4> {
        let above = Vec4::splat(above);
        self.rest
            .as_chunks::<4>()
            .0
            .iter()
            .zip(self.rise.as_chunks::<4>().0)
            .map(move |(&rest, &rise)| Vec4::from(rest) + Vec4::from(rise) * above)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lattice::table_seed;
    use noise::{NoiseFn, Perlin};

    const OCTAVE: Octave = Octave {
        frequency: 0.6,
        amplitude_m: 2.0,
    };

    #[test]
    fn agrees_with_the_noise_crate() {
        let lattice = Lattice::new(77);
        let perlin = Perlin::new(table_seed(77));
        for n in 0..40 {
            let t = f64::from(n);
            let first = DVec3::new(t * 73.3 - 900.0, 31.0 - t * 19.3, t * t * 3.1 - 2000.0);
            for step_m in [1.0, 8.0] {
                let layer = Layer::new(OCTAVE, first, step_m, 35, 33);
                let mut slab = [[Vec4::ZERO; VECTORS]; BLOCK];
                layer.add(&lattice, first.x, (0, 35), &mut slab);
                for (j, row) in slab.iter().enumerate().take(35) {
                    for k in 0..33 {
                        let p = first + DVec3::new(0.0, j as f64, k as f64) * step_m;
                        let expected = perlin.get((p * OCTAVE.frequencies()).to_array());
                        let found = f64::from(row[k / 4][k % 4]);
                        assert!((found - expected).abs() < 2e-6, "{p}: {found} {expected}");
                    }
                }
            }
        }
    }
}
