//! Noise over grids whose axes are the lattice's own, as flat spaces have them.
//!
//! Along such a grid the noise comes apart axis by axis. Between two lattice planes of constant
//! y it is `low + fade(y) (high - low)`, where a plane gives `rest + rise * (y - plane)`; both
//! are interpolated over x and z, and between lattice points of a plane `rest` is again linear
//! in z. So hashes are found once for each lattice point and slab of constant x, gradients are
//! interpolated once for each column and plane, and a sample costs ten operations an octave.

use glam::{DVec3, Mat4, Vec4};

use crate::form::{Form, terrace_wave};
use crate::fractal::Octave;
use crate::lattice::{Lattice, LatticeCoord, SCALE, fade};
use crate::relief::{BLOCK, Ground, Relief, Rows, VECTORS};

/// Most octaves that a field has.
const OCTAVES: usize = 4;

/// Samples of constant x: rows of constant y, along z.
pub(crate) type Slab = [[Vec4; VECTORS]; BLOCK];

/// The points of a grid along one axis of one octave.
struct Axis {
    low: [u8; BLOCK],
    part: [f32; BLOCK],
    fade: [f32; BLOCK],
}

/// A lattice plane of constant y over a slab: noise is `rest + rise * (y - plane)`.
pub(crate) struct Plane {
    pub rest: [f32; BLOCK],
    pub rise: [f32; BLOCK],
}

/// One octave over a grid, as far as it is the same for every slab.
pub(crate) struct Layer {
    pub octave: Octave,
    held_m: [f32; 2],
    ys: Axis,
    zs: Axis,
    depth: usize,
}

/// Places `first + step_m * (i, j, k)`, with `(i, j, k)` below `counts`.
#[derive(Clone, Copy)]
pub(crate) struct Grid {
    pub first: DVec3,
    pub step_m: DVec3,
    pub counts: [usize; 3],
}

/// What the columns of one slab make of the octaves, along z.
pub(crate) struct Forms {
    pub waves: [[Vec4; VECTORS]; OCTAVES],
    fall_m: [Vec4; VECTORS],
    terraces: [Vec4; VECTORS],
}

impl Forms {
    pub(crate) fn new(forms: &[Form]) -> Self {
        let lane = |number: &dyn Fn(&Form) -> f32| {
            let mut lane = [0.0; BLOCK];
            for (out, form) in lane.iter_mut().zip(forms) {
                *out = number(form);
            }
            std::array::from_fn(|v| Vec4::from_slice(&lane[v * 4..v * 4 + 4]))
        };
        Self {
            waves: std::array::from_fn(|n| lane(&|form| form.waves[n])),
            fall_m: lane(&|form| form.fall_m),
            terraces: lane(&|form| form.terraces),
        }
    }

    /// Begins the sums of rows from the first to before the second.
    pub(crate) fn begin(&self, rows: &Rows, [from, to]: [usize; 2], slab: &mut Slab) {
        for (row, sums) in slab.iter_mut().enumerate().take(to).skip(from) {
            let wave = rows.waves[row / 4][row % 4];
            for (sum, (&terraces, &fall_m)) in
                sums.iter_mut().zip(self.terraces.iter().zip(&self.fall_m))
            {
                *sum = terraces * wave + fall_m;
            }
        }
    }
}

/// Fills a grid by `(i * counts[2] + k) * counts[1] + j`, at most [`BLOCK`] along y and z; `forms` are those of its columns, by
/// `i * counts[2] + k`.
pub(crate) fn fill(
    lattice: &Lattice,
    octaves: &[Octave],
    Ground { relief, rows }: Ground<'_>,
    grid: &Grid,
    forms: &[Form],
    out: &mut [f32],
) {
    let [_, height, depth] = grid.counts;
    let layers: Vec<_> = octaves
        .iter()
        .map(|&octave| Layer::new(octave, grid))
        .collect();
    let mut slab = [[Vec4::ZERO; VECTORS]; BLOCK];
    for (i, out) in out.chunks_exact_mut((height * depth).max(1)).enumerate() {
        let x = grid.first.x + i as f64 * grid.step_m.x;
        let open = [4 * rows.open[0], height.min(4 * rows.open[1])];
        let forms = Forms::new(&forms[i * depth..][..depth]);
        forms.begin(rows, open, &mut slab);
        for (layer, shares) in layers.iter().zip(&forms.waves) {
            layer.add(lattice, x, open, shares, &mut slab);
        }
        write(relief, rows, &slab, height, out);
    }
}

/// Least and greatest sum in each row of a grid, the octaves held to `held` times what they are
/// held to else.
pub(crate) fn extremes(
    lattice: &Lattice,
    octaves: &[Octave],
    held: [f32; 2],
    grid: &Grid,
) -> [[f32; BLOCK]; 2] {
    let [width, height, depth] = grid.counts;
    let layers: Vec<_> = octaves
        .iter()
        .map(|&octave| {
            let mut layer = Layer::new(octave, grid);
            layer.held_m = held.map(|share| share * octave.half_m());
            layer
        })
        .collect();
    let mut least = [Vec4::INFINITY; BLOCK];
    let mut most = [Vec4::NEG_INFINITY; BLOCK];
    let mut slab = [[Vec4::ZERO; VECTORS]; BLOCK];
    for i in 0..width {
        slab[..height].fill([Vec4::ZERO; VECTORS]);
        for layer in &layers {
            layer.add(
                lattice,
                grid.first.x + i as f64 * grid.step_m.x,
                [0, height],
                &[Vec4::ONE; VECTORS],
                &mut slab,
            );
        }
        let bounds = least.iter_mut().zip(&mut most);
        for (sums, (least, most)) in slab[..height].iter().zip(bounds) {
            for &sum in &sums[..depth / 4] {
                (*least, *most) = (least.min(sum), most.max(sum));
            }
        }
    }
    [least.map(Vec4::min_element), most.map(Vec4::max_element)]
}

/// Turns the sums of a slab into columns of the field.
pub(crate) fn write(relief: &Relief, rows: &Rows, slab: &Slab, height: usize, out: &mut [f32]) {
    let height = height.max(1);
    let mut values = [rows.edge; 4];
    for (v, columns) in out.chunks_mut(4 * height).enumerate() {
        for vector in rows.open[0]..rows.open[1] {
            let first = vector * 4;
            let [a, b, c, d] = [0, 1, 2, 3].map(|n: usize| slab[first + n][v]);
            let sums = Mat4::from_cols(a, b, c, d).transpose();
            for (lane, values) in values.iter_mut().enumerate() {
                relief
                    .values(rows.base_m[vector], sums.col(lane))
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
            let place = LatticeCoord::new((first + n as f64 * step) * frequency);
            axis.low[n] = place.low;
            axis.part[n] = place.part;
            axis.fade[n] = fade(place.part);
        }
        axis
    }
}

impl Layer {
    pub(crate) fn new(octave: Octave, grid: &Grid) -> Self {
        let Grid { first, step_m, .. } = *grid;
        let [_, height, depth] = grid.counts;
        let frequency = octave.frequencies();
        let half_m = octave.half_m();
        Self {
            octave,
            held_m: [-half_m, half_m],
            ys: Axis::new(first.y, step_m.y, height, frequency.y),
            zs: Axis::new(first.z, step_m.z, depth, frequency.z),
            depth: depth.min(BLOCK),
        }
    }

    /// Adds the octave to the rows `from..to` of the slab at `x`, so many times of each column.
    fn add(
        &self,
        lattice: &Lattice,
        x: f64,
        [from, to]: [usize; 2],
        shares: &[Vec4; VECTORS],
        slab: &mut Slab,
    ) {
        let place = LatticeCoord::new(x * self.octave.frequencies().x);
        let plane = |y: u8, plane: &mut Plane| self.fill_plane(lattice, place, y, plane);
        self.add_planes([from, to], shares, slab, plane);
    }

    /// Adds the octave to the rows `from..to` of a slab whose lattice planes `fill` fills, so many times of each column.
    #[inline]
    pub(crate) fn add_planes(
        &self,
        [from, to]: [usize; 2],
        shares: &[Vec4; VECTORS],
        slab: &mut Slab,
        mut fill: impl FnMut(u8, &mut Plane),
    ) {
        let [least, most] = self.held_m.map(Vec4::splat);
        let vectors = self.depth.div_ceil(4);
        let mut known = None;
        let (mut low, mut high) = (Plane::new(), Plane::new());
        for (row, sums) in slab.iter_mut().enumerate().take(to).skip(from) {
            let y = self.ys.low[row];
            if known != Some(y) {
                if known == Some(y.wrapping_sub(1)) {
                    std::mem::swap(&mut low, &mut high);
                } else {
                    fill(y, &mut low);
                }
                fill(y.wrapping_add(1), &mut high);
                known = Some(y);
            }
            let (near, fade) = (self.ys.part[row], Vec4::splat(self.ys.fade[row]));
            let lines = low.lines(near).zip(high.lines(near - 1.0));
            let sums = sums.iter_mut().zip(shares).take(vectors);
            for ((sum, &share), (a, b)) in sums.zip(lines) {
                *sum += share * (a + fade * (b - a)).clamp(least, most);
            }
        }
    }

    /// The lattice plane at `y` over the slab at `x`.
    fn fill_plane(&self, lattice: &Lattice, x: LatticeCoord, y: u8, plane: &mut Plane) {
        let line = Line::new(lattice, x, y, self.octave.half_m() * SCALE);
        let mut ends = [[0.0; 3]; 2];
        let mut known = None;
        for n in 0..self.depth {
            let z = self.zs.low[n];
            if known != Some(z) {
                ends = [line.node(z), line.node(z.wrapping_add(1))];
                known = Some(z);
            }
            (plane.rest[n], plane.rise[n]) = between(ends, self.zs.part[n], self.zs.fade[n]);
        }
    }
}

/// Where a plane of constant x cuts a lattice plane of constant y.
struct Line<'a> {
    lattice: &'a Lattice,
    columns: [u8; 2],
    near: f32,
    far: f32,
    fade: f32,
    weight: f32,
}

impl<'a> Line<'a> {
    fn new(lattice: &'a Lattice, x: LatticeCoord, y: u8, weight: f32) -> Self {
        Self {
            lattice,
            columns: lattice.pair(x.low, y),
            near: x.part,
            far: x.part - 1.0,
            fade: fade(x.part),
            weight,
        }
    }

    /// Between the lattice points of one z: the value there, its slope along z and along y.
    #[inline]
    fn node(&self, z: u8) -> [f32; 3] {
        let [a, b] = self.columns.map(|column| self.lattice.gradient(column, z));
        let across = |a: f32, b: f32| (a + self.fade * (b - a)) * self.weight;
        [
            across(a[0] * self.near, b[0] * self.far),
            across(a[2], b[2]),
            across(a[1], b[1]),
        ]
    }
}

/// Rest and rise of a plane between two nodes.
#[inline]
fn between([a, b]: [[f32; 3]; 2], part: f32, fade: f32) -> (f32, f32) {
    let (low, high) = (a[0] + a[1] * part, b[0] + b[1] * (part - 1.0));
    (low + fade * (high - low), a[2] + fade * (b[2] - a[2]))
}

/// The sum of the octaves at a point: bit for bit what [`fill`] finds there.
pub(crate) fn sum_at(lattice: &Lattice, octaves: &[Octave], form: &Form, point: DVec3) -> f32 {
    let mut sum = form.start(terrace_wave(point.y));
    for (octave, wave) in octaves.iter().zip(form.waves.to_array()) {
        let at = point * octave.frequencies();
        let [x, y, z] = at.to_array().map(LatticeCoord::new);
        let half = octave.half_m();
        let plane = |y: u8| {
            let line = Line::new(lattice, x, y, half * SCALE);
            let ends = [line.node(z.low), line.node(z.low.wrapping_add(1))];
            between(ends, z.part, fade(z.part))
        };
        let ((a, low), (b, high)) = (plane(y.low), plane(y.low.wrapping_add(1)));
        let (a, b) = (a + low * y.part, b + high * (y.part - 1.0));
        sum += wave * (a + fade(y.part) * (b - a)).clamp(-half, half);
    }
    sum
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
                let grid = Grid {
                    first,
                    step_m: DVec3::splat(step_m),
                    counts: [1, 35, 33],
                };
                let layer = Layer::new(OCTAVE, &grid);
                let mut slab = [[Vec4::ZERO; VECTORS]; BLOCK];
                layer.add(&lattice, first.x, [0, 35], &[Vec4::ONE; VECTORS], &mut slab);
                for (j, row) in slab.iter().enumerate().take(35) {
                    for k in 0..33 {
                        let p = first + DVec3::new(0.0, j as f64, k as f64) * step_m;
                        let expected = perlin.get((p * OCTAVE.frequencies()).to_array());
                        let found = row[k / 4][k % 4];
                        assert_eq!(found, sum_at(&lattice, &[OCTAVE], &Form::PLAIN, p));
                        let found = f64::from(found);
                        assert!((found - expected).abs() < 2e-6, "{p}: {found} {expected}");
                    }
                }
            }
        }
    }
}
