//! The section of the adapter's figures: frame times of the fixed scene and of the same triangles in every space.

use antipode_render::{AdapterChoice, Gpu};
use antipode_scene::frame::{Frame, Quality, View};

use crate::speed::scenes::{Look, Order, fixed, keep_common, looks, sphere_looks};
use crate::speed::stage::{Taken, race};
use crate::speed::{equal, lamps, quality, shadows, vertex_stage};
use crate::{Cell, Effort, LabError, SPACES, Section, Table};

/// Size of the pictures that the bar on cost is for.
const BAR_SIZE: (u32, u32) = (1280, 720);

fn size(effort: Effort) -> (u32, u32) {
    if effort.quick { (640, 360) } else { BAR_SIZE }
}

/// Frame times, in every space, of the fixed scene and of the same triangles; and the vertex stage alone.
///
/// # Errors
/// When there is no such adapter, it fails, or the scene cannot be made.
pub fn gpu_section(effort: Effort, adapter: AdapterChoice) -> Result<Section, LabError> {
    let gpu = Gpu::headless(adapter)?;
    let (width, height) = size(effort);
    let aspect = f64::from(width) / f64::from(height);
    let mut frames = Vec::new();
    for geometry in SPACES {
        frames.push(fixed(geometry, aspect)?);
    }
    let mut tables = vec![scene_table(&gpu, &frames, effort)?];
    let (open, closed) = (&frames[0], &frames[frames.len() - 1]);
    for (frame, looks, land) in [
        (open, looks(), FAR),
        (open, looks(), NEAR),
        (closed, sphere_looks(), SPHERE),
    ] {
        tables.extend(same_triangles(&gpu, frame, &looks, &land, effort)?);
    }
    tables.push(lamps::table(&gpu, &frames, effort)?);
    tables.extend(lit_triangles(&gpu, open, closed, effort)?);
    let (qualities, quality_plot) = quality::tables(&gpu, &frames, size(effort), effort)?;
    tables.extend(qualities);
    tables.push(shadows::table(&gpu, &frames, effort)?);
    let (stage, stage_plot) = vertex_stage::measured(&gpu, effort)?;
    tables.push(stage);
    Ok(Section::new(
        "speed-gpu",
        "What accuracy costs on the adapter",
        METHOD,
        tables,
    )
    .with([quality_plot, stage_plot]))
}

const METHOD: [&str; 5] = [
    "The fixed scene is seed 7 where a new player stands, heading 0.4 and elevation -0.08 radians, view distance 6, made by the game itself, at 1280x720; a quick run draws it at 640x360, but for the tables of the same triangles. Frames are drawn in turns, to and fro, interleaved in one run; the cost of a frame is the least of several rounds' medians.",
    "The cost is a graphics card's own time by timestamps. A software adapter draws on the processor, so there it is the time that all threads worked, which other programs do not add to; where neither can be told it is the wall clock's. The wall clock is shown beside it: from the first command to the last pixel; planning and recording on the main thread is a part of it.",
    "For the same triangles, the land of one world is drawn through every map. At 1280x720 chunks that any map hides, trims or divides are left out, and so is the fog, so that every map draws each triangle once; the picture they cover still differs, and with it the number of pixels shaded. So each map is compared with the flat picture once more, over the same pixels: whichever of the two covers more is looked at with a wider field of view, or where that does not help from an eye that looks up, until both cover as many within 3 %. That table has the verdicts; where too little of the land is seen, it says so. Balanced divides edges near the eye in curved pictures only, so with it only far land is the same; near land is compared at fast, which divides none. Land nearer or farther is taken first, since near land hides what is behind it.",
    "Shadows are measured on a walk through the fixed scene in the morning, 4.5 m and one second of the day a second at thirty frames a second, with three figures ahead: every step is drawn without shadows and with those that the game has on the adapter, in turns. It is walked three times, the same each time, and a step costs the least of the three: spikes of a shared machine are at other steps in every walk. All other figures here are without shadows.",
    "A pixel differs from the exact picture where a channel is off by more than 8 of 255; it is land's where it is not the same as in the picture without land; it is at an edge where, within a pixel of it, a 3x3 neighbourhood of the exact picture varies by more than 8.",
];

/// The scene as each space has it.
fn scene_table(gpu: &Gpu, frames: &[Frame], effort: Effort) -> Result<Table, LabError> {
    let (_, taken) = race(gpu, size(effort), frames.to_vec(), effort)?;
    let flat = taken.first().copied().unwrap_or_default();
    let rows = SPACES.iter().zip(&taken).map(|(geometry, own)| {
        let mut row = vec![Cell::text(geometry.name())];
        row.extend(costs(own, &flat));
        row
    });
    Ok(Table::new(
        "The fixed scene in each space",
        columns(&["space"], &[]),
        rows,
    ))
}

/// Which of a world's land is compared.
struct Land {
    name: &'static str,
    quality: Quality,
    order: Order,
}

/// Balanced divides edges near the eye, in curved pictures only, so there only far land is the same; fast divides none.
const FAR: Land = Land {
    name: "the flat world's far land",
    quality: Quality::Balanced,
    order: Order::FarthestFirst,
};
const NEAR: Land = Land {
    name: "the flat world's near land",
    quality: Quality::Fast,
    order: Order::NearestFirst,
};
const SPHERE: Land = Land {
    name: "the spherical world's land",
    quality: Quality::Fast,
    order: Order::NearestFirst,
};

/// The same work in every map once more, with some lamps.
fn lit_triangles(
    gpu: &Gpu,
    open: &Frame,
    closed: &Frame,
    effort: Effort,
) -> Result<Vec<Table>, LabError> {
    let mut tables = Vec::new();
    for (frame, looks, land) in [(open, looks(), NEAR), (closed, sphere_looks(), SPHERE)] {
        let mut frame = lamps::lit(frame, lamps::FEW).with_view(|it| {
            it.quality = land.quality;
            it.fog_distance_m = View::NO_FOG_M;
        });
        let chunks = keep_common(gpu, &mut frame, &looks, BAR_SIZE.1, land.order)?;
        let land = format!(
            "{chunks} chunks of {}, {}, with {} lamps",
            land.name,
            land.quality,
            lamps::FEW
        );
        tables.push(equal::same_pixels(
            gpu, &frame, &looks, &land, BAR_SIZE, effort,
        )?);
    }
    Ok(tables)
}

/// One world's land seen in several ways, every one of which draws all of it.
fn same_triangles(
    gpu: &Gpu,
    frame: &Frame,
    looks: &[Look],
    land: &Land,
    effort: Effort,
) -> Result<[Table; 2], LabError> {
    let mut frame = frame.clone().with_view(|it| {
        it.quality = land.quality;
        it.fog_distance_m = View::NO_FOG_M;
    });
    let chunks = keep_common(gpu, &mut frame, looks, BAR_SIZE.1, land.order)?;
    let rivals = looks.iter().map(|look| look.at(&frame)).collect();
    let (mut stages, taken) = race(gpu, BAR_SIZE, rivals, effort)?;
    let mut covered = Vec::new();
    for (stage, look) in stages.iter_mut().zip(looks) {
        covered.push(equal::shown(stage, &look.at(&frame), BAR_SIZE.0)?.pixels);
    }
    let flat = taken.first().copied().unwrap_or_default();
    let bare = covered.first().copied().unwrap_or_default().max(1);
    let rows = looks
        .iter()
        .zip(&taken)
        .zip(covered)
        .map(|((look, own), covered)| {
            let mut row = vec![Cell::text(look.name)];
            row.extend(costs(own, &flat));
            row.push(Cell::count(covered));
            row.push(Cell::figure(covered as f64 / bare as f64, ""));
            row.push(Cell::count(own.stats.plan.chunks_by_frame));
            row
        });
    let Land { name, quality, .. } = land;
    let land = format!("{chunks} chunks of {name}, {quality}");
    let every = Table::new(
        format!("The same triangles in every map: {land}"),
        columns(
            &["seen as"],
            &["pixels of land", "pixels to flat", "chunks by one matrix"],
        ),
        rows,
    );
    let pairs = equal::same_pixels(gpu, &frame, looks, &land, BAR_SIZE, effort)?;
    Ok([every, pairs])
}

fn columns(first: &[&str], last: &[&str]) -> Vec<String> {
    let middle = [
        "cost",
        "cost to flat",
        "wall clock",
        "planned and recorded",
        "triangles",
        "triangles to flat",
        "draw calls",
    ];
    first
        .iter()
        .chain(&middle)
        .chain(last)
        .map(|c| (*c).to_owned())
        .collect()
}

fn costs(own: &Taken, flat: &Taken) -> [Cell; 7] {
    let share = |a: f64, b: f64| Cell::figure(a / b, "");
    [
        Cell::figure(own.cost_ms, "ms"),
        share(own.cost_ms, flat.cost_ms),
        Cell::figure(own.wall_ms, "ms"),
        Cell::figure(own.recorded_ms, "ms"),
        Cell::count(own.stats.triangles),
        share(own.stats.triangles as f64, flat.stats.triangles as f64),
        Cell::count(own.stats.draws),
    ]
}
