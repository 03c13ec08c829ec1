//! Functions of one or two numbers, in both precisions, against eighty digits.

use antipode_geometry::kernel::linear;
use antipode_geometry::kernel::parts::Parts;
use antipode_geometry::{Real, scalar};

use super::golden::{Check, FUNCTIONS, Unit, failures, one};

fn sinc_cos<T: Real>(x: &[T]) -> Vec<T> {
    T::sinc_cos(x[0]).to_vec()
}

fn sinhc_cosh<T: Real>(x: &[T]) -> Vec<T> {
    T::sinhc_cosh(x[0]).to_vec()
}

/// The same in parts: half exponentials from t = 1, what exceeds 1 before.
fn parts_of_sinhc_cosh<T: Real>(x: &[T]) -> Vec<T> {
    let parts = Parts::of(-T::ONE, [x[0], T::ZERO, T::ZERO]);
    vec![
        (parts.scale + parts.scale * parts.sine) / parts.divisor,
        parts.scale + parts.scale * parts.cosine,
    ]
}

fn parts_of_sine_cosine<T: Real>(x: &[T]) -> Vec<T> {
    if x[0] < -T::ONE {
        return sine_cosine(x);
    }
    let parts = Parts::near(x[0]);
    vec![T::ONE + parts.sine, T::ONE + parts.cosine]
}

fn sine_cosine<T: Real>(x: &[T]) -> Vec<T> {
    T::sine_cosine(x[0]).to_vec()
}

fn exp<T: Real>(x: &[T]) -> Vec<T> {
    vec![T::exp(x[0])]
}

fn sinc_bend<T: Real>(x: &[T]) -> Vec<T> {
    vec![T::sinc_bend(x[0], x[1])]
}

fn angle<T: Real>(x: &[T]) -> Vec<T> {
    vec![T::angle(x[0], x[1])]
}

fn asinh<T: Real>(x: &[T]) -> Vec<T> {
    vec![T::asinh(x[0])]
}

fn length<T: Real>(x: &[T]) -> Vec<T> {
    let v = [x[0], x[1], x[2]];
    let unit = linear::normalized(v);
    vec![linear::length(v), unit[0], unit[1], unit[2]]
}

fn scalars(x: &[f64]) -> Vec<f64> {
    let (sign, t) = (x[0], x[1]);
    vec![
        scalar::sinc_s(sign, t),
        scalar::sin_s(sign, t),
        scalar::cos_s(sign, t),
        scalar::cos_minus_one_over_square(sign, t),
        scalar::sinc_minus_one_over_square(sign, t),
    ]
}

/// The condition of exp: half an ulp of the root of s is that many ulp of the answer.
fn root_condition(x: &[f64]) -> f64 {
    if x[0] < -1.0 { (-x[0]).sqrt() } else { 1.0 }
}

macro_rules! both {
    ($table:literal, $covers:expr, $arguments:literal, $kernel:ident, $unit:expr, $condition:expr, $bounds:expr) => {
        Check {
            table: $table,
            covers: $covers,
            arguments: $arguments,
            double: $kernel,
            single: Some($kernel),
            unit: $unit,
            condition: $condition,
            bounds: $bounds,
        }
    };
}

macro_rules! double {
    ($table:literal, $covers:expr, $arguments:literal, $kernel:expr, $unit:expr, $condition:expr, $bound:expr) => {
        Check {
            table: $table,
            covers: $covers,
            arguments: $arguments,
            double: $kernel,
            single: None,
            unit: $unit,
            condition: $condition,
            bounds: [$bound, 0.0],
        }
    };
}
pub(crate) use {both, double};

pub fn checks() -> Vec<Check> {
    use Unit::{One, Own};
    vec![
        both!(
            "sinc_cos",
            &["library::sinc_cos", "series::sinc_cos"],
            1,
            sinc_cos,
            One,
            one,
            [1.5, 1.5]
        ),
        both!(
            "sinhc_cosh",
            &["library::sinhc_cosh", "series::sinhc_cosh"],
            1,
            sinhc_cosh,
            Own,
            one,
            [3.0, 1.25]
        ),
        double!("sinhc_cosh_wide", &[], 1, sinhc_cosh, Own, one, 3.0),
        both!(
            "sinhc_cosh",
            &["library::half_exp", "series::half_exp", "parts::of"],
            1,
            parts_of_sinhc_cosh,
            Own,
            one,
            [4.0, 2.0]
        ),
        both!(
            "sine_cosine",
            &["library::excess", "series::excess", "parts::near"],
            1,
            parts_of_sine_cosine,
            One,
            root_condition,
            [3.0, 1.5]
        ),
        both!(
            "sine_cosine",
            &["library::sine_cosine", "series::sine_cosine"],
            1,
            sine_cosine,
            One,
            root_condition,
            [3.0, 1.6]
        ),
        both!(
            "exp",
            &["library::exp", "series::exp"],
            1,
            exp,
            Own,
            one,
            [1.0, 1.0]
        ),
        both!(
            "sinc_bend",
            &["library::sinc_bend", "series::sinc_bend"],
            2,
            sinc_bend,
            Own,
            one,
            [3.0, 1.5]
        ),
        both!(
            "angle",
            &["library::angle", "series::angle"],
            2,
            angle,
            Own,
            one,
            [1.0, 1.5]
        ),
        both!(
            "asinh",
            &["library::asinh", "series::asinh"],
            1,
            asinh,
            Own,
            one,
            [3.0, 1.5]
        ),
        both!(
            "length",
            &["linear::length", "linear::normalized"],
            3,
            length,
            Own,
            one,
            [2.5, 2.5]
        ),
        double!(
            "scalar",
            &[
                "scalar::sinc_s",
                "scalar::sin_s",
                "scalar::cos_s",
                "scalar::sinc",
                "scalar::sinhc",
                "scalar::cos_minus_one_over_square",
                "scalar::sinc_minus_one_over_square"
            ],
            2,
            scalars,
            Own,
            |x| x[1],
            4.0
        ),
        double!(
            "sin_cos_k",
            &["scalar::sin_k", "scalar::cos_k"],
            2,
            |x| vec![scalar::sin_k(x[0], x[1]), scalar::cos_k(x[0], x[1])],
            One,
            |x| x[0].abs().sqrt() * x[1],
            4.0
        ),
        double!(
            "asin_k",
            &["scalar::asin_k"],
            2,
            |x| vec![scalar::asin_k(x[0], x[1])],
            Own,
            one,
            4.0
        ),
        double!(
            "atan_k",
            &["scalar::atan_k"],
            3,
            |x| vec![scalar::atan_k(x[0], x[1], x[2])],
            Own,
            one,
            4.0
        ),
        double!(
            "acos_k",
            &["scalar::acos_k"],
            2,
            |x| vec![scalar::acos_k(x[0], x[1]).unwrap_or(f64::NAN)],
            Own,
            one,
            4.0
        ),
    ]
}

#[test]
fn functions_keep_their_stated_bounds() {
    let failures = failures(FUNCTIONS, &checks());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
