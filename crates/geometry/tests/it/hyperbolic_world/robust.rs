//! Any input, many threads, and the ends of the world.

use antipode_geometry::tiling::Side;
use antipode_geometry::{
    Atlas, BodyChart, ChartId, ChartPoint, Eye, HyperbolicWorld, Map, Metric, Optics,
};
use glam::DVec3;
use proptest::prelude::{any, prop_assert, proptest};

use super::common::{apart_m, chart, frame, outward, place, worlds};
use crate::space::common::{cases, projection};

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn nothing_panics_and_what_is_seen_is_finite(
        x in any::<f64>(), y in any::<f64>(), z in any::<f64>(), yaw in any::<f64>(), number in any::<u128>(), to in any::<u128>(),
        reach_m in any::<f64>(),
    ) {
        let world = HyperbolicWorld::new(x);
        let point = ChartPoint::new(ChartId::new(number), DVec3::new(x, y, z));
        let near = ChartPoint::new(ChartId::new(to % 1000), DVec3::new(z, x, y));
        let eye = Eye { point: near, yaw: yaw.clamp(-1e9, 1e9), ..Eye::default() };
        let view = world.view_point(&eye, point);
        prop_assert!(view.is_finite(), "{view}");
        let back = world.chart_point(&eye, view);
        prop_assert!(world.has_chart(back.chart) && back.pos.is_finite(), "{back:?}");
        let end = world.along(&eye, DVec3::new(0.6, 0.0, 0.8), yaw);
        prop_assert!(world.has_chart(end.chart) && end.pos.is_finite());
        prop_assert!(world.distance_m(point, near, &eye) >= 0.0);
        for point in [point, near] {
            if let Some(it) = world.cross(point) {
                prop_assert!(world.has_chart(it.point.chart) && it.turn_rad.is_finite());
            }
            let images = world.images(point, reach_m);
            prop_assert!(images.len() < 40);
            let _ = world.carry(point, near.chart);
            prop_assert!(!world.spread_m(point, 3.0, 8.0).is_nan());
            prop_assert!(world.noise_point(point).with_y(0.0).is_finite());
            prop_assert!(world.port_normal(&eye, point, DVec3::Y).is_finite());
            prop_assert!(world.in_frame(point, DVec3::X).is_finite());
            let cell = world.sight_cell(&eye, point.chart, point.pos, point.pos + 32.0);
            let _ = world.frustum(&eye, &projection()).sees(&cell);
            prop_assert!(!world.ball_rises_m(&eye, point, 2.0).is_nan());
            let body = BodyChart::new(&world, point);
            let _ = (body.pos(near), body.arrival(near.pos));
        }
    }
}

#[test]
fn at_the_end_of_the_world_nobody_goes_on() {
    for world in worlds() {
        let mut at = outward(&[Side::new(0)], 74.0);
        while let Ok(next) = at.neighbour(Side::new(0)) {
            at = next.frame;
        }
        let last = chart(&at);
        let past = place(&world, last, DVec3::new(1.3, 0.0, 0.2));
        assert!(world.has_chart(last) && world.cross(past).is_none());
        let back = world
            .cross(place(&world, last, DVec3::new(-1.3, 0.0, 0.2)))
            .unwrap();
        assert!(frame(back.point.chart).tile() < at.tile());
        let eye = Eye {
            point: past,
            ..Eye::default()
        };
        let end = world.along(&eye, DVec3::NEG_Z, 1e6);
        assert_eq!(end.chart, last);
        assert!(end.pos.is_finite());
    }
}

/// Home, and a mark at the other end of the world, are seen where they are, though no exact number holds the way.
#[test]
fn from_end_to_end_of_the_world_ways_are_found() {
    let world = HyperbolicWorld::new(60.305);
    let ends = [[0, 1, 3], [2, 0, 0], [1, 3, 2], [3, 0, 1]]
        .map(|way| chart(&outward(&way.map(Side::new), 76.0)));
    let at = |chart: ChartId| place(&world, chart, DVec3::new(0.2, 0.1, -0.4));
    for a in ends {
        for b in ends.into_iter().filter(|it| *it != a) {
            let [ab, ba] = [apart_m(&world, at(a), at(b)), apart_m(&world, at(b), at(a))];
            let root_m = apart_m(&world, at(a), at(ChartId::FIRST))
                + apart_m(&world, at(ChartId::FIRST), at(b));
            println!("{:.1} radii", ab / world.radius_m());
            assert!((ab - ba).abs() < 1e-9 * ab && ab <= root_m + 1e-6);
            assert!(ab > 100.0 * world.radius_m());
            // Who goes by it comes as much nearer. (Over 36 radii a direction would have lost all of its digits.)
            let eye = Eye {
                point: at(a),
                ..Eye::default()
            };
            let view = world.view_point(&eye, at(b)).truncate().normalize();
            let gone_m = 20.0 * world.radius_m();
            let there = world.along(&eye, view, gone_m);
            let rest_m = apart_m(&world, there, at(b));
            assert!((rest_m + gone_m - ab).abs() < 1e-6, "{rest_m} {ab}");
        }
    }
}

#[test]
fn many_threads_have_the_same_answers() {
    let world = HyperbolicWorld::new(60.305);
    let ask = |world: &HyperbolicWorld| {
        let mut sum = Vec::new();
        for number in 0..3000_u128 {
            let point = place(
                world,
                ChartId::new(number * number),
                DVec3::new(1.05, 0.3, -0.98),
            );
            let crossing = world.cross(point).unwrap();
            sum.push((crossing.point, world.images(point, 3.0).len()));
        }
        sum
    };
    let alone = ask(&HyperbolicWorld::new(60.305));
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(|| ask(&world))).collect();
        for thread in threads {
            assert!(thread.join().unwrap() == alone);
        }
    });
}
