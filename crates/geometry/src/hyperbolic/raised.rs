//! Hyperbolic space, raised map: the theses' default, with a camera that never moves.
//!
//! The world moves under the camera, so numbers stay small however far one walks. A chart
//! point at `u = k (p - eye)` goes through the exponential chart as `u + (0, h, 0)`, and the
//! camera sits at the image of `(0, h, 0)`; the offset alone makes the visible bend. Porting
//! first and boosting back afterwards would cancel; the closed form below never subtracts two
//! large numbers. It works in metres, so that it is regular down to k = 0.

use glam::{DMat4, DVec3, DVec4};

use super::FAR_LIMIT_RADII;
use crate::charts::exponential;
use crate::flat::rotation;
use crate::kernel::raised::RaisedMap;
use crate::metric::distance_between_views_m;
use crate::projection::Depth;
use crate::real::Real;
use crate::scalar::sinhc;
use crate::sight::{Plan, slope_range};
use crate::{
    Atlas, ChartId, ChartPoint, Curvature, Dial, Eye, HyperbolicMap, Map, MapShader, Metric,
    Optics, Projection, SightCell, SpaceUniform, ViewMode, Viewer, shader,
};

/// Halvings that find where a slope turns: to a millionth of a chunk.
const BISECTIONS: u32 = 24;

/// Hyperbolic space of a given radius of curvature, seen through the raised map.
#[derive(Debug, Clone, Copy)]
pub struct Raised {
    radius_m: f64,
}

impl Raised {
    /// Scroll positions, in metres of offset.
    pub const DIAL: Dial = Dial {
        min: 0.0,
        max: 20.0,
        default: 10.0,
    };

    /// `radius_m` is the radius of curvature in metres, positive and finite.
    pub fn new(radius_m: f64) -> Self {
        Self { radius_m }
    }

    /// The offset c in metres.
    fn offset_m(eye: &Eye) -> f64 {
        if eye.dial.is_nan() {
            return Self::DIAL.min;
        }
        eye.dial.clamp(Self::DIAL.min, Self::DIAL.max)
    }

    /// The offset h in radii.
    fn offset(self, eye: &Eye) -> f64 {
        Self::offset_m(eye) / self.radius_m
    }

    /// The kernel's map at the eye's dial.
    fn map(self, eye: &Eye) -> RaisedMap<f64> {
        RaisedMap::new(self.radius_m, Self::offset_m(eye))
    }

    /// The slope at which a point is seen: (q cosh h - d coth d sinh h) / r in radii, with q its
    /// height over the offset centre, r its level distance and d its distance from that centre.
    /// It is the boosted point's Y' over its level part, sinhc(d) r.
    fn slope(h: f64, q: f64, r: f64) -> f64 {
        let rise = q * h.cosh() - d_coth(q.hypot(r)) * h.sinh();
        if r <= 1e-12 {
            f64::INFINITY.copysign(rise)
        } else {
            rise / r
        }
    }

    /// Where along r the slope turns. `g(r) = d coth d` is convex, so `g - r g'` falls, and the
    /// slope's derivative, `(sinh h (g - r g') - q cosh h) / r^2`, changes sign at most once.
    fn turns(h: f64, q: f64, [low, high]: [f64; 2]) -> Option<f64> {
        let rises = |r: f64| {
            let d = q.hypot(r);
            if d < 1e-6 {
                return h.sinh() - q * h.cosh();
            }
            let coth = 1.0 / d.tanh();
            let slope_of_g = (coth - d / d.sinh().powi(2)) * r / d;
            h.sinh() * (d * coth - r * slope_of_g) - q * h.cosh()
        };
        let (mut low, mut high) = (low, high);
        if rises(low) <= 0.0 || rises(high) >= 0.0 {
            return None;
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if rises(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(0.5 * (low + high))
    }
}

/// d coth d, which is 1 at 0.
fn d_coth(d: f64) -> f64 {
    if d < 1e-8 { 1.0 } else { d / d.tanh() }
}

impl Atlas for Raised {}

impl Map for Raised {
    fn view_modes(&self) -> &'static [ViewMode] {
        const {
            &[
                ViewMode::Map(HyperbolicMap::Raised),
                ViewMode::Map(HyperbolicMap::Horizon),
            ]
        }
    }

    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let u = (point.pos - eye.point.pos).to_array();
        let x = DVec4::from_array(self.map(eye).port(u));
        eye.to_view(x.truncate()).extend(x.w)
    }

    fn viewer<'a>(&'a self, eye: &'a Eye) -> Viewer<'a> {
        let (map, rotation) = (self.map(eye), rotation(eye));
        Box::new(move |point| {
            let u = (point.pos - eye.point.pos).to_array();
            let x = DVec4::from_array(map.port(u));
            (rotation * x.truncate()).extend(x.w)
        })
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        let h = self.offset(eye);
        let v = eye.to_chart(view.truncate());
        let lifted = h.cosh() * v.y + self.radius_m * h.sinh() * view.w;
        let x = DVec3::new(v.x, lifted, v.z);
        // sinh d / d is taken from d itself: the same number as in the port.
        let d = (x.length() / self.radius_m).asinh();
        let u = x / sinhc(d) - DVec3::Y * Self::offset_m(eye);
        ChartPoint::a(eye.point.pos + u)
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        let t = (distance_m / self.radius_m).clamp(-f64::FAR, f64::FAR);
        let view = direction * (self.radius_m * t.sinh());
        self.chart_point(eye, view.extend(t.cosh()))
    }

    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let u = self
            .map(eye)
            .within_range((point.pos - eye.point.pos).to_array());
        let q = DVec3::from_array(u) / self.radius_m + DVec3::Y * self.offset(eye);
        exponential(-1.0, q)
    }

    /// The part along the ray from the offset centre keeps its length and the part across it
    /// shrinks by sinh d / d.
    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        let u = (point.pos - eye.point.pos).to_array();
        self.map(eye).normal(u, normal.to_array()).into()
    }
}

impl Metric for Raised {
    fn curvature(&self) -> Curvature {
        Curvature::of_radius(-1.0, self.radius_m)
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, eye: &Eye) -> f64 {
        let views = [a, b].map(|p| self.view_point(eye, p));
        distance_between_views_m(-self.radius_m.powi(-2), views)
    }
}

impl Optics for Raised {
    fn sight_limit_m(&self, _eye: &Eye) -> f64 {
        FAR_LIMIT_RADII * self.radius_m
    }

    /// The chart never exceeds the space's own distances from the eye.
    fn sight_cell(&self, eye: &Eye, _chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        let (low, high) = (min - eye.point.pos, max - eye.point.pos);
        let plan = Plan::of_box(low, high);
        let h = self.offset(eye);
        let heights = [low.y, high.y].map(|y| y / self.radius_m + h);
        let levels = plan.level_m.map(|r| r / self.radius_m);
        SightCell {
            azimuth_rad: plan.azimuth_rad,
            half_width_rad: plan.half_width_rad,
            level_m: plan.level_m,
            slope: slope_range(
                &heights,
                &levels,
                |q, r| Self::slope(h, *q, *r),
                |q| {
                    let turn = Self::turns(h, *q, levels);
                    turn.filter(|r| (levels[0]..=levels[1]).contains(r))
                },
            ),
            nearest_m: DVec3::ZERO.clamp(low, high).length(),
        }
    }

    /// What is t radii from the offset centre is stretched by `sinh t / t` across the ray from there, and not along it.
    fn ball_rises_m(&self, eye: &Eye, middle: ChartPoint, radius_m: f64) -> f64 {
        let own = radius_m / self.radius_m;
        let q = (middle.pos - eye.point.pos) / self.radius_m + DVec3::Y * self.offset(eye);
        let farthest = q.length() + own;
        self.radius_m * (own * farthest.sinh() / farthest).sinh()
    }

    fn clip_from_view(&self, _eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        let radius_m = self.radius_m;
        projection.clip(Depth::Exponential { radius_m }, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        DMat4::from_mat3(rotation(eye))
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = self.view_matrix(eye);
        let h = self.offset(eye);
        SpaceUniform::new(view, projection, self.radius_m, -1.0, h)
    }

    fn shader(&self) -> &'static MapShader {
        &shader::RAISED
    }
}
