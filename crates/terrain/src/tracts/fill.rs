//! Fills columns with the noise of their spots.
//!
//! Patches lie anywhere in the space of the noise, but all at the same height. So between two lattice planes of constant y noise is
//! `low + fade(y) (high - low)` as in [`crate::upright`], where a plane gives `rest + rise (y - plane)`, and
//! these two are blended from patch to patch once for each column and plane: a sample costs what it does in flat worlds.

use antipode_geometry::tiling::quilt::{MOST_PATCHES, PATCHES};
use glam::{DVec2, DVec3, Vec4};

use super::Spot;
use crate::form::{Form, terrace_wave};
use crate::fractal::Octave;
use crate::lattice::{Lattice, LatticeCoord, SCALE, fade};
use crate::relief::{BLOCK, Ground};
use crate::upright::{Forms, Grid, Layer, Plane, write};

/// A column's place in a lattice cell of one patch.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    patch: usize,
    low: [u8; 2],
    /// From the four corners of the cell in a plane, `x + 2 z`, along x and z, and what each weighs.
    away: [Vec4; 2],
    weights: Vec4,
}

impl Corner {
    fn new(&(patch, at, share): &(usize, DVec2, f32), frequencies: DVec3, half: f32) -> Self {
        let x = LatticeCoord::new(at.x * frequencies.x);
        let z = LatticeCoord::new(at.y * frequencies.z);
        let (u, w) = (fade(x.part), fade(z.part));
        let along_x = Vec4::new(1.0 - u, u, 1.0 - u, u);
        let along_z = Vec4::new(1.0 - w, 1.0 - w, w, w);
        Self {
            patch,
            low: [x.low, z.low],
            away: [
                x.part - Vec4::new(0.0, 1.0, 0.0, 1.0),
                z.part - Vec4::new(0.0, 0.0, 1.0, 1.0),
            ],
            weights: along_x * along_z * (share * half * SCALE),
        }
    }

    /// Adds to the rest and the rise of a plane with these gradients.
    #[inline]
    fn add(&self, [x, y, z]: &[Vec4; 3], [rest, rise]: &mut [Vec4; 2]) {
        *rest += self.weights * (*x * self.away[0] + *z * self.away[1]);
        *rise += self.weights * *y;
    }
}

/// The corners of a spot in an octave.
#[derive(Debug, Clone, Copy, Default)]
struct Corners {
    count: usize,
    all: [Corner; MOST_PATCHES],
}

impl Corners {
    /// Takes the place of those that were there.
    fn set(&mut self, spot: &Spot, octave: Octave) {
        let (frequencies, half) = (octave.frequencies(), octave.half_m());
        for (corner, lot) in self.all.iter_mut().zip(spot.lots()) {
            *corner = Corner::new(lot, frequencies, half);
        }
        self.count = spot.lots().len();
    }

    /// Rest and rise in a plane, by what gives the gradients of a corner.
    #[inline]
    fn plane(&self, mut gradients: impl FnMut(&Corner) -> [Vec4; 3]) -> [f32; 2] {
        let mut sums = [Vec4::ZERO; 2];
        for corner in &self.all[..self.count] {
            corner.add(&gradients(corner), &mut sums);
        }
        // In this order on every machine.
        sums.map(|sum| (sum.x + sum.y) + (sum.z + sum.w))
    }
}

/// As [`crate::upright::fill`], of columns with these spots.
pub(crate) fn fill(
    lattice: &Lattice,
    octaves: &[Octave],
    Ground { relief, rows }: Ground<'_>,
    grid: &Grid,
    (spots, forms): (&[Spot], &[Form]),
    out: &mut [f32],
) {
    let [_, height, depth] = grid.counts;
    let layers: Vec<_> = octaves
        .iter()
        .map(|&octave| Layer::new(octave, grid))
        .collect();
    let open = [4 * rows.open[0], height.min(4 * rows.open[1])];
    let mut slab = [[Vec4::ZERO; crate::relief::VECTORS]; BLOCK];
    let mut corners = vec![Corners::default(); BLOCK];
    let columns = forms.chunks(depth.max(1)).zip(spots.chunks(depth.max(1)));
    for ((forms, spots), out) in columns.zip(out.chunks_exact_mut((height * depth).max(1))) {
        let is_felt = |n: usize| forms.iter().any(|form| form.waves[n] != 0.0);
        let shares = Forms::new(forms);
        shares.begin(rows, open, &mut slab);
        for (n, (layer, shares)) in layers.iter().zip(&shares.waves).enumerate() {
            if !is_felt(n) {
                continue;
            }
            for (corners, spot) in corners.iter_mut().zip(spots) {
                corners.set(spot, layer.octave);
            }
            let corners = &corners[..depth.min(BLOCK)];
            layer.add_planes(open, shares, &mut slab, |y, plane| {
                fill_plane(lattice, corners, y, plane);
            });
        }
        write(relief, rows, &slab, height, out);
    }
}

/// A lattice plane over columns beside each other: of a patch those mostly lie in the same cell.
fn fill_plane(lattice: &Lattice, columns: &[Corners], y: u8, plane: &mut Plane) {
    let mut known = [(None, [Vec4::ZERO; 3]); PATCHES];
    for (n, corners) in columns.iter().enumerate() {
        [plane.rest[n], plane.rise[n]] = corners.plane(|corner| {
            let known = &mut known[corner.patch % PATCHES];
            if known.0 != Some(corner.low) {
                let [x, z] = corner.low;
                *known = (Some(corner.low), lattice.around(x, y, z));
            }
            known.1
        });
    }
}

/// The sum of the octaves at a height over a spot: bit for bit what [`fill`] finds there.
pub(crate) fn sum_at(
    lattice: &Lattice,
    octaves: &[Octave],
    form: &Form,
    spot: &Spot,
    height_m: f64,
) -> f32 {
    let mut sum = form.start(terrace_wave(height_m));
    let mut corners = Corners::default();
    for (octave, wave) in octaves.iter().zip(form.waves.to_array()) {
        if wave == 0.0 {
            continue;
        }
        corners.set(spot, *octave);
        let y = LatticeCoord::new(height_m * octave.frequencies().y);
        let half = octave.half_m();
        let plane = |y: u8| corners.plane(|it| lattice.around(it.low[0], y, it.low[1]));
        let ([a, low], [b, high]) = (plane(y.low), plane(y.low.wrapping_add(1)));
        let (a, b) = (a + low * y.part, b + high * (y.part - 1.0));
        sum += wave * (a + fade(y.part) * (b - a)).clamp(-half, half);
    }
    sum
}
