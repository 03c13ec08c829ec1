//! The three-sphere in two cylindrical charts that meet at the equator.
//!
//! The ground lies along the great sphere y = 0. Hemisphere A is the cylindrical chart about
//! the pole (0, 0, 0, 1), B about (0, 0, 0, -1), each out to a quarter turn. For B the chart is
//! first mirrored by G = diag(-1, 1, 1) and then w is negated: B = diag(-1, 1, 1, -1) A, a
//! rotation, so orientation, winding and "up" are the same in both.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use glam::{DMat4, DVec3, DVec4};

use super::globe::{Globe, is_b};
use crate::kernel::{distance, sphere};
use crate::projection::Depth;
use crate::sight::{Axis, Plan};
use crate::{
    Atlas, BoundingCylinder, ChartId, ChartPoint, Crossing, Curvature, Domain, Eye, HeightLimits,
    Map, MapShader, Metric, NoiseFrame, Optics, Projection, SightCell, SpaceUniform, Viewer,
    shader,
};

/// How far past the equator a body goes before it changes charts, in metres. Any overshoot is
/// exact; this only keeps a body that stands on the line from flipping to and fro.
const CROSSING_HYSTERESIS_M: f64 = 0.2;

/// The three-sphere of a given radius.
#[derive(Debug, Clone, Copy)]
pub struct Spherical {
    radius_m: f64,
}

/// The chart on the far side of the equator.
fn other(chart: ChartId) -> ChartId {
    if is_b(chart) {
        ChartId::FIRST
    } else {
        ChartId::SECOND
    }
}

/// The mirror G of hemisphere B's chart.
fn mirrored(chart: ChartId, v: DVec3) -> DVec3 {
    sphere::mirrored(is_b(chart), v.to_array()).into()
}

/// The 4-vector of hemisphere A moved to its place in the given hemisphere.
fn placed(chart: ChartId, v: DVec4) -> DVec4 {
    sphere::placed(is_b(chart), v.to_array()).into()
}

/// A velocity with its part along a level direction and the level part across it made so many times as long.
fn scaled(out: DVec3, [along, across]: [f64; 2], velocity: DVec3) -> DVec3 {
    let away = out * velocity.dot(out);
    let level = velocity.with_y(0.0);
    (away * along + (level - away) * across).with_y(velocity.y)
}

impl Spherical {
    /// `radius_m` is the sphere's radius in metres, positive and finite.
    pub fn new(radius_m: f64) -> Self {
        Self { radius_m }
    }

    /// The point of the unit three-sphere that a chart point is.
    fn model(self, point: ChartPoint) -> DVec4 {
        let p = (point.pos / self.radius_m).to_array();
        sphere::point(is_b(point.chart), p).into()
    }

    /// A chart direction at a chart point as a tangent of the unit three-sphere.
    fn tangent(self, point: ChartPoint, direction: DVec3) -> DVec4 {
        let p = (point.pos / self.radius_m).to_array();
        sphere::direction(is_b(point.chart), p, direction.to_array()).into()
    }

    /// The rotation that takes the model to view coordinates, in units of the radius.
    fn view(self, eye: &Eye) -> DMat4 {
        DMat4::from_cols(
            self.tangent(eye.point, eye.right()),
            self.tangent(eye.point, eye.up()),
            self.tangent(eye.point, -eye.front()),
            self.model(eye.point),
        )
        .transpose()
    }

    fn metres(self, unit: DVec4) -> DVec4 {
        (unit.truncate() * self.radius_m).extend(unit.w)
    }

    fn units(self, metres: DVec4) -> DVec4 {
        (metres.truncate() / self.radius_m).extend(metres.w)
    }

    /// The chart point that a point of the unit three-sphere is, in the hemisphere it lies in.
    fn unmodel(self, x: DVec4) -> ChartPoint {
        let level = x.x.hypot(x.z);
        let y = x.y.atan2(level.hypot(x.w));
        let chart = if level.atan2(x.w) > FRAC_PI_2 {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        let r = level.atan2(placed(chart, x).w);
        let per_level = if level > 0.0 { r / level } else { 0.0 };
        let unit = DVec3::new(x.x * per_level, y, x.z * per_level);
        ChartPoint::new(chart, mirrored(chart, unit) * self.radius_m)
    }

    /// The way out from a chart's centre at a point, and how long a metre of the chart is along it and across it: with the
    /// point `cos y (sin r c, cos r)` at the height y these are cos y and cos y sin r / r; upright it is a metre.
    fn level_lengths(self, at: ChartPoint) -> (DVec3, [f64; 2]) {
        let (r, y) = (
            at.pos.x.hypot(at.pos.z) / self.radius_m,
            at.pos.y / self.radius_m,
        );
        let round = if r > 0.0 { r.sin() / r } else { 1.0 };
        let out = at.pos.with_y(0.0).normalize_or(DVec3::X);
        (out, [y.cos(), y.cos() * round])
    }

    /// Distance of the equator from a chart's centre, metres.
    fn rim_m(self) -> f64 {
        FRAC_PI_2 * self.radius_m
    }

    /// A point in the other chart.
    ///
    /// With c the ground direction, the point goes to `G c (pi R - r)` and every vector by
    /// `G (1 - 2 c c^T)`, the rotation about +y by `2 atan2(c.z, c.x)`. At the pole any c will
    /// do; +x is taken.
    fn over(self, point: ChartPoint) -> Crossing {
        let level = DVec3::new(point.pos.x, 0.0, point.pos.z);
        let r = level.length();
        let c = if r > 0.0 { level / r } else { DVec3::X };
        let across = c * (PI * self.radius_m - r);
        let pos = DVec3::new(-across.x, point.pos.y, across.z);
        Crossing {
            point: ChartPoint::new(other(point.chart), pos),
            turn_rad: 2.0 * c.z.atan2(c.x),
        }
    }
}

impl Atlas for Spherical {
    fn domain(&self, _chart: ChartId) -> Domain {
        Domain::Disc {
            radius_m: self.rim_m(),
        }
    }

    fn has_chart(&self, chart: ChartId) -> bool {
        chart <= ChartId::SECOND
    }

    fn all_charts(&self) -> Option<&[ChartId]> {
        Some(&[ChartId::FIRST, ChartId::SECOND])
    }

    fn chart_name(&self, chart: ChartId) -> String {
        Globe::new(self.radius_m).hemisphere(chart).to_string()
    }

    fn globe(&self) -> Option<Globe> {
        Some(Globe::new(self.radius_m))
    }

    fn cross(&self, point: ChartPoint) -> Option<Crossing> {
        let r = point.pos.x.hypot(point.pos.z);
        let past = r > self.rim_m() + CROSSING_HYSTERESIS_M;
        past.then(|| self.over(point))
    }

    fn carry(&self, point: ChartPoint, to: ChartId) -> Option<Crossing> {
        if to == point.chart {
            Some(Crossing::within(point))
        } else {
            self.has_chart(to).then(|| self.over(point))
        }
    }

    fn images(&self, point: ChartPoint, reach_m: f64) -> Vec<Crossing> {
        let near = point.pos.x.hypot(point.pos.z) > self.rim_m() - reach_m;
        near.then(|| self.over(point)).into_iter().collect()
    }

    /// Carrying keeps radial lengths and angles about the pole, so a disc's width there is at most its angle here times
    /// the largest radius that it gets.
    fn spread_m(&self, point: ChartPoint, radius_m: f64, past_m: f64) -> f64 {
        let r = point.pos.x.hypot(point.pos.z);
        let angle = if radius_m < r {
            (radius_m / r).asin()
        } else {
            PI
        };
        let rim_m = self.rim_m();
        let farthest = (2.0 * rim_m - (r - radius_m)).min(rim_m + past_m);
        radius_m + farthest * angle
    }

    /// The eye at height y has its antipode at -y, so with all ground above 0 every sight line
    /// meets ground before it gets there, and everything is seen exactly once.
    fn limits(&self) -> Option<HeightLimits> {
        Some(HeightLimits {
            bedrock_m: 0.1 * self.radius_m,
            ground_min_m: 0.15 * self.radius_m,
            ground_max_m: 0.5 * self.radius_m,
            ceiling_m: 1.2 * self.radius_m,
        })
    }

    fn noise_frame(&self, _chart: ChartId) -> NoiseFrame {
        NoiseFrame::Radial {
            radius_m: self.radius_m,
        }
    }

    fn noise_point(&self, point: ChartPoint) -> DVec3 {
        Globe::new(self.radius_m).from_middle_m(point)
    }
}

impl Map for Spherical {
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        self.metres(self.view(eye) * self.model(point))
    }

    fn viewer<'a>(&'a self, eye: &'a Eye) -> Viewer<'a> {
        let view = self.view(eye);
        Box::new(move |point| self.metres(view * self.model(point)))
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        self.unmodel(self.view(eye).transpose() * self.units(view))
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        let (sin, cos) = (distance_m / self.radius_m).sin_cos();
        self.chart_point(eye, (direction * (self.radius_m * sin)).extend(cos))
    }

    fn curved(&self, _eye: &Eye, point: ChartPoint) -> DVec4 {
        self.model(point)
    }

    fn port_normal(&self, _eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        let p = (point.pos / self.radius_m).to_array();
        sphere::normal(p, normal.to_array()).into()
    }
}

impl Metric for Spherical {
    fn curvature(&self) -> Curvature {
        Curvature::of_radius(1.0, self.radius_m)
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, _eye: &Eye) -> f64 {
        let (a, b) = (self.model(a), self.model(b));
        self.radius_m * distance::spherical(a.to_array(), b.to_array())
    }

    fn moves_in_chart(&self) -> bool {
        false
    }

    fn in_frame(&self, at: ChartPoint, velocity: DVec3) -> DVec3 {
        let (out, [along, across]) = self.level_lengths(at);
        scaled(out, [along, across], velocity)
    }

    fn in_chart(&self, at: ChartPoint, velocity: DVec3) -> DVec3 {
        let (out, [along, across]) = self.level_lengths(at);
        scaled(out, [along.recip(), across.recip()], velocity)
    }
}

impl Optics for Spherical {
    fn has_sky(&self) -> bool {
        false
    }

    fn reference(&self, _eye: &Eye, _chart: ChartId) -> DVec3 {
        DVec3::ZERO
    }

    fn sight_limit_m(&self, _eye: &Eye) -> f64 {
        PI * self.radius_m
    }

    fn trims(&self, _eye: &Eye, _chart: ChartId, min: DVec3, max: DVec3) -> bool {
        let far = min.abs().max(max.abs());
        far.x.hypot(far.z) > self.rim_m()
    }

    /// The feet of the box's points lie within half its level diagonal of the foot of its middle,
    /// since the sheet is never wider than its chart. Seen from the eye's own foot, that cap has a
    /// distance D and a radius a: it spans level distances D - a to D + a, and azimuths
    /// `asin(sin a / sin D)` to either side, by the right triangle at its tangent.
    fn sight_cell(&self, eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        // The chart's uprights end a quarter turn up, far over the ceiling.
        let highest = 1.5 * self.radius_m;
        if eye.point.pos.y.abs() > highest {
            return SightCell::EVERYWHERE;
        }
        let heights = [min.y, max.y].map(|y| y.clamp(-highest, highest));
        let foot = |pos: DVec3| DVec3::new(pos.x, 0.0, pos.z);
        let eye_foot = ChartPoint::new(eye.point.chart, foot(eye.point.pos));
        let middle = self.model(ChartPoint::new(chart, foot(0.5 * (min + max))));
        let x = self.tangent(eye_foot, DVec3::X).dot(middle);
        let z = self.tangent(eye_foot, DVec3::Z).dot(middle);
        let away = x.hypot(z).atan2(self.model(eye_foot).dot(middle));
        let half = 0.5 * (max - min);
        let radius = half.x.hypot(half.z) / self.radius_m;
        let apart = away > radius && away + radius < PI;
        let plan = Plan {
            azimuth_rad: z.atan2(x),
            half_width_rad: if apart {
                (radius.sin() / away.sin()).min(1.0).asin()
            } else {
                PI
            },
            level_m: [(away - radius).max(0.0), (away + radius).min(PI)].map(|a| a * self.radius_m),
        };
        Axis::new(self.radius_m.powi(-2), eye.point.pos.y).cell(&plan, heights)
    }

    /// Boxes count as the bounding cylinders around them, and bounding cylinders as the boxes in them.
    fn sight_cell_of(&self, eye: &Eye, cylinder: &BoundingCylinder) -> SightCell {
        let half_m = FRAC_1_SQRT_2 * cylinder.radius_m;
        let [min, max] = cylinder.square(DVec3::new(half_m, 0.0, half_m));
        self.sight_cell(eye, cylinder.chart, min, max)
    }

    /// Ways of the sphere are no longer than those of its charts.
    fn ball_rises_m(&self, _eye: &Eye, _middle: ChartPoint, radius_m: f64) -> f64 {
        self.radius_m * (radius_m / self.radius_m).min(FRAC_PI_2).sin()
    }

    fn keeps_azimuths(&self) -> bool {
        false
    }

    fn clip_from_view(&self, _eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        projection.clip(Depth::Great, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        // The shader's points have xyz in metres and w without unit, before and after.
        let metres = DVec4::new(self.radius_m, self.radius_m, self.radius_m, 1.0);
        DMat4::from_diagonal(metres) * self.view(eye) * DMat4::from_diagonal(metres.recip())
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = self.view_matrix(eye);
        SpaceUniform::new(view, projection, self.radius_m, 1.0, 0.0).within(self.rim_m())
    }

    fn home_matrix(&self, chart: ChartId) -> DMat4 {
        let side = if is_b(chart) { -1.0 } else { 1.0 };
        DMat4::from_diagonal(DVec4::new(side, 1.0, 1.0, side))
    }

    fn shader(&self) -> &'static MapShader {
        &shader::SPHERE
    }
}
