//! The charts of a tile: there and back, shared edges, and how they stretch.

use antipode_geometry::charts::cylindrical;
use antipode_geometry::tiling::{
    APOTHEM, CORNER_DISTANCE, Side, cylindrical_chart, equiangular_chart, equiangular_point,
};
use glam::{DVec3, DVec4};
use proptest::prelude::{prop_assert, proptest};

use super::common::{outward, sides};
use crate::space::common::cases;

proptest! {
    #![proptest_config(cases(2048))]

    #[test]
    fn charts_lead_there_and_back(x in -0.75..0.75_f64, y in -1.0..1.0_f64, z in -0.75..0.75_f64) {
        let chart = DVec3::new(x, y, z);
        for (point, back) in [
            (equiangular_point(chart).unwrap(), equiangular_chart as fn(DVec4) -> DVec3),
            (cylindrical(-1.0, chart), cylindrical_chart),
        ] {
            let form = point.w * point.w - point.truncate().length_squared();
            prop_assert!((form - 1.0).abs() < 1e-14 * point.w * point.w);
            prop_assert!((back(point) - chart).length() < 2e-15);
        }
    }

    /// What makes ground without a seam of tiles that know nothing of each other.
    #[test]
    fn a_point_of_a_shared_edge_has_one_coordinate_along_it(
        drawn in sides(50), side in 0_u8..4, eta in -0.6..0.6_f64, y in -0.6..0.6_f64,
    ) {
        let frame = outward(&drawn, 50.0);
        let side = Side::new(side);
        let next = frame.neighbour(side).unwrap();
        // Along a side and outwards over it, as the chart's x and z have them.
        let at = |side: Side, out: f64, along: f64| match side.number() {
            0 => DVec3::new(out, y, along),
            1 => DVec3::new(-along, y, out),
            2 => DVec3::new(-out, y, -along),
            _ => DVec3::new(along, y, -out),
        };
        let here = equiangular_point(at(side, APOTHEM, eta)).unwrap();
        let way = next.frame.between(&frame).unwrap().lorentz();
        // From the other tile the edge runs the other way.
        let expected = at(next.back, APOTHEM, -eta);
        let there = equiangular_chart(way * here);
        prop_assert!((there - expected).abs().max_element() < 2e-15, "{} {}", there, expected);
        let again = equiangular_point(expected).unwrap();
        prop_assert!((again - way * here).abs().max_element() < 4e-15);
    }
}

#[test]
fn a_chart_ends_where_the_plane_does() {
    assert!(equiangular_point(DVec3::new(0.9, 0.0, 0.85)).is_some());
    assert_eq!(equiangular_point(DVec3::new(0.9, 0.0, 0.9)), None);
    assert_eq!(equiangular_point(DVec3::new(3.0, 0.0, -3.0)), None);
    assert_eq!(equiangular_point(DVec3::NAN), None);
    assert_eq!(cylindrical_chart(DVec4::W), DVec3::ZERO);
}

/// The least and the greatest length in the space of one of the chart, level, by differences of points.
fn stretch(point: impl Fn(DVec3) -> DVec4, at: DVec3) -> [f64; 2] {
    let slope = |axis: DVec3| (point(at + axis * 1e-6) - point(at - axis * 1e-6)) / 2e-6;
    let inner = |a: DVec4, b: DVec4| a.truncate().dot(b.truncate()) - a.w * b.w;
    let (x, z) = (slope(DVec3::X), slope(DVec3::Z));
    let (e, f, g) = (inner(x, x), inner(x, z), inner(z, z));
    let (mean, half) = (0.5 * (e + g), (0.5 * (e - g)).hypot(f));
    [(mean - half).sqrt(), (mean + half).sqrt()]
}

#[test]
fn charts_stretch_as_much_as_said() {
    let diagonal = CORNER_DISTANCE * std::f64::consts::FRAC_1_SQRT_2;
    let equiangular = |at: DVec3| equiangular_point(at).unwrap();
    let polar = |at: DVec3| cylindrical(-1.0, at);
    let [middle, corner] = [DVec3::X * APOTHEM, DVec3::new(diagonal, 0.0, diagonal)];
    let own = DVec3::new(APOTHEM, 0.0, APOTHEM);
    for (ours, expected) in [
        (stretch(polar, middle), [1.0, 1.05]),
        (stretch(polar, corner), [1.0, 1.12]),
        (stretch(equiangular, middle), [1.0, 1.14]),
        (stretch(equiangular, own), [1.05, 1.45]),
        (
            stretch(equiangular, own * (1.0 + 0.1 / APOTHEM)),
            [1.12, 1.83],
        ),
    ] {
        println!("{ours:?}");
        for (a, b) in ours.into_iter().zip(expected) {
            assert!((a - b).abs() < 0.006, "{ours:?} {expected:?}");
        }
    }
}
