//! The port and its inverse, everywhere the game uses them.

use antipode_geometry::{Atlas, ChartId, ChartPoint, Geometry, Map, Spherical};
use glam::DVec3;
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{all_spaces, cases, chart_point, eye, in_space, spaces, vector};

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn chart_points_come_back(eye in eye(50.0), step in vector(150.0)) {
        for space in spaces().into_iter().filter(|s| s.geometry() != Geometry::Spherical) {
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            let point = eye.point.moved(step);
            let back = space.chart_point(&eye, space.view_point(&eye, point));
            prop_assert!((back.pos - point.pos).length() < 1e-10);
        }
    }

    #[test]
    fn spherical_chart_points_come_back(eye in eye(50.0), point in chart_point(50.2)) {
        let space = Spherical::new(32.0);
        let back = space.chart_point(&eye, space.view_point(&eye, point));
        prop_assert_eq!(back.chart, point.chart);
        prop_assert!((back.pos - point.pos).length() < 1e-11);
    }

    #[test]
    fn distances_are_a_metric(eye in eye(50.0), a in chart_point(50.0), b in chart_point(50.0)) {
        for space in all_spaces() {
            let (a, b) = (in_space(space.as_ref(), a), in_space(space.as_ref(), b));
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            let ab = space.distance_m(a, b, &eye);
            prop_assert!((ab - space.distance_m(b, a, &eye)).abs() < 1e-12 * (1.0 + ab));
            prop_assert_eq!(space.distance_m(a, a, &eye), 0.0);
            let seen = space.eye_distance_m(&eye, space.view_point(&eye, a));
            let to_eye = space.distance_m(a, eye.point, &eye);
            prop_assert!((seen - to_eye).abs() < 1e-11 * (1.0 + seen));
            let around = to_eye + space.distance_m(eye.point, b, &eye);
            prop_assert!(ab <= around + 1e-11 * (1.0 + around));
        }
    }

    #[test]
    fn walking_along_a_geodesic_covers_its_length(
        eye in eye(50.0), to in vector(1.0), distance in 0.01..99.0_f64,
    ) {
        for space in all_spaces() {
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            let end = space.along(&eye, to.normalize_or(DVec3::X), distance);
            let there = space.distance_m(eye.point, end, &eye);
            prop_assert!((there - distance).abs() < 1e-10 * (1.0 + distance));
        }
    }
}

#[test]
fn points_across_the_equator_come_back_in_their_own_chart() {
    let space = Spherical::new(32.0);
    let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
    let eye = antipode_geometry::Eye {
        point: ChartPoint::a(DVec3::new(rim - 1.0, 9.0, 0.0)),
        ..Default::default()
    };
    for over in [1e-9, 1e-3, 0.5, 10.0] {
        let past = ChartPoint::a(DVec3::new(rim + over, 5.0, 2.0));
        let back = space.chart_point(&eye, space.view_point(&eye, past));
        let carried = space.images(past, f64::INFINITY)[0].point;
        assert_eq!(back.chart, ChartId::SECOND);
        assert!((back.pos - carried.pos).length() < 1e-12, "{over}");
    }
    for chart in [ChartId::FIRST, ChartId::SECOND] {
        let pole = ChartPoint::new(chart, DVec3::Y * 5.0);
        let back = space.chart_point(&eye, space.view_point(&eye, pole));
        assert_eq!(back.chart, chart);
        assert!((back.pos - pole.pos).length() < 1e-12);
    }
}

#[test]
fn tiny_separations_have_exact_distances() {
    let eye = antipode_geometry::Eye {
        dial: 10.0,
        ..Default::default()
    };
    for space in all_spaces() {
        for gap in [1e-3, 1e-6, 1e-9] {
            let (a, b) = (DVec3::new(0.0, 5.0, 0.0), DVec3::new(0.0, 5.0 + gap, 0.0));
            let gap = b.y - a.y; // as the inputs have it
            let distance = space.distance_m(ChartPoint::a(a), ChartPoint::a(b), &eye);
            // Straight up is a geodesic at unit scale from every offset centre below.
            assert!(
                (distance / gap - 1.0).abs() < 1e-5,
                "{:?} {gap}: {distance}",
                space.geometry()
            );
        }
    }
}
