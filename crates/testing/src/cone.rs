//! A flat cone in three charts, each a quarter of a plane about the tip: three quarters of a turn lead round it, and who
//! has gone round is turned by the quarter that is missing.
//!
//! A chart unrolls the cone about its own quarter: the angle about the tip, counted from the quarter's middle, goes from
//! half a turn backwards to half a turn ahead. Of that three quarters of a turn are all of the cone, each place once, and
//! that is what is carried; what is left is written a second time, from either side up to the line behind the tip, for what
//! stands at the tip. A straight way passes the tip on its left or on its right. The shorter of the two turns by at most
//! three eighths of a turn, so that it is straight in the chart of its start.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use antipode_geometry::{
    Atlas, BoundingCylinder, ChartId, ChartPoint, Crossing, Curvature, Domain, Euclidean, Eye, Map,
    MapShader, Metric, NoiseFrame, Optics, Projection, SightCell, SpaceUniform, SquareFrame,
};
use glam::{DMat4, DVec2, DVec3, DVec4, Vec3Swizzles};

/// Charts about the tip.
const QUARTERS: i32 = 3;
/// How far past an edge a body goes before it changes charts, metres.
const HYSTERESIS_M: f64 = 0.2;
/// The noise is sampled with this scale, so that it is nowhere steeper than in flat space: a quarter is spread to a third of a
/// turn, which stretches it across by the square root of 3/2.
const NOISE_SCALE: f64 = 0.816_496_580_927_726;

/// The cone. The tip is at the centre of every chart, whose quarter lies between +x and +z.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cone;

impl Cone {
    /// The chart of a quarter, counted round the tip from +x to +z.
    pub fn chart(quarter: i32) -> ChartId {
        ChartId::new(quarter.rem_euclid(QUARTERS).unsigned_abs().into())
    }

    /// The quarter of a chart.
    pub fn quarter(chart: ChartId) -> i32 {
        (chart.number() % 3) as i32
    }

    /// The place at an angle about the tip and a distance from it: radians from +x of the first chart to its +z and on,
    /// three quarters of a turn lead to the same place again.
    pub fn around(angle_rad: f64, away_m: f64, height_m: f64) -> ChartPoint {
        let angle_rad = angle_rad.rem_euclid(f64::from(QUARTERS) * FRAC_PI_2);
        let quarter = (angle_rad / FRAC_PI_2).floor();
        let (sin, cos) = (angle_rad - quarter * FRAC_PI_2).sin_cos();
        let pos = DVec3::new(away_m * cos, height_m, away_m * sin);
        ChartPoint::new(Self::chart(quarter as i32), pos)
    }

    /// By how many quarters a place is ahead of the chart that it is written in.
    fn ahead(pos: DVec3) -> i32 {
        match (pos.x >= 0.0, pos.z >= 0.0) {
            (true, true) => 0,
            (false, true) => 1,
            (true, false) => -1,
            (false, false) if pos.x < pos.z => 2,
            (false, false) => -2,
        }
    }

    /// A point in the chart so many quarters ahead, as one gets there round the tip.
    fn stepped(point: ChartPoint, quarters: i32) -> Crossing {
        if quarters == 0 {
            return Crossing::within(point);
        }
        let frame = SquareFrame {
            quarter_turns: quarters.rem_euclid(4) as u8,
            ..SquareFrame::default()
        };
        let chart = Self::chart(Self::quarter(point.chart) + quarters);
        Crossing {
            point: ChartPoint::new(chart, frame.turned(point.pos)),
            turn_rad: f64::from(quarters) * FRAC_PI_2,
        }
    }

    /// How many quarters are ahead to a chart, by the side that is nearer: none, one, or one backwards.
    fn between(from: ChartId, to: ChartId) -> i32 {
        (Self::quarter(to) - Self::quarter(from) + 1).rem_euclid(QUARTERS) - 1
    }

    /// A point in a chart, so many quarters farther round the tip than its own quarter is nearest.
    fn carried(point: ChartPoint, to: ChartId, farther: i32) -> Crossing {
        let own = Self::ahead(point.pos);
        let at_home = Self::stepped(point, own).point.chart;
        Self::stepped(point, own + Self::between(at_home, to) + farther)
    }

    /// The angle about the tip from +x, as the chart has it: from half a turn behind the quarter's middle to half a turn
    /// ahead of it, radians.
    fn angle_rad(pos: DVec3) -> f64 {
        let middle = DVec2::new(pos.x + pos.z, pos.z - pos.x);
        FRAC_PI_4 + middle.y.atan2(middle.x)
    }

    /// A point as somebody has it who stands at a place: where the shorter way round the tip leads to it.
    fn seen(from: ChartPoint, point: ChartPoint) -> Crossing {
        let own = Self::ahead(point.pos);
        let home = Self::stepped(point, own).point;
        let quarters = Self::between(from.chart, home.chart);
        let ahead_rad =
            f64::from(quarters) * FRAC_PI_2 + Self::angle_rad(home.pos) - Self::angle_rad(from.pos);
        let around = if ahead_rad > 0.75 * PI {
            QUARTERS
        } else if ahead_rad < -0.75 * PI {
            -QUARTERS
        } else {
            0
        };
        Self::stepped(point, own - quarters + around)
    }

    /// A place that is reached straight from another, both written in its chart, in the quarter that it lies in.
    fn reached(from: ChartPoint, pos: DVec3) -> ChartPoint {
        let start_rad = Self::angle_rad(from.pos);
        let turned = Self::angle_rad(pos) - start_rad;
        let turned = (turned + PI).rem_euclid(TAU) - PI;
        let quarters = ((start_rad + turned) / FRAC_PI_2).floor() as i32;
        Self::stepped(ChartPoint::new(from.chart, pos), quarters).point
    }

    fn noise(point: ChartPoint) -> DVec3 {
        let home = Self::stepped(point, Self::ahead(point.pos)).point;
        let quarter = Self::quarter(home.chart);
        // Three directions a third of a turn apart: an edge is the same one in both of its charts.
        let edge = |number: i32| match number.rem_euclid(QUARTERS) {
            0 => DVec2::X,
            1 => DVec2::new(-0.5, 0.75_f64.sqrt()),
            _ => DVec2::new(-0.5, -(0.75_f64.sqrt())),
        };
        let at = home.pos.x * edge(quarter) + home.pos.z * edge(quarter + 1);
        DVec3::new(NOISE_SCALE * at.x, point.pos.y, NOISE_SCALE * at.y)
    }

    /// A point as the eye has it.
    fn from_eye(eye: &Eye, point: ChartPoint) -> ChartPoint {
        Self::seen(eye.point, point).point
    }
}

impl Atlas for Cone {
    fn domain(&self, _chart: ChartId) -> Domain {
        Domain::Rectangle {
            low: DVec2::ZERO,
            high: DVec2::INFINITY,
        }
    }

    fn has_chart(&self, chart: ChartId) -> bool {
        Self::chart(Self::quarter(chart)) == chart
    }

    fn cross(&self, point: ChartPoint) -> Option<Crossing> {
        let is_past = self.domain(point.chart).outside_m(point.pos.xz()) > HYSTERESIS_M;
        is_past.then(|| Self::stepped(point, Self::ahead(point.pos)))
    }

    fn carry(&self, point: ChartPoint, to: ChartId) -> Option<Crossing> {
        if to == point.chart {
            return Some(Crossing::within(point));
        }
        self.has_chart(to).then(|| Self::carried(point, to, 0))
    }

    fn carry_near(&self, point: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        self.has_chart(to.chart).then(|| Self::seen(to, point))
    }

    fn images(&self, point: ChartPoint, reach_m: f64) -> Vec<Crossing> {
        let others = (0..QUARTERS).map(Self::chart);
        let others = others.filter(|chart| *chart != point.chart);
        let images = others.map(|chart| Self::carried(point, chart, 0));
        let is_near = |image: &Crossing| {
            let domain = self.domain(image.point.chart);
            domain.outside_m(image.point.pos.xz()) <= reach_m
        };
        images.filter(is_near).collect()
    }

    /// What is written behind the tip lies on the other side of it than what it is near to.
    fn spread_m(&self, point: ChartPoint, radius_m: f64, past_m: f64) -> f64 {
        let tip_m = point.pos.xz().length();
        if tip_m > radius_m + past_m {
            radius_m
        } else {
            2.0 * tip_m + radius_m
        }
    }

    fn noise_frame(&self, _chart: ChartId) -> NoiseFrame {
        NoiseFrame::Upright
    }

    fn noise_point(&self, point: ChartPoint) -> DVec3 {
        Self::noise(point)
    }
}

impl Map for Cone {
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        Euclidean.view_point(eye, Self::from_eye(eye, point))
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        Self::reached(eye.point, Euclidean.chart_point(eye, view).pos)
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        self.chart_point(eye, (direction * distance_m).extend(1.0))
    }

    fn curved(&self, _eye: &Eye, point: ChartPoint) -> DVec4 {
        Self::noise(point).extend(1.0)
    }

    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        Euclidean.port_normal(eye, point, normal)
    }
}

impl Metric for Cone {
    fn curvature(&self) -> Curvature {
        Curvature::FLAT
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, _eye: &Eye) -> f64 {
        a.pos.distance(Self::seen(a, b).point.pos)
    }
}

impl Optics for Cone {
    fn trims(&self, _eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> bool {
        self.domain(chart).most_outside_m(min.xz(), max.xz()) > 0.0
    }

    fn sight_cell(&self, eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        if chart == eye.point.chart {
            return Euclidean.sight_cell(eye, chart, min, max);
        }
        // What is seen past the tip is seen on either side of it.
        SightCell::EVERYWHERE
    }

    fn sight_cell_of(&self, eye: &Eye, cylinder: &BoundingCylinder) -> SightCell {
        let [min, max] = cylinder.square(DVec3::new(cylinder.radius_m, 0.0, cylinder.radius_m));
        self.sight_cell(eye, cylinder.chart, min, max)
    }

    fn clip_from_view(&self, eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        Euclidean.clip_from_view(eye, projection, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        Euclidean.view_matrix(eye)
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        Euclidean.uniform(eye, projection)
    }

    fn shader(&self) -> &'static MapShader {
        Euclidean.shader()
    }
}
