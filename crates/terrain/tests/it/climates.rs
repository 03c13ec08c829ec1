//! Land of several biomes: how much there is of each, how they go over into each other, and what is known of it.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, Geometry, Strategy, strategy};
use antipode_terrain::{Content, Field, Generator};
use glam::{DVec2, DVec3};

use crate::common::{Random, chunk, flat};

fn land(seed: u64, space: Arc<dyn Strategy>) -> Field {
    Field::made_by(Generator::Climates, seed, space)
}

fn name(field: &Field, chart: ChartId, x: f64, z: f64) -> &'static str {
    let place = ChartPoint::new(chart, DVec3::new(x, 0.0, z));
    field.biome_at(place).name()
}

/// By name the share of a square kilometre about a place.
fn shares(field: &Field, middle: DVec2) -> BTreeMap<&'static str, f64> {
    const ACROSS: u32 = 50;
    let mut shares = BTreeMap::new();
    for n in 0..ACROSS * ACROSS {
        let at = DVec2::new(f64::from(n / ACROSS), f64::from(n % ACROSS)) * 20.0 - 490.0 + middle;
        *shares
            .entry(name(field, ChartId::FIRST, at.x, at.y))
            .or_default() += f64::from(ACROSS * ACROSS).recip();
    }
    shares
}

#[test]
fn a_square_kilometre_has_four_biomes_and_the_world_all_nine() {
    let mut all: BTreeMap<_, f64> = BTreeMap::new();
    let mut counts = Vec::new();
    for seed in 100..120 {
        let found = shares(&land(seed, flat()), DVec2::ZERO);
        let count = found.values().filter(|share| **share >= 0.03).count();
        counts.push(count);
        for (name, share) in found {
            *all.entry(name).or_default() += share / 20.0;
        }
    }
    println!("biomes of 3 % and more within 1 km2: {counts:?}; of all {all:.3?}");
    assert!(counts.iter().all(|count| *count >= 4), "{counts:?}");
    assert!(
        all.len() >= 9 && all.values().all(|it| *it > 0.02),
        "{all:?}"
    );
}

#[test]
fn worlds_begin_where_one_likes_to_go_on_and_open_ones_with_another_biome_near() {
    let closed = |radius_m| strategy(Geometry::Spherical, radius_m);
    for seed in 500..540 {
        for space in [flat(), closed(32.0), closed(128.0)] {
            let is_open = space.globe().is_none();
            let field = land(seed, space);
            let of = |x: f64, z: f64| name(&field, ChartId::FIRST, x, z);
            let first = of(0.0, 0.0);
            assert!(
                !["tundra", "wetland", "crags"].contains(&first),
                "{seed}: {first}"
            );
            let about = [[150.0, 0.0], [-150.0, 0.0], [0.0, 150.0], [0.0, -150.0]];
            let is_varied = about.iter().any(|[x, z]| of(*x, *z) != first);
            assert!(!is_open || is_varied, "{seed}: {first} all about");
        }
    }
}

#[test]
fn a_walk_of_ten_minutes_crosses_three_biomes() {
    let mut least = Vec::new();
    for seed in 100..120 {
        let field = land(seed, flat());
        let mut random = Random(seed);
        let angle = random.between(0.0, std::f64::consts::TAU);
        let way = DVec2::from_angle(angle);
        let mut names: Vec<_> = (0..270)
            .map(|n| way * 10.0 * f64::from(n))
            .map(|at| name(&field, ChartId::FIRST, at.x, at.y))
            .collect();
        names.sort_unstable();
        names.dedup();
        least.push(names.len());
    }
    println!("biomes on a straight walk of 2.7 km: {least:?}");
    assert!(least.iter().all(|count| *count >= 3), "{least:?}");
}

#[test]
fn closed_worlds_have_two_biomes_and_large_ones_three() {
    for radius_m in [16.0, 32.0, 64.0, 99.0, 100.0, 256.0] {
        let mut least = 1.0_f64;
        for seed in 100..120 {
            let field = land(seed, strategy(Geometry::Spherical, radius_m));
            let mut random = Random(seed);
            let mut counts: BTreeMap<_, f64> = BTreeMap::new();
            for _ in 0..2000 {
                // Evenly over the sphere: the height of a place on it is as likely as any other.
                let up = random.between(-1.0, 1.0);
                let chart = [ChartId::FIRST, ChartId::SECOND][usize::from(up < 0.0)];
                let from_pole = up.abs().acos();
                let radius = (0.5 * from_pole).tan() * radius_m;
                let at = DVec2::from_angle(random.between(0.0, std::f64::consts::TAU)) * radius;
                *counts.entry(name(&field, chart, at.x, at.y)).or_default() += 1.0 / 2000.0;
            }
            let expected = if radius_m < 100.0 { 2 } else { 3 };
            assert_eq!(counts.len(), expected, "{radius_m} {seed} {counts:?}");
            least = counts.values().fold(least, |least, it| least.min(*it));
        }
        println!("radius {radius_m} m: the smallest biome has {least:.3} of a world");
        assert!(least > 0.03, "{radius_m}: {least}");
    }
}

#[test]
fn chunks_are_known_from_bounds_and_none_is_mistaken() {
    let (mut free, mut known) = ([0; 4], [0; 4]);
    for seed in 100..108 {
        let field = land(seed, flat());
        for layer in -1..3 {
            for n in 0..100 {
                let coord = chunk(ChartId::FIRST, n % 10 * 7 - 33, layer, n / 10 * 7 - 33);
                let samples = field.samples(coord);
                let solid = samples.values().iter().filter(|v| **v < 0.0).count();
                let truth = match solid {
                    0 => Content::Air,
                    all if all == samples.values().len() => Content::Solid,
                    _ => Content::Surface,
                };
                let found = field.content(coord);
                assert!(
                    found == truth || found == Content::Surface,
                    "{seed} {coord:?}: {found:?}, not {truth:?}"
                );
                free[(layer + 1) as usize] += i32::from(truth != Content::Surface);
                known[(layer + 1) as usize] += i32::from(found != Content::Surface);
            }
        }
    }
    println!("chunks without a surface that are told, by layers: {known:?} of {free:?}");
    let share = f64::from(known.iter().sum::<i32>()) / f64::from(free.iter().sum::<i32>());
    println!("{:.1} %", 100.0 * share);
    assert!(share >= 0.9, "{share}");
}

#[test]
fn single_samples_and_chunks_agree_bit_for_bit() {
    for space in [flat(), strategy(Geometry::Spherical, 48.0)] {
        let field = land(9, space);
        for layer in [0, 1] {
            let here = field.samples(chunk(ChartId::SECOND, 0, layer, -1));
            for n in (0..35).step_by(3) {
                for m in 0..35 {
                    let y = m as f64 - 1.0 + 32.0 * f64::from(layer);
                    let p = DVec3::new(n as f64 - 1.0, y, 6.0 - 32.0);
                    let single = field.sample(ChartPoint::new(ChartId::SECOND, p));
                    assert_eq!(here.get(n, m, 7), single, "{p}");
                }
            }
        }
    }
}

/// Height over a place of hemisphere A.
fn height(field: &Field, at: DVec2) -> f64 {
    field.surface_height(ChartId::FIRST, at.x, at.y)
}

#[test]
#[ignore = "prints how high and steep the land is"]
fn print_heights_and_slopes() {
    let mut all: BTreeMap<&str, [Vec<f64>; 2]> = BTreeMap::new();
    for seed in 100..108 {
        let field = land(seed, flat());
        let mut random = Random(seed);
        for _ in 0..3000 {
            let at = DVec2::new(random.between(-900.0, 900.0), random.between(-900.0, 900.0));
            let here = height(&field, at);
            let beside = [DVec2::X, DVec2::Y].map(|by| height(&field, at + by) - here);
            let slope = DVec2::from(beside).length().atan().to_degrees();
            let [heights, slopes] = all
                .entry(name(&field, ChartId::FIRST, at.x, at.y))
                .or_default();
            heights.push(here);
            slopes.push(slope);
        }
    }
    for (name, mut numbers) in all {
        let parts = numbers.each_mut().map(|list| {
            list.sort_by(f64::total_cmp);
            [0.02, 0.25, 0.5, 0.75, 0.98]
                .map(|part| list[(part * list.len() as f64) as usize].round())
        });
        println!(
            "{name:10} {:6} heights {:?} slopes {:?}",
            numbers[0].len(),
            parts[0],
            parts[1]
        );
    }
}
