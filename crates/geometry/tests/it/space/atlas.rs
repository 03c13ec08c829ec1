//! What holds of the charts of any world: of the sphere's two, of flat space's squares without number, and of the hyperbolic
//! world's.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use antipode_geometry::{
    ChartId, ChartPoint, Domain, HyperbolicWorld, NoiseFrame, Spherical, Strategy,
};
use antipode_testing::cone::Cone;
use antipode_testing::tiled::{TILE_M, TiledFlat};
use glam::{DVec2, DVec3, I64Vec2};
use proptest::prelude::{Strategy as Generator, prop_assert, prop_assert_eq, proptest};

use super::common::{cases, eye, in_space, vector};

/// Worlds of more than one chart.
fn spaces() -> [Box<dyn Strategy>; 6] {
    [
        Box::new(Spherical::new(32.0)),
        Box::new(TiledFlat),
        Box::new(Cone),
        Box::new(HyperbolicWorld::new(30.152)),
        Box::new(HyperbolicWorld::new(60.305)),
        Box::new(HyperbolicWorld::new(120.61)),
    ]
}

/// A place within or a little outside of some chart's domain.
fn place(space: &dyn Strategy, share: DVec3, tile: (i64, i64)) -> ChartPoint {
    let chart = match space.all_charts() {
        Some(charts) => charts[tile.0.unsigned_abs() as usize % charts.len()],
        // Within four steps of the root.
        None if space.curvature().sign < 0.0 => {
            ChartId::new((81 * (tile.0 + 40) + tile.1 + 40) as u128 % 109)
        }
        None => TiledFlat::chart(I64Vec2::new(tile.0, tile.1)),
    };
    let half_m = space.domain(chart).half_width_m();
    let height_m = 8.0 + 2.0 * share.y;
    if half_m.is_infinite() {
        // Nothing behind the tip, which is written twice.
        let pos = (share.abs() * 60.0 - 6.0).with_y(height_m);
        let quarter = Cone::chart(tile.0 as i32);
        let behind = pos.x < 0.0 && pos.z < 0.0;
        return ChartPoint::new(quarter, if behind { pos.abs() } else { pos });
    }
    let reach_m = 1.2 * half_m;
    ChartPoint::new(chart, (share * reach_m).with_y(height_m))
}

fn tile() -> impl Generator<Value = (i64, i64)> {
    (-40..40_i64, -40..40_i64)
}

fn outside_m(space: &dyn Strategy, point: ChartPoint) -> f64 {
    let at = DVec2::new(point.pos.x, point.pos.z);
    space.domain(point.chart).outside_m(at)
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn an_image_is_the_same_place_and_leads_back(
        share in vector(1.0), way in vector(1.0), tile in tile(), eye in eye(20.0),
    ) {
        for space in spaces() {
            let space = &*space;
            let point = place(space, share, tile);
            let mut eye = eye;
            eye.point = in_space(space, eye.point);
            prop_assert_eq!(space.carry(point, point.chart).map(|it| it.point), Some(point));
            for image in space.images(point, 12.0) {
                prop_assert!(image.point.chart != point.chart);
                let seen = [point, image.point].map(|it| space.view_point(&eye, it));
                // Where space is hyperbolic w grows, and all of a point with it.
                let off_m = (seen[0] - seen[1]).length();
                prop_assert!(off_m < 1e-9 * seen[0].w.max(1.0), "{space:?}");
                let noise = [point, image.point].map(|it| space.noise_point(it));
                prop_assert!(noise[0].distance(noise[1]) < 1e-9, "{space:?}");
                prop_assert_eq!(space.carry(point, image.point.chart), Some(image));
                let back = space.carry(image.point, point.chart).unwrap();
                prop_assert!(back.point.pos.distance(point.pos) < 1e-9);
                let turned = back.turn_vector(image.turn_vector(way));
                prop_assert!(turned.distance(way) < 1e-9);
                if let NoiseFrame::Square(_) = space.noise_frame(point.chart) {
                    let there = image.turn_vector(way);
                    let told = [(point.chart, way), (image.point.chart, there)]
                        .map(|(chart, way)| space.in_common_axes(chart, way));
                    prop_assert!(told[0].distance(told[1]) < 1e-9, "{told:?}");
                }
                let off_rad = (back.turn_rad + image.turn_rad + 0.5).rem_euclid(TAU);
                prop_assert!((off_rad - 0.5).abs() < 1e-9 || space.all_charts().is_some());
            }
        }
    }

    #[test]
    fn the_images_are_in_the_charts_whose_domains_are_near(
        share in vector(1.0), tile in tile(), reach_m in 0.0..40.0_f64,
    ) {
        for space in spaces() {
            let space = &*space;
            let point = place(space, share, tile);
            let found: BTreeSet<ChartId> =
                space.images(point, reach_m).iter().map(|it| it.point.chart).collect();
            // All that there are about it.
            let every = space.images(point, 150.0);
            for image in every {
                let near = outside_m(space, image.point) <= reach_m;
                prop_assert_eq!(found.contains(&image.point.chart), near, "{:?}", space);
            }
        }
    }

    #[test]
    fn who_leaves_a_chart_comes_to_that_of_the_place_and_stays(share in vector(1.0), tile in tile()) {
        for space in spaces() {
            let space = &*space;
            let point = place(space, share, tile);
            let out_m = outside_m(space, point);
            let crossing = space.cross(point);
            prop_assert_eq!(crossing.is_some(), out_m > 0.2, "{:?} {}", space, out_m);
            if let Some(crossing) = crossing {
                prop_assert!(outside_m(space, crossing.point) < 1e-9);
                prop_assert!(space.cross(crossing.point).is_none());
                prop_assert_eq!(space.carry(point, crossing.point.chart), Some(crossing));
            }
        }
    }

    #[test]
    fn a_disc_stays_within_its_spread_in_the_next_chart(
        share in vector(1.0), tile in tile(), radius_m in 0.5..12.0_f64, turn in 0.0..TAU, part in 0.0..1.0_f64,
    ) {
        const PAST_M: f64 = 12.0;
        for space in spaces() {
            let space = &*space;
            let point = place(space, share, tile);
            let away = DVec3::new(turn.cos(), 0.0, turn.sin()) * radius_m * part;
            let spread_m = space.spread_m(point, radius_m, PAST_M);
            for image in space.images(point, radius_m + PAST_M) {
                let Some(there) = space.carry(point.moved(away), image.point.chart) else {
                    continue;
                };
                let there = there.point;
                if outside_m(space, there) > PAST_M {
                    continue;
                }
                let apart = (there.pos - image.point.pos).abs();
                prop_assert!(apart.x.max(apart.z) <= spread_m + 1e-9, "{space:?} {apart}");
            }
        }
    }
}

#[test]
fn a_domain_says_how_far_outside_a_place_is() {
    let disc = Domain::Disc { radius_m: 5.0 };
    assert_eq!(disc.outside_m(DVec2::new(3.0, 4.0)), 0.0);
    assert_eq!(disc.outside_m(DVec2::new(6.0, 8.0)), 5.0);
    let square = Domain::Rectangle {
        low: DVec2::splat(-4.0),
        high: DVec2::splat(4.0),
    };
    assert_eq!(square.outside_m(DVec2::new(1.0, -3.0)), -1.0);
    assert_eq!(square.outside_m(DVec2::new(7.0, 8.0)), 5.0);
    assert_eq!(square.outside_m(DVec2::new(-6.0, 2.0)), 2.0);
    let (low, high) = (DVec2::new(2.0, 5.0), DVec2::new(7.0, 8.0));
    assert_eq!(square.least_outside_m(low, high), 1.0);
    assert_eq!(square.most_outside_m(low, high), 5.0);
    assert_eq!(
        Domain::Everywhere.most_outside_m(low, high),
        f64::NEG_INFINITY
    );
    let quarter = Domain::Rectangle {
        low: DVec2::ZERO,
        high: DVec2::INFINITY,
    };
    assert_eq!(quarter.outside_m(DVec2::new(3.0, 900.0)), -3.0);
    assert_eq!(quarter.outside_m(DVec2::new(-3.0, -4.0)), 5.0);
    assert_eq!(quarter.least_outside_m(-high, high), -7.0);
    assert_eq!(quarter.most_outside_m(-high, high), high.length());
    assert_eq!(quarter.side_chunks(8.0), i32::MAX);
    let half = Domain::Rectangle {
        low: DVec2::new(0.0, f64::NEG_INFINITY),
        high: DVec2::INFINITY,
    };
    assert_eq!(half.outside_m(DVec2::new(-2.0, 1e9)), 2.0);
    assert_eq!(half.least_outside_m(-high, high), -7.0);
    assert_eq!(half.most_outside_m(-high, high), 7.0);
}

#[test]
fn a_square_turned_four_times_is_as_it_was() {
    for turns in 0..4 {
        let chart = (0..400).map(|n| TiledFlat::chart(I64Vec2::new(n, 7 - n)));
        let frames = chart.map(TiledFlat::frame);
        let frame = frames
            .into_iter()
            .find(|it| it.quarter_turns == turns)
            .unwrap();
        let v = DVec3::new(1.25, 2.5, -7.0);
        assert_eq!(frame.turned_back(frame.turned(v)), v);
        assert_eq!(frame.taken(frame.placed(v)), v);
        let rotation = glam::DQuat::from_rotation_y(f64::from(turns) * TAU / 4.0);
        assert!((rotation * v).distance(frame.turned(v)) < 1e-12);
        let corner = DVec3::new(0.5 * TILE_M, 0.0, -0.5 * TILE_M);
        let away = frame.placed(corner) - frame.placed(DVec3::ZERO);
        assert_eq!(away.abs(), corner.abs());
    }
}

#[test]
fn charts_have_letters_on_a_globe_and_numbers_elsewhere_and_are_read_back_by_either() {
    let names = |space: &dyn Strategy, charts: &[ChartId]| {
        let name = |chart: &ChartId| {
            let name = space.chart_name(*chart);
            assert_eq!(name.parse(), Ok(*chart));
            name
        };
        charts.iter().map(name).collect::<Vec<_>>()
    };
    let two = [ChartId::FIRST, ChartId::SECOND];
    assert_eq!(names(&Spherical::new(32.0), &two), ["A", "B"]);
    let tiles = [(0, 0), (0, 1), (-1, 3)].map(|(x, z)| TiledFlat::chart(I64Vec2::new(x, z)));
    assert_eq!(tiles[..2], two);
    assert_eq!(
        names(&TiledFlat, &tiles),
        ["A", "0x1", "0xffffffff00000003"]
    );
}
