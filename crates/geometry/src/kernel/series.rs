//! Trigonometry in single precision: the functions of `shaders/trigonometry.wgsl`, line by line.
//!
//! Only + - * /, square roots and shifts of the exponent, so the bits are the same on every system
//! and thread. Coefficients are least-squares fits at Chebyshev nodes in 60 digits, rounded to
//! `f32` from the constant upwards with the rest fitted again after each; what is left of the
//! truncation is under a tenth of an ulp. Errors are in ulp of the result, arguments exact.

use std::f32::consts::{FRAC_PI_2, LOG2_E, PI};

/// ln 2 in two parts; a whole number up to 2^14 times the first is exact.
const LN2_HIGH: f32 = 0.693_359_4;
const LN2_LOW: f32 = -2.121_944_4e-4;
/// The series of sine and cosine end a little past a right angle, at this t^2: nearer it the half
/// angle's rounding would count four times.
const OBTUSE: f32 = 3.2;
/// What an octant of the angle begins with, and what rounding took from it: no or half a ratio in
/// the right of the half turn, in front of its upright, behind it, and in the left.
const BEGINNINGS: [[f32; 2]; 8] = [
    [0.0, 0.0],
    [0.463_647_6, 5.012_158_7e-9],
    [FRAC_PI_2, -4.371_139e-8],
    [1.107_148_8, -4.872_355e-8],
    [FRAC_PI_2, -4.371_139e-8],
    [2.034_443_9, 8.051_006e-8],
    [PI, -8.742_278e-8],
    [2.677_945_1, -9.243_495e-8],
];

/// (sin(t)/t - 1)/t^2 on 0 <= t^2 <= pi^2.
const SIN_BEND: [f32; 7] = [
    -0.166_666_67,
    0.008_333_348,
    -0.000_198_424_47,
    2.759_834_8e-6,
    -2.574_422_3e-8,
    2.162_827e-10,
    -2.450_907_5e-12,
];
/// (sin(t)/t - 1)/t^2 on -1 <= t^2 <= 3.2, where t^2 < 0 stands for sinh.
const SIN: [f32; 5] = [
    -0.166_666_67,
    0.008_333_336,
    -0.000_198_408_41,
    2.751_607_6e-6,
    -2.370_211_8e-8,
];
/// (cos(t) - 1)/t^2 on -1 <= t^2 <= 3.2, where t^2 < 0 stands for cosh.
const COS: [f32; 6] = [
    -0.5,
    0.041_666_668,
    -0.001_388_889_4,
    2.480_051_6e-5,
    -2.747_551e-7,
    1.903_503_6e-9,
];
/// (sinh(t)/t - 1)/t^2 on 0 <= t^2 <= 4.
const SINH_BEND: [f32; 6] = [
    0.166_666_67,
    0.008_333_309,
    0.000_198_447_19,
    2.736_083_4e-6,
    2.994_07e-8,
    -2.780_991_3e-10,
];
/// (exp(x) - 1 - x)/x^2 on -0.4 ln(2) <= x <= 0.6 ln(2).
const EXP: [f32; 6] = [
    0.5,
    0.166_666_69,
    0.041_666_6,
    0.008_332_246,
    0.001_391_440_9,
    0.000_209_505_86,
];
/// (atan(x)/x - 1)/x^2 on |x| <= 1/2.
const ATAN: [f32; 6] = [
    -0.333_333_34,
    0.199_999_91,
    -0.142_824_34,
    0.110_311_55,
    -0.083_332,
    0.043_684_28,
];
/// (asinh(x)/x - 1)/x^2 on 0 <= x <= 3/4.
const ASINH: [f32; 8] = [
    -0.166_666_67,
    0.075_000_24,
    -0.044_645_064,
    0.030_369_325,
    -0.022_089_198,
    0.015_658_088,
    -0.008_845_639,
    0.002_667_949,
];
/// (log(1 + g) - g)/g^2 on sqrt(1/2) <= 1 + g <= sqrt(2).
const LOG: [f32; 9] = [
    -0.499_999_9,
    0.333_333_25,
    -0.250_014_1,
    0.200_019_22,
    -0.166_123_1,
    0.141_838_82,
    -0.132_224_89,
    0.128_881_22,
    -0.076_479_08,
];

/// A polynomial by Horner's rule, the constant first.
#[inline]
fn polynomial<const N: usize>(x: f32, coefficients: &[f32; N]) -> f32 {
    let (last, rest) = coefficients
        .split_last()
        .map_or((0.0, &[][..]), |(l, r)| (*l, r));
    rest.iter().rev().fold(last, |sum, c| c + x * sum)
}

/// What both exceed 1 by, for s = kappa t^2 from -1 to [`OBTUSE`].
#[inline]
fn sinc_cos_excess(s: f32) -> [f32; 2] {
    [s * polynomial(s, &SIN), s * polynomial(s, &COS)]
}

/// (sin(t)/t, cos(t)) for t^2 = s, t up to pi, and (sinh(t)/t, cosh(t)) for t^2 = -s, t up to 1; past
/// s = 3.2 from the half angle: sin t = 2 sin cos, cos t = 2 cos^2 - 1. The sine over t to 1.5 ulp up
/// to a right angle, both to 1.5 ulp of 1 everywhere.
#[inline]
pub fn sinc_cos(s: f32) -> [f32; 2] {
    let far = s > OBTUSE;
    let [sinc, cos] = sinc_cos_excess(if far { 0.25 * s } else { s }).map(|x| 1.0 + x);
    if far {
        [sinc * cos, 2.0 * (cos * cos) - 1.0]
    } else {
        [sinc, cos]
    }
}

/// What the two of [`sinc_cos`] exceed 1 by: both to half an ulp of 1 before they are added to it,
/// and no less exact near 0.
#[inline]
pub fn excess(s: f32) -> [f32; 2] {
    if s > OBTUSE {
        sinc_cos(s).map(|x| x - 1.0)
    } else {
        sinc_cos_excess(s)
    }
}

/// Half of exp(t + rest), 0 <= t < 88 and |rest| an ulp of t at most, as a power of two a, high
/// and low: `a (1 + (high + low))`. High is what of t is left over the exponent, and exact.
#[inline]
fn half_exp_parts(t: f32, rest: f32) -> [f32; 3] {
    let n = (t * LOG2_E + 0.4).floor();
    let high = t - n * LN2_HIGH;
    let low = n * LN2_LOW - rest;
    let x = high - low;
    let a = f32::from_bits(((n as i32 + 126) as u32) << 23);
    [a, high, x * (x * polynomial(x, &EXP)) - low]
}

/// Half of exp(t + rest) and of its reciprocal, 1 <= t < 88: `[a, high, low, fade]` with
/// `exp/2 = a (1 + (high + low))` to half an ulp of a before the sum, and `exp(-)/2 = a fade`.
#[inline]
pub fn half_exp(t: f32, rest: f32) -> [f32; 4] {
    let [a, high, low] = half_exp_parts(t, rest);
    [a, high, low, 0.25 / (a * (1.0 + (high + low))) / a]
}

/// e to the t for 0 <= t < 88: 1 ulp.
#[inline]
pub fn exp(t: f32) -> f32 {
    let [a, high, low] = half_exp_parts(t, 0.0);
    2.0 * a * (1.0 + (high + low))
}

/// (sinh(t)/t, cosh(t)) for |t| to 81: series to 1, where nothing cancels, then exponentials, the
/// greatest part added last: 1.25 ulp. What is divided by t goes in two parts, the first of them
/// short, so that no rounding is doubled by the quotient.
#[inline]
pub fn sinhc_cosh(t: f32) -> [f32; 2] {
    let t = t.abs();
    if t < 1.0 {
        return sinc_cos(-(t * t));
    }
    let [a, high, low, fade] = half_exp(t, 0.0);
    let sine = low - fade;
    let short = f32::from_bits((1.0 + (high + sine)).to_bits() & 0xffff_f000);
    let left = ((1.0 - short) + high) + sine;
    [
        a * (short / t + left / t),
        a * (1.0 + (high + (low + fade))),
    ]
}

/// The length of a vector and what rounding took from it, which is known to 2^-33 of the length:
/// half of `q.q - t^2` over t. Each coordinate and t are cut at one place, 11 bits from t's first;
/// squares of what is before it add up without rounding in any order, fused or not.
///
/// Lengths from 1e-15 to 1e18.
#[inline]
pub fn length_rest(q: [f32; 3]) -> [f32; 2] {
    let t = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
    let exponent = t.to_bits() & 0x7f80_0000;
    let unit = f32::from_bits(exponent) * (1.0 / 1024.0);
    let per_unit = f32::from_bits(0x7f00_0000 - exponent) * 1024.0;
    let cut = |x: f32| (x * per_unit + 0.5).floor() * unit;
    let (h, ht) = (q.map(cut), cut(t));
    let before = h[0] * h[0] + h[1] * h[1] + h[2] * h[2] - ht * ht;
    let behind = (q[0] - h[0]) * (q[0] + h[0])
        + (q[1] - h[1]) * (q[1] + h[1])
        + (q[2] - h[2]) * (q[2] + h[2])
        - (t - ht) * (t + ht);
    [t, (before + behind) * (0.5 / t)]
}

/// The sine over its argument and the cosine of either curvature, for s = kappa t^2.
#[inline]
pub fn sine_cosine(s: f32) -> [f32; 2] {
    if s > -1.0 {
        return sinc_cos(s);
    }
    sinhc_cosh((-s).sqrt())
}

/// (sin(t)/t - 1)/t^2 where `sign` > 0, t to pi, else (sinh(t)/t - 1)/t^2, t to 80; t^2 = s.
#[inline]
pub fn sinc_bend(s: f32, sign: f32) -> f32 {
    if sign > 0.0 {
        return polynomial(s, &SIN_BEND);
    }
    if s < 4.0 {
        return polynomial(s, &SINH_BEND);
    }
    (sinhc_cosh(s.sqrt())[0] - 1.0) / s
}

/// atan2(sine, cosine) for sine >= 0. The ratio of the lesser to the greater goes through the
/// series, taken from 1/2 where it is more, and one sum adds what the octant begins with.
#[inline]
pub fn angle(sine: f32, cosine: f32) -> f32 {
    let c = cosine.abs();
    let (low, high) = (sine.min(c), sine.max(c));
    if high == 0.0 {
        return 0.0;
    }
    let half = low > 0.5 * high;
    let x = if half {
        (low - 0.5 * high) / (high + 0.5 * low)
    } else {
        low / high
    };
    let (steep, back) = (sine > c, cosine < 0.0);
    // From the uprights the series runs down to the right and up to the left, from level the
    // other way.
    let octant = match (steep, back) {
        (false, false) => 0,
        (true, false) => 2,
        (true, true) => 4,
        (false, true) => 6,
    };
    let [base, rest] = BEGINNINGS[octant + usize::from(half)];
    let x = if steep == back { x } else { -x };
    let s = x * x;
    base + (x + (x * (s * polynomial(s, &ATAN)) + rest))
}

/// asinh(x) for x >= 0. Past 3/4 it is the logarithm of x + sqrt(x^2 + 1) = 2x + r, with
/// `r = 1/(x + sqrt(x^2 + 1))`: the mantissa of 2x less 1 is exact, and r is added to that small
/// number, not to 2x.
#[inline]
pub fn asinh(x: f32) -> f32 {
    if x < 0.75 {
        let s = x * x;
        return x + x * (s * polynomial(s, &ASINH));
    }
    let y = x.min(1e4);
    let r = 1.0 / (y + (y * y + 1.0).sqrt());
    // 2x + r over 2^n lies between sqrt(1/2) and sqrt(2).
    let exponent = ((x + 0.5 * r) * std::f32::consts::SQRT_2).to_bits() >> 23;
    let n = exponent as i32 - 126;
    let scale = f32::from_bits(((128 - n) as u32) << 23);
    let g = (x * scale - 1.0) + 0.5 * (r * scale);
    let n = n as f32;
    n * LN2_HIGH + (g + (g * (g * polynomial(g, &LOG)) + n * LN2_LOW))
}
