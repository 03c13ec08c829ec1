//! When a straight path meets the faces of a box, in the box's own axes.
//!
//! A place counts by its distances to the planes of the faces rather than by times: near a face that is grazed a time is the
//! quotient of two small numbers and may be anything, a distance is off by rounding only.

use glam::DVec3;

/// Rounding of a place, as a share of the numbers that it is made of.
const ROUNDING: f64 = 1e-13;
/// In place of a speed of nought.
const LEAST_SPEED: f64 = 1e-200;

/// Distance within which a place may lie on either side of a face, for a place `l` about a box of half sizes `h`.
fn tolerance(l: DVec3, h: DVec3) -> f64 {
    ROUNDING * (1.0 + l.abs().max_element() + h.max_element())
}

fn pace(u: f64) -> (f64, f64) {
    (u.signum(), u.abs().max(LEAST_SPEED))
}

/// When and through which axis's face a path from `l` at velocity `u` enters the box of half sizes `h`, if it does; times
/// from 0. It is for boxes that one is not in: one that has just been left, so that one is at its far face, is not entered,
/// nor is one whose entering face lies behind.
pub fn crossing_in(l: DVec3, u: DVec3, h: DVec3) -> Option<(f64, usize)> {
    let slack = tolerance(l, h);
    let (mut enters, mut axis, mut before) = (f64::NEG_INFINITY, 0, 0.0);
    let mut leaves = f64::INFINITY;
    for i in 0..3 {
        let (sign, speed) = pace(u[i]);
        let (near, far) = (-h[i] - sign * l[i], h[i] - sign * l[i]);
        if far <= slack {
            return None;
        }
        if near / speed > enters {
            (enters, axis, before) = (near / speed, i, near);
        }
        leaves = leaves.min(far / speed);
    }
    (before >= -slack && enters < leaves).then(|| (enters.max(0.0), axis))
}

/// When and through which axis's face a path from `l` inside of the box leaves it; times from 0.
pub fn crossing_out(l: DVec3, u: DVec3, h: DVec3) -> (f64, usize) {
    let (mut leaves, mut axis) = (f64::INFINITY, 0);
    for i in 0..3 {
        let (sign, speed) = pace(u[i]);
        let time = (h[i] - sign * l[i]) / speed;
        if time < leaves {
            (leaves, axis) = (time, i);
        }
    }
    (leaves.max(0.0), axis)
}
