//! What is near, however many tiles lie between.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::tiled::{about_corner, beside, fits};
use antipode_geometry::tiling::{Frame, Side, rings};
use antipode_geometry::{
    Atlas, ChartId, ChartPoint, ChunkCoord, ChunkCube, Eye, HyperbolicWorld, Metric, Tiled,
};
use glam::{DVec2, DVec3, IVec3, Vec3Swizzles};
use proptest::prelude::{prop_assert, proptest};

use super::common::{apart_m, beyond, charts, place, steps, worlds};
use crate::space::common::{cases, vector};

fn level(point: ChartPoint) -> ChartPoint {
    ChartPoint::new(point.chart, point.pos.with_y(0.0))
}

/// How far it is to the nearest of many places of a box of a chart, metres.
fn sampled_away_m(
    world: &HyperbolicWorld,
    at: ChartPoint,
    chart: ChartId,
    low: DVec2,
    high: DVec2,
) -> f64 {
    let share = |n: u32| f64::from(n) / 40.0;
    let places = (0..41 * 41).map(|n| {
        let pos = low + (high - low) * DVec2::new(share(n / 41), share(n % 41));
        ChartPoint::new(chart, DVec3::new(pos.x, 0.0, pos.y))
    });
    let away = places.map(|to| world.distance_m(level(at), to, &Eye::default()));
    away.fold(f64::INFINITY, f64::min)
}

/// Within 250 m there are as many tiles as their nearest places say, of which the disc's land is but a part.
#[test]
fn tiles_within_a_distance_are_those_that_come_so_near_and_nearest_first() {
    for world in worlds() {
        let at = ChartPoint::a(DVec3::new(5.0, 9.0, -3.0));
        let reach_m = 3.0 * world.radius_m();
        let found = world.charts_within(at, reach_m);
        let half_m = world.domain(at.chart).half_width_m();
        let away = |chart| {
            sampled_away_m(
                &world,
                at,
                chart,
                DVec2::splat(-half_m),
                DVec2::splat(half_m),
            )
        };
        let about: Vec<_> = rings(&Frame::ROOT, 6, 2000).unwrap().concat();
        let numbers = about.iter().map(|it| it.path().unwrap().number());
        let slack_m = half_m / 20.0;
        for chart in numbers.map(ChartId::new) {
            let away_m = away(chart);
            if away_m < reach_m || away_m > reach_m + slack_m {
                assert_eq!(found.contains(&chart), away_m < reach_m, "{chart} {away_m}");
            }
        }
        assert_eq!(found[0], ChartId::FIRST);
        let aways: Vec<_> = found.iter().map(|it| away(*it)).collect();
        assert!(aways.windows(2).all(|it| it[0] <= it[1] + slack_m));
        assert_eq!(found.iter().collect::<BTreeSet<_>>().len(), found.len());
    }
}

/// As much as a flat view's square has twice, and no more than that at any size.
#[test]
fn land_is_there_as_far_as_twice_a_flat_views_goes() {
    for world in worlds() {
        let radius_m = world.radius_m();
        for chunks in 0..64 {
            let view_m = (f64::from(chunks) + 0.5) * 32.0;
            let reach_m = world.land_reach_m(view_m);
            let land_m2 =
                2.0 * std::f64::consts::PI * radius_m.powi(2) * ((reach_m / radius_m).cosh() - 1.0);
            assert!(
                land_m2 <= 8.0 * view_m * view_m * (1.0 + 1e-9),
                "{chunks} {land_m2}"
            );
            assert!(reach_m <= view_m && reach_m <= 5.0 * radius_m + 1e-9);
            assert!(
                reach_m >= 0.9 * view_m.min(2.5 * radius_m),
                "{chunks} {reach_m}"
            );
        }
    }
}

/// The chunk over an edge has the same face, and from there it leads back.
#[test]
fn a_chunk_over_an_edge_has_the_same_face() {
    for world in &worlds()[1..] {
        let half = (world.domain(ChartId::FIRST).half_width_m() / 32.0) as i32;
        for number in (0..200).chain([1 << 70]) {
            let chart = ChartId::new(number);
            let all = ChunkCoord::boxed(
                chart,
                IVec3::new(-half, 3, -half),
                IVec3::new(half - 1, 3, half - 1),
            );
            for coord in all {
                for step in [IVec3::X, IVec3::NEG_X, IVec3::Z, IVec3::NEG_Z, IVec3::Y] {
                    let over = beside(world, coord, step);
                    if over.chart == chart {
                        assert_eq!(over, coord.offset(step));
                        continue;
                    }
                    let face = coord.centre() + step.as_dvec3() * 16.0;
                    let there = world.carry(ChartPoint::new(chart, face), over.chart);
                    let off = there.unwrap().point.pos - over.centre();
                    assert!((off.xz().length() - 16.0).abs() < 1e-6, "{coord:?} {off}");
                    let back = -(off / 16.0).round().as_ivec3();
                    assert_eq!(beside(world, over, -back), coord);
                }
            }
        }
    }
    // Where edges run through chunks, the same stretch of the edge is in both.
    let narrow = &worlds()[0];
    for number in 0..50 {
        for [x, z] in [[0, 0], [-1, 0], [0, -1], [-1, -1]] {
            let coord = ChunkCoord::new(ChartId::new(number), IVec3::new(x, 2, z));
            let step = IVec3::X * (2 * x + 1);
            let over = beside(narrow, coord, step);
            let middle = step.as_dvec3() * 16.0 + DVec3::new(0.0, 80.0, f64::from(2 * z + 1) * 8.0);
            let there = narrow
                .carry(ChartPoint::new(coord.chart, middle), over.chart)
                .unwrap();
            let slightly = ChartPoint::new(over.chart, there.point.pos * 0.999);
            assert_eq!(ChunkCoord::containing(slightly), over);
        }
    }
    let chart = ChartId::FIRST;
    assert!(!fits(narrow, chart) && fits(&worlds()[1], chart) && fits(&worlds()[2], chart));
}

#[test]
fn a_cube_has_tiles_that_are_written_nowhere_near() {
    for world in &worlds()[..2] {
        let centre = ChunkCoord::containing(ChartPoint::a(DVec3::new(3.0, 10.0, 4.0)));
        let cube = ChunkCube::about(world, centre, 7, 8.0);
        for over in 1..4 {
            let chart = beyond(ChartId::FIRST, &[Side::new(0)].repeat(over));
            let coord = ChunkCoord::new(chart, centre.index);
            let away_m = world.level_way_m(
                ChartPoint::new(centre.chart, centre.centre()),
                ChartPoint::new(chart, DVec3::ZERO),
            );
            let away = away_m.unwrap().xz().length() / 32.0;
            assert!(cube.has(coord, 6), "{over}");
            assert!(!cube.has(coord, 0));
            let apart = cube.apart(coord).unwrap().as_dvec3().xz().length();
            assert!((apart - away).abs() < 2.0, "{over}: {apart} {away}");
        }
        // One tile more than there is.
        let far = beyond(ChartId::FIRST, &[Side::new(0)].repeat(8));
        assert!(cube.apart(ChunkCoord::new(far, centre.index)).is_none());
    }
}

/// A chunk that lies past an edge is in the cube for bodies; nothing lists it with the land.
#[test]
fn chunks_past_an_edge_are_not_among_the_land() {
    let world = &worlds()[1];
    let centre = ChunkCoord::new(ChartId::FIRST, IVec3::ZERO);
    let cube = ChunkCube::about(world, centre, 3, 8.0);
    let past = ChunkCoord::new(ChartId::FIRST, IVec3::new(1, 0, 0));
    assert!(cube.has(past, 2) && cube.is_past_edge(past) && !cube.is_past_edge(centre));
    let all: BTreeSet<_> = cube.chunks(2).into_iter().collect();
    assert!(all.contains(&centre) && !all.contains(&past));
    assert!(
        all.iter()
            .all(|coord| cube.has(*coord, 2) && !cube.is_past_edge(*coord))
    );
    assert!(cube.past_edges(ChartId::FIRST, 2).contains(&past));
    // Tiles of four columns, each once.
    let columns: BTreeSet<_> = all
        .iter()
        .map(|it| (it.chart, it.index.x, it.index.z))
        .collect();
    assert_eq!(columns.len() * 5, all.len());
}

/// Where tiles are as wide as a chunk, the corners of tiles are the middles of chunks, and all five charts tell of the same land.
#[test]
fn the_land_about_a_corner_is_the_same_whichever_of_the_five_charts_tells() {
    let world = &worlds()[0];
    let corner = ChartPoint::a(DVec3::splat(16.0));
    let others = world.images(corner, 1e-6).into_iter().map(|it| it.point);
    let all: Vec<_> = others
        .chain([corner])
        .map(|at| {
            let centre =
                ChunkCoord::containing(at.moved(DVec3::new(-1e-6, 0.0, -1e-6) * at.pos.signum()));
            ChunkCube::about(world, centre, 7, 8.0)
        })
        .collect();
    assert_eq!(all.len(), 5);
    for cube in &all[1..] {
        let sets = [cube, &all[0]].map(|it| it.chunks(6).into_iter().collect::<BTreeSet<_>>());
        let differing = sets[0].symmetric_difference(&sets[1]).count();
        assert!(
            sets[0].len() > 5000 && differing * 100 < sets[0].len(),
            "{differing}"
        );
    }
}

/// What is asked of many boxes at once is what is asked of each.
#[test]
fn boxes_are_as_far_together_as_one_by_one() {
    for world in worlds() {
        let half_m = world.domain(ChartId::FIRST).half_width_m();
        let quarter = DVec2::splat(0.5 * half_m);
        let boxes = [[-2.0, -1.0], [-1.0, 0.0], [0.0, 2.0]].map(|it| it.map(|it| it * quarter));
        let far = beyond(ChartId::FIRST, &[Side::new(1)].repeat(30));
        for chart in [ChartId::FIRST, far] {
            let at = ChartPoint::new(chart, DVec3::new(0.7, 0.3, -0.4) * half_m);
            let reach_m = 2.5 * world.radius_m();
            let found = world.boxes_within(at, reach_m, &boxes);
            let charts: Vec<_> = found.iter().map(|(chart, _)| *chart).collect();
            assert_eq!(charts, world.charts_within(at, reach_m));
            assert!(charts.len() > 20 && found.iter().all(|(_, aways)| aways.len() == 3));
            for (chart, aways) in found {
                for ([low, high], away) in boxes.into_iter().zip(aways) {
                    let nearest_m = world.away_m(at, chart, low, high);
                    let middle = low.midpoint(high);
                    let to = ChartPoint::new(chart, DVec3::new(middle.x, 0.0, middle.y));
                    let way_m = world.level_way_m(at, to).unwrap().xz();
                    assert!((away.nearest_m - nearest_m).abs() < 1e-6, "{chart:?}");
                    assert!(away.way_m.distance(way_m) < 1e-6, "{chart:?}");
                }
            }
        }
        let nowhere = ChartPoint::new(ChartId::new(u128::MAX), DVec3::ZERO);
        assert!(world.boxes_within(nowhere, 50.0, &boxes).is_empty());
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn ways_are_as_long_as_the_shortest_and_lead_there(
        size in 0..3_usize,
        chart in charts(),
        over in steps(6),
        from in vector(1.0),
        to in vector(1.0),
    ) {
        let world = &worlds()[size];
        let from = place(world, chart, from);
        let to = place(world, beyond(chart, &over), to);
        let way = world.level_way_m(from, to).unwrap();
        let level_m = world.distance_m(level(from), level(to), &Eye::default());
        prop_assert!((way.xz().length() - level_m).abs() < 1e-6 * (1.0 + level_m), "{way} {level_m}");
        prop_assert!((way.y - (to.pos.y - from.pos.y)).abs() < 1e-9);
        let near = from.moved(DVec3::new(0.01, 0.0, 0.02));
        let aside = world.level_way_m(from, near).unwrap();
        prop_assert!(aside.normalize().dot(DVec3::new(1.0, 0.0, 2.0).normalize()) > 1.0 - 1e-6);
        let half_m = DVec2::splat(world.domain(to.chart).half_width_m());
        let (low, high) = ((to.pos.xz() - 9.0).max(-half_m), (to.pos.xz() + 5.0).min(half_m));
        let away_m = world.away_m(from, to.chart, low, high);
        let sampled_m = sampled_away_m(world, from, to.chart, low, high);
        prop_assert!(away_m <= sampled_m + 1e-6 && sampled_m < away_m + 0.6, "{away_m} {sampled_m}");
    }
}

#[test]
fn squares_at_an_edge_and_about_a_corner_are_told_apart_alike_from_all() {
    let world = HyperbolicWorld::new(60.305);
    let charts = world.charts_within(ChartPoint::a(DVec3::new(20.0, 0.0, 11.0)), 250.0);
    for chart in charts {
        let joins = world.joins(chart);
        for side in 0..4u8 {
            let (over, back) = world.over(chart, side).unwrap();
            let there = world.joins(over);
            assert_ne!(
                joins.is_second[usize::from(side)],
                there.is_second[usize::from(back)]
            );
            // About the corner at this side's end, from which the next square has its own corner at its side's beginning.
            let here = joins.about[usize::from((side + 3) % 4)];
            assert_eq!(there.about[usize::from(back)], (here + 1) % 5);
        }
        assert_eq!(joins.bits() >> 16, 0);
    }
}

/// Five squares meet at a corner, which is one place.
#[test]
fn round_a_corner_are_five_squares_and_all_have_it_where_they_say() {
    for world in worlds() {
        let half_m = world.domain(ChartId::FIRST).half_width_m();
        let at = |(chart, corner): (ChartId, u8)| {
            let quarters = DVec2::from_angle(f64::from(corner) * FRAC_PI_2);
            let pos = quarters.rotate(DVec2::splat(half_m));
            ChartPoint::new(chart, DVec3::new(pos.x, 3.0, pos.y))
        };
        for number in (0..100).chain([1 << 70]) {
            for corner in 0..4 {
                let first = (ChartId::new(number), corner);
                let about = about_corner(&world, first.0, corner);
                let tiles: BTreeSet<_> = about.iter().map(|(tile, _)| *tile).collect();
                assert_eq!((about.len(), tiles.len(), about[0]), (5, 5, first));
                for other in about {
                    let away_m = apart_m(&world, at(first), at(other));
                    assert!(away_m < 1e-6, "{first:?} {other:?}: {away_m} m");
                }
            }
        }
    }
}
