//! The world: its charts, how an eye sees them, and lengths.

use std::fmt;

use glam::{DMat4, DVec2, DVec3, DVec4, Vec3Swizzles};

use super::chart::SquareChart;
use super::tiles::Tiles;
use crate::kernel::distance;
use crate::tiling::APOTHEM;
use crate::tiling::quilt::Quilt;
use crate::{
    Atlas, CHUNK_CELLS, ChartId, ChartPoint, Crossing, Curvature, Domain, Eye, Geometry, Map,
    Metric, NoiseFrame, NoiseQuilt, Tiled, Viewer,
};

/// How far past an edge a body goes before it changes charts, metres. What it goes past is carried exactly; this keeps a body on
/// the line from flipping to and fro.
const HYSTERESIS_M: f64 = 0.2;
/// The widest tiles, in chunks.
const WIDEST_CHUNKS: f64 = 64.0;
/// Geodesics are followed in steps of at most so many radii: coordinates stay small.
const STEP_RAD: f64 = 1.0;
/// They are followed so far at most, in radii: from one end of the world to the other.
const FARTHEST_RAD: f64 = 160.0;
/// What lies in a chart that is not there is seen so many radii behind the eye.
const NOWHERE_RAD: f64 = 40.0;

/// Hyperbolic space over the plane of squares, five about a corner, one chart for each.
///
/// A chart's number is that of its tile: [`ChartId::FIRST`] is the root, then come the four about it, and so on outwards.
/// Positions are metres of the equiangular chart ([`crate::tiling::equiangular_point`]), y the height over the plane. So the
/// square is a square of the chart, a whole number of chunks wide, and what lies on an edge is at one place along it in both
/// charts. A chart is written to a quarter of its width past its edges.
///
/// Vectors at a place are told in the frame that comes of the chart's axes at its centre by parallel transport straight to the
/// place. [`Metric::in_frame`] takes those of the chart there.
///
/// Nothing here panics: a place past the end of its chart is drawn in to it, one that is no number counts as 0, and what lies in
/// a chart that is not there is seen far behind the eye.
pub struct HyperbolicWorld {
    pub(super) chart: SquareChart,
    pub(super) tiles: Tiles,
}

impl fmt::Debug for HyperbolicWorld {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("HyperbolicWorld")
            .field("radius_m", &self.chart.radius_m)
            .finish_non_exhaustive()
    }
}

impl HyperbolicWorld {
    /// The radii, metres, of tiles 32, 64 and 128 m wide at their middle, to a millimetre; the second is a new world's.
    pub const RADII_M: [f64; 3] = [30.152, 60.305, 120.61];

    /// The world whose radius is nearest to one in metres, such that its tiles are a whole number of chunks wide at their
    /// middle, 1 to 64 of them: [`Metric::radius_m`] has the exact one. What is no number counts as the middle one of
    /// [`Self::RADII_M`].
    pub fn new(radius_m: f64) -> Self {
        let wished_m = if radius_m.is_nan() {
            Self::RADII_M[1]
        } else {
            radius_m
        };
        let chunk = f64::from(CHUNK_CELLS);
        let chunks = (2.0 * APOTHEM * wished_m / chunk).round();
        let half_m = 0.5 * chunk * chunks.clamp(1.0, WIDEST_CHUNKS);
        Self {
            chart: SquareChart {
                radius_m: half_m / APOTHEM,
            },
            tiles: Tiles::new(),
        }
    }

    /// How an eye stands in the model of its chart: the directions of right, up and back, and its point, by columns.
    pub(super) fn pose(&self, eye: &Eye) -> DMat4 {
        let frame = self.chart.frame(eye.point.pos);
        let [right, up, back] =
            [eye.right(), eye.up(), -eye.front()].map(|v| frame * v.extend(0.0));
        DMat4::from_cols(right, up, back, frame.w_axis)
    }

    /// From the model of a chart to view coordinates in radii; none where there is no such chart.
    pub(super) fn sight(&self, eye: &Eye, chart: ChartId) -> Option<DMat4> {
        let way = self.tiles.way(chart, eye.point.chart)?;
        Some(inverse(self.pose(eye)) * way)
    }

    /// View coordinates of a point by what takes its chart's model there.
    fn seen(&self, sight: Option<DMat4>, pos: DVec3) -> DVec4 {
        let nowhere = DVec4::new(0.0, 0.0, NOWHERE_RAD.sinh(), NOWHERE_RAD.cosh());
        let view = sight.map_or(nowhere, |sight| sight * self.chart.point(pos));
        (view.truncate() * self.chart.radius_m).extend(view.w)
    }

    /// How far outside of its chart's square a place is, metres; less than 0 inside.
    fn outside_m(&self, pos: DVec3) -> f64 {
        self.domain(ChartId::FIRST).outside_m(pos.xz())
    }

    /// A point of a chart, whose place on the plane is known in the chart's model, in another chart; none where that one is not
    /// written so far.
    fn carried(&self, point: ChartPoint, level: DVec4, to: ChartId) -> Option<Crossing> {
        let way = self.tiles.way(point.chart, to)?;
        let there = way * level;
        SquareChart::is_written(there).then(|| Crossing {
            // Nothing that is carried gets higher or lower, to the bit.
            point: ChartPoint::new(to, self.chart.pos(there).with_y(point.pos.y)),
            turn_rad: self.chart.turn_rad(point.pos, way),
        })
    }

    /// A place on the plane below or above one of a chart, in the chart's model.
    pub(super) fn level(&self, pos: DVec3) -> DVec4 {
        self.chart.point(pos.with_y(0.0))
    }

    /// The chart whose square a point of a chart's model lies in, and the way there; none past the end of the world.
    fn home(&self, chart: ChartId, point: DVec4) -> Option<(ChartId, DMat4)> {
        let place = self.tiles.frame(chart)?.place(point).ok()?;
        Some((self.tiles.chart(&place.frame)?, place.way.lorentz()))
    }
}

/// A point and a direction there, put right after roundings: what they lack of length and right angle would grow as e^(2d)
/// along the way.
fn straightened(at: DVec4, ahead: DVec4) -> (DVec4, DVec4) {
    let inner = |a: DVec4, b: DVec4| a.truncate().dot(b.truncate()) - a.w * b.w;
    let away = at.truncate();
    let at = away.extend((1.0 + away.length_squared()).sqrt());
    let ahead = ahead + at * inner(at, ahead);
    (at, ahead / inner(ahead, ahead).sqrt())
}

/// The inverse of a Lorentz matrix: `G M^T G`, G = diag(1, 1, 1, -1).
pub(super) fn inverse(matrix: DMat4) -> DMat4 {
    let flip = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0));
    flip * matrix.transpose() * flip
}

impl Atlas for HyperbolicWorld {
    fn domain(&self, _chart: ChartId) -> Domain {
        let half_m = DVec2::splat(self.chart.half_m());
        Domain::Rectangle {
            low: -half_m,
            high: half_m,
        }
    }

    fn has_chart(&self, chart: ChartId) -> bool {
        self.tiles.frame(chart).is_some()
    }

    /// None at the end of the world, 77.7 radii from its middle, past which there is no chart.
    fn cross(&self, point: ChartPoint) -> Option<Crossing> {
        if self.outside_m(point.pos) <= HYSTERESIS_M {
            return None;
        }
        let level = self.level(point.pos);
        let (home, _) = self.home(point.chart, level)?;
        // Past the hysteresis a place may still round to an edge.
        self.carry(point, home).filter(|_| home != point.chart)
    }

    fn carry(&self, point: ChartPoint, to: ChartId) -> Option<Crossing> {
        if to == point.chart {
            return Some(Crossing::within(point));
        }
        self.carried(point, self.level(point.pos), to)
    }

    /// Those that reach so far: none that shares no corner with the chart that the point lies in.
    fn images(&self, point: ChartPoint, reach_m: f64) -> Vec<Crossing> {
        let inside_m = -self.outside_m(point.pos);
        let mut images = Vec::new();
        // Along either axis, what the one chart has as a distance to the edge has the other, too.
        if inside_m > reach_m.min(self.chart.reach_m() - self.chart.half_m()) {
            return images;
        }
        let level = self.level(point.pos);
        let Some((home, _)) = self.home(point.chart, level) else {
            return images;
        };
        let others = std::iter::once(home).chain(self.tiles.around(home));
        for chart in others.filter(|it| *it != point.chart) {
            let image = self.carried(point, level, chart);
            images.extend(image.filter(|it| self.outside_m(it.point.pos) <= reach_m));
        }
        images
    }

    /// Coordinates of a chart change by no more than the way in the space: `|grad x| = sqrt((1 - a^2 - b^2)/(1 - a^2))`. So
    /// it is what a metre of the point's own chart is at most. All of a chart lies within its reach.
    fn spread_m(&self, point: ChartPoint, radius_m: f64, past_m: f64) -> f64 {
        let (half_m, reach_m) = (self.chart.half_m(), self.chart.reach_m());
        let whole_m = reach_m + (half_m + past_m).min(reach_m);
        let stretched_m = radius_m * self.chart.most_stretch(point.pos, radius_m);
        stretched_m.min(whole_m)
    }

    fn noise_frame(&self, _chart: ChartId) -> NoiseFrame {
        NoiseFrame::Upright
    }

    /// The null vector (n, 1) of the north has the product -1/g with the ground's point P, and the way there is g (n, 1) - P.
    fn in_sky_axes(&self, point: ChartPoint, v: DVec3) -> DVec3 {
        let at = self.level(point.pos);
        let (here, n) = (DVec2::new(at.x, at.z), self.ideal_north(point.chart));
        let g = 1.0 / (at.w - here.dot(n));
        let north = (g * n - here * ((1.0 + g) / (1.0 + at.w))).normalize_or(DVec2::NEG_X);
        DVec3::new(-north.dot(v.xz()), v.y, north.y * v.x - north.x * v.z)
    }

    fn ideal_north(&self, chart: ChartId) -> DVec2 {
        self.tiles.north(chart).unwrap_or(DVec2::NEG_X)
    }

    /// The Poincare disc about the root, as large as the plane at its middle. Continuous it is, but the plane is crowded at the
    /// disc's edge: land goes by [`Atlas::quilt`].
    fn noise_point(&self, point: ChartPoint) -> DVec3 {
        let level = self.level(point.pos);
        let at = self.tiles.way(point.chart, ChartId::FIRST);
        let at = at.map_or(level, |way| way * level);
        let scale = 2.0 * self.chart.radius_m / (1.0 + at.w);
        DVec3::new(at.x * scale, point.pos.y, at.z * scale)
    }

    fn tiled(&self) -> Option<&dyn Tiled> {
        Some(self)
    }

    fn quilt(&self, chart: ChartId) -> Option<NoiseQuilt> {
        let quilt = Quilt::new(&self.tiles.frame(chart)?).ok()?;
        let charts = quilt.around().iter().map(|it| self.tiles.chart(it.frame()));
        Some(NoiseQuilt {
            radius_m: self.chart.radius_m,
            charts: charts.collect(),
            quilt,
        })
    }
}

impl Map for HyperbolicWorld {
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        self.seen(self.sight(eye, point.chart), point.pos)
    }

    fn viewer<'a>(&'a self, eye: &'a Eye) -> Viewer<'a> {
        let view = inverse(self.pose(eye));
        let own = self
            .tiles
            .way(eye.point.chart, eye.point.chart)
            .map(|_| view);
        let last = std::cell::Cell::new((eye.point.chart, own));
        Box::new(move |point| {
            let (mut chart, mut sight) = last.get();
            if chart != point.chart {
                chart = point.chart;
                sight = self.tiles.way(chart, eye.point.chart).map(|way| view * way);
                last.set((chart, sight));
            }
            self.seen(sight, point.pos)
        })
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        let away = view.truncate();
        let length_m = away.length();
        let radii = f64::asinh(length_m / self.chart.radius_m);
        let direction = if length_m > 0.0 {
            away / length_m
        } else {
            DVec3::NEG_Z
        };
        self.along(eye, direction, radii * self.chart.radius_m)
    }

    /// Step by step, each in the chart that it leads to, so that far off only the direction's own rounding counts: 1e-16 of it
    /// are `1e-16 sinh(d)` radii at d radii. High up, at y radii, all are `cosh(y)^2` times as coarse. It ends where the world
    /// does, and 13 radii up.
    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        let pose = self.pose(eye);
        let mut chart = eye.point.chart;
        let (mut at, mut ahead) = (pose.w_axis, pose * direction.extend(0.0));
        let radii = (distance_m / self.chart.radius_m).clamp(-FARTHEST_RAD, FARTHEST_RAD);
        let steps = (radii.abs() / STEP_RAD).ceil().max(1.0);
        let (sinh, cosh) = ((radii / steps).sinh(), (radii / steps).cosh());
        for _ in 0..steps as u32 {
            let next = at * cosh + ahead * sinh;
            let Some((home, way)) = self.home(chart, next) else {
                break;
            };
            let onward = way * (at * sinh + ahead * cosh);
            (at, ahead) = straightened(way * next, onward);
            chart = home;
        }
        ChartPoint::new(chart, self.chart.pos(at))
    }

    /// In the model of the eye's chart: in that of the first it would grow as e^d with the distance d from there.
    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let at = self.chart.point(point.pos);
        let way = self.tiles.way(point.chart, eye.point.chart);
        way.map_or(at, |way| way * at)
    }

    fn port_normal(&self, _eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        self.chart.normal(point.pos, normal)
    }
}

impl Metric for HyperbolicWorld {
    fn curvature(&self) -> Curvature {
        Curvature::of_radius(-1.0, self.chart.radius_m)
    }

    /// Infinite where one of the charts is not there.
    fn distance_m(&self, a: ChartPoint, b: ChartPoint, _eye: &Eye) -> f64 {
        let Some(way) = self.tiles.way(b.chart, a.chart) else {
            return f64::INFINITY;
        };
        let (a, b) = (self.chart.point(a.pos), way * self.chart.point(b.pos));
        let [a, b] = [a, b].map(|it| it.truncate().to_array());
        self.chart.radius_m * distance::hyperbolic_far(a, b)
    }

    fn geometry(&self) -> Geometry {
        Geometry::HyperbolicWorld
    }

    fn moves_in_chart(&self) -> bool {
        false
    }

    fn in_frame(&self, at: ChartPoint, velocity: DVec3) -> DVec3 {
        self.chart.in_frame(at.pos, velocity)
    }

    fn in_chart(&self, at: ChartPoint, velocity: DVec3) -> DVec3 {
        self.chart.in_chart(at.pos, velocity)
    }
}
