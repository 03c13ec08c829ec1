//! What is near in a world in tiles, where the chart of a place is not written where somebody stands.

use glam::{DVec2, DVec3, IVec2, IVec3, Vec3Swizzles};

use crate::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Domain};

/// How far a box of a ground plan is from a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Away {
    /// To the nearest of it, metres, as [`Tiled::away_m`] has it.
    pub nearest_m: f64,
    /// The way to its middle, metres: x and z of [`Tiled::level_way_m`].
    pub way_m: DVec2,
}

/// A world whose charts are tiles, all with one domain, of which there may be more in view than share a corner with the player's. What is near
/// is told by lengths on the level y = 0.
pub trait Tiled {
    /// The charts whose domains come within so many metres of a place, nearest first; the place's own is among them.
    fn charts_within(&self, at: ChartPoint, reach_m: f64) -> Vec<ChartId>;

    /// Of each of these charts, how far some boxes are from the place, each from its least x and z to its greatest: many at once, for
    /// a quarter of what they cost one by one. Nothing where the place's chart is not there.
    fn boxes_within(
        &self,
        at: ChartPoint,
        reach_m: f64,
        boxes: &[[DVec2; 2]],
    ) -> Vec<(ChartId, Vec<Away>)>;

    /// How far it is from a place to the nearest of a box of a chart's ground plan from its least x and z to its greatest,
    /// metres: 0 inside, infinite where there is no such chart.
    fn away_m(&self, at: ChartPoint, chart: ChartId, low: DVec2, high: DVec2) -> f64;

    /// The way from a place to another, metres: as long as the shortest on the level, in the direction in which that sets
    /// out along the axes of the first's chart, and with the height from the one to the other. None where one of the charts is
    /// not there.
    fn level_way_m(&self, from: ChartPoint, to: ChartPoint) -> Option<DVec3>;

    /// Between which lines of a chart's grid a place lies, metres: lines go on from edge to edge of the plane, so that every place has
    /// some x and some z, though the chart be written nowhere near. None where one of the charts is not there.
    fn grid_lines_m(&self, at: ChartPoint, chart: ChartId) -> Option<DVec2>;

    /// The least and the greatest azimuth at which a box of a chart's ground plan is seen from a place, from its least x and z to its
    /// greatest, radians as [`crate::SightCell::azimuth_rad`]; less than half a turn apart. None where the place lies over the box,
    /// or one of the charts is not there.
    fn azimuths_rad(
        &self,
        at: ChartPoint,
        chart: ChartId,
        low: DVec2,
        high: DVec2,
    ) -> Option<[f64; 2]>;

    /// How far land is to be there in place of a flat view of so many metres: no farther than that, nor than it is of use, and
    /// with at most twice as much land as the flat view's square of that half side. It never falls with the view.
    fn land_reach_m(&self, view_m: f64) -> f64;

    /// The radius of a disc of the level with so much land, square metres, in metres.
    fn disc_m(&self, land_m2: f64) -> f64;

    /// The chart over a side of one's domain, and the side of its own that lies there. Sides are counted from +x by quarter turns
    /// towards +z, 0 to 3.
    fn over(&self, chart: ChartId, side: u8) -> Option<(ChartId, u8)>;

    /// How many edges are between a chart's tile and the first one at least; none where there is no such chart.
    fn edges_from_first(&self, chart: ChartId) -> Option<usize>;

    /// How a chart's tile is joined to those about it.
    fn joins(&self, chart: ChartId) -> Joins;
}

/// What of a tile tells those on both sides of an edge and about a corner apart, so that all of them can read one pattern there.
/// Sides are counted as in [`Tiled::over`]; corner n lies between the sides n and n + 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Joins {
    /// Whether the tile over a side comes first by its chart.
    pub is_second: [bool; 4],
    /// How many tiles one goes through about a corner, as [`about_corner`] does, from this one to the one whose chart comes first.
    pub about: [u8; 4],
}

impl Joins {
    /// By what lies over sides. At the end of a world, where that is nothing, a tile comes first.
    pub fn of(tiled: &dyn Tiled, chart: ChartId) -> Self {
        let is_first = |side| tiled.over(chart, side).is_none_or(|(over, _)| chart < over);
        let about = |corner| {
            let about = about_corner(tiled, chart, corner);
            let places = about.iter().zip(0..);
            places.min().map_or(0, |(_, place)| place)
        };
        Self {
            is_second: [0, 1, 2, 3].map(|side| !is_first(side)),
            about: [0, 1, 2, 3].map(about),
        }
    }

    /// For shaders: a bit for each side, then three for each corner.
    pub fn bits(self) -> u32 {
        let sides = (0..4).map(|side| u32::from(self.is_second[side]) << side);
        let corners = (0..4).map(|corner| u32::from(self.about[corner]) << (4 + 3 * corner));
        sides.chain(corners).sum()
    }
}

/// The outward steps over the sides of a domain, as [`Tiled::over`] counts them.
const SIDES: [IVec2; 4] = [IVec2::X, IVec2::Y, IVec2::NEG_X, IVec2::NEG_Y];

/// The chunk over a face of another, by the step to it, 1 along an axis: of its own chart, or in a world in tiles, where the
/// step leads past an edge, the chunk of the next chart that has the same face ([`fits`]). Where edges run through the middle of
/// chunks it is the one that the same stretch of the edge runs through.
pub fn beside(atlas: &dyn Atlas, coord: ChunkCoord, step: IVec3) -> ChunkCoord {
    let next = coord.offset(step);
    if step.y != 0 {
        return next;
    }
    let over = || {
        let tiled = atlas.tiled()?;
        let half = half_width(atlas.domain(coord.chart))?.ceil() as i32;
        let own = |it: ChunkCoord| {
            let [x, _, z] = it.index.to_array();
            (-half..half).contains(&x) && (-half..half).contains(&z)
        };
        if own(next) || !own(coord) {
            return None;
        }
        let side = SIDES.iter().position(|it| *it == step.xz())?;
        let (chart, back) = tiled.over(coord.chart, side as u8)?;
        // Twice the middle, which is whole. What lies along an edge runs the other way as seen from the next tile.
        let middle = 2 * coord.index.xz() + 1;
        let (out, along) = (middle.dot(SIDES[side]), middle.dot(SIDES[(side + 1) % 4]));
        let back = usize::from(back % 4);
        let there = (out * SIDES[back] - along * SIDES[(back + 1) % 4] - 1) / 2;
        let index = IVec3::new(there.x, coord.index.y, there.y);
        Some(ChunkCoord::new(chart, index))
    };
    over().unwrap_or(next)
}

/// The most tiles that are looked for about a corner.
const MOST_ABOUT: usize = 8;

/// The tiles about a corner of a chart's domain, each with the number that the corner has there: the chart's own first, then as
/// one comes round over the edges. Corners are counted as sides are, each between a side and the next. Empty where the way round
/// does not close, at the end of the world.
pub fn about_corner(tiled: &dyn Tiled, chart: ChartId, corner: u8) -> Vec<(ChartId, u8)> {
    let first = (chart, corner % 4);
    let (mut about, mut at) = (vec![first], first);
    while let Some((over, back)) = tiled.over(at.0, at.1) {
        // Come in over a side, one has the corner between it and the one before.
        at = (over, (back + 3) % 4);
        if at == first {
            return about;
        }
        if about.len() == MOST_ABOUT {
            break;
        }
        about.push(at);
    }
    Vec::new()
}

/// Where a point is as seen from a place of a chart: as written there, and else in the direction and at the distance at which
/// the shortest way on the level leads to it, metres. None where no way is known.
pub fn as_seen_from(atlas: &dyn Atlas, place: ChartPoint, point: ChartPoint) -> Option<DVec3> {
    if let Some(written) = atlas.carry(point, place.chart) {
        return Some(written.point.pos);
    }
    let way = atlas.tiled()?.level_way_m(place, point)?;
    Some(place.pos + way)
}

/// Whether a chart is a tile of whole chunks, so that those of the next have the same faces at its edges.
pub fn fits(atlas: &dyn Atlas, chart: ChartId) -> bool {
    let half = atlas.tiled().and_then(|_| half_width(atlas.domain(chart)));
    half.is_some_and(|half| half.fract() == 0.0)
}

/// How many chunks it is from the middle of a square domain to its edges.
fn half_width(domain: Domain) -> Option<f64> {
    let Domain::Rectangle { low, high } = domain else {
        return None;
    };
    let is_square = low == -high && high.x == high.y;
    is_square.then_some(high.x / f64::from(CHUNK_CELLS))
}
