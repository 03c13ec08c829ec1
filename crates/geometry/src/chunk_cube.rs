//! The chunks of a cube about one of them, in every chart that comes into it.

use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

use glam::{I64Vec3, IVec3};

use crate::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Domain};

mod tile_part;

use tile_part::Columns;

/// The chunks within a Chebyshev distance of one, each chart counted along its own axes, that come near the domains of
/// their charts. It is made for the chunk's middle, so that it is the same wherever in it somebody stands.
///
/// In a world in tiles ([`Atlas::tiled`]) distances are those along the level, whatever chart a place is written in, and as far
/// as [`crate::Tiled::land_reach_m`] says; up and down they are counted in chunks as everywhere.
#[derive(Clone, Debug)]
pub struct ChunkCube {
    centre: ChunkCoord,
    /// Shared: there may be hundreds of charts, and ranges are handed on with plans.
    parts: Arc<BTreeMap<ChartId, Part>>,
    past_m: f64,
}

/// What of a cube lies in one chart.
#[derive(Clone, Debug, PartialEq)]
struct Part {
    /// The chunk in the middle, as this chart counts them.
    middle: IVec3,
    /// By how many chunks the cube is wider in this chart than in its own.
    wider: i32,
    domain: Domain,
    /// What is near of a tile, which goes before all that is told by the middle.
    columns: Option<Columns>,
}

impl ChunkCube {
    /// The chunks up to `reach` from `centre`, in every chart that comes so near: of each those that come within `past_m`
    /// metres of its domain. In other charts it holds every place that is no farther from the middle than a face of the
    /// cube; corners are held only where charts are square to one another.
    pub fn about(atlas: &dyn Atlas, centre: ChunkCoord, reach: u16, past_m: f64) -> Self {
        let parts = atlas.tiled().map_or_else(
            || Self::images(atlas, centre, reach, past_m),
            |tiled| tile_part::parts(atlas, tiled, centre, reach, past_m),
        );
        Self {
            centre,
            parts: Arc::new(parts),
            past_m,
        }
    }

    /// The parts by the images of the middle.
    fn images(
        atlas: &dyn Atlas,
        centre: ChunkCoord,
        reach: u16,
        past_m: f64,
    ) -> BTreeMap<ChartId, Part> {
        let cell = f64::from(CHUNK_CELLS);
        let half_m = (f64::from(reach) + 0.5) * cell;
        let at = ChartPoint::new(centre.chart, centre.centre());
        let own = Part {
            middle: centre.index,
            wider: 0,
            domain: atlas.domain(centre.chart),
            columns: None,
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
                columns: None,
            };
            (coord.chart, part)
        });
        others.chain([(centre.chart, own)]).collect()
    }

    /// The chunk that it is made about.
    pub fn centre(&self) -> ChunkCoord {
        self.centre
    }

    /// The middle of the cube's middle chunk in every chart that comes in.
    pub fn middles(&self) -> impl Iterator<Item = ChartPoint> + '_ {
        self.parts.iter().map(|(&chart, part)| {
            let coord = ChunkCoord::new(chart, part.middle);
            ChartPoint::new(chart, coord.centre())
        })
    }

    /// How far a chunk is from the middle, in chunks along the axes of its chart, or in a world in tiles of the middle's; none in
    /// a chart that does not come in.
    pub fn apart(&self, coord: ChunkCoord) -> Option<I64Vec3> {
        let part = self.parts.get(&coord.chart)?;
        let apart = coord.index.as_i64vec3() - part.middle.as_i64vec3();
        let Some(columns) = &part.columns else {
            return Some(apart);
        };
        let way = columns.at(coord.index)?.way;
        Some(I64Vec3::new(way.x.into(), apart.y, way.y.into()))
    }

    /// Whether a chunk is within a distance, in chunks.
    pub fn has(&self, coord: ChunkCoord, distance: u16) -> bool {
        self.parts.get(&coord.chart).is_some_and(|part| {
            let apart = (coord.index.as_i64vec3() - part.middle.as_i64vec3()).abs();
            let half = i64::from(part.half(distance));
            match &part.columns {
                Some(columns) => {
                    let column = columns.at(coord.index);
                    apart.y <= half && column.is_some_and(|it| it.within <= distance)
                }
                None => apart.max_element() <= half && part.domain.reaches(coord, self.past_m),
            }
        })
    }

    /// Whether a chunk of a tile lies wholly beyond its edges, where only what stands near the edge needs it: pictures have
    /// the chunks of the next tile there. Never in worlds that are not in tiles.
    pub fn is_past_edge(&self, coord: ChunkCoord) -> bool {
        let part = self.parts.get(&coord.chart);
        let columns = part.and_then(|part| part.columns.as_ref());
        let column = columns.and_then(|columns| columns.at(coord.index));
        column.is_some_and(|column| !column.is_own)
    }

    /// The least and the greatest indices that a chart has within a distance, in chunks; they saturate. None of a chart
    /// that does not come in. Of a tile all of the ground plan counts.
    pub fn span(&self, chart: ChartId, distance: u16) -> Option<[IVec3; 2]> {
        let part = self.parts.get(&chart)?;
        let half = IVec3::splat(part.half(distance));
        let mut low = part.middle.saturating_sub(half);
        let mut high = part.middle.saturating_add(half);
        if let Some(columns) = &part.columns {
            let [least, most] = columns.span();
            (low.x, low.z, high.x, high.z) = (least, least, most, most);
        }
        Some([low, high])
    }

    /// Every chunk within a distance, in chunks, but for those [past an edge](Self::is_past_edge).
    pub fn chunks(&self, distance: u16) -> Vec<ChunkCoord> {
        let mut found = Vec::new();
        for (&chart, part) in &*self.parts {
            let Some([mut low, mut high]) = self.span(chart, distance) else {
                continue;
            };
            if let Some(columns) = &part.columns {
                let own = columns.within(distance).filter(|(_, column)| column.is_own);
                found.extend(own.flat_map(|(at, _)| {
                    let at = |y| IVec3::new(at.x, y, at.y);
                    ChunkCoord::boxed(chart, at(low.y), at(high.y))
                }));
                continue;
            }
            let side = part.domain.side_chunks(self.past_m);
            (low.x, low.z) = (low.x.max(-1 - side), low.z.max(-1 - side));
            (high.x, high.z) = (high.x.min(side), high.z.min(side));
            let all = ChunkCoord::boxed(chart, low, high);
            found.extend(all.filter(|&coord| part.domain.reaches(coord, self.past_m)));
        }
        found
    }

    /// The chunks of a chart within a distance that are [past an edge](Self::is_past_edge).
    pub fn past_edges(&self, chart: ChartId, distance: u16) -> Vec<ChunkCoord> {
        let part = self.parts.get(&chart);
        let columns = part.and_then(|part| part.columns.as_ref());
        let Some((columns, [low, high])) = columns.zip(self.span(chart, distance)) else {
            return Vec::new();
        };
        let past = columns
            .within(distance)
            .filter(|(_, column)| !column.is_own);
        past.flat_map(|(at, _)| {
            let at = |y| IVec3::new(at.x, y, at.y);
            ChunkCoord::boxed(chart, at(low.y), at(high.y))
        })
        .collect()
    }

    /// The charts that come in.
    pub fn charts(&self) -> impl Iterator<Item = ChartId> + '_ {
        self.parts.keys().copied()
    }
}

impl PartialEq for ChunkCube {
    fn eq(&self, other: &Self) -> bool {
        let same_parts = || Arc::ptr_eq(&self.parts, &other.parts) || self.parts == other.parts;
        self.centre == other.centre && self.past_m == other.past_m && same_parts()
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
