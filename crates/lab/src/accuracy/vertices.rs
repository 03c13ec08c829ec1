//! The picture itself: projected vertices of the shaders against the `f64` reference, in pixels.

use antipode_geometry::{ChartPoint, ChunkCoord, Eye};
use glam::{DVec2, DVec3};

use super::cases::{self, HEIGHT, Setting, WIDTH};
use super::curvature::pixel;
use super::errors::words;
use super::picture::{seen_point, standing};
use super::row::Subject;
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::error::LabError;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "100 random cameras in each space and map, and vertices of chunks all around each. A vertex goes the way the game sends it: the chunk's corner from the whole metres next to the camera, to which the shader adds the place in the chunk and takes off the rest of a metre. Those in the picture of 1280 by 720 with a vertical field of view of 75 degrees are compared with the f64 port of the same vertex; the worst vertex is given with its camera. Nothing may be off by half a pixel.",
    "The textbook column keeps world positions in f32, 10 km from the origin at most, and does everything else exactly.",
];

/// Nothing that can be seen.
const HALF_PIXEL: f64 = 0.5;

fn settings() -> Vec<Setting> {
    let mut all = vec![cases::flat()];
    all.extend([0.5, 10.0, 20.0].map(cases::raised));
    all.extend([0.5, 10.0, 20.0].map(cases::horizon));
    all.extend([-20.0, -2.0, 2.0, 20.0].map(cases::bent));
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
    let local = (wanted.pos - chunk.origin()).as_vec3();
    let point = ChartPoint::new(wanted.hemisphere, chunk.origin() + local.as_dvec3());
    let place = |point| {
        let view = space.view_point(eye, point);
        pixel(space.clip_from_view(eye, &cases::projection(), view)).map(|at| (view, at))
    };
    let (view, at) = place(point)?;
    let trimmed = space.trims(eye, point.hemisphere, point.pos, point.pos);
    if trimmed || space.eye_distance_m(eye, view) > space.sight_limit_m(eye) {
        return None;
    }
    let reference = space.reference(eye, point.hemisphere);
    let mut case = cases::case(space, eye, point, DVec3::Y);
    case.p = cases::sent(space, eye, chunk, local);
    let world = (point.pos.as_vec3() - reference.as_vec3()).as_dvec3();
    let textbook = place(ChartPoint::new(point.hemisphere, reference + world));
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
        seen.point.hemisphere
    )
}

fn measure(bench: &Bench, setting: &Setting) -> Result<[Row; 1], LabError> {
    let mut rng = Numbers::new(109);
    let mut all = Vec::new();
    for _ in 0..POSES {
        let eye = standing(&mut rng, setting);
        let some = (0..bench.effort.count(10_000)).filter_map(|_| sent(&mut rng, setting, &eye));
        all.extend(some);
    }
    let mut textbook = Worst::default();
    for seen in &all {
        if let Some(there) = seen.textbook {
            textbook.note((there - seen.at).length(), || words_of(seen));
        }
    }
    let list: Vec<cases::Case> = all.iter().map(|seen| seen.case).collect();
    let ours = cases::answers(bench.gpu.as_ref(), &list)?.map(|answers| {
        let mut worst = Worst::default();
        for (answer, seen) in answers.iter().zip(&all) {
            let clip = answer.clip.as_dvec4();
            let there = DVec2::new(clip.x, clip.y) / clip.w * DVec2::new(0.5 * WIDTH, 0.5 * HEIGHT);
            worst.note((there - seen.at).length(), || words_of(seen));
        }
        worst
    });
    let subject = Subject {
        quantity: "projected vertices",
        range: format!("{}, {POSES} cameras", setting.name),
        unit: "px",
        naive: Some(textbook),
    };
    Ok(subject.rows([(Arithmetic::Gpu, ours, HALF_PIXEL)]))
}
