//! Places in the world, from its origin to 1e8 m: chunks, seams, and port and back.
//!
//! A position is a chunk, in whole numbers, and a place in it, in `f32`. The chunk's corner is
//! measured from the whole metres next to the camera, which is exact; the shader adds the place in
//! the chunk and takes off the rest of a metre. Reference:
//! the same difference in `f64`, ported in `f64`.

use antipode_geometry::{CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Eye};
use glam::{DVec3, Vec3};

use super::cases::{self, LIFT_M, RADIUS_M, Setting};
use super::errors::{angle, words};
use super::row::{Curve, Subject, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::naive;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Vertices of chunks at least 1.6 m from the camera, as far down as its feet, are drawn at growing distances from the origin of the world. The textbook keeps world positions in f32.",
    "At a seam the same vertex is in two chunks: at 32 m along one of them and at 0 along the next. The row says how far apart the two are seen; it has to be nothing, bit for bit.",
    "Port and back: a chart point is ported and un-ported in f64, up to 20 radii away (15 through the horizon map, whose heights lose a digit with each 2.3 radii); the error is relative to its distance from the camera or to the radius, whichever is greater. The textbook un-ports with acosh in f32.",
];

/// Best known: angle error however far from the origin, in radians.
const WALKED: f64 = 6e-7;
/// A nanometre per metre: far below what picking and digging can tell apart.
const DOUBLE: f64 = 1e-9;

/// Runs positions, seams and port and back.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    let mut curves = ["GPU", "textbook f32"].map(|name| Curve::new(name, 1.0, 1e8));
    for range in [[1.0, 1e3], [1e3, 1e6], [1e6, 1e8]] {
        positions(bench, range, &mut curves, &mut found)?;
    }
    found.plots.push(plot(
        "positions",
        "World positions: angle error against distance from the origin",
        "distance from the origin, m",
        "worst error, rad",
        &curves,
    ));
    for high in [1e3, 1e6, 1e8] {
        seams(bench, high, &mut found);
    }
    for (setting, reach) in [
        (cases::flat(), 1e3),
        (cases::raised(0.0), 400.0),
        (cases::raised(0.5), 400.0),
        (cases::raised(10.0), 400.0),
        (cases::raised(20.0), 400.0),
        (cases::horizon(5.0), 240.0),
        (cases::horizon(20.0), 60.0),
        (cases::bent(-5.0), 30.0),
        (cases::sphere(16.0), 0.0),
        (cases::sphere(64.0), 0.0),
    ] {
        port_and_back(bench, &setting, reach, &mut found);
    }
    Ok(found)
}

/// A camera at a distance from the origin, on level ground.
fn camera(rng: &mut Numbers, [low, high]: [f64; 2]) -> Eye {
    let level = rng.turn() * rng.magnitude(low, high);
    Eye {
        point: ChartPoint::a(DVec3::new(level.x, rng.between(-200.0, 200.0), level.y)),
        yaw: rng.between(-3.2, 3.2),
        pitch: rng.between(-1.4, 1.4),
        roll: 0.0,
        dial: 10.0,
        lift_m: LIFT_M,
    }
}

/// A vertex as its chunk holds it: the chunk's corner, and a place in it.
pub fn vertex(rng: &mut Numbers, eye: &Eye, [low, high]: [f64; 2]) -> (ChunkCoord, Vec3) {
    loop {
        let p = eye.point.pos + rng.direction() * rng.magnitude(low, high);
        let chunk = ChunkCoord::containing(ChartPoint::new(eye.point.chart, p));
        let local = (p - chunk.origin()).as_vec3();
        let exact = chunk.origin() + local.as_dvec3() - eye.point.pos;
        if exact.length() >= low {
            return (chunk, local);
        }
    }
}

fn positions(
    bench: &Bench,
    range: [f64; 2],
    curves: &mut [Curve; 2],
    found: &mut Findings,
) -> Result<(), LabError> {
    let setting = cases::raised(10.0);
    let space = setting.space.as_ref();
    let mut rng = Numbers::new(79);
    let (mut list, mut truths) = (Vec::new(), Vec::new());
    for _ in 0..bench.effort.count(50_000) {
        let eye = camera(&mut rng, range);
        let (chunk, local) = vertex(&mut rng, &eye, [1.6, 200.0]);
        let exact = chunk.origin() + local.as_dvec3();
        let mut case = cases::case(space, &eye, ChartPoint::a(exact), DVec3::Y);
        case.p = cases::sent(space, &eye, chunk, local);
        let straight = exact - eye.point.pos;
        let world = (exact.as_vec3() - eye.point.pos.as_vec3()).as_dvec3();
        let view = space.view_point(&eye, ChartPoint::a(exact)).truncate();
        let ours = angle(case.p.as_dvec3(), straight);
        list.push(case);
        truths.push((eye, view, angle(world, straight), ours));
    }
    let gpu = cases::answers(bench.gpu.as_ref(), &list)?;
    let mut worst = [(); 3].map(|()| Worst::default());
    for (i, (eye, view, textbook, ours)) in truths.iter().enumerate() {
        let at = || {
            format!(
                "camera at {} m, p = {} m",
                words(eye.point.pos),
                words(list[i].p.as_dvec3())
            )
        };
        let far = eye.point.pos.length();
        worst[0].note(*ours, at);
        if let Some(gpu) = &gpu {
            let error = angle(gpu[i].view.as_dvec4().truncate(), *view);
            worst[1].note(error, at);
            curves[0].note(far, error);
        }
        worst[2].note(*textbook, at);
        curves[1].note(far, *textbook);
    }
    push_positions(range, gpu.is_some(), worst, found);
    Ok(())
}

fn push_positions(range: [f64; 2], ran: bool, worst: [Worst; 3], found: &mut Findings) {
    let [single, shader, textbook] = worst;
    let subject = |quantity| Subject {
        quantity,
        range: format!("{:e} to {:e} m from the origin", range[0], range[1]),
        unit: "rad",
        naive: Some(textbook.clone()),
    };
    let shader = ran.then_some(shader);
    let rows = subject("world positions, as the shader has them");
    found
        .rows
        .extend(rows.rows([(Arithmetic::Single, Some(single), WALKED)]));
    let rows = subject("world positions, as seen through the raised map");
    found
        .rows
        .extend(rows.rows([(Arithmetic::Gpu, shader, WALKED)]));
}

/// The same vertex in two neighbouring chunks.
fn seams(bench: &Bench, high: f64, found: &mut Findings) {
    let mut rng = Numbers::new(83);
    let space = cases::raised(10.0).space;
    let (mut ours, mut textbook) = (Worst::default(), Worst::default());
    for _ in 0..bench.effort.count(50_000) {
        let eye = camera(&mut rng, [1.0, high]);
        let (chunk, local) = vertex(&mut rng, &eye, [1.6, 200.0]);
        let side = (rng.bits() % 3) as usize;
        let (mut low, mut up) = (local, local);
        low[side] = CHUNK_CELLS as f32;
        up[side] = 0.0;
        let mut step = glam::IVec3::ZERO;
        step[side] = 1;
        let next = chunk.offset(step);
        let seen = |chunk, local| cases::sent(space.as_ref(), &eye, chunk, local);
        let world = |chunk: ChunkCoord, local: Vec3| {
            (chunk.origin().as_vec3() + local) - eye.point.pos.as_vec3()
        };
        let gap = |a: Vec3, b: Vec3| {
            if a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits) {
                0.0
            } else {
                angle(a.as_dvec3(), b.as_dvec3())
            }
        };
        let at = || format!("camera at {} m, {chunk:?}, {local}", words(eye.point.pos));
        ours.note(gap(seen(chunk, low), seen(next, up)), at);
        let straight = chunk.origin() + low.as_dvec3() - eye.point.pos;
        textbook.note(angle(world(chunk, low).as_dvec3(), straight), at);
    }
    found.rows.push(Row {
        quantity: "vertices shared by two chunks, gap",
        range: format!("to {high:e} m from the origin"),
        arithmetic: Arithmetic::Single,
        unit: "rad",
        ours: Some(ours),
        bar: Some(0.0),
        naive: Some(textbook),
    });
}

fn port_and_back(bench: &Bench, setting: &Setting, reach: f64, found: &mut Findings) {
    let mut rng = Numbers::new(89);
    let space = setting.space.as_ref();
    let (mut ours, mut textbook) = (Worst::default(), Worst::default());
    for _ in 0..bench.effort.count(20_000) {
        let mut eye = camera(&mut rng, [1.0, 30.0]);
        eye.dial = setting.dial;
        let (point, scale) = if space.is_closed() {
            let radius = space.radius_m();
            let level = rng.turn() * rng.between(0.0, 1.56) * radius;
            let side = [ChartId::FIRST, ChartId::SECOND][(rng.bits() % 2) as usize];
            eye.point.pos.y = rng.between(0.1, 1.2) * radius;
            let pos = DVec3::new(level.x, rng.between(0.1, 1.2) * radius, level.y);
            (ChartPoint::new(side, pos), radius)
        } else {
            let u = rng.direction() * rng.magnitude(1e-3, reach);
            (ChartPoint::a(eye.point.pos + u), u.length().max(RADIUS_M))
        };
        if space.trims(&eye, point.chart, point.pos, point.pos) {
            continue;
        }
        let back = space.chart_point(&eye, space.view_point(&eye, point));
        let gap = (back.pos - point.pos).length() / scale;
        let error = if back.chart == point.chart {
            gap
        } else {
            f64::NAN
        };
        ours.note(error, || {
            format!("eye {} m, point {:?}", words(eye.point.pos), point)
        });
        if setting.space.curvature().sign < 0.0 {
            let q = ((point.pos - eye.point.pos) / RADIUS_M).as_vec3();
            let back = naive::unport(naive::exponential(-1.0, q)) - q;
            textbook.note(f64::from(back.length() / q.length().max(1.0)), || {
                words(q.as_dvec3())
            });
        }
    }
    found.rows.push(Row {
        quantity: "port and back",
        range: setting.name.clone(),
        arithmetic: Arithmetic::Double,
        unit: "of it",
        ours: Some(ours),
        bar: Some(DOUBLE),
        naive: (textbook.count > 0).then_some(textbook),
    });
}
