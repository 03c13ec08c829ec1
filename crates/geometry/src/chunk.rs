//! Chunks: the cubes of 32 cells that terrain is made, saved and drawn in.

use glam::{DVec3, IVec3};
use std::cmp::Ordering;

use crate::{ChartId, ChartPoint};

/// Cells along each edge of a chunk; a cell is one metre.
pub const CHUNK_CELLS: i32 = 32;

/// A chunk's place: chart and index in whole chunks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct ChunkCoord {
    /// The chart the chunk lies in.
    pub chart: ChartId,
    /// Index in chunks: the chunk covers `32 * index ..= 32 * (index + 1)` metres.
    pub index: IVec3,
}

impl ChunkCoord {
    /// The chunk with that index in that chart.
    pub const fn new(chart: ChartId, index: IVec3) -> Self {
        Self { chart, index }
    }

    /// The chunk that holds the point. Points on a shared face belong to the chunk above it.
    /// Places beyond the range of `i32` chunks saturate.
    pub fn containing(point: ChartPoint) -> Self {
        let index = (point.pos / f64::from(CHUNK_CELLS)).floor();
        Self::new(point.chart, index.as_ivec3())
    }

    /// The corner with the smallest coordinates, in chart metres.
    pub fn origin(self) -> DVec3 {
        self.index.as_dvec3() * f64::from(CHUNK_CELLS)
    }

    /// The box's least corner in chart metres; the same as [`ChunkCoord::origin`].
    pub fn min(self) -> DVec3 {
        self.origin()
    }

    /// The box's greatest corner in chart metres.
    pub fn max(self) -> DVec3 {
        self.origin() + DVec3::splat(f64::from(CHUNK_CELLS))
    }

    /// The box's middle in chart metres.
    pub fn centre(self) -> DVec3 {
        self.origin() + DVec3::splat(f64::from(CHUNK_CELLS) * 0.5)
    }

    /// The chunk that lies `step` chunks away in the same chart; indices saturate.
    #[must_use]
    pub fn offset(self, step: IVec3) -> Self {
        Self::new(self.chart, self.index.saturating_add(step))
    }

    /// The chunks of a chart from one index to another, both among them.
    pub fn boxed(chart: ChartId, low: IVec3, high: IVec3) -> impl Iterator<Item = Self> + Clone {
        (low.x..=high.x).flat_map(move |x| {
            (low.y..=high.y).flat_map(move |y| {
                (low.z..=high.z).map(move |z| Self::new(chart, IVec3::new(x, y, z)))
            })
        })
    }

    fn key(self) -> (ChartId, [i32; 3]) {
        (self.chart, self.index.to_array())
    }
}

impl PartialOrd for ChunkCoord {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for ChunkCoord {
    fn cmp(&self, other: &Self) -> Ordering {
        self.key().cmp(&other.key())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chunk_contains_its_origin_and_not_its_far_corner() {
        for index in [
            IVec3::ZERO,
            IVec3::new(-1, 2, -7),
            IVec3::new(40_000, -3, 0),
        ] {
            let chunk = ChunkCoord::new(ChartId::SECOND, index);
            let inside = ChartPoint::new(ChartId::SECOND, chunk.origin());
            assert_eq!(ChunkCoord::containing(inside), chunk);
            let below = inside.moved(DVec3::splat(-1e-6));
            assert_eq!(ChunkCoord::containing(below), chunk.offset(IVec3::NEG_ONE));
            let far = ChartPoint::new(ChartId::SECOND, chunk.max());
            assert_eq!(ChunkCoord::containing(far), chunk.offset(IVec3::ONE));
        }
    }

    #[test]
    fn order_is_by_chart_then_index() {
        let a = ChunkCoord::new(ChartId::FIRST, IVec3::new(5, 5, 5));
        let b = ChunkCoord::new(ChartId::SECOND, IVec3::new(0, 0, 0));
        assert!(a < b);
        assert!(a.offset(IVec3::new(0, 0, -1)) < a);
    }
}
