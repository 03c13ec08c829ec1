//! What was found as sections of a report: tables, plots, and how to read them.

use super::amount::Amount;
use super::cost::Found;
use super::fit::Cost;
use super::spread::{Percentiles, Spread};
use crate::{Cell, Plot, Scale, Section, Series, Table};

/// What the figures of costs are and where they come from.
const COSTS: [&str; 3] = [
    "The fixed scene of seed 7, drawn without fog and shadows. A frame of V views with T million triangles and P million pixels in all is taken to last a V + b T + c P milliseconds; a, b and c are those for which the sum of ((a V + b T + c P) / t - 1)^2 over the measured times t is least. The figure after ± is the standard error. Frames of many triangles show all land in view, hidden or not, in more and more views of 64 by 36 pixels; frames of many pixels show the ground at one's feet in one large view, and in further small ones.",
    "A pixel is one of the picture, once shaded, with the samples that the game takes on the adapter. A triangle is one that is sent, whether it is seen or not; most here are smaller than a pixel.",
    "Frames are drawn in turns, to and fro, several in a row of which the first is not timed; a frame's time is the least of its turns' medians.",
];

/// How single frames are drawn.
fn turning(amount: &Amount) -> String {
    format!(
        "The fixed scene as the game draws it by default: quality balanced, shadows and samples as on this adapter, land and fog at view distance {}, while the eye turns once round in {} frames. Each frame is waited for before the next is begun. Of a hundred frames 50, 95 or 99 took at most what stands under p50, p95 and p99.",
        amount.view_distance, amount.frames
    )
}

/// By what they are timed.
const CLOCKS: &str = "\"Drawing\" is by the clock that the head names for frames. \"Whole frame\" is the wall clock, from before the frame is planned to its last pixel.";

fn ms(value: f64) -> Cell {
    Cell::figure(value, "ms")
}

fn cost(cost: &Cost) -> [Cell; 2] {
    [ms(cost.ms), ms(cost.off_ms)]
}

/// A size as it is written.
pub fn size((width, height): (u32, u32)) -> String {
    format!("{width}x{height}")
}

/// The section of what triangles and pixels cost.
pub fn costs(found: &[Found]) -> Section {
    let dots = found.iter().filter_map(|it| {
        let fit = it.fit.as_ref()?;
        let points = it.loads.iter().map(|load| (fit.told_ms(load), load.ms));
        Some(Series::dots(it.space, points.collect::<Vec<_>>()))
    });
    let plot = Plot::new(
        "gpu-cost",
        "Frames of all kinds: measured against the model",
        Scale::Logarithmic.axes("by the model, ms", "measured, ms"),
        dots,
    );
    Section::new(
        "gpu-cost",
        "A million triangles and a million pixels",
        COSTS,
        [fits(found), loads(found)],
    )
    .with([plot])
}

/// The costs of each space, and how far its frames stray from them.
fn fits(found: &[Found]) -> Table {
    let rows = found.iter().map(|it| {
        let mut row = vec![Cell::text(it.space)];
        match &it.fit {
            Some(fit) => {
                row.extend([&fit.triangles, &fit.pixels, &fit.view].map(cost).concat());
                row.extend([100.0 * fit.rms, 100.0 * fit.worst].map(|it| Cell::figure(it, "%")));
            }
            None => row.extend(vec![Cell::text("not told apart"); 8]),
        }
        row.push(Cell::count(it.rounds));
        row
    });
    let columns = [
        "space",
        "a million triangles",
        "±",
        "a million pixels",
        "±",
        "a view of neither",
        "±",
        "strays by (root mean square)",
        "strays by at most",
        "rounds",
    ];
    Table::new("Costs apart", columns, rows)
}

/// Every frame that the costs were found from.
fn loads(found: &[Found]) -> Table {
    let rows = found.iter().flat_map(|it| {
        it.loads.iter().map(|load| {
            let told = it.fit.as_ref().map(|fit| fit.told_ms(load));
            let off = told.map(|told| Cell::figure(100.0 * (told / load.ms - 1.0), "%"));
            vec![
                Cell::text(it.space),
                Cell::count(load.views),
                Cell::figure(load.triangles_m, "M"),
                Cell::figure(load.pixels_m, "M"),
                ms(load.ms),
                told.map_or(Cell::Empty, ms),
                off.unwrap_or(Cell::Empty),
            ]
        })
    });
    let columns = [
        "space",
        "views",
        "triangles",
        "pixels",
        "measured",
        "by the model",
        "the model is off by",
    ];
    Table::new("The frames behind them", columns, rows)
}

/// The section of single frames' times.
pub fn spreads(found: &[Spread], amount: &Amount) -> Section {
    let rows = found.iter().map(|it| {
        let mut row = vec![Cell::text(it.space), Cell::text(size(it.size))];
        for Percentiles { p50, p95, p99 } in [it.drawing, it.whole] {
            row.extend([p50, p95, p99].map(ms));
        }
        row.extend([Cell::count(it.triangles), Cell::count(it.frames)]);
        row
    });
    let columns = [
        "space",
        "picture",
        "drawing p50",
        "p95",
        "p99",
        "whole frame p50",
        "p95",
        "p99",
        "triangles",
        "frames timed",
    ];
    let table = Table::new("Frames of the three spaces", columns, rows);
    let mut spaces: Vec<&str> = found.iter().map(|it| it.space).collect();
    spaces.dedup();
    let lines = spaces.iter().flat_map(|space| {
        let of_space = found.iter().filter(|it| it.space == *space);
        let line = |name: &str, value: fn(&Percentiles) -> f64| {
            let points = of_space.clone().map(|it| {
                let pixels = f64::from(it.size.0) * f64::from(it.size.1);
                (pixels * 1e-6, value(&it.drawing))
            });
            Series::line(format!("{space}, {name}"), points.collect::<Vec<_>>())
        };
        [line("p50", |it| it.p50), line("p99", |it| it.p99)]
    });
    let plot = Plot::new(
        "gpu-frames",
        "Drawing a frame, by the pixels of its picture",
        Scale::Linear.axes("millions of pixels", "ms"),
        lines.collect::<Vec<_>>(),
    );
    let method = [turning(amount), CLOCKS.to_owned()];
    Section::new("gpu-frames", "Frames, one by one", method, [table]).with([plot])
}

/// The section that stands first: one row a space.
pub fn short(costs: &[Found], spreads: &[Spread], rest: &[(&str, Tally)]) -> Section {
    let mut sizes: Vec<(u32, u32)> = spreads.iter().map(|it| it.size).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut columns = vec!["space".to_owned()];
    columns.extend(["a million triangles", "a million pixels"].map(str::to_owned));
    columns.extend(sizes.iter().map(|it| format!("{}, p50", size(*it))));
    let names = crate::SPACES.map(antipode_geometry::Geometry::name);
    let rows = names.into_iter().map(|space| {
        let fit = costs.iter().find(|it| it.space == space);
        let fit = fit.and_then(|it| it.fit.as_ref());
        let mut row = vec![Cell::text(space)];
        row.push(fit.map_or(Cell::Empty, |fit| ms(fit.triangles.ms)));
        row.push(fit.map_or(Cell::Empty, |fit| ms(fit.pixels.ms)));
        row.extend(sizes.iter().map(|size| {
            let own = spreads
                .iter()
                .find(|it| it.space == space && it.size == *size);
            own.map_or(Cell::Empty, |it| ms(it.drawing.p50))
        }));
        row
    });
    let speed = Table::new("How fast", columns, rows);
    let right = rest.iter().map(|(what, tally)| {
        vec![
            Cell::text(*what),
            Cell::count(tally.met),
            Cell::count(tally.all),
        ]
    });
    let right = Table::new("How right", ["what", "within the bar", "of"], right);
    Section::new(
        "gpu-short",
        "In short",
        [
            "Milliseconds of the adapter. The sections below say how each was measured, and have the rest.",
        ],
        [speed, right],
    )
}

/// How many of some bars are met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tally {
    met: usize,
    all: usize,
}

impl Tally {
    /// The bars of a section.
    pub fn of(section: &Section) -> Self {
        let rows = section.tables.iter().flat_map(|table| &table.rows);
        let (mut met, mut all) = (0, 0);
        for cell in rows.flatten() {
            if let Cell::Verdict(good) = cell {
                met += usize::from(*good);
                all += 1;
            }
        }
        Self { met, all }
    }
}

/// A section for what could not be measured: its place in the report stays, and says why.
pub fn absent(id: &str, title: &str, why: &str) -> Section {
    Section::new(id, title, [why], [])
}
