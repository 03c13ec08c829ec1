//! Distances, directions and attenuation: the chord form, from touching to the far end.
//!
//! Inputs are `f32` vectors, whose spatial part is exact. The reference is the chord form, in `f64`:
//! `2 asinh(|b - a|/2)`, `2 atan2(|a - b|, |a + b|)`; for distances from the eye `asinh` and
//! `atan2` of the exact view vector.

use antipode_geometry::kernel::distance;
use antipode_geometry::{ChartPoint, Eye, charts};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4, Vec4};

use super::cases::{self, RADIUS_M, Setting};
use super::errors::relative;
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::double_double::Double2;
use crate::error::LabError;
use crate::random::Numbers;
use crate::{compute, naive, single};

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Distances between two points of the model at separations from 1e-8 to the far end, both near the camera, where positions are kept; the textbook takes acosh or acos of the inner product. Distances from the eye are those the shaders take for fog.",
    "A light's direction is that from the surface to the light at the surface: its error here is that of its length. At separation 0 there is none, and the surface normal takes its place.",
    "Attenuation is 1/(1 + 0.7 d + 1.8 d^2), d in radii, near 0 and near the antipode. Its error is at most twice that of the distance.",
];

/// Best known: the chord form for points 1e-3 apart.
const CHORD: f64 = 1.6e-7;
/// At any other separation and from the eye: three ulp.
const ANY: f64 = 3.6e-7;
/// Far from the camera, where angle and distances are combined: the figure for angles.
const FAR: f64 = 6e-7;

/// Best known length of a direction, 1e-7 to its one digit.
const DIRECTION: f64 = 1.5e-7;

/// Positions are within half a radius of the camera.
const HALF: f64 = 0.5;

/// Runs distances between points, from the eye, directions and attenuation.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    far_apart(bench, &mut found);
    for sign in [-1.0, 1.0] {
        between(bench, sign, &mut found);
        in_double(bench, sign, &mut found);
        from_eye(bench, sign, &mut found)?;
        directions(bench, sign, &mut found);
    }
    Ok(found)
}

fn name(sign: f64) -> &'static str {
    if sign < 0.0 {
        "hyperbolic"
    } else {
        "spherical"
    }
}

/// Two points of the model at a separation, the first within some radii of the camera.
fn pair(rng: &mut Numbers, sign: f64, separation: f64, within: f64) -> [Vec4; 2] {
    let q = rng.direction() * rng.between(0.0, within);
    let a = charts::exponential(sign, q);
    let v = charts::exponential_direction(sign, q, rng.direction());
    let half = charts::exponential(sign, DVec3::X * separation);
    let b = a * half.w + v * half.x;
    [a.as_vec4(), b.as_vec4()]
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

/// Worst errors of ours and of the textbook's.
type Both = [Worst; 2];

fn between(bench: &Bench, sign: f64, found: &mut Findings) {
    let mut rng = Numbers::new(3);
    let [mut all, mut near, mut light] = [(); 3].map(|()| Both::default());
    let mut curves =
        ["CPU f32, chord form", "textbook f32"].map(|name| Curve::new(name, 1e-8, far_end(sign)));
    for i in 0..bench.effort.count(100_000) {
        let separation = if i % 4 == 0 && sign > 0.0 {
            far_end(sign) - rng.magnitude(1e-7, 1.0)
        } else {
            rng.magnitude(1e-8, far_end(sign))
        };
        // Roundings of positions must not be larger than what lies between them.
        let within = (1e3 * separation).min(HALF);
        let [a, b] = pair(&mut rng, sign, separation, within);
        let exact = chord(sign, on_model(sign, a), on_model(sign, b));
        if exact == 0.0 {
            continue;
        }
        let words = || format!("a = {a}, b = {b}");
        let distances = [
            single_distance(sign, a, b),
            naive::distance(sign as f32, a, b),
        ];
        for (k, d) in distances.into_iter().enumerate() {
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
    let range = format!("{}, separations 1e-8 to {:.2}", name(sign), far_end(sign));
    let thousandth = format!("{}, separations of 1e-3", name(sign));
    let ends = format!("{}, near 0 to the far end", name(sign));
    found.rows.extend([
        row("distance of two points", range, all, ANY),
        row("distance of two points", thousandth, near, CHORD),
        row("attenuation of a light", ends, light, 2.0 * ANY),
    ]);
    found.plots.push(plot(
        &format!("distance-{}", name(sign)),
        &format!(
            "Distance of two {} points: error against distance",
            name(sign)
        ),
        "distance, radii",
        "worst relative error",
        &curves,
    ));
}

fn row(quantity: &'static str, range: String, [ours, textbook]: Both, bar: f64) -> Row {
    Row {
        quantity,
        range,
        arithmetic: Arithmetic::Single,
        unit: "of it",
        ours: Some(ours),
        bar: Some(bar),
        naive: Some(textbook),
    }
}

/// Two hyperbolic points anywhere that is drawn, from angle and distances, against `f64`.
fn far_apart(bench: &Bench, found: &mut Findings) {
    let mut rng = Numbers::new(19);
    let mut both = Both::default();
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
    found
        .rows
        .push(row("distance of two points", range, both, FAR));
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

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Seen {
    space: antipode_geometry::SpaceUniform,
    view: Vec4,
}

/// View vectors at distances from 1e-8 to `far` radii.
fn seen(bench: &Bench, sign: f64, far: f64, setting: &Setting) -> Vec<Seen> {
    let space = setting.space.uniform(&Eye::default(), &cases::projection());
    let mut rng = Numbers::new(13);
    (0..bench.effort.count(100_000))
        .map(|_| {
            let end = charts::exponential(sign, DVec3::X * rng.magnitude(1e-8, far));
            let view = (rng.direction() * end.x * RADIUS_M).extend(end.w).as_vec4();
            Seen { space, view }
        })
        .collect()
}

/// The shader's distances, where there is an adapter.
fn on_gpu(bench: &Bench, inputs: &[Seen]) -> Result<Option<Vec<f32>>, LabError> {
    let shader = compute::shader(
        "struct Seen { space: Space, view: vec4<f32> }",
        "Seen",
        "f32",
        "outputs[i] = eye_distance(inputs[i].space, inputs[i].view);",
    );
    let gpu = bench.gpu.as_ref();
    gpu.map(|gpu| compute::run(gpu, &shader, inputs))
        .transpose()
}

/// The distance that fog is made of.
fn from_eye(bench: &Bench, sign: f64, found: &mut Findings) -> Result<(), LabError> {
    let setting = if sign < 0.0 {
        cases::raised(10.0)
    } else {
        cases::sphere(RADIUS_M)
    };
    let far = if sign < 0.0 {
        20.0
    } else {
        std::f64::consts::PI - 1e-3
    };
    let inputs = seen(bench, sign, far, &setting);
    let gpu = on_gpu(bench, &inputs)?;
    let mut worst = [(); 3].map(|()| Worst::default());
    let mut curves = ["CPU f32", "GPU", "textbook f32"].map(|name| Curve::new(name, 1e-8, far));
    let radius = RADIUS_M as f32;
    for (i, input) in inputs.iter().enumerate() {
        let (view, eye) = (input.view, Eye::default());
        let exact = setting.space.eye_distance_m(&eye, view.as_dvec4());
        let textbook = if sign < 0.0 {
            view.w.acosh()
        } else {
            view.w.acos()
        } * radius;
        let errors = [
            Some(distance::from_eye(
                sign as f32,
                1.0 / radius,
                radius,
                view.to_array(),
            )),
            gpu.as_ref().map(|gpu| gpu[i]),
            Some(textbook),
        ]
        .map(|ours| ours.map(|ours| relative(f64::from(ours), exact)));
        let at = || format!("view {view}");
        note_all(errors, &mut worst, &mut curves, exact / RADIUS_M, at);
    }
    let [single, shader, textbook] = worst;
    let subject = Subject {
        quantity: "distance from the eye",
        range: format!("{}, 1e-8 to {far:.4} radii", name(sign)),
        unit: "of it",
        naive: Some(textbook),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), ANY),
        (Arithmetic::Gpu, gpu.is_some().then_some(shader), ANY),
    ]));
    found.plots.push(plot(
        &format!("eye-distance-{}", name(sign)),
        &format!(
            "Distance from the eye, {}: error against distance",
            name(sign)
        ),
        "distance, radii",
        "worst relative error",
        &curves,
    ));
    Ok(())
}

fn directions(bench: &Bench, sign: f64, found: &mut Findings) {
    let mut curves =
        ["CPU f32, chord form", "textbook f32"].map(|name| Curve::new(name, 1e-8, 1.0));
    for (low, high) in [(1e-8, 1e-4), (1e-4, 1.0)] {
        let mut rng = Numbers::new(17);
        let (mut ours, mut textbook) = (Worst::default(), Worst::default());
        for i in 0..bench.effort.count(50_000) {
            let separation = if i == 0 {
                0.0
            } else {
                rng.magnitude(low, high)
            };
            let [a, b] = pair(&mut rng, sign, separation, HALF);
            let words = || format!("a = {a}, b = {b}");
            let normal = normal_at(sign as f32, a);
            let made = distance::direction(sign as f32, a.to_array(), b.to_array(), normal);
            let error = length_error(sign, Vec4::from_array(made));
            ours.note(error, words);
            let error_textbook = length_error(sign, naive::direction(sign as f32, a, b));
            textbook.note(error_textbook, words);
            curves[0].note(separation, error);
            curves[1].note(separation, error_textbook);
        }
        found.rows.push(Row {
            quantity: "length of a light's direction",
            range: format!("{}, separations {low:e} to {high:e}, and 0", name(sign)),
            arithmetic: Arithmetic::Single,
            unit: "of 1",
            ours: Some(ours),
            bar: Some(DIRECTION),
            naive: Some(textbook),
        });
    }
    found.plots.push(plot(
        &format!("direction-{}", name(sign)),
        &format!(
            "Length of a light's direction, {}: error against separation",
            name(sign)
        ),
        "separation, radii",
        "worst error of the length",
        &curves,
    ));
}

/// A unit tangent at a, in the place of the surface's normal.
fn normal_at(sign: f32, a: Vec4) -> [f32; 4] {
    let q = a.truncate().as_dvec3();
    let length = q.length();
    let distance = if sign < 0.0 {
        length.asinh()
    } else {
        length.atan2(a.w.into())
    };
    let q = q.normalize_or_zero() * distance;
    charts::exponential_direction(sign.into(), q, DVec3::Y)
        .as_vec4()
        .to_array()
}

fn length_error(sign: f64, v: Vec4) -> f64 {
    let v = v.as_dvec4();
    ((v.truncate().length_squared() + sign * v.w * v.w).sqrt() - 1.0).abs()
}
