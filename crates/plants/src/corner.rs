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
use antipode_geometry::{Atlas, ChartId, ChartPoint, ChunkCoord};
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

/// Stones line the edges about a corner from the first of these on, each so much farther, to the last: metres of the chart.
const LINED_M: [f64; 3] = [1.37, 0.77, 11.0];
/// How far within a square those of its edges lie, metres of the chart.
const LINED_WITHIN_M: f64 = 0.2;

/// A corner of a square where five meet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    /// Where it is in the plan of the square's chart, metres.
    at: DVec2,
    /// How many quarter turns from +x to +z lead there from that at +x and +z.
    quarters: u8,
    /// The square whose the stone is, and which of its corners this is.
    owner: (ChartId, u8),
}

/// Those of a chart; none but in a world in squares of which five meet.
pub(crate) fn corners(space: &dyn Atlas, chart: ChartId) -> Vec<Corner> {
    let Some(tiled) = space.tiled() else {
        return Vec::new();
    };
    let half_m = space.domain(chart).half_width_m();
    let corner = |quarters: u8| {
        let about = about_corner(tiled, chart, quarters);
        let owner = about.iter().min().copied()?;
        (about.len() == SQUARES).then_some(Corner {
            at: place_of(half_m, quarters),
            quarters,
            owner,
        })
    };
    (0..4).filter_map(corner).collect()
}

/// Where a corner lies in the plan of a square of half such a width, metres.
fn place_of(half_m: f64, quarters: u8) -> DVec2 {
    let (x, z) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][usize::from(quarters % 4)];
    DVec2::new(x, z) * half_m
}

/// Where stones line the edges of a square about its corners, in the plan of its chart, metres: five ways between two rows each lead from a
/// corner, so that one sees how many squares meet there.
pub(crate) fn lined(space: &dyn Atlas, chart: ChartId) -> Vec<DVec2> {
    let [first, step, last] = LINED_M;
    let many = ((last - first) / step) as u32;
    let corners = corners(space, chart).into_iter();
    let along = corners.flat_map(|it| {
        let back = -it.at.signum();
        let ways = [DVec2::new(back.x, 0.0), DVec2::new(0.0, back.y)];
        ways.map(move |way| (it.at + (back - way) * LINED_WITHIN_M, way))
    });
    along
        .flat_map(|(from, way)| (0..=many).map(move |n| from + way * (first + step * f64::from(n))))
        .collect()
}

/// A hair within the square of a corner: so it is one of the square's chunks that has it.
fn within(corner: DVec2) -> DVec3 {
    let at = corner * (1.0 - 1e-6);
    DVec3::new(at.x, 0.0, at.y)
}

/// What is solid on a chunk of stones that are other squares', told from its corner, and the chunk that each is a thing of. Whoever
/// comes from a square meets what is solid in its chart.
pub fn stones_of_others(field: &Field, coord: ChunkCoord) -> Vec<(Thing, ChunkCoord)> {
    let space = &**field.strategy();
    if !field.generator().has_things() {
        return Vec::new();
    }
    let others = corners(space, coord.chart).into_iter();
    let others = others.filter(|it| it.owner.0 != coord.chart);
    let solid = |it: Corner| {
        let (root, thing) = it.stone(field, coord.chart)?;
        let is_here =
            ChunkCoord::containing(ChartPoint::new(coord.chart, within(it.at).with_y(root.y)))
                == coord;
        let (owner, quarters) = it.owner;
        let half_m = space.domain(owner).half_width_m();
        let home = within(place_of(half_m, quarters)).with_y(root.y);
        let root = (root - coord.origin()).as_vec3();
        let home = ChunkCoord::containing(ChartPoint::new(owner, home));
        is_here.then_some((Thing { root, ..thing }, home))
    };
    others.filter_map(solid).collect()
}

impl Corner {
    /// Whether a thing that reaches so far about a place of the plan leaves room for the stone here, metres.
    pub fn leaves(&self, at: DVec2, reach_m: f64) -> bool {
        self.at.distance(at) > reach_m + CLEAR_M
    }

    /// The stone, if it is the chart's and is wanted.
    pub fn own_stone(
        &self,
        field: &Field,
        chart: ChartId,
        is_wanted: impl Fn(DVec3) -> bool,
    ) -> Option<(DVec3, Thing)> {
        let is_own = self.owner.0 == chart && is_wanted(within(self.at));
        is_own.then(|| self.stone(field, chart)).flatten()
    }

    /// The stone, if it has ground: its root in the chart, and all else of it.
    fn stone(&self, field: &Field, chart: ChartId) -> Option<(DVec3, Thing)> {
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
