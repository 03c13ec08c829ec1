//! Frames of the model: their products, and Gram-Schmidt under the inner product.

use super::linear::{along, dot, inner, scaled, space};
use crate::real::Real;

/// The product of two matrices, given and returned by columns.
#[inline]
pub fn product<T: Real>(a: [[T; 4]; 4], b: [[T; 4]; 4]) -> [[T; 4]; 4] {
    b.map(|column| {
        let mut sum = scaled(a[0], column[0]);
        for (axis, part) in a.iter().zip(column).skip(1) {
            sum = along(sum, *axis, part);
        }
        sum
    })
}

/// The inner product, summed in double precision.
#[inline]
fn product_of<T: Real>(sign: T, a: [T; 4], b: [T; 4]) -> f64 {
    inner(sign.to_f64(), a.map(T::to_f64), b.map(T::to_f64))
}

/// A frame (three tangents and the point, by columns) made orthonormal again after rounding: the
/// point first, since it says where the frame is, then x, y, z in turn. `sign` is not 0.
#[inline]
pub fn orthonormalized<T: Real>(sign: T, frame: [[T; 4]; 4]) -> [[T; 4]; 4] {
    let [x, y, z, point] = frame;
    let unit = |v: [T; 4]| {
        let square = product_of(sign, v, v).abs();
        // What is nearly of unit length is moved by the little that it lacks: one rounding less.
        let lacks = 1.0 - square;
        if lacks.abs() < 1e-5 {
            return along(v, v, T::of(lacks * (0.5 + 0.375 * lacks)));
        }
        scaled(v, T::of(1.0 / square.sqrt()))
    };
    let mut point = unit(point);
    if sign < T::ZERO {
        // On the hyperboloid w is the greatest, and rounded most coarsely: it follows from the rest.
        point[3] = (T::ONE + dot(space(point), space(point))).sqrt();
    }
    let tangent = |v: [T; 4]| along(v, point, -sign * T::of(product_of(sign, v, point)));
    let without = |v: [T; 4], axis: [T; 4]| along(v, axis, -T::of(product_of(sign, v, axis)));
    let x = unit(tangent(x));
    let y = unit(without(tangent(y), x));
    let z = unit(without(without(tangent(z), x), y));
    let level = |v: [T; 4]| {
        let w = -sign * dot(space(v), space(point)) / point[3];
        if sign < T::ZERO {
            [v[0], v[1], v[2], w]
        } else {
            v
        }
    };
    squared_up(sign, [level(x), level(y), level(z), point])
}

/// A frame that is orthonormal but for roundings, moved by half of what its products are off, all
/// of it in double precision: what is left is one rounding of each entry.
#[inline]
fn squared_up<T: Real>(sign: T, frame: [[T; 4]; 4]) -> [[T; 4]; 4] {
    let sign = sign.to_f64();
    let wide = frame.map(|column| column.map(T::to_f64));
    let signs = [1.0, 1.0, 1.0, sign];
    let mut columns = wide;
    for (j, column) in columns.iter_mut().enumerate() {
        for (i, axis) in wide.iter().enumerate() {
            let due = if i == j { signs[i] } else { 0.0 };
            let off = inner(sign, *axis, wide[j]) - due;
            *column = along(*column, *axis, -0.5 * signs[i] * off);
        }
    }
    columns.map(|column| column.map(T::of))
}
