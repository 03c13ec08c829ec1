//! Charts, maps, normals, depth, distances and frames in both precisions, against 80 digits.

use antipode_geometry::Real;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::{
    cylindrical, depth, distance, exponential, frame, sphere, translation,
};

use super::functions::{both, double};
use super::golden::{Check, KERNELS, Unit, failures, one};

fn xyz<T: Copy>(x: &[T]) -> [T; 3] {
    [x[0], x[1], x[2]]
}

fn xyzw<T: Copy>(x: &[T]) -> [T; 4] {
    [x[0], x[1], x[2], x[3]]
}

fn exponential_point<T: Real>(x: &[T]) -> Vec<T> {
    exponential::point(x[0], xyz(&x[1..])).to_vec()
}

fn exponential_direction<T: Real>(x: &[T]) -> Vec<T> {
    exponential::direction(x[0], xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

fn exponential_normal<T: Real>(x: &[T]) -> Vec<T> {
    exponential::normal(x[0], xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

fn cylindrical_point<T: Real>(x: &[T]) -> Vec<T> {
    cylindrical::point(x[0], xyz(&x[1..])).to_vec()
}

fn cylindrical_direction<T: Real>(x: &[T]) -> Vec<T> {
    cylindrical::direction(x[0], xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

fn cylindrical_normal<T: Real>(x: &[T]) -> Vec<T> {
    cylindrical::normal(x[0], xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

fn sphere_point<T: Real>(x: &[T]) -> Vec<T> {
    sphere::point(x[0] > T::ZERO, xyz(&x[1..])).to_vec()
}

fn sphere_direction<T: Real>(x: &[T]) -> Vec<T> {
    sphere::direction(x[0] > T::ZERO, xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

fn sphere_normal<T: Real>(x: &[T]) -> Vec<T> {
    sphere::normal(xyz(&x[1..]), xyz(&x[4..])).to_vec()
}

/// In units of the radius, so that the error is a part of it.
fn sphere_port<T: Real>(x: &[T]) -> Vec<T> {
    sphere::port(x[0], x[1] > T::ZERO, xyz(&x[2..])).to_vec()
}

/// The map with constants that are the `f64` ones, rounded: what a uniform holds.
fn raised_map<T: Real>(radius_m: T, offset_m: T) -> RaisedMap<T> {
    let map = RaisedMap::new(radius_m.to_f64(), offset_m.to_f64());
    RaisedMap {
        k: T::of(map.k),
        radius_m,
        offset_m,
        offset: T::of(map.offset),
        sinh: T::of(map.sinh),
        cosh: T::of(map.cosh),
    }
}

fn raised_port<T: Real>(x: &[T]) -> Vec<T> {
    raised_map(x[0], x[1]).port(xyz(&x[2..])).to_vec()
}

fn raised_normal<T: Real>(x: &[T]) -> Vec<T> {
    raised_map(x[0], x[1])
        .normal(xyz(&x[2..]), xyz(&x[5..]))
        .to_vec()
}

fn horizon_map<T: Real>(kappa: T, lift_m: T) -> HorizonMap<T> {
    let map = HorizonMap::new(kappa.to_f64(), lift_m.to_f64());
    HorizonMap {
        kappa,
        k: T::of(map.k),
        radius_m: T::of(map.radius_m),
        lift_m,
        sin: T::of(map.sin),
        cos: T::of(map.cos),
    }
}

fn horizon_port<T: Real>(x: &[T]) -> Vec<T> {
    horizon_map(x[0], x[1]).port(xyz(&x[2..])).to_vec()
}

fn horizon_normal<T: Real>(x: &[T]) -> Vec<T> {
    horizon_map(x[0], x[1])
        .normal(xyz(&x[2..]), xyz(&x[5..]))
        .to_vec()
}

fn depths<T: Real>(x: &[T]) -> Vec<T> {
    let (near, k, view) = (x[1], x[2], xyzw(&x[3..]));
    vec![
        depth::exponential(near, k, view),
        depth::great(near, view),
        depth::upright(near, view),
        distance::from_eye(x[0], k, T::of(20.0), view),
    ]
}

fn distances<T: Real>(x: &[T]) -> [[T; 4]; 2] {
    [&x[1..4], &x[4..7]].map(|p| exponential::point(x[0], xyz(p)))
}

/// The distance as a part of the exact one is left to the extremes; here its absolute error.
fn chords<T: Real>(x: &[T]) -> Vec<T> {
    let [a, b] = distances(x);
    let length = if x[0] > T::ZERO {
        distance::spherical(a, b)
    } else {
        distance::hyperbolic(a, b)
    };
    let up = [T::ZERO, T::ONE, T::ZERO, T::ZERO];
    let mut out = vec![length];
    out.extend(distance::direction(x[0], a, b, up));
    out
}

fn hyperbolic_far(x: &[f64]) -> Vec<f64> {
    let [a, b] = [&x[..3], &x[3..]].map(|p| xyz(&exponential::point(-1.0, xyz(p))));
    vec![distance::hyperbolic_far(a, b)]
}

fn translated<T: Real>(x: &[T]) -> Vec<T> {
    translation::translation(x[0], xyz(&x[1..])).concat()
}

fn orthonormalized<T: Real>(x: &[T]) -> Vec<T> {
    let axes = [1, 5, 9, 13].map(|i| xyzw(&x[i..]));
    frame::orthonormalized(x[0], axes).concat()
}

fn radii(x: &[f64]) -> f64 {
    x[1].hypot(x[2]).hypot(x[3])
}

/// Distance from the chart's centre where hyperbolic: the condition of exp.
fn growth(x: &[f64]) -> f64 {
    if x[0] < 0.0 { radii(x) } else { 1.0 }
}

fn raised_growth(x: &[f64]) -> f64 {
    (x[2].hypot(x[3] + x[1]).hypot(x[4]) + x[1]) / x[0]
}

fn horizon_growth(x: &[f64]) -> f64 {
    (x[2].hypot(x[3]).hypot(x[4]) + x[1]) * x[0].abs().sqrt()
}

/// Near the antipode a rounding of the point turns the direction by its share of what is left.
fn chord_growth(x: &[f64]) -> f64 {
    let out = radii(&x[3..]);
    if x[0] > 0.0 && radii(x) == 0.0 {
        1.0 / out.sin()
    } else {
        1.0
    }
}

/// A normal across the ray far off turns by sinh d / d times a rounding of its arguments.
fn normal_growth(d: f64) -> f64 {
    if d > 1e-3 {
        (d.sinh() / d).min(1e12)
    } else {
        1.0
    }
}

pub fn checks() -> Vec<Check> {
    use Unit::{Own, Point, Vector};
    vec![
        both!(
            "exponential_point",
            &[
                "exponential::point",
                "charts::exponential",
                "exponential::sine_cosine"
            ],
            4,
            exponential_point,
            Point,
            growth,
            [2.0, 1.5]
        ),
        double!(
            "exponential_point_wide",
            &[],
            4,
            exponential_point,
            Point,
            growth,
            3.0
        ),
        both!(
            "exponential_direction",
            &["exponential::direction", "charts::exponential_direction"],
            7,
            exponential_direction,
            Vector,
            growth,
            [1.5, 1.5]
        ),
        both!(
            "exponential_normal",
            &["exponential::normal"],
            7,
            exponential_normal,
            Vector,
            |x| if x[0] < 0.0 {
                normal_growth(radii(x))
            } else {
                1.0
            },
            [1.5, 1.5]
        ),
        both!(
            "cylindrical_point",
            &["cylindrical::point", "charts::cylindrical"],
            4,
            cylindrical_point,
            Point,
            growth,
            [2.5, 2.5]
        ),
        double!(
            "cylindrical_point_wide",
            &[],
            4,
            cylindrical_point,
            Point,
            growth,
            3.0
        ),
        both!(
            "cylindrical_direction",
            &["cylindrical::direction", "charts::cylindrical_direction"],
            7,
            cylindrical_direction,
            Vector,
            growth,
            [1.5, 1.5]
        ),
        both!(
            "cylindrical_normal",
            &["cylindrical::normal"],
            7,
            cylindrical_normal,
            Vector,
            |x| if x[0] < 0.0 {
                normal_growth(radii(x))
            } else {
                1.0
            },
            [1.5, 1.5]
        ),
        both!(
            "sphere_point",
            &["sphere::point", "sphere::mirrored", "sphere::placed"],
            4,
            sphere_point,
            Vector,
            one,
            [1.5, 1.0]
        ),
        both!(
            "sphere_direction",
            &["sphere::direction"],
            7,
            sphere_direction,
            Vector,
            one,
            [1.5, 1.5]
        ),
        both!(
            "sphere_normal",
            &["sphere::normal"],
            7,
            sphere_normal,
            Vector,
            one,
            [1.5, 1.5]
        ),
        both!(
            "sphere_port",
            &["sphere::port"],
            5,
            sphere_port,
            Vector,
            one,
            [2.5, 2.5]
        ),
        both!(
            "raised_port",
            &[
                "raised::new",
                "raised::from_uniform",
                "raised::port",
                "raised::within_range"
            ],
            5,
            raised_port,
            Point,
            raised_growth,
            [5.0, 5.0]
        ),
        double!(
            "raised_port_wide",
            &[],
            5,
            raised_port,
            Point,
            raised_growth,
            4.0
        ),
        both!(
            "raised_normal",
            &["raised::normal"],
            8,
            raised_normal,
            Vector,
            |x| normal_growth(raised_growth(x)),
            [1.5, 1.5]
        ),
        both!(
            "horizon_port",
            &[
                "horizon::new",
                "horizon::from_uniform",
                "horizon::port",
                "horizon::within_range"
            ],
            5,
            horizon_port,
            Point,
            horizon_growth,
            [4.0, 3.5]
        ),
        both!(
            "horizon_normal",
            &["horizon::normal"],
            8,
            horizon_normal,
            Vector,
            |x| normal_growth(horizon_growth(x)),
            [1.5, 1.5]
        ),
        both!(
            "depth",
            &[
                "depth::exponential",
                "depth::great",
                "depth::upright",
                "distance::from_eye"
            ],
            7,
            depths,
            Own,
            one,
            [1.5, 1.5]
        ),
        both!(
            "chords",
            &[
                "distance::spherical",
                "distance::hyperbolic",
                "distance::direction"
            ],
            7,
            chords,
            Vector,
            chord_growth,
            [4.0, 4.0]
        ),
        double!(
            "hyperbolic_far",
            &["distance::hyperbolic_far"],
            6,
            hyperbolic_far,
            Own,
            one,
            8.0
        ),
        both!(
            "translation",
            &["translation::translation"],
            4,
            translated,
            Vector,
            growth,
            [4.0, 3.0]
        ),
        both!(
            "orthonormalized",
            &["frame::orthonormalized"],
            17,
            orthonormalized,
            Vector,
            one,
            [4.0, 4.0]
        ),
    ]
}

#[test]
fn kernels_keep_their_stated_bounds() {
    let failures = failures(KERNELS, &checks());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
