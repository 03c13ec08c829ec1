//! The horizon map and the bend of flat worlds: the true picture of level ground, at any curvature.

use antipode_geometry::charts::{cylindrical, inner};
use antipode_geometry::{
    ChartId, ChartPoint, Euclidean, Eye, Geometry, Horizon, HyperbolicMap, Map, Metric, Optics,
    picture, strategy,
};
use glam::{DVec3, DVec4};
use proptest::prelude::{prop_assert, proptest};

use super::common::{cases, pixel, vector};

const LIFT_M: f64 = 1.62;

fn eye(dial: f64) -> Eye {
    Eye {
        point: ChartPoint::a(DVec3::new(40.0, 13.0, -7.0)),
        yaw: 0.4,
        pitch: -0.2,
        roll: 0.0,
        dial,
        lift_m: LIFT_M,
    }
}

/// Curvature k per metre at a setting of the dial.
fn k_at(dial: f64) -> f64 {
    dial.abs() / 80.0
}

#[test]
fn level_ground_ends_where_its_true_horizon_lies() {
    // 90 deg - 2 atan(exp(-h)) below level, whatever the height of the feet.
    for dial in [0.5, 5.0, 10.0, 20.0] {
        let (space, eye) = (Horizon::hyperbolic(20.0), eye(dial));
        let h = k_at(dial) * LIFT_M;
        let far = eye.point.pos + DVec3::new(18.0 / k_at(dial), -LIFT_M, 0.0);
        let view = space.view_point(&eye, ChartPoint::a(far)).truncate();
        let seen = eye.to_chart(view.normalize());
        let below = -seen.y.atan2(seen.x.hypot(seen.z));
        let expected = std::f64::consts::FRAC_PI_2 - 2.0 * (-h).exp().atan();
        assert!(
            (below - expected).abs() < 1e-10,
            "{dial}: {below} {expected}"
        );
    }
}

#[test]
fn the_bend_passes_through_flat_without_a_step() {
    let space = Horizon::bent();
    let points = [
        DVec3::new(3.0, -1.6, 0.5),
        DVec3::new(60.0, 9.0, 20.0),
        DVec3::new(150.0, -12.0, -40.0),
    ];
    for step in points {
        let at = |dial: f64| {
            let eye = eye(dial);
            let point = eye.point.moved(step);
            pixel(&space, &eye, space.view_point(&eye, point)).unwrap()
        };
        let flat_eye = eye(0.0);
        let point = flat_eye.point.moved(step);
        let flat = pixel(
            &Euclidean,
            &flat_eye,
            Euclidean.view_point(&flat_eye, point),
        )
        .unwrap();
        assert_eq!(at(0.0), flat);
        // Curvature goes with the dial's square: about zero the picture stands still.
        for dial in [1e-12, 1e-6, 1e-3] {
            assert!((at(dial) - flat).length() < 1e-3, "{dial}");
            assert!((at(-dial) - flat).length() < 1e-3, "-{dial}");
        }
        // And nowhere does it jump: a thousandth of a notch moves no point by a third of a pixel.
        let mut last = at(-0.5);
        for i in -499..=500 {
            let here = at(f64::from(i) * 1e-3);
            assert!((here - last).length() < 0.34, "{i}: {last} {here}");
            last = here;
        }
    }
}

#[test]
fn only_the_picture_changes_with_the_map() {
    for geometry in Geometry::ALL {
        let world = strategy(geometry, 32.0);
        for map in HyperbolicMap::ALL {
            let other = picture(geometry, 32.0, map, true);
            assert_eq!(other.geometry(), world.geometry());
            assert_eq!(other.radius_m(), world.radius_m());
            assert_eq!(
                other.domain(ChartId::FIRST).radius_m(),
                world.domain(ChartId::FIRST).radius_m()
            );
            assert_eq!(other.limits(), world.limits());
            assert_eq!(other.has_sky(), world.has_sky());
            let point = ChartPoint::a(DVec3::new(60.0, 9.0, -3.0));
            assert_eq!(other.cross(point), world.cross(point));
            assert_eq!(other.noise_point(point), world.noise_point(point));
        }
    }
}

#[test]
fn what_would_cover_the_sphere_twice_is_trimmed() {
    let (space, eye) = (Horizon::bent(), eye(-20.0));
    let trims = |step: DVec3| {
        let at = eye.point.pos + step;
        space.trims(&eye, eye.point.chart, at, at)
    };
    // k = 1/4: a half turn is 12.6 m.
    assert!(!trims(DVec3::new(11.0, 0.0, 0.0)));
    assert!(trims(DVec3::new(11.5, 0.0, 0.0)));
    assert!(trims(DVec3::new(0.0, 6.5, 0.0)));
    assert!(space.sight_limit_m(&eye) < 11.0);
}

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn the_closed_form_is_the_chart_boosted_to_the_eye(
        step in vector(12.0), dial in -20.0..20.0_f64, lift in -2.0..6.0_f64,
    ) {
        let (space, mut eye) = (Horizon::bent(), eye(dial));
        eye.lift_m = lift;
        let (k, sign) = (k_at(dial), -dial.signum());
        let x = cylindrical(sign, k * (step + DVec3::Y * lift));
        let e = cylindrical(sign, k * DVec3::Y * lift);
        // The upright through the eye: the derivative of the axis there.
        let up = DVec4::new(0.0, e.w, 0.0, -sign * e.y);
        let boosted = DVec3::new(x.x, inner(sign, x, up), x.z) / k;
        let view = space.view_point(&eye, eye.point.moved(step));
        let expected = eye.to_view(boosted).extend(sign * inner(sign, e, x));
        let size = 1.0 + expected.length();
        prop_assert!((view - expected).length() < 1e-12 * size * size, "{view} {expected}");
        let model = (view.truncate() * k).extend(view.w);
        let limit = 1e-13 * (1.0 + model.length_squared());
        prop_assert!((inner(sign, model, model) - sign).abs() < limit);
    }

    #[test]
    fn points_come_back_from_the_picture(step in vector(1.0), dial in -20.0..20.0_f64) {
        let (space, eye) = (Horizon::bent(), eye(dial));
        // Within ten radii, or within the part of the sphere that is shown.
        let reach = (if dial > 0.0 { 10.0 } else { 1.1 } / k_at(dial)).min(300.0);
        let point = eye.point.moved(step * reach);
        let back = space.chart_point(&eye, space.view_point(&eye, point));
        prop_assert!((back.pos - point.pos).length() < 1e-7 * reach, "{dial}");
    }

    #[test]
    fn normals_are_covectors(step in vector(1.0), normal in vector(1.0), dial in -20.0..20.0_f64) {
        let (space, eye) = (Horizon::bent(), eye(dial));
        let normal = normal.normalize_or(DVec3::X);
        let point = eye.point.moved(step * (1.2 / k_at(dial)).min(60.0));
        let ported = space.port_normal(&eye, point, normal);
        prop_assert!((ported.length() - 1.0).abs() < 1e-12);
        // A tangent of the surface stays at right angles to it: the differential in the chart's
        // own frame is radial C(y), tangential C(y) S(r)/r, upright 1.
        let u = point.pos - eye.point.pos;
        let (k, sign) = (k_at(dial), -dial.signum());
        let (y, r) = (k * (u.y + LIFT_M), k * u.x.hypot(u.z));
        let (cosine, sine) = if sign > 0.0 { (y.cos(), r.sin()) } else { (y.cosh(), r.sinh()) };
        let radial = DVec3::new(u.x, 0.0, u.z).normalize_or(DVec3::X);
        let tangential = radial.cross(DVec3::Y);
        let across = if r > 0.0 { sine / r } else { 1.0 };
        for tangent in [normal.any_orthonormal_vector(), normal.cross(normal.any_orthonormal_vector())] {
            let carried = radial * (cosine * tangent.dot(radial))
                + tangential * (cosine * across * tangent.dot(tangential))
                + DVec3::Y * tangent.y;
            prop_assert!(carried.normalize().dot(ported).abs() < 1e-10);
        }
    }

    #[test]
    fn the_geodesic_ahead_stays_under_the_crosshair(
        pitch in -1.5..1.5_f64, dial in -20.0..20.0_f64, part in 0.001..1.0_f64,
    ) {
        let space = Horizon::bent();
        let eye = Eye { pitch, ..eye(dial) };
        let reach = (if dial > 0.0 { 8.0 } else { 1.4 } / k_at(dial)).min(100.0);
        let point = space.along(&eye, DVec3::NEG_Z, part * reach);
        let view = space.view_point(&eye, point);
        let at = pixel(&space, &eye, view).unwrap();
        prop_assert!(at.length() < 1e-4, "{at}");
        prop_assert!((space.eye_distance_m(&eye, view) - part * reach).abs() < 1e-7 * reach);
        prop_assert!((space.distance_m(eye.point, point, &eye) - part * reach).abs() < 1e-7 * reach);
    }
}
