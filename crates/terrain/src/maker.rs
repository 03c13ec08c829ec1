//! Vertices: where the ground crosses an edge of the lattice, with normal and colour.

use std::cell::Cell;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use glam::{DVec3, IVec3, Vec3, Vec4};

use crate::colour::Painter;
use crate::field::Field;
use crate::kind::{Kind, SKIN, number_of, under_sky};
use crate::mesh::{PARTS_PER_M, Vertex, octahedral};
use crate::samples::{Covered, Samples};
use crate::strata::{Strata, depth_m};

/// Vertices keep this many parts away from the ends of their edge, so that ground through a
/// sample gives small triangles, never empty ones that would have to be cut out of a closed
/// surface.
const END_PARTS: f32 = 64.0;

/// Where the field is zero between the samples at an edge's lower and upper end: parts from the
/// lower, of the edge's own length. Samples that are not finite still give a place on it.
#[inline]
pub(crate) fn place_on_edge(low: f32, high: f32, length: u32) -> u32 {
    let length = length as f32;
    let parts = length * low / (low - high);
    if parts.is_nan() {
        (0.5 * length) as u32
    } else {
        // Rounded without a call: it is positive.
        (parts.clamp(END_PARTS, length - END_PARTS) + 0.5) as u32
    }
}

/// Makes the vertices of one chunk.
#[derive(Debug)]
pub(crate) struct Maker<'a> {
    samples: &'a Samples,
    coord: ChunkCoord,
    origin: DVec3,
    painter: Painter<'a>,
    strata: Strata<'a>,
    /// Parts along an edge of a cell.
    length: u32,
    /// Of squares of a step in one of a metre.
    per_step2: f32,
    /// How far apart in the block a sample's neighbours along x, y and z are.
    strides: [usize; 3],
    /// By column the corner whose kind was asked for last, one more in the high byte, and that kind: the edges of a
    /// corner follow each other, and most have one solid end.
    kinds: Box<[Cell<u16>]>,
}

/// Corners along an edge of a chunk at full resolution.
const CORNERS: usize = CHUNK_CELLS as usize + 1;

impl<'a> Maker<'a> {
    pub(crate) fn new(samples: &'a Samples, field: &'a Field, coord: ChunkCoord) -> Self {
        let side = samples.side();
        Self {
            samples,
            coord,
            origin: coord.origin(),
            painter: Painter::new(field),
            strata: Strata::new(field, coord),
            length: samples.level().step_m() * PARTS_PER_M,
            per_step2: (samples.level().step_m() as f32).powi(-2),
            strides: [side * side, 1, side],
            kinds: vec![Cell::new(0); CORNERS * CORNERS].into_boxed_slice(),
        }
    }

    pub(crate) fn samples(&self) -> &Samples {
        self.samples
    }

    /// The vertex on the edge that runs from a corner along an axis.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    pub(crate) fn on_edge(&self, corner: [usize; 3], axis: usize) -> Vertex {
        let [i, j, k] = corner;
        let low = self.samples.index(i + 1, j + 1, k + 1);
        let high = low + self.strides[axis];
        let values = self.samples.values();
        let place = place_on_edge(values[low], values[high], self.length);
        let mut at = corner.map(|c| c as u32 * self.length);
        at[axis] += place;
        let share = place as f32 / self.length as f32;
        let slope = self.slope(low);
        let slope = slope + (self.slope(high) - slope) * share;
        let mut solid = corner;
        let mut air = corner;
        let is_upward = usize::from(values[low] >= 0.0);
        solid[axis] += is_upward;
        air[axis] += 1 - is_upward;
        self.finished(at, slope.truncate(), self.kind_byte(solid, air), slope.w)
    }

    /// What the fourth byte of a vertex says: the kind of a solid corner and the sky that is left in the air beside it. The
    /// corner lies up to a step below the surface, which is its skin wherever that air was never ground.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn kind_byte(&self, solid: [usize; 3], air: [usize; 3]) -> u8 {
        if !self.samples.is_untouched() {
            let depth = self.covered(air).depth;
            return under_sky(self.kind_of(solid, depth), depth_m(depth));
        }
        let [i, j, k] = solid;
        let known = &self.kinds[i * CORNERS + k];
        let tag = (j as u16 + 1) << 8;
        if known.get() & 0xff00 == tag {
            return known.get() as u8;
        }
        let byte = self.strata.at(self.sample_at(solid), 0);
        known.set(tag | u16::from(byte));
        byte
    }

    fn covered(&self, corner: [usize; 3]) -> Covered {
        let [i, j, k] = corner.map(|c| c + 1);
        self.samples.covered(self.samples.index(i, j, k))
    }

    /// Whole metres from the chunk's origin to a corner.
    fn sample_at(&self, corner: [usize; 3]) -> IVec3 {
        let step_m = self.samples.level().step_m() as i32;
        IVec3::from(corner.map(|c| c as i32)) * step_m
    }

    /// The kind of a corner, no deeper than that.
    fn kind_of(&self, corner: [usize; 3], most_deep: u8) -> u8 {
        let Covered { depth, laid } = self.covered(corner);
        if laid > 0 {
            return Kind::of_byte(laid).unwrap_or(Kind::PLAIN).byte();
        }
        self.strata.at(self.sample_at(corner), depth.min(most_deep))
    }

    /// The kind of the solid corner of a place's cell that is nearest to it, or else of the nearest: no deeper than any of
    /// that cell's corners, whose least depth tells the sky too.
    pub(crate) fn kind_near(&self, place: [u32; 3]) -> u8 {
        let last = self.samples.level().cells() as u32 - 1;
        let low = place.map(|p| (p / self.length).min(last));
        let corners = (0..8_u32).map(|n| std::array::from_fn(|axis| low[axis] + (n >> axis & 1)));
        let order = |corner: &[u32; 3]| {
            let [i, j, k] = corner.map(|c| c as usize + 1);
            let away = |axis: usize| u64::from(place[axis].abs_diff(corner[axis] * self.length));
            let far = (0..3).map(|axis| away(axis).pow(2)).sum::<u64>();
            (self.samples.get(i, j, k) >= 0.0, far)
        };
        let depths = corners
            .clone()
            .map(|corner| self.covered(corner.map(|c| c as usize)).depth);
        let least = depths.min().unwrap_or(0);
        let nearest = corners.min_by_key(order).unwrap_or(low);
        let kind = self.kind_of(nearest.map(|c| c as usize), least);
        under_sky(kind, depth_m(least))
    }

    /// A vertex anywhere in the chunk, in parts, with the normal of the field between the samples.
    pub(crate) fn at(&self, place: [u32; 3]) -> Vertex {
        let local = DVec3::from(place.map(f64::from)) / f64::from(PARTS_PER_M);
        let half = 0.5 * f64::from(self.samples.level().step_m());
        let rise = |axis: DVec3| {
            self.samples.density(local + axis * half) - self.samples.density(local - axis * half)
        };
        let normal = Vec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z));
        self.finished(place, normal, self.kind_near(place), 0.0)
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn finished(&self, place: [u32; 3], normal: Vec3, kind: u8, bend: f32) -> Vertex {
        let normal = normal.normalize_or(Vec3::Y);
        let local = DVec3::from(place.map(f64::from)) / f64::from(PARTS_PER_M);
        let point = ChartPoint {
            chart: self.coord.chart,
            pos: self.origin + local,
        };
        let hollow = bend * self.per_step2;
        let colour = self.painter.paint(point, normal, kind, hollow);
        Vertex::at(place, octahedral(normal), colour)
    }

    /// Twice the field's gradient at a sample, by central differences, per step; and last how hollow the ground is there, the
    /// Laplacian with its sign turned, per square of a step.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn slope(&self, at: usize) -> Vec4 {
        let values = self.samples.values();
        let [x, y, z] = self.strides;
        let above = Vec4::new(values[at + x], values[at + y], values[at + z], 0.0);
        let below = Vec4::new(values[at - x], values[at - y], values[at - z], 0.0);
        let both = above + below;
        (above - below).with_w(6.0 * values[at] - (both.x + both.y + both.z))
    }
}

impl Samples {
    /// The kind of a sample by its whole metres from the chunk's origin, each 0 to 32; untouched, by its own depth.
    pub fn kind_of_sample(&self, field: &Field, coord: ChunkCoord, local: IVec3) -> Kind {
        let step = self.level().step_m() as i32;
        let corner = (local / step).to_array().map(|c| c.max(0) as usize);
        let byte = Maker::new(self, field, coord).kind_of(corner, u8::MAX);
        Kind::of_byte(number_of(byte)).unwrap_or(Kind::PLAIN)
    }

    /// The kind of the ground at a place, metres from the chunk's origin, of a surface with this unit normal: that of the
    /// solid corner of its cell which is nearest.
    pub fn kind(&self, field: &Field, coord: ChunkCoord, local: DVec3, normal: Vec3) -> Kind {
        let place = (local * f64::from(PARTS_PER_M))
            .to_array()
            .map(|part| part.max(0.0) as u32);
        let maker = Maker::new(self, field, coord);
        let byte = maker.kind_near(place);
        let kind = Kind::of_byte(number_of(byte)).unwrap_or(Kind::PLAIN);
        let point = ChartPoint::new(coord.chart, coord.origin() + local);
        if byte >= SKIN && maker.painter.shares(point, normal).rock > 0.5 {
            kind.where_steep()
        } else {
            kind
        }
    }
}
