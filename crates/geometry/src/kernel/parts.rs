//! Hyperbolic and circular sine and cosine in parts, for products of several without a rounding
//! each.
//!
//! `sinc = scale (1 + sine) / divisor` and `cosine = scale (1 + cosine)`, scale a power of two. A
//! product of two of them is `scale scale' (1 + (x + (y + x y)))`: one rounding of the whole, where
//! the product of the rounded factors has three.

use super::linear::dot;
use crate::real::Real;

/// Sine over argument and cosine in parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parts<T> {
    /// A power of two.
    pub scale: T,
    /// What the sine, over the divisor, exceeds the scale by, in scales.
    pub sine: T,
    /// What the cosine exceeds the scale by, in scales.
    pub cosine: T,
    /// 1 where the sine is over its argument already, else the argument.
    pub divisor: T,
}

impl<T: Real> Parts<T> {
    /// For the length of `q` radii under the curvature `sign`, between -1 and 1. Domain: sign > 0,
    /// `f32`: |q| <= pi; sign < 0: 700 in `f64`, 81 in `f32`.
    #[inline]
    pub fn of(sign: T, q: [T; 3]) -> Self {
        let s = sign * dot(q, q);
        if s > -T::ONE {
            return Self::near(s);
        }
        let [t, rest] = T::length_rest(q);
        let [scale, high, low, fade] = T::half_exp(t, rest);
        // sinh/(t + rest) is sinh/t less its part rest/t.
        let sine = high + (low - fade);
        Self {
            scale,
            sine: sine - (T::ONE + sine) * (rest / t),
            cosine: high + (low + fade),
            divisor: t,
        }
    }

    /// For `kappa t^2 = s` from -1 up.
    #[inline]
    pub fn near(s: T) -> Self {
        let [sine, cosine] = T::excess(s);
        Self {
            scale: T::ONE,
            sine,
            cosine,
            divisor: T::ONE,
        }
    }

    /// `(cosine - 1)(1 + y)`, exact to its own last places near 0.
    #[inline]
    pub fn cosine_less_one(self, y: T) -> T {
        let (whole, part) = (self.scale - T::ONE, self.scale * self.cosine);
        whole + (part + (whole + part) * y)
    }
}

/// `(1 + x)(1 + y)`, scaled, with one rounding of the size of the answer.
#[inline]
pub fn product<T: Real>(scale: T, x: T, y: T) -> T {
    scale + scale * (x + (y + x * y))
}
