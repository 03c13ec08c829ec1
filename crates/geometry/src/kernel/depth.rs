//! Clip z of each depth rule, reversed: nearer is greater, and the division by -Z is the
//! hardware's.

use super::linear::{length, space};
use crate::real::Real;

/// `n / (W + k rho)`, which is `n exp(-d)` at hyperbolic distance d; `k` in 1/m.
#[inline]
pub fn exponential<T: Real>(near_m: T, k: T, view: [T; 4]) -> T {
    near_m / (view[3] + k * length(space(view)))
}

/// `(n W - Z)/2`: on the sphere, linear in the vertex.
#[inline]
pub fn great<T: Real>(near_m: T, view: [T; 4]) -> T {
    T::HALF * (near_m * view[3] - view[2])
}

/// `n (1 + W)/2`: on the sphere, and the flat rule as it grows.
#[inline]
pub fn upright<T: Real>(near_m: T, view: [T; 4]) -> T {
    T::HALF * near_m * (T::ONE + view[3])
}
