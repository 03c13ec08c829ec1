//! Which aberrations are tunnels that a raster sees through: with walls and doors, felt both ways, and clear of the faces of all
//! others, so that each of their doors leads to one place.

use antipode_deformation::{Placed, Sides, Space, Ways};

/// Faces that are nearer to each other than this share of their coordinates may coincide by rounding.
const CLEAR: f64 = 1e-5;

/// Whether each aberration is such a tunnel.
pub fn tidy(space: &Space) -> Vec<bool> {
    let all = space.placed();
    let is_tidy = |(number, one): (usize, &Placed)| {
        let aberration = &one.aberration;
        aberration.sides == Sides::Walls
            && aberration.ways == Ways::Both
            && all
                .iter()
                .enumerate()
                .all(|(other, against)| other == number || is_clear(one, against))
    };
    all.iter().enumerate().map(is_tidy).collect()
}

/// How near to each other faces of two boxes may be, metres.
pub fn clearance(one: &Placed) -> f64 {
    let reach = one.aberration.centre.abs() + one.aberration.half;
    CLEAR * (1.0 + reach.max_element())
}

/// Whether two boxes lie apart or one within the other, and their faces do not meet.
fn is_clear(one: &Placed, other: &Placed) -> bool {
    let clear_m = clearance(one).max(clearance(other));
    let between = |a: &Placed, b: &Placed| {
        let away = a.local(b.aberration.centre).abs();
        let reach = (a.axes.transpose() * b.axes).abs() * b.aberration.half;
        (away, reach, a.aberration.half)
    };
    let is_apart = |a: &Placed, b: &Placed| {
        let (away, reach, half) = between(a, b);
        (away - reach - half).max_element() > clear_m
    };
    let holds = |a: &Placed, b: &Placed| {
        let (away, reach, half) = between(a, b);
        (away + reach - half).max_element() < -clear_m
    };
    is_apart(one, other) || is_apart(other, one) || holds(one, other) || holds(other, one)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_deformation::Aberration;
    use glam::{DQuat, DVec3};

    use super::*;

    fn tunnel(z: f64, half: f64, turn: f64) -> Aberration {
        let half = DVec3::new(half, half, 2.0 * half);
        let turn = DQuat::from_rotation_y(turn);
        Aberration::tunnel(z * DVec3::Z, turn, half, 2, 9.0)
    }

    fn found(all: Vec<Aberration>) -> Vec<bool> {
        tidy(&Space::new(all).unwrap())
    }

    #[test]
    fn tunnels_apart_and_within_each_other_are_tidy() {
        let all = vec![
            tunnel(0.0, 2.0, 0.0),
            tunnel(0.3, 0.5, 0.4),
            tunnel(9.0, 2.0, 0.7),
        ];
        assert_eq!(found(all), [true; 3]);
    }

    #[test]
    fn what_touches_bends_or_is_felt_one_way_is_not() {
        // Doors in a row.
        let touching = vec![
            tunnel(0.0, 2.0, 0.0),
            tunnel(8.0, 2.0, 0.0),
            tunnel(30.0, 2.0, 0.0),
        ];
        assert_eq!(found(touching), [false, false, true]);
        // Two that share a door's plane.
        let flush = vec![tunnel(0.0, 2.0, 0.0), tunnel(2.0, 1.0, 0.0)];
        assert_eq!(found(flush), [false, false]);
        let soft = Aberration {
            sides: Sides::Soft,
            ..tunnel(0.0, 2.0, 0.0)
        };
        let one_way = Aberration {
            ways: Ways::Along(2),
            ..tunnel(20.0, 2.0, 0.0)
        };
        assert_eq!(found(vec![soft, one_way]), [false, false]);
    }
}
