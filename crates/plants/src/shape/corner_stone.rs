//! The stone at a corner of five squares: a dark prism whose five arrises point along their edges, pale up to a star on its top.
//!
//! It is told in metres of the chart at the corner at +x and +z, where an edge leads straight out along the diagonal.

use std::f32::consts::{FRAC_PI_4, TAU};

use glam::{Vec2, Vec3, Vec3Swizzles};

use super::mesh::{Colour, Mesh, rgb};
use super::plan::Build;
use super::trunk::DEPTH;
use super::{Material, Shape, Size};
use crate::corner::{in_chart, normal_in_chart};

const BODY: Colour = rgb(74, 72, 80);
const SIGN: Colour = rgb(244, 234, 206);
/// The top as it looks where nobody sees a star.
const MIXED: Colour = rgb(190, 182, 164);
/// How high the sides reach, and where the pale arrises begin, metres.
const SHOULDER_M: f32 = 1.36;
const SIGN_FROM_M: f32 = 0.05;
/// How wide it is there, as a share of its foot.
const TAPER: f32 = 0.8;
/// The share of the width of a side that is pale at either end.
const ARRIS: f32 = 0.15;
/// How far out the star's inner corners are, as a share of the way to the middle of a side.
const INNER: f32 = 0.47;

/// A stone of a build, in a size.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let mut stone = Stone {
        mesh: Mesh::default(),
        build,
        sides: if size == Size::Far { 4 } else { 5 },
    };
    for side in 0..stone.sides {
        match size {
            Size::Near => {
                let middle_m = 0.5 * SHOULDER_M;
                stone.plain(side, [-DEPTH, SIGN_FROM_M]);
                stone.signed(side, [SIGN_FROM_M, middle_m]);
                stone.signed(side, [middle_m, SHOULDER_M]);
                stone.star(side);
            }
            Size::Middle => {
                stone.plain(side, [-DEPTH, SIGN_FROM_M]);
                stone.signed(side, [SIGN_FROM_M, SHOULDER_M]);
                stone.star(side);
            }
            Size::Coarse | Size::Far => {
                stone.plain(side, [-DEPTH, SHOULDER_M]);
                let [from, to] = stone.ends(side, SHOULDER_M);
                stone.face([to, from, stone.top()], MIXED);
            }
        }
    }
    stone.mesh.finish()
}

/// One in the making, in metres of the space.
struct Stone {
    mesh: Mesh,
    build: Build,
    sides: usize,
}

impl Stone {
    fn top(&self) -> Vec3 {
        Vec3::Y * self.build.height
    }

    /// The ends of a side at a height, as one turns from x to z.
    fn ends(&self, side: usize, y: f32) -> [Vec3; 2] {
        let share = (y / SHOULDER_M).clamp(0.0, 1.0);
        let out_m = self.build.radius * (1.0 - share * (1.0 - TAPER));
        [side, side + 1].map(|n| {
            let turn = FRAC_PI_4 + TAU * n as f32 / self.sides as f32;
            (Vec2::from_angle(turn) * out_m).extend(y).xzy()
        })
    }

    /// A side between two heights.
    fn plain(&mut self, side: usize, heights: [f32; 2]) {
        self.strip(side, heights, [0.0, 1.0], BODY);
    }

    /// The same with pale ends.
    fn signed(&mut self, side: usize, heights: [f32; 2]) {
        self.strip(side, heights, [0.0, ARRIS], SIGN);
        self.strip(side, heights, [ARRIS, 1.0 - ARRIS], BODY);
        self.strip(side, heights, [1.0 - ARRIS, 1.0], SIGN);
    }

    /// A part of the width of a side.
    fn strip(&mut self, side: usize, heights: [f32; 2], shares: [f32; 2], colour: Colour) {
        let [low, high] = heights.map(|y| {
            let [from, to] = self.ends(side, y);
            shares.map(|share| from.lerp(to, share))
        });
        self.face([low[1], low[0], high[1]], colour);
        self.face([low[0], high[0], high[1]], colour);
    }

    /// What of the top is over a side: two halves of rays of the star, and what is between.
    fn star(&mut self, side: usize) {
        let [from, to] = self.ends(side, SHOULDER_M);
        let inner = self.top().lerp(from.midpoint(to), INNER);
        self.face([inner, from, self.top()], SIGN);
        self.face([to, inner, self.top()], SIGN);
        self.face([to, from, inner], BODY);
    }

    /// A flat triangle, counter-clockwise seen from outside.
    fn face(&mut self, places: [Vec3; 3], colour: Colour) {
        let [a, b, c] = places;
        let normal = normal_in_chart((b - a).cross(c - a));
        let [a, b, c] = places.map(|it| {
            let level = in_chart(Vec2::new(it.x, it.z), 0.0);
            let place = Vec3::new(level.x, it.y, level.y);
            self.mesh
                .corner(place, normal, colour, Material::Stone, 0.0)
        });
        self.mesh.triangle(a, b, c);
    }
}
