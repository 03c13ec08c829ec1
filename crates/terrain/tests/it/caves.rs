//! Land with caves: what samples, chunks and bounds say of them, and what they are made of.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{Content, FIELD_BAND_M, Field, Generator, Kind, Level};
use glam::{DVec3, IVec3};

use crate::common::{chunk, flat};

fn land(seed: u64, space: Arc<dyn Strategy>) -> Field {
    Field::made_by(Generator::Climates, seed, space)
}

fn spaces() -> [Arc<dyn Strategy>; 4] {
    [
        flat(),
        strategy(Geometry::Hyperbolic, 20.0),
        strategy(Geometry::Spherical, 32.0),
        strategy(Geometry::Spherical, 96.0),
    ]
}

/// Chunks of a block about the middle of a chart, with all layers where there may be caves.
fn chunks(space: &Arc<dyn Strategy>, chart: ChartId, across: i32) -> Vec<ChunkCoord> {
    let heights = if space.limits().is_some() {
        0..2
    } else {
        -2..3
    };
    let columns = (-across..across).flat_map(|x| (-across..across).map(move |z| (x, z)));
    columns
        .flat_map(|(x, z)| heights.clone().map(move |y| chunk(chart, x, y, z)))
        .collect()
}

/// Whether a sample lies in a cave: deep in the land, and no ground.
fn is_cave(field: &Field, point: ChartPoint) -> bool {
    field.land(point) < -3.0 && field.sample(point) > 0.0
}

#[test]
fn single_samples_chunks_and_levels_agree_on_caves_bit_for_bit() {
    for space in spaces() {
        let mut caves = 0;
        let is_small = space.limits().is_some_and(|limits| limits.ceiling_m < 60.0);
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            if space.globe().is_none() && chart == ChartId::SECOND {
                continue;
            }
            let field = land(41, space.clone());
            for coord in chunks(&space, chart, 3) {
                if field.content(coord) != Content::Surface {
                    continue;
                }
                for level in [Level::FULL, Level::ALL[2]] {
                    let samples = field.samples_at(coord, level);
                    let last = samples.side() - 1;
                    for n in 0..800 {
                        let at = [n * 7 % last, n * 13 % last, n * 31 % last];
                        let step = f64::from(level.step_m());
                        let offset = DVec3::from(at.map(|c| c as f64 - 1.0)) * step;
                        let point = ChartPoint::new(chart, coord.origin() + offset);
                        let [i, j, k] = at;
                        assert_eq!(
                            samples.get(i, j, k),
                            field.sample(point),
                            "{coord:?} {at:?}"
                        );
                        caves += usize::from(is_cave(&field, point));
                    }
                }
            }
        }
        println!("{:?}: {caves} samples in caves", space.limits());
        assert!(is_small || caves > 20, "{caves}");
    }
}

#[test]
fn the_field_is_a_number_wherever_one_asks() {
    for space in spaces() {
        let field = land(41, space);
        for far in [
            1e7,
            -4e18,
            1e300,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ] {
            for pos in [
                DVec3::new(far, 3.0, 1.0),
                DVec3::new(2.0, far, far),
                DVec3::splat(far),
            ] {
                let value = field.sample(ChartPoint::a(pos));
                assert!(value.abs() <= FIELD_BAND_M, "{pos}: {value}");
            }
        }
        for index in [
            IVec3::splat(i32::MAX),
            IVec3::splat(i32::MIN),
            IVec3::new(i32::MAX, 0, i32::MIN),
        ] {
            let coord = ChunkCoord {
                chart: ChartId::FIRST,
                index,
            };
            field.content(coord);
            field.samples(coord);
        }
    }
}

#[test]
fn no_chunk_with_a_cave_is_taken_for_solid_and_nine_in_ten_of_the_others_are_known() {
    for space in [flat(), strategy(Geometry::Spherical, 96.0)] {
        let (mut known, mut bare) = (0, 0);
        for seed in 60..63 {
            let field = land(seed, space.clone());
            for coord in chunks(&space, ChartId::FIRST, 4) {
                let samples = field.samples(coord);
                let solid = samples
                    .values()
                    .iter()
                    .filter(|value| **value < 0.0)
                    .count();
                let content = field.content(coord);
                match content {
                    Content::Solid => assert_eq!(solid, samples.values().len(), "{coord:?}"),
                    Content::Air => assert_eq!(solid, 0, "{coord:?}"),
                    Content::Surface => {}
                }
                if solid == 0 || solid == samples.values().len() {
                    bare += 1;
                    known += usize::from(content != Content::Surface);
                }
            }
        }
        println!("{known} of {bare} chunks without a surface are known");
        // The ground of closed worlds is squeezed into so few layers that their heights decide alone.
        assert!(
            space.limits().is_some() || known * 10 >= bare * 9,
            "{known} of {bare}"
        );
    }
}

/// Of columns of coarse samples below which a cave runs, how many have lost the land over it: from the surface down to the
/// cave none of them is solid.
fn lost_roofs(field: &Field, level: Level) -> (usize, usize) {
    let step = f64::from(level.step_m());
    let (mut lost, mut all) = (0, 0);
    for n in 0..100 * 100 {
        let (x, z) = (
            f64::from(n % 100 - 50) * step,
            f64::from(n / 100 - 50) * step,
        );
        let point = |y: f64| ChartPoint::a(DVec3::new(x, y, z));
        let (low, high) = field.ground_range_m();
        let heights = (0..200)
            .map(|n| high - f64::from(n) * 0.5)
            .take_while(|y| *y > low - 40.0);
        let top = heights.clone().find(|y| field.land(point(*y)) < 0.0);
        let roof = heights.clone().find(|y| is_cave(field, point(*y)));
        let (Some(top), Some(roof)) = (top, roof) else {
            continue;
        };
        // Where it lies open there is none.
        let is_open = heights
            .filter(|y| (roof..top).contains(y))
            .all(|y| field.sample(point(y)) > 0.0);
        if is_open {
            continue;
        }
        all += 1;
        let first = (roof / step).ceil() as i32;
        let last = (top / step).floor() as i32;
        let mut samples = (first..=last).map(|n| f64::from(n) * step);
        lost += usize::from(!samples.any(|y| field.sample(point(y)) < 0.0));
    }
    (lost, all)
}

#[test]
fn far_land_keeps_its_roofs_over_caves() {
    for (space, levels) in [
        (flat(), 1..4),
        (strategy(Geometry::Spherical, 256.0), 1..4),
        (strategy(Geometry::Spherical, 64.0), 1..3),
        (strategy(Geometry::Spherical, 32.0), 1..2),
    ] {
        for level in &Level::ALL[levels] {
            let counts = (60..63).map(|seed| lost_roofs(&land(seed, space.clone()), *level));
            let (lost, all) = counts.fold((0, 0), |sum, it| (sum.0 + it.0, sum.1 + it.1));
            println!(
                "{:?} {level:?}: {lost} of {all} roofs are lost",
                space.globe().is_some()
            );
            assert!(all > 20 && lost * 20 <= all, "{level:?}: {lost} of {all}");
        }
    }
}

#[test]
fn caves_are_dark_rock_inside_and_halls_grow_crystal() {
    let field = land(41, flat());
    let solid = field.without_caves();
    let (mut walls, mut surface, mut grown, mut light) = (0, 0, 0, 0);
    for coord in chunks(&flat(), ChartId::FIRST, 6) {
        if field.content(coord) != Content::Surface {
            continue;
        }
        let [samples, before] = [&field, &solid].map(|field| field.samples(coord));
        for n in 0..32 * 32 * 32 {
            let local = IVec3::new(n >> 10, n >> 5 & 31, n & 31);
            let point = ChartPoint::new(coord.chart, coord.origin() + local.as_dvec3());
            let above = point.moved(DVec3::Y);
            // Floors and ceilings of caves, well below the land.
            if field.sample(point) < 0.0 && is_cave(&field, above) && field.land(above) < -7.0 {
                walls += 1;
                let kind = samples.kind_of_sample(&field, coord, local);
                // Not that of veins, which there is without a cave, too.
                let was = before.kind_of_sample(&solid, coord, local);
                grown += usize::from(kind == Kind::Crystal && was != Kind::Crystal);
                light += usize::from(field.sky_left(above) > 0.1);
                surface += usize::from(!kind.is_deep());
            }
        }
    }
    println!(
        "{walls} walls, {surface} of kinds that lie above ground, {grown} crystal, {light} light"
    );
    assert!(walls > 500 && grown > 5, "{walls} {grown}");
    assert_eq!(light, 0);
    assert!(surface * 20 < walls, "{surface} of {walls}");
}
