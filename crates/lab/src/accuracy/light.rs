//! A light's direction: from the surface to the light at the surface, by chords.
//!
//! The error is that of its length under the inner product, which shades too bright or too dark.

use antipode_geometry::charts;
use antipode_geometry::kernel::distance;
use glam::{DVec3, DVec4, Vec4};

use super::distance::{HALF, name, pair};
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Worst};
use crate::naive;
use crate::random::Numbers;

/// Best known length of a direction.
const DIRECTION: f64 = 1e-7;

/// Directions of a light in single precision, in double rounded once, and by the textbook.
fn directions(sign: f64, [a, b]: [DVec4; 2]) -> [Vec4; 3] {
    let normal = normal_at(sign, a);
    let cast = distance::direction(sign, a.to_array(), b.to_array(), normal.to_array());
    let (a, b) = (a.as_vec4(), b.as_vec4());
    let sign = sign as f32;
    let single = distance::direction(
        sign,
        a.to_array(),
        b.to_array(),
        normal.as_vec4().to_array(),
    );
    [
        single.into(),
        DVec4::from_array(cast).as_vec4(),
        naive::direction(sign, a, b),
    ]
}

/// Notes lengths of directions in hyperbolic or spherical space.
pub fn measure(bench: &Bench, sign: f64, found: &mut Findings) {
    let mut curves = ["CPU f32, chord form", "CPU f64, then f32", "textbook f32"]
        .map(|name| Curve::new(name, 1e-8, 1.0));
    for (low, high) in [(1e-8, 1e-4), (1e-4, 1.0)] {
        let mut rng = Numbers::new(17);
        let mut worst = [(); 3].map(|()| Worst::default());
        for i in 0..bench.effort.count(50_000) {
            let separation = if i == 0 {
                0.0
            } else {
                rng.magnitude(low, high)
            };
            let points = pair(&mut rng, sign, separation, HALF);
            let errors = directions(sign, points).map(|v| Some(length_error(sign, v)));
            let at = || format!("a = {}, b = {}", points[0], points[1]);
            note_all(errors, &mut worst, &mut curves, separation, at);
        }
        let [single, cast, textbook] = worst;
        let subject = Subject {
            quantity: "length of a light's direction",
            range: format!("{}, separations {low:e} to {high:e}, and 0", name(sign)),
            unit: "of 1",
            naive: Some(textbook),
        };
        found.rows.extend(subject.rows([
            (Arithmetic::Single, Some(single), DIRECTION),
            (Arithmetic::Cast, Some(cast), DIRECTION),
        ]));
    }
    let title = format!(
        "Length of a light's direction, {}: error against separation",
        name(sign)
    );
    found.plots.push(plot(
        &format!("direction-{}", name(sign)),
        &title,
        "separation, radii",
        "worst error of the length",
        &curves,
    ));
}

/// A unit tangent at a, in the place of the surface's normal.
fn normal_at(sign: f64, a: DVec4) -> DVec4 {
    let q = a.truncate();
    let length = q.length();
    let distance = if sign < 0.0 {
        length.asinh()
    } else {
        length.atan2(a.w)
    };
    let q = q.normalize_or_zero() * distance;
    charts::exponential_direction(sign, q, DVec3::Y)
}

fn length_error(sign: f64, v: Vec4) -> f64 {
    let v = v.as_dvec4();
    ((v.truncate().length_squared() + sign * v.w * v.w).sqrt() - 1.0).abs()
}
