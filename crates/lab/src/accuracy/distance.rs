//! Distances, directions and attenuation: the chord form, from touching to the far end.
//!
//! Inputs are `f32` vectors, whose spatial part is exact. The reference is the chord form, in `f64`:
//! `2 asinh(|b - a|/2)`, `2 atan2(|a - b|, |a + b|)`; for distances from the eye `asinh` and
//! `atan2` of the exact view vector.

use antipode_geometry::kernel::distance;
use antipode_geometry::{ChartPoint, Eye, charts};
use glam::{DVec3, DVec4, Vec4};

use super::cases;
use super::errors::relative;
use super::row::{Curve, Subject, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst, eye_distance, light};
use crate::double_double::Double2;
use crate::error::LabError;
use crate::random::Numbers;
use crate::{naive, single};

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Distances between two points of the model at separations from 1e-8 to the far end, both near the camera, where positions are kept; the textbook takes acosh or acos of the inner product. Distances from the eye are those the shaders take for fog.",
    "A light's direction is that from the surface to the light at the surface: its error here is that of its length, in pure f32 and as the game computes, in f64 from positions in f64 and rounded once. At separation 0 there is none, and the surface normal takes its place.",
    "Attenuation is 1/(1 + 0.7 d + 1.8 d^2), d in radii, near 0 and near the antipode. Its error is at most twice that of the distance.",
];

/// Best known: the chord form for points 1e-3 apart.
const CHORD: f64 = 1.6e-7;
/// At any other separation and from the eye: three ulp.
pub const ANY: f64 = 3.6e-7;
/// Far from the camera, where angle and distances are combined: the figure for angles.
const FAR: f64 = 6e-7;

/// Positions are within half a radius of the camera.
pub const HALF: f64 = 0.5;

/// Runs distances between points, from the eye, directions and attenuation.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    far_apart(bench, &mut found);
    for sign in [-1.0, 1.0] {
        between(bench, sign, &mut found);
        in_double(bench, sign, &mut found);
        eye_distance::measure(bench, sign, &mut found)?;
        light::measure(bench, sign, &mut found);
    }
    Ok(found)
}

/// The space's name by the sign of its curvature.
pub fn name(sign: f64) -> &'static str {
    if sign < 0.0 {
        "hyperbolic"
    } else {
        "spherical"
    }
}

/// Two points of the model at a separation, the first within some radii of the camera.
pub fn pair(rng: &mut Numbers, sign: f64, separation: f64, within: f64) -> [DVec4; 2] {
    let q = rng.direction() * rng.between(0.0, within);
    let a = charts::exponential(sign, q);
    let v = charts::exponential_direction(sign, q, rng.direction());
    let half = charts::exponential(sign, DVec3::X * separation);
    let b = a * half.w + v * half.x;
    [a, b]
}

fn chord(sign: f64, a: DVec4, b: DVec4) -> f64 {
    let e = b - a;
    if sign < 0.0 {
        let q = e.truncate().length_squared() - e.w * e.w;
        2.0 * (0.5 * q.max(0.0).sqrt()).asinh()
    } else {
        2.0 * e.length().atan2((a + b).length())
    }
}

/// The point of the model that rounded coordinates stand for: where w is large it follows from the
/// others, which say more; near the sphere's equator all four are made a unit vector.
fn on_model(sign: f64, a: Vec4) -> DVec4 {
    let a = a.as_dvec4();
    if sign > 0.0 && a.w < std::f64::consts::FRAC_1_SQRT_2 {
        return a.normalize();
    }
    let v = a.truncate();
    v.extend((1.0 - sign * v.length_squared()).sqrt())
}

fn far_end(sign: f64) -> f64 {
    if sign < 0.0 {
        1.0
    } else {
        std::f64::consts::PI
    }
}

fn single_distance(sign: f64, a: Vec4, b: Vec4) -> f32 {
    if sign < 0.0 {
        single::hyperbolic_distance(a, b)
    } else {
        single::sphere_distance(a, b)
    }
}

fn attenuation(d: f64) -> f64 {
    1.0 / (1.0 + d * (0.7 + 1.8 * d))
}

fn attenuation_single(d: f32) -> f32 {
    1.0 / (1.0 + d * (0.7 + 1.8 * d))
}

/// Worst errors of ours in single precision, of ours in double rounded once, and of the textbook's.
type Three = [Worst; 3];

/// Distances of two points given in single precision by each of the three.
fn distances(sign: f64, single: [Vec4; 2], double: [DVec4; 2]) -> [f32; 3] {
    let [a, b] = double.map(|point| point.to_array());
    let cast = if sign < 0.0 {
        distance::hyperbolic(a, b)
    } else {
        distance::spherical(a, b)
    };
    let [a, b] = single;
    [
        single_distance(sign, a, b),
        cast as f32,
        naive::distance(sign as f32, a, b),
    ]
}

fn between(bench: &Bench, sign: f64, found: &mut Findings) {
    let mut rng = Numbers::new(3);
    let [mut all, mut near, mut light] = [(); 3].map(|()| Three::default());
    let mut curves = ["CPU f32, chord form", "CPU f64, then f32", "textbook f32"]
        .map(|name| Curve::new(name, 1e-8, far_end(sign)));
    for i in 0..bench.effort.count(100_000) {
        let separation = if i % 4 == 0 && sign > 0.0 {
            far_end(sign) - rng.magnitude(1e-7, 1.0)
        } else {
            rng.magnitude(1e-8, far_end(sign))
        };
        // Roundings of positions must not be larger than what lies between them.
        let within = (1e3 * separation).min(HALF);
        let single = pair(&mut rng, sign, separation, within).map(DVec4::as_vec4);
        let double = single.map(|point| on_model(sign, point));
        let exact = chord(sign, double[0], double[1]);
        if exact == 0.0 {
            continue;
        }
        let words = || format!("a = {}, b = {}", single[0], single[1]);
        for (k, d) in distances(sign, single, double).into_iter().enumerate() {
            let error = relative(f64::from(d), exact);
            all[k].note(error, words);
            if (exact - 1e-3).abs() < 2e-4 {
                near[k].note(error, words);
            }
            curves[k].note(exact, error);
            let less = relative(f64::from(attenuation_single(d)), attenuation(exact));
            light[k].note(less, words);
        }
    }
    push_between(sign, [all, near, light], found);
    let title = format!(
        "Distance of two {} points: error against distance",
        name(sign)
    );
    found.plots.push(plot(
        &format!("distance-{}", name(sign)),
        &title,
        "distance, radii",
        "worst relative error",
        &curves,
    ));
}

fn push_between(sign: f64, [all, near, light]: [Three; 3], found: &mut Findings) {
    let name = name(sign);
    let range = format!("{name}, separations 1e-8 to {:.2}", far_end(sign));
    for (quantity, range, [single, cast, textbook], bar) in [
        ("distance of two points", range, all, ANY),
        (
            "distance of two points",
            format!("{name}, separations of 1e-3"),
            near,
            CHORD,
        ),
        (
            "attenuation of a light",
            format!("{name}, near 0 to the far end"),
            light,
            2.0 * ANY,
        ),
    ] {
        let subject = Subject {
            quantity,
            range,
            unit: "of it",
            naive: Some(textbook),
        };
        found.rows.extend(subject.rows([
            (Arithmetic::Single, Some(single), bar),
            (Arithmetic::Cast, Some(cast), bar),
        ]));
    }
}

/// Two hyperbolic points anywhere that is drawn, from angle and distances, against `f64`.
fn far_apart(bench: &Bench, found: &mut Findings) {
    let mut rng = Numbers::new(19);
    let mut both = [(); 2].map(|()| Worst::default());
    for _ in 0..bench.effort.count(20_000) {
        let [a, b] = [(); 2].map(|()| {
            let q = rng.direction() * rng.between(0.5, 20.0);
            charts::exponential(-1.0, q).as_vec4()
        });
        let exact = distance::hyperbolic_far(
            a.as_dvec4().truncate().to_array(),
            b.as_dvec4().truncate().to_array(),
        );
        let ours = distance::hyperbolic_far(a.truncate().to_array(), b.truncate().to_array());
        let words = || format!("a = {a}, b = {b}");
        both[0].note(relative(f64::from(ours), exact), words);
        both[1].note(
            relative(f64::from(naive::distance(-1.0, a, b)), exact),
            words,
        );
    }
    let range = "hyperbolic, both up to 20 radii from the camera".to_owned();
    let [ours, textbook] = both;
    found.rows.push(Row {
        quantity: "distance of two points",
        range,
        arithmetic: Arithmetic::Single,
        unit: "of it",
        ours: Some(ours),
        bar: Some(FAR),
        naive: Some(textbook),
    });
}

/// The strategy's own distance in `f64` against the chord form with thirty digits.
fn in_double(bench: &Bench, sign: f64, found: &mut Findings) {
    let mut rng = Numbers::new(5);
    let setting = if sign < 0.0 {
        cases::raised(10.0)
    } else {
        cases::sphere(32.0)
    };
    let eye = Eye {
        dial: setting.dial,
        ..Eye::default()
    };
    let radius = setting.space.radius_m();
    let mut worst = Worst::default();
    for _ in 0..bench.effort.count(5_000) {
        let a = rng.direction() * rng.between(0.0, 1.1) * radius;
        let b = a + rng.direction() * rng.magnitude(1e-8, 1.0) * radius;
        let ours = setting
            .space
            .distance_m(ChartPoint::a(a), ChartPoint::a(b), &eye);
        let [x, y] = [a, b].map(|p| better(sign, p, setting.dial, radius));
        let exact = better_chord(sign, x, y).to_f64() * radius;
        // The distance between the roundings of the two chart points cannot be known better.
        let scale = exact + 1e-16 * radius;
        worst.note((ours - exact).abs() / scale, || format!("{a} m and {b} m"));
    }
    found.rows.push(Row {
        quantity: "distance of two points",
        range: format!("{}, separations 1e-8 to 1 radius", setting.name),
        arithmetic: Arithmetic::Double,
        unit: "of it",
        ours: Some(worst),
        bar: Some(CHORD),
        naive: None,
    });
}

fn better(sign: f64, p: DVec3, dial: f64, radius: f64) -> [Double2; 4] {
    let radius = Double2::from(radius);
    let [x, y, z] = p.to_array().map(|x| Double2::from(x) / radius);
    if sign > 0.0 {
        let r = (x * x + z * z).sqrt();
        let ((sin_r, cos_r), (sin_y, cos_y)) = (r.sin_cos(), y.sin_cos());
        let across = cos_y * sin_r / r;
        return [across * x, sin_y, across * z, cos_y * cos_r];
    }
    let y = y + Double2::from(dial) / radius;
    let d = (x * x + y * y + z * z).sqrt();
    let (sinh, cosh) = d.sinh_cosh();
    let across = sinh / d;
    [across * x, across * y, across * z, cosh]
}

fn better_chord(sign: f64, a: [Double2; 4], b: [Double2; 4]) -> Double2 {
    let square = |with: fn(Double2, Double2) -> Double2, sign: f64| {
        let v = [0, 1, 2, 3].map(|i| with(a[i], b[i]));
        v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + Double2::from(sign) * v[3] * v[3]
    };
    let (two, half) = (Double2::from(2.0), Double2::from(0.5));
    let chord = square(|a, b| a - b, sign).sqrt();
    if sign < 0.0 {
        two * (chord * half).asinh()
    } else {
        two * chord.atan2(square(|a, b| a + b, 1.0).sqrt())
    }
}
