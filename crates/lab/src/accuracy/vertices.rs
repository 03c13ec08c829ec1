//! The picture itself: projected vertices of the shaders against the `f64` reference, in pixels.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord, Eye};
use antipode_render::{ChunkChoice, ChunkLand, Ground, Port, plan};
use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3, Vec4};

use super::cases::{self, HEIGHT, Setting, WIDTH};
use super::curvature::pixel;
use super::errors::words;
use super::picture::{seen_point, standing};
use super::row::Subject;
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::compute;
use crate::error::LabError;
use crate::figure::number;
use crate::random::Numbers;
use crate::scene_frame;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "100 random cameras in each space and map, and vertices of chunks all around each. A vertex goes the way the game sends it: the chunk's corner from the whole metres next to the camera, to which the shader adds the place in the chunk and takes off the rest of a metre. Those in the picture of 1280 by 720 with a vertical field of view of 75 degrees are compared with the f64 port of the same vertex; the worst vertex is given with its camera. Nothing may be off by half a pixel.",
    "Each vertex goes through the full port first, and then the way the planner chooses at balanced: where one first-order matrix for the whole chunk stays within the tolerance, through that one, with the planner's matrix and the shader's arithmetic. A chunk is taken for a slab of 32 m by 4 m about the vertex, as thin as land is, so that the planner is tempted. The range says how many vertices went by a matrix.",
    "The textbook column keeps world positions in f32, 10 km from the origin at most, and does everything else exactly.",
];

/// Nothing that can be seen.
const HALF_PIXEL: f64 = 0.5;
/// Units of a mesh's positions.
const GRID_PER_M: f32 = antipode_terrain::PARTS_PER_M as f32;
/// How high a chunk's land is taken for, metres.
const SLAB_M: f64 = 4.0;

fn settings() -> Vec<Setting> {
    let mut all = vec![cases::flat()];
    all.extend([0.5, 10.0, 20.0].map(cases::raised));
    all.extend([0.5, 10.0, 20.0].map(cases::horizon));
    all.extend([-20.0, -2.0, 2.0, 20.0].map(cases::bent));
    // On the way through flat: so little bent, chunks are ported by a matrix.
    all.extend([-0.01, 0.01].map(cases::bent));
    all.push(cases::horizon(0.01));
    all.extend([16.0, 32.0, 64.0].map(cases::sphere));
    all
}

/// Runs every space and map.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for setting in settings() {
        found.rows.extend(measure(bench, &setting)?);
    }
    Ok(found)
}

/// Cameras for each space and map.
const POSES: usize = 100;

/// A vertex as it is sent, where it truly is in the picture, and where the textbook has it.
struct Seen {
    eye: Eye,
    point: ChartPoint,
    case: cases::Case,
    at: DVec2,
    textbook: Option<DVec2>,
}

/// Sends one vertex the way the game does, if it is in the picture.
fn sent(rng: &mut Numbers, setting: &Setting, eye: &Eye) -> Option<Seen> {
    let space = setting.space.as_ref();
    let wanted = seen_point(rng, setting, eye);
    let chunk = ChunkCoord::containing(wanted);
    // Land's vertices lie on a grid.
    let local = ((wanted.pos - chunk.origin()).as_vec3() * GRID_PER_M).round() / GRID_PER_M;
    let point = ChartPoint::new(wanted.chart, chunk.origin() + local.as_dvec3());
    let place = |point| {
        let view = space.view_point(eye, point);
        pixel(space.clip_from_view(eye, &cases::projection(), view)).map(|at| (view, at))
    };
    let (view, at) = place(point)?;
    let trimmed = space.trims(eye, point.chart, point.pos, point.pos);
    if trimmed || space.eye_distance_m(eye, view) > space.sight_limit_m(eye) {
        return None;
    }
    let reference = space.reference(eye, point.chart);
    let mut case = cases::case(space, eye, point, DVec3::Y);
    case.p = cases::sent(space, eye, chunk, local);
    let world = (point.pos.as_vec3() - reference.as_vec3()).as_dvec3();
    let textbook = place(ChartPoint::new(point.chart, reference + world));
    Some(Seen {
        eye: *eye,
        point,
        case,
        at,
        textbook: textbook.map(|(_, at)| at),
    })
}

fn words_of(seen: &Seen) -> String {
    format!(
        "camera {} m, yaw {:.4}, pitch {:.4}; vertex {} m in {:?}",
        words(seen.eye.point.pos),
        seen.eye.yaw,
        seen.eye.pitch,
        words(seen.point.pos),
        seen.point.chart
    )
}

fn measure(bench: &Bench, setting: &Setting) -> Result<Vec<Row>, LabError> {
    let mut rng = Numbers::new(109);
    let (mut all, mut framed) = (Vec::new(), Vec::new());
    for _ in 0..POSES {
        let eye = standing(&mut rng, setting);
        let some = (0..bench.effort.count(10_000)).filter_map(|_| sent(&mut rng, setting, &eye));
        let first = all.len();
        all.extend(some);
        let chosen = matrices(setting, &eye, &all[first..]);
        framed.extend(chosen.into_iter().map(|(i, matrix)| (first + i, matrix)));
    }
    let mut textbook = Worst::default();
    for seen in &all {
        if let Some(there) = seen.textbook {
            textbook.note((there - seen.at).length(), || words_of(seen));
        }
    }
    let Some([ported, planned]) = on_adapter(bench, &all, &framed)? else {
        return Ok(rows(setting, None, 0.0, &textbook));
    };
    let share = 100.0 * framed.len() as f64 / all.len().max(1) as f64;
    Ok(rows(setting, Some([ported, planned]), share, &textbook))
}

fn rows(setting: &Setting, worst: Option<[Worst; 2]>, share: f64, textbook: &Worst) -> Vec<Row> {
    let (ported, planned) = worst.map(|[a, b]| (a, b)).unzip();
    let subject = |quantity, range| Subject {
        quantity,
        range,
        unit: "px",
        naive: Some(textbook.clone()),
    };
    let name = &setting.name;
    let each = subject("projected vertices", format!("{name}, {POSES} cameras"));
    let range = format!("{name}, {POSES} cameras, {} % by a matrix", number(share));
    let chosen = subject("projected vertices, as balanced ports them", range);
    let mut rows = each.rows([(Arithmetic::Gpu, ported, HALF_PIXEL)]).to_vec();
    rows.extend(chosen.rows([(Arithmetic::Gpu, planned, HALF_PIXEL)]));
    rows
}

/// The shader's matrix of a chunk: the view of the reference, and per metre along x, y and z.
type Matrix = [[f32; 4]; 4];

/// Which of one eye's vertices the planner ports by a matrix at balanced, and by which.
fn matrices(setting: &Setting, eye: &Eye, all: &[Seen]) -> Vec<(usize, Matrix)> {
    let land: Vec<ChunkLand> = all.iter().map(slab).collect();
    let planned = plan(
        &scene_frame::bare(Arc::clone(&setting.space), eye),
        HEIGHT as u32,
        &land,
    );
    let matrix = |chunk: ChunkChoice| match chunk.port {
        Port::Frame(map) => {
            let [x, y, z] = map.columns;
            let rows = [map.base, x, y, z].map(|v| v.as_vec4().to_array());
            Some((chunk.place, rows))
        }
        Port::Vertex => None,
    };
    planned.chunks.into_iter().filter_map(matrix).collect()
}

/// The chunk of a vertex, as if its land were level.
fn slab(seen: &Seen) -> ChunkLand {
    let coord = ChunkCoord::containing(seen.point);
    let (mut min, mut max) = (coord.min(), coord.max());
    min.y = min.y.max(seen.point.pos.y - 0.5 * SLAB_M);
    max.y = max.y.min(seen.point.pos.y + 0.5 * SLAB_M);
    ChunkLand {
        coord,
        level: antipode_terrain::Level::FULL,
        min,
        max,
        whole: [min, max],
        triangles: 1,
        error_m: 0.0,
        ground: Ground::UNKNOWN,
    }
}

/// A vertex with its chunk's matrix.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Framed {
    case: cases::Case,
    matrix: Matrix,
}

/// As `vertex_framed` of shaders/terrain.wgsl has it.
const FRAMED: &str = "let p = inputs[i].shared_case.p;
    let m = inputs[i].matrix;
    outputs[i] = clip_from_view(inputs[i].shared_case.space, m[0] + m[1] * p.x + m[2] * p.y + m[3] * p.z);";

/// How far vertices come out from their places on the adapter: each by the full port, and as planned.
fn on_adapter(
    bench: &Bench,
    all: &[Seen],
    framed: &[(usize, Matrix)],
) -> Result<Option<[Worst; 2]>, LabError> {
    let list: Vec<cases::Case> = all.iter().map(|seen| seen.case).collect();
    let (Some(gpu), Some(answers)) = (&bench.gpu, cases::answers(bench.gpu.as_ref(), &list)?)
    else {
        return Ok(None);
    };
    let types = format!(
        "{}\nstruct Framed {{ shared_case: Case, matrix: array<vec4<f32>, 4> }}",
        cases::TYPES
    );
    let shader = compute::shader(&types, "Framed", "vec4<f32>", FRAMED);
    let inputs: Vec<Framed> = framed
        .iter()
        .map(|(i, matrix)| Framed {
            case: all[*i].case,
            matrix: *matrix,
        })
        .collect();
    let by_matrix = if inputs.is_empty() {
        Vec::new()
    } else {
        compute::run_by_map::<Framed, Vec4>(gpu, &shader, &inputs, |it| it.case.map)?
    };
    let mut planned: Vec<Vec4> = answers.iter().map(|answer| answer.clip).collect();
    for ((i, _), clip) in framed.iter().zip(by_matrix) {
        planned[*i] = clip;
    }
    let [mut ported, mut chosen] = [(); 2].map(|()| Worst::default());
    for ((seen, answer), planned) in all.iter().zip(&answers).zip(planned) {
        for (clip, worst) in [(answer.clip, &mut ported), (planned, &mut chosen)] {
            let clip = clip.as_dvec4();
            let there = DVec2::new(clip.x, clip.y) / clip.w * DVec2::new(0.5 * WIDTH, 0.5 * HEIGHT);
            worst.note((there - seen.at).length(), || words_of(seen));
        }
    }
    Ok(Some([ported, chosen]))
}
