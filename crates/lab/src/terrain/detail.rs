//! Levels of detail: what is resident and what is drawn by view distance, and what a strong bend leaves.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use antipode_geometry::{ChartPoint, ChunkCoord, Geometry, HyperbolicMap};
use antipode_render::Gpu;
use antipode_scene::Scene;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::FOV_Y_RAD;
use antipode_terrain::Level;
use glam::{DVec3, IVec3};

use super::engine::{name, open, settle};
use super::row::{Bar, Judged, Row, table};
use crate::speed::stage::Stage;
use crate::{Effort, LabError, SPACES, Section};

/// The view distances compared, chunks.
const NEAR: u32 = 6;
const FAR: u32 = 16;
/// Times the triangles of the near one that the far one may have.
const TIMES: f64 = 2.0;
/// Size of the picture.
const SIZE: (u32, u32) = (1280, 720);
/// Longest wait for the land.
const PATIENCE: Duration = Duration::from_mins(3);
/// Most pictures until everything is on the adapter: sending is budgeted.
const MOST_PICTURES: usize = 200;
/// What spans less than this is not loaded, pixels.
const LEAST_PX: f64 = 0.5;

/// A world seen from where a new player stands.
struct View {
    seconds: f64,
    chunks: usize,
    triangles: usize,
    /// Chunks by level.
    levels: [usize; 4],
    /// Chunks that span less than half a pixel or lie beyond what is drawn at all.
    needless: usize,
    /// Triangles and draws of a picture, where there is an adapter.
    drawn: Option<(f64, f64)>,
}

/// The section of levels of detail; without an adapter nothing is drawn. A quick run looks at the near view distance
/// only.
///
/// # Errors
/// When a world cannot be opened or its land is not made, or the adapter fails.
pub fn section(effort: Effort, gpu: Option<&Gpu>) -> Result<Section, LabError> {
    let mut rows = Vec::new();
    for geometry in SPACES {
        let near = look(open(geometry, NEAR, None)?, gpu)?;
        rows.extend(rows_of(&case(geometry, NEAR), &near));
        if !effort.quick {
            let far = look(open(geometry, FAR, None)?, gpu)?;
            rows.extend(rows_of(&case(geometry, FAR), &far));
            rows.extend(ratios(geometry, &near, &far));
        }
    }
    if !effort.quick {
        for map in HyperbolicMap::ALL {
            rows.extend(bent(map, gpu)?);
        }
    }
    Ok(Section::new(
        "terrain-detail",
        "Levels of detail",
        METHOD,
        [table("Resident and drawn", &rows, effort)],
    ))
}

fn case(geometry: Geometry, view_distance: u32) -> String {
    format!("{}, view distance {view_distance}", name(geometry))
}

fn rows_of(case: &str, view: &View) -> Vec<Row> {
    let levels = Level::ALL.iter().zip(view.levels);
    let levels: Vec<String> = levels
        .map(|(level, count)| format!("{count} of {} m", level.step_m()))
        .collect();
    let drawn = |of: fn((f64, f64)) -> f64| view.drawn.map(of);
    vec![
        Row::new("chunks resident", case, view.chunks as f64, "").note(levels.join(", ")),
        Row::new(
            "triangles resident",
            case,
            view.triangles as f64 * 1e-3,
            "thousand",
        ),
        Row::new("triangles drawn", case, drawn(|d| d.0 * 1e-3), "thousand"),
        Row::new("draws", case, drawn(|d| d.1), ""),
        Row::new("time until everything stands", case, view.seconds, "s"),
    ]
}

fn ratios(geometry: Geometry, near: &View, far: &View) -> Vec<Row> {
    let case = format!("{}, view distance {FAR} to {NEAR}", name(geometry));
    let row = |what: &str, times: Option<f64>| {
        Row::new(what, &case, times, "").bar(Bar::AtMost(TIMES), Judged::Always)
    };
    let drawn = near.drawn.zip(far.drawn).map(|(near, far)| far.0 / near.0);
    let resident = far.triangles as f64 / near.triangles as f64;
    vec![
        row("triangles resident, times", Some(resident)),
        row("triangles drawn, times", drawn),
    ]
}

/// A hyperbolic world with the dial at its end, as far as one may look.
fn bent(map: HyperbolicMap, gpu: Option<&Gpu>) -> Result<Vec<Row>, LabError> {
    let mut scene = open(Geometry::Hyperbolic, FAR, None)?;
    let most = scene.lens().range().map_or(0.0, |(_, most)| most);
    if !(scene.set_map(map) && scene.set_curvature(most)) {
        return Err(LabError::Scene("the dial could not be set".to_owned()));
    }
    let view = look(scene, gpu)?;
    let map = format!("{map:?}").to_lowercase();
    let case = format!("hyperbolic, {map} map, dial {most}, view distance {FAR}");
    let mut rows = rows_of(&case, &view);
    rows.push(
        Row::new(
            "chunks loaded that span less than half a pixel",
            &case,
            view.needless as f64,
            "",
        )
        .bar(Bar::AtMost(0.0), Judged::Always),
    );
    Ok(rows)
}

fn look(mut scene: Scene, gpu: Option<&Gpu>) -> Result<View, LabError> {
    let began = Instant::now();
    settle(&mut scene, PATIENCE)?;
    let seconds = began.elapsed().as_secs_f64();
    let (width, height) = SIZE;
    let frame = scene.frame(FOV_Y_RAD, f64::from(width) / f64::from(height), 1);
    let meshes = frame
        .content
        .land
        .meshes()
        .filter(|(_, mesh)| !mesh.is_empty());
    let meshes: BTreeMap<_, _> = meshes.collect();
    let mut levels = [0; 4];
    for mesh in meshes.values() {
        levels[mesh.level.index()] += 1;
    }
    let needless = meshes.keys().filter(|coord| is_needless(&frame, **coord));
    Ok(View {
        seconds,
        chunks: meshes.len(),
        triangles: meshes.values().map(|mesh| mesh.triangles().len()).sum(),
        levels,
        needless: needless.count(),
        drawn: gpu.map(|gpu| drawn(gpu, &frame)).transpose()?,
    })
}

/// Whether a chunk's box, wherever one looks, spans less than half a pixel, or lies beyond the farthest drawn.
fn is_needless(frame: &Frame, coord: ChunkCoord) -> bool {
    let (space, eye) = (&*frame.view.strategy, &frame.view.eye);
    let mut nearest_m = f64::INFINITY;
    let mut directions = Vec::new();
    for place in 0..27 {
        let step = IVec3::new(place % 3, place / 3 % 3, place / 9).as_dvec3();
        let point = ChartPoint::new(coord.chart, coord.origin() + 16.0 * step);
        let view = space.view_point(eye, point);
        nearest_m = nearest_m.min(space.eye_distance_m(eye, view));
        directions.push(view.truncate().normalize_or(DVec3::NEG_Z));
    }
    let spread = |from: &DVec3| {
        let chords = directions.iter().map(|to| from.distance(*to));
        chords.fold(0.0, f64::max)
    };
    let span_rad = directions.iter().map(spread).fold(0.0, f64::max);
    // At the picture's middle, where a radian has the fewest pixels.
    let px_per_rad = 0.5 * f64::from(SIZE.1) / (0.5 * FOV_Y_RAD).tan();
    nearest_m > space.sight_limit_m(eye) || span_rad * px_per_rad < LEAST_PX
}

/// Triangles and draws of a picture, once everything is on the adapter.
fn drawn(gpu: &Gpu, frame: &Frame) -> Result<(f64, f64), LabError> {
    let mut stage = Stage::new(gpu, SIZE)?;
    let mut last = stage.draw(frame)?.stats;
    for _ in 0..MOST_PICTURES {
        let next = stage.draw(frame)?.stats;
        if next.triangles == last.triangles && next.triangles > 0 {
            break;
        }
        last = next;
    }
    Ok((last.triangles as f64, last.draws as f64))
}

const METHOD: [&str; 2] = [
    "A new world is opened and loaded to its end with the default quality; the player looks along the land. Resident are the triangles of all chunks that are there, drawn those of one picture of 1280 by 720 pixels. A closed world is resident whole at any view distance.",
    "With the hyperbolic dial at its end, 27 points of each resident chunk's box are taken through the map: a chunk whose box spans less than half a pixel wherever one looks, or that lies beyond the farthest distance drawn, should not have been loaded.",
];
