//! The exponential chart, in units of the radius: `X = (q sinc d, cos d)` with d = |q|, sine and
//! cosine those of the curvature's sign.
//!
//! Its differential keeps lengths along the ray and stretches those across it by sinc d; directions
//! are carried out from the centre along the ray (parallel transport), which turns only their part
//! along it.

use super::linear::{along, dot, normalized, scaled};
use super::parts::Parts;
use crate::real::Real;

/// The point of the model at `q` radii. Domain: sign > 0, `f32`: d <= pi; sign < 0: d <= 350 in
/// `f64`, 80 in `f32`.
#[inline]
pub fn point<T: Real>(sign: T, q: [T; 3]) -> [T; 4] {
    if sign < T::ZERO {
        let of = Parts::of(sign, q);
        let sinc = (of.scale + of.scale * of.sine) / of.divisor;
        let [x, y, z] = q.map(|x| x * sinc);
        return [x, y, z, of.scale + of.scale * of.cosine];
    }
    let [sinc, cos] = sine_cosine(sign, dot(q, q));
    [q[0] * sinc, q[1] * sinc, q[2] * sinc, cos]
}

/// The direction `v` at `q` by parallel transport: `v - sign/2 sinc^2(d/2) <v,q> q`, and
/// `-sign sinc(d) <v,q>` for w.
#[inline]
pub fn direction<T: Real>(sign: T, q: [T; 3], v: [T; 3]) -> [T; 4] {
    let along_ray = dot(v, q);
    let quarter = T::HALF * T::HALF * dot(q, q);
    let [half_sinc, half_cos] = sine_cosine(sign, quarter);
    let bend = -T::HALF * sign * half_sinc * half_sinc;
    let xyz = along(v, q, bend * along_ray);
    [
        xyz[0],
        xyz[1],
        xyz[2],
        -sign * half_sinc * half_cos * along_ray,
    ]
}

/// A chart normal at `q` as a unit covector in the frame carried out along the ray: the inverse
/// transpose of the differential. The part along the ray stays, the part across shrinks by sinc d:
/// `n/sinc + q (1 - 1/sinc) <n,q>/d^2`.
#[inline]
pub fn normal<T: Real>(sign: T, q: [T; 3], n: [T; 3]) -> [T; 3] {
    let s = dot(q, q);
    // Far out the part across is below the reach of the part along.
    let sinc = sine_cosine(sign, s)[0].min(T::SQUARABLE);
    let bend = bend(sign, s, sinc);
    normalized(along(scaled(n, T::ONE / sinc), q, bend / sinc * dot(n, q)))
}

/// `(sinc - 1)/s`, from a sinc already known where that does not cancel.
#[inline]
pub(crate) fn bend<T: Real>(sign: T, s: T, sinc: T) -> T {
    if s < T::of(4.0) || sign > T::ZERO {
        T::sinc_bend(s, sign)
    } else {
        (sinc - T::ONE) / s
    }
}

/// The sine over its argument and the cosine that belong to a sign, for `t^2 = s`.
#[inline]
pub fn sine_cosine<T: Real>(sign: T, s: T) -> [T; 2] {
    if sign > T::ZERO {
        T::sinc_cos(s)
    } else if sign < T::ZERO {
        T::sine_cosine(-s)
    } else {
        [T::ONE, T::ONE]
    }
}
