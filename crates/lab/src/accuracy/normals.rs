//! Normals: covectors carried exactly, against normals carried like directions.
//!
//! The reference splits the normal by its definition into the part along the chart's ray and the
//! parts across it, and divides each by the stretch of its axis, in `f64`. No series is involved.

use antipode_geometry::kernel::exponential;
use antipode_geometry::{ChartId, ChartPoint, Eye, charts};
use glam::DVec3;

use super::cases::{self, RADIUS_M, Setting};
use super::errors::{angle, words};
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Worst};
use crate::error::LabError;
use crate::random::Numbers;
use crate::{naive, single};

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "The angle between the normal of the port and the exact one. Far off in hyperbolic space the part of a normal across the ray shrinks by sinh(d)/d, so that a normal nearly across it turns by that much more than its inputs do; the error is divided by what a rounding of the inputs is multiplied by.",
    "The textbook carries the normal along like a direction. Its error is one of the model, not of the arithmetic; at d = 1, 2 and 3 it is given for the worst normal, ours there without any division.",
    "Darkening is what is lost when a hyperbolic normal of four components is made a unit vector by its Euclidean length, as shaders do by habit.",
];

/// Best known error of an angle in single precision, in radians.
const SINGLE: f64 = 6e-7;

/// Runs the exact normals, the model's error and the darkening.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for (setting, chart) in [
        (cases::raised(0.0), ChartId::FIRST),
        (cases::raised(10.0), ChartId::FIRST),
        (cases::raised(20.0), ChartId::FIRST),
        (cases::sphere(32.0), ChartId::FIRST),
        (cases::sphere(32.0), ChartId::SECOND),
    ] {
        exact(bench, &setting, chart, &mut found)?;
    }
    for d in [1.0, 2.0, 3.0] {
        model(bench, d, &mut found)?;
    }
    Ok(found)
}

/// The normal by its definition, and what a rounding is multiplied by in it. `q` is in radii from
/// the chart's centre.
fn by_definition(hyperbolic: bool, q: DVec3, n: DVec3) -> (DVec3, f64) {
    if hyperbolic {
        let d = q.length();
        let ray = q / d;
        let stretch = d.sinh() / d;
        let along = n.dot(ray);
        let across = (n - ray * along) / stretch;
        let condition = 1.0 / along.hypot(1.0 / stretch);
        return ((ray * along + across).normalize(), condition);
    }
    let r = q.x.hypot(q.z);
    let ray = DVec3::new(q.x, 0.0, q.z) / r;
    let aside = DVec3::new(-ray.z, 0.0, ray.x);
    let (level, side) = (q.y.cos(), q.y.cos() * r.sin() / r);
    let ported = ray * (n.dot(ray) / level) + aside * (n.dot(aside) / side) + DVec3::Y * n.y;
    (ported.normalize(), 1.0)
}

/// Chart point in metres and in radii from the chart's centre.
fn place(rng: &mut Numbers, setting: &Setting) -> (DVec3, DVec3) {
    let radius = setting.space.radius_m();
    if setting.space.is_closed() {
        let level = rng.turn() * rng.magnitude(1e-3, 1.5);
        let q = DVec3::new(level.x, rng.between(0.1, 1.2), level.y);
        return (q * radius, q);
    }
    let p = rng.direction() * rng.magnitude(1e-3, 20.0) * radius;
    (p, p / radius + DVec3::Y * (setting.dial / radius))
}

fn exact(
    bench: &Bench,
    setting: &Setting,
    chart: ChartId,
    found: &mut Findings,
) -> Result<(), LabError> {
    let mut rng = Numbers::new(23);
    let space = setting.space.as_ref();
    let hyperbolic = !space.is_closed();
    let radius = space.radius_m();
    let eye = Eye {
        dial: setting.dial,
        ..Eye::default()
    };
    let inputs: Vec<(DVec3, DVec3)> = (0..bench.effort.count(50_000))
        .map(|_| {
            let p = place(&mut rng, setting).0;
            (p.as_vec3().as_dvec3(), rng.direction().as_vec3().as_dvec3())
        })
        .collect();
    let list: Vec<cases::Case> = inputs
        .iter()
        .map(|(p, n)| cases::case(space, &eye, ChartPoint::new(chart, *p), *n))
        .collect();
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let mut worst = [(); 4].map(|()| Worst::default());
    let mut curves =
        ["CPU f32", "CPU f64", "GPU", "textbook f32"].map(|name| Curve::new(name, 1e-3, 21.0));
    let lift = if hyperbolic {
        setting.dial / radius
    } else {
        0.0
    };
    for (i, (p, n)) in inputs.iter().enumerate() {
        let q = *p / radius + DVec3::Y * lift;
        let (truth, condition) = by_definition(hyperbolic, q, *n);
        let errors = [
            Some(single_normal(hyperbolic, q, *n)),
            Some(space.port_normal(&eye, ChartPoint::new(chart, *p), *n)),
            gpu.as_ref().map(|gpu| gpu[i].normal.as_dvec3()),
            Some(*n),
        ]
        .map(|ours| ours.map(|ours| angle(ours, truth) / condition));
        let at = || format!("p = {} m, n = {}", words(*p), words(*n));
        note_all(errors, &mut worst, &mut curves, q.length(), at);
    }
    let name = setting.space.chart_name(chart);
    push(setting, &name, worst, gpu.is_some(), found);
    found.plots.push(plot(
        &format!("normals-{}-{name}", setting.name),
        &format!(
            "Normals, {}, hemisphere {name}: error against distance",
            setting.name
        ),
        "distance from the chart's centre, radii",
        "worst error, rad",
        &curves,
    ));
    Ok(())
}

fn single_normal(hyperbolic: bool, q: DVec3, n: DVec3) -> DVec3 {
    let (q, n) = (q.as_vec3(), n.as_vec3());
    let ported = if hyperbolic {
        single::normal_exponential(q, n)
    } else {
        single::normal_sphere(q, n)
    };
    ported.as_dvec3()
}

fn push(setting: &Setting, name: &str, worst: [Worst; 4], ran: bool, found: &mut Findings) {
    let [single, double, gpu, textbook] = worst;
    let subject = Subject {
        quantity: "normals",
        range: format!("{}, hemisphere {name}", setting.name),
        unit: "rad",
        naive: Some(textbook),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), SINGLE),
        (Arithmetic::Double, Some(double), 1e-14),
        (Arithmetic::Gpu, ran.then_some(gpu), SINGLE),
    ]));
}

/// The worst normal at a distance, carried like a direction; and a four-normal's darkening.
fn model(bench: &Bench, d: f64, found: &mut Findings) -> Result<(), LabError> {
    let setting = cases::raised(0.0);
    let (space, eye) = (setting.space.as_ref(), Eye::default());
    let mut rng = Numbers::new(29);
    let normals: Vec<(DVec3, DVec3)> = (0..bench.effort.count(20_000))
        .map(|_| (rng.direction() * d * RADIUS_M, rng.direction()))
        .map(|(p, n)| (p.as_vec3().as_dvec3() / RADIUS_M, n.as_vec3().as_dvec3()))
        .collect();
    let case = |(q, n): &(DVec3, DVec3)| cases::case(space, &eye, ChartPoint::a(*q * RADIUS_M), *n);
    let list: Vec<cases::Case> = normals.iter().map(case).collect();
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let found_here = compared(&normals, gpu.as_deref());
    push_model(d, gpu.is_some(), found_here, found);
    Ok(())
}

/// Worst errors of [`model`].
#[derive(Default)]
struct Model {
    /// The shader's normals, degrees, and their lengths, percent.
    shader: Worst,
    length: Worst,
    /// Normals carried like directions, degrees, and ours of the sphere.
    carried: Worst,
    carried_sphere: Worst,
    sphere: Worst,
    /// Darkening by a Euclidean 4-norm, percent.
    dark: Worst,
}

/// Each normal q, n against its definition.
fn compared(normals: &[(DVec3, DVec3)], gpu: Option<&[cases::Answer]>) -> Model {
    let mut all = Model::default();
    for (i, (q, n)) in normals.iter().enumerate() {
        let at = || format!("q = {}, n = {}", words(*q), words(*n));
        let (truth, _) = by_definition(true, *q, *n);
        all.carried.note(angle(*n, truth).to_degrees(), at);
        all.dark.note(darkening(*q, truth), at);
        // On the sphere the same chart shrinks what is across the ray by sin(d)/d.
        let along = q.normalize() * n.dot(q.normalize());
        let truth_sphere = along + (*n - along) / (q.length().sin() / q.length());
        all.carried_sphere
            .note(angle(*n, truth_sphere).to_degrees(), at);
        let ours = exponential::normal(1.0, q.to_array(), n.to_array());
        all.sphere.note(
            angle(DVec3::from_array(ours), truth_sphere).to_degrees(),
            at,
        );
        if let Some(gpu) = gpu {
            let ours = gpu[i].normal.as_dvec3();
            all.shader.note(angle(ours, truth).to_degrees(), at);
            all.length.note((ours.length() - 1.0).abs() * 100.0, at);
        }
    }
    all
}

fn push_model(d: f64, ran: bool, all: Model, found: &mut Findings) {
    let subject = |quantity, unit, naive| Subject {
        quantity,
        range: format!("d = {d}"),
        unit,
        naive: Some(naive),
    };
    let shader = (
        Arithmetic::Gpu,
        ran.then_some(all.shader),
        SINGLE.to_degrees(),
    );
    let rows = subject(
        "normals carried like directions, hyperbolic",
        "deg",
        all.carried,
    );
    found.rows.extend(rows.rows([shader]));
    let rows = subject(
        "normals carried like directions, spherical",
        "deg",
        all.carried_sphere,
    );
    found
        .rows
        .extend(rows.rows([(Arithmetic::Double, Some(all.sphere), 1e-12)]));
    let rows = subject("darkening by a Euclidean 4-norm", "%", all.dark);
    found
        .rows
        .extend(rows.rows([(Arithmetic::Gpu, ran.then_some(all.length), UNIT)]));
}

/// Best known length of a unit normal in single precision, in per cent.
const UNIT: f64 = 2e-5;

/// How much less light a hyperbolic normal catches than a unit one when its four components are
/// divided by their Euclidean length, in per cent.
fn darkening(q: DVec3, normal: DVec3) -> f64 {
    let unit = charts::exponential_direction(-1.0, q, normal);
    let four = naive::four_normal(unit.as_vec4()).as_dvec4();
    (1.0 - charts::inner(-1.0, four, unit)) * 100.0
}
