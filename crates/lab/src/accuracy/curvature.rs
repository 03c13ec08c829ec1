//! Curvature swept from nothing to the top of the scroll range, and through zero.
//!
//! Reference for each curvature: the `f64` port. The step at zero is that of the picture in pixels
//! when the curvature goes through zero in small steps of the dial: a switch would be seen as one.

use antipode_geometry::{ChartPoint, Eye, Geometry, HyperbolicMap, Projection, Strategy, picture};
use glam::{DVec2, DVec3};

use super::cases::{self, Answer, HEIGHT, LIFT_M, Setting};
use super::row::{Curve, Subject, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Points up to 300 m away are projected while the curvature is swept; errors are in pixels of a picture of 1280 by 720. A world of radius R has the curvature 1/R: raised maps go from 1e-30 per metre to the world's own 1/20, the horizon map to its top of 1/4 per metre, and a flat world is bent through zero.",
    "The textbook switches to the flat formula below a curvature of 1e-3 per metre; the whole bend of that curvature appears at once.",
];

/// Best known: no switch visible.
const POP_PX: f64 = 1e-3;
/// The textbook's switch, at 1e-3 per metre, on the dial.
const SWITCH_DIAL: f64 = 0.08;

/// Runs the sweeps.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    let mut curve = Curve::new("GPU, raised, dial 10", 1e-30, 1.0);
    for range in [[1e-30, 1e-9], [1e-9, 1e-3], [1e-3, 0.25]] {
        found.rows.extend(sweep(bench, range, &mut curve)?);
    }
    found.plots.push(plot(
        "curvature-sweep",
        "Curvature swept to nothing: error of the picture",
        "curvature, 1/m",
        "worst error, px",
        &[curve],
    ));
    let bent = cases::bent(0.0);
    let level = cases::horizon(0.0);
    found.rows.extend(through_zero(
        bench,
        "flat world bent",
        &bent,
        [-1e-4, 0.0, 1e-4],
    )?);
    found.rows.extend(through_zero(
        bench,
        "horizon map",
        &level,
        [0.0, 1e-4, 2e-4],
    )?);
    Ok(found)
}

/// Pixels from the middle of the picture.
pub fn pixel(clip: glam::DVec4) -> Option<DVec2> {
    let at = Projection::screen(clip)?;
    let inside = at.abs().max_element() <= 1.0;
    inside.then(|| at * DVec2::new(0.5 * cases::WIDTH, 0.5 * HEIGHT))
}

fn eye(dial: f64) -> Eye {
    Eye {
        point: ChartPoint::a(DVec3::new(0.0, LIFT_M, 0.0)),
        dial,
        lift_m: LIFT_M,
        ..Eye::default()
    }
}

fn ahead(rng: &mut Numbers) -> DVec3 {
    let x = rng.magnitude(0.5, 300.0);
    let aside = DVec3::new(1.0, rng.between(-0.7, 0.7), rng.between(-1.2, 1.2));
    (aside * x).as_vec3().as_dvec3()
}

/// The projection of a world of curvature k per metre, on the adapter, against `f64`.
fn sweep(bench: &Bench, range: [f64; 2], curve: &mut Curve) -> Result<[Row; 1], LabError> {
    let mut rng = Numbers::new(71);
    let (mut list, mut exact) = (Vec::new(), Vec::new());
    for _ in 0..bench.effort.count(20_000) {
        let k = rng.magnitude(range[0], range[1]);
        let space = picture(Geometry::Hyperbolic, 1.0 / k, HyperbolicMap::Raised, false);
        let eye = eye(10.0);
        let u = ahead(&mut rng) * if k > 0.05 { 0.05 / k } else { 1.0 };
        let point = ChartPoint::a(eye.point.pos + u);
        let case = cases::case(space.as_ref(), &eye, point, DVec3::Y);
        // What the shader is given is what the reference ports.
        let given = ChartPoint::a(eye.point.pos + case.p.as_dvec3());
        let view = space.view_point(&eye, given);
        let clip = space.clip_from_view(&eye, &cases::projection(), view);
        list.push(case);
        exact.push((k, clip));
    }
    let ours = cases::answers(bench.gpu.as_ref(), &list)?.map(|answers| {
        let mut worst = Worst::default();
        for (answer, (k, clip)) in answers.iter().zip(&exact) {
            let Some(at) = pixel(*clip) else { continue };
            let off = (drawn(answer) - at).length();
            worst.note(off, || format!("k = {k:e}"));
            curve.note(*k, off);
        }
        worst
    });
    let subject = Subject {
        quantity: "curvature sweep, error",
        range: format!("k from {:e} to {} per metre", range[0], range[1]),
        unit: "px",
        naive: None,
    };
    Ok(subject.rows([(Arithmetic::Gpu, ours, POP_PX)]))
}

/// Where the shader puts a point, in pixels from the middle of the picture.
fn drawn(answer: &Answer) -> DVec2 {
    let clip = answer.clip.as_dvec4();
    DVec2::new(clip.x, clip.y) / clip.w * DVec2::new(0.5 * cases::WIDTH, 0.5 * HEIGHT)
}

fn position(space: &dyn Strategy, dial: f64, u: DVec3) -> Option<DVec2> {
    let eye = eye(dial);
    let view = space.view_point(&eye, ChartPoint::a(eye.point.pos + u));
    pixel(space.clip_from_view(&eye, &cases::projection(), view))
}

/// Through zero along three equal steps of the dial.
fn through_zero(
    bench: &Bench,
    name: &str,
    setting: &Setting,
    dials: [f64; 3],
) -> Result<[Row; 2], LabError> {
    let (flat, space) = (cases::flat(), setting.space.as_ref());
    let mut rng = Numbers::new(73);
    let [mut ours, mut textbook] = [(); 2].map(|()| Worst::default());
    let mut list = Vec::new();
    for _ in 0..bench.effort.count(20_000) {
        let u = ahead(&mut rng);
        let [Some(a), Some(b), Some(c)] = dials.map(|dial| position(space, dial, u)) else {
            continue;
        };
        let at = || format!("u = {u} m");
        ours.note((b - a).length().max((c - b).length()), at);
        let bent = position(space, SWITCH_DIAL, u);
        let straight = position(flat.space.as_ref(), 0.0, u);
        if let (Some(bent), Some(straight)) = (bent, straight) {
            textbook.note((bent - straight).length(), at);
        }
        list.extend(dials.map(|dial| {
            let eye = eye(dial);
            cases::case(space, &eye, ChartPoint::a(eye.point.pos + u), DVec3::Y)
        }));
    }
    let shader = cases::answers(bench.gpu.as_ref(), &list)?.map(|answers| {
        let mut worst = Worst::default();
        for (i, three) in answers.chunks_exact(3).enumerate() {
            let jump = |k: usize| (drawn(&three[k + 1]) - drawn(&three[k])).length();
            worst.note(jump(0).max(jump(1)), || format!("p = {} m", list[3 * i].p));
        }
        worst
    });
    let subject = Subject {
        quantity: "curvature through 0, step of the picture",
        range: format!("{name}, dial {} to {}", dials[0], dials[2]),
        unit: "px",
        naive: Some(textbook),
    };
    Ok(subject.rows([
        (Arithmetic::Double, Some(ours), POP_PX),
        (Arithmetic::Gpu, shader, POP_PX),
    ]))
}
