//! Vertices: where the ground crosses an edge of the lattice, with normal and colour.

use antipode_geometry::{ChartPoint, ChunkCoord};
use glam::{DVec3, Vec3};

use crate::colour::Painter;
use crate::field::Field;
use crate::mesh::{PARTS_PER_M, Vertex, octahedral};
use crate::samples::Samples;

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
    /// Parts along an edge of a cell.
    length: u32,
    /// How far apart in the block a sample's neighbours along x, y and z are.
    strides: [usize; 3],
}

impl<'a> Maker<'a> {
    pub(crate) fn new(samples: &'a Samples, field: &'a Field, coord: ChunkCoord) -> Self {
        let side = samples.side();
        Self {
            samples,
            coord,
            origin: coord.origin(),
            painter: Painter::new(field),
            length: samples.level().step_m() * PARTS_PER_M,
            strides: [side * side, 1, side],
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
        let normal = slope + (self.slope(high) - slope) * share;
        self.finished(at, normal)
    }

    /// A vertex anywhere in the chunk, in parts, with the normal of the field between the samples.
    pub(crate) fn at(&self, place: [u32; 3]) -> Vertex {
        let local = DVec3::from(place.map(f64::from)) / f64::from(PARTS_PER_M);
        let half = 0.5 * f64::from(self.samples.level().step_m());
        let rise = |axis: DVec3| {
            self.samples.density(local + axis * half) - self.samples.density(local - axis * half)
        };
        let normal = Vec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z));
        self.finished(place, normal)
    }

    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn finished(&self, place: [u32; 3], normal: Vec3) -> Vertex {
        let normal = normal.normalize_or(Vec3::Y);
        let local = DVec3::from(place.map(f64::from)) / f64::from(PARTS_PER_M);
        let point = ChartPoint {
            chart: self.coord.chart,
            pos: self.origin + local,
        };
        let colour = self.painter.paint(point, normal);
        Vertex::at(place, octahedral(normal), colour)
    }

    /// Twice the field's gradient at a sample, by central differences, per step.
    #[inline]
    fn slope(&self, at: usize) -> Vec3 {
        let values = self.samples.values();
        let [x, y, z] = self
            .strides
            .map(|stride| values[at + stride] - values[at - stride]);
        Vec3::new(x, y, z)
    }
}
