//! How long frames take, one by one: the three spaces at three sizes while the eye turns once round, as the game draws
//! them (quality *balanced*, shadows and samples as on that adapter by default).

use std::f64::consts::TAU;

use antipode_render::Gpu;
use antipode_timing::nearest_rank;

use super::amount::{Amount, Size};
use super::clock::{Clock, Limit};
use super::worlds::World;
use crate::LabError;
use crate::speed::shadows;
use crate::speed::stage::Stage;

/// Share of the time in which frames are drawn and not timed: land is sent, shaders are made, shadow maps come, and a card
/// leaves the clock rate of its rest.
const WARM: f64 = 0.125;
/// Fewest frames, whatever they take.
const FEWEST: usize = 3;

/// Times that so many of a hundred frames keep to, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Percentiles {
    /// Half of them.
    pub p50: f64,
    /// 95.
    pub p95: f64,
    /// 99.
    pub p99: f64,
}

/// One space at one size.
#[derive(Clone, Debug)]
pub struct Spread {
    /// The space.
    pub space: &'static str,
    /// The picture.
    pub size: Size,
    /// Frames that were timed.
    pub frames: usize,
    /// By the clock of frames.
    pub drawing: Percentiles,
    /// By the wall clock, from before planning to the last pixel.
    pub whole: Percentiles,
    /// Triangles of a frame, the median.
    pub triangles: usize,
}

impl Percentiles {
    /// By nearest rank; all zero of no times.
    pub fn of(times: &mut [f64]) -> Self {
        times.sort_by(f64::total_cmp);
        let rank = |share| nearest_rank(times, share).unwrap_or_default();
        Self {
            p50: rank(0.5),
            p95: rank(0.95),
            p99: rank(0.99),
        }
    }
}

/// Every world at one size.
///
/// # Errors
/// When the adapter fails, cannot draw pictures of that size, or tells no times.
pub fn at_size(
    gpu: &Gpu,
    worlds: &[World],
    size: Size,
    amount: &Amount,
) -> Result<Vec<Spread>, LabError> {
    let most = gpu.device.limits().max_texture_dimension_2d;
    if size.0.max(size.1) > most {
        let why = format!("its pictures have at most {most} pixels a side");
        return Err(crate::compute::failed(gpu, &why));
    }
    let mut stage = Stage::shadowed(gpu, size, shadows::quality(gpu))?;
    worlds
        .iter()
        .map(|world| spread(gpu, &mut stage, world, (size, amount)))
        .collect()
}

fn spread(
    gpu: &Gpu,
    stage: &mut Stage<'_>,
    world: &World,
    (size, amount): (Size, &Amount),
) -> Result<Spread, LabError> {
    let clock = Clock::of_frames(gpu);
    let turned = |turn: usize| {
        let by_rad = TAU * turn as f64 / amount.frames as f64;
        world.frame.clone().with_view(|view| view.eye.yaw += by_rad)
    };
    stage.complete_next();
    let warming = Limit::of(WARM * amount.spread_s);
    let mut warm = 0;
    while warm < FEWEST || !warming.is_over() {
        stage.draw(&turned(0))?;
        warm += 1;
    }
    let limit = Limit::of((1.0 - WARM) * amount.spread_s);
    let (mut drawing, mut whole, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for turn in 0..amount.frames {
        if turn >= FEWEST && limit.is_over() {
            break;
        }
        let drawn = stage.draw(&turned(turn))?;
        drawing.extend(clock.ms(&drawn));
        whole.push(drawn.wall_ms);
        triangles.push(drawn.stats.triangles);
    }
    if drawing.is_empty() {
        return Err(clock.silent(gpu));
    }
    triangles.sort_unstable();
    Ok(Spread {
        space: world.name(),
        size,
        frames: whole.len(),
        drawing: Percentiles::of(&mut drawing),
        whole: Percentiles::of(&mut whole),
        triangles: nearest_rank(&triangles, 0.5).unwrap_or_default(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_those_of_the_times_in_order() {
        let mut times: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        let found = Percentiles::of(&mut times);
        let [p50, p95, p99] = [100.0, 190.0, 198.0];
        assert_eq!(found, Percentiles { p50, p95, p99 });
        assert_eq!(Percentiles::of(&mut []), Percentiles::default());
    }
}
