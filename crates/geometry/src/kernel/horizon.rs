//! The horizon map at any curvature kappa, negative, zero or positive.
//!
//! With u the chart displacement from the eye in metres, H its height over the sheet, y = u.y + H,
//! r = |(u.x, u.z)|, S(t) = t sinc(kappa t^2), C(t) = cos(kappa t^2) and q = S(r/2)^2, the boost
//! along the axis by H takes (S(y), C(y) C(r)) to
//! `Y' = S(u.y) + 2 kappa S(H) C(y) q` and `W' = C(u.y) - 2 kappa C(H) C(y) q`,
//! by the addition theorems and `1 - C(r) = 2 kappa q`. X and Z are the cylindrical chart's.

use super::cylindrical::level_normal;
use super::exponential::bend;
use super::linear::drawn_in;
use crate::real::Real;

/// The horizon map of one eye and curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HorizonMap<T> {
    /// Curvature per square metre.
    pub kappa: T,
    /// Its square root, per metre.
    pub k: T,
    /// The radius of curvature in metres; 0 where flat.
    pub radius_m: T,
    /// H in metres, |k H| <= 2.
    pub lift_m: T,
    /// S(H) in metres.
    pub sin: T,
    /// C(H).
    pub cos: T,
}

impl HorizonMap<f64> {
    /// The map of a curvature per square metre, from `lift_m` metres over the sheet.
    #[inline]
    pub fn new(kappa: f64, lift_m: f64) -> Self {
        let k = kappa.abs().sqrt();
        let [sinc, cos] = f64::sine_cosine(kappa * lift_m * lift_m);
        Self {
            kappa,
            k,
            radius_m: if k > 0.0 { 1.0 / k } else { 0.0 },
            lift_m,
            sin: sinc * lift_m,
            cos,
        }
    }
}

impl HorizonMap<f32> {
    /// The map as the shader has it: `curve`, k of `edge` and the radius of a `SpaceUniform`.
    #[inline]
    pub fn from_uniform([kappa, lift_m, sin, cos]: [f32; 4], k: f32, radius_m: f32) -> Self {
        Self {
            kappa,
            k,
            radius_m,
            lift_m,
            sin,
            cos,
        }
    }
}

impl<T: Real> HorizonMap<T> {
    /// A displacement from the eye, drawn in where products of coordinates would leave the range.
    #[inline]
    pub fn within_range(&self, u: [T; 3]) -> [T; 3] {
        if self.kappa < T::ZERO {
            drawn_in(u, T::FAR_LEVEL * self.radius_m)
        } else {
            drawn_in(u, T::BOUND)
        }
    }

    /// Ported and boosted, xyz in metres, before the camera's rotation.
    #[inline]
    pub fn port(&self, u: [T; 3]) -> [T; 4] {
        let [x, y, z] = self.within_range(u);
        let square = x * x + z * z;
        let half = T::sine_cosine(T::HALF * T::HALF * self.kappa * square);
        let [rise, fall, upright] = self.climb(y);
        let sag = T::HALF * upright * (half[0] * half[0]) * (self.kappa * square);
        let across = upright * (half[0] * half[1]);
        [
            across * x,
            rise + self.sin * sag,
            across * z,
            fall - self.cos * sag,
        ]
    }

    /// S(y), C(y) and C(y + H) for a climb of y metres from the eye.
    #[inline]
    fn climb(&self, y: T) -> [T; 3] {
        let steep = self.k * y.abs();
        if self.kappa < T::ZERO && steep > T::ONE {
            // One exponential for all three: its error scales the point and leaves the direction.
            let sense = if y < T::ZERO { -T::ONE } else { T::ONE };
            let e = T::HALF * T::exp(steep);
            let r = T::HALF * T::HALF / e;
            let lifted = self.cos + sense * self.k * self.sin;
            return [
                sense * self.radius_m * (e - r),
                e + r,
                e * lifted + r / lifted,
            ];
        }
        let [sinc, cos] = T::sine_cosine(self.kappa * y * y);
        let rise = sinc * y;
        [rise, cos, cos * self.cos - self.kappa * rise * self.sin]
    }

    /// A chart normal at `u` as a unit covector in the chart's frame: lengths along the radial,
    /// tangential and upward axes are C(y), C(y) S(r)/r and 1 per chart metre.
    #[inline]
    pub fn normal(&self, u: [T; 3], n: [T; 3]) -> [T; 3] {
        let u = self.within_range(u);
        let square = u[0] * u[0] + u[2] * u[2];
        let s = self.kappa * square;
        let level = T::sine_cosine(s)[0];
        let upright = self.climb(u[1])[2];
        let sign = if self.kappa > T::ZERO {
            T::ONE
        } else {
            -T::ONE
        };
        // (S(r)/r - 1)/r^2
        let bend = bend(sign, s.abs(), level) * self.kappa.abs();
        level_normal(u, n, level, upright, bend)
    }
}
