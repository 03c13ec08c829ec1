//! T(q), the isometry that carries the origin of the model to the exponential chart's point q and
//! every direction along with it.
//!
//! From half-angles, `sin d = 2 sin(d/2) cos(d/2)` and `1 - cos d = 2 sin^2(d/2)`, both of one
//! series: the textbook's `1/(1 + w)` is infinite at the antipode.

use super::exponential::sine_cosine;
use super::linear::{dot, scaled};
use crate::real::Real;

/// The columns of T(q): the carried axes x, y, z, and the point. q is in radii; sign > 0: |q| <= 2
/// pi in `f32`.
///
/// With m = n sin(d/2) and c = cos(d/2): `I - 2 sign m m^T`, `2 c m`, `-2 sign c m^T` and
/// `1 - 2 sign m.m`. On the sphere 2 is replaced by `2/(m.m + c^2)`, which makes the matrix
/// orthogonal whatever the rounding of m and c.
#[inline]
pub fn translation<T: Real>(sign: T, q: [T; 3]) -> [[T; 4]; 4] {
    let [sinc, c] = sine_cosine(sign, T::HALF * T::HALF * dot(q, q));
    let m = scaled(q, T::HALF * sinc);
    let two = if sign > T::ZERO {
        T::of(2.0) / (dot(m, m) + c * c)
    } else {
        T::of(2.0)
    };
    let axis = |i: usize| {
        let mut v = [T::ZERO; 4];
        v[i] = T::ONE;
        for (v, m_j) in v.iter_mut().zip(m) {
            *v = *v - sign * two * (m[i] * m_j);
        }
        v[3] = -sign * two * (c * m[i]);
        v
    };
    let point = m.map(|x| two * (c * x));
    let w = T::ONE - sign * two * dot(m, m);
    [axis(0), axis(1), axis(2), [point[0], point[1], point[2], w]]
}
