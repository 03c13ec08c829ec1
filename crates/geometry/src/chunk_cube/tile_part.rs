//! What of a cube lies in a tile, by columns of chunks.

use std::collections::BTreeMap;

use glam::{DVec2, IVec2, IVec3, Vec3Swizzles};

use super::Part;
use crate::{Atlas, Away, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Domain, Tiled};

/// Never within any distance.
const NEVER: u16 = u16::MAX;

/// The columns of a tile, from `-side` to `side` along both axes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Columns {
    side: i32,
    columns: Vec<Column>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    /// The least distance of a cube that it is in, chunks.
    pub within: u16,
    /// The way to it from the cube's middle, chunks along the axes of the middle's chart.
    pub way: IVec2,
    /// Whether some of it lies in the domain.
    pub is_own: bool,
}

impl Columns {
    /// What is known of the column of a chunk, if it is one of these.
    pub fn at(&self, index: IVec3) -> Option<&Column> {
        let [x, z] = index.xz().to_array();
        let range = -self.side..self.side;
        if !range.contains(&x) || !range.contains(&z) {
            return None;
        }
        let width = 2 * self.side as usize;
        let place = (x + self.side) as usize * width + (z + self.side) as usize;
        self.columns.get(place)
    }

    /// The least and the greatest index along both axes.
    pub fn span(&self) -> [i32; 2] {
        [-self.side, self.side - 1]
    }

    /// The one that is nearest to the cube's middle, by its index.
    fn nearest(&self) -> IVec2 {
        let nearest = self.within(NEVER).min_by_key(|(at, column)| {
            let way = column.way.as_i64vec2();
            (way.length_squared(), at.to_array())
        });
        nearest.map_or(IVec2::ZERO, |(at, _)| at)
    }

    /// The columns within a distance, by their indices.
    pub fn within(&self, distance: u16) -> impl Iterator<Item = (IVec2, &Column)> {
        let width = 2 * self.side as usize;
        let all = self.columns.iter().enumerate();
        all.filter(move |(_, column)| column.within <= distance)
            .map(move |(place, column)| {
                let at = IVec2::new((place / width) as i32, (place % width) as i32);
                (at - self.side, column)
            })
    }
}

/// The columns of any tile: all have one domain.
struct Layout {
    side: i32,
    /// What of each column that comes into the domain lies in it, from the least x and z to the greatest, metres.
    own: Vec<[DVec2; 2]>,
    columns: Vec<Place>,
}

/// A column of a [`Layout`].
struct Place {
    /// Of `own`, what is as near: what lies past an edge is as far as the column beside it in the domain.
    own: usize,
    is_near_domain: bool,
    is_own: bool,
}

/// The parts of the cube about a chunk, whose distances are told along the level, in place of its square: of land that grows with
/// the distance as no square does there is as much in it as [`Tiled::land_reach_m`] says.
pub(super) fn parts(
    atlas: &dyn Atlas,
    tiled: &dyn Tiled,
    centre: ChunkCoord,
    reach: u16,
    past_m: f64,
) -> BTreeMap<ChartId, Part> {
    let cell = f64::from(CHUNK_CELLS);
    let reaches = (0..=reach).map(|chunks| tiled.land_reach_m((f64::from(chunks) + 0.5) * cell));
    let reaches_m: Vec<_> = reaches.collect();
    let farthest_m = reaches_m.last().copied().unwrap_or_default();
    let domain = atlas.domain(centre.chart);
    let layout = Layout::new(domain, past_m);
    let at = ChartPoint::new(centre.chart, centre.centre());
    let tiles = tiled.boxes_within(at, farthest_m, &layout.own).into_iter();
    let parts = tiles.map(|(chart, away)| {
        let columns = layout.columns(&away, &reaches_m);
        let middle = if chart == centre.chart {
            centre.index
        } else {
            let at = columns.nearest();
            IVec3::new(at.x, centre.index.y, at.y)
        };
        let part = Part {
            middle,
            wider: 0,
            domain,
            columns: Some(columns),
        };
        (chart, part)
    });
    parts.collect()
}

impl Layout {
    fn new(domain: Domain, past_m: f64) -> Self {
        let side = domain.side_chunks(past_m).clamp(1, i32::from(NEVER));
        let inner = domain.side_chunks(0.0).clamp(1, side);
        let place = |at: IVec2| {
            let outside_m = outside_m(domain, at);
            let [x, z] = at
                .clamp(IVec2::splat(-inner), IVec2::splat(inner - 1))
                .to_array();
            Place {
                own: ((x + inner) * 2 * inner + z + inner) as usize,
                is_near_domain: outside_m <= past_m,
                is_own: outside_m < 0.0,
            }
        };
        Self {
            side,
            own: square(inner).map(|at| own_box(domain, at)).collect(),
            columns: square(side).map(place).collect(),
        }
    }

    /// The columns of a tile whose own are so far away.
    fn columns(&self, away: &[Away], reaches_m: &[f64]) -> Columns {
        let column = |away: &Away| {
            let within = reaches_m.partition_point(|reach_m| *reach_m <= away.nearest_m);
            let is_near = within < reaches_m.len();
            let way = away.way_m / f64::from(CHUNK_CELLS);
            (
                if is_near { within as u16 } else { NEVER },
                way.round().as_ivec2(),
            )
        };
        let own: Vec<_> = away.iter().map(column).collect();
        let columns = self.columns.iter().map(|place| {
            let (within, way) = own.get(place.own).copied().unwrap_or((NEVER, IVec2::ZERO));
            Column {
                within: if place.is_near_domain { within } else { NEVER },
                way,
                is_own: place.is_own,
            }
        });
        Columns {
            side: self.side,
            columns: columns.collect(),
        }
    }
}

/// The columns up to `side` to either side of the middle, as [`Columns`] has them in their order.
fn square(side: i32) -> impl Iterator<Item = IVec2> {
    (-side..side).flat_map(move |x| (-side..side).map(move |z| IVec2::new(x, z)))
}

/// What of a column is in the domain, where an edge runs through it.
fn own_box(domain: Domain, at: IVec2) -> [DVec2; 2] {
    let low = at.as_dvec2() * f64::from(CHUNK_CELLS);
    let corners = [low, low + f64::from(CHUNK_CELLS)];
    match domain {
        Domain::Rectangle { low, high } => corners.map(|it| it.clamp(low, high)),
        _ => corners,
    }
}

/// How far outside of a domain a column lies, metres; less than 0 where some of it is inside.
fn outside_m(domain: Domain, at: IVec2) -> f64 {
    let low = at.as_dvec2() * f64::from(CHUNK_CELLS);
    domain.least_outside_m(low, low + f64::from(CHUNK_CELLS))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use glam::DVec3;

    use super::*;
    use crate::{Geometry, strategy};

    #[test]
    fn columns_that_are_none_of_a_tiles_are_not_there() {
        for radius_m in crate::HyperbolicWorld::RADII_M {
            let space = strategy(Geometry::HyperbolicWorld, radius_m);
            let tiled = space.tiled().unwrap();
            let parts = parts(
                &*space,
                tiled,
                ChunkCoord::containing(ChartPoint::a(DVec3::Y)),
                2,
                8.0,
            );
            for columns in parts.into_values().filter_map(|part| part.columns) {
                let side = columns.side;
                for far in [
                    side,
                    side + 1,
                    1000,
                    i32::MAX,
                    -side - 1,
                    -side - 2,
                    i32::MIN,
                ] {
                    for near in [-side, 0, side - 1] {
                        assert_eq!(columns.at(IVec3::new(far, 0, near)), None);
                        assert_eq!(columns.at(IVec3::new(near, 0, far)), None);
                    }
                }
                assert!(columns.at(IVec3::splat(-side)).is_some());
            }
        }
    }
}
