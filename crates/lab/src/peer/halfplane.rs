//! The half-plane representation: points `x + i y` with `y > 0`, isometries as real 2 x 2
//! matrices of determinant one, acting by `(a z + b) / (c z + d)`.
//!
//! The origin is i, and the first axis goes up from it. The disk coordinate of a point is
//! `(z - i) / (z + i)`, which gives its direction; `sinh(d/2) = |z - i| / (2 sqrt y)` its distance.

use std::marker::PhantomData;

use super::model::Model;
use super::number::{Number, length};

/// Points of the half-plane and matrices of SL(2, R).
#[derive(Clone, Copy, Debug)]
pub struct HalfPlane<N>(PhantomData<N>);

impl<N: Number> Model for HalfPlane<N> {
    type N = N;
    /// a, b, c, d.
    type Isometry = [N; 4];
    /// x, y.
    type Point = [N; 2];
    const NAME: &'static str = "half-plane";

    fn identity() -> [N; 4] {
        [N::of(1.0), N::of(0.0), N::of(0.0), N::of(1.0)]
    }

    fn origin() -> [N; 2] {
        [N::of(0.0), N::of(1.0)]
    }

    fn spin(angle: N) -> [N; 4] {
        let half = angle * N::of(0.5);
        let (c, s) = (half.cos(), half.sin());
        [c, s, -s, c]
    }

    fn push(distance: N) -> [N; 4] {
        let half = distance * N::of(0.5);
        [half.exp(), N::of(0.0), N::of(0.0), (-half).exp()]
    }

    fn compose(m: &[N; 4], n: &[N; 4]) -> [N; 4] {
        [
            m[0] * n[0] + m[1] * n[2],
            m[0] * n[1] + m[1] * n[3],
            m[2] * n[0] + m[3] * n[2],
            m[2] * n[1] + m[3] * n[3],
        ]
    }

    fn apply(m: &[N; 4], p: &[N; 2]) -> [N; 2] {
        let [x, y] = *p;
        let (top, bottom) = (m[0] * x + m[1], m[2] * x + m[3]);
        let square = bottom * bottom + m[2] * m[2] * y * y;
        // The imaginary part of the quotient is the determinant times y, and that is one.
        let real = top * bottom + m[0] * m[2] * y * y;
        [real / square, y / square]
    }

    fn inverse(m: &[N; 4]) -> [N; 4] {
        [m[3], -m[1], -m[2], m[0]]
    }

    /// The upper triangular matrix that takes i to the point, turned until it is symmetric.
    fn push_to(p: &[N; 2]) -> [N; 4] {
        let root = p[1].sqrt();
        let (a, b, d) = (root, p[0] / root, N::of(1.0) / root);
        let sum = a + d;
        let size = length([sum, b]);
        let (c, s) = (sum / size, -b / size);
        [a * c - b * s, a * s + b * c, -d * s, d * c]
    }

    fn distance(p: &[N; 2]) -> N {
        let chord = length([p[0], p[1] - N::of(1.0)]);
        N::of(2.0) * (chord / (N::of(2.0) * p[1].sqrt())).asinh()
    }

    fn angle(p: &[N; 2]) -> N {
        let one = N::of(1.0);
        let along = p[0] * p[0] + (p[1] - one) * (p[1] + one);
        (-(p[0] + p[0])).atan2(along)
    }
}
