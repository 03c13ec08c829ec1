//! What charts mean where ways lead round something: the cone of three quarters.

use std::f64::consts::{FRAC_PI_2, PI};

use antipode_geometry::{Atlas, ChartPoint, Crossing, Eye, Map, Metric};
use antipode_testing::cone::Cone;
use glam::{DQuat, DVec3};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::cases;

/// All the way round the tip, radians.
const ROUND_RAD: f64 = 3.0 * FRAC_PI_2;

fn at(point: ChartPoint) -> Eye {
    Eye {
        point,
        ..Eye::default()
    }
}

/// The angle about the tip and the distance from it.
fn polar(point: ChartPoint) -> (f64, f64) {
    let quarter = f64::from(Cone::quarter(point.chart));
    let angle_rad = point.pos.z.atan2(point.pos.x) + quarter * FRAC_PI_2;
    (angle_rad, point.pos.x.hypot(point.pos.z))
}

/// By the law of cosines, along the side of the tip where the angle is less.
fn apart_m(a: (f64, f64), b: (f64, f64)) -> f64 {
    let between = (a.0 - b.0).rem_euclid(ROUND_RAD);
    let angle_rad = between.min(ROUND_RAD - between);
    let across = 2.0 * a.1 * b.1 * angle_rad.cos();
    (a.1 * a.1 + b.1 * b.1 - across).max(0.0).sqrt()
}

/// Steps by half a metre on a circle, crossing where the cone says, and what it has turned by.
fn walk_round(radius_m: f64, angle_rad: f64, way: f64) -> (Vec<Crossing>, ChartPoint) {
    let mut point = Cone::around(angle_rad, radius_m, 5.0);
    let steps = (ROUND_RAD * radius_m / 0.5).ceil();
    let turn = DQuat::from_rotation_y(-way * ROUND_RAD / steps);
    let mut crossings = Vec::new();
    for _ in 0..steps as usize {
        point.pos = turn * point.pos;
        if let Some(crossing) = Cone.cross(point) {
            point = crossing.point;
            crossings.push(crossing);
        }
    }
    (crossings, point)
}

#[test]
fn who_goes_round_the_tip_comes_back_turned_by_a_quarter() {
    for (radius_m, way) in [(0.5, 1.0), (3.0, -1.0), (40.0, 1.0), (40.0, -1.0)] {
        let (crossings, end) = walk_round(radius_m, 0.7, way);
        assert_eq!(crossings.len(), 3, "{radius_m}");
        let start = Cone::around(0.7, radius_m, 5.0);
        assert!(end.chart == start.chart && end.pos.distance(start.pos) < 1e-9);
        // Three quarters of a turn of the axes: a way ahead that was kept points a quarter aside of what it was.
        let turned: f64 = crossings.iter().map(|it| it.turn_rad).sum();
        assert!((turned - way * ROUND_RAD).abs() < 1e-12, "{turned}");
        let kept = crossings.iter().fold(DVec3::X, |v, it| it.turn_vector(v));
        assert!(kept.distance(DVec3::Z * way) < 1e-12, "{kept}");
    }
}

proptest! {
    #![proptest_config(cases(600))]

    #[test]
    fn the_way_leads_by_the_side_of_the_tip_that_is_shorter(
        a in (0.0..ROUND_RAD, 0.1..50.0_f64), b in (0.0..ROUND_RAD, 0.1..50.0_f64),
    ) {
        let (from, to) = (Cone::around(a.0, a.1, 4.0), Cone::around(b.0, b.1, 9.0));
        let expected = apart_m(a, b).hypot(5.0);
        let distance = Cone.distance_m(from, to, &at(from));
        prop_assert!((distance - expected).abs() < 1e-9, "{distance} {expected}");
        prop_assert!((Cone.distance_m(to, from, &at(to)) - expected).abs() < 1e-9);
        // A bearing leads there: straight on along it, past the tip, is the other place.
        let view = Cone.view_point(&at(from), to);
        let away_m = Cone.eye_distance_m(&at(from), view);
        prop_assert!((away_m - expected).abs() < 1e-9);
        let end = Cone.along(&at(from), view.truncate() / away_m, away_m);
        prop_assert!(Cone.distance_m(end, to, &at(end)) < 1e-6, "{end:?} {to:?}");
        let near = Cone.carry_near(to, from).unwrap().point;
        prop_assert!(near.chart == from.chart && (near.pos.distance(from.pos) - expected).abs() < 1e-9);
    }

    /// A carried point does not depend on the asker, and so may lie by the longer side of the tip.
    #[test]
    fn a_chart_writes_every_place_of_the_cone_once(
        a in (0.0..ROUND_RAD, 0.1..50.0_f64), chart in 0..3_i32,
    ) {
        let point = Cone::around(a.0, a.1, 4.0);
        let there = Cone.carry(point, Cone::chart(chart)).unwrap();
        prop_assert_eq!(there.point.chart, Cone::chart(chart));
        let from_middle = (polar(there.point).0 - f64::from(chart) * FRAC_PI_2) / FRAC_PI_2 - 0.5;
        let from_middle = (from_middle + 2.0).rem_euclid(4.0) - 2.0;
        prop_assert!(from_middle.abs() <= 1.5 + 1e-9, "{from_middle}");
        let back = Cone.carry(there.point, point.chart).unwrap();
        prop_assert!(back.point.pos.distance(point.pos) < 1e-12);
        prop_assert_eq!(there.turn_rad, -back.turn_rad);
    }

    /// Of what lies behind the tip, written twice, either side is the continuation of what it hangs together with.
    #[test]
    fn what_is_behind_the_tip_goes_on_from_either_side(
        angle in (PI + 0.01)..(1.5 * PI - 0.01), away_m in 0.1..8.0_f64, chart in 0..3_i32,
    ) {
        let pos = DVec3::new(away_m * angle.cos(), 3.0, away_m * angle.sin());
        let point = ChartPoint::new(Cone::chart(chart), pos);
        let ahead = if angle < 1.25 * PI { 2 } else { -2 };
        let own = Cone.cross(point).or_else(|| Cone.carry(point, Cone::chart(chart + ahead)));
        let own = own.unwrap();
        prop_assert_eq!(own.point.chart, Cone::chart(chart + ahead));
        prop_assert!(own.point.pos.distance(DVec3::new(-pos.x, 3.0, -pos.z)) < 1e-12);
        prop_assert_eq!(Cone.noise_point(point), Cone.noise_point(own.point));
    }
}

#[test]
fn at_the_tip_all_three_charts_are_at_hand_and_far_from_it_two() {
    let charts = |angle_rad: f64, away_m: f64| {
        let images = Cone.images(Cone::around(angle_rad, away_m, 1.0), 4.0);
        images.len()
    };
    assert_eq!([charts(0.8, 1.0), charts(0.8, 3.9)], [2, 2]);
    assert_eq!([charts(0.1, 30.0), charts(1.5, 30.0)], [1, 1]);
    assert_eq!(charts(0.8, 30.0), 0);
}

#[test]
fn noise_is_the_same_to_the_bit_on_both_sides_of_every_edge() {
    for quarter in 0..3 {
        for cell in 0..2000 {
            let along_m = f64::from(cell) * 0.25;
            let here = ChartPoint::new(Cone::chart(quarter), DVec3::new(0.0, 7.0, along_m));
            let next = ChartPoint::new(Cone::chart(quarter + 1), DVec3::new(along_m, 7.0, 0.0));
            let (here, next) = (Cone.noise_point(here), Cone.noise_point(next));
            assert_eq!(here.to_array(), next.to_array(), "{quarter} {along_m}");
        }
    }
}
