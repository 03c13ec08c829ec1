//! The two precisions the kernels are written for.
//!
//! `f64` leans on the system's library and serves the game's own reckoning; `f32` is the arithmetic
//! of `shaders/geometry.wgsl`, operation by operation ([`crate::kernel::series`]). "In `f64`, then
//! cast" is the `f64` kernel with its result rounded once: 0.50 ulp of `f32`.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::kernel::{library, series};

/// A floating-point number with the trigonometry of the curved spaces.
///
/// Lengths `t` are in units of the radius of curvature; `s` is `t^2`, negative where hyperbolic.
/// Errors are given in ulp of the result for `f64` and `f32`, arguments taken as exact.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// A half.
    const HALF: Self;
    /// Chart coordinates are drawn in to this many metres before they are squared.
    const BOUND: Self;
    /// Squares of lengths within this and its reciprocal neither overflow nor vanish.
    const SQUARABLE: Self;
    /// Hyperbolic points are drawn in to this many radii: hyperboloid coordinates stay in range.
    const FAR: Self;
    /// The same where two hyperboloid coordinates are multiplied.
    const FAR_LEVEL: Self;

    /// The nearest number of this precision.
    fn of(x: f64) -> Self;
    /// The same number in double precision: exact.
    fn to_f64(self) -> f64;
    /// Square root, rounded once.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Magnitude.
    #[must_use]
    fn abs(self) -> Self;
    /// The greatest whole number that is not greater.
    #[must_use]
    fn floor(self) -> Self;
    /// The greater of two numbers.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// The lesser of two numbers.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// `(sin(t)/t, cos(t))` for `t^2 = s`; `f32` to t = pi.
    fn sinc_cos(s: Self) -> [Self; 2];
    /// `(sinh(t)/t, cosh(t))` for |t| to 700 in `f64`, to 81 in `f32`.
    fn sinhc_cosh(t: Self) -> [Self; 2];
    /// The sine over its argument and the cosine of either curvature, for `s = kappa t^2`: entire
    /// in s, so nothing is switched at 0.
    fn sine_cosine(s: Self) -> [Self; 2];
    /// What the two of [`Real::sine_cosine`] exceed 1 by, for s >= -1: no digit is lost near 0.
    fn excess(s: Self) -> [Self; 2];
    /// `[a, high, low, fade]`, a a power of two: half of exp(t + rest) is `a (1 + (high + low))` and
    /// half of its reciprocal `a fade`; t >= 1, `f32` t < 88, |rest| an ulp of t at most.
    fn half_exp(t: Self, rest: Self) -> [Self; 4];
    /// The length of a vector, and in `f32` what rounding took from it; lengths of 1e-15 to 1e18.
    fn length_rest(q: [Self; 3]) -> [Self; 2];
    /// e to the t; `f32` for 0 <= t < 88.
    #[must_use]
    fn exp(t: Self) -> Self;
    /// `(sin(t)/t - 1)/t^2` where `sign` > 0, `f32` to t = pi, else `(sinh(t)/t - 1)/t^2`, `f32` to
    /// t = 80; `t^2 = s`.
    #[must_use]
    fn sinc_bend(s: Self, sign: Self) -> Self;
    /// `atan2(sine, cosine)` for `sine >= 0`, and 0 where both are 0.
    #[must_use]
    fn angle(sine: Self, cosine: Self) -> Self;
    /// Inverse hyperbolic sine of x >= 0.
    #[must_use]
    fn asinh(x: Self) -> Self;
}

macro_rules! real {
    ($real:ty, $functions:ident, $bound:expr, $squarable:expr, $far:expr, $far_level:expr) => {
        impl Real for $real {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Self = 0.5;
            const BOUND: Self = $bound;
            const SQUARABLE: Self = $squarable;
            const FAR: Self = $far;
            const FAR_LEVEL: Self = $far_level;

            #[inline]
            fn of(x: f64) -> Self {
                x as Self
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                <$real>::sqrt(self)
            }
            #[inline]
            fn abs(self) -> Self {
                <$real>::abs(self)
            }
            #[inline]
            fn floor(self) -> Self {
                <$real>::floor(self)
            }
            #[inline]
            fn max(self, other: Self) -> Self {
                <$real>::max(self, other)
            }
            #[inline]
            fn min(self, other: Self) -> Self {
                <$real>::min(self, other)
            }
            #[inline]
            fn sinc_cos(s: Self) -> [Self; 2] {
                $functions::sinc_cos(s)
            }
            #[inline]
            fn sinhc_cosh(t: Self) -> [Self; 2] {
                $functions::sinhc_cosh(t)
            }
            #[inline]
            fn sine_cosine(s: Self) -> [Self; 2] {
                $functions::sine_cosine(s)
            }
            #[inline]
            fn excess(s: Self) -> [Self; 2] {
                $functions::excess(s)
            }
            #[inline]
            fn half_exp(t: Self, rest: Self) -> [Self; 4] {
                $functions::half_exp(t, rest)
            }
            #[inline]
            fn length_rest(q: [Self; 3]) -> [Self; 2] {
                $functions::length_rest(q)
            }
            #[inline]
            fn exp(t: Self) -> Self {
                $functions::exp(t)
            }
            #[inline]
            fn sinc_bend(s: Self, sign: Self) -> Self {
                $functions::sinc_bend(s, sign)
            }
            #[inline]
            fn angle(sine: Self, cosine: Self) -> Self {
                $functions::angle(sine, cosine)
            }
            #[inline]
            fn asinh(x: Self) -> Self {
                $functions::asinh(x)
            }
        }
    };
}

real!(f64, library, 1e150, 1e100, 350.0, 170.0);
real!(f32, series, 1e18, 1e15, 79.0, 38.0);
