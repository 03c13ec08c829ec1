//! The skyline of nearer land, azimuth by azimuth.
//!
//! A column of ground that is solid below some height blocks every ray that enters it below that height. In
//! a space that keeps azimuths that is all rays of its azimuths up to the slope at which its top is seen; and so it is in a world in
//! tiles, where the plan of a ray is straight.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

use antipode_frame::Frame;
use antipode_geometry::{
    CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, SightCell, SquareFrame, Strategy, azimuth_spread,
};
use glam::{DVec2, DVec3, IVec2, Vec3Swizzles};

use super::bounds::PictureScale;
use super::land::PARTS;
use super::rings::Rings;

/// Azimuths are told apart to 360/1024 of a degree.
const BINS: usize = 1024;
/// So many of a column's parts along each side are taken together, by how many steps it lies from the eye's own: the
/// slope of a square is that of its worst place.
const TAKEN_TOGETHER: [usize; 12] = [1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2];

/// Solid ground under one column of chunks.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its chart.
    pub chart: ChartId,
    /// Which column, in chunks along x and z.
    pub place: IVec2,
    /// Height below which each of its parts is solid, chart metres.
    solid_below_m: [f64; PARTS * PARTS],
    /// The least and the greatest of these.
    lowest_m: f64,
    highest_m: f64,
}

impl Column {
    /// A column whose parts, row by row along x, are solid below some heights, chart metres.
    pub fn new(chart: ChartId, place: IVec2, solid_below_m: [f64; PARTS * PARTS]) -> Self {
        Self {
            chart,
            place,
            solid_below_m,
            lowest_m: solid_below_m.into_iter().fold(f64::INFINITY, f64::min),
            highest_m: solid_below_m.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Its corner with the smallest coordinates, x and z in chart metres.
    fn corner(&self) -> DVec2 {
        self.place.as_dvec2() * f64::from(CHUNK_CELLS)
    }

    /// Height below which a square of `side` parts is solid, from the part at `x` and `z` on.
    fn solid_below_m(&self, [x, z]: [usize; 2], side: usize) -> f64 {
        if side == PARTS {
            return self.lowest_m;
        }
        let rows = self.solid_below_m.chunks_exact(PARTS).skip(z).take(side);
        let parts = rows.flat_map(|row| row.iter().skip(x).take(side));
        parts.copied().fold(f64::INFINITY, f64::min)
    }
}

/// How the columns of a chart lie about the eye, where they stand on the grid of those of its own chart.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// The chart as the eye's has it, its middle in whole columns; none where its columns do not fit in with those.
    lies: Option<(SquareFrame, IVec2)>,
    home: IVec2,
    /// The eye's place in its own chart, x and z in metres.
    eye: DVec2,
    /// Whether azimuths are those of the picture and not of the chart.
    is_tile: bool,
}

impl Grid {
    /// That of a chart.
    pub fn of(frame: &Frame, chart: ChartId) -> Self {
        let (space, eye) = (&*frame.view.strategy, frame.view.eye.point);
        let is_tile = space.tiled().is_some();
        Self {
            lies: (!is_tile).then(|| lies(space, chart, eye.chart)).flatten(),
            home: ChunkCoord::containing(eye).index.xz(),
            eye: eye.pos.xz(),
            is_tile,
        }
    }

    /// Steps in x plus steps in z from the eye's column to one; none where that cannot be said.
    pub fn ring(&self, place: IVec2) -> Option<u32> {
        let (frame, middle) = self.lies?;
        // Turned by quarters, the columns from 0 to -1 change places: those after a turn of an axis begin at their other side.
        let turned = match frame.quarter_turns {
            0 => place,
            1 => IVec2::new(place.y, -1 - place.x),
            2 => -1 - place,
            _ => IVec2::new(-1 - place.y, place.x),
        };
        let steps = turned + middle - self.home;
        Some(steps.x.unsigned_abs() + steps.y.unsigned_abs())
    }

    /// The azimuths at which a square of the chart is seen; `None` where the eye stands over it.
    fn seen_at(&self, corner: DVec2, side: f64) -> Option<[f64; 2]> {
        let (frame, _) = self.lies?;
        let corners = [corner, corner + side];
        let corners = corners.map(|at| frame.placed(DVec3::new(at.x, 0.0, at.y)).xz());
        let low = corners[0].min(corners[1]) - self.eye;
        azimuths(low, low + side)
    }
}

/// A chart as another has it, and its middle there in columns, if it is turned by quarters and its columns stand on the
/// other's grid.
fn lies(strategy: &dyn Strategy, chart: ChartId, other: ChartId) -> Option<(SquareFrame, IVec2)> {
    if chart == other {
        return Some((SquareFrame::default(), IVec2::ZERO));
    }
    let crossing = strategy.carry(ChartPoint::new(chart, DVec3::ZERO), other)?;
    let (turns, middle) = (crossing.turn_rad / FRAC_PI_2, crossing.point.pos);
    let columns = middle / f64::from(CHUNK_CELLS);
    let is_square = (turns - turns.round()).abs() < 1e-9;
    let fits = is_square && middle.y == 0.0 && columns.fract() == DVec3::ZERO;
    let frame = SquareFrame {
        quarter_turns: turns.round().rem_euclid(4.0) as u8,
        centre_m: middle.xz(),
    };
    fits.then(|| (frame, columns.xz().as_ivec2()))
}

/// Whether the eye is inside the ground, where land is seen from its back and hides nothing.
pub fn is_underground(frame: &Frame, rings: &mut Rings<'_>, columns: &[Column]) -> bool {
    let mut columns = columns.iter();
    let over = columns.find(|it| rings.ring_of_hiding(it.chart, it.place) == Some(0));
    let Some(column) = over else {
        return false;
    };
    let strategy = &frame.view.strategy;
    let Some(eye) = strategy.carry(frame.view.eye.point, column.chart) else {
        return false;
    };
    let part_m = f64::from(CHUNK_CELLS) / PARTS as f64;
    let part = (eye.point.pos.xz() - column.corner()) / part_m;
    let [x, z] = part
        .to_array()
        .map(|i| (i.max(0.0) as usize).min(PARTS - 1));
    column.solid_below_m([x, z], 1) > eye.point.pos.y
}

/// The slope up to which rays of each azimuth are blocked.
#[derive(Debug)]
pub struct Skyline<'a> {
    frame: &'a Frame,
    scale: PictureScale,
    slopes: Vec<f64>,
    /// The outermost ring that is looked for at each azimuth: what stands there or farther off need not be known.
    wanted: Vec<u32>,
}

impl<'a> Skyline<'a> {
    /// Nothing is blocked, and nothing is looked for.
    pub fn new(frame: &'a Frame, scale: PictureScale) -> Self {
        Self {
            frame,
            scale,
            slopes: vec![f64::NEG_INFINITY; BINS],
            wanted: vec![0; BINS],
        }
    }

    /// Tells that [`Skyline::rises_px`] will be asked for when all rings inside of one are known.
    pub fn want(&mut self, cell: &SightCell, ring: u32) {
        if ring > 0 {
            for bin in bins_around(cell) {
                self.wanted[bin] = self.wanted[bin].max(ring);
            }
        }
    }

    /// Blocks what a column of a ring blocks; `grid` is that of its chart.
    pub fn raise(&mut self, column: &Column, grid: &Grid, ring: u32) {
        let side = f64::from(CHUNK_CELLS);
        let Some([from, to]) = self.seen_at(column, grid, column.corner(), side) else {
            // The eye's own column blocks what its parts do.
            return self.raise_parts(column, grid, ring);
        };
        let bins = bin_at(from).floor() as i64..bin_at(to).floor() as i64 + 1;
        if self.is_wanted(bins.clone(), ring) {
            let highest = self
                .top(column.chart, column.corner(), side, column.highest_m)
                .slope[1];
            if bins
                .into_iter()
                .any(|bin| self.slopes[wrapped(bin)] < highest)
            {
                self.raise_parts(column, grid, ring);
            }
        }
    }

    /// The azimuths at which a square of a column is seen; `None` where the eye stands over it.
    fn seen_at(&self, column: &Column, grid: &Grid, corner: DVec2, side: f64) -> Option<[f64; 2]> {
        if !grid.is_tile {
            return grid.seen_at(corner, side);
        }
        let view = &self.frame.view;
        let tiled = view.strategy.tiled()?;
        tiled.azimuths_rad(view.eye.point, column.chart, corner, corner + side)
    }

    /// The cell of a level square of the chart.
    fn top(&self, chart: ChartId, corner: DVec2, side: f64, top_m: f64) -> SightCell {
        let min = DVec3::new(corner.x, top_m, corner.y);
        let max = min + DVec3::new(side, 0.0, side);
        let (space, eye) = (&self.frame.view.strategy, &self.frame.view.eye);
        space.sight_cell(eye, chart, min, max)
    }

    fn raise_parts(&mut self, column: &Column, grid: &Grid, ring: u32) {
        let together = TAKEN_TOGETHER.get(ring as usize).copied().unwrap_or(PARTS);
        let part_m = f64::from(CHUNK_CELLS) / PARTS as f64;
        let side = part_m * together as f64;
        for z in (0..PARTS).step_by(together) {
            for x in (0..PARTS).step_by(together) {
                let corner = column.corner() + part_m * DVec2::new(x as f64, z as f64);
                if let Some(azimuths) = self.seen_at(column, grid, corner, side) {
                    let top_m = column.solid_below_m([x, z], together);
                    let top = || self.top(column.chart, corner, side, top_m);
                    if let Some((bins, slope)) = self.blocked(azimuths, ring, top) {
                        for bin in bins {
                            let blocked = &mut self.slopes[wrapped(bin)];
                            *blocked = blocked.max(slope);
                        }
                    }
                }
            }
        }
    }

    /// The bins that a part of a ring's column fills, if anything farther off is looked for there, and the slope up to
    /// which its top blocks them.
    fn blocked(
        &self,
        [from, to]: [f64; 2],
        ring: u32,
        top: impl FnOnce() -> SightCell,
    ) -> Option<(Range<i64>, f64)> {
        // Only azimuths that lie in the part throughout.
        let bins = bin_at(from).ceil() as i64..bin_at(to).floor() as i64;
        let cell = self.is_wanted(bins.clone(), ring).then(top)?;
        (!cell.is_empty()).then_some((bins, cell.slope[0]))
    }

    /// Whether anything farther off than a ring is looked for at any of the azimuths.
    fn is_wanted(&self, mut bins: Range<i64>, ring: u32) -> bool {
        bins.any(|bin| self.wanted[wrapped(bin)] > ring)
    }

    /// By how many pixels at most something rises over the skyline; zero or less where it is hidden.
    pub fn rises_px(&self, cell: &SightCell) -> f64 {
        let lowest = bins_around(cell)
            .map(|bin| self.slopes[bin])
            .fold(f64::INFINITY, f64::min);
        self.scale.widest_px(cell.slope[1].atan() - lowest.atan())
    }
}

/// The bins of the azimuths of a cell.
fn bins_around(cell: &SightCell) -> impl Iterator<Item = usize> + use<> {
    let half = cell.half_width_rad.min(PI);
    let first = bin_at(cell.azimuth_rad - half).floor() as i64;
    let last = bin_at(cell.azimuth_rad + half).floor() as i64;
    (first..=last).take(BINS).map(wrapped)
}

/// A bin counted once about.
fn wrapped(bin: i64) -> usize {
    bin.rem_euclid(BINS as i64) as usize
}

/// An azimuth counted in bins.
fn bin_at(azimuth_rad: f64) -> f64 {
    azimuth_rad * (BINS as f64 / (2.0 * PI))
}

/// The azimuths at which a square is seen from the origin; `None` when it holds the origin.
fn azimuths(low: DVec2, high: DVec2) -> Option<[f64; 2]> {
    if DVec2::ZERO.clamp(low, high) == DVec2::ZERO {
        return None;
    }
    let middle = 0.5 * (low + high);
    let heading = middle.y.atan2(middle.x);
    let [least, most] = azimuth_spread(low, high);
    Some([heading + least, heading + most])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_counts_the_columns_between_a_turned_charts_and_the_eyes_own() {
        let side = f64::from(CHUNK_CELLS);
        let (middle, home) = (IVec2::new(3, -2), IVec2::new(-1, 4));
        for quarter_turns in 0..4 {
            let frame = SquareFrame {
                quarter_turns,
                centre_m: middle.as_dvec2() * side,
            };
            let grid = Grid {
                lies: Some((frame, middle)),
                home,
                eye: DVec2::ZERO,
                is_tile: false,
            };
            for place in [IVec2::ZERO, IVec2::new(2, -3), IVec2::new(-4, 1)] {
                let within = (place.as_dvec2() + 0.25) * side;
                let carried = frame.placed(DVec3::new(within.x, 0.0, within.y)).xz();
                let steps = (carried / side).floor().as_ivec2() - home;
                let expected = steps.x.unsigned_abs() + steps.y.unsigned_abs();
                assert_eq!(grid.ring(place), Some(expected), "{quarter_turns}, {place}");
            }
        }
    }
}
