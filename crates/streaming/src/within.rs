//! Where bodies move at all: the only chunks that ground is made solid in.

use antipode_geometry::{ChartId, ChunkCoord, ChunkCube};

use crate::api::Wish;

/// The chunks about a middle that bodies move in, and those about places that are looked at from elsewhere.
///
/// A range stays for a while when its middle moves, and reaches as far as the view. Were ground made solid in all of it, what
/// bodies meet would hang on how far the view is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Within {
    cube: ChunkCube,
    distance: u16,
    apart: Vec<ChunkCube>,
}

impl Within {
    pub(crate) fn new(cube: &ChunkCube, distance: u16, apart: &[ChunkCube]) -> Self {
        Self {
            cube: cube.clone(),
            distance,
            apart: apart.to_vec(),
        }
    }

    pub(crate) fn has(&self, coord: ChunkCoord) -> bool {
        let is_apart = |it: &ChunkCube| it.has(coord, Wish::APART_CHUNKS);
        self.cube.has(coord, self.distance) || self.apart.iter().any(is_apart)
    }

    /// Whether a chunk lies wholly beyond the edges of its tile.
    pub(crate) fn is_past_edge(&self, coord: ChunkCoord) -> bool {
        self.cube.is_past_edge(coord)
    }

    /// Those about the middle, but for [`Within::past_edges`].
    pub(crate) fn chunks(&self) -> Vec<ChunkCoord> {
        self.cube.chunks(self.distance)
    }

    /// Those about the middle that lie beyond the edges of their tiles, in charts that `counts` says.
    pub(crate) fn past_edges(&self, counts: impl Fn(ChartId) -> bool) -> Vec<ChunkCoord> {
        let charts = self.cube.charts().filter(|chart| counts(*chart));
        let past = |chart| self.cube.past_edges(chart, self.distance);
        charts.flat_map(past).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::{Atlas, ChartPoint, Geometry, strategy};
    use antipode_terrain::RIM_REACH_M;
    use glam::DVec3;

    use super::*;
    use crate::api::Reach;
    use crate::range::Range;
    use crate::reaches::Reaches;

    const DISTANCE: u16 = 4;

    fn wish(atlas: &dyn Atlas, x: f64, view: u32) -> Wish {
        let centre = ChartPoint::a(DVec3::new(x, 3.0, 5.0));
        let about = ChunkCoord::containing(centre);
        let cube = ChunkCube::about(atlas, about, DISTANCE, RIM_REACH_M);
        let whole = cube.charts().map(Reach::whole).collect();
        Wish {
            bodies: whole,
            bodies_distance: DISTANCE.into(),
            bodies_within: Some(cube),
            ..Wish::new(centre, DVec3::X, view)
        }
    }

    /// Whoever walks a few metres over the border of a chunk keeps the range that he had, yet not where bodies move.
    #[test]
    fn ground_is_made_for_bodies_in_the_same_chunks_however_far_the_view_is() {
        for radius_m in [30.152, 60.305] {
            let space = strategy(Geometry::HyperbolicWorld, radius_m);
            for view in [2, 4, 8] {
                let before = Range::after(&Range::Nothing, &*space, &wish(&*space, 3.0, view));
                let now = wish(&*space, -6.0, view);
                let range = Range::after(&before, &*space, &now);
                let cube = now.bodies_within.clone().unwrap();
                let mut chunks = cube.chunks(DISTANCE);
                let past = cube.charts().collect::<Vec<_>>();
                chunks.extend(past.iter().flat_map(|it| cube.past_edges(*it, DISTANCE)));
                let bodies = Reaches::of(&now.bodies).within(range.bodies());
                let listed = range.kept().into_iter().chain(range.past_edges(&bodies));
                let mut made: Vec<_> = listed.filter(|it| bodies.wants(*it)).collect();
                made.sort_unstable();
                chunks.sort_unstable();
                assert!(chunks.iter().all(|it| range.contains(*it)), "{view}");
                assert_eq!(made, chunks, "{radius_m} {view}");
            }
        }
    }
}
