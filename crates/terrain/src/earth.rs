//! How much ground edits move, by kind: what was solid before and is air now was dug, and what became solid was built.
//!
//! Volumes are those of the meshes. In each cell the solid part of marching cubes is a closed body, whose volume follows
//! from its surface by Gauss: with the field (0, y, 0) only the triangles and the solid part of the cell's top count.
//! Only cells with a corner that has changed are looked at. A cell's volume goes to the kinds of the corners that made it.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord};
use glam::{DVec2, DVec3, IVec3, Vec3, Vec3Swizzles};

use crate::edits::{ChunkEdits, EDIT_STEP};
use crate::field::Field;
use crate::kind::{Kind, SKIN};
use crate::samples::Samples;
use crate::strata::Strata;
use crate::tables::{EDGES, TRIANGLES};

pub(crate) const KINDS: usize = Kind::ALL.len();
const CELLS: usize = 32;
/// Parts of a cell less than this are rounding, cubic metres.
const LEAST_M3: f64 = 1e-6;
/// A corner's part in a cell that moved without it.
const LEAST_SHARE: f32 = 1e-6;

/// Ground that was dug and built, in cubic metres of the space, by kind.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Earth {
    dug_m3: [f64; KINDS],
    built_m3: [f64; KINDS],
}

impl Earth {
    /// How much of a kind was dug, cubic metres.
    pub fn dug_m3(&self, kind: Kind) -> f64 {
        self.dug_m3[at(kind)]
    }

    /// How much of a kind was built, cubic metres.
    pub fn built_m3(&self, kind: Kind) -> f64 {
        self.built_m3[at(kind)]
    }

    /// What was dug less what was built, of all kinds, cubic metres.
    pub fn gained_m3(&self) -> f64 {
        self.dug_m3.iter().sum::<f64>() - self.built_m3.iter().sum::<f64>()
    }

    /// Whether nothing was moved.
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }

    /// Adds what was moved besides.
    pub fn add(&mut self, other: &Self) {
        let pairs = self.both_mut().zip(other.both());
        pairs.for_each(|(sum, more)| *sum += more);
    }

    /// Takes back what was moved and is no longer; nothing is left of less than can be measured.
    pub fn take_back(&mut self, other: &Self) {
        for (sum, less) in self.both_mut().zip(other.both()) {
            *sum -= less;
            if sum.abs() < LEAST_M3 {
                *sum = 0.0;
            }
        }
    }

    fn both(&self) -> impl Iterator<Item = f64> {
        self.dug_m3.into_iter().chain(self.built_m3)
    }

    fn both_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.dug_m3.iter_mut().chain(&mut self.built_m3)
    }
}

pub(crate) fn at(kind: Kind) -> usize {
    usize::from(kind.byte()) - 1
}

/// Cells of a chunk, by `i * 32 + k` those of a column as bits.
#[derive(Debug, Clone)]
pub struct Cells(Box<[u32; CELLS * CELLS]>);

impl Default for Cells {
    fn default() -> Self {
        Self(Box::new([0; CELLS * CELLS]))
    }
}

/// The cells of each chunk with a corner whose edit differs between two states of chunks.
pub fn changed_cells<'a>(
    chunks: impl Iterator<Item = (ChunkCoord, &'a ChunkEdits, &'a ChunkEdits)>,
) -> BTreeMap<ChunkCoord, Cells> {
    let mut found = BTreeMap::new();
    for (coord, before, after) in chunks {
        before.each_changed_column(after, |i, k, mask| {
            for (di, dk) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let (x, z) = (i as i32 - di, k as i32 - dk);
                mark(&mut found, coord, [x, 0, z], mask | mask >> 1);
                if mask & 1 != 0 {
                    mark(&mut found, coord, [x, -1, z], 1 << 31);
                }
            }
        });
    }
    found
}

/// Marks cells of the column over a cell of a chunk, or of one beside it.
fn mark(
    found: &mut BTreeMap<ChunkCoord, Cells>,
    coord: ChunkCoord,
    [x, y, z]: [i32; 3],
    bits: u32,
) {
    let beside = IVec3::new(x.div_euclid(32), y, z.div_euclid(32));
    let owner = ChunkCoord {
        chart: coord.chart,
        index: coord.index.saturating_add(beside),
    };
    let column = x.rem_euclid(32) as usize * CELLS + z.rem_euclid(32) as usize;
    found.entry(owner).or_default().0[column] |= bits;
}

/// The edits of a chunk and of those beyond its upper faces, by their offset's bits: x, y, z.
pub type Owners = [Option<Arc<ChunkEdits>>; 8];

/// What is needed to tell what was moved in the cells of one chunk.
#[derive(Debug)]
pub struct Moved<'a> {
    /// The ground before all edits.
    pub field: &'a Field,
    /// The chunk.
    pub coord: ChunkCoord,
    /// Its untouched samples.
    pub base: &'a Samples,
    /// The edits before.
    pub before: Owners,
    /// The edits now.
    pub after: Owners,
}

/// A corner of a cell before and after.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    values: [f32; 2],
    laid: [u8; 2],
    depth: u8,
}

impl Moved<'_> {
    /// What was moved in these cells. `share` is how many cubic metres of the space a cubic metre of the chart is there.
    /// What lies beyond the chart's domain is another chart's to tell.
    pub fn earth(&self, cells: &Cells, share: &dyn Fn(ChartPoint) -> f64) -> Earth {
        let strata = Strata::new(self.field, self.coord);
        let domain = self.field.strategy().domain(self.coord.chart);
        let mut earth = Earth::default();
        for (column, mask) in cells.0.iter().enumerate().filter(|(_, mask)| **mask != 0) {
            let (i, k) = (column / CELLS, column % CELLS);
            let middle = self.coord.origin() + DVec3::new(i as f64 + 0.5, 0.5, k as f64 + 0.5);
            // Of a cell that the domain's edge cuts about the part inside counts.
            let inside = (0.5 - domain.outside_m(DVec2::new(middle.x, middle.z))).min(1.0);
            if inside <= 0.0 {
                continue;
            }
            let first = mask.trailing_zeros() as usize;
            let last = 31 - mask.leading_zeros() as usize;
            let columns = [(0, 0), (1, 0), (0, 1), (1, 1)]
                .map(|(di, dk)| self.column([i + di, k + dk], first..=last + 1));
            for j in (first..=last).filter(|j| mask >> j & 1 == 1) {
                let corner = |c: usize| columns[c & 1 | c >> 1 & 2][j + (c >> 1 & 1)];
                let corners: [Corner; 8] = std::array::from_fn(corner);
                let [before, after] = [0, 1].map(|n| solid_share(&corners.map(|c| c.values[n])));
                let dug = before - after;
                if dug.abs() < LEAST_M3 {
                    continue;
                }
                let place = ChartPoint::new(self.coord.chart, middle + DVec3::Y * j as f64);
                let m3 = dug * inside * share(place);
                enter(&mut earth, m3, &corners, &strata, [i, j, k]);
            }
        }
        earth
    }

    /// The corners of a column in a range of heights.
    fn column(&self, [i, k]: [usize; 2], range: std::ops::RangeInclusive<usize>) -> [Corner; 33] {
        let (low, high) = self.base.editable_y_m();
        let mut found = [Corner::default(); 33];
        for j in range {
            let at = self.base.index(i + 1, j + 1, k + 1);
            let base = self.base.get(i + 1, j + 1, k + 1);
            let land = self.base.covered(at);
            let y = self.coord.origin().y + j as f64;
            let mut corner = Corner {
                values: [base; 2],
                laid: [land.laid; 2],
                depth: land.depth,
            };
            if y >= low && y <= high {
                let owner = i >> 5 | j >> 5 << 1 | k >> 5 << 2;
                for (n, owners) in [&self.before, &self.after].into_iter().enumerate() {
                    if let Some(edits) = &owners[owner] {
                        let (i, j, k) = (i & 31, j & 31, k & 31);
                        corner.values[n] += f32::from(edits.get(i, j, k)) * EDIT_STEP;
                        let laid = edits.kind_byte(i, j, k);
                        if laid != 0 {
                            corner.laid[n] = laid;
                        }
                    }
                }
            }
            found[j] = corner;
        }
        found
    }
}

/// Enters what was dug in a cell, or built, under the kinds of the corners that changed for it.
fn enter(
    earth: &mut Earth,
    m3: f64,
    corners: &[Corner; 8],
    strata: &Strata<'_>,
    [i, j, k]: [usize; 3],
) {
    // Dug ground is of the kinds that were there, built ground of those that are.
    let (when, sense) = if m3 > 0.0 { (0, 1.0) } else { (1, -1.0) };
    // Where corners have turned, the rest of the cell is what it was.
    let turned = |corner: &Corner| (corner.values[0] < 0.0) != (corner.values[1] < 0.0);
    let is_solid = |corner: &Corner| corner.values[when] < 0.0;
    let any_turned = corners.iter().any(|it| is_solid(it) && turned(it));
    let change = |corner: &Corner| (sense * (corner.values[1] - corner.values[0])).max(0.0);
    let part = |c: usize| {
        let corner = &corners[c];
        if !is_solid(corner) || (any_turned && !turned(corner)) {
            return 0.0;
        }
        // Where none has turned, surfaces have moved along edges that end in air, by what has changed at either end.
        let ends = [1, 2, 4].map(|axis: usize| &corners[c ^ axis]);
        let beside = ends.into_iter().filter(|end| !any_turned && !is_solid(end));
        change(corner) + beside.map(change).sum::<f32>() + LEAST_SHARE
    };
    let whole: f32 = (0..8).map(part).sum();
    let sums = if m3 > 0.0 {
        &mut earth.dug_m3
    } else {
        &mut earth.built_m3
    };
    for (c, corner) in corners.iter().enumerate() {
        let part = part(c);
        if part <= 0.0 {
            continue;
        }
        let kind = match corner.laid[when] {
            0 => {
                let place = [i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)];
                let place = IVec3::from(place.map(|c| c as i32));
                Kind::of_byte(strata.at(place, corner.depth) & !SKIN)
            }
            laid => Kind::of_byte(laid),
        };
        sums[at(kind.unwrap_or(Kind::PLAIN))] += m3.abs() * f64::from(part / whole);
    }
}

/// How much of a cell is solid, 0 to 1, by the values of its corners as [`crate::tables`] numbers them.
fn solid_share(values: &[f32; 8]) -> f64 {
    let case = (0..8).fold(0, |case, c| case | usize::from(values[c] < 0.0) << c);
    if case == 0 || case == 255 {
        return if case == 0 { 0.0 } else { 1.0 };
    }
    let points = EDGES.map(|edge| {
        let low = Vec3::new(
            (edge.corner & 1) as f32,
            (edge.corner >> 1 & 1) as f32,
            (edge.corner >> 2) as f32,
        );
        low + Vec3::AXES[edge.axis]
            * crossing(values[edge.corner], values[edge.corner + (1 << edge.axis)])
    });
    let mut sum = top_area([2, 3, 7, 6].map(|c: usize| values[c]));
    for triangle in TRIANGLES[case].as_chunks::<3>().0 {
        let [a, b, c] = triangle.map(|edge| points[usize::from(edge)]);
        let (ab, ac) = ((b - a).xz(), (c - a).xz());
        let upward = 0.5 * (ab.y * ac.x - ab.x * ac.y);
        sum += upward * (a.y + b.y + c.y) / 3.0;
    }
    f64::from(sum)
}

/// Where the ground crosses between two values, 0 to 1 from the first; half way where they are no numbers.
fn crossing(from: f32, to: f32) -> f32 {
    let share = from / (from - to);
    if share.is_nan() {
        0.5
    } else {
        share.clamp(0.0, 1.0)
    }
}

/// The solid part of a unit square whose corners have these values in the order about it. As in [`crate::tables`], solid
/// corners that share no edge are kept apart.
fn top_area(values: [f32; 4]) -> f32 {
    const CORNERS: [[f32; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let is_solid = values.map(|value| value < 0.0);
    let between = |n: usize| crossing(values[n], values[(n + 1) % 4]);
    if is_solid == [true, false, true, false] || is_solid == [false, true, false, true] {
        let cut = |n: usize| 0.5 * between(n) * (1.0 - between((n + 3) % 4));
        return (0..4).filter(|n| is_solid[*n]).map(cut).sum();
    }
    let mut outline = [[0.0; 2]; 8];
    let mut count = 0;
    for n in 0..4 {
        if is_solid[n] {
            outline[count] = CORNERS[n];
            count += 1;
        }
        if is_solid[n] != is_solid[(n + 1) % 4] {
            let (a, b, t) = (CORNERS[n], CORNERS[(n + 1) % 4], between(n));
            outline[count] = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            count += 1;
        }
    }
    let side = |n: usize| {
        let ([ax, ay], [bx, by]) = (outline[n], outline[(n + 1) % count]);
        ax * by - bx * ay
    };
    0.5 * (0..count).map(side).sum::<f32>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_cuts_off_of_a_cell_what_lies_below_it() {
        for (normal, height, expected) in [
            (Vec3::Y, 0.25, 0.25),
            (Vec3::X, 0.7, 0.7),
            (Vec3::Z, 0.4, 0.4),
            (Vec3::new(1.0, 1.0, 0.0), 1.0, 0.5),
            (Vec3::new(1.0, 1.0, 1.0), 1.5, 0.5),
            (Vec3::ONE, 0.5, 0.125 / 6.0),
            (Vec3::NEG_ONE, -2.5, 0.125 / 6.0),
        ] {
            let values = std::array::from_fn(|c| {
                let corner = Vec3::new((c & 1) as f32, (c >> 1 & 1) as f32, (c >> 2) as f32);
                normal.dot(corner) - height
            });
            let found = solid_share(&values);
            assert!(
                (found - expected).abs() < 1e-6,
                "{normal} {height}: {found}"
            );
        }
        assert_eq!(solid_share(&[-1.0; 8]), 1.0);
        assert_eq!(solid_share(&[1.0; 8]), 0.0);
    }

    #[test]
    fn what_is_taken_back_leaves_nothing() {
        let mut sum = Earth::default();
        let mut more = Earth::default();
        more.dug_m3[0] = 0.1;
        more.built_m3[6] = 0.3;
        for _ in 0..3 {
            sum.add(&more);
        }
        assert!((sum.gained_m3() + 0.6).abs() < 1e-12 && !sum.is_nothing());
        for _ in 0..3 {
            sum.take_back(&more);
        }
        assert!(sum.is_nothing(), "{sum:?}");
    }
}
