//! A fuzz over every magnitude of `f32`, and the same bits on every run and thread.

use antipode_geometry::{ChartId, ChartPoint, Eye};
use glam::{DVec3, Vec3};

use super::cases::{self, LIFT_M, Setting};
use super::errors::words;
use super::row::Subject;
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::naive;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Points, normals and boxes with coordinates of every exponent that f32 has, of both signs, and zeros among them, go through the port, normal, projection, distance and the cell that culling tests. No answer may be NaN or infinite. On a sphere the domain is its chart, within its rim and under its ceiling; everywhere else it is half the range of f32, so that lengths are in it too.",
    "The same inputs are computed twice on the adapter, and on one and on several threads of the processor; the row counts answers that differ in any bit.",
];

/// Runs the fuzz and the repetitions.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for setting in settings() {
        fuzz(bench, &setting, &mut found)?;
    }
    repeated(bench, &mut found)?;
    Ok(found)
}

fn settings() -> [Setting; 8] {
    [
        cases::flat(),
        cases::raised(0.0),
        cases::raised(20.0),
        cases::horizon(0.0),
        cases::horizon(20.0),
        cases::bent(-20.0),
        cases::sphere(16.0),
        cases::sphere(64.0),
    ]
}

/// A number of any exponent, or zero; `f32`'s own range, subnormal ones included.
fn any(rng: &mut Numbers) -> f32 {
    let bits = rng.bits() as u32;
    if bits.is_multiple_of(23) {
        return 0.0;
    }
    let number = f32::from_bits(bits);
    if number.is_finite() { number } else { f32::MAX }
}

fn any_vector(rng: &mut Numbers) -> Vec3 {
    Vec3::new(any(rng), any(rng), any(rng))
}

/// Heights of a sphere's world end here, in radii.
const CEILING: f64 = 1.2;

/// A point of any magnitude that the space's chart holds, relative to its reference. Everywhere
/// but on a sphere that is half the range of `f32`, so that its length is in range too.
fn any_point(rng: &mut Numbers, setting: &Setting, eye: &Eye) -> Vec3 {
    let p = any_vector(rng).as_dvec3() * 0.5;
    let space = setting.space.as_ref();
    if let Some(rim) = space.domain(ChartId::FIRST).radius_m() {
        let ceiling = CEILING * space.radius_m();
        let level = (rim / p.x.hypot(p.z)).min(1.0);
        return DVec3::new(p.x * level, p.y.clamp(-ceiling, ceiling), p.z * level).as_vec3();
    }
    let trimmed = |p: DVec3| {
        let pos = eye.point.pos + p;
        space.trims(eye, eye.point.chart, pos, pos)
    };
    if trimmed(p) {
        // A flat world bent to a sphere ends at the edge of its chart.
        return (p.normalize() * setting.space.radius_at_m(eye)).as_vec3();
    }
    p.as_vec3()
}

/// An input of the fuzz: an eye, a point, and a normal that has a direction.
type Thrown = (Eye, ChartPoint, DVec3);

/// One input, and the shader's case of it.
fn thrown(rng: &mut Numbers, setting: &Setting) -> (Thrown, cases::Case) {
    let space = setting.space.as_ref();
    let eye = Eye {
        point: ChartPoint::a(DVec3::Y * 0.3 * space.radius_m().min(20.0)),
        yaw: rng.between(-3.2, 3.2),
        pitch: rng.between(-1.5, 1.5),
        roll: 0.0,
        dial: setting.dial,
        lift_m: LIFT_M,
    };
    let p = any_point(rng, setting, &eye);
    // A normal has some length that can be normalised; its components may be tiny or 0.
    let n = any_vector(rng).as_dvec3().normalize_or(DVec3::Y);
    let b = space.is_closed() && rng.bits().is_multiple_of(2);
    let side = if b { ChartId::SECOND } else { ChartId::FIRST };
    let pos = space.reference(&eye, side) + p.as_dvec3();
    let point = ChartPoint::new(side, pos);
    let mut case = cases::case(space, &eye, point, n);
    case.p = p;
    ((eye, point, n), case)
}

/// Whether every answer of the `f64` port is a number.
fn finite(setting: &Setting, (eye, point, n): &Thrown) -> bool {
    let space = setting.space.as_ref();
    let view = space.view_point(eye, *point);
    let clip = space.clip_from_view(eye, &cases::projection(), view);
    let normal = space.port_normal(eye, *point, *n);
    let far = point.pos + DVec3::splat(32.0);
    let cell = space.sight_cell(eye, point.chart, point.pos, far);
    let distance = space.eye_distance_m(eye, view);
    view.is_finite()
        && clip.is_finite()
        && (normal.length() - 1.0).abs() < 1e-9
        && distance.is_finite()
        && ![cell.slope[0], cell.slope[1], cell.nearest_m]
            .map(f64::is_nan)
            .contains(&true)
}

/// Whether every answer of the shader is.
fn finite_on_gpu(answer: &cases::Answer) -> bool {
    answer.view.is_finite()
        && answer.clip.is_finite()
        && (answer.normal.as_dvec3().length() - 1.0).abs() < 1e-5
        && answer.distance.is_finite()
}

fn fuzz(bench: &Bench, setting: &Setting, found: &mut Findings) -> Result<(), LabError> {
    let mut rng = Numbers::new(103);
    let (mut double, mut textbook) = (Worst::default(), Worst::default());
    let mut list = Vec::new();
    let error = |fine: bool| if fine { 0.0 } else { f64::NAN };
    for _ in 0..bench.effort.count(100_000) {
        let (input, case) = thrown(&mut rng, setting);
        list.push(case);
        let at = || format!("p = {}, n = {}", words(case.p.as_dvec3()), words(input.2));
        double.note(error(finite(setting, &input)), at);
        if setting.space.curvature().sign < 0.0 {
            let x = naive::exponential(-1.0, case.p / setting.space.radius_m() as f32);
            let fine = x.is_finite() && x.w.acosh().is_finite();
            textbook.note(error(fine), at);
        }
    }
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?.map(|answers| {
        let mut worst = Worst::default();
        for (answer, case) in answers.iter().zip(&list) {
            let at = || format!("p = {}, n = {}", words(case.p.as_dvec3()), case.n);
            worst.note(error(finite_on_gpu(answer)), at);
        }
        worst
    });
    let subject = Subject {
        quantity: "NaN or infinity at any magnitude",
        range: setting.name.clone(),
        unit: "",
        naive: (textbook.count > 0).then_some(textbook),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Double, Some(double), 0.0),
        (Arithmetic::Gpu, gpu, 0.0),
    ]));
    Ok(())
}

/// Bits of a port, its normal and its distance, in `f64`.
fn bits(setting: &Setting, eye: &Eye, p: DVec3, n: DVec3) -> [u64; 8] {
    let point = ChartPoint::a(p);
    let view = setting.space.view_point(eye, point);
    let normal = setting.space.port_normal(eye, point, n);
    let distance = setting.space.eye_distance_m(eye, view);
    let numbers = [
        view.x, view.y, view.z, view.w, normal.x, normal.y, normal.z, distance,
    ];
    numbers.map(f64::to_bits)
}

fn repeated(bench: &Bench, found: &mut Findings) -> Result<(), LabError> {
    for setting in [
        cases::raised(10.0),
        cases::horizon(10.0),
        cases::sphere(32.0),
    ] {
        let mut rng = Numbers::new(107);
        let eye = Eye {
            point: ChartPoint::a(DVec3::new(1.0, 9.0, 2.0)),
            yaw: 0.7,
            pitch: -0.3,
            roll: 0.0,
            dial: setting.dial,
            lift_m: LIFT_M,
        };
        let inputs: Vec<(DVec3, DVec3)> = (0..bench.effort.count(20_000))
            .map(|_| (rng.direction() * rng.between(1.0, 40.0), rng.direction()))
            .collect();
        let once: Vec<[u64; 8]> = inputs
            .iter()
            .map(|(p, n)| bits(&setting, &eye, *p, *n))
            .collect();
        let mut threads = Worst::default();
        for again in on_threads(&setting, &eye, &inputs) {
            for (a, b) in once.iter().zip(&again) {
                threads.note(f64::from(u8::from(a != b)), String::new);
            }
        }
        let list: Vec<cases::Case> = inputs
            .iter()
            .map(|(p, n)| cases::case(setting.space.as_ref(), &eye, ChartPoint::a(*p), *n))
            .collect();
        let first = cases::answers(bench.gpu.as_ref(), &list)?;
        let second = cases::answers(bench.gpu.as_ref(), &list)?;
        let gpu = first.zip(second).map(|(first, second)| {
            let mut worst = Worst::default();
            for (a, b) in first.iter().zip(&second) {
                let differ = bytemuck::bytes_of(a) != bytemuck::bytes_of(b);
                worst.note(f64::from(u8::from(differ)), || format!("{a:?} and {b:?}"));
            }
            worst
        });
        for (arithmetic, ours) in [(Arithmetic::Double, Some(threads)), (Arithmetic::Gpu, gpu)] {
            found.rows.push(Row {
                quantity: "the same bits again",
                range: setting.name.clone(),
                arithmetic,
                unit: "differ",
                ours,
                bar: Some(0.0),
                naive: None,
            });
        }
    }
    Ok(())
}

/// The same computation on each of four threads at once. A thread that did not come back gives
/// no answers, and every one of them counts as different.
fn on_threads(setting: &Setting, eye: &Eye, inputs: &[(DVec3, DVec3)]) -> Vec<Vec<[u64; 8]>> {
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..4)
            .map(|_| {
                scope.spawn(|| {
                    inputs
                        .iter()
                        .map(|(p, n)| bits(setting, eye, *p, *n))
                        .collect()
                })
            })
            .collect();
        let lost = || vec![[0; 8]; inputs.len()];
        workers
            .into_iter()
            .map(|worker| worker.join().unwrap_or_else(|_| lost()))
            .collect()
    })
}
