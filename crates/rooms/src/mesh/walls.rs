//! The walls that an aberration makes for itself where its faces are no doors.
//!
//! A wall lies on both sides of its face, so that from inside a ray meets it before it leaves, and from outside before
//! it enters, however the last digit is rounded.

use glam::DVec3;

use super::blocks::block;
use super::builder::Builder;
use crate::aberration::{Aberration, Axis, Sides};

/// How far a wall reaches into its aberration, metres.
pub const WALL_INSIDE_M: f64 = 0.005;
/// How far a wall reaches out of its aberration, metres.
pub const WALL_OUTSIDE_M: f64 = 0.05;

pub(super) fn walls(out: &mut Builder, it: &Aberration) {
    if it.sides != Sides::Walls {
        return;
    }
    let doors = it.doors();
    // Walls of a later axis reach over the edges of those of an earlier one, and not over doors.
    let mut reach = it.half;
    for axis in Axis::ALL
        .map(Axis::index)
        .into_iter()
        .filter(|axis| !doors[*axis])
    {
        for side in [-1.0, 1.0] {
            let (mut least, mut most) = (-reach, reach);
            let bounds = [
                it.half[axis] - WALL_INSIDE_M,
                it.half[axis] + WALL_OUTSIDE_M,
            ]
            .map(|at| side * at);
            least[axis] = bounds[0].min(bounds[1]);
            most[axis] = bounds[0].max(bounds[1]);
            block(out, DVec3::min(least, most), DVec3::max(least, most));
        }
        reach[axis] += WALL_OUTSIDE_M;
    }
}
