//! The sphere's two charts: crossing, carrying, orientation and what they leave unchanged.

use antipode_geometry::{
    Atlas, ChartId, ChartPoint, Euclidean, Eye, Map, Metric, Raised, Spherical, Strategy,
};
use glam::{DVec3, DVec4};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{cases, chart_point, eye, pixel, vector};

const RADIUS_M: f64 = 32.0;

fn sphere() -> Spherical {
    Spherical::new(RADIUS_M)
}

/// The eye in the other chart.
fn crossed(eye: &Eye) -> Eye {
    let crossing = sphere().images(eye.point, f64::INFINITY)[0];
    Eye {
        point: crossing.point,
        yaw: eye.yaw - crossing.turn_rad,
        ..*eye
    }
}

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn the_picture_is_the_same_before_and_after(eye in eye(70.0), point in chart_point(70.0)) {
        let before = sphere().view_point(&eye, point);
        let after = sphere().view_point(&crossed(&eye), point);
        prop_assert!((before - after).length() < 1e-12 * RADIUS_M);
        let carried = sphere().images(point, f64::INFINITY)[0].point;
        prop_assert!((before - sphere().view_point(&eye, carried)).length() < 1e-12 * RADIUS_M);
    }

    #[test]
    fn carrying_twice_changes_nothing(point in chart_point(70.0), v in vector(5.0)) {
        let there = sphere().images(point, f64::INFINITY)[0];
        let back = sphere().images(there.point, f64::INFINITY)[0];
        prop_assert_eq!(back.point.chart, point.chart);
        prop_assert!((back.point.pos - point.pos).length() < 1e-12);
        prop_assert!((back.turn_vector(there.turn_vector(v)) - v).length() < 1e-12);
        prop_assert_eq!(there.point.pos.y, point.pos.y);
    }

    #[test]
    fn vectors_turn_as_the_frame_does(eye in eye(60.0)) {
        // A step along a turned vector leads to the same place as the step before the turn.
        let crossing = sphere().images(eye.point, f64::INFINITY)[0];
        let step = eye.front() * 1e-4;
        let before = sphere().curved(&eye, eye.point.moved(step));
        let straight = crossing.turn_vector(eye.front());
        prop_assert!((straight - crossed(&eye).front()).length() < 1e-12);
        prop_assert!((crossing.rotation() * DVec3::Y - DVec3::Y).length() < 1e-15);
        // Only near the equator are both charts' scales alike, so only there is a step compared.
        let rim = sphere().domain(ChartId::FIRST).radius_m().unwrap();
        let (c, y) = (eye.point.pos.normalize(), eye.point.pos.y);
        let level = DVec3::new(c.x, 0.0, c.z).normalize();
        let at_rim = ChartPoint::new(eye.point.chart, level * rim + DVec3::Y * y);
        let over = sphere().images(at_rim, f64::INFINITY)[0];
        let here = sphere().curved(&eye, at_rim.moved(step));
        let there = sphere().curved(&eye, over.point.moved(over.turn_vector(step)));
        prop_assert!((here - there).length() < 1e-9 / RADIUS_M);
        prop_assert!(before.is_finite());
    }

    #[test]
    fn noise_is_sampled_at_one_place_from_either_chart(point in chart_point(70.0)) {
        let carried = sphere().images(point, f64::INFINITY)[0].point;
        let gap = sphere().noise_point(point) - sphere().noise_point(carried);
        prop_assert!(gap.length() < 1e-12 * RADIUS_M);
        let length = sphere().noise_point(point).length();
        prop_assert!((length - RADIUS_M - point.pos.y).abs() < 1e-12 * RADIUS_M);
    }
}

#[test]
fn a_body_crosses_only_past_the_hysteresis() {
    let rim = sphere().domain(ChartId::FIRST).radius_m().unwrap();
    let at = |r: f64| ChartPoint::a(DVec3::new(-0.6 * r, 7.0, 0.8 * r));
    assert!(sphere().cross(at(rim + 0.19)).is_none());
    let crossing = sphere().cross(at(rim + 0.21)).unwrap();
    assert_eq!(crossing.point.chart, ChartId::SECOND);
    assert!(sphere().cross(crossing.point).is_none());
    for space in [&Raised::new(20.0) as &dyn Strategy, &Euclidean] {
        assert!(space.cross(at(1e6)).is_none());
        assert!(space.images(at(1e6), f64::INFINITY).pop().is_none());
    }
}

#[test]
fn a_straight_walk_over_the_equator_is_a_great_circle() {
    // Once round: through both poles and twice over the equator, 2 pi R of ground.
    let walk = DVec3::new(0.6, 0.0, 0.8);
    let (mut point, mut heading) = (ChartPoint::a(DVec3::Y * 6.0), walk);
    let start = sphere().curved(&Eye::default(), point);
    let around = std::f64::consts::TAU * RADIUS_M;
    let steps = 4000;
    let mut crossings = 0;
    for _ in 0..steps {
        point = point.moved(heading * (around / f64::from(steps)));
        if let Some(crossing) = sphere().cross(point) {
            heading = crossing.turn_vector(heading);
            point = crossing.point;
            crossings += 1;
        }
    }
    assert_eq!(crossings, 2);
    assert!((sphere().curved(&Eye::default(), point) - start).length() < 1e-10);
    assert!((heading - walk).length() < 1e-10);
}

#[test]
fn a_million_crossings_do_not_drift() {
    let rim = sphere().domain(ChartId::FIRST).radius_m().unwrap();
    let start = ChartPoint::a(DVec3::new(0.28 * (rim + 0.3), 9.0, -0.96 * (rim + 0.3)));
    let velocity = DVec3::new(1.0, 2.0, -3.0);
    let (mut point, mut v) = (start, velocity);
    for _ in 0..1_000_000 {
        let crossing = sphere().images(point, f64::INFINITY)[0];
        v = crossing.turn_vector(v);
        point = crossing.point;
    }
    assert_eq!(point.chart, start.chart);
    assert!((point.pos - start.pos).length() < 1e-8);
    assert!((v - velocity).length() < 1e-8, "{v}");
}

#[test]
fn an_f_reads_as_an_f_in_either_hemisphere() {
    // A sign before the eye: foot, top, end of the upper arm (to the right), of the lower.
    let strokes = [(0.0, -1.0), (0.0, 1.0), (1.0, 1.0), (0.6, 0.0)];
    for space in super::common::spaces() {
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            for turn in 0..12 {
                let pos = DVec3::new(11.0, 8.0, -7.0);
                let yaw = f64::from(turn) * 0.5;
                let eye = Eye {
                    point: ChartPoint::new(chart, pos),
                    yaw,
                    pitch: 0.0,
                    roll: 0.0,
                    dial: 10.0,
                    lift_m: 1.62,
                };
                let seen = strokes.map(|(right, up)| {
                    let at = eye.front() * 4.0 + eye.right() * right + eye.up() * up;
                    let point = eye.point.moved(at);
                    pixel(space.as_ref(), &eye, space.view_point(&eye, point)).unwrap()
                });
                let [foot, top, upper, lower] = seen;
                assert!(top.y > foot.y + 50.0, "upright");
                assert!(upper.x > top.x + 20.0 && lower.x > 0.5 * (top.x + foot.x) + 10.0);
                assert!(upper.x > lower.x && upper.y > lower.y);
            }
        }
    }
}

#[test]
fn triangles_keep_their_winding_in_either_hemisphere() {
    for chart in [ChartId::FIRST, ChartId::SECOND] {
        let eye = Eye {
            point: ChartPoint::new(chart, DVec3::new(20.0, 9.0, 5.0)),
            ..Eye::default()
        };
        let axes = [eye.right(), eye.up(), -eye.front()];
        let origin = sphere().view_point(&eye, eye.point);
        let columns = axes.map(|axis| {
            (sphere().view_point(&eye, eye.point.moved(axis * 1e-3)) - origin).truncate()
        });
        assert!(columns[0].cross(columns[1]).dot(columns[2]) > 0.0);
        assert_eq!(origin.truncate().length() < 1e-12, origin.w > 0.999_999);
    }
}

#[test]
fn poles_and_antipodes_are_where_they_belong() {
    let eye = Eye::default();
    let pole = |chart| sphere().curved(&eye, ChartPoint::new(chart, DVec3::ZERO));
    assert_eq!(pole(ChartId::FIRST), DVec4::W);
    assert_eq!(pole(ChartId::SECOND), -DVec4::W);
    let far = sphere().distance_m(
        ChartPoint::a(DVec3::new(3.0, 5.0, 1.0)),
        // The antipode of (w, x, z) at height y is at height -y, straight across.
        ChartPoint::new(ChartId::SECOND, DVec3::new(3.0, -5.0, -1.0)),
        &eye,
    );
    assert!(
        (far - std::f64::consts::PI * RADIUS_M).abs() < 1e-12 * RADIUS_M,
        "{far}"
    );
}
