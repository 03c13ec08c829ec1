//! Distances and directions between points of the models, in units of the radius, by chords.
//!
//! An inner product near 1 has lost half of the digits; the chord e = b - a has not. With
//! `q = <e,e>`: hyperbolic `d = 2 asinh(sqrt(q)/2)`, spherical `d = 2 atan2(|a-b|, |a+b|)`. The
//! direction from a to b is the part of b tangent at a: since `<a,b> = S (1 - S q/2)`, that is
//! `e + S (q/2) a`, of squared length `q - S q^2/4`; past a right angle on the sphere, with
//! s = a + b, `s - (|s|^2/2) a`, of squared length `|s|^2 - |s|^4/4`.
//!
//! Points must be near the origin of the model, that is, relative to the camera: a hyperboloid
//! coordinate at distance D has an error of eps e^D, which a chord cannot give back.

use super::linear::{along, dot, inner, lacks, length, scaled, space};
use crate::real::Real;

/// `b - a`. The difference of two w near 1 has lost its digits; it follows from the rest, by
/// `(bw - aw)(bw + aw) = -S <b - a, b + a>` over the first three coordinates.
#[inline]
fn chord<T: Real>(sign: T, a: [T; 4], b: [T; 4]) -> [T; 4] {
    let mut e = along(b, a, -T::ONE);
    let sum = along(b, a, T::ONE);
    if sum[3].abs() > T::ONE {
        e[3] = -sign * dot(space(e), space(sum)) / sum[3];
    }
    e
}

/// `b - a` and `b + a` in double precision, where they are exact but for w.
#[inline]
fn chords<T: Real>(sign: f64, a: [T; 4], b: [T; 4]) -> [[f64; 4]; 2] {
    let (a, b) = (a.map(T::to_f64), b.map(T::to_f64));
    [chord(sign, a, b), along(a, b, 1.0)]
}

/// Distance of two points of the unit three-sphere, 0 to pi. The chords are measured in double
/// precision and rounded once.
#[inline]
pub fn spherical<T: Real>(a: [T; 4], b: [T; 4]) -> T {
    let [between, sum] = chords(1.0, a, b).map(|v| T::of(length(v)));
    T::of(2.0) * T::angle(between, sum)
}

/// Distance of two points of the hyperboloid near its origin. The chord is measured in double
/// precision and rounded once.
#[inline]
pub fn hyperbolic<T: Real>(a: [T; 4], b: [T; 4]) -> T {
    let [e, _] = chords(-1.0, a, b);
    let out = length(space(e));
    if out == 0.0 {
        return T::ZERO;
    }
    // <e,e> as a part of the spatial length, so that nothing underflows.
    let w = e[3] / out;
    let chord = out * ((1.0 - w) * (1.0 + w)).max(0.0).sqrt();
    T::of(2.0) * T::asinh(T::of(0.5 * chord))
}

/// Distance of two points of the hyperboloid anywhere, from their spatial parts:
/// `sinh^2(D/2) = sinh^2((ra - rb)/2) + sinh ra sinh rb sin^2(theta/2)` with ra, rb their distances
/// from the origin and theta the angle between them there. Nothing large is subtracted.
#[inline]
pub fn hyperbolic_far<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    let (sinh_a, sinh_b) = (length(a), length(b));
    let between = (T::asinh(sinh_a) - T::asinh(sinh_b)).abs() * T::HALF;
    let unit = |v: [T; 3], length: T| {
        if length > T::ZERO {
            v.map(|x| x / length)
        } else {
            v
        }
    };
    let turn = length(along(unit(a, sinh_a), unit(b, sinh_b), -T::ONE));
    let across = T::HALF * turn * sinh_a.sqrt() * sinh_b.sqrt();
    let climb = between * T::sinhc_cosh(between)[0];
    T::of(2.0) * T::asinh(length([climb, across]))
}

/// A vector of nearly unit length, moved by the little that it lacks: its length is off by one
/// rounding of its coordinates, 1e-7 in `f32`, where they are within 2. Farther out no `f32`
/// coordinate could say it better.
#[inline]
fn measured<T: Real>(sign: T, v: [T; 4]) -> [T; 4] {
    let lacks = lacks(sign, v);
    if lacks.abs() < T::of(1e-5) {
        along(v, v, T::HALF * lacks)
    } else {
        v
    }
}

/// The unit tangent at `a` towards `b`. Where every direction leads there, at one point and at the
/// antipode, it is `otherwise`: the surface's normal, a unit tangent at `a`.
#[inline]
pub fn direction<T: Real>(sign: T, a: [T; 4], b: [T; 4], otherwise: [T; 4]) -> [T; 4] {
    let e = chord(sign, a, b);
    let far = sign > T::ZERO && inner(sign, a, b) < T::ZERO;
    // From the antipode -a to b the direction is the same, by the chord a + b.
    let (e, turn) = if far {
        (along(a, b, T::ONE), -T::ONE)
    } else {
        (e, T::ONE)
    };
    let most = e.iter().fold(T::ZERO, |most, x| most.max(x.abs()));
    if most == T::ZERO {
        return otherwise;
    }
    let unit = e.map(|x| x / most);
    let q = inner(sign, unit, unit).max(T::ZERO);
    let half = T::HALF * sign * (q * most);
    let square = q - sign * (T::HALF * q * most) * (T::HALF * q * most);
    if square > T::ZERO {
        measured(
            sign,
            scaled(along(unit, a, turn * half), T::ONE / square.sqrt()),
        )
    } else {
        otherwise
    }
}

/// Distance from the eye, at the origin, to a point in view coordinates, in metres: `k` is the
/// curvature in 1/m and `sign` its sign.
#[inline]
pub fn from_eye<T: Real>(sign: T, k: T, radius_m: T, view: [T; 4]) -> T {
    let rho = length(space(view));
    if sign > T::ZERO {
        radius_m * T::angle(rho * k, view[3])
    } else if sign < T::ZERO {
        radius_m * T::asinh(rho * k)
    } else {
        rho
    }
}
