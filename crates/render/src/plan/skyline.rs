//! The skyline of nearer land, azimuth by azimuth.
//!
//! A column of ground that is solid below some height blocks every ray that enters it below that height. In
//! a space that keeps azimuths that is all rays of its azimuths up to the slope at which its top is seen.

use std::collections::HashMap;
use std::f64::consts::PI;

use antipode_geometry::{CHUNK_CELLS, ChunkCoord, Hemisphere, SightCell};
use antipode_scene::frame::Frame;
use glam::{DVec2, DVec3, IVec2};

use super::ChunkLand;
use super::bounds::PictureScale;

/// Azimuths are told apart to 360/1024 of a degree.
const BINS: usize = 1024;
/// A column is taken in this many parts along each side, since its slope is that of its worst place: by how
/// many steps it lies from the eye's own.
const PARTS: [u32; 4] = [4, 4, 2, 2];

/// Solid ground under one column of chunks.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Steps in x plus steps in z from the eye's column.
    pub ring: u32,
    /// Which column, in chunks along x and z.
    pub place: IVec2,
    corner: DVec2,
    solid_below_m: f64,
}

/// The column of a chunk.
pub fn place_of(chunk: &ChunkLand) -> IVec2 {
    IVec2::new(chunk.coord.index.x, chunk.coord.index.z)
}

/// Whether the eye is inside the ground, where land is seen from its back and hides nothing.
pub fn is_underground(frame: &Frame, land: &[ChunkLand]) -> bool {
    columns(frame, land)
        .iter()
        .any(|column| column.ring == 0 && column.solid_below_m > frame.eye.point.pos.y)
}

/// The columns that are known to be solid below some height.
pub fn columns(frame: &Frame, land: &[ChunkLand]) -> Vec<Column> {
    let mut lowest: HashMap<IVec2, &ChunkLand> = HashMap::with_capacity(land.len());
    for chunk in land {
        let key = place_of(chunk);
        let entry = lowest.entry(key).or_insert(chunk);
        if chunk.coord.index.y < entry.coord.index.y {
            *entry = chunk;
        }
    }
    let home = ChunkCoord::containing(frame.eye.point).index;
    lowest
        .into_iter()
        .filter_map(|(key, chunk)| {
            let steps = key - IVec2::new(home.x, home.z);
            let origin = chunk.coord.origin();
            Some(Column {
                ring: steps.x.unsigned_abs() + steps.y.unsigned_abs(),
                place: key,
                corner: DVec2::new(origin.x, origin.z),
                solid_below_m: chunk.solid_below_m?,
            })
        })
        .collect()
}

/// The slope up to which rays of each azimuth are blocked.
#[derive(Debug)]
pub struct Skyline<'a> {
    frame: &'a Frame,
    scale: PictureScale,
    slopes: Vec<f64>,
}

impl<'a> Skyline<'a> {
    /// Nothing is blocked.
    pub fn new(frame: &'a Frame, scale: PictureScale) -> Self {
        Self {
            frame,
            scale,
            slopes: vec![f64::NEG_INFINITY; BINS],
        }
    }

    /// Blocks what a column blocks.
    pub fn raise(&mut self, column: &Column) {
        let parts = PARTS.get(column.ring as usize).copied().unwrap_or(1);
        let side = f64::from(CHUNK_CELLS) / f64::from(parts);
        for part in 0..parts * parts {
            let step = DVec2::new(f64::from(part % parts), f64::from(part / parts)) * side;
            self.raise_part(column.corner + step, side, column.solid_below_m);
        }
    }

    fn raise_part(&mut self, corner: DVec2, side: f64, top_m: f64) {
        let eye = self.frame.eye.point.pos;
        let low = corner - DVec2::new(eye.x, eye.z);
        let Some((from, to)) = azimuths(low, low + side) else {
            return;
        };
        let min = DVec3::new(corner.x, top_m, corner.y);
        let max = min + DVec3::new(side, 0.0, side);
        let cell = self
            .frame
            .strategy
            .sight_cell(&self.frame.eye, Hemisphere::A, min, max);
        if cell.is_empty() {
            return;
        }
        // Only azimuths that lie in the part throughout.
        let (first, last) = (bin_at(from).ceil() as i64, bin_at(to).floor() as i64);
        for bin in first..last {
            let slope = &mut self.slopes[bin.rem_euclid(BINS as i64) as usize];
            *slope = slope.max(cell.slope[0]);
        }
    }

    /// By how many pixels at most something rises over the skyline; zero or less where it is hidden.
    pub fn rises_px(&self, cell: &SightCell) -> f64 {
        let half = cell.half_width_rad.min(PI);
        let first = bin_at(cell.azimuth_rad - half).floor() as i64;
        let last = bin_at(cell.azimuth_rad + half).floor() as i64;
        let bins = (first..=last).take(BINS);
        let lowest = bins
            .map(|bin| self.slopes[bin.rem_euclid(BINS as i64) as usize])
            .fold(f64::INFINITY, f64::min);
        self.scale.widest_px(cell.slope[1].atan() - lowest.atan())
    }
}

/// An azimuth counted in bins.
fn bin_at(azimuth_rad: f64) -> f64 {
    azimuth_rad * (BINS as f64 / (2.0 * PI))
}

/// The azimuths at which a square is seen from the origin; `None` when it holds the origin.
fn azimuths(low: DVec2, high: DVec2) -> Option<(f64, f64)> {
    if DVec2::ZERO.clamp(low, high) == DVec2::ZERO {
        return None;
    }
    let middle = 0.5 * (low + high);
    let heading = middle.y.atan2(middle.x);
    let corners = [
        low,
        high,
        DVec2::new(low.x, high.y),
        DVec2::new(high.x, low.y),
    ];
    let aside = corners.map(|c| middle.perp_dot(c).atan2(middle.dot(c)));
    let least = aside.into_iter().fold(f64::INFINITY, f64::min);
    let most = aside.into_iter().fold(f64::NEG_INFINITY, f64::max);
    Some((heading + least, heading + most))
}
