//! The linear representation: points on the hyperboloid `z^2 = 1 + x^2 + y^2`, isometries as
//! 3 x 3 matrices of SO(2, 1).
//!
//! Never corrected, or with Gram and Schmidt's process in the Minkowski form after every product:
//! taking the last column, the image of the origin, as it is, or putting it back onto the
//! hyperboloid first. Coordinates grow as `exp d`, so a difference between far points loses
//! `exp 2d` units in the last place. Distances are `asinh |(x, y)|`, and once, as published,
//! `acosh z`, which near the origin holds half as many digits.

use std::marker::PhantomData;

use super::model::Model;
use super::number::{Number, length};

/// Products stay as they are.
pub const BARE: u8 = 0;
/// The two other columns are made orthogonal to the last, and to each other.
pub const COLUMNS: u8 = 1;
/// As [`COLUMNS`], after the last column and every point are put back onto the hyperboloid.
pub const LIFTED: u8 = 2;

/// As [`COLUMNS`], with distances by `acosh z`, and none where z is below one.
pub const PUBLISHED: u8 = 3;

/// Hyperboloid vectors and matrices, corrected after each product by one of the ways above.
#[derive(Clone, Copy, Debug)]
pub struct Linear<N, const CORRECTION: u8>(PhantomData<N>);

type Vector<N> = [N; 3];
/// By columns: the images of the two axes and of the origin.
type Matrix<N> = [Vector<N>; 3];

fn scaled<N: Number>(v: Vector<N>, by: N) -> Vector<N> {
    v.map(|entry| entry * by)
}

fn plus<N: Number>(a: Vector<N>, b: Vector<N>) -> Vector<N> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn inner<N: Number>(a: Vector<N>, b: Vector<N>) -> N {
    a[0] * b[0] + a[1] * b[1] - a[2] * b[2]
}

fn image<N: Number>(m: &Matrix<N>, v: &Vector<N>) -> Vector<N> {
    let first = plus(scaled(m[0], v[0]), scaled(m[1], v[1]));
    plus(first, scaled(m[2], v[2]))
}

/// Back onto the hyperboloid, keeping x and y.
fn lifted<N: Number>(v: Vector<N>) -> Vector<N> {
    let z = (N::of(1.0) + v[0] * v[0] + v[1] * v[1]).sqrt();
    [v[0], v[1], z]
}

/// A column across `last` and the columns already done, of length one where it has a length.
fn across<N: Number>(column: Vector<N>, last: Vector<N>, done: Option<Vector<N>>) -> Vector<N> {
    let mut column = plus(column, scaled(last, inner(column, last)));
    if let Some(done) = done {
        column = plus(column, scaled(done, -inner(column, done)));
    }
    let square = inner(column, column);
    if square > N::of(0.0) {
        scaled(column, N::of(1.0) / square.sqrt())
    } else {
        column
    }
}

fn orthogonal<N: Number>(m: Matrix<N>, last: Vector<N>) -> Matrix<N> {
    let second = across(m[1], last, None);
    [across(m[0], last, Some(second)), second, last]
}

fn rows<N: Number>(r: [[N; 3]; 3]) -> Matrix<N> {
    [0, 1, 2].map(|column| [r[0][column], r[1][column], r[2][column]])
}

impl<N: Number, const CORRECTION: u8> Model for Linear<N, CORRECTION> {
    type N = N;
    type Isometry = Matrix<N>;
    type Point = Vector<N>;
    const NAME: &'static str = match CORRECTION {
        COLUMNS => "linear, Gram-Schmidt",
        LIFTED => "linear, Gram-Schmidt, lifted",
        PUBLISHED => "linear, Gram-Schmidt, acosh",
        _ => "linear",
    };

    fn identity() -> Matrix<N> {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
    }

    fn origin() -> Vector<N> {
        [N::of(0.0), N::of(0.0), N::of(1.0)]
    }

    fn spin(angle: N) -> Matrix<N> {
        let (zero, one, c, s) = (N::of(0.0), N::of(1.0), angle.cos(), angle.sin());
        rows([[c, -s, zero], [s, c, zero], [zero, zero, one]])
    }

    fn push(distance: N) -> Matrix<N> {
        let (zero, one, c, s) = (N::of(0.0), N::of(1.0), distance.cosh(), distance.sinh());
        rows([[c, zero, s], [zero, one, zero], [s, zero, c]])
    }

    fn compose(first: &Matrix<N>, second: &Matrix<N>) -> Matrix<N> {
        let product = [0, 1, 2].map(|column| image(first, &second[column]));
        match CORRECTION {
            COLUMNS | PUBLISHED => orthogonal(product, product[2]),
            LIFTED => orthogonal(product, lifted(product[2])),
            _ => product,
        }
    }

    fn apply(isometry: &Matrix<N>, point: &Vector<N>) -> Vector<N> {
        let moved = image(isometry, point);
        if CORRECTION == LIFTED {
            lifted(moved)
        } else {
            moved
        }
    }

    fn inverse(m: &Matrix<N>) -> Matrix<N> {
        [
            [m[0][0], m[1][0], -m[2][0]],
            [m[0][1], m[1][1], -m[2][1]],
            [-m[0][2], -m[1][2], m[2][2]],
        ]
    }

    fn push_to(p: &Vector<N>) -> Matrix<N> {
        let one = N::of(1.0);
        let share = one / (p[2] + one);
        let (x, y) = (p[0], p[1]);
        rows([
            [one + x * x * share, x * y * share, x],
            [x * y * share, one + y * y * share, y],
            [x, y, p[2]],
        ])
    }

    fn distance(p: &Vector<N>) -> N {
        if CORRECTION != PUBLISHED {
            return length([p[0], p[1]]).asinh();
        }
        let (one, z) = (N::of(1.0), p[2]);
        if z < one {
            return N::of(0.0);
        }
        (z + (z - one).sqrt() * (z + one).sqrt()).ln()
    }

    fn angle(p: &Vector<N>) -> N {
        p[1].atan2(p[0])
    }
}
