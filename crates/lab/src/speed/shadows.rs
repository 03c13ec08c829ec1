//! What shadows cost: a walk through the fixed scene with and without them, frame by frame in turns.

use antipode_geometry::{ChartPoint, Geometry};
use antipode_render::{Gpu, ShadowQuality};
use antipode_scene::day;
use antipode_scene::frame::{Figure, Frame, ModelId};
use glam::DVec3;

use crate::speed::clock::median;
use crate::speed::stage::{Drawn, Stage};
use crate::{Cell, Effort, LabError, SPACES, Table};

/// Size of the pictures that the bar is for.
const SIZE: (u32, u32) = (640, 360);
/// What a frame with shadows may cost at most, of the one without.
const MOST_COST: f64 = 1.5;
/// Time of day at which the walk begins, seconds: the sun is half way up, and climbs.
const MORNING_S: f64 = 75.0;
/// Steps of the walk: seconds and metres a frame.
const STEP: (f64, f64) = (1.0 / 30.0, 4.5 / 30.0);
/// Frames before those that are timed: pipelines are made, and the maps are on their way.
const WARM: usize = 30;
/// How often it is walked.
const WALKS: usize = 3;
/// How high over where a new player's eye is the walk goes, so that it comes through no hill, metres.
const LIFT_M: f64 = 2.0;

/// The frame of a step.
fn at(frame: &Frame, step: usize) -> Frame {
    let mut own = frame.clone();
    let ahead = DVec3::new(own.view.eye.yaw.cos(), 0.0, own.view.eye.yaw.sin());
    let (seconds, metres) = STEP;
    own.view.eye.point = own
        .view
        .eye
        .point
        .moved(ahead * (metres * step as f64) + DVec3::Y * LIFT_M);
    let time_s = seconds * step as f64;
    own.content_mut().time_s += time_s as f32;
    own.content_mut().sky = day::sky(MORNING_S + time_s, &*own.view.strategy, &own.view.eye);
    let eye = own.view.eye;
    let beside = |right_m: f64| {
        let place = eye.point.pos + ahead * 5.0 + eye.right() * right_m;
        let point = ChartPoint {
            pos: place - DVec3::Y * 3.6,
            ..eye.point
        };
        Figure::standing(ModelId::Astronaut, point, eye.yaw)
    };
    own.content_mut()
        .figures
        .extend([-2.0, 0.5, 2.5].map(beside));
    own
}

fn cost_ms(gpu: &Gpu, drawn: &Drawn) -> f64 {
    let told = drawn.stats.gpu_ms.filter(|_| !gpu.is_software());
    drawn
        .worked_ms
        .or(told.map(f64::from))
        .unwrap_or(drawn.wall_ms)
}

/// The value that one in a hundred is over.
fn hundredth(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let at = (values.len() * 99 / 100).min(values.len().saturating_sub(1));
    values.get(at).copied().unwrap_or(f64::INFINITY)
}

/// Costs of the walk's steps without and with shadows. The walk is the same each time, so what a step costs is the
/// least of several: a step that is dear is dear in all of them, what else a machine does strikes now one, now another.
fn walks(gpu: &Gpu, frame: &Frame, effort: Effort) -> Result<[Vec<f64>; 2], LabError> {
    let mut least = walk(gpu, frame, effort)?;
    for _ in 1..WALKS {
        let again = walk(gpu, frame, effort)?;
        for (costs, again) in least.iter_mut().zip(&again) {
            for (cost, again) in costs.iter_mut().zip(again) {
                *cost = cost.min(*again);
            }
        }
    }
    Ok(least)
}

/// Costs of one walk.
fn walk(gpu: &Gpu, frame: &Frame, effort: Effort) -> Result<[Vec<f64>; 2], LabError> {
    let steps = WARM + if effort.quick { 100 } else { 200 };
    let shadows = quality(gpu);
    let mut stages = [
        Stage::shadowed(gpu, SIZE, ShadowQuality::Off)?,
        Stage::shadowed(gpu, SIZE, shadows)?,
    ];
    let mut costs = [Vec::new(), Vec::new()];
    for step in 0..steps {
        let own = at(frame, step);
        let first = step % 2;
        for turn in [first, 1 - first] {
            if step == 0 {
                stages[turn].complete_next();
            }
            let drawn = stages[turn].draw(&own)?;
            if step >= WARM {
                costs[turn].push(cost_ms(gpu, &drawn));
            }
        }
    }
    Ok(costs)
}

/// The quality that the game takes on an adapter.
pub fn quality(gpu: &Gpu) -> ShadowQuality {
    if gpu.is_software() {
        ShadowQuality::Low
    } else {
        ShadowQuality::High
    }
}

/// A row for each space, with the verdict.
///
/// # Errors
/// When the adapter fails.
pub fn table(gpu: &Gpu, frames: &[Frame], effort: Effort) -> Result<Table, LabError> {
    let mut rows = Vec::new();
    for (geometry, frame) in SPACES.into_iter().zip(frames) {
        rows.push(row(geometry, walks(gpu, frame, effort)?));
    }
    let columns = [
        "space",
        "median without",
        "median with",
        "ratio of medians",
        "99th of 100 without",
        "99th of 100 with",
        "ratio of those",
        "both at most 1.5",
    ];
    Ok(Table::new(
        "A walk with shadows and without, at 640x360",
        columns,
        rows,
    ))
}

fn row(geometry: Geometry, [mut without, mut with]: [Vec<f64>; 2]) -> Vec<Cell> {
    let ms = |x: f64| Cell::figure(x, "ms");
    let number = |x: f64| Cell::figure(x, "");
    let medians = [median(&mut without), median(&mut with)];
    let worst = [hundredth(&mut without), hundredth(&mut with)];
    let [typical, rare] = [medians, worst].map(|[without, with]| with / without);
    vec![
        Cell::text(geometry.name()),
        ms(medians[0]),
        ms(medians[1]),
        number(typical),
        ms(worst[0]),
        ms(worst[1]),
        number(rare),
        Cell::Verdict(typical <= MOST_COST && rare <= MOST_COST),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(without: f64, with: f64, rare: f64) -> Option<Cell> {
        let mut shaded = vec![with; 200];
        shaded[..3].fill(rare);
        row(Geometry::Euclidean, [vec![without; 200], shaded]).pop()
    }

    #[test]
    fn a_walk_fails_by_its_middle_and_by_its_worst_frames() {
        assert_eq!(judged(10.0, 14.0, 15.0), Some(Cell::Verdict(true)));
        assert_eq!(judged(10.0, 15.5, 15.5), Some(Cell::Verdict(false)));
        assert_eq!(judged(10.0, 12.0, 16.0), Some(Cell::Verdict(false)));
    }
}
