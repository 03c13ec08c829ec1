//! The same triangles over the same number of pixels: what a map costs by itself.
//!
//! A map that shows land larger has more to shade, which is the picture's doing and not the
//! engine's. Of each curved picture and the flat one, the one that covers more is looked at with a
//! wider field of view, or where that does not help from an eye that looks up, until both cover as
//! many pixels.

use antipode_render::Gpu;
use antipode_scene::frame::Frame;

use crate::speed::pictures::Picture;
use crate::speed::scenes::{Look, Order, keep_whole};
use crate::speed::stage::{Stage, Taken, race};
use crate::{Cell, Effort, LabError, Table};

/// What a curved frame may cost at most, of the flat frame of the same triangles.
const MOST_COST: f64 = 1.15;
/// Coverages count as equal within this part.
const EQUAL: f64 = 0.03;
/// Halvings of a knob's range.
const HALVINGS: usize = 9;
/// How often what one of the pictures does not draw whole is left out and the pixels matched again.
const MATCHES: usize = 3;
/// Of fewer pixels than this nothing can be said.
const FEWEST: usize = 5_000;

/// What a frame shows of its land.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shown {
    /// Pixels that the land covers.
    pub pixels: usize,
    /// Triangles drawn.
    pub triangles: usize,
}

/// Draws a frame with and without its land, `width` pixels wide.
///
/// # Errors
/// When the adapter fails.
pub fn shown(stage: &mut Stage<'_>, frame: &Frame, width: u32) -> Result<Shown, LabError> {
    let empty = Picture::without_land(stage, frame, width)?;
    let triangles = stage.draw(frame)?.stats.triangles;
    let drawn = Picture::last(stage, width)?;
    Ok(Shown {
        pixels: drawn.difference(&drawn, &empty).land,
        triangles,
    })
}

/// The frame with a wider field of view, by a factor on the tangents of its halves.
fn widened(frame: &Frame, factor: f64) -> Frame {
    let mut own = frame.clone();
    own.view.projection.sx /= factor;
    own.view.projection.sy /= factor;
    own
}

/// The frame from an eye that looks up by so many radians more.
fn tilted(frame: &Frame, by_rad: f64) -> Frame {
    let mut own = frame.clone();
    own.view.eye.pitch += by_rad;
    own
}

/// A way to cover fewer pixels, from not at all to the most.
type Knob = (fn(&Frame, f64) -> Frame, [f64; 2]);

/// What is far gets smaller in a wider field of view; of what is near as much more comes in at the
/// sides, but it sinks out of the picture as the eye looks up.
const KNOBS: [Knob; 2] = [(widened, [1.0, 3.0]), (tilted, [0.0, 0.8])];

/// A flat and a curved frame of the same land, and what each shows.
struct Pair {
    frames: [Frame; 2],
    shown: [Shown; 2],
}

impl Pair {
    fn same_pixels(&self) -> bool {
        let [flat, curved] = self.shown.map(|shown| shown.pixels as f64);
        (curved / flat - 1.0).abs() <= EQUAL && self.shown[0].pixels >= FEWEST
    }

    fn same_triangles(&self) -> bool {
        self.shown[0].triangles == self.shown[1].triangles
    }
}

/// Turns a knob on whichever of the frames covers more until both cover as much, as far as that goes.
fn matched(stage: &mut Stage<'_>, frames: [Frame; 2], width: u32) -> Result<Pair, LabError> {
    let mut pair = Pair {
        shown: [
            shown(stage, &frames[0], width)?,
            shown(stage, &frames[1], width)?,
        ],
        frames,
    };
    let more = usize::from(pair.shown[1].pixels > pair.shown[0].pixels);
    let due = pair.shown[1 - more].pixels;
    let whole = (pair.frames[more].clone(), pair.shown[more]);
    for (turned, [mut low, mut high]) in KNOBS {
        for _ in 0..HALVINGS {
            if pair.same_pixels() || due < FEWEST {
                return Ok(pair);
            }
            let middle = 0.5 * (low + high);
            pair.frames[more] = turned(&whole.0, middle);
            pair.shown[more] = shown(stage, &pair.frames[more], width)?;
            if pair.shown[more].pixels > due {
                low = middle;
            } else {
                high = middle;
            }
        }
        if !pair.same_pixels() {
            (pair.frames[more], pair.shown[more]) = whole.clone();
        }
    }
    Ok(pair)
}

/// The pair of one look, with land that both draw whole.
fn pair(
    stage: &mut Stage<'_>,
    gpu: &Gpu,
    frame: &Frame,
    look: [&Look; 2],
    size: (u32, u32),
) -> Result<Pair, LabError> {
    let mut frame = frame.clone();
    let mut found = matched(stage, look.map(|look| look.at(&frame)), size.0)?;
    for _ in 0..MATCHES {
        if found.same_triangles() || !found.same_pixels() {
            break;
        }
        // What is hidden, divided or out of the picture now.
        keep_whole(gpu, &mut frame, &found.frames, size.1, Order::NearestFirst)?;
        found = matched(stage, look.map(|look| look.at(&frame)), size.0)?;
    }
    Ok(found)
}

/// A row for each look after the first, which is flat: cost, pixels and the verdict.
///
/// # Errors
/// When the adapter fails.
pub fn same_pixels(
    gpu: &Gpu,
    frame: &Frame,
    looks: &[Look],
    land: &str,
    size: (u32, u32),
    effort: Effort,
) -> Result<Table, LabError> {
    let Some((flat, curved)) = looks.split_first() else {
        return Err(LabError::Scene("nothing to compare with".to_owned()));
    };
    let mut stage = Stage::new(gpu, size)?;
    let mut rows = Vec::new();
    for look in curved {
        let pair = pair(&mut stage, gpu, frame, [flat, look], size)?;
        let taken = if pair.same_pixels() {
            race(gpu, size, pair.frames.to_vec(), effort)?.1
        } else {
            Vec::new()
        };
        rows.push(row(look.name, &pair, &taken));
    }
    let columns = [
        "seen as",
        "cost",
        "flat frame's cost",
        "cost to flat",
        "triangles",
        "flat frame's triangles",
        "pixels of land",
        "pixels to flat",
        "same triangles and pixels, at most 1.15",
    ];
    Ok(Table::new(
        format!("The same triangles over the same pixels: {land}"),
        columns,
        rows,
    ))
}

/// Costs are left out where the pixels are not the same.
fn row(name: &str, pair: &Pair, taken: &[Taken]) -> Vec<Cell> {
    let number = |x: f64| Cell::figure(x, "");
    let ms = |x: f64| Cell::figure(x, "ms");
    let mut cells = vec![Cell::text(name)];
    let verdict = if let [flat, own] = taken {
        let ratio = own.cost_ms / flat.cost_ms;
        cells.extend([ms(own.cost_ms), ms(flat.cost_ms), number(ratio)]);
        Cell::Verdict(pair.same_triangles() && ratio <= MOST_COST)
    } else {
        cells.extend([Cell::Empty, Cell::Empty, Cell::Empty]);
        Cell::text("not the same pixels")
    };
    let [bare, own] = pair.shown;
    cells.extend([
        number(own.triangles as f64),
        number(bare.triangles as f64),
        number(own.pixels as f64),
        number(own.pixels as f64 / bare.pixels.max(1) as f64),
        verdict,
    ]);
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(pixels: [usize; 2], triangles: [usize; 2]) -> Pair {
        let space = antipode_geometry::strategy(antipode_geometry::Geometry::Euclidean, 0.0);
        let frame = crate::scene_frame::bare(space, &antipode_geometry::Eye::default());
        Pair {
            frames: [frame.clone(), frame],
            shown: [0, 1].map(|i| Shown {
                pixels: pixels[i],
                triangles: triangles[i],
            }),
        }
    }

    fn judged(pixels: [usize; 2], triangles: [usize; 2], costs: [f64; 2]) -> Option<Cell> {
        let pair = pair(pixels, triangles);
        let taken = costs.map(|cost_ms| Taken {
            cost_ms,
            ..Taken::default()
        });
        let told: &[Taken] = if pair.same_pixels() { &taken } else { &[] };
        row("curved", &pair, told).pop()
    }

    #[test]
    fn only_the_same_work_is_judged_and_a_cost_past_the_bar_fails() {
        let (pixels, triangles) = ([90_000, 91_000], [7, 7]);
        let passed = Some(Cell::Verdict(true));
        assert_eq!(judged(pixels, triangles, [1.0, 1.15]), passed);
        let failed = Some(Cell::Verdict(false));
        assert_eq!(judged(pixels, triangles, [1.0, 1.16]), failed);
        assert_eq!(judged(pixels, [7, 8], [1.0, 1.0]), failed);
        let apart = judged([90_000, 94_000], triangles, [1.0, 1.0]);
        assert!(matches!(apart, Some(Cell::Text(_))), "{apart:?}");
    }
}
