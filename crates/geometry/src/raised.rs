//! Hyperbolic space, raised map: the theses' default, with a camera that never moves.
//!
//! The world moves under the camera, so numbers stay small however far one walks. A chart
//! point at `u = k (p - eye)` goes through the exponential chart as `u + (0, h, 0)`, and the
//! camera sits at the image of `(0, h, 0)`; the offset alone makes the visible bend. Porting
//! first and boosting back afterwards would cancel; the closed form below never subtracts two
//! large numbers. It works in metres, so that it is regular down to k = 0.

use glam::{DMat4, DVec3, DVec4};

use crate::charts::exponential;
use crate::euclidean::rotation;
use crate::scalar::{sinc_minus_one_over_square, sinhc};
use crate::strategy::Dial;
use crate::{
    BoundingSphere, ChartPoint, Eye, Geometry, Hemisphere, Projection, SpaceUniform, Strategy,
};

/// Points farther than this from the eye, in radii, are drawn in to it before the port, so
/// that the squares of hyperboloid coordinates stay finite in `f64`.
const OVERFLOW_GUARD_RADII: f64 = 350.0;

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

    /// A chart displacement from the eye, in metres, drawn in where it is too far to port.
    fn within_guard(self, u: DVec3) -> DVec3 {
        u.clamp_length_max(OVERFLOW_GUARD_RADII * self.radius_m)
    }

    /// The closed form: ported and boosted, before the camera's rotation. `u` is the chart
    /// displacement from the eye in metres.
    fn boosted(self, eye: &Eye, u: DVec3) -> DVec4 {
        let (k, c, h) = (1.0 / self.radius_m, Self::offset_m(eye), self.offset(eye));
        let u = self.within_guard(u);
        let q_y = u.y + c;
        let rho_square = u.x * u.x + u.z * u.z;
        let d = (rho_square + q_y * q_y).sqrt();
        if d + c == 0.0 {
            return DVec4::W;
        }
        let delta = (u.y * (u.y + 2.0 * c) + rho_square) / (d + c);
        // d - q_y, without cancellation on either side of the offset centre.
        let m = if q_y > 0.0 {
            rho_square / (d + q_y)
        } else {
            d - q_y
        };
        let across = sinhc(k * d);
        DVec4::new(
            across * u.x,
            delta * sinhc(k * delta) - h.cosh() * across * m,
            across * u.z,
            (k * delta).cosh() + h.sinh() * across * k * m,
        )
    }

    /// An upper bound on how much the map from the chart to the eye's normal coordinates
    /// stretches lengths anywhere in the box from `low` to `high` (radii, relative to the eye).
    ///
    /// Let O be the offset centre, E the eye, dO and dE the distances from them to a point,
    /// and alpha the angle there between the two sight lines. In frames along those lines the
    /// differential is `diag(1, 1/sinhc dE) rotation(alpha) diag(1, sinhc dO)`, with
    /// determinant `P = sinhc dO / sinhc dE` in that plane and P across it. Its greater
    /// singular value grows with P and with `A = 1 + (sinhc dO sin alpha)^2 +
    /// (sin alpha / sinhc dE)^2 >= Frobenius^2 - P^2`, so bounds on those suffice. They follow
    /// from `dO <= dE + h`, from the law of sines `sin alpha <= sinh h / sinh dE`, and from
    /// the chart never exceeding the space's own distance, `dE >= |u|`.
    fn max_stretch(h: f64, low: DVec3, high: DVec3) -> f64 {
        let offset = DVec3::Y * h;
        let eye_low = nearest(low, high).length();
        let centre_low = nearest(low + offset, high + offset).length();
        let centre_high = farthest(low + offset, high + offset).length();
        let eye_high = centre_high + h;
        // The ratio rises with dE towards exp h.
        let p = if eye_high < OVERFLOW_GUARD_RADII {
            sinhc(eye_high + h) / sinhc(eye_high)
        } else {
            h.exp()
        };
        let sin_alpha = if eye_low > 0.0 {
            (h.sinh() / eye_low.sinh()).min(1.0)
        } else {
            1.0
        };
        let by_sines = (h.cosh() + h.sinh() / eye_low.tanh()) * h.sinh() / centre_low;
        let shear = if by_sines.is_finite() {
            by_sines.min(sinhc(centre_high))
        } else {
            sinhc(centre_high)
        };
        let lean = sin_alpha / sinhc(eye_low);
        let a = 1.0 + shear * shear + lean * lean;
        let sum = a + p * p;
        (0.5 * (sum + (sum * sum - 4.0 * p * p).max(0.0).sqrt())).sqrt()
    }
}

/// The point of a box that is nearest to the origin.
fn nearest(low: DVec3, high: DVec3) -> DVec3 {
    DVec3::ZERO.clamp(low, high)
}

/// The corner of a box that is farthest from the origin.
fn farthest(low: DVec3, high: DVec3) -> DVec3 {
    low.abs().max(high.abs())
}

impl Strategy for Raised {
    fn geometry(&self) -> Geometry {
        Geometry::Hyperbolic
    }

    fn radius_m(&self) -> f64 {
        self.radius_m
    }

    fn dial(&self) -> Option<Dial> {
        Some(Self::DIAL)
    }

    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let x = self.boosted(eye, point.pos - eye.point.pos);
        eye.to_view(x.truncate()).extend(x.w)
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
        let t = (distance_m / self.radius_m).clamp(-OVERFLOW_GUARD_RADII, OVERFLOW_GUARD_RADII);
        let view = direction * (self.radius_m * t.sinh());
        self.chart_point(eye, view.extend(t.cosh()))
    }

    /// `sinh^2(D/2) = sinh^2((a-b)/2) + sinh a sinh b sin^2(theta/2)` with a, b the distances
    /// from the eye: no large terms are subtracted, near or far.
    fn distance_m(&self, a: ChartPoint, b: ChartPoint, eye: &Eye) -> f64 {
        let a = self.view_point(eye, a).truncate() / self.radius_m;
        let b = self.view_point(eye, b).truncate() / self.radius_m;
        let (length_a, length_b) = (a.length(), b.length());
        let between = (length_a.asinh() - length_b.asinh()) * 0.5;
        let turn = a.normalize_or_zero() - b.normalize_or_zero();
        let across = 0.5 * turn.length() * length_a.sqrt() * length_b.sqrt();
        2.0 * self.radius_m * between.sinh().hypot(across).asinh()
    }

    fn eye_distance_m(&self, view: DVec4) -> f64 {
        self.radius_m * (view.truncate().length() / self.radius_m).asinh()
    }

    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        let u = self.within_guard(point.pos - eye.point.pos) / self.radius_m;
        exponential(-1.0, u + DVec3::Y * self.offset(eye))
    }

    /// The part along the ray from the offset centre keeps its length and the part across it
    /// shrinks by sinh d / d.
    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        let u = self.within_guard(point.pos - eye.point.pos);
        let q = u / self.radius_m + DVec3::Y * self.offset(eye);
        let d = q.length();
        let stretch = sinhc(d);
        let along = sinc_minus_one_over_square(-1.0, d) / stretch;
        (normal / stretch + q * (along * normal.dot(q))).normalize_or_zero()
    }

    fn bounding_sphere(
        &self,
        eye: &Eye,
        hemisphere: Hemisphere,
        min: DVec3,
        max: DVec3,
    ) -> BoundingSphere {
        let centre = ChartPoint::new(hemisphere, 0.5 * (min + max));
        let low = (min - eye.point.pos) / self.radius_m;
        let high = (max - eye.point.pos) / self.radius_m;
        let stretch = Self::max_stretch(self.offset(eye), low, high);
        let radius_m = 0.5 * (max - min).length() * stretch;
        BoundingSphere {
            centre: self.view_point(eye, centre),
            // Past the range of f64 nothing is known, and everything must be kept.
            radius_m: if radius_m.is_finite() {
                radius_m
            } else {
                f64::MAX
            },
        }
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = DMat4::from_mat3(rotation(eye));
        let h = self.offset(eye);
        SpaceUniform::new(SpaceUniform::RAISED, view, projection, self.radius_m, h)
    }
}
