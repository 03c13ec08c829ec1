//! The charts of a world, and how they hang together.

use std::fmt::Debug;

use glam::{DVec2, DVec3, Vec3Swizzles};

use crate::tiling::quilt::Quilt;
use crate::{CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Crossing, Globe, Tiled};

/// The part of a chart's ground plan that is the chart's own. What lies farther out is another chart's, and is written
/// here only as far as what stands near the edge needs it.
///
/// Shaders know a rectangle from its chart and a disc from the space ([`crate::SpaceUniform`]'s `level_m`), so that all discs of
/// a space are alike and lie about the reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Domain {
    /// All of it: there is no other chart.
    Everywhere,
    /// A disc about the centre.
    Disc {
        /// Its radius, metres.
        radius_m: f64,
    },
    /// A rectangle with its sides along the axes; where a corner is infinite it has no end, so that a quarter and a half of
    /// the plan are rectangles, too.
    Rectangle {
        /// The least x and z, metres.
        low: DVec2,
        /// The greatest x and z, metres.
        high: DVec2,
    },
}

impl Domain {
    /// The radius of a disc, metres.
    pub fn radius_m(self) -> Option<f64> {
        match self {
            Self::Disc { radius_m } => Some(radius_m),
            Self::Everywhere | Self::Rectangle { .. } => None,
        }
    }

    /// How far it reaches from the centre along the axes, metres.
    pub fn half_width_m(self) -> f64 {
        match self {
            Self::Everywhere => f64::INFINITY,
            Self::Disc { radius_m } => radius_m,
            Self::Rectangle { low, high } => low.abs().max(high.abs()).max_element(),
        }
    }

    /// How far outside a place of the plan lies, metres; less than 0 inside, by how far it is to the edge.
    pub fn outside_m(self, at: DVec2) -> f64 {
        match self {
            Self::Everywhere => f64::NEG_INFINITY,
            Self::Disc { radius_m } => at.length() - radius_m,
            Self::Rectangle { low, high } => {
                let past = (low - at).max(at - high);
                if past.max_element() > 0.0 {
                    past.max(DVec2::ZERO).length()
                } else {
                    past.max_element()
                }
            }
        }
    }

    /// [`Domain::outside_m`] of the place of a box for which it is least.
    pub fn least_outside_m(self, low: DVec2, high: DVec2) -> f64 {
        self.outside_m(self.middle().clamp(low, high))
    }

    /// Whether a chunk of the chart comes within so many metres of it.
    pub fn reaches(self, coord: ChunkCoord, past_m: f64) -> bool {
        self.least_outside_m(coord.min().xz(), coord.max().xz()) <= past_m
    }

    /// How many chunks it is at most along the axes from the centre to one that comes within so many metres of it; more
    /// than there are where the domain has no end.
    pub fn side_chunks(self, past_m: f64) -> i32 {
        ((self.half_width_m() + past_m) / f64::from(CHUNK_CELLS)).ceil() as i32
    }

    /// [`Domain::outside_m`] of the corner of a box for which it is greatest: the domains are convex.
    pub fn most_outside_m(self, low: DVec2, high: DVec2) -> f64 {
        let middle = self.middle();
        let farther = |low: f64, high: f64, middle: f64| {
            let is_low = middle - low > high - middle;
            if is_low { low } else { high }
        };
        self.outside_m(DVec2::new(
            farther(low.x, high.x, middle.x),
            farther(low.y, high.y, middle.y),
        ))
    }

    /// The place that is farthest inside; along an axis without an end infinitely far out.
    fn middle(self) -> DVec2 {
        let Self::Rectangle { low, high } = self else {
            return DVec2::ZERO;
        };
        let between = |low: f64, high: f64| {
            let middle = f64::midpoint(low, high);
            if middle.is_nan() { 0.0 } else { middle }
        };
        DVec2::new(between(low.x, high.x), between(low.y, high.y))
    }
}

/// Heights in chart metres between which a space can hold a world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeightLimits {
    /// Nothing is dug below this.
    pub bedrock_m: f64,
    /// The natural ground lies no lower than this.
    pub ground_min_m: f64,
    /// The natural ground lies no higher than this.
    pub ground_max_m: f64,
    /// Nothing is built or flown above this.
    pub ceiling_m: f64,
}

/// How the space in which terrain noise is sampled lies in a chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoiseFrame {
    /// Square with the chart.
    Square(SquareFrame),
    /// About the centre of a sphere: a column of the chart is part of a radius.
    Radial {
        /// The sphere's radius, metres.
        radius_m: f64,
    },
    /// Columns of the chart stand upright in it, a metre high for each metre; where, only [`Atlas::noise_point`] says.
    Upright,
}

impl NoiseFrame {
    /// By how many quarter turns about +y a chart is turned against the space, 0 to 3.
    pub fn quarter_turns(self) -> u8 {
        match self {
            Self::Square(frame) => frame.quarter_turns % 4,
            Self::Radial { .. } | Self::Upright => 0,
        }
    }
}

/// A chart's place in a space whose axes are the chart's but for quarter turns, exact for coordinates in whole metres.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SquareFrame {
    /// Quarter turns about +y, as of `Quat::from_rotation_y`: one takes +z to +x.
    pub quarter_turns: u8,
    /// Where the chart's centre lies, x and z in whole metres.
    pub centre_m: DVec2,
}

impl SquareFrame {
    /// A vector of the chart in that space.
    pub fn turned(self, v: DVec3) -> DVec3 {
        match self.quarter_turns % 4 {
            0 => v,
            1 => DVec3::new(v.z, v.y, -v.x),
            2 => DVec3::new(-v.x, v.y, -v.z),
            _ => DVec3::new(-v.z, v.y, v.x),
        }
    }

    /// A vector of that space in the chart.
    pub fn turned_back(self, v: DVec3) -> DVec3 {
        let back = Self {
            quarter_turns: 4 - self.quarter_turns % 4,
            ..self
        };
        back.turned(v)
    }

    /// A place of the chart in that space.
    #[inline]
    pub fn placed(self, pos: DVec3) -> DVec3 {
        self.turned(pos) + DVec3::new(self.centre_m.x, 0.0, self.centre_m.y)
    }

    /// A place of that space in the chart.
    pub fn taken(self, pos: DVec3) -> DVec3 {
        self.turned_back(pos - DVec3::new(self.centre_m.x, 0.0, self.centre_m.y))
    }
}

/// The charts of a world.
///
/// Laws, which `tests/it/space/atlas.rs` checks for every space that it names: a place is written in a chart at most once,
/// but about the tip of a cone; [`Atlas::cross`] of a place that has crossed is none; [`Atlas::carry`] there and back is the
/// identity where both are defined. A chart never meets itself, and what is carried turns about +y alone.
pub trait Atlas: Debug + Send + Sync {
    /// The part of a chart that is its own.
    fn domain(&self, _chart: ChartId) -> Domain {
        Domain::Everywhere
    }

    /// Whether there is such a chart.
    fn has_chart(&self, chart: ChartId) -> bool {
        chart == ChartId::FIRST
    }

    /// Whether who walks straight on comes round: the world is finite, and all of its land is at hand.
    fn is_closed(&self) -> bool {
        self.all_charts().is_some()
    }

    /// All charts of a closed world, which has [`Atlas::limits`], too; none of one that goes on for ever.
    fn all_charts(&self) -> Option<&[ChartId]> {
        None
    }

    /// What scripts, probes and the display call a chart: A where there is one, and the letters of a globe's hemispheres;
    /// others by their numbers.
    fn chart_name(&self, chart: ChartId) -> String {
        if chart == ChartId::FIRST {
            "A".to_owned()
        } else {
            chart.to_string()
        }
    }

    /// The globe that the ground is, of a world in which land hangs overhead and every way leads round.
    fn globe(&self) -> Option<Globe> {
        None
    }

    /// The point in the chart that it belongs to, once it is outside of its own by more than the hysteresis that keeps a
    /// body standing on the line from flipping to and fro.
    fn cross(&self, _point: ChartPoint) -> Option<Crossing> {
        None
    }

    /// The same point of the space written in a chart, which may be its own; none where that chart does not reach so far.
    fn carry(&self, point: ChartPoint, to: ChartId) -> Option<Crossing> {
        (to == point.chart).then(|| Crossing::within(point))
    }

    /// Writes a point in the chart of another, at the place to which the shortest way from that other leads. It differs
    /// from [`Atlas::carry`] only where two ways go round something, as on a cone. A point of the same chart stays as it is
    /// if both lie in its domain.
    fn carry_near(&self, point: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        self.carry(point, to.chart)
    }

    /// The way from a place to another along the axes of the first's chart, metres: the difference of coordinates where the
    /// second is written near the first. None where it is not, nor told by [`Atlas::tiled`].
    fn way_m(&self, from: ChartPoint, to: ChartPoint) -> Option<DVec3> {
        let near = self.carry_near(to, from);
        let written = near.map(|near| near.point.pos - from.pos);
        written.or_else(|| self.tiled()?.level_way_m(from, to))
    }

    /// The same point in every other chart whose domain comes within `reach_m` metres of it.
    fn images(&self, _point: ChartPoint, _reach_m: f64) -> Vec<Crossing> {
        Vec::new()
    }

    /// Half the side of a square about a point's image in another chart. The square holds all places within `radius_m`
    /// metres of the point along its own chart, but for those more than `past_m` metres outside of the other's domain.
    fn spread_m(&self, _point: ChartPoint, radius_m: f64, _past_m: f64) -> f64 {
        radius_m
    }

    /// What is near in a world in tiles, of which more than [`Atlas::images`] knows may be in view; none where images of a place
    /// tell all that is near.
    fn tiled(&self) -> Option<&dyn Tiled> {
        None
    }

    /// Heights that the space limits a world to.
    fn limits(&self) -> Option<HeightLimits> {
        None
    }

    /// How the space in which terrain noise is sampled lies in a chart.
    fn noise_frame(&self, _chart: ChartId) -> NoiseFrame {
        NoiseFrame::Square(SquareFrame::default())
    }

    /// A vector of a chart in the axes that all charts have in common, in which the light from a sky is told: those of the
    /// first chart. Where charts have none in common, as in a closed world, the vector as it is.
    fn in_common_axes(&self, chart: ChartId, v: DVec3) -> DVec3 {
        match self.noise_frame(chart) {
            NoiseFrame::Square(frame) => frame.turned(v),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => v,
        }
    }

    /// A vector of the chart's frame at a point in the axes in which the light from a sky is told: y up, and north is -x. They
    /// are the common ones, but where charts have none under a sky: there they turn from place to place, smoothly over all
    /// edges.
    fn in_sky_axes(&self, point: ChartPoint, v: DVec3) -> DVec3 {
        self.in_common_axes(point.chart, v)
    }

    /// Towards the ideal point in the north from the middle of a chart, a unit vector of x and z, where the axes of
    /// [`Atlas::in_sky_axes`] are told by one; else 0.
    fn ideal_north(&self, _chart: ChartId) -> DVec2 {
        DVec2::ZERO
    }

    /// Where the terrain noise is sampled, in metres: continuous over the whole space.
    fn noise_point(&self, point: ChartPoint) -> DVec3 {
        match self.noise_frame(point.chart) {
            NoiseFrame::Square(frame) => frame.placed(point.pos),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => point.pos,
        }
    }

    /// The patches that the noise of a chart is found in, of a world in tiles whose noise knows no centre. There it is not
    /// sampled at [`Atlas::noise_point`], but in each patch, at the place in it.
    fn quilt(&self, _chart: ChartId) -> Option<NoiseQuilt> {
        None
    }
}

/// The patches that the noise of a chart is found in.
#[derive(Debug, Clone)]
pub struct NoiseQuilt {
    /// Metres of a radius of the world.
    pub radius_m: f64,
    /// The chart's tile and those about it.
    pub quilt: Quilt,
    /// The charts of [`Quilt::around`], in its order.
    pub charts: Vec<Option<ChartId>>,
}

impl NoiseQuilt {
    /// X/W at x of the chart, or Z/W at z, metres. What is no number counts as 0.
    pub fn tangent(&self, along_m: f64) -> f64 {
        let along = along_m / self.radius_m;
        if along.is_nan() { 0.0 } else { along.tanh() }
    }

    /// X/W and Z/W by [`Self::tangent`] of each, drawn in to where the chart is written: nobody asks what lies farther out.
    pub fn written(&self, at: DVec2) -> DVec2 {
        at.clamp(DVec2::splat(-WRITTEN_TANH), DVec2::splat(WRITTEN_TANH))
    }
}

/// X/W along an axis where a chart ends, a quarter of the width of its square past the edge.
const WRITTEN_TANH: f64 = 0.661_770_042_700_383_5;
