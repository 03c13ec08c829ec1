//! Triangles that a plane cuts.

use glam::DVec3;

/// The part of a triangle where `inside` is not negative, in triangles that run as it does. `inside` is linear: metres from a plane.
pub(super) fn cut(corners: [DVec3; 3], inside: impl Fn(DVec3) -> f64, out: &mut Vec<[DVec3; 3]>) {
    let mut kept: Vec<DVec3> = Vec::with_capacity(4);
    for at in 0..3 {
        let (a, b) = (corners[at], corners[(at + 1) % 3]);
        let (from, to) = (inside(a), inside(b));
        if from >= 0.0 {
            kept.push(a);
        }
        if (from >= 0.0) != (to >= 0.0) {
            kept.push(a.lerp(b, from / (from - to)));
        }
    }
    for at in 2..kept.len() {
        out.push([kept[0], kept[at - 1], kept[at]]);
    }
}
