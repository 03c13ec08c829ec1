//! Sums, products and lengths of small arrays.

use crate::real::Real;

/// The dot product of two vectors.
#[inline]
pub fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The model's inner product `x x' + y y' + z z' + sign w w'`.
#[inline]
pub fn inner<T: Real>(sign: T, a: [T; 4], b: [T; 4]) -> T {
    dot(space(a), space(b)) + sign * a[3] * b[3]
}

/// The first three coordinates.
#[inline]
pub fn space<T: Real>(v: [T; 4]) -> [T; 3] {
    [v[0], v[1], v[2]]
}

/// `a + b t`.
#[inline]
pub fn along<T: Real, const N: usize>(a: [T; N], b: [T; N], t: T) -> [T; N] {
    let mut sum = a;
    for (sum, b) in sum.iter_mut().zip(b) {
        *sum = *sum + b * t;
    }
    sum
}

/// The vector times a number.
#[inline]
pub fn scaled<T: Real, const N: usize>(v: [T; N], by: T) -> [T; N] {
    v.map(|x| x * by)
}

/// The sum of squares.
#[inline]
fn squared<T: Real, const N: usize>(v: [T; N]) -> T {
    v.iter().skip(1).fold(v[0] * v[0], |sum, x| sum + *x * *x)
}

/// Length of a vector of whatever size: 2 ulp. Out of the range of squares it is measured in units
/// of its greatest coordinate.
#[inline]
pub fn length<T: Real, const N: usize>(v: [T; N]) -> T {
    let most = v.iter().fold(T::ZERO, |most, x| most.max(x.abs()));
    if most < T::SQUARABLE && most * T::SQUARABLE > T::ONE {
        return squared(v).sqrt();
    }
    if most == T::ZERO {
        return most;
    }
    most * squared(v.map(|x| x / most)).sqrt()
}

/// The vector over its length; zero stays zero.
#[inline]
pub fn normalized<T: Real>(v: [T; 3]) -> [T; 3] {
    let length = length(v);
    if length > T::ZERO {
        v.map(|x| x / length)
    } else {
        v
    }
}

/// What the square of a vector, under [`inner`], lacks of 1. Coordinates within 2, the square near
/// 1: exact to 1e-9 in `f32`. Each coordinate is cut after 11 bits behind the point: squares of
/// what is before the cut are whole multiples of 2^-22, which add up without rounding in any
/// order, fused or not.
#[inline]
pub fn lacks<T: Real>(sign: T, v: [T; 4]) -> T {
    let (unit, per_unit) = (T::of(1.0 / 2048.0), T::of(2048.0));
    let cut = v.map(|x| (x * per_unit + T::HALF).floor() * unit);
    let (rest, sum) = (along(v, cut, -T::ONE), along(v, cut, T::ONE));
    (T::ONE - inner(sign, cut, cut)) - inner(sign, rest, sum)
}

/// A chart displacement drawn in to `limit` metres, where it is finite.
#[inline]
pub fn drawn_in<T: Real>(u: [T; 3], limit: T) -> [T; 3] {
    let bounded = u.map(|x| x.max(-T::BOUND).min(T::BOUND));
    let far = dot(bounded, bounded).sqrt();
    if far > limit {
        scaled(bounded, limit / far)
    } else {
        bounded
    }
}
