//! Limits of the parameters: curvature to zero, the dial at zero, every magnitude.

use antipode_geometry::{ChartPoint, Euclidean, Eye, Map, Metric, Raised, Spherical, Strategy};
use glam::{DVec2, DVec3};
use proptest::prelude::{prop_assert, proptest};

use super::common::{cases, pixel, vector};

fn looking(pos: DVec3) -> Eye {
    Eye {
        point: ChartPoint::a(pos),
        yaw: 0.4,
        pitch: -0.2,
        roll: 0.0,
        dial: 10.0,
        lift_m: 1.62,
    }
}

/// Distance in metres between the flat view of a point and the view at that radius.
fn off_flat(space: &dyn Strategy, eye: &Eye, point: ChartPoint) -> f64 {
    let flat = Euclidean.view_point(eye, point);
    (space.view_point(eye, point) - flat).truncate().length()
}

#[test]
fn vanishing_curvature_is_the_flat_picture_to_second_order() {
    // The eye is high and off the pole, so that the sphere's chart stretches at the eye too.
    let eye = looking(DVec3::new(3.0, 4.0, -2.0));
    let point = ChartPoint::a(DVec3::new(12.0, 1.0, 5.0));
    let raised = |radius: f64| off_flat(&Raised::new(radius), &eye, point);
    let sphere = |radius: f64| off_flat(&Spherical::new(radius), &eye, point);
    for error in [&raised as &dyn Fn(f64) -> f64, &sphere] {
        for radius in [2e3, 2e4, 2e5] {
            let fall = error(radius) / error(10.0 * radius);
            // The least radius whose error is still above the rounding of R * eps.
            assert!(
                (fall - 100.0).abs() < 2.0 || radius > 2e4,
                "{radius}: {fall}"
            );
            assert!(error(radius) < 3e3 / (radius * radius) + 1e-15 * radius);
        }
    }
}

#[test]
fn raised_is_regular_down_to_no_curvature_at_all() {
    let eye = looking(DVec3::ZERO);
    let point = ChartPoint::a(DVec3::new(12.0, 1.0, 5.0));
    for exponent in 4..=30 {
        let space = Raised::new(10.0_f64.powi(exponent));
        let view = space.view_point(&eye, point);
        assert!(view.is_finite());
        assert!(off_flat(&space, &eye, point) < 1e4 * 10.0_f64.powi(-2 * exponent) + 1e-14);
    }
}

#[test]
fn a_sweep_of_the_dial_to_zero_has_no_step() {
    let space = Raised::new(20.0);
    let point = ChartPoint::a(DVec3::new(30.0, -4.0, 6.0));
    let mut last: Option<DVec2> = None;
    for i in (0..=20_000).rev() {
        let eye = Eye {
            roll: 0.0,
            dial: f64::from(i) * 1e-3,
            ..looking(DVec3::ZERO)
        };
        let here = pixel(&space, &eye, space.view_point(&eye, point)).unwrap();
        if let Some(last) = last {
            assert!((here - last).length() < 0.1, "dial {}", eye.dial);
        }
        last = Some(here);
    }
    let flat = pixel(
        &Euclidean,
        &looking(DVec3::ZERO),
        Euclidean.view_point(&looking(DVec3::ZERO), point),
    )
    .unwrap();
    assert!((last.unwrap() - flat).length() < 1e-9);
}

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn raised_with_the_dial_at_zero_is_the_flat_picture(
        at in vector(1e4), step in vector(200.0), yaw in -4.0..4.0_f64, pitch in -1.5..1.5_f64,
    ) {
        let eye = Eye { point: ChartPoint::a(at), yaw, pitch, ..Eye::default() };
        let point = ChartPoint::a(at + step);
        let flat = Euclidean.view_point(&eye, point);
        let raised = Raised::new(20.0).view_point(&eye, point);
        let gap = flat.truncate().normalize() - raised.truncate().normalize();
        prop_assert!(gap.length() < 1e-14, "{gap}");
    }

    #[test]
    fn raised_is_finite_at_every_magnitude(
        direction in vector(1.0), exponent in -300.0..300.0_f64, dial in 0.0..20.0_f64,
    ) {
        let space = Raised::new(20.0);
        let eye = Eye { dial, ..looking(DVec3::ZERO) };
        let point = ChartPoint::a(direction * 10.0_f64.powf(exponent));
        let view = space.view_point(&eye, point);
        prop_assert!(view.is_finite());
        prop_assert!(space.chart_point(&eye, view).pos.is_finite());
        prop_assert!(space.eye_distance_m(&eye, view).is_finite());
        prop_assert!(space.distance_m(point, eye.point, &eye).is_finite());
        prop_assert!(space.port_normal(&eye, point, DVec3::Y).is_finite());
    }
}

#[test]
fn a_useless_dial_is_taken_into_range() {
    let space = Raised::new(20.0);
    let point = ChartPoint::a(DVec3::new(3.0, 1.0, 2.0));
    let at = |dial| {
        space.view_point(
            &Eye {
                roll: 0.0,
                dial,
                ..looking(DVec3::ZERO)
            },
            point,
        )
    };
    assert_eq!(at(-5.0), at(0.0));
    assert_eq!(at(f64::NAN), at(0.0));
    assert_eq!(at(500.0), at(20.0));
}

#[test]
fn raised_is_exact_at_the_eye() {
    let space = Raised::new(20.0);
    for dial in [0.0, 1e-9, 10.0, 20.0] {
        let eye = Eye {
            roll: 0.0,
            dial,
            ..looking(DVec3::new(1e6, 3.0, 0.5))
        };
        assert_eq!(space.view_point(&eye, eye.point), glam::DVec4::W);
    }
}

#[test]
fn straight_below_the_offset_centre_nothing_cancels() {
    let space = Raised::new(20.0);
    let eye = looking(DVec3::ZERO);
    for aside in [0.0, 1e-12, 1e-6, 1e-3] {
        let u = DVec3::new(aside, -100.0, 0.0);
        let seen = space.view_point(&eye, ChartPoint::a(u));
        let down = eye.to_chart(seen.truncate().normalize());
        // Seen from the eye, the angle aside is less than the chart's, and more than nothing.
        assert!(
            down.x <= aside / 90.0 + 1e-16 && down.x >= aside / 1e3 - 1e-16,
            "{aside}: {down}"
        );
        assert!((space.eye_distance_m(&eye, seen) - 100.0).abs() < 1e-5);
    }
}
