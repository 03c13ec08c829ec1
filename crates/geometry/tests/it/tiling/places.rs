//! Which tile a point lies in.

use antipode_geometry::tiling::{
    APOTHEM, CORNER_DISTANCE, EDGE_TANH, Frame, HALF_EDGE, Side, TilingError, equiangular_point,
    rings,
};
use glam::{DVec3, DVec4};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{outward, sides};
use crate::space::common::cases;

/// The point so far from the centre in that direction, at a height, in radii.
fn polar(radii: f64, angle_rad: f64, height: f64) -> DVec4 {
    let (level, up) = (height.cosh() * radii.sinh(), height.sinh());
    DVec4::new(
        level * angle_rad.cos(),
        up,
        level * angle_rad.sin(),
        height.cosh() * radii.cosh(),
    )
}

/// By how much a point is inside of the nearest edge, in X/W.
fn inside(point: DVec4) -> f64 {
    EDGE_TANH - point.x.abs().max(point.z.abs()) / point.w
}

#[test]
fn edges_and_corners_are_where_they_are_said_to_be() {
    assert!((APOTHEM.tanh() - EDGE_TANH).abs() < 2e-16);
    let corner = polar(CORNER_DISTANCE, std::f64::consts::FRAC_PI_4, 0.0);
    assert!((corner.x / corner.w - EDGE_TANH).abs() < 2e-16);
    // The edge's half: from the middle of the edge to the corner.
    let middle = polar(APOTHEM, 0.0, 0.0);
    let cosh = middle.w * corner.w - middle.x * corner.x;
    assert!((cosh.acosh() - HALF_EDGE).abs() < 1e-15);
    let phi = 0.5 + 1.25f64.sqrt();
    assert!((2.0 * APOTHEM - phi.acosh()).abs() < 4e-16);
    assert!(
        [
            APOTHEM - 0.53064,
            HALF_EDGE - 0.62687,
            CORNER_DISTANCE - 0.84248
        ]
        .iter()
        .all(|it| it.abs() < 5e-6)
    );
}

proptest! {
    #![proptest_config(cases(2048))]

    #[test]
    fn a_point_is_found_in_the_tile_that_it_lies_in(
        drawn in sides(50), radii in 0.0..9.0_f64, angle_rad in -3.2..3.2_f64, height in -0.6..0.6_f64,
    ) {
        let from = outward(&drawn, 40.0);
        let point = polar(radii, angle_rad, height);
        let place = from.place(point).unwrap();
        // A coordinate's last place at distance r, carried to the other side.
        let lost = 1e-15 * (2.0 * radii).exp();
        prop_assert!(inside(place.point) > -2e-14 - lost);
        prop_assert_eq!(place.way, place.frame.between(&from).unwrap());
        prop_assert!((place.point.y - point.y).abs() < 1e-15);
        // It is the tile with the nearest centre.
        for side in Side::ALL {
            let next = place.frame.neighbour(side).unwrap().frame;
            let seen = next.between(&place.frame).unwrap().lorentz() * place.point;
            prop_assert!(seen.w > place.point.w * (1.0 - 1e-13) - lost);
        }
    }

    #[test]
    fn a_point_on_an_edge_is_in_the_tile_that_is_asked(
        drawn in sides(50), eta in -0.5306..0.5306_f64, height in -0.5..0.5_f64, off in -1..=1_i32,
    ) {
        let from = outward(&drawn, 40.0);
        let mut point = equiangular_point(DVec3::new(APOTHEM, height, eta)).unwrap();
        // To a rounding on either side of it.
        point.x += f64::from(off) * f64::EPSILON;
        prop_assert_eq!(from.place(point).unwrap().frame, from);
        let next = from.neighbour(Side::new(0)).unwrap();
        let there = next.frame.between(&from).unwrap().lorentz() * point;
        prop_assert_eq!(next.frame.place(there).unwrap().frame, next.frame);
        // A little farther it is in one of the two, whoever is asked.
        for past in [1e-12, -1e-12] {
            let point = point + DVec4::X * past;
            let there = next.frame.between(&from).unwrap().lorentz() * point;
            let one = from.place(point).unwrap();
            prop_assert_eq!(one.frame, next.frame.place(there).unwrap().frame);
            prop_assert_eq!(one.frame == from, past < 0.0);
        }
    }
}

#[test]
fn a_point_on_a_corner_is_in_each_of_the_five_tiles_and_found_from_all_others() {
    let corner = polar(CORNER_DISTANCE, std::f64::consts::FRAC_PI_4, 0.2);
    let near: Vec<Frame> = rings(&Frame::ROOT, 4, 200).unwrap().concat();
    let mut own = 0;
    for frame in near {
        let seen = frame.between(&Frame::ROOT).unwrap().lorentz() * corner;
        let place = frame.place(seen).unwrap();
        assert!(inside(place.point) > -2e-14);
        own += usize::from(place.frame == frame);
    }
    assert_eq!(own, 5);
}

#[test]
fn what_is_no_point_and_what_is_too_far_are_errors() {
    for point in [
        DVec4::ZERO,
        DVec4::NAN,
        DVec4::new(1.0, 0.0, 1.0, 1.2),
        DVec4::new(0.0, 0.0, 0.0, -1.0),
        DVec4::W * f64::INFINITY,
    ] {
        assert_eq!(
            Frame::ROOT.place(point),
            Err(TilingError::NoPoint),
            "{point}"
        );
    }
    assert_eq!(
        Frame::ROOT.place(polar(14.0, 1.0, 0.0)),
        Err(TilingError::OutOfReach)
    );
    for step in 0..3600 {
        let place = Frame::ROOT
            .place(polar(13.0, f64::from(step) * 1e-3, 0.0))
            .unwrap();
        assert!((place.way.distance() - 13.0).abs() < CORNER_DISTANCE + 0.01);
    }
    // At the end of the world there is nothing to go over to.
    let mut frame = outward(&[Side::new(0)], 74.0);
    while let Ok(next) = frame.neighbour(Side::new(0)) {
        frame = next.frame;
    }
    assert_eq!(
        frame.place(polar(1.0, 0.0, 0.0)),
        Err(TilingError::OutOfReach)
    );
}
