//! The horizon map: the true picture of level ground in a space of any curvature.
//!
//! The chart is cylindrical about the foot of the eye's plumb line, so the sheet at the height of
//! the feet is totally geodesic and the camera stands on the axis above it. The curvature kappa
//! (per square metre, negative where hyperbolic) follows the eye's dial and may pass through zero:
//! every function below is an entire function of kappa, so nothing is switched there.
//! [`crate::kernel::horizon`] has the closed form.

use glam::{DMat4, DVec3, DVec4};

use super::FAR_LIMIT_RADII;
use crate::charts::cylindrical;
use crate::flat::rotation;
use crate::kernel::horizon::HorizonMap;
use crate::metric::distance_between_views_m;
use crate::projection::Depth;
use crate::real::Real;
use crate::scalar::{asin_k, atan_k, cos_k, sin_k};
use crate::sight::{Axis, SightCell};
use crate::uniform::PictureEdge;
use crate::{
    Atlas, ChartId, ChartPoint, Curvature, Dial, Eye, Map, MapShader, Metric, Optics, Projection,
    SpaceUniform, Viewer, shader,
};

/// Metres of radius times notches of the dial: the curvature k is c / 80 per metre.
const RADIUS_NOTCHES_M: f64 = 80.0;
/// Where curvature is positive, the chart is cut off at these parts of its half turn outwards and
/// of its quarter turn upwards: past them it would cover the sphere a second time.
const CUT_LEVEL: f64 = 0.9;
const CUT_UPRIGHT: f64 = 0.95;
/// Where curvature is positive, slopes are told for eyes up to here over the sheet: below a quarter turn.
const HIGHEST_EYE_RAD: f64 = 1.5;
/// Where curvature is positive, the haze is complete at this part of a half turn: before the cut.
const HAZE: f64 = 0.8;

/// A flat or hyperbolic world seen through the horizon map.
#[derive(Debug, Clone, Copy)]
pub struct Horizon {
    /// That of the world, which this map does not use.
    world: Curvature,
}

impl Horizon {
    /// Scroll positions of hyperbolic worlds.
    pub const DIAL: Dial = Dial {
        min: 0.0,
        max: 20.0,
        default: 10.0,
    };
    /// Scroll positions of flat worlds: hyperbolic above zero, spherical below.
    pub const BEND_DIAL: Dial = Dial {
        min: -20.0,
        max: 20.0,
        default: 0.0,
    };

    /// A hyperbolic world of that radius in metres.
    pub fn hyperbolic(radius_m: f64) -> Self {
        Self {
            world: Curvature::of_radius(-1.0, radius_m),
        }
    }

    /// A flat world whose picture is bent by the dial.
    pub fn bent() -> Self {
        Self {
            world: Curvature::FLAT,
        }
    }

    fn range(self) -> Dial {
        if self.world.sign < 0.0 {
            Self::DIAL
        } else {
            Self::BEND_DIAL
        }
    }

    /// The curvature in use, per square metre: `-c |c| / 80^2`.
    pub fn kappa(self, eye: &Eye) -> f64 {
        let range = self.range();
        if eye.dial.is_nan() {
            return 0.0;
        }
        let k = eye.dial.clamp(range.min, range.max) / RADIUS_NOTCHES_M;
        -k * k.abs()
    }

    /// The kernel's map at the eye's dial.
    fn map(self, eye: &Eye) -> HorizonMap<f64> {
        HorizonMap::new(self.kappa(eye), eye.lift_m)
    }

    /// What the picture shows.
    fn edge(kappa: f64) -> PictureEdge {
        if kappa > 0.0 {
            let turn = std::f64::consts::PI / kappa.sqrt();
            PictureEdge {
                level_m: CUT_LEVEL * turn,
                upright_m: CUT_UPRIGHT * 0.5 * turn,
            }
        } else {
            PictureEdge {
                level_m: f64::INFINITY,
                upright_m: f64::INFINITY,
            }
        }
    }

    /// Cells of the picture are found about the axis through the eye.
    fn axis(kappa: f64, eye: &Eye) -> Axis {
        Axis::new(kappa, eye.lift_m)
    }
}

impl Atlas for Horizon {}

impl Map for Horizon {
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
        let map = self.map(eye);
        let (kappa, sin_h, cos_h) = (map.kappa, map.sin, map.cos);
        let v = eye.to_chart(view.truncate());
        // The boost back, by the transpose of the one above.
        let rise = v.y * cos_h + view.w * sin_h;
        let out = view.w * cos_h - kappa * v.y * sin_h;
        let level = v.x.hypot(v.z);
        let (y, r) = if kappa > 0.0 {
            let beside = (kappa * level * level + out * out).sqrt();
            (atan_k(kappa, rise, beside), atan_k(kappa, level, out))
        } else {
            let y = asin_k(kappa, rise);
            (y, asin_k(kappa, level / cos_k(kappa, y)))
        };
        let per_level = if level > 0.0 { r / level } else { 1.0 };
        let foot = eye.point.pos - DVec3::Y * eye.lift_m;
        ChartPoint::a(foot + DVec3::new(v.x * per_level, y, v.z * per_level))
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        let kappa = self.kappa(eye);
        let limit = if kappa < 0.0 {
            f64::FAR_LEVEL / (-kappa).sqrt()
        } else {
            f64::INFINITY
        };
        let t = distance_m.clamp(-limit, limit);
        self.chart_point(eye, (direction * sin_k(kappa, t)).extend(cos_k(kappa, t)))
    }

    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let kappa = self.kappa(eye);
        let u = self
            .map(eye)
            .within_range((point.pos - eye.point.pos).to_array());
        let u = DVec3::from_array(u) + DVec3::Y * eye.lift_m;
        if kappa == 0.0 {
            u.extend(1.0)
        } else {
            cylindrical(kappa.signum(), u * kappa.abs().sqrt())
        }
    }

    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        let u = (point.pos - eye.point.pos).to_array();
        self.map(eye).normal(u, normal.to_array()).into()
    }
}

impl Metric for Horizon {
    fn curvature(&self) -> Curvature {
        self.world
    }

    fn curvature_at(&self, eye: &Eye) -> Curvature {
        Curvature::of_kappa(self.kappa(eye))
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, eye: &Eye) -> f64 {
        let views = [a, b].map(|p| self.view_point(eye, p));
        distance_between_views_m(self.kappa(eye), views)
    }
}

impl Optics for Horizon {
    fn sight_limit_m(&self, eye: &Eye) -> f64 {
        let kappa = self.kappa(eye);
        if kappa > 0.0 {
            HAZE * std::f64::consts::PI / kappa.sqrt()
        } else {
            FAR_LIMIT_RADII * self.radius_at_m(eye)
        }
    }

    fn trims(&self, eye: &Eye, _chart: ChartId, min: DVec3, max: DVec3) -> bool {
        let edge = Self::edge(self.kappa(eye));
        let foot = eye.point.pos - DVec3::Y * eye.lift_m;
        let far = (min - foot).abs().max((max - foot).abs());
        far.x.hypot(far.z) > edge.level_m || far.y > edge.upright_m
    }

    fn sight_cell(&self, eye: &Eye, _chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        let kappa = self.kappa(eye);
        // Past a quarter turn over its sheet an eye sees heights the other way round.
        if kappa > 0.0 && kappa.sqrt() * eye.lift_m.abs() > HIGHEST_EYE_RAD {
            return SightCell::EVERYWHERE;
        }
        let PictureEdge { level_m, upright_m } = Self::edge(kappa);
        let low = min - eye.point.pos;
        let high = max - eye.point.pos;
        Self::axis(kappa, eye).cell_of_box(low, high, level_m, upright_m)
    }

    /// In the chart's metres, `ds^2 = dy^2 + C(y)^2 (dr^2 + (S(r) / r)^2 (r dphi)^2)`: no way is stretched by more than
    /// `cosh y sinh r / r`, or at all where curvature is positive.
    fn ball_rises_m(&self, eye: &Eye, middle: ChartPoint, radius_m: f64) -> f64 {
        let kappa = self.kappa(eye);
        let k = kappa.abs().sqrt();
        if kappa > 0.0 {
            return (k * radius_m).min(std::f64::consts::FRAC_PI_2).sin() / k;
        }
        if kappa == 0.0 {
            return radius_m;
        }
        let u = middle.pos - eye.point.pos;
        let up = k * ((u.y + eye.lift_m).abs() + radius_m);
        let out = k * (u.x.hypot(u.z) + radius_m);
        (k * radius_m * up.cosh() * out.sinh() / out).sinh() / k
    }

    fn clip_from_view(&self, eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        let kappa = self.kappa(eye);
        let depth = if kappa > 0.0 {
            Depth::Upright
        } else if kappa < 0.0 {
            Depth::Exponential {
                radius_m: self.radius_at_m(eye),
            }
        } else {
            Depth::Reciprocal
        };
        projection.clip(depth, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        DMat4::from_mat3(rotation(eye))
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = self.view_matrix(eye);
        let kappa = self.kappa(eye);
        SpaceUniform::level(view, projection, kappa, eye.lift_m, Self::edge(kappa))
    }

    fn shader(&self) -> &'static MapShader {
        &shader::HORIZON
    }
}
