//! The sphere's two charts: the equator to the last ulp, the poles, the antipode, a million crossings.
//!
//! A point of the sphere is written in either chart; its two pictures must be one. Reference at the
//! pole and the antipode: the definition of the chart, in `f64`.

use std::f64::consts::{FRAC_PI_2, PI};

use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry, strategy};
use glam::{DVec2, DVec3, DVec4, Vec3};

use super::cases::{self, single_view};
use super::errors::words;
use super::row::Subject;
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Errors are distances between two computed points in units of the radius, which is their angle on the sphere.",
    "At the equator a point is written in both charts and ported from both; the difference of the two is the jump of a picture when a body changes charts. Beside it stands the rule of the theses, exponential charts about both poles that are changed where the level distance passes a right angle: at a height of half a radius on a sphere of 20 m the picture jumps by 3.1 voxels.",
    "A million crossings to and fro must leave a body where it was.",
];

/// Best known: a picture's jump at the equator, in radians.
const CROSSING: f64 = 5.6e-7;

/// Runs equator, poles, antipode and crossings.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for radius in [16.0, 20.0, 64.0] {
        equator(bench, radius, &mut found)?;
    }
    for (place, r) in [("pole", 0.0), ("equator", FRAC_PI_2)] {
        ends(bench, place, r, &mut found)?;
    }
    teleports(bench, &mut found);
    Ok(found)
}

fn next(x: f32, ulps: i32) -> f32 {
    f32::from_bits(x.to_bits().wrapping_add_signed(ulps))
}

/// The rule of the theses: exponential charts about both poles, and a body changes charts where its
/// level distance passes a right angle, at the same height. It is then at `hypot(pi/2, h)` from the
/// pole in either chart, so the two points are twice the excess over a right angle apart. `h` is
/// the height in radii.
fn jump_of_the_theses(h: f64) -> f64 {
    2.0 * (FRAC_PI_2.hypot(h) - FRAC_PI_2)
}

/// An eye over the ground, and a point near the equator or just past it, in metres.
fn at_the_rim(rng: &mut Numbers, radius: f64, i: usize) -> (Eye, ChartPoint) {
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(
            rng.between(-1.0, 1.0) * radius,
            rng.between(0.15, 1.0) * radius,
            rng.between(-1.0, 1.0) * radius,
        )),
        yaw: rng.between(-3.2, 3.2),
        pitch: rng.between(-1.4, 1.4),
        ..Eye::default()
    };
    // From ten ulp this side to ten ulp beyond, and up to the colliders' overlap.
    let rim = f64::from(next((FRAC_PI_2 * radius) as f32, i as i32 % 21 - 10));
    let beyond = if i.is_multiple_of(2) {
        0.0
    } else {
        rng.between(-0.2, 8.0)
    };
    let level = rng.turn() * (rim + beyond);
    let pos = DVec3::new(level.x, rng.between(0.1, 1.2) * radius, level.y);
    (eye, ChartPoint::a(pos.as_vec3().as_dvec3()))
}

fn equator(bench: &Bench, radius: f64, found: &mut Findings) -> Result<(), LabError> {
    let space = strategy(Geometry::Spherical, radius);
    let mut rng = Numbers::new(61);
    let (mut list, mut points) = (Vec::new(), Vec::new());
    for i in 0..bench.effort.count(20_000) {
        let (eye, a) = at_the_rim(&mut rng, radius, i);
        let Some(b) = space.images(a, f64::INFINITY).pop() else {
            continue;
        };
        for point in [a, b.point] {
            list.push(cases::case(space.as_ref(), &eye, point, DVec3::Y));
        }
        points.push((eye, a, b.point));
    }
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let [mut double, mut single, mut shader, mut theses] = [(); 4].map(|()| Worst::default());
    for (i, (eye, a, b)) in points.iter().enumerate() {
        let at = || format!("{} m", words(a.pos));
        let gap = |a: DVec4, b: DVec4| (a - b).truncate().length() / radius;
        double.note(
            gap(space.view_point(eye, *a), space.view_point(eye, *b)),
            at,
        );
        let both = [2 * i, 2 * i + 1];
        let [here, there] = both.map(|i| single_view(&list[i]).as_dvec4());
        single.note(gap(here, there), at);
        if let Some(gpu) = &gpu {
            let [here, there] = both.map(|i| gpu[i].view.as_dvec4());
            shader.note(gap(here, there), at);
        }
        theses.note(jump_of_the_theses(a.pos.y / radius), at);
    }
    let subject = Subject {
        quantity: "equator crossing, jump of the picture",
        range: format!("R = {radius} m, ten ulp either side and 8 m beyond"),
        unit: "rad",
        naive: Some(theses),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Double, Some(double), 1e-14),
        (Arithmetic::Single, Some(single), CROSSING),
        (Arithmetic::Gpu, gpu.is_some().then_some(shader), CROSSING),
    ]));
    Ok(())
}

/// Points about the pole or the equator, seen by eyes that include their antipodes.
fn ends(bench: &Bench, place: &str, r: f64, found: &mut Findings) -> Result<(), LabError> {
    let radius = 32.0;
    let space = strategy(Geometry::Spherical, radius);
    let mut rng = Numbers::new(67);
    let (mut list, mut exact) = (Vec::new(), Vec::new());
    for i in 0..bench.effort.count(20_000) {
        let (eye, point) = at_an_end(&mut rng, radius, r, i);
        list.push(cases::case(space.as_ref(), &eye, point, DVec3::Y));
        exact.push((space.view_point(&eye, point), point));
    }
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let mut worst = [(); 3].map(|()| Worst::default());
    for (i, (view, point)) in exact.iter().enumerate() {
        let views = [
            Some(single_view(&list[i])),
            Some(view.as_vec4()),
            gpu.as_ref().map(|gpu| gpu[i].view),
        ];
        for (ours, worst) in views.into_iter().zip(&mut worst) {
            let Some(ours) = ours else { continue };
            let gap = ours.as_dvec4() - *view;
            let gap = (gap.truncate() / radius).extend(gap.w).length();
            worst.note(gap, || format!("{} m", words(point.pos)));
        }
    }
    let [single, cast, shader] = worst;
    let subject = Subject {
        quantity: "points at the poles and the antipode",
        range: format!("about the {place}, half of them seen from their antipode"),
        unit: "rad",
        naive: None,
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), CROSSING),
        (Arithmetic::Cast, Some(cast), CROSSING),
        (Arithmetic::Gpu, gpu.is_some().then_some(shader), CROSSING),
    ]));
    Ok(())
}

/// A point at r radii from the pole, or nearly, and an eye: every other one at its antipode.
fn at_an_end(rng: &mut Numbers, radius: f64, r: f64, i: usize) -> (Eye, ChartPoint) {
    let off = if i.is_multiple_of(5) {
        0.0
    } else {
        rng.magnitude(1e-8, 1e-2)
    };
    let level: DVec2 = rng.turn() * (r + off) * radius;
    let height = rng.between(0.1, 1.2) * radius;
    let pos = DVec3::new(level.x, height, level.y).as_vec3().as_dvec3();
    // The antipode of (r, y) in chart A: turned half about the axis in B, and under ground.
    let at = if i.is_multiple_of(2) {
        ChartPoint::new(ChartId::SECOND, DVec3::new(level.x, -height, -level.y))
    } else {
        ChartPoint::a(DVec3::new(
            rng.between(-20.0, 20.0),
            8.0,
            rng.between(-20.0, 20.0),
        ))
    };
    let eye = Eye {
        point: at,
        yaw: rng.between(-3.2, 3.2),
        pitch: rng.between(-1.4, 1.4),
        ..Eye::default()
    };
    (eye, ChartPoint::a(pos))
}

fn teleports(bench: &Bench, found: &mut Findings) {
    let radius = 20.0;
    let space = strategy(Geometry::Spherical, radius);
    let crossings = bench.effort.count(1_000_000);
    let start = ChartPoint::a(DVec3::new(1.1, 0.35, -1.2) * radius);
    let (mut here, mut facing) = (start, DVec3::new(0.3, 0.1, 0.9));
    let began = facing;
    // The textbook's body in single precision, by the same rule.
    let mut single = start.pos.as_vec3();
    let (mut ours, mut textbook) = (Worst::default(), Worst::default());
    for i in 1..=crossings {
        if let Some(over) = space.images(here, f64::INFINITY).pop() {
            facing = over.turn_vector(facing);
            here = over.point;
        }
        single = carried(radius as f32, single);
        if i % 2 == 0 {
            let drift = (here.pos - start.pos).length() / radius + (facing - began).length();
            ours.note(drift, || format!("after {i} crossings"));
            let drift = f64::from((single - start.pos.as_vec3()).length()) / radius;
            textbook.note(drift, || format!("after {i} crossings"));
        }
    }
    found.rows.push(Row {
        quantity: "teleports, drift of place and heading",
        range: format!("{crossings} crossings of the equator"),
        arithmetic: Arithmetic::Double,
        unit: "rad",
        ours: Some(ours),
        bar: Some(CROSSING),
        naive: Some(textbook),
    });
}

fn carried(radius: f32, p: Vec3) -> Vec3 {
    let r = p.x.hypot(p.z);
    let far = (PI as f32 * radius - r) / r;
    Vec3::new(-p.x * far, p.y, p.z * far)
}
