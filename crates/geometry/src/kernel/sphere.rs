//! The three-sphere in two cylindrical charts: B(p) = diag(-1, 1, 1, -1) A(p), a rotation, so that
//! orientation and "up" are the same in both hemispheres.

use super::cylindrical;
use crate::real::Real;

/// Mirrors the chart of hemisphere B: x is negated.
#[inline]
pub fn mirrored<T: Real>(b: bool, v: [T; 3]) -> [T; 3] {
    if b { [-v[0], v[1], v[2]] } else { v }
}

/// A vector of hemisphere A's model in its place: w is negated in B.
#[inline]
pub fn placed<T: Real>(b: bool, v: [T; 4]) -> [T; 4] {
    if b { [v[0], v[1], v[2], -v[3]] } else { v }
}

/// The point of the unit three-sphere at `p` radii in hemisphere A, or `b`.
#[inline]
pub fn point<T: Real>(b: bool, p: [T; 3]) -> [T; 4] {
    placed(b, cylindrical::point(T::ONE, mirrored(b, p)))
}

/// A chart direction at `p` as a tangent of the unit three-sphere.
#[inline]
pub fn direction<T: Real>(b: bool, p: [T; 3], v: [T; 3]) -> [T; 4] {
    let tangent = cylindrical::direction(T::ONE, mirrored(b, p), mirrored(b, v));
    placed(b, tangent)
}

/// A chart normal at `p` radii as a unit covector in the chart's frame; the mirror leaves the
/// formula as it is.
#[inline]
pub fn normal<T: Real>(p: [T; 3], n: [T; 3]) -> [T; 3] {
    cylindrical::normal(T::ONE, p, n)
}

/// The point with xyz in metres, as the shader has it; `k` is the curvature in 1/m and `p` in
/// metres from the hemisphere's pole.
#[inline]
pub fn port<T: Real>(k: T, b: bool, p: [T; 3]) -> [T; 4] {
    let u = p.map(|x| x * k);
    let [level, far] = T::sinc_cos(u[0] * u[0] + u[2] * u[2]);
    let [up, upright] = T::sinc_cos(u[1] * u[1]);
    let flip = if b { -T::ONE } else { T::ONE };
    [
        upright * level * p[0] * flip,
        up * p[1],
        upright * level * p[2],
        upright * far * flip,
    ]
}
