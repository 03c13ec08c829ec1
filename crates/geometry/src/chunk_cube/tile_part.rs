//! What of a cube lies in a tile, by columns of chunks.

use std::collections::BTreeMap;

use glam::{DVec3, IVec2, IVec3, Vec3Swizzles};

use super::Part;
use crate::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Domain, Tiled};

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

/// What is known of all tiles of a cube.
struct Maker<'a> {
    tiled: &'a dyn Tiled,
    /// The middle of the cube.
    at: ChartPoint,
    /// How far each distance reaches, metres.
    reaches_m: Vec<f64>,
    past_m: f64,
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
    let maker = Maker {
        tiled,
        at: ChartPoint::new(centre.chart, centre.centre()),
        reaches_m: reaches.collect(),
        past_m,
    };
    let farthest_m = maker.reaches_m.last().copied().unwrap_or_default();
    let charts = tiled.charts_within(maker.at, farthest_m).into_iter();
    let parts = charts.map(|chart| {
        let columns = maker.columns(chart, atlas.domain(chart));
        let nearest = columns.within(NEVER).min_by_key(|(at, column)| {
            let way = column.way.as_i64vec2();
            (way.length_squared(), at.to_array())
        });
        let at = nearest.map_or(IVec2::ZERO, |(at, _)| at);
        let middle = if chart == centre.chart {
            centre.index
        } else {
            IVec3::new(at.x, centre.index.y, at.y)
        };
        let part = Part {
            middle,
            wider: 0,
            domain: atlas.domain(chart),
            columns: Some(columns),
        };
        (chart, part)
    });
    parts.collect()
}

impl Maker<'_> {
    fn columns(&self, chart: ChartId, domain: Domain) -> Columns {
        let side = domain.side_chunks(self.past_m).clamp(1, i32::from(NEVER));
        let inner_side = domain.side_chunks(0.0).clamp(1, side);
        let mut columns = Columns {
            side,
            columns: Vec::new(),
        };
        // What lies past an edge is as far as the column beside it in the domain; that is known first.
        let mut own = BTreeMap::new();
        let all = (-side..side).flat_map(|x| (-side..side).map(move |z| IVec2::new(x, z)));
        columns.columns = all
            .map(|at| {
                let past_m = past_m(domain, at);
                let inner = at.clamp(IVec2::splat(-inner_side), IVec2::splat(inner_side - 1));
                let nearest = *own
                    .entry(inner.to_array())
                    .or_insert_with(|| self.column(chart, domain, inner));
                Column {
                    within: if past_m <= self.past_m {
                        nearest.within
                    } else {
                        NEVER
                    },
                    way: nearest.way,
                    is_own: past_m < 0.0,
                }
            })
            .collect();
        columns
    }

    fn column(&self, chart: ChartId, domain: Domain, at: IVec2) -> Column {
        let coord = ChunkCoord::new(chart, IVec3::new(at.x, 0, at.y));
        let (low, high) = (coord.min().xz(), coord.max().xz());
        // Of a column that an edge runs through counts what is in the domain.
        let (low, high) = match domain {
            Domain::Rectangle {
                low: least,
                high: most,
            } => (low.clamp(least, most), high.clamp(least, most)),
            _ => (low, high),
        };
        let away_m = self.tiled.away_m(self.at, chart, low, high);
        let within = self.reaches_m.partition_point(|reach_m| *reach_m <= away_m);
        let is_near = within < self.reaches_m.len();
        let middle = 0.5 * (low + high);
        let to = ChartPoint::new(chart, DVec3::new(middle.x, 0.0, middle.y));
        let way = self.tiled.level_way_m(self.at, to).unwrap_or_default().xz();
        Column {
            within: if is_near { within as u16 } else { NEVER },
            way: (way / f64::from(CHUNK_CELLS)).round().as_ivec2(),
            is_own: true,
        }
    }
}

/// How far outside of a domain a column lies, metres; less than 0 where some of it is inside.
fn past_m(domain: Domain, at: IVec2) -> f64 {
    let low = at.as_dvec2() * f64::from(CHUNK_CELLS);
    domain.least_outside_m(low, low + f64::from(CHUNK_CELLS))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
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
