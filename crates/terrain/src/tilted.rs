//! Noise along columns that run through the lattice at any slant, as curved spaces have them.

use glam::{DVec3, Vec4};

use crate::fixed::{self, PART_BITS, Ray};
use crate::form::terrace_wave;
use crate::fractal::{Column, Octave};
use crate::lattice::{Cell, Lattice, SCALE, blend, fade};
use crate::region::{Batch, LIMIT, Region};
use crate::relief::{BLOCK, Ground, Relief};

/// Columns of fewer samples than this would leave most of a vector empty.
const SHORT: usize = 3;

/// Heights `first_m + step_m * n` with `n` below `count`.
#[derive(Clone, Copy)]
pub(crate) struct Heights {
    pub first_m: f64,
    pub step_m: f64,
    pub count: usize,
}

/// Fills columns of samples at `heights`, at most [`BLOCK`], above each of `columns`, which hold lattice coordinates of
/// the first octave.
pub(crate) fn fill(
    lattice: &Lattice,
    octaves: &[Octave],
    ground: Ground<'_>,
    columns: &[Column],
    heights: Heights,
    out: &mut [f32],
) {
    let Ground { relief, rows } = ground;
    let Heights {
        first_m,
        step_m,
        count: height,
    } = heights;
    let Some(regions) = regions(lattice, octaves, columns, heights) else {
        return fill_far(lattice, octaves, relief, (columns, heights), out);
    };
    if height < SHORT {
        return fill_short(&regions, ground, columns, heights, out);
    }
    let [from, to] = rows.open;
    let open = to - from;
    let Some(together) = LIMIT.checked_div(open) else {
        return rows.fill_closed(height, out);
    };
    let mut batch = Batch::new(open);
    let rest = rest_m(&regions, columns);
    for (columns, out) in columns
        .chunks(together)
        .zip(out.chunks_mut(together * height))
    {
        let form = |four: usize| &columns[four / open].form;
        let start = |four| form(four).starts(rows.waves[from + four % open]);
        let [x, y, z] = batch.restart(columns.len() * open, start);
        let [x, y, z] = [x, y, z].map(|axis| axis.chunks_exact_mut(4 * open));
        for (column, ((x, y), z)) in columns.iter().zip(x.zip(y).zip(z)) {
            Ray::new(column, first_m, step_m).fill(from, [x, y, z]);
        }
        for (n, region) in regions.iter().enumerate() {
            region.add(&mut batch, |four| Vec4::splat(form(four).waves[n]));
            // The first octave is more than all others together: asked again after those, the
            // question costs more than it saves.
            if n == 0 {
                batch.retain(|row, sum| !rows.certain(from + row, sum, rest));
            }
        }
        let sums = batch.finish().chunks_exact(open);
        for (sums, out) in sums.zip(out.chunks_exact_mut(height)) {
            let mut values = rows.edge;
            let fours = values[4 * from..].chunks_exact_mut(4);
            for ((&base, &sum), four) in rows.base_m[from..to].iter().zip(sums).zip(fours) {
                relief.values(base, sum).write_to_slice(four);
            }
            out.copy_from_slice(&values[..height]);
        }
    }
}

/// How far from zero all octaves but the first are together at most, in any of some columns, metres.
fn rest_m(regions: &[Region], columns: &[Column]) -> f32 {
    let waves = columns.iter().map(|column| column.form.waves);
    let most = waves.fold(Vec4::ZERO, Vec4::max);
    let octaves = regions.iter().zip(most.to_array()).skip(1);
    octaves.map(|(region, wave)| region.half_m() * wave).sum()
}

/// [`fill`] of columns that no regions hold.
fn fill_far(
    lattice: &Lattice,
    octaves: &[Octave],
    relief: &Relief,
    (columns, heights): (&[Column], Heights),
    out: &mut [f32],
) {
    let height = heights.count.max(1);
    for (column, out) in columns.iter().zip(out.chunks_exact_mut(height)) {
        for (n, value) in out.iter_mut().enumerate() {
            let y = heights.first_m + n as f64 * heights.step_m;
            *value = relief.value(y, sum_at(lattice, octaves, column, y));
        }
    }
}

/// [`fill`] of columns that are too short to fill vectors: rows go along the columns then.
fn fill_short(
    regions: &[Region],
    Ground { relief, rows }: Ground<'_>,
    columns: &[Column],
    heights: Heights,
    out: &mut [f32],
) {
    let height = heights.count;
    let mut batch = Batch::new(1);
    for (columns, out) in columns.chunks(BLOCK).zip(out.chunks_mut(BLOCK * height)) {
        let vectors = columns.len().div_ceil(4);
        for row in 0..height {
            let y = heights.first_m + row as f64 * heights.step_m;
            let wave = rows.waves[row / 4][row % 4];
            let forms = |four: usize| {
                [0, 1, 2, 3].map(|n| columns[(4 * four + n).min(columns.len() - 1)].form)
            };
            let start = |four| Vec4::from(forms(four).map(|form| form.start(wave)));
            let mut axes = batch.restart(vectors, start);
            for n in 0..vectors * 4 {
                let column = &columns[n.min(columns.len() - 1)];
                let start = Ray::new(column, y, 0.0).start;
                for (axis, start) in axes.iter_mut().zip(start) {
                    axis[n] = start;
                }
            }
            for (n, region) in regions.iter().enumerate() {
                let share = |four| Vec4::from(forms(four).map(|form| form.waves[n]));
                region.add(&mut batch, share);
            }
            let base = Vec4::splat(rows.base_m[row / 4][row % 4]);
            for (&sum, out) in batch.finish().iter().zip(out.chunks_mut(4 * height)) {
                let values = relief.values(base, sum).to_array();
                for (column, value) in out.chunks_exact_mut(height).zip(values) {
                    column[row] = value;
                }
            }
        }
    }
}

/// The sum of the octaves at height `y` of a column: bit for bit what [`fill`] finds there.
pub(crate) fn sum_at(lattice: &Lattice, octaves: &[Octave], column: &Column, y: f64) -> f32 {
    let position = Ray::new(column, y, 0.0).start;
    let mut sum = column.form.start(terrace_wave(y));
    let waves = column.form.waves.to_array();
    for ((octave, wave), doublings) in octaves.iter().zip(waves).zip(0..) {
        let at = position.map(|p| (p << doublings) >> (64 - 8 - PART_BITS));
        let [x, y, z] = at.map(|p| fixed::part(p as u32));
        let cell = Cell::new(lattice, at.map(|p| (p >> PART_BITS) as u8));
        let corners = cell.corners(x, y, z, fade(z));
        let noise = blend([corners; 4], Vec4::splat(fade(x)), Vec4::splat(fade(y))).x;
        let half = octave.half_m();
        sum += wave * (noise * (half * SCALE)).clamp(-half, half);
    }
    sum
}

/// Where the columns of a block run, for each octave.
fn regions(
    lattice: &Lattice,
    octaves: &[Octave],
    columns: &[Column],
    heights: Heights,
) -> Option<Vec<Region>> {
    let first_m = heights.first_m;
    // Columns are worked on in whole fours.
    let rows = heights.count.next_multiple_of(4).max(1);
    let last_m = first_m + heights.step_m * (rows - 1) as f64;
    let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for column in columns {
        for y in [first_m, last_m] {
            let end = column.base + column.slope * y;
            (min, max) = (min.min(end), max.max(end));
        }
    }
    let octaves = octaves.iter().zip(0..);
    octaves
        .map(|(&octave, doublings)| Region::new(lattice, octave, doublings, min, max))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form::Form;
    use crate::lattice::table_seed;
    use crate::relief::Relief;
    use noise::{NoiseFn, Perlin};

    /// Columns through the lattice of the first octave of 0.6 times the axes' frequencies.
    fn columns() -> Vec<Column> {
        let column = |n: i32| {
            let t = f64::from(n);
            let base = DVec3::new(t * 7.3 - 900.0, 31.0 - t * 1.9, t * t * 0.03 - 2000.0);
            let slope = [DVec3::Y, DVec3::new(0.4, -0.7, 0.59)][(n % 2) as usize];
            let octave = Octave {
                frequency: 0.6,
                amplitude_m: 1.0,
            };
            Column {
                base: base * octave.frequencies(),
                slope: slope * octave.frequencies(),
                form: Form::PLAIN,
            }
        };
        (0..400).map(column).collect()
    }

    #[test]
    fn agrees_with_the_noise_crate_octave_by_octave() {
        let lattice = Lattice::new(77);
        let perlin = Perlin::new(table_seed(77));
        for doublings in 0..4 {
            // All octaves but one are silent.
            let octaves: Vec<_> = (0..4)
                .map(|n| Octave {
                    frequency: 0.0,
                    amplitude_m: if n == doublings { 2.0 } else { 0.0 },
                })
                .collect();
            for column in columns() {
                for y in -5..30 {
                    let y = f64::from(y);
                    let q = (column.base + column.slope * y) * f64::from(1 << doublings);
                    let expected = perlin.get(q.to_array());
                    let found = f64::from(sum_at(&lattice, &octaves, &column, y));
                    assert!((found - expected).abs() < 2e-6, "{q}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn blocks_of_columns_hold_what_single_samples_do() {
        let lattice = Lattice::new(3);
        let octaves = [8.0, 4.0, 2.0].map(|amplitude_m| Octave {
            frequency: 0.0,
            amplitude_m,
        });
        let relief = Relief::new([-7.0, 7.0], 0.0, Some((9.0, 5.0)));
        let far = columns();
        let near: Vec<_> = (0..30)
            .map(|n| Column {
                base: DVec3::new(0.02, 0.4, -0.3) * f64::from(n),
                slope: DVec3::new(0.03, 0.05, -0.01),
                form: Form {
                    waves: Vec4::new(0.4, 1.3, 0.02 * n as f32, 0.7),
                    fall_m: 0.1 * n as f32 - 1.0,
                    terraces: 0.5,
                },
            })
            .collect();
        for columns in [far, near] {
            for (first_m, step_m, height) in [
                (-11.0, 1.0, 35),
                (1.0, 8.0, 3),
                (4.25, 1.0, 1),
                (-2.0, 4.0, 2),
            ] {
                let rows = relief.rows(first_m, step_m, height);
                let mut out = vec![0.0; columns.len() * height];
                let heights = Heights {
                    first_m,
                    step_m,
                    count: height,
                };
                let ground = Ground {
                    relief: &relief,
                    rows: &rows,
                };
                fill(&lattice, &octaves, ground, &columns, heights, &mut out);
                for (column, found) in columns.iter().zip(out.chunks_exact(height)) {
                    for (n, &found) in found.iter().enumerate() {
                        let y = first_m + n as f64 * step_m;
                        let sum = sum_at(&lattice, &octaves, column, y);
                        assert_eq!(found, relief.value(y, sum), "{column:?} {y}");
                    }
                }
            }
        }
    }
}
