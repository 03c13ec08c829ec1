//! What the light of lamps costs: the fixed scene with as many as a picture shows, and the same work with a few of
//! them in every map.

use std::f64::consts::{FRAC_PI_3, SQRT_2};

use antipode_render::Gpu;
use antipode_scene::frame::{Frame, LampLight, Lights};
use glam::DVec3;

use crate::speed::stage::{Taken, race};
use crate::{Cell, Effort, LabError, SPACES, Table};

/// Lamps that a picture shows at most, and what a frame with them may cost of one without.
const MOST: usize = 64;
const MOST_COST: f64 = 1.6;
/// Lamps of the comparison between maps.
pub const FEW: usize = 8;
/// Size of the pictures that the bar is for.
const SIZE: (u32, u32) = (640, 360);
/// Where lamps stand, metres from the eye.
const NEAREST_M: f64 = 4.0;
const FARTHEST_M: f64 = 60.0;
/// Colour times strength, and distance at which the light has faded, metres: those of the game's lamps.
const COLOUR: [f32; 3] = [2.6, 1.9, 1.1];
const RANGE_M: f64 = 12.0;

/// The frame with so many lamps before the eye, a metre under it, spread over a third of a disc from 4 m on as densely
/// in every space: over as much ground as a flat disc of 60 m has.
pub fn lit(frame: &Frame, count: usize) -> Frame {
    let eye = &frame.view.eye;
    let lamps = (0..count).map(|n| {
        let share = (n as f64 + 0.5) / count as f64;
        let turn = eye.yaw + ((n as f64 * SQRT_2).fract() - 0.5) * 2.0 * FRAC_PI_3;
        let way = DVec3::new(turn.cos(), 0.0, turn.sin());
        let (near2, far2) = (NEAREST_M * NEAREST_M, FARTHEST_M * FARTHEST_M);
        let level_m = level_m(frame, share.mul_add(far2 - near2, near2));
        let place = eye.point.moved(way * level_m - DVec3::Y);
        LampLight {
            point: frame
                .view
                .strategy
                .cross(place)
                .map_or(place, |over| over.point),
            colour: COLOUR,
            range_m: RANGE_M,
        }
    });
    frame.clone().with_content(|it| {
        it.lights = Lights {
            lamps: lamps.collect(),
            beams: Vec::new(),
        }
    })
}

/// The radius of a disc of ground as large as a flat one of the given radius squared: on a sphere
/// `2 pi R^2 (1 - cos(r/R))` instead of `pi r^2`.
fn level_m(frame: &Frame, flat2: f64) -> f64 {
    if !frame.view.strategy.is_closed() {
        return flat2.sqrt();
    }
    let radius_m = frame.view.strategy.radius_m();
    radius_m * (1.0 - flat2 / (2.0 * radius_m * radius_m)).max(-1.0).acos()
}

/// A row for each space: the fixed scene without lamps and with as many as a picture shows.
///
/// # Errors
/// When the adapter fails.
pub fn table(gpu: &Gpu, frames: &[Frame], effort: Effort) -> Result<Table, LabError> {
    let mut rows = Vec::new();
    for (geometry, frame) in SPACES.iter().zip(frames) {
        let pair = vec![lit(frame, 0), lit(frame, MOST)];
        let (_, taken) = race(gpu, SIZE, pair, effort)?;
        rows.push(row(geometry.name(), &taken));
    }
    let columns = ["space", "without lamps", "with 64", "ratio", "at most 1.6"];
    Ok(Table::new(
        "The fixed scene at 640x360 without lamps and with 64 of them",
        columns,
        rows,
    ))
}

fn row(name: &str, taken: &[Taken]) -> Vec<Cell> {
    let ms = |taken: &Taken| Cell::figure(taken.cost_ms, "ms");
    let mut cells = vec![Cell::text(name)];
    if let [bare, lit] = taken {
        let ratio = lit.cost_ms / bare.cost_ms;
        cells.extend([
            ms(bare),
            ms(lit),
            Cell::figure(ratio, ""),
            Cell::Verdict(ratio <= MOST_COST),
        ]);
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cost_past_the_bar_fails() {
        let judged = |costs: [f64; 2]| {
            let taken = costs.map(|cost_ms| Taken {
                cost_ms,
                ..Taken::default()
            });
            row("flat", &taken).pop()
        };
        assert_eq!(judged([10.0, 16.0]), Some(Cell::Verdict(true)));
        assert_eq!(judged([10.0, 16.1]), Some(Cell::Verdict(false)));
    }
}
