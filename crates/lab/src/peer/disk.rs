//! The disk representation: isometries as pairs of complex numbers (u, v) with
//! `|u|^2 - |v|^2 = 1`, acting on the unit disk by `(u z + v) / (conj v z + conj u)`: SU(1, 1).
//!
//! A point is the isometry that takes the origin to it. `|v|` is `sinh(d/2)`, half the chord, so
//! the distance is `2 asinh |v|` with nothing cancelled near or far; the direction is that of
//! `u v`. Both numbers share a power of two, so that no distance overflows.

use std::f64::consts::LN_2;
use std::marker::PhantomData;

use super::model::Model;
use super::number::{Number, length};

/// Pairs of complex numbers with a common power of two.
#[derive(Clone, Copy, Debug)]
pub struct Disk<N>(PhantomData<N>);

/// `2^exponent (u, v)`.
#[derive(Clone, Copy, Debug)]
pub struct Mobius<N> {
    u: [N; 2],
    v: [N; 2],
    exponent: i32,
}

/// Numbers above this share out a power of two of the same size.
const STEP_BITS: i32 = 24;

/// Up to this power of two the product with it stays finite in single precision.
const DIRECT_BITS: i32 = 3 * STEP_BITS;

fn times<N: Number>(a: [N; 2], b: [N; 2]) -> [N; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn plus<N: Number>(a: [N; 2], b: [N; 2]) -> [N; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn conjugate<N: Number>(a: [N; 2]) -> [N; 2] {
    [a[0], -a[1]]
}

impl<N: Number> Mobius<N> {
    /// The power of two taken out where the numbers have grown.
    fn shared(mut self) -> Self {
        let limit = N::of(2.0_f64.powi(STEP_BITS));
        let large = |x: N| x > limit || x < -limit;
        if large(self.u[0]) || large(self.u[1]) {
            let down = N::of(2.0_f64.powi(-STEP_BITS));
            self.u = self.u.map(|x| x * down);
            self.v = self.v.map(|x| x * down);
            self.exponent += STEP_BITS;
        }
        self
    }

    /// Back to determinant one. Only meant where |v| is small, as beside a camera.
    #[must_use]
    pub fn renormalised(mut self) -> Self {
        let (u, v) = (length(self.u), length(self.v));
        let by = N::of(1.0) / ((u - v) * (u + v)).sqrt();
        self.u = self.u.map(|x| x * by);
        self.v = self.v.map(|x| x * by);
        self
    }
}

impl<N: Number> Disk<N> {
    /// The distance in radii whose half chord, `sinh(d/2)`, has this natural logarithm.
    pub fn distance_of_half_chord(logarithm: N) -> N {
        let half = if logarithm < N::of(f64::from(DIRECT_BITS) * LN_2) {
            logarithm.exp().asinh()
        } else {
            logarithm + N::of(LN_2)
        };
        N::of(2.0) * half
    }
}

impl<N: Number> Model for Disk<N> {
    type N = N;
    type Isometry = Mobius<N>;
    type Point = Mobius<N>;
    const NAME: &'static str = "disk";

    fn identity() -> Mobius<N> {
        let zero = N::of(0.0);
        Mobius {
            u: [N::of(1.0), zero],
            v: [zero, zero],
            exponent: 0,
        }
    }

    fn origin() -> Mobius<N> {
        Self::identity()
    }

    fn spin(angle: N) -> Mobius<N> {
        let half = angle * N::of(0.5);
        Mobius {
            u: [half.cos(), half.sin()],
            ..Self::identity()
        }
    }

    fn push(distance: N) -> Mobius<N> {
        let half = distance * N::of(0.5);
        Mobius {
            u: [half.cosh(), N::of(0.0)],
            v: [half.sinh(), N::of(0.0)],
            exponent: 0,
        }
    }

    fn compose(a: &Mobius<N>, b: &Mobius<N>) -> Mobius<N> {
        let product = Mobius {
            u: plus(times(a.u, b.u), times(a.v, conjugate(b.v))),
            v: plus(times(a.u, b.v), times(a.v, conjugate(b.u))),
            exponent: a.exponent + b.exponent,
        };
        product.shared()
    }

    fn apply(isometry: &Mobius<N>, point: &Mobius<N>) -> Mobius<N> {
        Self::compose(isometry, point)
    }

    fn inverse(m: &Mobius<N>) -> Mobius<N> {
        Mobius {
            u: conjugate(m.u),
            v: m.v.map(|x| -x),
            exponent: m.exponent,
        }
    }

    fn push_to(point: &Mobius<N>) -> Mobius<N> {
        let size = length(point.u);
        Mobius {
            u: [size, N::of(0.0)],
            v: times(point.v, point.u.map(|x| x / size)),
            exponent: point.exponent,
        }
    }

    fn distance(point: &Mobius<N>) -> N {
        let half_chord = length(point.v);
        if point.exponent <= DIRECT_BITS {
            return N::of(2.0) * (half_chord * N::of(2.0_f64.powi(point.exponent))).asinh();
        }
        let bits = N::of(f64::from(point.exponent));
        Self::distance_of_half_chord(half_chord.ln() + bits * N::of(LN_2))
    }

    fn angle(point: &Mobius<N>) -> N {
        let direction = times(point.u, point.v);
        direction[1].atan2(direction[0])
    }
}
