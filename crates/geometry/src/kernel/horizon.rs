//! The horizon map at any curvature kappa, negative, zero or positive.
//!
//! With u the chart displacement from the eye in metres, H its height over the sheet, y = u.y + H,
//! r = |(u.x, u.z)|, S(t) = t sinc(kappa t^2) and C(t) = cos(kappa t^2), the boost along the axis by
//! H takes (S(y), C(y) C(r)) to
//! `Y' = S(u.y) - S(H) C(y) (C(r) - 1)` and `W' = C(u.y) + C(H) C(y) (C(r) - 1)`,
//! by the addition theorems. X and Z are the cylindrical chart's.

use super::cylindrical::level_normal;
use super::exponential::bend;
use super::linear::drawn_in;
use super::parts::{Parts, product};
use crate::real::Real;

/// A climb of y metres from the eye: S(y), C(y), and C(y + H) in parts.
#[derive(Debug, Clone, Copy)]
struct Climb<T> {
    /// S(y) in metres.
    rise: T,
    /// C(y).
    fall: T,
    /// C(y + H) is `scale lifted (1 + upright)`, scale a power of two.
    scale: T,
    lifted: T,
    upright: T,
}

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
    /// The map as the shader has it: of a `SpaceUniform` kappa, the lift, its sine and cosine, k per metre and the radius.
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
        let level = self.level(x, z);
        let climb = self.climb(y);
        let upright = climb.scale * climb.lifted;
        // C(y) (C(r) - 1)
        let sag = upright * level.cosine_less_one(climb.upright);
        let across = product(upright * level.scale, level.sine, climb.upright) / level.divisor;
        [
            across * x,
            climb.rise - self.sin * sag,
            across * z,
            climb.fall + self.cos * sag,
        ]
    }

    /// S(r)/r and C(r) of a level distance in metres, in parts.
    #[inline]
    fn level(&self, x: T, z: T) -> Parts<T> {
        let s = self.kappa * (x * x + z * z);
        if s > -T::ONE {
            Parts::near(s)
        } else {
            Parts::of(-T::ONE, [self.k * x, T::ZERO, self.k * z])
        }
    }

    /// What a climb of y metres from the eye makes.
    #[inline]
    fn climb(&self, y: T) -> Climb<T> {
        let steep = self.k * y.abs();
        if self.kappa < T::ZERO && steep > T::ONE {
            // One exponential for all three: its error scales the point and leaves the direction.
            let sense = if y < T::ZERO { -T::ONE } else { T::ONE };
            let [scale, high, low, fade] = T::half_exp(steep, T::ZERO);
            let lifted = self.cos + sense * self.k * self.sin;
            return Climb {
                rise: sense * self.radius_m * (scale + scale * (high + (low - fade))),
                fall: scale + scale * (high + (low + fade)),
                scale,
                lifted,
                upright: high + (low + fade / (lifted * lifted)),
            };
        }
        let [sine, cosine] = T::excess(self.kappa * y * y);
        let rise = y + y * sine;
        Climb {
            rise,
            fall: T::ONE + cosine,
            scale: T::ONE,
            lifted: T::ONE,
            upright: (self.cos - T::ONE) + (self.cos * cosine - self.kappa * rise * self.sin),
        }
    }

    /// A chart normal at `u` as a unit covector in the chart's frame: lengths along the radial,
    /// tangential and upward axes are C(y), C(y) S(r)/r and 1 per chart metre.
    #[inline]
    pub fn normal(&self, u: [T; 3], n: [T; 3]) -> [T; 3] {
        let u = self.within_range(u);
        let square = u[0] * u[0] + u[2] * u[2];
        let s = self.kappa * square;
        let level = T::sine_cosine(s)[0];
        let climb = self.climb(u[1]);
        let upright = climb.scale * climb.lifted * (T::ONE + climb.upright);
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
