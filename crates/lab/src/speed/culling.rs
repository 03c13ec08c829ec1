//! What it costs to tell whether a chunk is in the picture, and how often the answer is wrong: the game's cells of
//! directions, a flat frustum on the chart's boxes, and drawing everything.

use std::sync::Arc;

use antipode_geometry::{
    CHUNK_CELLS, ChartId, ChartPoint, Eye, Geometry, HyperbolicMap, Projection, Strategy, picture,
    strategy,
};
use glam::DVec3;

use crate::random::Numbers;
use crate::speed::clock::race;
use crate::speed::pareto::{Group, Variant};
use crate::{Cell, Effort, Table};

/// Points along each edge of a box that decide whether it is seen.
const SAMPLES: u32 = 9;
/// Level distance of the chunks, in chunks, and least and greatest height of their land over its corner, metres.
const REACH: i32 = 6;
const LAND_M: (f64, f64) = (4.0, 14.0);
const SPHERE_RADIUS_M: f64 = 32.0;

/// A space, an eye in it, and chunks around.
struct Case {
    space: Arc<dyn Strategy>,
    eye: Eye,
    boxes: Vec<(ChartId, DVec3, DVec3)>,
}

fn projection() -> Projection {
    Projection::new(75_f64.to_radians(), 16.0 / 9.0, 0.02)
}

fn cases(space: &Arc<dyn Strategy>, dial: f64, count: usize) -> Vec<Case> {
    let mut numbers = Numbers::new(61);
    let closed = space.domain(ChartId::FIRST).radius_m();
    let one = |_| {
        let (ground_m, reach) = match closed {
            Some(rim_m) => (
                0.3 * SPHERE_RADIUS_M,
                (rim_m / f64::from(CHUNK_CELLS)).ceil() as i32,
            ),
            None => (0.0, REACH),
        };
        let level = numbers.turn() * numbers.between(0.0, 30.0);
        let eye = Eye {
            point: ChartPoint::a(DVec3::new(level.x, ground_m + 3.0, level.y)),
            yaw: numbers.between(-3.1, 3.1),
            pitch: numbers.between(-0.6, 0.4),
            roll: 0.0,
            dial,
            lift_m: 1.65,
        };
        let charts: &[_] = if closed.is_some() {
            &[ChartId::FIRST, ChartId::SECOND]
        } else {
            &[ChartId::FIRST]
        };
        let mut boxes = Vec::new();
        for &chart in charts {
            for x in -reach..reach {
                for z in -reach..reach {
                    let edge = f64::from(CHUNK_CELLS);
                    let height = numbers.between(LAND_M.0, LAND_M.1);
                    let min = DVec3::new(
                        f64::from(x) * edge,
                        ground_m - 0.5 * height,
                        f64::from(z) * edge,
                    );
                    boxes.push((chart, min, min + DVec3::new(edge, height, edge)));
                }
            }
        }
        Case {
            space: Arc::clone(space),
            eye,
            boxes,
        }
    };
    (0..count).map(one).collect()
}

/// Whether any of the samples is in the picture.
fn seen(case: &Case, chart: ChartId, min: DVec3, max: DVec3) -> bool {
    let projection = projection();
    let rim_m = case
        .space
        .domain(ChartId::FIRST)
        .radius_m()
        .unwrap_or(f64::INFINITY);
    let limit_m = case.space.sight_limit_m(&case.eye);
    let step = (max - min) / f64::from(SAMPLES - 1);
    (0..SAMPLES.pow(3)).any(|i| {
        let at = [i % SAMPLES, i / SAMPLES % SAMPLES, i / (SAMPLES * SAMPLES)];
        let pos = min + step * DVec3::from_array(at.map(f64::from));
        if pos.x.hypot(pos.z) > rim_m {
            return false;
        }
        let view = case
            .space
            .view_point(&case.eye, ChartPoint::new(chart, pos));
        let clip = case.space.clip_from_view(&case.eye, &projection, view);
        Projection::screen(clip).is_some_and(|s| s.abs().max_element() <= 1.0)
            && case.space.eye_distance_m(&case.eye, view) <= limit_m
    })
}

type Test = fn(&Case) -> Vec<bool>;

fn by_cells(case: &Case) -> Vec<bool> {
    let space = case.space.as_ref();
    let frustum = space.frustum(&case.eye, &projection());
    let one = |&(chart, min, max): &_| {
        frustum
            .cell_seen(space, &case.eye, chart, min, max)
            .is_some()
    };
    case.boxes.iter().map(one).collect()
}

fn by_whole_cells(case: &Case) -> Vec<bool> {
    let space = case.space.as_ref();
    let frustum = space.frustum(&case.eye, &projection());
    let one = |&(chart, min, max): &_| frustum.sees(&space.sight_cell(&case.eye, chart, min, max));
    case.boxes.iter().map(one).collect()
}

/// The boxes as they lie in the chart of the eye's hemisphere, against an ordinary frustum. What lies in the other
/// chart is taken to where it would be if the charts were laid out rim to rim.
fn by_flat_frustum(case: &Case) -> Vec<bool> {
    let projection = projection();
    let away = case.space.domain(ChartId::FIRST).radius_m().unwrap_or(0.0) * 2.0;
    let sides = [
        DVec3::new(projection.sx, 0.0, -1.0),
        DVec3::new(-projection.sx, 0.0, -1.0),
        DVec3::new(0.0, projection.sy, -1.0),
        DVec3::new(0.0, -projection.sy, -1.0),
    ];
    let sides = sides.map(|s| case.eye.to_chart(s.normalize_or_zero()));
    let one = |&(chart, min, max): &(ChartId, DVec3, DVec3)| {
        let shift = if chart == case.eye.point.chart {
            DVec3::ZERO
        } else {
            DVec3::X * away
        };
        let (middle, half) = (
            0.5 * (min + max) + shift - case.eye.point.pos,
            0.5 * (max - min),
        );
        !sides
            .iter()
            .any(|s| s.dot(middle) + s.abs().dot(half) < 0.0)
    };
    case.boxes.iter().map(one).collect()
}

fn none(case: &Case) -> Vec<bool> {
    case.boxes.iter().map(|_| true).collect()
}

const TESTS: [(&str, &str, Test); 4] = [
    (
        "cells of directions, wide ones in parts",
        "processor",
        by_cells,
    ),
    ("cells of directions, whole", "", by_whole_cells),
    ("flat frustum on chart boxes", "", by_flat_frustum),
    ("none", "", none),
];

/// How often a test was wrong.
#[derive(Clone, Copy, Debug, Default)]
struct Wrong {
    culled: usize,
    kept: usize,
}

/// The spaces, with the dial's value.
fn spaces() -> [(&'static str, &'static str, Arc<dyn Strategy>, f64); 4] {
    let horizon = picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Horizon, false);
    [
        (
            "culling-raised",
            "raised map, offset 10 m",
            strategy(Geometry::Hyperbolic, 20.0),
            10.0,
        ),
        (
            "culling-raised-20",
            "raised map, offset 20 m",
            strategy(Geometry::Hyperbolic, 20.0),
            20.0,
        ),
        ("culling-horizon", "horizon map, dial 10", horizon, 10.0),
        (
            "culling-sphere",
            "sphere of radius 32 m",
            strategy(Geometry::Spherical, SPHERE_RADIUS_M),
            0.0,
        ),
    ]
}

/// A group for each space, and the table that says which test was wrong, and how.
pub fn groups(effort: Effort) -> (Vec<Group>, Table) {
    let mut rows = Vec::new();
    let mut groups = Vec::new();
    for (id, name, space, dial) in spaces() {
        let cases = cases(&space, dial, if effort.quick { 20 } else { 100 });
        let truth: Vec<Vec<bool>> = cases
            .iter()
            .map(|case| {
                case.boxes
                    .iter()
                    .map(|b| seen(case, b.0, b.1, b.2))
                    .collect()
            })
            .collect();
        let (variants, wrongs) = compete(&cases, &truth, effort);
        let total: usize = truth.iter().map(Vec::len).sum();
        let shown: usize = truth.iter().flatten().filter(|s| **s).count();
        for (variant, wrong) in variants.iter().zip(wrongs) {
            rows.push(vec![
                Cell::text(name),
                Cell::text(&variant.name),
                Cell::figure(variant.ns, "ns"),
                Cell::percent(wrong.culled, shown),
                Cell::percent(wrong.kept, total - shown),
                if variant.used.is_empty() {
                    Cell::Empty
                } else {
                    Cell::Verdict(wrong.culled == 0)
                },
            ]);
        }
        groups.push(Group {
            id,
            title: format!("Whether a chunk is in the picture: {name}"),
            error: "chunks judged wrongly either way",
            unit: "%",
            variants,
        });
    }
    (groups, table(rows))
}

fn table(rows: Vec<Vec<Cell>>) -> Table {
    let columns = [
        "space",
        "test",
        "time per chunk",
        "seen chunks left out",
        "unseen chunks drawn",
        "the game leaves none out",
    ];
    Table::new("Culling: who is wrong, and which way", columns, rows)
}

fn compete(cases: &[Case], truth: &[Vec<bool>], effort: Effort) -> (Vec<Variant>, Vec<Wrong>) {
    let total: usize = truth.iter().map(Vec::len).sum();
    let mut batches: Vec<Box<dyn FnMut() + '_>> = Vec::new();
    for (_, _, test) in TESTS {
        batches.push(Box::new(move || {
            for case in cases {
                std::hint::black_box(test(std::hint::black_box(case)));
            }
        }));
    }
    let times = race(&mut batches, total, effort);
    let mut variants = Vec::new();
    let mut wrongs = Vec::new();
    for ((name, used, test), ns) in TESTS.into_iter().zip(times) {
        let mut wrong = Wrong::default();
        for (case, truth) in cases.iter().zip(truth) {
            for (said, is) in test(case).into_iter().zip(truth) {
                wrong.culled += usize::from(*is && !said);
                wrong.kept += usize::from(!*is && said);
            }
        }
        let error = 100.0 * (wrong.culled + wrong.kept) as f64 / total.max(1) as f64;
        variants.push(Variant {
            name: name.to_owned(),
            ns,
            error,
            not_numbers: 0,
            used,
        });
        wrongs.push(wrong);
    }
    (variants, wrongs)
}
