//! Isometries: translations at both ends of the space, and cameras moved a hundred thousand times.
//!
//! A matrix M is off orthogonal by the greatest entry of `M^T J M - J`, J the metric of the model,
//! computed in `f64`. An exact isometry is off by 0, so this is the whole error.

use antipode_geometry::kernel::{frame, translation};
use antipode_geometry::{ChartPoint, Eye, Geometry, charts, strategy};
use glam::{DMat4, DVec3, DVec4, Mat4, Vec3};

use super::cases;
use super::distance::name;
use super::errors::words;
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::naive;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "A translation takes the origin to a point of the space. The textbook builds it with 1/(1 + w), which has no answer at the antipode; ours is made of half angles, in f32 and in f64 rounded once.",
    "A camera is moved step by step by small turns and translations, composed in f32. The textbook multiplies on; with Gram-Schmidt under the model's inner product after each step, in f32 or in f64 rounded once, the error stays where it was. The game does neither: it keeps the camera as a chart point and three angles, and makes the matrix anew for each frame.",
    "Out and back: the camera walks away in a thousand steps and returns by their inverses; what is left is the distance from where it began.",
];

/// Runs translations and moves.
#[expect(clippy::unnecessary_wraps, reason = "every suite has this signature")]
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    translations(bench, &mut found);
    views(bench, &mut found);
    for sign in [-1.0, 1.0] {
        composed(bench, sign, &mut found);
        out_and_back(bench, sign, &mut found);
    }
    Ok(found)
}

/// How far a matrix is off orthogonal; no number where one of its entries is none.
pub(crate) fn off_orthogonal(sign: f64, m: Mat4) -> f64 {
    let metric = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, sign));
    let m = m.as_dmat4();
    let off = m.transpose() * metric * m - metric;
    // NaN in any entry must not be lost, as `max` would.
    if !off.is_finite() {
        return f64::NAN;
    }
    off.to_cols_array()
        .into_iter()
        .fold(0.0, |most, x| most.max(x.abs()))
}

/// The translation by q from half angles, in `f64`.
fn translated(sign: f64, q: DVec3) -> DMat4 {
    DMat4::from_cols_array_2d(&translation::translation(sign, q.to_array()))
}

/// Best known: the half-angle form on S3.
const HALF_ANGLE: f64 = 8e-7;

fn translations(bench: &Bench, found: &mut Findings) {
    let pi = std::f64::consts::PI;
    let mut curves = [
        "half angles, CPU f32",
        "half angles, CPU f64",
        "textbook f32",
    ]
    .map(|name| Curve::new(name, 1e-6, pi));
    for (name, low, high) in [
        ("near the origin", 1e-8, 1e-2),
        ("in between", 1e-2, pi - 1e-2),
    ] {
        let mut worst = [(); 3].map(|()| Worst::default());
        let mut rng = Numbers::new(37);
        for _ in 0..bench.effort.count(20_000) {
            let q = rng.direction() * rng.magnitude(low, high);
            note_translation(1.0, q, &mut worst, &mut curves);
        }
        push_translation("spherical", name, worst, found);
    }
    for from_antipode in [1e-3, 1e-4, 1e-6, 0.0] {
        let mut worst = [(); 3].map(|()| Worst::default());
        let mut rng = Numbers::new(41);
        for _ in 0..bench.effort.count(2_000) {
            let q = rng.direction() * (pi - from_antipode);
            note_translation(1.0, q, &mut worst, &mut curves);
        }
        let range = format!("{from_antipode:e} radii from the antipode");
        push_translation("spherical", &range, worst, found);
    }
    let mut worst = [(); 3].map(|()| Worst::default());
    let mut rng = Numbers::new(43);
    for _ in 0..bench.effort.count(20_000) {
        let q = rng.direction() * rng.magnitude(1e-8, 1.0);
        let mut none = ["", "", ""].map(|name| Curve::new(name, 1.0, 2.0));
        note_translation(-1.0, q, &mut worst, &mut none);
    }
    push_translation("hyperbolic", "to 1 radius", worst, found);
    found.plots.push(plot(
        "translations",
        "Translations of the sphere: off orthogonal against distance from the antipode",
        "distance from the antipode, radii",
        "greatest entry off",
        &curves,
    ));
}

fn note_translation(sign: f64, q: DVec3, worst: &mut [Worst; 3], curves: &mut [Curve; 3]) {
    let ported = charts::exponential(sign, q).as_vec4();
    let half = translation::translation(sign as f32, q.as_vec3().to_array());
    let errors = [
        off_orthogonal(sign, Mat4::from_cols_array_2d(&half)),
        off_orthogonal(sign, translated(sign, q).as_mat4()),
        off_orthogonal(sign, naive::translation(sign as f32, ported)),
    ];
    let from_antipode = std::f64::consts::PI - q.length();
    let at = || format!("q = {}", words(q));
    note_all(errors.map(Some), worst, curves, from_antipode, at);
}

fn push_translation(space: &str, range: &str, worst: [Worst; 3], found: &mut Findings) {
    let [single, cast, textbook] = worst;
    for (arithmetic, ours) in [(Arithmetic::Single, single), (Arithmetic::Cast, cast)] {
        found.rows.push(Row {
            quantity: "translation matrix off orthogonal",
            range: format!("{space}, {range}"),
            arithmetic,
            unit: "",
            ours: Some(ours),
            bar: Some(HALF_ANGLE),
            naive: Some(textbook.clone()),
        });
    }
}

/// The very matrices that the shaders are given, from eyes anywhere.
fn views(bench: &Bench, found: &mut Findings) {
    for (geometry, radius) in [(Geometry::Hyperbolic, 20.0), (Geometry::Spherical, 32.0)] {
        let space = strategy(geometry, radius);
        let mut rng = Numbers::new(47);
        let mut worst = Worst::default();
        for _ in 0..bench.effort.count(20_000) {
            let level = rng.turn() * rng.between(0.0, 1.57) * radius;
            let eye = Eye {
                point: ChartPoint::a(DVec3::new(level.x, rng.between(0.1, 1.2) * radius, level.y)),
                yaw: rng.between(-3.2, 3.2),
                pitch: rng.between(-1.5, 1.5),
                dial: rng.between(0.0, 20.0),
                ..Eye::default()
            };
            let view = Mat4::from_cols_array_2d(&space.uniform(&eye, &cases::projection()).view);
            // Back from metres to radii, where the space is a unit sphere.
            let metres = DVec4::new(radius, radius, radius, 1.0);
            let unit = DMat4::from_diagonal(metres.recip())
                * view.as_dmat4()
                * DMat4::from_diagonal(metres);
            worst.note(
                off_orthogonal(space.curvature().sign, unit.as_mat4()),
                || format!("{eye:?}"),
            );
        }
        found.rows.push(Row {
            quantity: "view matrix off orthogonal",
            range: format!("{geometry}, eyes anywhere and however far they walked"),
            arithmetic: Arithmetic::Cast,
            unit: "",
            ours: Some(worst),
            bar: Some(HALF_ANGLE),
            naive: None,
        });
    }
}

/// A small step: a turn about the upright and a translation, in single precision.
fn step(sign: f64, rng: &mut Numbers) -> Mat4 {
    let q = rng.direction() * rng.between(0.0, 0.02);
    let turn = Mat4::from_axis_angle(Vec3::Y, rng.between(-0.05, 0.05) as f32);
    translated(sign, q).as_mat4() * turn
}

/// Gram-Schmidt under the model's inner product, in single precision.
fn orthonormal(sign: f64, m: Mat4) -> Mat4 {
    Mat4::from_cols_array_2d(&frame::orthonormalized(sign as f32, m.to_cols_array_2d()))
}

/// The same in double precision, rounded once.
fn orthonormal_cast(sign: f64, m: Mat4) -> Mat4 {
    let columns = m.as_dmat4().to_cols_array_2d();
    DMat4::from_cols_array_2d(&frame::orthonormalized(sign, columns)).as_mat4()
}

/// Best known: Gram-Schmidt each step.
const COMPOSED: f64 = 2e-7;

/// The random walk is led back so that it stays within two radii: what is measured is drift, not
/// the growth of hyperboloid coordinates.
fn homeward(sign: f64, m: Mat4, step: Mat4) -> Mat4 {
    let moved = m * step;
    if sign < 0.0 && moved.w_axis.w > 1.2 {
        return m * step.inverse();
    }
    moved
}

fn composed(bench: &Bench, sign: f64, found: &mut Findings) {
    let moves = bench.effort.count(100_000);
    let mut rng = Numbers::new(53);
    let mut worst = [(); 3].map(|()| Worst::default());
    let mut curves = [
        "Gram-Schmidt, CPU f32",
        "Gram-Schmidt, CPU f64",
        "textbook f32",
    ]
    .map(|name| Curve::new(name, 1.0, 1e5));
    let mut cameras = [Mat4::IDENTITY; 3];
    for i in 1..=moves {
        let step = step(sign, &mut rng);
        let [a, b, c] = cameras.map(|m| homeward(sign, m, step));
        cameras = [orthonormal(sign, a), orthonormal_cast(sign, b), c];
        if i % 50 == 0 || i == moves {
            let errors = cameras.map(|m| Some(off_orthogonal(sign, m)));
            let at = || format!("after {i} moves");
            note_all(errors, &mut worst, &mut curves, i as f64, at);
        }
    }
    let space = name(sign);
    let [single, cast, textbook] = worst;
    let subject = Subject {
        quantity: "composed camera moves, off orthogonal",
        range: format!("{space}, {moves} moves"),
        unit: "",
        naive: Some(textbook),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), COMPOSED),
        (Arithmetic::Cast, Some(cast), COMPOSED),
    ]));
    found.plots.push(plot(
        &format!("moves-{space}"),
        &format!("Composed camera moves, {space}: off orthogonal against their number"),
        "moves",
        "greatest entry off",
        &curves,
    ));
}

/// A thousand steps out along one line, and the same steps back; and the game's own camera.
fn out_and_back(bench: &Bench, sign: f64, found: &mut Findings) {
    let (mut ours, mut textbook) = (Worst::default(), Worst::default());
    let mut rng = Numbers::new(59);
    let radius = 20.0;
    for _ in 0..bench.effort.count(200) {
        let away = rng.direction();
        let stride = translated(sign, away * 0.008).as_mat4();
        let back = translated(sign, away * -0.008).as_mat4();
        let mut m = Mat4::IDENTITY;
        let mut eye = ChartPoint::a(DVec3::ZERO);
        let metres = away * 0.008 * radius;
        for i in 0..2000 {
            m *= if i < 1000 { stride } else { back };
            eye = eye.moved(if i < 1000 { metres } else { -metres });
        }
        let left = f64::from(m.w_axis.truncate().length());
        textbook.note(left, || words(away));
        ours.note(eye.pos.length() / radius, || words(away));
    }
    let space = name(sign);
    found.rows.push(Row {
        quantity: "out and back, distance left",
        range: format!("{space}, 1000 steps to 8 radii"),
        arithmetic: Arithmetic::Double,
        unit: "radii",
        ours: Some(ours),
        bar: Some(COMPOSED),
        naive: Some(textbook),
    });
}
