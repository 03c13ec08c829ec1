//! Trigonometry shared by the curved spaces, stable near zero.
//!
//! `sign` is the sign of the curvature: -1 hyperbolic, 0 flat, +1 spherical. Arguments are
//! lengths in units of the radius of curvature.

use crate::real::Real;

/// sin(t)/t, with 1 at t = 0: 1.5 ulp.
pub fn sinc(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { t.sin() / t }
}

/// sinh(t)/t, with 1 at t = 0: 3 ulp for |t| to 709, where e^t ends.
pub fn sinhc(t: f64) -> f64 {
    f64::sinhc_cosh(t)[0]
}

/// The sine over its argument that belongs to the curvature's sign.
pub fn sinc_s(sign: f64, t: f64) -> f64 {
    if sign > 0.0 {
        sinc(t)
    } else if sign < 0.0 {
        sinhc(t)
    } else {
        1.0
    }
}

/// The sine that belongs to the curvature's sign: sinh, t or sin.
pub fn sin_s(sign: f64, t: f64) -> f64 {
    sinc_s(sign, t) * t
}

/// The cosine that belongs to the curvature's sign: cosh, 1 or cos.
pub fn cos_s(sign: f64, t: f64) -> f64 {
    if sign > 0.0 {
        t.cos()
    } else if sign < 0.0 {
        t.cosh()
    } else {
        1.0
    }
}

/// `(cos_s(t) - 1) / t^2`, which is `-sign/2 sinc_s(t/2)^2` and never cancels.
pub fn cos_minus_one_over_square(sign: f64, t: f64) -> f64 {
    let half = sinc_s(sign, 0.5 * t);
    -0.5 * sign * half * half
}

/// `(sinc_s(t) - 1) / t^2`: a series to t = 2, where the difference would cancel; 0 where flat.
pub fn sinc_minus_one_over_square(sign: f64, t: f64) -> f64 {
    if sign == 0.0 {
        0.0
    } else {
        f64::sinc_bend(t * t, sign)
    }
}

/// The sine of curvature kappa, in metres: sin(k t)/k, t or sinh(k t)/k with `kappa = +-k^2` per
/// square metre and t in metres. Smooth in kappa.
pub fn sin_k(kappa: f64, t: f64) -> f64 {
    t * sinc_s(kappa, kappa.abs().sqrt() * t)
}

/// The cosine of curvature kappa: cos(k t), 1 or cosh(k t). Smooth in kappa.
pub fn cos_k(kappa: f64, t: f64) -> f64 {
    cos_s(kappa, kappa.abs().sqrt() * t)
}

/// The inverse of [`sin_k`] where `kappa <= 0`: asinh(k s)/k or s, in metres.
pub fn asin_k(kappa: f64, s: f64) -> f64 {
    let k = kappa.abs().sqrt();
    if k == 0.0 { s } else { (k * s).asinh() / k }
}

/// The length whose [`sin_k`] is to its [`cos_k`] as `s` to `c`, where `kappa > 0`, in metres.
pub fn atan_k(kappa: f64, s: f64, c: f64) -> f64 {
    let k = kappa.abs().sqrt();
    (k * s).atan2(c) / k
}

/// The length whose [`cos_k`] is `c`, in metres; `None` where there is none, or no single one.
pub fn acos_k(kappa: f64, c: f64) -> Option<f64> {
    let k = kappa.abs().sqrt();
    let angle = if kappa > 0.0 { c.acos() } else { c.acosh() };
    (k > 0.0 && angle.is_finite()).then(|| angle / k)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_branches_of_the_series_meet() {
        for sign in [-1.0, 1.0] {
            let (below, above) = (2.0 - 1e-12, 2.0 + 1e-12);
            let low = sinc_minus_one_over_square(sign, below);
            let high = sinc_minus_one_over_square(sign, above);
            assert!((low - high).abs() < 1e-13, "{low} {high}");
            assert!((sinc_minus_one_over_square(sign, 0.0) + sign / 6.0).abs() < 1e-16);
        }
    }

    #[test]
    fn small_differences_keep_their_digits() {
        // cosh(1e-9) - 1 is 5e-19: the difference itself would be zero in f64.
        let c = cos_minus_one_over_square(-1.0, 1e-9);
        assert!((c - 0.5).abs() < 1e-15);
        assert_eq!(sinc(0.0), 1.0);
        assert_eq!(sinhc(0.0), 1.0);
    }

    #[test]
    fn pythagoras_holds_for_each_sign() {
        for sign in [-1.0, 0.0, 1.0] {
            for t in [1e-8, 0.1, 1.0, 2.5] {
                let (s, c) = (sin_s(sign, t), cos_s(sign, t));
                assert!((c * c + sign * s * s - 1.0).abs() < 1e-12);
            }
        }
    }
}
