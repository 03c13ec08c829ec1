//! Depth: the nearest step that a buffer can hold, and the order of surfaces along lines of sight.
//!
//! The step is the distance between neighbouring numbers divided by the slope of the depth, which
//! has a closed form: `n exp(-r)/(R sinh r)` in hyperbolic space, `(1 + (n/R) cot r)/2` on the
//! sphere. Order is counted on what the shaders compute.

use antipode_geometry::{ChartPoint, Eye, Strategy};
use glam::DVec3;

use super::cases::{self, Answer, LIFT_M, NEAR_M, RADIUS_M, Setting};
use super::errors::ulp;
use super::row::{Curve, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::naive;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "The step is the least difference in distance that two neighbouring depths tell apart, in radii. The textbook puts hyperboloid coordinates through the usual projection into 24 bits, with the near plane at 0.01.",
    "For the order, pairs of surfaces a little apart along the same line of sight are put through the port and the projection; a pair whose depths are not in the order of their distances is a fault.",
];

/// Runs the steps and the orders.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    steps(&mut found);
    for (setting, reach) in [
        (cases::flat(), 1000.0),
        (cases::raised(0.0), 400.0),
        (cases::raised(10.0), 400.0),
        (cases::raised(20.0), 400.0),
        (cases::horizon(5.0), 320.0),
        (cases::horizon(20.0), 80.0),
        (cases::sphere(20.0), 0.0),
        (cases::sphere(64.0), 0.0),
    ] {
        order(bench, &setting, reach, &mut found)?;
    }
    Ok(found)
}

fn steps(found: &mut Findings) {
    let mut curves = ["exp(-r), f32", "textbook, 24 bits"].map(|name| Curve::new(name, 0.01, 20.0));
    let near = NEAR_M / RADIUS_M;
    for (low, high) in [(0.1, 5.0), (5.0, 8.0), (8.0, 20.0)] {
        let (mut ours, mut textbook) = (Worst::default(), Worst::default());
        for i in 0..=1000 {
            let r = low + (high - low) * f64::from(i) / 1000.0;
            let depth = near * (-r).exp() / r.sinh();
            let step = ulp(depth) / (depth * (1.0 + 1.0 / r.tanh()));
            let old = textbook_step(r);
            let at = || format!("r = {r:.3}");
            ours.note(step, at);
            textbook.note(old, at);
            curves[0].note(r, step);
            curves[1].note(r, old);
        }
        found.rows.push(Row {
            quantity: "nearest depth step, hyperbolic",
            range: format!("r from {low} to {high}"),
            arithmetic: Arithmetic::Single,
            unit: "radii",
            ours: Some(ours),
            bar: Some(7e-8),
            naive: Some(textbook),
        });
    }
    found.plots.push(plot(
        "depth-step",
        "Nearest depth step in hyperbolic space",
        "distance, radii",
        "least step told apart, radii",
        &curves,
    ));
}

/// One step of a 24-bit depth `coth r` with its near plane at 0.01; infinite where all of the rest
/// of the world falls into one step.
fn textbook_step(r: f64) -> f64 {
    let here = naive::depth_24(0.01, 1e9, r.tanh());
    let last = naive::depth_24(0.01, 1e9, 1.0);
    if here >= last {
        return f64::INFINITY;
    }
    r.sinh().powi(2) * (-24.0_f64).exp2() / 0.01
}

/// Pairs of surfaces along lines of sight, as cases, and the distance of the nearer ones in metres.
fn pairs(
    bench: &Bench,
    space: &dyn Strategy,
    eye: &Eye,
    reach: f64,
    scale: f64,
    curved: bool,
) -> (Vec<cases::Case>, Vec<f64>) {
    let mut rng = Numbers::new(31);
    let (mut list, mut distances) = (Vec::new(), Vec::new());
    for _ in 0..bench.effort.count(50_000) {
        let t = rng.magnitude(2.0 * NEAR_M, reach - 2.0 * APART * scale);
        // Where the picture is flat, the resolution follows the distance.
        let apart = APART * if curved { scale } else { t };
        let ray = DVec3::new(rng.between(-0.6, 0.6), rng.between(-0.5, 0.5), -1.0).normalize();
        for t in [t, t + apart] {
            let point = space.along(eye, ray, t);
            list.push(cases::case(space, eye, point, DVec3::Y));
        }
        distances.push(t);
    }
    (list, distances)
}

/// Separations along the line of sight, in radii of curvature.
const APART: f64 = 1e-3;

fn order(
    bench: &Bench,
    setting: &Setting,
    reach_m: f64,
    found: &mut Findings,
) -> Result<(), LabError> {
    let space = setting.space.as_ref();
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(3.0, 0.5 * RADIUS_M, 1.0)),
        yaw: 0.4,
        pitch: -0.1,
        roll: 0.0,
        dial: setting.dial,
        lift_m: LIFT_M,
    };
    let radius = space.radius_at_m(&eye);
    let scale = if radius.is_finite() { radius } else { RADIUS_M };
    let reach = if space.is_closed() {
        // Two near distances before the antipode, where one point fills the view.
        std::f64::consts::PI * radius - 2.0 * NEAR_M
    } else {
        reach_m
    };
    let (list, distances) = pairs(bench, space, &eye, reach, scale, radius.is_finite());
    let answers = cases::answers(bench.gpu.as_ref(), &list)?;
    let double: Vec<f64> = list
        .iter()
        .map(|case| depth_in_double(setting, &eye, case))
        .collect();
    let ours = answers.map(|answers| {
        let depths: Vec<f64> = answers.iter().map(depth_on_gpu).collect();
        faults(&depths, &distances)
    });
    let double = faults(&double, &distances);
    for (arithmetic, ours) in [(Arithmetic::Cast, Some(double)), (Arithmetic::Gpu, ours)] {
        found.rows.push(Row {
            quantity: "depth order along lines of sight",
            range: format!("{}, to {reach:.0} m, {APART} radii apart", setting.name),
            arithmetic,
            unit: "pairs",
            ours,
            bar: Some(0.0),
            naive: None,
        });
    }
    Ok(())
}

fn depth_on_gpu(answer: &Answer) -> f64 {
    f64::from(answer.clip.z / answer.clip.w)
}

fn depth_in_double(setting: &Setting, eye: &Eye, case: &cases::Case) -> f64 {
    let space = setting.space.as_ref();
    let chart = antipode_geometry::ChartId::new(case.chart.into());
    let pos = space.reference(eye, chart) + case.p.as_dvec3();
    let view = space.view_point(eye, ChartPoint::new(chart, pos));
    let clip = space
        .clip_from_view(eye, &cases::projection(), view)
        .as_vec4();
    f64::from(clip.z / clip.w)
}

/// Counts pairs whose depths do not fall with the distance.
fn faults(depths: &[f64], distances: &[f64]) -> Worst {
    let mut worst = Worst::default();
    let mut count = 0.0;
    for (pair, t) in depths.chunks_exact(2).zip(distances) {
        let finite = pair[0].is_finite() && pair[1].is_finite();
        let fault = pair[0] <= pair[1];
        count += f64::from(u8::from(fault));
        let error = if finite { count } else { f64::NAN };
        worst.note(error, || {
            format!("{t:.4} m: {:e} and {:e}", pair[0], pair[1])
        });
    }
    worst
}
