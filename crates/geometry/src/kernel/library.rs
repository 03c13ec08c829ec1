//! Trigonometry in double precision, from the system's library.
//!
//! Each function is one or two library calls, good to one ulp each on common systems; they are not
//! the same bits on every system, and nothing that is saved depends on them.

/// Reciprocals of (2n + 3)!, n from 0: the series of (sinh(t)/t - 1)/t^2.
const BEND: [f64; 12] = [
    1.666_666_666_666_666_6e-1,
    8.333_333_333_333_333e-3,
    1.984_126_984_126_984e-4,
    2.755_731_922_398_589e-6,
    2.505_210_838_544_172e-8,
    1.605_904_383_682_161_5e-10,
    7.647_163_731_819_816e-13,
    2.811_457_254_345_521e-15,
    8.220_635_246_624_33e-18,
    1.957_294_106_339_126e-20,
    3.868_170_170_630_684e-23,
    6.446_950_284_384_474e-26,
];
/// The series stands for |s| below this: past it 1 is no longer close to the sine over its
/// argument, and subtracting it loses less than two bits.
const BEND_TO: f64 = 4.0;

/// (sin(t)/t, cos(t)) for t^2 = s >= 0: 2.5 ulp where t is within a right angle.
#[inline]
pub fn sinc_cos(s: f64) -> [f64; 2] {
    let t = s.sqrt();
    let (sin, cos) = t.sin_cos();
    [if t > 0.0 { sin / t } else { 1.0 }, cos]
}

/// (sinh(t)/t, cosh(t)) for |t| to 709: 3 ulp. With m = e^t - 1: `sinh = (m + m/(m + 1))/2` and
/// `cosh = (m + 1 + 1/(m + 1))/2`.
#[inline]
pub fn sinhc_cosh(t: f64) -> [f64; 2] {
    let a = t.abs();
    if a == 0.0 {
        return [1.0, 1.0];
    }
    let m = a.exp_m1();
    let e = m + 1.0;
    [0.5 * (m + m / e) / a, 0.5 * (e + 1.0 / e)]
}

/// The sine over its argument and the cosine of either curvature, for s = kappa t^2.
#[inline]
pub fn sine_cosine(s: f64) -> [f64; 2] {
    if s > 0.0 {
        sinc_cos(s)
    } else {
        sinhc_cosh((-s).sqrt())
    }
}

/// Half of exp(t + rest) and of its reciprocal, t >= 1, in the parts of the single-precision one,
/// `[a, high, low, fade]` with `exp/2 = a (1 + (high + low))` and `exp(-)/2 = a fade`: 2 ulp.
#[inline]
pub fn half_exp(t: f64, rest: f64) -> [f64; 4] {
    let e = t.exp();
    [1.0, 0.5 * e - 1.0, 0.5 * e * rest, 0.5 / e]
}

/// The length of a vector; in double precision nothing is told of its rounding.
#[inline]
pub fn length_rest(q: [f64; 3]) -> [f64; 2] {
    [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt(), 0.0]
}

/// What sin(t)/t and cos(t), or their hyperbolic counterparts, exceed 1 by, for s = kappa t^2 >=
/// -1: 3 ulp of 1, and no less exact near 0.
#[inline]
pub fn excess(s: f64) -> [f64; 2] {
    let half = sine_cosine(0.25 * s)[0];
    let bend = sinc_bend(s.abs(), if s > 0.0 { 1.0 } else { -1.0 });
    [s.abs() * bend, -0.5 * s * (half * half)]
}

/// e to the t: 1 ulp.
#[inline]
pub fn exp(t: f64) -> f64 {
    t.exp()
}

/// (sin(t)/t - 1)/t^2 where `sign` > 0, else (sinh(t)/t - 1)/t^2; t^2 = s: 3 ulp.
#[inline]
pub fn sinc_bend(s: f64, sign: f64) -> f64 {
    let curved = if sign > 0.0 { s } else { -s };
    if s >= BEND_TO {
        return (sine_cosine(curved)[0] - 1.0) / s;
    }
    let series = BEND.iter().rev().fold(0.0, |sum, c| c - curved * sum);
    if sign > 0.0 { -series } else { series }
}

/// atan2(sine, cosine): 1 ulp.
#[inline]
pub fn angle(sine: f64, cosine: f64) -> f64 {
    sine.atan2(cosine)
}

/// asinh(x): `log1p(x + x^2/(1 + sqrt(1 + x^2)))`, 3 ulp; past 1e150, where squares overflow,
/// log(x) + log 2.
#[inline]
pub fn asinh(x: f64) -> f64 {
    if x > 1e150 {
        return x.ln() + std::f64::consts::LN_2;
    }
    let square = x * x;
    (x + square / (1.0 + (1.0 + square).sqrt())).ln_1p()
}
