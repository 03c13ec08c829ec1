//! Hyperbolic space, raised map: the exponential chart of `k u + (0, h, 0)` boosted back down the
//! axis by h, in closed form. u is the chart displacement from the eye in metres.
//!
//! With q = u.y + c, d = |u + (0, c, 0)| and m = d - q, the addition theorems turn the boosted
//! `sinh(d) q/d` and `cosh(d)` into `sinh(d - h) - cosh(h) sinc(d) m` and
//! `cosh(d - h) + sinh(h) sinc(d) m` (all times k inside): no two large numbers are subtracted.

use super::exponential;
use super::linear::{drawn_in, scaled};
use crate::real::Real;

/// The raised map at one setting of its dial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaisedMap<T> {
    /// Curvature in 1/m.
    pub k: T,
    /// Radius of curvature in metres.
    pub radius_m: T,
    /// The offset in metres.
    pub offset_m: T,
    /// The offset in radii.
    pub offset: T,
    /// Hyperbolic sine of the offset.
    pub sinh: T,
    /// Hyperbolic cosine of the offset.
    pub cosh: T,
}

impl RaisedMap<f64> {
    /// The map of a radius and an offset, both in metres.
    #[inline]
    pub fn new(radius_m: f64, offset_m: f64) -> Self {
        let offset = offset_m / radius_m;
        let [sinhc, cosh] = f64::sinhc_cosh(offset);
        Self {
            k: 1.0 / radius_m,
            radius_m,
            offset_m,
            offset,
            sinh: sinhc * offset,
            cosh,
        }
    }
}

impl RaisedMap<f32> {
    /// The map as the shader has it: of a `SpaceUniform` k per metre, the lift, its sine and cosine, and the radius.
    #[inline]
    pub fn from_uniform([k, offset, sinh, cosh]: [f32; 4], radius_m: f32) -> Self {
        Self {
            k,
            radius_m,
            offset_m: offset * radius_m,
            offset,
            sinh,
            cosh,
        }
    }
}

impl<T: Real> RaisedMap<T> {
    /// A displacement from the eye, drawn in where it is too far to port.
    #[inline]
    pub fn within_range(&self, u: [T; 3]) -> [T; 3] {
        drawn_in(u, T::FAR * self.radius_m)
    }

    /// Ported and boosted, xyz in metres, before the camera's rotation.
    #[inline]
    pub fn port(&self, u: [T; 3]) -> [T; 4] {
        let (k, c) = (self.k, self.offset_m);
        let [x, y, z] = self.within_range(u);
        let q_y = y + c;
        let rho_square = x * x + z * z;
        let d = (rho_square + q_y * q_y).sqrt();
        // So near the eye, at no offset, the map is the identity, and squares would vanish.
        if (d + c) * T::SQUARABLE < self.radius_m.min(T::ONE) {
            return [x, y, z, T::ONE];
        }
        let delta = (y * (y + T::of(2.0) * c) + rho_square) / (d + c);
        // d - q_y, without cancellation on either side of the offset centre.
        let m = if q_y > T::ZERO {
            rho_square / (d + q_y)
        } else {
            d - q_y
        };
        let (across, [rise, w]) = self.sines(d, delta);
        [
            across * x,
            rise - self.cosh * across * m,
            across * z,
            w + self.sinh * across * (k * m),
        ]
    }

    /// sinh(kd)/(kd), and sinh(k delta)/k with cosh(k delta).
    #[inline]
    fn sines(&self, d: T, delta: T) -> (T, [T; 2]) {
        let k = self.k;
        if k * delta > T::of(2.0) {
            // delta = d - c: with one exponential for both, its error scales the whole point and
            // leaves the direction alone.
            let e = T::HALF * T::exp(k * d);
            let f = e / (self.cosh + self.sinh);
            let quarter = T::HALF * T::HALF;
            let across = (e - quarter / e) / (k * d);
            let (back, up) = (f - quarter / f, f + quarter / f);
            return (across, [self.radius_m * back, up]);
        }
        let near = T::sinhc_cosh(k * delta);
        (T::sinhc_cosh(k * d)[0], [delta * near[0], near[1]])
    }

    /// A chart normal at `u` as a unit covector in the frame of the exponential chart.
    #[inline]
    pub fn normal(&self, u: [T; 3], n: [T; 3]) -> [T; 3] {
        let mut q = scaled(self.within_range(u), self.k);
        q[1] = q[1] + self.offset;
        exponential::normal(-T::ONE, q, n)
    }
}
