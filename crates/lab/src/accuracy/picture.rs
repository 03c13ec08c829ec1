//! What reaches the picture: straight edges that should bend, and chunks that are culled.
//!
//! The middle of an edge is ported in `f64` and compared with the straight line between its ported
//! ends. Culling is compared with a dense sample of each chunk.

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Euclidean, Eye, Optics, Strategy};
use glam::{DVec2, DVec3, IVec3};

use super::cases::{self, LIFT_M, Setting};
use super::curvature::pixel;
use super::errors::words;
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "The hardware draws the edges of triangles straight, where geodesics between their ends would bow. The row is the gap at the middle of an edge of one voxel in pixels of a picture of 1280 by 720, anywhere from a voxel and a half before the camera to 200 m, when edges are halved up to five times until each part strays by less than half a pixel; the textbook column draws them whole.",
    "A chunk is culled wrongly if a point of a dense sample of it is in the picture. The textbook culls the chunk's box in the chart with a straight frustum. Waste is the share of kept chunks of which no sample is in the picture; a sample may miss a corner, so it is an upper bound.",
];

const HALF_PIXEL: f64 = 0.5;

fn settings() -> [Setting; 7] {
    [
        cases::raised(0.5),
        cases::raised(10.0),
        cases::raised(20.0),
        cases::horizon(10.0),
        cases::horizon(20.0),
        cases::sphere(16.0),
        cases::sphere(64.0),
    ]
}

/// Runs edges and culling.
#[expect(clippy::unnecessary_wraps, reason = "every suite has this signature")]
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for setting in settings() {
        edges(bench, &setting, &mut found);
    }
    for setting in settings() {
        culling(bench, &setting, &mut found);
    }
    Ok(found)
}

/// An eye where a player may stand.
pub fn standing(rng: &mut Numbers, setting: &Setting) -> Eye {
    let sphere = setting.space.domain(ChartId::FIRST).radius_m();
    let reach = sphere.map_or(1e4, |rim| 0.95 * rim);
    let level = rng.turn() * rng.between(0.0, reach);
    let height = sphere.map_or(rng.between(-20.0, 60.0), |_| {
        rng.between(0.2, 0.7) * setting.space.radius_m()
    });
    Eye {
        point: ChartPoint::a(DVec3::new(level.x, height, level.y)),
        yaw: rng.between(-3.2, 3.2),
        pitch: rng.between(-1.2, 0.6),
        roll: 0.0,
        dial: setting.dial,
        lift_m: LIFT_M,
    }
}

/// A chart point that the space may hold, within 200 m of the eye.
pub fn seen_point(rng: &mut Numbers, setting: &Setting, eye: &Eye) -> ChartPoint {
    let Some(rim) = setting.space.domain(ChartId::FIRST).radius_m() else {
        let u = rng.direction() * rng.magnitude(1.5, 200.0);
        return ChartPoint::a(eye.point.pos + u * DVec3::new(1.0, 0.3, 1.0));
    };
    let level = rng.turn() * rng.between(0.0, rim);
    let side = [ChartId::FIRST, ChartId::SECOND][(rng.bits() % 2) as usize];
    let height = rng.between(0.15, 0.5) * setting.space.radius_m();
    ChartPoint::new(side, DVec3::new(level.x, height, level.y))
}

fn place(space: &dyn Strategy, eye: &Eye, point: ChartPoint) -> Option<DVec2> {
    let view = space.view_point(eye, point);
    let near = space.eye_distance_m(eye, view) <= space.sight_limit_m(eye);
    let at = pixel(space.clip_from_view(eye, &cases::projection(), view));
    at.filter(|_| near)
}

/// The gap at the middle of an edge, in pixels, if all of it is in the picture.
fn gap(space: &dyn Strategy, eye: &Eye, from: ChartPoint, edge: DVec3) -> Option<f64> {
    let a = place(space, eye, from)?;
    let middle = place(space, eye, from.moved(edge * 0.5))?;
    let b = place(space, eye, from.moved(edge))?;
    let along = b - a;
    let part = ((middle - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    let off = if along == DVec2::ZERO {
        middle - a
    } else {
        middle - a - along * part
    };
    Some(off.length())
}

/// The game halves an edge at most this often at its balanced quality.
const HALVINGS: u32 = 5;

/// The greatest gap in any part of an edge that is halved until its parts are under half a pixel.
fn halved(
    space: &dyn Strategy,
    eye: &Eye,
    from: ChartPoint,
    edge: DVec3,
    left: u32,
) -> Option<f64> {
    let whole = gap(space, eye, from, edge)?;
    if whole <= HALF_PIXEL || left == 0 {
        return Some(whole);
    }
    let half = edge * 0.5;
    let parts = [from, from.moved(half)].map(|from| halved(space, eye, from, half, left - 1));
    Some(parts[0]?.max(parts[1]?))
}

fn edges(bench: &Bench, setting: &Setting, found: &mut Findings) {
    let mut rng = Numbers::new(97);
    let space = setting.space.as_ref();
    let (mut ours, mut textbook) = (Worst::default(), Worst::default());
    for _ in 0..bench.effort.count(200_000) {
        let eye = standing(&mut rng, setting);
        let from = seen_point(&mut rng, setting, &eye);
        let edge = rng.direction();
        let near = space.eye_distance_m(&eye, space.view_point(&eye, from));
        let Some(whole) = gap(space, &eye, from, edge).filter(|_| near >= 1.5) else {
            continue;
        };
        let at = || {
            format!(
                "eye {} m, edge at {:?} along {}",
                words(eye.point.pos),
                from,
                words(edge)
            )
        };
        textbook.note(whole, at);
        // Parts that leave the picture have no gap in it.
        let gap = halved(space, &eye, from, edge, HALVINGS).unwrap_or(0.0);
        ours.note(gap, at);
    }
    found.rows.push(Row {
        quantity: "middle of an edge of one voxel, halved where it strays",
        range: setting.name.clone(),
        arithmetic: Arithmetic::Double,
        unit: "px",
        ours: Some(ours),
        bar: Some(HALF_PIXEL),
        naive: Some(textbook),
    });
}

/// Whether any point of a dense sample is in the picture.
fn shows(space: &dyn Strategy, eye: &Eye, chunk: ChunkCoord, n: i32) -> bool {
    let size = chunk.max() - chunk.min();
    (0..n * n * n).any(|i| {
        let part = DVec3::new(
            f64::from(i % n),
            f64::from(i / n % n),
            f64::from(i / (n * n)),
        );
        let pos = chunk.min() + size * (part / f64::from(n - 1));
        // What lies past the rim belongs to the other chart, and is not drawn.
        let past = space
            .domain(ChartId::FIRST)
            .radius_m()
            .is_some_and(|rim| pos.x.hypot(pos.z) > rim);
        !past && place(space, eye, ChartPoint::new(chunk.chart, pos)).is_some()
    })
}

fn chunks_about(space: &dyn Strategy, eye: &Eye) -> Vec<ChunkCoord> {
    let home = ChunkCoord::containing(eye.point);
    let around = |far: i32, heights: std::ops::RangeInclusive<i32>, home: ChunkCoord| {
        let mut all = Vec::new();
        for y in heights {
            for x in -far..=far {
                for z in -far..=far {
                    all.push(home.offset(IVec3::new(x, y, z)));
                }
            }
        }
        all
    };
    let Some(rim) = space.domain(ChartId::FIRST).radius_m() else {
        return around(6, -1..=1, home);
    };
    let far = (rim / 32.0).ceil() as i32;
    let high = (1.2 * space.radius_m() / 32.0).ceil() as i32 - 1;
    [ChartId::FIRST, ChartId::SECOND]
        .into_iter()
        .flat_map(|side| around(far, 0..=high, ChunkCoord::new(side, IVec3::ZERO)))
        .collect()
}

fn culling(bench: &Bench, setting: &Setting, found: &mut Findings) {
    let space = setting.space.as_ref();
    let projection = cases::projection();
    let mut rng = Numbers::new(101);
    let (mut kept, mut wasted, mut visible) = (0_u64, 0_u64, 0_u64);
    let (mut wrong, mut straight_wrong) = (0_u64, 0_u64);
    let mut at = String::new();
    for _ in 0..bench.effort.count(40) {
        let eye = standing(&mut rng, setting);
        let frustum = space.frustum(&eye, &projection);
        let straight = Euclidean.frustum(&eye, &projection);
        for chunk in chunks_about(space, &eye) {
            let shown = shows(space, &eye, chunk, if bench.effort.quick { 6 } else { 9 });
            let (min, max) = (chunk.min(), chunk.max());
            let ours = frustum
                .cell_seen(space, &eye, chunk.chart, min, max)
                .is_some();
            let textbook = straight
                .cell_seen(&Euclidean, &eye, chunk.chart, min, max)
                .is_some();
            visible += u64::from(shown);
            kept += u64::from(ours);
            wasted += u64::from(ours && !shown);
            straight_wrong += u64::from(shown && !textbook);
            if shown && !ours {
                wrong += 1;
                at = format!("eye {eye:?}, {chunk:?}");
            }
        }
    }
    let share = |part: u64, of: u64| 100.0 * part as f64 / of.max(1) as f64;
    let worst = |error: f64, count: u64, at: String| Worst {
        error,
        at,
        bad: 0,
        count,
    };
    let row = |quantity, ours, bar, naive| Row {
        quantity,
        range: setting.name.clone(),
        arithmetic: Arithmetic::Double,
        unit: "%",
        ours: Some(ours),
        bar,
        naive,
    };
    let textbook = worst(share(straight_wrong, visible), visible, String::new());
    let ours = worst(share(wrong, visible), visible, at);
    found.rows.push(row(
        "chunks wrongly culled",
        ours,
        Some(0.0),
        Some(textbook),
    ));
    let waste = worst(share(wasted, kept), kept, String::new());
    found
        .rows
        .push(row("chunks kept for nothing", waste, None, None));
}
