//! The cylindrical (Fermi) chart, in units of the radius: out along the sheet y = 0 by r = |(x,z)|,
//! then straight up by y. With s, c the sine and cosine of the curvature's sign,
//! `X = (c(y) sinc(r) x, s(y), c(y) sinc(r) z, c(y) c(r))`.
//!
//! Lengths along its radial, tangential and upright axes are c(y), c(y) sinc(r) and 1 per chart
//! length: its differential is diagonal in that frame.

use super::exponential::{bend, sine_cosine};
use super::linear::normalized;
use super::parts::{Parts, product};
use crate::real::Real;

/// The point of the model at `p` radii. Domain: sign > 0, `f32`: r and |y| <= pi; sign < 0: r + |y|
/// <= 350 in `f64`, 80 in `f32`.
#[inline]
pub fn point<T: Real>(sign: T, p: [T; 3]) -> [T; 4] {
    if sign < T::ZERO {
        let level = Parts::of(sign, [p[0], T::ZERO, p[2]]);
        let climb = Parts::of(sign, [T::ZERO, p[1], T::ZERO]);
        let scale = level.scale * climb.scale;
        let across = product(scale, level.sine, climb.cosine) / level.divisor;
        let up = (climb.scale + climb.scale * climb.sine) / climb.divisor;
        return [
            across * p[0],
            up * p[1],
            across * p[2],
            product(scale, level.cosine, climb.cosine),
        ];
    }
    let [level, far] = sine_cosine(sign, p[0] * p[0] + p[2] * p[2]);
    let [up, upright] = sine_cosine(sign, p[1] * p[1]);
    [
        upright * level * p[0],
        up * p[1],
        upright * level * p[2],
        upright * far,
    ]
}

/// The direction `v` at `p` on the chart's orthonormal frame: what is level turns with the radius,
/// by `(cos(r) - 1)/r^2 = -sign/2 sinc^2(r/2)`, and the upright leans by the sine of y.
#[inline]
pub fn direction<T: Real>(sign: T, p: [T; 3], v: [T; 3]) -> [T; 4] {
    let square = p[0] * p[0] + p[2] * p[2];
    let along = v[0] * p[0] + v[2] * p[2];
    let half = sine_cosine(sign, T::HALF * T::HALF * square);
    let [level, far] = sine_cosine(sign, square);
    let turn = -T::HALF * sign * half[0] * half[0] * along;
    let [up, upright] = sine_cosine(sign, p[1] * p[1]);
    let fall = -sign * up * p[1] * v[1];
    [
        v[0] + turn * p[0] + fall * level * p[0],
        upright * v[1],
        v[2] + turn * p[2] + fall * level * p[2],
        -sign * level * along + fall * far,
    ]
}

/// A chart normal at `p` as a unit covector in the chart's frame: components divided by the axes'
/// lengths, all times `c(y) sinc(r)`.
#[inline]
pub fn normal<T: Real>(sign: T, p: [T; 3], n: [T; 3]) -> [T; 3] {
    let square = p[0] * p[0] + p[2] * p[2];
    let level = sine_cosine(sign, square)[0];
    let upright = sine_cosine(sign, p[1] * p[1])[1];
    level_normal(p, n, level, upright, bend(sign, square, level))
}

/// The rule of [`normal`] with sinc(r), c(y) and (sinc(r) - 1)/r^2 given; all is divided by the
/// greater of sinc(r) and 1, so that nothing overflows.
#[inline]
pub(crate) fn level_normal<T: Real>(p: [T; 3], n: [T; 3], level: T, upright: T, bend: T) -> [T; 3] {
    let along = bend * (n[0] * p[0] + n[2] * p[2]);
    let shrink = T::ONE / level.abs().max(T::ONE);
    normalized([
        (n[0] + along * p[0]) * shrink,
        n[1] * upright * (level * shrink),
        (n[2] + along * p[2]) * shrink,
    ])
}
