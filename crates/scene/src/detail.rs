//! How large land is in the picture, told to the chunk workers: it decides which level of detail a
//! chunk is made at, and whether it is made at all.
//!
//! What is told must hold while the eye roams a little and the dial glides a little, for each new
//! answer has the whole range planned anew; only when either has gone far enough is it told again.

use std::sync::Arc;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord, Eye, Map, Strategy};
use antipode_streaming::{Detail, Wish};
use glam::{DMat3, DVec3, DVec4};

use crate::frame::Quality;

/// How far the eye may go, in metres, before the sizes of things are taken anew.
const ROAM_M: f64 = 8.0;
/// Change of some size, as a natural logarithm, after which sizes are taken anew: a tenth.
const SCALE_CHANGE: f64 = 0.1;
/// Length of the short ways in the chart whose sight tells how large a metre is there.
const PROBE_M: f64 = 0.5;
/// Distances from the eye at which changes of the scale are looked for, in metres.
const SCALE_AT_M: [f64; 2] = [40.0, 160.0];

/// How exact the picture is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sharpness {
    /// Pixels in a radian at the picture's middle.
    pub(crate) pixels_per_rad: f64,
    /// Errors of so many pixels are let pass.
    pub(crate) tolerance_px: f64,
}

impl Sharpness {
    /// Of a picture of that many lines and field of view; `None` if nothing may be let pass.
    pub(crate) fn of(quality: Quality, height_px: u32, fov_y_rad: f64) -> Option<Self> {
        let tolerance_px = match quality {
            Quality::Fast => 1.0,
            Quality::Balanced => 0.5,
            Quality::Exact => return None,
        };
        Some(Self {
            pixels_per_rad: 0.5 * f64::from(height_px) / (0.5 * fov_y_rad).tan(),
            tolerance_px,
        })
    }
}

/// Sizes in the picture from one place.
#[derive(Debug)]
pub(crate) struct Sight {
    strategy: Arc<dyn Strategy>,
    eye: Eye,
    sharpness: Sharpness,
    scale: [f64; 6 * SCALE_AT_M.len()],
}

impl Sight {
    /// The sizes seen from `eye`.
    pub(crate) fn new(strategy: &Arc<dyn Strategy>, eye: &Eye, sharpness: Sharpness) -> Self {
        Self {
            strategy: Arc::clone(strategy),
            eye: *eye,
            sharpness,
            scale: scale(&**strategy, eye),
        }
    }

    /// Do the sizes still hold from here?
    pub(crate) fn holds(&self, strategy: &dyn Strategy, eye: &Eye, sharpness: Sharpness) -> bool {
        let (there, here) = (self.eye.point, eye.point);
        // Where nothing is as it was in the next chart, as on a sphere, crossing alone is far enough.
        let way = match strategy.tiled() {
            Some(tiled) => tiled.level_way_m(there, here),
            None => (there.chart == here.chart).then(|| here.pos - there.pos),
        };
        let roamed = way.is_none_or(|way| way.length() > ROAM_M);
        let rescaled = || {
            let mut pairs = self.scale.into_iter().zip(scale(strategy, eye));
            pairs.any(|(before, now)| differs(before, now))
        };
        self.sharpness == sharpness && !roamed && !rescaled()
    }

    /// Of a chunk in whose chart the eye is not written. A tile's plan has no more than half a chunk between places of a lattice
    /// of three, and the nearest of these is at most half an edge off the nearest place.
    fn far_pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        if self.strategy.tiled().is_none() {
            return f64::INFINITY;
        }
        let (low, high) = (coord.min() - ROAM_M, coord.max() + ROAM_M);
        let y = self.eye.point.pos.y.clamp(low.y, high.y);
        let viewer = self.strategy.viewer(&self.eye);
        let plan = lattice(3).filter(|share| share.y == 0.0);
        let sizes = plan.map(|share| {
            let pos = (low + share * (high - low)).with_y(y);
            size_rad(&*viewer, ChartPoint::new(coord.chart, pos))
        });
        sizes.fold(0.0, f64::max) * self.sharpness.pixels_per_rad
    }

    /// Where the eye is in a chunk's chart.
    fn eye_in(&self, coord: ChunkCoord) -> Option<DVec3> {
        let carried = self.strategy.carry(self.eye.point, coord.chart);
        carried.map(|eye| eye.point.pos)
    }
}

impl Detail for Sight {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        let (low, high) = (coord.min() - ROAM_M, coord.max() + ROAM_M);
        let Some(eye) = self.eye_in(coord) else {
            return self.far_pixels_per_metre(coord);
        };
        let nearest = eye.clamp(low, high);
        if nearest == eye {
            return f64::INFINITY;
        }
        let viewer = self.strategy.viewer(&self.eye);
        let at = |pos| size_rad(&*viewer, ChartPoint::new(coord.chart, pos));
        let mut size = at(nearest);
        if self.strategy.globe().is_some() {
            // In a closed space things grow again towards the antipode.
            for corner in lattice(3) {
                size = size.max(at(low + corner * (high - low)));
            }
        }
        size * self.sharpness.pixels_per_rad
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        let limit_m = self.strategy.sight_limit_m(&self.eye);
        let mut seen = false;
        let viewer = self.strategy.viewer(&self.eye);
        let mut directions = [DVec3::ZERO; 27];
        for (direction, share) in directions.iter_mut().zip(lattice(3)) {
            let pos = coord.origin() + share * f64::from(CHUNK_CELLS);
            let point = ChartPoint::new(coord.chart, pos);
            *direction = viewer(point).truncate().normalize_or(DVec3::NEG_Z);
            seen = seen || self.strategy.distance_m(self.eye.point, point, &self.eye) <= limit_m;
        }
        if !seen {
            return 0.0;
        }
        let spread = |from: &DVec3| {
            directions
                .iter()
                .map(|to| from.distance(*to))
                .fold(0.0, f64::max)
        };
        let span_rad = directions.iter().map(spread).fold(0.0, f64::max);
        span_rad * self.sharpness.pixels_per_rad
    }

    fn tolerance_px(&self) -> f64 {
        self.sharpness.tolerance_px
    }
}

/// Sizes in the picture, and in what is seen through a pair of doors: land about a leaf is made for who stands before it.
#[derive(Debug)]
pub(crate) struct Sights {
    own: Sight,
    leaves: Vec<Sight>,
}

impl Sights {
    /// The sizes seen from `eye`, and from the feet of leaves.
    pub(crate) fn new(
        strategy: &Arc<dyn Strategy>,
        eye: &Eye,
        feet: &[ChartPoint],
        sharpness: Sharpness,
    ) -> Self {
        let leaf = |foot: &ChartPoint| {
            let eye = Eye {
                point: *foot,
                ..*eye
            };
            Sight::new(strategy, &eye, sharpness)
        };
        Self {
            own: Sight::new(strategy, eye, sharpness),
            leaves: feet.iter().map(leaf).collect(),
        }
    }

    /// Do the sizes still hold from here, and with these leaves?
    pub(crate) fn holds(
        &self,
        strategy: &dyn Strategy,
        eye: &Eye,
        feet: &[ChartPoint],
        sharpness: Sharpness,
    ) -> bool {
        let stood = self.leaves.iter().map(|leaf| leaf.eye.point);
        stood.eq(feet.iter().copied()) && self.own.holds(strategy, eye, sharpness)
    }

    /// What is greatest of what the own eye sees and what those do in whose land the chunk lies.
    fn greatest(&self, coord: ChunkCoord, of: impl Fn(&Sight) -> f64) -> f64 {
        let reach_m = f64::from(CHUNK_CELLS) * (f64::from(Wish::APART_CHUNKS) + 1.5);
        let is_near = |leaf: &&Sight| {
            let foot = leaf.eye_in(coord);
            foot.is_some_and(|foot| (foot - coord.centre()).abs().max_element() <= reach_m)
        };
        let leaves = self.leaves.iter().filter(is_near);
        leaves.map(&of).fold(of(&self.own), f64::max)
    }
}

impl Detail for Sights {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        self.greatest(coord, |sight| sight.pixels_per_metre(coord))
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        self.greatest(coord, |sight| sight.span_px(coord))
    }

    fn tolerance_px(&self) -> f64 {
        self.own.tolerance_px()
    }
}

/// The points of a cubic lattice with `n` points along each edge of the unit cube.
fn lattice(n: u32) -> impl Iterator<Item = DVec3> {
    let last = f64::from(n - 1);
    (0..n * n * n).map(move |at| {
        DVec3::new(
            f64::from(at % n),
            f64::from(at / n % n),
            f64::from(at / n / n),
        ) / last
    })
}

/// The largest angle, in radians, that a metre of the chart takes at a point: the greatest singular
/// value of the derivative of the direction in which the point is seen.
fn size_rad(viewer: &dyn Fn(ChartPoint) -> DVec4, point: ChartPoint) -> f64 {
    let direction = |pos| {
        let view = viewer(ChartPoint::new(point.chart, pos));
        view.truncate().normalize_or(DVec3::NEG_Z)
    };
    let here = direction(point.pos);
    let column = |axis: DVec3| (direction(point.pos + axis * PROBE_M) - here) / PROBE_M;
    let derivative = DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z));
    let square = derivative.transpose() * derivative;
    // Squared thrice, the trace of its eighth power is within 12 % of the greatest alone, from above.
    let eighth = (0..3).fold(square, |power, _| power * power);
    let trace = eighth.x_axis.x + eighth.y_axis.y + eighth.z_axis.z;
    trace.powf(1.0 / 16.0)
}

/// How large a metre is seen around the eye.
fn scale(strategy: &dyn Map, eye: &Eye) -> [f64; 6 * SCALE_AT_M.len()] {
    let viewer = strategy.viewer(eye);
    let mut sizes = [0.0; 6 * SCALE_AT_M.len()];
    let ways = DVec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
    let steps = ways.flat_map(|way| SCALE_AT_M.map(|length_m| way * length_m));
    for (size, step) in sizes.iter_mut().zip(steps) {
        let point = ChartPoint::new(eye.point.chart, eye.point.pos + step);
        *size = size_rad(&*viewer, point);
    }
    sizes
}

/// Differ two sizes by more than may be? What is not a number is the same as itself.
fn differs(before: f64, now: f64) -> bool {
    let change = (now / before).ln().abs();
    before.to_bits() != now.to_bits() && (change.is_nan() || change > SCALE_CHANGE)
}

#[cfg(test)]
mod tests;
