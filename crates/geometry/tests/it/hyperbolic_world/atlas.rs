//! Charts: their numbers, images, edges and corners.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use antipode_geometry::tiling::{Frame, Side, rings};
use antipode_geometry::{Atlas, ChartId, ChartPoint, HyperbolicWorld, Metric};
use glam::{DVec2, DVec3};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{apart_m, beyond, chart, charts, frame, outward, place, steps, worlds};
use crate::space::common::{cases, vector};

#[test]
fn the_first_chart_is_the_root_and_squares_are_as_wide_as_said() {
    assert_eq!(chart(&Frame::ROOT), ChartId::FIRST);
    for (world, width_m) in worlds().iter().zip([32.0, 64.0, 128.0]) {
        let half_m = world.domain(ChartId::FIRST).half_width_m();
        assert!((2.0 * half_m - width_m).abs() < 1e-12, "{half_m}");
        assert_eq!(world.chart_name(ChartId::FIRST), "A");
        assert!(!world.is_closed() && world.limits().is_none());
        for number in 0..500 {
            let chart = ChartId::new(number);
            assert!(world.has_chart(chart));
            assert_eq!(world.chart_name(chart).parse(), Ok(chart));
        }
        assert!(!world.has_chart(ChartId::new(u128::MAX)));
    }
    // The radius is that of whole chunks: the stated ones to a millimetre.
    for (world, radius_m) in worlds().iter().zip(HyperbolicWorld::RADII_M) {
        assert!((world.radius_m() - radius_m).abs() < 1e-3, "{radius_m}");
    }
    for (asked, chunks) in [
        (f64::NAN, 2.0),
        (0.0, 1.0),
        (-5.0, 1.0),
        (f64::INFINITY, 64.0),
        (75.0, 2.0),
    ] {
        let half_m = HyperbolicWorld::new(asked)
            .domain(ChartId::FIRST)
            .half_width_m();
        assert!((half_m - 16.0 * chunks).abs() < 1e-9, "{asked} {half_m}");
    }
}

/// The charts in which a point lies within so many metres of the square, of all within four steps.
fn near(world: &HyperbolicWorld, point: ChartPoint, reach_m: f64) -> BTreeSet<ChartId> {
    let about = rings(&frame(point.chart), 4, 1000).unwrap().concat();
    let own = |it: &ChartId| *it != point.chart;
    let within = |to: &ChartId| {
        world.carry(point, *to).is_some_and(|it| {
            let at = DVec2::new(it.point.pos.x, it.point.pos.z);
            world.domain(*to).outside_m(at) <= reach_m
        })
    };
    about.iter().map(chart).filter(own).filter(within).collect()
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn images_are_all_that_there_are(share in vector(1.45), from in charts(), part in 0.0..1.2_f64) {
        for world in worlds() {
            let point = place(&world, from, share);
            let reach_m = part * world.domain(from).half_width_m();
            let images = world.images(point, reach_m);
            let found: BTreeSet<ChartId> = images.iter().map(|it| it.point.chart).collect();
            prop_assert_eq!(found.len(), images.len());
            prop_assert_eq!(found, near(&world, point, reach_m));
            for image in images {
                prop_assert_eq!(image.point.pos.y, point.pos.y);
                prop_assert_eq!(world.carry(point, image.point.chart), Some(image));
                prop_assert!(apart_m(&world, point, image.point) < 1e-9);
                let back = world.carry(image.point, from).unwrap();
                prop_assert!(back.point.pos.distance(point.pos) < 1e-9);
            }
        }
    }

    /// A direction that is carried is the same in the space: what the turn says of it, a point a little ahead does.
    #[test]
    fn turns_are_those_of_the_space(share in vector(1.3), from in charts(), heading in 0.0..TAU) {
        for world in worlds() {
            let point = place(&world, from, share);
            let way = DVec3::new(heading.cos(), 0.0, heading.sin());
            for image in world.images(point, 6.0) {
                let ahead = point.moved(world.in_chart(point, way) * 1e-4);
                let Some(there) = world.carry(ahead, image.point.chart) else { continue };
                let told = world.in_frame(image.point, there.point.pos - image.point.pos) * 1e4;
                prop_assert!(told.distance(image.turn_vector(way)) < 1e-4, "{told} {image:?}");
            }
        }
    }

    #[test]
    fn an_edge_is_one_line_of_both_charts(from in charts(), side in 0_u8..4, along in -1.0..1.0_f64, y in -5.0..40.0_f64) {
        for world in worlds() {
            let half_m = world.domain(from).half_width_m();
            let at = |side: Side, along: f64| {
                let out = DVec3::new(half_m, y, along * half_m);
                let turned = glam::DQuat::from_rotation_y(-f64::from(side.number()) * TAU / 4.0) * out;
                turned.with_y(y)
            };
            let side = Side::new(side);
            let over = frame(from).neighbour(side).unwrap();
            let point = ChartPoint::new(from, at(side, along));
            let there = world.carry(point, chart(&over.frame)).unwrap().point;
            // From the other chart the edge runs the other way.
            prop_assert!(there.pos.distance(at(over.back, -along)) < 2e-13 * half_m, "{there:?}");
            prop_assert!(apart_m(&world, point, there) < 1e-9);
        }
    }

    #[test]
    fn far_charts_are_reached_by_the_same_numbers_from_everywhere(from in charts(), over in steps(6)) {
        let world = HyperbolicWorld::new(60.305);
        let to = beyond(from, &over);
        let point = place(&world, from, DVec3::new(0.3, 0.1, -0.6));
        let end = place(&world, to, DVec3::new(-0.7, -0.2, 0.2));
        let [ab, ba] = [apart_m(&world, point, end), apart_m(&world, end, point)];
        prop_assert!((ab - ba).abs() < 1e-10 * (1.0 + ab), "{ab} {ba}");
    }
}

/// The charts about the corner at +x +z of a chart, in the order of a way round it.
fn round_corner(from: ChartId) -> Vec<(ChartId, DVec2)> {
    let mut about = Vec::new();
    // The sides before and behind the corner, seen from within: who goes over the one finds the corner at the other's end.
    let (mut at, mut side) = (frame(from), Side::new(0));
    for _ in 0..5 {
        // The corner between this side and the next one on.
        let corner = match side.number() {
            0 => DVec2::new(1.0, 1.0),
            1 => DVec2::new(-1.0, 1.0),
            2 => DVec2::new(-1.0, -1.0),
            _ => DVec2::new(1.0, -1.0),
        };
        about.push((chart(&at), corner));
        let over = at.neighbour(side).unwrap();
        at = over.frame;
        // Past the edge the corner is before the side that one came over.
        side = over.back.turned(3);
    }
    assert_eq!(chart(&at), from, "five squares about a corner");
    about
}

#[test]
fn a_corner_is_one_point_of_five_charts_and_an_edge_of_two() {
    let far = [0.0, 0.5, 2.0, 20.0, 50.0, 70.0]
        .map(|radii| chart(&outward(&[1, 3, 0].map(Side::new), radii)));
    for world in worlds() {
        for from in far {
            let half_m = world.domain(from).half_width_m();
            let about = round_corner(from);
            let at = |&(chart, corner): &(ChartId, DVec2)| {
                let level = corner * half_m;
                ChartPoint::new(chart, DVec3::new(level.x, 6.0, level.y))
            };
            let corner = at(&about[0]);
            for other in &about[1..] {
                let there = world.carry(corner, other.0).unwrap().point;
                assert!(there.pos.distance(at(other).pos) < 1e-9, "{there:?}");
                for third in &about {
                    let way = world.carry(there, third.0).unwrap().point;
                    assert!(way.pos.distance(at(third).pos) < 1e-9, "{way:?}");
                }
            }
            let images = world.images(corner, 1e-9);
            assert_eq!(images.len(), 4);
            let middle = ChartPoint::new(from, DVec3::new(half_m, 6.0, 0.0));
            assert_eq!(world.images(middle, 1e-9).len(), 1);
            assert_eq!(
                world
                    .images(corner.moved(DVec3::new(-1.0, 0.0, -1.0)), 0.9)
                    .len(),
                0
            );
            // Round the corner through all five, directions come back as they were.
            let turns = (0..5).map(|i| world.carry(at(&about[i]), about[(i + 1) % 5].0).unwrap());
            let turned: f64 = turns.map(|it| it.turn_rad).sum();
            let whole = (turned / TAU).round() * TAU;
            assert!((turned - whole).abs() < 1e-9, "{turned}");
        }
    }
}

#[test]
fn who_stands_on_a_line_stays_until_the_hysteresis_is_past() {
    for world in worlds() {
        let half_m = world.domain(ChartId::FIRST).half_width_m();
        let at = |out: f64| ChartPoint::a(DVec3::new(half_m + out, 3.0, 4.0));
        assert!(world.cross(at(0.199)).is_none());
        let crossing = world.cross(at(0.201)).unwrap();
        assert_eq!(crossing.point.chart, ChartId::new(1));
        assert!(world.cross(crossing.point).is_none());
        // Back by as much, it stays in the new one.
        let back = world.carry(at(-0.1), crossing.point.chart).unwrap();
        assert!(world.cross(back.point).is_none());
        assert!((back.point.pos.x.abs().max(back.point.pos.z.abs()) - half_m - 0.1).abs() < 1e-9);
    }
}
