//! The ground plan of a box of a chart, seen from the foot of an eye.
//!
//! Lines along the grid of an equiangular chart are geodesics, so that a rectangle of it has four straight sides, and in the
//! Klein disc about the eye's foot, (X/W, Z/W), it is a quadrilateral with straight sides, too. There directions are those seen
//! at the foot, and a place at a distance d is `tanh d` away: the nearest of the quadrilateral is the nearest in the space,
//! and its corners have the greatest distance and the outermost directions.

use std::f64::consts::PI;

use glam::DVec2;

use crate::sight::Plan;

/// Distances are told to so many radii: past it `tanh d` has no digits left.
const FARTHEST_RAD: f64 = 15.0;
/// So near to the eye's foot, in the disc, a quadrilateral lies all around it.
const UNDERFOOT: f64 = 1e-9;
/// What roundings may do to directions.
const SLACK_RAD: f64 = 1e-9;

/// The plan of a quadrilateral by its corners in the disc, in their order, and a place within it.
pub(super) fn plan(corners: [DVec2; 4], middle: DVec2, radius_m: f64) -> Plan {
    let sides = (0..4).map(|i| (corners[i], corners[(i + 1) % 4]));
    let nearest = sides
        .clone()
        .map(|(from, to)| to_segment(from, to))
        .fold(f64::INFINITY, f64::min);
    let farthest = corners.iter().map(|it| it.length()).fold(0.0, f64::max);
    let around = is_around(corners);
    let metres = |disc: f64| radius_m * disc.atanh();
    let far_m = radius_m * FARTHEST_RAD;
    let greatest_m = if farthest < FARTHEST_RAD.tanh() {
        metres(farthest)
    } else {
        f64::INFINITY
    };
    if around || nearest < UNDERFOOT {
        return Plan {
            azimuth_rad: 0.0,
            half_width_rad: PI,
            level_m: [0.0, greatest_m],
        };
    }
    let [least, most] = spread_rad(corners, middle);
    let half_width_rad = most.max(-least);
    Plan {
        azimuth_rad: middle.y.atan2(middle.x),
        half_width_rad: half_width_rad + SLACK_RAD,
        level_m: [metres(nearest.min(1.0)).min(far_m), greatest_m],
    }
}

/// The least and the greatest azimuth of a quadrilateral from the disc's middle; none where it lies around that.
pub(super) fn azimuths_rad(corners: [DVec2; 4], middle: DVec2) -> Option<[f64; 2]> {
    let heading = middle.y.atan2(middle.x);
    let spread = || spread_rad(corners, middle).map(|aside| heading + aside);
    (!is_around(corners)).then(spread)
}

/// How far its corners are to the sides of a direction.
fn spread_rad(corners: [DVec2; 4], ahead: DVec2) -> [f64; 2] {
    let parts = corners.map(|corner| (ahead.perp_dot(corner), ahead.dot(corner)));
    let range = |aside: [f64; 4]| {
        let least = aside.into_iter().fold(0.0, f64::min);
        [least, aside.into_iter().fold(0.0, f64::max)]
    };
    // Before one, tangents grow as angles do, and two of these are enough.
    if parts.iter().all(|(_, along)| *along > 0.0) {
        range(parts.map(|(across, along)| across / along)).map(f64::atan)
    } else {
        range(parts.map(|(across, along)| across.atan2(along)))
    }
}

/// Whether the middle of the disc lies in it.
fn is_around(corners: [DVec2; 4]) -> bool {
    let turns = (0..4).map(|i| corners[i].perp_dot(corners[(i + 1) % 4]) > 0.0);
    turns.clone().all(|it| it) || !turns.clone().any(|it| it)
}

/// How far the nearest place between two is from the middle.
fn to_segment(from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let square = way.length_squared();
    let part = if square > 0.0 {
        (-from.dot(way) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from + way * part).length()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(middle: DVec2, half: f64) -> [DVec2; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, z)| middle + DVec2::new(x, z) * half)
    }

    #[test]
    fn who_stands_on_a_square_has_it_all_around() {
        for middle in [DVec2::ZERO, DVec2::new(0.05, -0.08), DVec2::new(0.1, 0.0)] {
            let mut corners = square(middle, 0.1);
            for _ in 0..2 {
                let plan = plan(corners, middle, 10.0);
                assert_eq!(plan.half_width_rad, PI);
                assert_eq!(plan.level_m[0], 0.0);
                corners.reverse();
            }
        }
    }

    #[test]
    fn a_square_aside_is_seen_between_its_corners() {
        let middle = DVec2::new(0.0, 0.5);
        let plan = plan(square(middle, 0.1), middle, 10.0);
        assert!((plan.azimuth_rad - 0.5 * PI).abs() < 1e-12);
        assert!((plan.half_width_rad - 0.25_f64.atan()).abs() < 1e-8);
        let corners = square(DVec2::new(0.3, 0.5), 0.1);
        let middle = DVec2::new(0.3, 0.4);
        let [least, most] = azimuths_rad(corners, middle).unwrap_or_default();
        assert!((least - 1.0_f64.atan()).abs() < 1e-12 && (most - 3.0_f64.atan()).abs() < 1e-12);
        assert_eq!(azimuths_rad(square(DVec2::ZERO, 0.1), DVec2::ZERO), None);
        let [near, far] = plan.level_m.map(|it| (it / 10.0).tanh());
        assert!((near - 0.4).abs() < 1e-12 && (far - 0.1_f64.hypot(0.6)).abs() < 1e-12);
    }
}
