//! The polar representation: a point is a direction and a distance, an isometry a turn followed
//! by a translation in a direction.
//!
//! Composing solves one hyperbolic triangle with two sides and the angle between them. Its third
//! side comes from `sinh^2(c/2) = sinh^2((a-b)/2) + sinh a sinh b cos^2(alpha/2)`, where alpha is
//! the outer angle, and its angles from the sine and cosine rules, in the form that does not
//! cancel for the alpha at hand.

use std::f64::consts::PI;
use std::marker::PhantomData;

use super::model::Model;
use super::number::Number;

/// Directions and distances.
#[derive(Clone, Copy, Debug)]
pub struct Polar<N>(PhantomData<N>);

/// A turn about the origin, then a translation.
#[derive(Clone, Copy, Debug)]
pub struct Motion<N> {
    turn: N,
    direction: N,
    distance: N,
}

/// Direction and distance from the origin.
#[derive(Clone, Copy, Debug)]
pub struct Bearing<N> {
    direction: N,
    distance: N,
}

/// An angle brought between minus pi and pi.
fn wrapped<N: Number>(angle: N) -> N {
    let (half, full) = (N::of(PI), N::of(2.0 * PI));
    let mut angle = angle;
    while angle > half {
        angle = angle - full;
    }
    while angle < -half {
        angle = angle + full;
    }
    angle
}

/// `sinh a cosh b + cosh a sinh b cos alpha`, the third side's part along the side a.
fn along<N: Number>(a: N, b: N, cos: N, sin_half: N, cos_half: N) -> N {
    let product = N::of(2.0) * a.cosh() * b.sinh();
    if cos > N::of(0.0) {
        (a + b).sinh() - product * sin_half * sin_half
    } else {
        (a - b).sinh() + product * cos_half * cos_half
    }
}

struct Triangle<N> {
    side: N,
    /// From the first side to the third, at the start.
    first: N,
    /// From the third side to the second, at the end.
    second: N,
}

fn triangle<N: Number>(a: N, b: N, alpha: N) -> Triangle<N> {
    let half = alpha * N::of(0.5);
    let (cos, sin, sin_half, cos_half) = (alpha.cos(), alpha.sin(), half.sin(), half.cos());
    let between = ((a - b) * N::of(0.5)).sinh();
    let (sinh_a, sinh_b) = (a.sinh(), b.sinh());
    let square = between * between + sinh_a * sinh_b * cos_half * cos_half;
    Triangle {
        side: N::of(2.0) * square.sqrt().asinh(),
        first: (sinh_b * sin).atan2(along(a, b, cos, sin_half, cos_half)),
        second: (sinh_a * sin).atan2(along(b, a, cos, sin_half, cos_half)),
    }
}

impl<N: Number> Model for Polar<N> {
    type N = N;
    type Isometry = Motion<N>;
    type Point = Bearing<N>;
    const NAME: &'static str = "polar";

    fn identity() -> Motion<N> {
        Self::spin(N::of(0.0))
    }

    fn origin() -> Bearing<N> {
        let zero = N::of(0.0);
        Bearing {
            direction: zero,
            distance: zero,
        }
    }

    fn spin(angle: N) -> Motion<N> {
        let zero = N::of(0.0);
        Motion {
            turn: angle,
            direction: zero,
            distance: zero,
        }
    }

    fn push(distance: N) -> Motion<N> {
        let (turn, direction) = (N::of(0.0), N::of(0.0));
        Motion {
            turn,
            direction,
            distance,
        }
    }

    fn compose(first: &Motion<N>, second: &Motion<N>) -> Motion<N> {
        let turn = wrapped(first.turn + second.turn);
        let second_direction = wrapped(second.direction + first.turn);
        if first.distance == N::of(0.0) {
            return Motion {
                turn,
                direction: second_direction,
                distance: second.distance,
            };
        }
        if second.distance == N::of(0.0) {
            return Motion { turn, ..*first };
        }
        let alpha = wrapped(second_direction - first.direction);
        let found = triangle(first.distance, second.distance, alpha);
        Motion {
            turn: wrapped(turn + (found.first + found.second - alpha)),
            direction: wrapped(first.direction + found.first),
            distance: found.side,
        }
    }

    fn apply(isometry: &Motion<N>, point: &Bearing<N>) -> Bearing<N> {
        let moved = Self::compose(isometry, &Self::push_to(point));
        Bearing {
            direction: moved.direction,
            distance: moved.distance,
        }
    }

    fn inverse(isometry: &Motion<N>) -> Motion<N> {
        Motion {
            turn: -isometry.turn,
            direction: wrapped(isometry.direction - isometry.turn + N::of(PI)),
            distance: isometry.distance,
        }
    }

    fn push_to(point: &Bearing<N>) -> Motion<N> {
        Motion {
            turn: N::of(0.0),
            direction: point.direction,
            distance: point.distance,
        }
    }

    fn distance(point: &Bearing<N>) -> N {
        point.distance
    }

    fn angle(point: &Bearing<N>) -> N {
        point.direction
    }
}
