//! The chunks of a cube about one of them, in every chart that comes into it.

use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;

use glam::{I64Vec3, IVec3};

use crate::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Domain};

/// The chunks within a Chebyshev distance of one, each chart counted along its own axes, that come near the domains of
/// their charts. It is made for the chunk's middle, so that it is the same wherever in it somebody stands.
#[derive(Clone, Debug, PartialEq)]
pub struct ChunkCube {
    parts: BTreeMap<ChartId, Part>,
    past_m: f64,
}

/// What of a cube lies in one chart.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    /// The chunk in the middle, as this chart counts them.
    middle: IVec3,
    /// By how many chunks the cube is wider in this chart than in its own.
    wider: i32,
    domain: Domain,
}

impl ChunkCube {
    /// The chunks up to `reach` from `centre`, in every chart that comes so near: of each those that come within `past_m`
    /// metres of its domain. In other charts it holds every place that is no farther from the middle than a face of the
    /// cube; corners are held only where charts are square to one another.
    pub fn about(atlas: &dyn Atlas, centre: ChunkCoord, reach: u16, past_m: f64) -> Self {
        let cell = f64::from(CHUNK_CELLS);
        let half_m = (f64::from(reach) + 0.5) * cell;
        let at = ChartPoint::new(centre.chart, centre.centre());
        let own = Part {
            middle: centre.index,
            wider: 0,
            domain: atlas.domain(centre.chart),
        };
        // The corners of the cube's ground plan are what is farthest off.
        let images = atlas.images(at, SQRT_2 * half_m + past_m).into_iter();
        let others = images.map(|image| {
            let coord = ChunkCoord::containing(image.point);
            // The image need not be in the middle of its chunk.
            let off_m = (image.point.pos - coord.centre())
                .with_y(0.0)
                .abs()
                .max_element();
            let wider_m = atlas.spread_m(at, half_m, past_m) + off_m - half_m;
            let part = Part {
                middle: coord.index,
                wider: (wider_m / cell).ceil().max(0.0) as i32,
                domain: atlas.domain(coord.chart),
            };
            (coord.chart, part)
        });
        Self {
            parts: others.chain([(centre.chart, own)]).collect(),
            past_m,
        }
    }

    /// The middle of the cube's middle chunk in every chart that comes in.
    pub fn middles(&self) -> impl Iterator<Item = ChartPoint> + '_ {
        self.parts.iter().map(|(&chart, part)| {
            let coord = ChunkCoord::new(chart, part.middle);
            ChartPoint::new(chart, coord.centre())
        })
    }

    /// How far a chunk is from the middle, in chunks along the axes of its chart; none in a chart that does not come in.
    pub fn apart(&self, coord: ChunkCoord) -> Option<I64Vec3> {
        let part = self.parts.get(&coord.chart)?;
        Some(coord.index.as_i64vec3() - part.middle.as_i64vec3())
    }

    /// Whether a chunk is within a distance, in chunks.
    pub fn has(&self, coord: ChunkCoord, distance: u16) -> bool {
        self.parts.get(&coord.chart).is_some_and(|part| {
            let apart = coord.index.as_i64vec3() - part.middle.as_i64vec3();
            apart.abs().max_element() <= i64::from(part.half(distance))
                && part.domain.reaches(coord, self.past_m)
        })
    }

    /// The least and the greatest indices that a chart has within a distance, in chunks; they saturate. None of a chart
    /// that does not come in.
    pub fn span(&self, chart: ChartId, distance: u16) -> Option<[IVec3; 2]> {
        let part = self.parts.get(&chart)?;
        let half = IVec3::splat(part.half(distance));
        Some([
            part.middle.saturating_sub(half),
            part.middle.saturating_add(half),
        ])
    }

    /// Every chunk within a distance, in chunks.
    pub fn chunks(&self, distance: u16) -> Vec<ChunkCoord> {
        let mut found = Vec::new();
        for (&chart, part) in &self.parts {
            let Some([mut low, mut high]) = self.span(chart, distance) else {
                continue;
            };
            let side = part.domain.side_chunks(self.past_m);
            (low.x, low.z) = (low.x.max(-1 - side), low.z.max(-1 - side));
            (high.x, high.z) = (high.x.min(side), high.z.min(side));
            let all = ChunkCoord::boxed(chart, low, high);
            found.extend(all.filter(|&coord| part.domain.reaches(coord, self.past_m)));
        }
        found
    }
}

impl Part {
    fn half(&self, distance: u16) -> i32 {
        i32::from(distance).saturating_add(self.wider)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3Swizzles};

    use super::*;
    use crate::{Euclidean, Spherical};

    #[test]
    fn in_a_world_of_one_chart_it_is_a_cube() {
        let centre = ChunkCoord::new(ChartId::FIRST, IVec3::new(-4, 1, i32::MAX));
        let cube = ChunkCube::about(&Euclidean, centre, 3, 8.0);
        assert_eq!(cube.chunks(2).len(), 5 * 5 * 3);
        let near = centre.offset(IVec3::new(2, -2, -1));
        assert!(cube.has(near, 2) && !cube.has(near, 1));
        assert_eq!(cube.apart(near), Some(I64Vec3::new(2, -2, -1)));
        let [low, high] = cube.span(ChartId::FIRST, 2).unwrap_or_default();
        assert_eq!(low, IVec3::new(-6, -1, i32::MAX - 2));
        assert_eq!(high, IVec3::new(-2, 3, i32::MAX));
        let other = ChunkCoord::new(ChartId::SECOND, centre.index);
        assert!(!cube.has(other, 3) && cube.apart(other).is_none());
    }

    /// Whatever is within so many metres is in the cube, in whichever chart it is written.
    #[test]
    fn over_an_edge_it_holds_what_is_as_near_there() {
        let space = Spherical::new(64.0);
        let rim_m = space.domain(ChartId::FIRST).half_width_m();
        let cell = f64::from(CHUNK_CELLS);
        let centre = ChunkCoord::containing(ChartPoint::a(DVec3::new(rim_m - 20.0, 4.0, 11.0)));
        let cube = ChunkCube::about(&space, centre, 2, 8.0);
        let middle = ChartPoint::new(centre.chart, centre.centre());
        let mut over = 0;
        for n in 0..400 {
            let (turn, share) = (f64::from(n) * 2.4, f64::from(n) / 399.0);
            let away_m = 2.5 * cell * share.sqrt() - 1e-6;
            let point = middle.moved(DVec3::new(turn.cos(), 0.0, turn.sin()) * away_m);
            let is_own = space.domain(point.chart).outside_m(point.pos.xz()) <= 8.0;
            assert!(!is_own || cube.has(ChunkCoord::containing(point), 2));
            for image in space.images(point, 8.0) {
                assert!(
                    cube.has(ChunkCoord::containing(image.point), 2),
                    "{image:?}"
                );
                over += 1;
            }
        }
        assert!(over > 50, "{over}");
    }
}
