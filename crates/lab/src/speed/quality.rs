//! What the qualities draw of the fixed scene in every space and map, what that costs, and how far their pictures are
//! from the exact one.

use antipode_geometry::{Geometry, HyperbolicMap};
use antipode_render::Gpu;
use antipode_scene::frame::{Frame, Quality};

use crate::speed::pictures::{Difference, Picture};
use crate::speed::scenes::Look;
use crate::speed::stage::{Stage, Taken, race};
use crate::{Cell, Effort, LabError, Plot, SPACES, Scale, Series, Table};

/// The looks at the highest curvature that there is, in both maps.
const MOST_CURVED: [&str; 2] = [
    "hyperbolic, raised, offset 20 m",
    "hyperbolic, horizon, dial 20",
];
/// Share of the flat view's triangles that the most curved ones may draw.
const MOST_TRIANGLES: f64 = 0.5;
/// Share of the land's pixels that may differ visibly from the exact picture.
const MOST_DIFFERING: f64 = 1e-3;

/// Every space and map, in the dial's settings that matter.
fn looks(geometry: Geometry) -> Vec<Look> {
    let (raised, horizon) = (HyperbolicMap::Raised, HyperbolicMap::Horizon);
    match geometry {
        Geometry::Euclidean => vec![
            Look::flat("euclidean"),
            Look::bent("euclidean, bent by 10", 10.0),
            Look::bent("euclidean, bent by -10", -10.0),
        ],
        Geometry::Hyperbolic => vec![
            Look::hyperbolic("hyperbolic, raised, offset 10 m", raised, 10.0),
            Look::hyperbolic("hyperbolic, raised, offset 20 m", raised, 20.0),
            Look::hyperbolic("hyperbolic, horizon, dial 10", horizon, 10.0),
            Look::hyperbolic("hyperbolic, horizon, dial 20", horizon, 20.0),
        ],
        Geometry::Spherical => vec![Look::spherical("spherical")],
        Geometry::HyperbolicWorld => Vec::new(),
    }
}

/// One look in one quality.
struct Entry {
    look: &'static str,
    quality: Quality,
    taken: Taken,
    difference: Difference,
}

/// What each quality draws and costs, and the bars on balanced.
///
/// # Errors
/// When the adapter fails.
pub fn tables(
    gpu: &Gpu,
    frames: &[Frame],
    size: (u32, u32),
    effort: Effort,
) -> Result<([Table; 2], Plot), LabError> {
    let mut entries = Vec::new();
    for (geometry, frame) in SPACES.into_iter().zip(frames) {
        entries.extend(of_world(gpu, &looks(geometry), frame, size, effort)?);
    }
    Ok(([costs(&entries), bars(&entries)], plot(&entries)))
}

fn of_world(
    gpu: &Gpu,
    looks: &[Look],
    frame: &Frame,
    size: (u32, u32),
    effort: Effort,
) -> Result<Vec<Entry>, LabError> {
    let with = |look: &Look| {
        Quality::ALL.map(|quality| look.at(frame).with_view(|it| it.quality = quality))
    };
    let (mut stages, taken) = race(gpu, size, looks.iter().flat_map(with).collect(), effort)?;
    let mut entries = Vec::new();
    let worlds = stages
        .chunks_mut(Quality::ALL.len())
        .zip(taken.chunks(Quality::ALL.len()));
    for (look, (stages, taken)) in looks.iter().zip(worlds) {
        let differences = differences(stages, &look.at(frame), size.0)?;
        for ((quality, taken), difference) in Quality::ALL.into_iter().zip(taken).zip(differences) {
            entries.push(Entry {
                look: look.name,
                quality,
                taken: *taken,
                difference,
            });
        }
    }
    Ok(entries)
}

/// How each stage's last picture differs from the last stage's, which is the exact one.
fn differences(
    stages: &mut [Stage<'_>],
    frame: &Frame,
    width: u32,
) -> Result<Vec<Difference>, LabError> {
    let mut pictures = Vec::new();
    for stage in &*stages {
        pictures.push(Picture::last(stage, width)?);
    }
    let (Some(stage), Some(exact)) = (stages.last_mut(), pictures.last()) else {
        return Ok(Vec::new());
    };
    let empty = Picture::without_land(stage, frame, width)?;
    Ok(pictures
        .iter()
        .map(|own| exact.difference(own, &empty))
        .collect())
}

fn costs(entries: &[Entry]) -> Table {
    let rows = entries.chunks(Quality::ALL.len()).flat_map(|of_look| {
        let exact = of_look.last();
        of_look.iter().map(move |entry| {
            let plan = &entry.taken.stats.plan;
            vec![
                Cell::text(entry.look),
                Cell::text(entry.quality.name()),
                Cell::figure(entry.taken.cost_ms, "ms"),
                exact.map_or(Cell::Empty, |e| {
                    Cell::figure(entry.taken.cost_ms / e.taken.cost_ms, "")
                }),
                Cell::count(entry.taken.stats.triangles),
                Cell::count(plan.triangles_hidden),
                Cell::count(plan.triangles_small),
                Cell::figure(plan.error_px, "px"),
                Cell::percent(entry.difference.differing, entry.difference.land),
            ]
        })
    });
    let columns = [
        "space and map",
        "quality",
        "cost",
        "to exact",
        "triangles",
        "hidden",
        "too small",
        "largest error by the bounds",
        "land's pixels that differ from exact",
    ];
    Table::new("The fixed scene in each quality", columns, rows)
}

/// Cost across, the largest error upwards: a line for each look, from fast to exact.
fn plot(entries: &[Entry]) -> Plot {
    let line = |of_look: &[Entry]| {
        Series::line(
            of_look[0].look,
            of_look
                .iter()
                .map(|e| (e.taken.cost_ms, e.taken.stats.plan.error_px)),
        )
    };
    Plot::new(
        "speed-quality",
        "The qualities: fast, balanced and exact, from the left",
        Scale::Logarithmic.axes("cost of a frame, ms", "largest error by the bounds, px"),
        entries.chunks(Quality::ALL.len()).map(line),
    )
}

/// The bars on balanced: the picture everywhere, and the triangles at the highest curvature.
fn bars(entries: &[Entry]) -> Table {
    let balanced = || entries.iter().filter(|e| e.quality == Quality::Balanced);
    let flat = balanced().next().map_or(0, |e| e.taken.stats.triangles);
    let rows = balanced().map(|entry| {
        let found = &entry.difference;
        let share = entry.taken.stats.triangles as f64 / flat.max(1) as f64;
        vec![
            Cell::text(entry.look),
            Cell::count(entry.taken.stats.triangles),
            Cell::figure(share, ""),
            if MOST_CURVED.contains(&entry.look) {
                Cell::Verdict(share <= MOST_TRIANGLES)
            } else {
                Cell::Empty
            },
            Cell::percent(found.differing, found.land),
            Cell::count(found.off_edge),
            Cell::Verdict(
                found.differing as f64 <= MOST_DIFFERING * found.land as f64 && found.off_edge == 0,
            ),
        ]
    });
    let columns = [
        "space and map, balanced",
        "triangles",
        "to the flat view",
        "at most half",
        "land's pixels that differ from exact",
        "of them off every edge",
        "at most 0.1 %, all at edges",
    ];
    Table::new(
        "Balanced against the flat view and against exact",
        columns,
        rows,
    )
}
