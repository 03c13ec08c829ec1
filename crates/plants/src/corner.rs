//! The stones that tell where five squares meet, in worlds in tiles.
//!
//! Each corner has one, which belongs to the tile with the least number of those about it, so that all five know the same.
//!
//! Things are told in metres of their chart, and those of a square's are not the space's: at its corner they are the longest, by
//! 1.38 times more along the diagonal than across. All squares are alike, so that what is rigid there has one form in all of
//! their charts but for quarter turns. With a = b = T the equiangular chart has the lengths (`geometry/src/hyperbolic_world/chart.rs`)
//! `(1 - T^2) W` across and W times that along, where W, the cosh of how far the corner is from the middle, is
//! `cot(pi/4) cot(pi/5)`, W^2 = 1 + 2/sqrt(5), and T^2 = sqrt(5) - 2. So they are sqrt(2 - 2/sqrt(5)) and 1 + 1/sqrt(5).

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use antipode_geometry::tiled::about_corner;
use antipode_geometry::{Atlas, ChartId};
use antipode_terrain::{FIRST_PLANTED, Field, Thing};
use glam::{DVec2, DVec3, Vec2, Vec3};

use crate::species::{Age, Species};

/// Its number on its column of chunks, where there is but one corner: past those of all cells.
pub(crate) const SLOT: u8 = FIRST_PLANTED - 1;
/// How many squares meet where a stone stands.
const SQUARES: usize = 5;
/// Metres of the space in one of the chart at a corner, on the level, along the diagonal and across it.
const ALONG: f32 = 1.447_213_6;
const ACROSS: f32 = 1.051_462_2;
/// Nothing else reaches nearer to the middle of a stone, metres of the chart.
const CLEAR_M: f64 = 1.0;

/// A corner of a square where five meet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    /// Where it is in the plan of the square's chart, metres.
    at: DVec2,
    /// How many quarter turns from +x to +z lead there from that at +x and +z.
    quarters: u8,
    /// Whether its stone is the square's.
    is_own: bool,
}

/// Those of a chart; none but in a world in squares of which five meet.
pub(crate) fn corners(space: &dyn Atlas, chart: ChartId) -> Vec<Corner> {
    let Some(tiled) = space.tiled() else {
        return Vec::new();
    };
    let half_m = space.domain(chart).half_width_m();
    let corner = |quarters: u8| {
        let about = about_corner(tiled, chart, quarters);
        let least = about.iter().map(|(tile, _)| *tile).min()?;
        let (x, z) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][usize::from(quarters)];
        (about.len() == SQUARES).then_some(Corner {
            at: DVec2::new(x, z) * half_m,
            quarters,
            is_own: least == chart,
        })
    };
    (0..4).filter_map(corner).collect()
}

impl Corner {
    /// Whether a thing that reaches so far about a place of the plan leaves room for the stone here, metres.
    pub fn leaves(&self, at: DVec2, reach_m: f64) -> bool {
        self.at.distance(at) > reach_m + CLEAR_M
    }

    /// The stone, if it is the chart's, is wanted, and has ground: its root in the chart, and all else of it.
    pub fn stone(
        &self,
        field: &Field,
        chart: ChartId,
        is_wanted: impl Fn(DVec3) -> bool,
    ) -> Option<(DVec3, Thing)> {
        // A hair within its square, so that it is one of the square's chunks that has it.
        let within = self.at * (1.0 - 1e-6);
        if !self.is_own || !is_wanted(DVec3::new(within.x, 0.0, within.y)) {
            return None;
        }
        let footing = field.thin_footing(chart, self.at.x, self.at.y)?;
        let thing = Thing {
            root: Vec3::ZERO,
            slot: SLOT,
            species: Species::CornerStone.byte(),
            age: Age::Grown.byte(),
            turn_rad: f32::from(self.quarters) * FRAC_PI_2,
            scale: 1.0,
        };
        let root = DVec3::new(self.at.x, footing.height_m, self.at.y);
        Some((root, thing))
    }
}

/// A level way in metres of the space at a corner in the chart, where the corner is turned by so much from +x and +z towards
/// +z.
pub(crate) fn in_chart(way: Vec2, turn_rad: f32) -> Vec2 {
    stretched(way, turn_rad, [ALONG.recip(), ACROSS.recip()])
}

/// The normal in the chart at the corner at +x and +z of what has one in the space: it goes by the inverse of what takes ways
/// there.
pub(crate) fn normal_in_chart(normal: Vec3) -> Vec3 {
    let level = stretched(Vec2::new(normal.x, normal.z), 0.0, [ALONG, ACROSS]);
    Vec3::new(level.x, normal.y, level.y).normalize_or(Vec3::Y)
}

fn stretched(way: Vec2, turn_rad: f32, [along, across]: [f32; 2]) -> Vec2 {
    let diagonal = Vec2::from_angle(FRAC_PI_4 + turn_rad);
    way * across + diagonal * (way.dot(diagonal) * (along - across))
}
