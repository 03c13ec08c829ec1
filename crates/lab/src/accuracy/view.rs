//! The raised map as seen: the camera near and far, and the camera that roams.
//!
//! Reference: the closed form in `f64`; that in turn is compared with chart and boost done one
//! after the other in double-double arithmetic. For the roaming camera the reference is the
//! direction that the point was put in.

use antipode_geometry::{ChartPoint, Eye};
use glam::{DVec3, DVec4, Mat4, Vec3};

use super::cases::{self, RADIUS_M, Setting, single_view};
use super::errors::{angle, words};
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::double_double::Double2;
use crate::error::LabError;
use crate::naive;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "A point is put at a distance from the camera in the chart, ported, and the angle between its direction in view coordinates and the exact one is taken. A pixel is about 1e-3 rad. The textbook ports in f32 and boosts back to the eye.",
    "The roaming camera walks D radii away from the origin and looks at a point one radius off. The textbook keeps camera and point as hyperboloid coordinates in f32. Ours subtracts the camera in the chart first, so that nothing grows.",
    "An exact answer rounded to f32 is off by up to 2^-24 = 5.96e-8 rad; that is the bar of what is computed in f64 and rounded once. What is computed in f32 is held to 6e-7 rad, the best figure known far from the origin.",
];

/// Runs near, far and roaming cameras.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    let mut curves = ["CPU f32", "CPU f64, then f32", "GPU", "textbook f32"]
        .map(|name| Curve::new(name, 1e-4, 20.0));
    for setting in [0.0, 0.5, 10.0, 20.0].map(cases::raised) {
        for range in [[1e-4, 1e-1], [1e-1, 3.0], [3.0, 20.0]] {
            near_and_far(bench, &setting, range, &mut curves, &mut found.rows)?;
        }
    }
    found.plots.push(plot(
        "view-raised",
        "Raised map, every dial: angle error against distance",
        "chart distance from the camera, radii",
        "worst error, rad",
        &curves,
    ));
    roaming(bench, &mut found)?;
    Ok(found)
}

fn near_and_far(
    bench: &Bench,
    setting: &Setting,
    [low, high]: [f64; 2],
    curves: &mut [Curve; 4],
    rows: &mut Vec<Row>,
) -> Result<(), LabError> {
    let mut rng = Numbers::new(7);
    let space = setting.space.as_ref();
    let eye = Eye {
        yaw: 0.3,
        pitch: -0.2,
        dial: setting.dial,
        ..Eye::default()
    };
    let points: Vec<DVec3> = (0..bench.effort.count(50_000))
        .map(|_| rng.direction() * rng.magnitude(low, high) * RADIUS_M)
        .map(|p| p.as_vec3().as_dvec3())
        .collect();
    let list: Vec<cases::Case> = points
        .iter()
        .map(|p| cases::case(space, &eye, ChartPoint::a(*p), DVec3::Y))
        .collect();
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let mut worst = [(); 4].map(|()| Worst::default());
    let mut double = Worst::default();
    for (i, (p, case)) in points.iter().zip(&list).enumerate() {
        let exact = space.view_point(&eye, ChartPoint::a(*p)).truncate();
        let textbook = textbook(&eye, setting.dial / RADIUS_M, *p);
        let errors = [
            Some(single_view(case).as_dvec4().truncate()),
            Some(exact.as_vec3().as_dvec3()),
            gpu.as_ref().map(|gpu| gpu[i].view.as_dvec4().truncate()),
            Some(textbook),
        ]
        .map(|ours| ours.map(|ours| angle(ours, exact)));
        let at = || format!("{} m", words(*p));
        note_all(errors, &mut worst, curves, p.length() / RADIUS_M, at);
        if i % 10 == 0 {
            double.note(angle(exact, port_then_boost(&eye, *p)), at);
        }
    }
    let [single, cast, shader, textbook] = worst;
    let subject = Subject {
        quantity: "view through the raised map",
        range: format!("{}, {low} to {high} radii from the camera", setting.name),
        unit: "rad",
        naive: Some(textbook),
    };
    rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), WALKED),
        (Arithmetic::Cast, Some(cast), ROUNDED),
        (Arithmetic::Gpu, gpu.is_some().then_some(shader), WALKED),
        (Arithmetic::Double, Some(double), 1e-14),
    ]));
    Ok(())
}

/// Best known angle error in single precision however far one has walked, in radians.
const WALKED: f64 = 6e-7;
/// Half an ulp of every coordinate: what is left when an exact answer is rounded to single.
const ROUNDED: f64 = 5.97e-8;

fn textbook(eye: &Eye, h: f64, p: DVec3) -> DVec3 {
    let x = naive::port_then_boost(h as f32, (p / RADIUS_M).as_vec3());
    eye.to_view(x.truncate().as_dvec3())
}

/// Chart and boost one after the other, with thirty digits, as a direction in view coordinates.
fn port_then_boost(eye: &Eye, p: DVec3) -> DVec3 {
    let radius = Double2::from(RADIUS_M);
    let h = Double2::from(eye.dial) / radius;
    let [x, y, z] = p.to_array().map(|x| Double2::from(x) / radius);
    let q = y + h;
    let d = (x * x + q * q + z * z).sqrt();
    let (sinh, cosh) = d.sinh_cosh();
    let across = sinh / d;
    let (sinh_h, cosh_h) = h.sinh_cosh();
    let up = cosh_h * (across * q) - sinh_h * cosh;
    let boosted = [across * x, up, across * z].map(Double2::to_f64);
    eye.to_view(DVec3::from_array(boosted))
}

/// The camera at D radii from the origin, a point one radius from the camera.
fn roaming(bench: &Bench, found: &mut Findings) -> Result<(), LabError> {
    let setting = cases::raised(0.0);
    let mut curves = [
        "CPU f32",
        "CPU f64, then f32",
        "GPU",
        "textbook f32",
        "textbook in f64",
    ]
    .map(|name| Curve::new(name, 0.1, 20.0));
    for (low, high) in [(0.1, 5.0), (5.0, 7.0), (7.0, 8.0), (8.0, 20.0)] {
        let mut rng = Numbers::new(11);
        let mut worst = [(); 5].map(|()| Worst::default());
        let mut list = Vec::new();
        let mut truths = Vec::new();
        for _ in 0..bench.effort.count(20_000) {
            let (d, away, v) = (rng.between(low, high), rng.direction(), rng.direction());
            let eye = Eye {
                point: ChartPoint::a((away * d * RADIUS_M).as_vec3().as_dvec3()),
                ..Eye::default()
            };
            let p = (v * RADIUS_M).as_vec3().as_dvec3();
            let point = ChartPoint::a(eye.point.pos + p);
            list.push(cases::case(setting.space.as_ref(), &eye, point, DVec3::Y));
            truths.push((d, away, v, eye, point));
        }
        let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
        for (i, (d, away, v, eye, point)) in truths.iter().enumerate() {
            let exact = setting.space.view_point(eye, *point).truncate();
            let errors = [
                Some(angle(single_view(&list[i]).as_dvec4().truncate(), exact)),
                Some(angle(exact.as_vec3().as_dvec3(), exact)),
                gpu.as_ref()
                    .map(|gpu| angle(gpu[i].view.as_dvec4().truncate(), exact)),
                Some(roamed(*away * *d, *v)),
                Some(roamed_f64(*away * *d, *v)),
            ];
            let at = || format!("D = {d:.4}, point towards {}", words(*v));
            note_all(errors, &mut worst, &mut curves, *d, at);
        }
        found
            .rows
            .extend(roaming_rows(low, high, worst, gpu.is_some()));
    }
    found.plots.push(plot(
        "view-roaming",
        "Roaming camera: angle error against distance walked",
        "distance from the origin, radii",
        "worst error, rad",
        &curves,
    ));
    Ok(())
}

fn roaming_rows(low: f64, high: f64, worst: [Worst; 5], ran: bool) -> [Row; 3] {
    let [single, cast, gpu, textbook, _] = worst;
    [
        (Arithmetic::Single, Some(single), WALKED),
        (Arithmetic::Cast, Some(cast), ROUNDED),
        (Arithmetic::Gpu, ran.then_some(gpu), WALKED),
    ]
    .map(|(arithmetic, ours, bar)| Row {
        quantity: "roaming hyperbolic camera",
        range: format!("{low} to {high} radii from the origin"),
        arithmetic,
        unit: "rad",
        ours,
        bar: Some(bar),
        naive: Some(textbook.clone()),
    })
}

/// The point one radius from a camera at q in direction v, on the hyperboloid.
fn put(q: DVec3, v: DVec3) -> (DVec4, DVec4) {
    let camera = antipode_geometry::charts::exponential(-1.0, q);
    let tangent = antipode_geometry::charts::exponential_direction(-1.0, q, v);
    (camera, camera * 1.0_f64.cosh() + tangent * 1.0_f64.sinh())
}

/// Hyperboloid coordinates in single precision, brought back by the inverse translation.
fn roamed(q: DVec3, v: DVec3) -> f64 {
    let (camera, point) = put(q, v);
    let back: Mat4 = naive::translation(-1.0, {
        let away = camera.as_vec4();
        (-away.truncate()).extend(away.w)
    });
    let seen: Vec3 = (back * point.as_vec4()).truncate();
    angle(seen.as_dvec3(), v)
}

/// The same in double precision.
fn roamed_f64(q: DVec3, v: DVec3) -> f64 {
    let (camera, point) = put(q, v);
    let c = camera.truncate();
    let along = (point.truncate().dot(c) / (1.0 + camera.w)) - point.w;
    angle(point.truncate() + c * along, v)
}
