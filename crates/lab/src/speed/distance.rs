//! What a distance costs and how true it is: from the inner product, which loses half of all digits when it is near
//! one, and from the chord, which loses none.

use antipode_geometry::charts::inner;
use antipode_geometry::kernel::distance;
use glam::{DVec3, DVec4, Vec4};

use crate::random::Numbers;
use crate::speed::pareto::{Contest, Group};
use crate::speed::port::BATCH;
use crate::{Effort, naive};

/// What the error is, and its unit.
const ERROR: (&str, &str) = ("worst error", "radii");

/// Two points of the model within a radius of the eye, and how far apart they were put, in radii.
#[derive(Clone, Copy, Debug)]
struct Pair {
    wide: (DVec4, DVec4),
    rounded: (Vec4, Vec4),
    apart: f64,
}

/// Points `apart` radii from each other, `sign` that of the curvature.
fn pairs(seed: u64, sign: f64) -> Vec<Pair> {
    let sine = |t: f64| if sign < 0.0 { t.sinh() } else { t.sin() };
    let cosine = |t: f64| if sign < 0.0 { t.cosh() } else { t.cos() };
    let mut numbers = Numbers::new(seed);
    (0..BATCH)
        .map(|_| {
            let (away, apart) = (numbers.between(0.0, 1.0), numbers.magnitude(1e-4, 1.0));
            let out = numbers.direction();
            let a = (out * sine(away)).extend(cosine(away));
            // The frame at a: along the ray, and across it.
            let v = numbers.direction();
            let along = v.dot(out);
            let across: DVec3 = v - out * along;
            let tangent =
                (across + out * (along * cosine(away))).extend(-sign * along * sine(away));
            let b = a * cosine(apart) + tangent * sine(apart);
            Pair {
                wide: (a, b),
                rounded: (a.as_vec4(), b.as_vec4()),
                apart,
            }
        })
        .collect()
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "rivals are judged by references"
)]
fn error(pair: &Pair, got: &f64) -> f64 {
    (got - pair.apart).abs()
}

fn half_chord(a: Vec4, b: Vec4) -> f32 {
    let e = b - a;
    0.5 * naive::inner(-1.0, e, e).max(0.0).sqrt()
}

/// In hyperbolic space.
pub fn hyperbolic_group(effort: Effort) -> Group {
    let inputs = pairs(31, -1.0);
    let rivals = Contest::new(&inputs, error)
        .with("acosh of the inner product, f32", "", |p| {
            f64::from(naive::distance(-1.0, p.rounded.0, p.rounded.1))
        })
        .with("acosh of the inner product, f64", "", |p| {
            (-inner(-1.0, p.wide.0, p.wide.1)).acosh()
        })
        .with("asinh of the chord, library, f32", "", |p| {
            f64::from(2.0 * half_chord(p.rounded.0, p.rounded.1).asinh())
        })
        .with("asinh of the chord, series, f32", "shaders", |p| {
            f64::from(distance::hyperbolic(
                p.rounded.0.to_array(),
                p.rounded.1.to_array(),
            ))
        })
        .with("asinh of the chord, f64", "processor", |p| {
            distance::hyperbolic(p.wide.0.to_array(), p.wide.1.to_array())
        });
    let title = "Distance of two points in hyperbolic space, 1e-4 to 1 radius apart";
    rivals.race("distance-hyperbolic", title, ERROR, effort)
}

/// On the sphere.
pub fn sphere_group(effort: Effort) -> Group {
    let inputs = pairs(32, 1.0);
    let rivals = Contest::new(&inputs, error)
        .with("acos of the inner product, f32", "", |p| {
            f64::from(naive::distance(1.0, p.rounded.0, p.rounded.1))
        })
        .with("acos of the inner product, f64", "", |p| {
            inner(1.0, p.wide.0, p.wide.1).acos()
        })
        .with("atan2 of the chords, library, f32", "", |p| {
            let (a, b) = p.rounded;
            f64::from(2.0 * (a - b).length().atan2((a + b).length()))
        })
        .with("atan2 of the chords, series, f32", "shaders", |p| {
            f64::from(distance::spherical(
                p.rounded.0.to_array(),
                p.rounded.1.to_array(),
            ))
        })
        .with("atan2 of the chords, f64", "processor", |p| {
            distance::spherical(p.wide.0.to_array(), p.wide.1.to_array())
        });
    let title = "Distance of two points on the sphere, 1e-4 to 1 radius apart";
    rivals.race("distance-sphere", title, ERROR, effort)
}
