//! How fast something is in the space when it is carried to where a metre of the chart is longer or shorter.
//!
//! Cars go by the metres of the chart. On the sphere lengths along the axes of a chart's frame differ by place: with S the matrix
//! that takes a velocity of the chart to metres of the space along those axes ([`crate::Metric::in_frame`]), R the turn of a
//! crossing, and S' at its end, an isometry takes the frame of one place to that of the other: `S' v' = R S v`.

use glam::DVec3;

use crate::{ChartPoint, Crossing, Metric};

/// How many times as long a body's velocity (m/s of the chart) becomes where it is carried, if its way in the body's own axes
/// is to stay as it is: `|S v| / |S' R v|`. 1 for one that stands.
pub fn share(space: &dyn Metric, from: ChartPoint, crossing: &Crossing, velocity: DVec3) -> f64 {
    let here = space.in_frame(from, velocity).length();
    let turned = crossing.turn_vector(velocity);
    let there = space.in_frame(crossing.point, turned).length();
    if here > 0.0 && there > 0.0 {
        here / there
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use std::f64::consts::{PI, TAU};

    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;
    use crate::{ChartId, Doorway, Eye, Geometry, Leaf, Strategy as Space, strategy};

    const RADIUS_M: f64 = 32.0;

    /// How fast something is in the space, by where it is a little later.
    fn speed_m_s(space: &dyn Space, point: ChartPoint, velocity: DVec3) -> f64 {
        const SHORT_S: f64 = 1e-4;
        let later = point.moved(velocity * SHORT_S);
        space.distance_m(point, later, &Eye::default()) / SHORT_S
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: RngSeed::Fixed(23),
            failure_persistence: None,
            ..ProptestConfig::default()
        })]

        #[test]
        fn who_goes_through_a_door_of_a_closed_world_is_as_fast_in_the_space(
            far in 0.0..1.0f64, other in 0.0..1.0f64, around in 0.0..TAU, low in 0.15..0.5f64, high in 0.15..0.5f64,
            yaw in -PI..PI, looks in -PI..PI, second: bool,
            x in -4.0..4.0f64, y in -4.0..4.0f64, z in -4.0..4.0f64,
        ) {
            let space = strategy(Geometry::Spherical, RADIUS_M);
            let rim_m = 0.5 * PI * RADIUS_M;
            let chart = if second { ChartId::SECOND } else { ChartId::FIRST };
            let foot = |chart, far: f64, y: f64| {
                let level = DVec3::new(around.cos(), 0.0, around.sin()) * (far * rim_m);
                ChartPoint::new(chart, level.with_y(y * RADIUS_M))
            };
            let leaves = [
                Leaf::at(&*space, foot(ChartId::FIRST, far, low), yaw),
                Leaf::at(&*space, foot(chart, other, high), looks),
            ];
            let pair = Doorway { leaves };
            let from = leaves[0].place(DVec3::new(0.0, 1.2, 0.6));
            let out = pair.carry(&*space, 0, from).unwrap();
            let velocity = DVec3::new(x, y, z);
            let before = speed_m_s(&*space, from, velocity);
            let drives = out.turn_vector(velocity) * share(&*space, from, &out, velocity);
            let after = speed_m_s(&*space, out.point, drives);
            prop_assert!((after - before).abs() < 1e-3 * before.max(1e-3), "{before} {after}");
        }
    }

    #[test]
    fn where_a_metre_is_a_metre_nothing_but_the_turn_is_done() {
        let at = ChartPoint::a(DVec3::new(4.0, 2.0, -7.0));
        let crossing = Crossing {
            turn_rad: 0.7,
            ..Crossing::within(at.moved(DVec3::X * 50.0))
        };
        let velocity = DVec3::new(3.0, -1.0, 2.0);
        for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
            let space = strategy(geometry, RADIUS_M);
            assert!((share(&*space, at, &crossing, velocity) - 1.0).abs() < 1e-12);
        }
        let space = strategy(Geometry::Spherical, RADIUS_M);
        assert_eq!(share(&*space, at, &crossing, DVec3::ZERO), 1.0);
    }
}
