//! Decides from bounds alone whether a chunk can contain surface.
//!
//! Ground lies between two heights, so most layers of chunks are known to be air or ground. In
//! the layers that ground can reach into, the coarse octaves are looked at in a few nodes: in
//! between, a function strays from what its nodes enclose by no more than `h^2 / 8` times its
//! second derivative along each axis, which is bounded for the noise. Octaves that stray further
//! than they are high count with their full height.
//!
//! Of the chunks without surface in the layers just under and over the middle of flat worlds, all
//! are recognised so in the desert, the forest and the toxic land, nine in ten in the jungle and
//! three in four in the volcanic land, whose relief is greatest. On the sphere the ground's range
//! decides alone: ground is squeezed into so few layers that nearly all their chunks hold surface.

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, NoiseFrame};
use glam::{DVec2, DVec3, Vec4};

use crate::field::{FIELD_BAND_M, Field, RIM_REACH_M};
use crate::form::Form;
use crate::fractal::Octave;
use crate::upright::{self, Grid};

/// What a chunk of untouched ground holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Content {
    /// Only air, or nothing that is ever drawn: no sample of the block is solid, or the
    /// chunk lies past the rim of its hemisphere.
    Air,
    /// Only ground: every sample of the block is solid.
    Solid,
    /// Possibly some surface.
    Surface,
}

/// Room for the rounding of `f32` sums of noise.
const ROUNDING_M: f32 = 1e-3;
/// The second derivative of one octave of noise along an axis of the lattice is at most this: at
/// any place in a cell, the sum over the corners of the most that a gradient there adds.
pub(crate) const BEND: f64 = 14.0;
/// Before it is held to 1, noise is at most this.
const OVERSHOOT: f32 = 1.25;
/// From the first to the last sample of a chunk's block, metres.
const SPAN_M: f64 = 34.0;
/// Parts along x and z that a chunk is looked at in where columns differ in their forms.
const PARTS: u32 = 4;
/// Nodes along x and z that a chunk is looked at in, coarse ones first; whole vectors along z.
const STAGES: [[usize; 2]; 2] = [[8, 8], [18, 12]];

impl Field {
    /// What the chunk holds before any edit, its border of one sample included. Decided from
    /// the noise's bounds, in microseconds: `Air` and `Solid` are certain, `Surface` is not.
    pub fn content(&self, coord: ChunkCoord) -> Content {
        let land = self.land_content(coord);
        let first = coord.origin() - 1.0;
        if land == Content::Solid && self.is_hollow(coord.chart, first, first + SPAN_M) {
            Content::Surface
        } else {
            land
        }
    }

    /// [`Self::content`] as if there were no caves.
    fn land_content(&self, coord: ChunkCoord) -> Content {
        let bottom = f64::from(coord.index.y) * 32.0;
        let ends = [bottom - 1.0, bottom - 1.0 + SPAN_M];
        if !self.within_rim(coord) {
            return Content::Air;
        }
        let sums = self.relief().sums_m();
        if let Some(known) = self.known(sums, ends) {
            return known;
        }
        let NoiseFrame::Square(_) = self.strategy().noise_frame(coord.chart) else {
            return Content::Surface;
        };
        let corner = self.noise_corner(coord.chart, coord.origin() - 1.0);
        let Some(climate) = self.climate() else {
            let span = Span {
                corner,
                edge_m: SPAN_M,
                octaves: self.octaves().to_vec(),
                middle_m: 0.0,
                unsure_m: 0.0,
                sums,
            };
            return self.looked_at(&span, ends);
        };
        // Forms differ less in a part.
        let edge_m = SPAN_M / f64::from(PARTS);
        let mut parts = (0..PARTS * PARTS).map(|n| {
            let (x, z) = (f64::from(n % PARTS), f64::from(n / PARTS));
            let corner = corner + DVec3::new(x, 0.0, z) * edge_m;
            let forms = climate.forms(corner, edge_m);
            let span = Span::of(self.octaves(), &forms, corner, edge_m);
            let known = self.known(span.sums, ends);
            known.unwrap_or_else(|| self.looked_at(&span, ends))
        });
        let first = parts.next().unwrap_or(Content::Surface);
        if first != Content::Surface && parts.all(|other| other == first) {
            first
        } else {
            Content::Surface
        }
    }

    /// What lies between two heights where sums of noise lie between these, if that is all one.
    fn known(&self, [least, most]: [f32; 2], [first, last]: [f64; 2]) -> Option<Content> {
        let relief = self.relief();
        if relief.value(first, least) > ROUNDING_M {
            Some(Content::Air)
        } else if relief.value(last, most) < -ROUNDING_M {
            Some(Content::Solid)
        } else {
            None
        }
    }

    /// What there is between two heights, by a look at the noise.
    fn looked_at(&self, span: &Span, [first, last]: [f64; 2]) -> Content {
        let [low, high] = self.relief().heights_m(span.sums);
        if first >= low && self.is_all(false, span, [first, last.min(high)]) {
            Content::Air
        } else if last <= high && self.is_all(true, span, [first.max(low), last]) {
            Content::Solid
        } else {
            Content::Surface
        }
    }

    /// Whether all samples between two heights are certainly solid, or certainly not.
    fn is_all(&self, solid: bool, span: &Span, mut heights: [f64; 2]) -> bool {
        let end = if solid { heights[1] } else { heights[0] };
        let middle = (span.corner + span.edge_m / 2.0).with_y(end);
        let sample = self.land_square(middle);
        if (sample < 0.0) != solid {
            return false;
        }
        for stage in STAGES {
            match self.doubtful((solid, sample.abs()), span, heights, stage) {
                Doubt::None => return true,
                Doubt::Between(low, high) => heights = [low, high],
                Doubt::Lost => return false,
            }
        }
        false
    }

    /// The least corner of a chunk's samples in noise space, given that in the chart.
    fn noise_corner(&self, chart: ChartId, corner: DVec3) -> DVec3 {
        let point = |pos| self.strategy().noise_point(ChartPoint::new(chart, pos));
        point(corner).min(point(corner + SPAN_M))
    }

    /// Where between two heights samples may not all be as asked, by nodes of a stage. `clear_m` says how surely the middle of
    /// the end next to the surface is as asked: a stage that could not even tell that is left out.
    fn doubtful(
        &self,
        (solid, clear_m): (bool, f32),
        span: &Span,
        [low, high]: [f64; 2],
        [width, depth]: [usize; 2],
    ) -> Doubt {
        let Span { corner, edge_m, .. } = *span;
        let rows = ((high - low) * (width - 1) as f64 / SPAN_M).ceil().max(1.0);
        let counts = [width, rows as usize + 1, depth];
        let spans = DVec3::new((width - 1) as f64, rows, (depth - 1) as f64);
        let step_m = DVec3::new(edge_m, high - low, edge_m) / spans;
        let (coarse, strays_m, unknown_m) = span.coarse(step_m);
        let sign = if solid { -1.0 } else { 1.0 };
        let relief = self.relief();
        if clear_m <= (strays_m + unknown_m).min(0.99 * FIELD_BAND_M) {
            return Doubt::Between(low, high);
        }
        let held = if solid {
            [-1.0, OVERSHOOT]
        } else {
            [-OVERSHOOT, 1.0]
        };
        let grid = Grid {
            first: DVec3::new(corner.x, low, corner.z),
            step_m,
            counts,
        };
        let [least, most] = upright::extremes(self.lattice(), coarse, held, &grid);

        let at = |row: usize| low + row as f64 * step_m.y;
        let mut doubt: Option<(f64, f64)> = None;
        for row in 0..rows as usize {
            let (edge, other, worst) = if solid {
                (row + 1, row, most[row].max(most[row + 1]))
            } else {
                (row, row + 1, least[row].min(least[row + 1]))
            };
            let worst = span.middle_m + worst;
            let value = |row, slack| sign * relief.value(at(row), worst + sign * slack);
            if value(other, unknown_m) < 0.0 {
                return Doubt::Lost;
            }
            if value(edge, -strays_m - unknown_m) <= ROUNDING_M {
                let from = doubt.map_or(at(row), |(from, _)| from);
                doubt = Some((from, at(row + 1)));
            }
        }
        doubt.map_or(Doubt::None, |(low, high)| Doubt::Between(low, high))
    }

    /// Whether any cell of the chunk touches the part of its chart that is meshed.
    fn within_rim(&self, coord: ChunkCoord) -> bool {
        let low = DVec2::new(f64::from(coord.index.x), f64::from(coord.index.z)) * 32.0;
        self.domain(coord.chart).least_outside_m(low, low + 32.0) <= RIM_REACH_M
    }
}

/// What a square of columns makes of the octaves.
struct Span {
    /// Its least corner in noise space, and its edge, metres.
    corner: DVec3,
    edge_m: f64,
    /// As high as they are in its middle form.
    octaves: Vec<Octave>,
    /// How far the ground of that lies below the middle of the world's, metres.
    middle_m: f32,
    /// By how much other columns' sums may differ from what that gives, metres.
    unsure_m: f32,
    /// Between which all sums are, metres.
    sums: [f32; 2],
}

impl Span {
    /// For columns whose forms lie between these.
    fn of(octaves: &[Octave], [least, most]: &[Form; 2], corner: DVec3, edge_m: f64) -> Self {
        let waves = 0.5 * (least.waves + most.waves);
        let octaves = octaves.iter().zip(waves.to_array());
        let octaves = octaves.map(|(octave, wave)| Octave {
            amplitude_m: octave.amplitude_m * f64::from(wave),
            ..*octave
        });
        let [_, most_m] = most.sums(Vec4::ONE);
        let around_m = most_m - most.fall_m;
        let terraces_m = around_m - most.waves.element_sum();
        let apart = (most.waves - least.waves).element_sum() + most.fall_m - least.fall_m;
        Self {
            corner,
            edge_m,
            octaves: octaves.collect(),
            middle_m: f32::midpoint(least.fall_m, most.fall_m),
            unsure_m: 0.5 * apart + terraces_m,
            sums: [least.fall_m - around_m, most_m],
        }
    }

    /// The octaves that nodes so far apart tell something of, how far their sum strays between
    /// the nodes, and how far from zero the rest of the octaves is at most, metres.
    fn coarse(&self, step_m: DVec3) -> (&[Octave], f32, f32) {
        let octaves = &self.octaves;
        let strays_m = |octave: &Octave| {
            let steps = octave.frequencies() * step_m;
            BEND / 8.0 * steps.length_squared() * f64::from(octave.half_m())
        };
        let tells = |octave: &&Octave| strays_m(octave) < f64::from(octave.half_m());
        let count = octaves.iter().take_while(tells).count();
        let (coarse, fine) = octaves.split_at(count);
        let strays: f64 = coarse.iter().map(strays_m).sum();
        let unknown: f32 = fine.iter().map(|octave| octave.half_m()).sum();
        (coarse, strays as f32, unknown + self.unsure_m)
    }
}

/// Whether samples are as asked.
enum Doubt {
    /// All are.
    None,
    /// All are, but perhaps between these heights.
    Between(f64, f64),
    /// Some are not.
    Lost,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lattice::fade;

    /// The weight of a lattice point, with its first two derivatives, at a distance of up to 1.
    fn weight(t: f64) -> [f64; 3] {
        let (s, sign) = (t.abs(), t.signum());
        [
            1.0 - f64::from(fade(s as f32)),
            -sign * 30.0 * (s * (1.0 - s)).powi(2),
            -60.0 * s * (1.0 - s) * (1.0 - 2.0 * s),
        ]
    }

    /// The most that gradients of a cell's corners add up to at a place: noise before it is held,
    /// and its second derivative along x. The corners' gradients are anything's.
    fn most(place: [f64; 3]) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for corner in 0..8 {
            let at = [0, 1, 2].map(|axis| place[axis] - f64::from(corner >> axis & 1));
            let [x, y, z] = at.map(weight);
            let rest = y[0] * z[0];
            let mut found = [0.0_f64; 2];
            for (plus, minus) in [(0, 1), (0, 2), (1, 2)] {
                for signs in 0..4 {
                    let mut g = [0.0; 3];
                    g[plus] = 1.0 - f64::from(signs & 1) * 2.0;
                    g[minus] = 1.0 - f64::from(signs & 2);
                    let dot: f64 = (0..3).map(|axis| g[axis] * at[axis]).sum();
                    found[0] = found[0].max(x[0] * rest * dot);
                    found[1] = found[1].max((rest * (x[2] * dot + 2.0 * x[1] * g[0])).abs());
                }
            }
            sums = [sums[0] + found[0], sums[1] + found[1]];
        }
        sums.map(|sum| sum * 2.0 / 3.0_f64.sqrt())
    }

    #[test]
    fn noise_bends_and_overshoots_no_more_than_said() {
        const N: i32 = 40;
        let mut greatest = [0.0_f64; 2];
        for n in 0..(N + 1).pow(3) {
            let place = [n % (N + 1), n / (N + 1) % (N + 1), n / (N + 1).pow(2)];
            let found = most(place.map(|c| f64::from(c) / f64::from(N)));
            greatest = [greatest[0].max(found[0]), greatest[1].max(found[1])];
        }
        let [value, bend] = greatest;
        assert!(
            value > 1.1 && value < 0.99 * f64::from(OVERSHOOT),
            "{value}"
        );
        assert!(bend > 12.0 && bend < 0.998 * BEND, "{bend}");
    }
}
