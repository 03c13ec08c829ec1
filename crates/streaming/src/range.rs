//! The range of wanted chunks: a cube around the player, in every chart that comes into it, or the whole of a closed world.

use std::ops::RangeInclusive;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, ChunkCube, Domain};
use antipode_terrain::RIM_REACH_M;
use glam::{I64Vec3, IVec3};

use crate::api::Wish;
use crate::reaches::Reaches;
use crate::within::Within;

/// Chunks beyond the wished distance that are kept, so that walking to and fro over a border does
/// not load and unload.
const KEPT_BEYOND: u16 = 1;

/// In a world in tiles a range is not made anew before its middle's chunk is left by more than this, metres. What is kept beyond
/// the wished distance is less than a chunk there where land grows fast.
const STAYS_M: f64 = 8.0;

/// The largest distance in chunks that a wish can ask for.
const LARGEST_DISTANCE: u32 = 64;

/// A set of wanted chunks.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Range {
    /// Nothing has been wished yet.
    Nothing,
    /// What lies around a chunk in a world without end, up to so many chunks; beyond `view` chunks only for bodies.
    Around {
        cube: ChunkCube,
        distance: u16,
        view: u16,
        /// What else is viewed, up to [`Wish::APART_CHUNKS`] about each.
        apart: Vec<ChunkCube>,
        /// Where bodies move, which may be about another middle.
        bodies: Option<Within>,
    },
    /// The whole of a closed world.
    Whole(Closed),
}

/// The chunks that a closed world has: of each chart those that come within [`RIM_REACH_M`] of its domain, in the layers
/// `layers` (chunk y).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Closed {
    charts: Vec<(ChartId, Domain)>,
    layers: RangeInclusive<i32>,
}

impl Closed {
    /// The chunks of the given space; `None` if it is open and has them all.
    fn of(strategy: &dyn Atlas) -> Option<Self> {
        let (charts, limits) = (strategy.all_charts()?, strategy.limits()?);
        let layer = |y_m: f64| (y_m / f64::from(CHUNK_CELLS)).floor() as i32;
        // One cell more on either side: a chunk's border is meshed by the chunk below.
        let layers = layer(limits.bedrock_m - 1.0)..=layer(limits.ceiling_m + 1.0);
        Some(Self {
            charts: charts
                .iter()
                .map(|chart| (*chart, strategy.domain(*chart)))
                .collect(),
            layers,
        })
    }

    fn has(&self, coord: ChunkCoord) -> bool {
        let mut charts = self.charts.iter();
        self.layers.contains(&coord.index.y)
            && charts
                .any(|(chart, domain)| *chart == coord.chart && domain.reaches(coord, RIM_REACH_M))
    }
}

/// Does the world have this chunk? It has those that reach into the domain of their chart or the margin around it; a
/// closed one those among them that lie between bedrock and ceiling.
pub fn is_in_world(strategy: &dyn Atlas, coord: ChunkCoord) -> bool {
    if let Some(closed) = Closed::of(strategy) {
        return closed.has(coord);
    }
    let domain = strategy.domain(coord.chart);
    strategy.has_chart(coord.chart) && domain.reaches(coord, RIM_REACH_M)
}

impl Range {
    /// The range of a wish in the given space: what is viewed, and how far ground is made for bodies.
    pub(crate) fn wished(strategy: &dyn Atlas, centre: ChartPoint, view: u32, bodies: u32) -> Self {
        if let Some(closed) = Closed::of(strategy) {
            return Self::Whole(closed);
        }
        let within = |chunks: u32| chunks.min(LARGEST_DISTANCE) as u16;
        let view = within(view).max(1);
        let distance = view.max(within(bodies));
        let centre = ChunkCoord::containing(centre);
        Self::Around {
            cube: ChunkCube::about(strategy, centre, distance + KEPT_BEYOND, RIM_REACH_M),
            distance,
            view,
            apart: Vec::new(),
            bodies: None,
        }
    }

    /// The same, and what lies about places that are looked at from elsewhere.
    pub(crate) fn with(mut self, strategy: &dyn Atlas, places: &[ChartPoint]) -> Self {
        if let Self::Around { apart, .. } = &mut self {
            let cube = |place: &ChartPoint| {
                let centre = ChunkCoord::containing(*place);
                let reach = Wish::APART_CHUNKS + KEPT_BEYOND;
                ChunkCube::about(strategy, centre, reach, RIM_REACH_M)
            };
            apart.extend(places.iter().map(cube));
        }
        self
    }

    /// The range of a wish after another: what of that holds still is taken over.
    pub(crate) fn after(before: &Self, strategy: &dyn Atlas, wish: &Wish) -> Self {
        let mut range = Self::viewed_after(before, strategy, wish);
        if let Self::Around { apart, bodies, .. } = &mut range {
            let distance = wish.bodies_distance.min(LARGEST_DISTANCE) as u16;
            let cube = wish.bodies_within.as_ref();
            *bodies = cube.map(|cube| Within::new(cube, distance, apart));
        }
        range
    }

    /// Where bodies move, if they move nowhere else.
    pub(crate) fn bodies(&self) -> Option<&Within> {
        match self {
            Self::Around { bodies, .. } => bodies.as_ref(),
            Self::Nothing | Self::Whole(_) => None,
        }
    }

    fn viewed_after(before: &Self, strategy: &dyn Atlas, wish: &Wish) -> Self {
        let new = || {
            Self::wished(
                strategy,
                wish.centre,
                wish.view_distance,
                wish.bodies_distance,
            )
        };
        let Self::Around {
            cube,
            distance,
            view,
            apart: held,
            ..
        } = before
        else {
            return new().with(strategy, &wish.apart);
        };
        let within = |chunks: u32| chunks.min(LARGEST_DISTANCE) as u16;
        let same_size = *view == within(wish.view_distance).max(1)
            && *distance == (*view).max(within(wish.bodies_distance));
        if strategy.tiled().is_none() || !same_size || !stays(strategy, cube, wish.centre) {
            return new().with(strategy, &wish.apart);
        }
        let mut range = Self::Around {
            cube: cube.clone(),
            distance: *distance,
            view: *view,
            apart: Vec::new(),
            bodies: None,
        };
        let middles = wish
            .apart
            .iter()
            .map(|place| ChunkCoord::containing(*place));
        if middles.eq(held.iter().map(ChunkCube::centre)) {
            if let Self::Around { apart, .. } = &mut range {
                apart.clone_from(held);
            }
            return range;
        }
        range.with(strategy, &wish.apart)
    }

    /// Whether a chunk of a tile is there for bodies alone.
    pub(crate) fn is_past_edge(&self, coord: ChunkCoord) -> bool {
        match self {
            Self::Around {
                cube,
                apart,
                bodies,
                ..
            } => {
                let mut cubes = std::iter::once(cube).chain(apart);
                let is_past = cubes.any(|it| it.is_past_edge(coord));
                is_past || bodies.as_ref().is_some_and(|it| it.is_past_edge(coord))
            }
            Self::Nothing | Self::Whole(_) => false,
        }
    }

    /// The chunks past edges that bodies keep.
    pub(crate) fn past_edges(&self, bodies: &Reaches) -> Vec<ChunkCoord> {
        let Self::Around {
            cube,
            distance,
            apart,
            bodies: within,
            ..
        } = self
        else {
            return Vec::new();
        };
        let of = |cube: &ChunkCube, distance: u16| {
            let charts = cube.charts().filter(|chart| bodies.comes_into(*chart));
            let all = charts.flat_map(|chart| cube.past_edges(chart, distance));
            all.filter(|coord| bodies.keeps(*coord)).collect::<Vec<_>>()
        };
        let mut all = of(cube, distance + KEPT_BEYOND);
        all.extend(
            apart
                .iter()
                .flat_map(|it| of(it, Wish::APART_CHUNKS + KEPT_BEYOND)),
        );
        if let Some(within) = within {
            let past = within.past_edges(|chart| bodies.comes_into(chart));
            all.extend(past.into_iter().filter(|coord| bodies.keeps(*coord)));
        }
        all.sort_unstable();
        all.dedup();
        all
    }

    /// How far a chunk is from the middle, in chunks along the axes of its chart; none where there is no middle.
    pub(crate) fn apart(&self, coord: ChunkCoord) -> Option<I64Vec3> {
        match self {
            Self::Around { cube, .. } => cube.apart(coord),
            Self::Nothing | Self::Whole(_) => None,
        }
    }

    /// Is the chunk to be loaded though no body needs it?
    pub(crate) fn views(&self, coord: ChunkCoord) -> bool {
        self.viewed(coord, 0)
    }

    /// Is it to be kept, if it is there already, though no body needs it?
    pub(crate) fn keeps_view(&self, coord: ChunkCoord) -> bool {
        self.viewed(coord, KEPT_BEYOND)
    }

    fn viewed(&self, coord: ChunkCoord, beyond: u16) -> bool {
        match self {
            Self::Around {
                cube, view, apart, ..
            } => {
                let is_near = cube.has(coord, view + beyond) || has_apart(apart, coord, beyond);
                is_near && !self.is_past_edge(coord)
            }
            Self::Nothing | Self::Whole(_) => self.contains(coord),
        }
    }

    /// Is the chunk to be loaded?
    pub(crate) fn contains(&self, coord: ChunkCoord) -> bool {
        self.within(coord, 0)
    }

    /// Is the chunk to be kept if it is there already?
    pub(crate) fn keeps(&self, coord: ChunkCoord) -> bool {
        self.within(coord, KEPT_BEYOND)
    }

    fn within(&self, coord: ChunkCoord, beyond: u16) -> bool {
        match self {
            Self::Nothing => false,
            Self::Around {
                cube,
                distance,
                apart,
                bodies,
                ..
            } => {
                let is_near = cube.has(coord, distance + beyond) || has_apart(apart, coord, beyond);
                is_near || bodies.as_ref().is_some_and(|it| it.has(coord))
            }
            Self::Whole(closed) => closed.has(coord),
        }
    }

    /// Every chunk to be loaded.
    #[cfg(test)]
    pub(crate) fn all(&self) -> Vec<ChunkCoord> {
        self.list(0)
    }

    /// Every chunk to be kept if it is there already, but for [`Range::past_edges`]; those to be loaded are among them.
    pub(crate) fn kept(&self) -> Vec<ChunkCoord> {
        self.list(KEPT_BEYOND)
    }

    fn list(&self, beyond: u16) -> Vec<ChunkCoord> {
        match self {
            Self::Nothing => Vec::new(),
            Self::Around {
                cube,
                distance,
                apart,
                bodies,
                ..
            } => {
                let mut all = cube.chunks(distance + beyond);
                let others = apart
                    .iter()
                    .flat_map(|it| it.chunks(Wish::APART_CHUNKS + beyond));
                let others = others.chain(bodies.iter().flat_map(Within::chunks));
                all.extend(others.filter(|&coord| !cube.has(coord, distance + beyond)));
                if apart.len() + bodies.iter().len() > 1 {
                    all.sort_unstable();
                    all.dedup();
                }
                all
            }
            Self::Whole(Closed { charts, layers }) => {
                let all = charts.iter().flat_map(|(chart, domain)| {
                    let side = domain.side_chunks(RIM_REACH_M);
                    let low = IVec3::new(-side, *layers.start(), -side);
                    ChunkCoord::boxed(*chart, low, IVec3::new(side, *layers.end(), side))
                });
                all.filter(|&coord| self.contains(coord)).collect()
            }
        }
    }
}

/// Whether somebody has not gone farther from the middle's chunk than a range may stay for.
fn stays(strategy: &dyn Atlas, cube: &ChunkCube, centre: ChartPoint) -> bool {
    let middle = cube.centre();
    let here = strategy.carry(centre, middle.chart);
    here.is_some_and(|here| {
        let off = here.point.pos - here.point.pos.clamp(middle.min(), middle.max());
        off.abs().max_element() <= STAYS_M
    })
}

fn has_apart(apart: &[ChunkCube], coord: ChunkCoord, beyond: u16) -> bool {
    apart
        .iter()
        .any(|it| it.has(coord, Wish::APART_CHUNKS + beyond))
}

/// The chunks of the cube from `low` to `high` steps around a chunk, of its own chart; at the end
/// of the range of indices there are fewer.
pub(crate) fn around(coord: ChunkCoord, low: i32, high: i32) -> impl Iterator<Item = ChunkCoord> {
    let index = |steps| coord.index.saturating_add(IVec3::splat(steps));
    ChunkCoord::boxed(coord.chart, index(low), index(high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use antipode_geometry::{Geometry, strategy};
    use glam::DVec3;

    fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
        ChunkCoord {
            chart: ChartId::FIRST,
            index: IVec3::new(x, y, z),
        }
    }

    #[test]
    fn a_flat_range_is_a_cube_and_keeps_one_chunk_more() {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        let range = Range::wished(&*space, ChartPoint::a(DVec3::new(-1.0, 40.0, 5.0)), 2, 0);
        assert_eq!(range.all().len(), 125);
        assert!(range.contains(chunk(1, 3, -2)) && !range.contains(chunk(2, 1, 0)));
        assert!(range.keeps(chunk(2, 1, 0)) && !range.keeps(chunk(3, 1, 0)));
        assert!(range.all().iter().all(|&coord| range.contains(coord)));
    }

    #[test]
    fn beyond_the_view_chunks_are_there_for_bodies_alone() {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        let range = Range::wished(&*space, ChartPoint::a(DVec3::ZERO), 2, 4);
        assert!(range.contains(chunk(4, 0, 0)) && !range.contains(chunk(5, 0, 0)));
        assert!(range.views(chunk(2, 0, 0)) && !range.views(chunk(3, 0, 0)));
        assert!(range.keeps_view(chunk(3, 0, 0)) && !range.keeps_view(chunk(4, 0, 0)));
        let wide = Range::wished(&*space, ChartPoint::a(DVec3::ZERO), 8, 4);
        assert!(wide.views(chunk(8, 0, 0)) && !wide.contains(chunk(9, 0, 0)));
    }

    #[test]
    fn land_about_places_that_are_looked_at_from_elsewhere_is_viewed_once() {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        let far = ChartPoint::a(DVec3::new(3200.0, 1.0, 1.0));
        let near = ChartPoint::a(DVec3::new(33.0, 1.0, 1.0));
        let range = Range::wished(&*space, ChartPoint::a(DVec3::ONE), 2, 4);
        let both = range.clone().with(&*space, &[near, far]);
        assert!(both.views(chunk(102, 0, 0)) && !both.views(chunk(103, 0, 0)));
        assert!(both.keeps(chunk(103, 0, 0)) && !range.keeps(chunk(100, 0, 0)));
        assert!(both.views(chunk(3, 0, 0)) && !range.views(chunk(3, 0, 0)));
        let mut all = both.all();
        assert_eq!(all.len(), range.all().len() + 125);
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), range.all().len() + 125);
    }

    #[test]
    fn a_sphere_is_wanted_whole_wherever_the_player_is() {
        let space = strategy(Geometry::Spherical, 32.0);
        let range = Range::wished(&*space, ChartPoint::a(DVec3::new(3.0, 9.0, 1.0)), 1, 0);
        let away = ChartPoint::new(ChartId::SECOND, DVec3::new(-40.0, 9.0, 1.0));
        assert_eq!(range, Range::wished(&*space, away, 7, 0));
        let all = range.all();
        // The equator lies 50.3 m out, the margin ends at 58.3: two chunks on either side.
        assert_eq!(
            all.iter().filter(|c| c.chart == ChartId::SECOND).count() * 2,
            all.len()
        );
        assert!(range.contains(chunk(1, 0, 1)) && range.contains(chunk(-2, 0, -2)));
        assert!(!range.contains(chunk(2, 0, 0)) && !range.contains(chunk(0, 9, 0)));
    }

    #[test]
    fn at_the_end_of_the_indices_a_range_is_cut_off() {
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        for far in [1e30, -1e30] {
            let range = Range::wished(&*space, ChartPoint::a(DVec3::splat(far)), 2, 0);
            assert_eq!(range.all().len(), 27);
            assert!(range.all().iter().all(|&coord| range.keeps(coord)));
            assert!(!range.keeps(chunk(0, 0, 0)));
        }
        let corner = chunk(i32::MIN, i32::MAX, 0);
        assert_eq!(around(corner, -1, 1).count(), 12);
    }

    #[test]
    fn a_closed_world_has_exactly_the_chunks_that_are_wanted() {
        for radius_m in [16.0, 26.7, 32.0, 64.0] {
            let space = strategy(Geometry::Spherical, radius_m);
            let range = Range::wished(&*space, ChartPoint::a(DVec3::ZERO), 1, 0);
            let all = range.all();
            let cube = around(chunk(0, 0, 0), -6, 6).filter(|&coord| is_in_world(&*space, coord));
            assert_eq!(cube.count() * 2, all.len(), "{radius_m}");
        }
        let open = strategy(Geometry::Hyperbolic, 20.0);
        assert!(is_in_world(&*open, chunk(i32::MIN, 90, 0)));
    }

    #[test]
    fn nothing_is_wanted_before_the_first_wish() {
        assert!(Range::Nothing.all().is_empty() && !Range::Nothing.keeps(chunk(0, 0, 0)));
    }
}
