//! The tables of the theses, which chose "translate, then port" by them.
//!
//! They use the exponential chart on the unit sphere, in the plane; it is the same chart that
//! the raised map uses in hyperbolic space.

use antipode_geometry::charts::{exponential, exponential_direction, inner};
use glam::{DVec3, DVec4};

const RECTANGLE: [(f64, f64); 4] = [(-0.5, -0.7), (0.5, -0.7), (0.5, 0.5), (-0.5, 0.5)];

fn port((x, y): (f64, f64)) -> DVec4 {
    exponential(1.0, DVec3::new(x, y, 0.0))
}

/// The isometry that takes the origin to `port(to)` along the ray.
fn translate(point: DVec4, (x, y): (f64, f64)) -> DVec4 {
    let to = DVec3::new(x, y, 0.0);
    exponential_direction(1.0, to, point.truncate()) + exponential(1.0, to) * point.w
}

fn check(points: [DVec4; 4], table: [(f64, f64, f64); 4]) {
    for (point, (x, y, w)) in points.into_iter().zip(table) {
        let printed = DVec4::new(x, y, 0.0, w);
        assert!(
            (point - printed).abs().max_element() < 0.000_51,
            "{point} {printed}"
        );
    }
}

#[test]
fn the_ported_rectangle() {
    let table = [
        (-0.441, -0.617, 0.652),
        (0.441, -0.617, 0.652),
        (0.459, 0.459, 0.760),
        (-0.459, 0.459, 0.760),
    ];
    check(RECTANGLE.map(port), table);
}

#[test]
fn rectangles_ported_then_translated_part_company() {
    let first = RECTANGLE.map(|p| translate(port(p), (0.5, 0.5)));
    let second = RECTANGLE.map(|p| translate(port(p), (1.5, 1.7)));
    let table = [
        (-0.014, -0.190, 0.982),
        (0.761, -0.296, 0.577),
        (0.698, 0.698, 0.156),
        (-0.110, 0.809, 0.578),
    ];
    check(first, table);
    let table = [
        (0.709, 0.686, 0.160),
        (0.957, -0.031, -0.287),
        (0.141, 0.099, -0.985),
        (-0.117, 0.847, -0.519),
    ];
    check(second, table);
    // Both touch (1, 1) in the plane.
    assert!((first[2] - second[0]).length() > 0.01);
}

#[test]
fn squares_translated_then_ported_change_their_sides() {
    let sides = |x: f64, y: f64| {
        let corners = [(x, y), (x + 0.5, y), (x + 0.5, y + 0.5), (x, y + 0.5)].map(port);
        [0, 1, 2, 3].map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % 4]);
            2.0 * (0.5 * (a - b).length()).asin()
        })
    };
    let tables = [
        (sides(0.0, 0.0), [0.500, 0.479, 0.479, 0.500]),
        (sides(0.5, 0.5), [0.480, 0.425, 0.425, 0.480]),
    ];
    for (ours, printed) in tables {
        for (a, b) in ours.into_iter().zip(printed) {
            assert!((a - b).abs() < 0.000_51, "{a} {b}");
        }
    }
}

#[test]
fn the_translation_is_an_isometry() {
    for sign in [-1.0, 1.0] {
        let to = DVec3::new(0.7, -0.4, 1.1);
        let columns = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| exponential_direction(sign, to, v));
        for (i, a) in columns.iter().enumerate() {
            for (j, b) in columns.iter().enumerate() {
                let expected = f64::from(u8::from(i == j));
                assert!((inner(sign, *a, *b) - expected).abs() < 1e-14);
            }
        }
    }
}
