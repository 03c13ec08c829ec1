//! The solid ground: the chunks that bodies reach, and those a little beyond, which stay solid.

use antipode_geometry::{CHUNK_CELLS, ChartId, ChunkCoord};
use glam::{DVec3, IVec3};

use crate::api::Reach;
use crate::within::Within;

/// Ground stays solid this far beyond the reach, in metres: half a chunk, so that a body that walks
/// to and fro has nothing made again.
const KEPT_BEYOND_M: f64 = 16.0;

/// Boxes of more chunks than this are not listed one by one.
const MOST_LISTED: i64 = 4096;

/// All chunks from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct ChunkBox {
    chart: ChartId,
    low: IVec3,
    high: IVec3,
}

impl ChunkBox {
    fn of(reach: &Reach, beyond_m: f64) -> Self {
        let cell = f64::from(CHUNK_CELLS);
        // Casts of what is infinite end at the end of the indices.
        let index = |at: DVec3| (at / cell).floor().as_ivec3();
        Self {
            chart: reach.chart,
            low: index(reach.min - beyond_m),
            high: index(reach.max + beyond_m),
        }
    }

    fn has(&self, coord: ChunkCoord) -> bool {
        coord.chart == self.chart
            && coord.index.cmpge(self.low).all()
            && coord.index.cmple(self.high).all()
    }

    fn count(&self) -> i64 {
        let span = (self.high.as_i64vec3() - self.low.as_i64vec3() + 1).max(glam::I64Vec3::ZERO);
        span.x.saturating_mul(span.y).saturating_mul(span.z)
    }

    fn all(self) -> impl Iterator<Item = ChunkCoord> {
        let Self { chart, low, high } = self;
        (low.x..=high.x).flat_map(move |x| {
            (low.y..=high.y).flat_map(move |y| {
                (low.z..=high.z).map(move |z| ChunkCoord {
                    chart,
                    index: IVec3::new(x, y, z),
                })
            })
        })
    }
}

/// The chunks within reach of bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Reaches {
    wanted: Vec<ChunkBox>,
    kept: Vec<ChunkBox>,
    /// If there are any, none but these.
    within: Option<Within>,
}

impl Reaches {
    /// The chunks that any of the boxes touches.
    pub(crate) fn of(bodies: &[Reach]) -> Self {
        let boxes = |beyond_m| {
            bodies
                .iter()
                .map(|reach| ChunkBox::of(reach, beyond_m))
                .collect()
        };
        Self {
            wanted: boxes(0.0),
            kept: boxes(KEPT_BEYOND_M),
            within: None,
        }
    }

    /// Those of them that lie where bodies move.
    pub(crate) fn within(self, within: Option<&Within>) -> Self {
        Self {
            within: within.cloned(),
            ..self
        }
    }

    fn lets_move(&self, coord: ChunkCoord) -> bool {
        self.within.as_ref().is_none_or(|it| it.has(coord))
    }

    /// Must the chunk be solid?
    pub(crate) fn wants(&self, coord: ChunkCoord) -> bool {
        self.wanted.iter().any(|reach| reach.has(coord)) && self.lets_move(coord)
    }

    /// May the chunk stay solid?
    pub(crate) fn keeps(&self, coord: ChunkCoord) -> bool {
        self.kept.iter().any(|reach| reach.has(coord)) && self.lets_move(coord)
    }

    /// May any chunk of a chart stay solid?
    pub(crate) fn comes_into(&self, chart: ChartId) -> bool {
        self.kept.iter().any(|reach| reach.chart == chart)
    }

    /// Every chunk that must be solid; `None` if there are too many to list.
    pub(crate) fn list(&self) -> Option<Vec<ChunkCoord>> {
        let count = self.wanted.iter().map(ChunkBox::count);
        let few = count.fold(0_i64, i64::saturating_add) <= MOST_LISTED;
        let all = || self.wanted.iter().flat_map(|reach| reach.all());
        few.then(|| all().filter(|coord| self.lets_move(*coord)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use antipode_geometry::ChartPoint;

    fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
        ChunkCoord {
            chart: ChartId::FIRST,
            index: IVec3::new(x, y, z),
        }
    }

    #[test]
    fn ground_within_reach_is_wanted_and_stays_for_half_a_chunk_more() {
        let at = ChartPoint::a(DVec3::new(20.0, 16.0, 16.0));
        let reaches = Reaches::of(&[Reach::around(at, 15.0)]);
        assert!(reaches.wants(chunk(0, 0, 0)) && reaches.wants(chunk(1, 0, 0)));
        assert!(!reaches.wants(chunk(-1, 0, 0)) && reaches.keeps(chunk(-1, 0, 0)));
        assert!(!reaches.keeps(chunk(-2, 0, 0)) && !reaches.keeps(chunk(2, 0, 0)));
        let other = ChunkCoord {
            chart: ChartId::SECOND,
            ..chunk(0, 0, 0)
        };
        assert!(!reaches.keeps(other));
        assert_eq!(reaches.list(), Some(vec![chunk(0, 0, 0), chunk(1, 0, 0)]));
    }

    #[test]
    fn a_whole_chart_is_within_reach_but_not_listed() {
        let reaches = Reaches::of(&[Reach::whole(ChartId::FIRST)]);
        assert!(reaches.wants(chunk(i32::MIN, 5, i32::MAX)));
        assert_eq!(reaches.list(), None);
    }

    #[test]
    fn a_reach_that_is_no_box_reaches_nothing() {
        let nowhere = ChartPoint::a(DVec3::splat(f64::NAN));
        let reaches = Reaches::of(&[Reach::around(nowhere, -100.0)]);
        assert!(reaches.list().is_some_and(|chunks| chunks.len() <= 1));
    }
}
