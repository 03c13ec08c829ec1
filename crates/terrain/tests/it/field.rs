//! The field: its formula, its bounds, its continuity, and what chunks can hold.

use crate::common::{Random, chunk, flat, sphere};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, strategy};
use antipode_terrain::{Biome, Content, FIELD_BAND_M, Field, Generator, march};
use glam::{DVec2, DVec3};
use noise::{NoiseFn, Perlin};
use proptest::prelude::*;

/// Seed whose stirred bits seed the noise crate's table with [`FOREST_TABLE`].
const FOREST: u64 = 12;
/// The high half of splitmix64's first number for that seed.
const FOREST_TABLE: u32 = 0x943f_f9fc;

/// The reference's formula, written down with the noise crate's own noise.
fn formula(table: u32, p: DVec3, octaves: &[(f64, f64)]) -> f64 {
    let noise = Perlin::new(table);
    let relief: f64 = octaves.iter().map(|o| o.1 / 2.0).sum();
    let sum: f64 = octaves
        .iter()
        .map(|&(f, a)| {
            let q = [p.x * 0.1553 * f, p.y * 0.1271 * f, p.z * 0.0916 * f];
            noise.get(q) / 2.0 * a
        })
        .sum();
    p.y + sum - relief
}

#[test]
fn the_field_is_the_references_formula_near_the_surface() {
    let field = Field::made_by(Generator::OneBiome, FOREST, flat());
    let octaves = [(0.20, 18.0), (0.40, 9.0), (0.80, 4.5)];
    let mut random = Random(1);
    let mut compared = 0;
    for _ in 0..3000 {
        let p = DVec3::new(
            random.between(-500.0, 500.0),
            random.between(0.0, 32.0),
            random.between(-500.0, 500.0),
        );
        let expected = formula(FOREST_TABLE, p, &octaves);
        if expected.abs() < f64::from(FIELD_BAND_M) {
            let found = f64::from(field.sample(ChartPoint::a(p)));
            assert!((found - expected).abs() < 1e-4, "{p}: {found} {expected}");
            compared += 1;
        }
    }
    assert!(compared > 1000);
}

#[test]
fn the_field_of_a_sphere_is_the_same_noise_squeezed() {
    let noise = Perlin::new(FOREST_TABLE);
    for radius in [16.0, 32.0, 256.0] {
        let space = strategy(Geometry::Spherical, radius);
        let field = Field::made_by(Generator::OneBiome, FOREST, space.clone());
        let (low, high) = (0.15 * radius, 0.5 * radius);
        let mut random = Random(8);
        for _ in 0..2000 {
            let p = ChartPoint::new(
                [ChartId::FIRST, ChartId::SECOND][usize::from(random.unit() < 0.5)],
                DVec3::new(
                    random.between(-radius, radius),
                    random.between(low, high),
                    random.between(-radius, radius),
                ),
            );
            let q = space.noise_point(p) * DVec3::new(0.1553, 0.1271, 0.0916);
            let sum: f64 = [(0.20, 18.0), (0.40, 9.0), (0.80, 4.5)]
                .iter()
                .map(|&(f, a)| noise.get((q * f).to_array()) / 2.0 * a)
                .sum();
            let t = 2.2 * sum / 15.75;
            let half = (0.49 * (high - low)).min(11.0);
            let ground = f64::midpoint(low, high) - half * t / (1.0 + t * t).sqrt();
            let band = f64::from(FIELD_BAND_M);
            let expected = (p.pos.y - ground).clamp(-band, band);
            let found = f64::from(field.sample(p));
            assert!((found - expected).abs() < 1e-4, "{p:?}: {found} {expected}");
        }
    }
}

const GOLDEN: [[f32; 3]; 5] = [
    [-2.947_894, 4.466_333, -7.323_715],
    [2.932_262, 2.558_689, -3.738_064],
    [5.303_747, 1.460_436, -4.150_923],
    [1.203_591, 4.460_251, 0.757_350],
    [4.892_81, 0.536_076, -8.0],
];

/// Worlds on disk hold edits of this very ground: a change here changes players' worlds.
#[test]
fn golden_values() {
    let points = [
        DVec3::new(0.3, 14.2, -7.9),
        DVec3::new(101.5, 18.0, 44.25),
        DVec3::new(-63.0, 12.5, 250.75),
    ];
    for (seed, expected) in GOLDEN.into_iter().enumerate() {
        let field = Field::made_by(Generator::OneBiome, seed as u64, flat());
        let found = points.map(|p| field.sample(ChartPoint::a(p)));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-4,
                "seed {seed}: {found} {expected}"
            );
        }
    }
}

#[test]
fn seeds_of_one_biome_differ() {
    let height = |seed| {
        Field::made_by(Generator::OneBiome, seed, flat()).surface_height(
            ChartId::FIRST,
            40.5,
            -13.25,
        )
    };
    let heights: Vec<_> = (0..6).map(|n| height(2 + 5 * n)).collect();
    for (n, a) in heights.iter().enumerate() {
        for b in &heights[n + 1..] {
            assert!((a - b).abs() > 1e-3, "{heights:?}");
        }
    }
}

#[test]
fn single_samples_and_chunks_agree_and_neighbours_overlap_bit_for_bit() {
    for space in [flat(), sphere()] {
        let field = Field::made_by(Generator::OneBiome, 9, space);
        let here = field.samples(chunk(ChartId::SECOND, 0, 0, -1));
        let next = field.samples(chunk(ChartId::SECOND, 1, 0, -1));
        let above = field.samples(chunk(ChartId::SECOND, 0, 1, -1));
        for n in (0..35).step_by(3) {
            for m in 0..35 {
                let p = DVec3::new(n as f64 - 1.0, m as f64 - 1.0, 6.0 - 32.0);
                let single = field.sample(ChartPoint::new(ChartId::SECOND, p));
                assert_eq!(here.get(n, m, 7), single);
                for side in 0..3 {
                    assert_eq!(here.get(32 + side, m, n), next.get(side, m, n));
                    assert_eq!(here.get(n, 32 + side, m), above.get(n, side, m));
                }
            }
        }
    }
}

#[test]
fn the_field_is_continuous_over_the_equator() {
    let space = sphere();
    let field = Field::made_by(Generator::OneBiome, 21, space.clone());
    let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
    let mut random = Random(5);
    for _ in 0..500 {
        let angle = random.between(0.0, std::f64::consts::TAU);
        let ground = DVec2::from_angle(angle) * (rim + random.between(-8.0, 8.0));
        let y = random.between(4.0, 17.0);
        let here = ChartPoint::a(DVec3::new(ground.x, y, ground.y));
        let there = space.images(here, f64::INFINITY)[0].point;
        assert_eq!(there.chart, ChartId::SECOND);
        let (a, b) = (field.sample(here), field.sample(there));
        assert!((a - b).abs() < 1e-4, "{here:?}: {a} {b}");
    }
}

#[test]
fn spherical_ground_keeps_strictly_within_its_limits_and_uses_them() {
    for radius in [16.0, 32.0, 64.0] {
        let space = strategy(Geometry::Spherical, radius);
        let limits = space.limits().unwrap();
        let (mut lowest, mut highest) = (f64::MAX, f64::MIN);
        for seed in 0..5 {
            let field = Field::made_by(Generator::OneBiome, seed, space.clone());
            let mut random = Random(seed);
            for _ in 0..2000 {
                let x = random.between(-radius, radius);
                let z = random.between(-radius, radius);
                let y = field.surface_height(ChartId::FIRST, x, z);
                lowest = lowest.min(y);
                highest = highest.max(y);
                let under = ChartPoint::a(DVec3::new(x, limits.ground_min_m, z));
                assert!(field.sample(under) < 0.0);
                let over = ChartPoint::a(DVec3::new(x, limits.ground_max_m, z));
                assert!(field.sample(over) > 0.0);
            }
        }
        assert!(lowest > limits.ground_min_m && highest < limits.ground_max_m);
        let used = (highest - lowest) / (limits.ground_max_m - limits.ground_min_m);
        assert!(used > 0.6, "ground of radius {radius} is flat: {used}");
    }
}

#[test]
fn far_away_and_nonsense_coordinates_are_finite() {
    for space in [flat(), sphere()] {
        let field = Field::made_by(Generator::OneBiome, 0, space);
        for far in [1e8, -1e8, 1e18, -1e300, f64::INFINITY, f64::NAN] {
            for p in [
                DVec3::new(far, 12.0, 3.0),
                DVec3::new(1.0, far, 3.0),
                DVec3::splat(far),
            ] {
                let value = field.sample(ChartPoint::a(p));
                assert!(value.abs() <= FIELD_BAND_M, "{p}: {value}");
            }
        }
    }
    let field = Field::made_by(Generator::OneBiome, 0, flat());
    let far = chunk(ChartId::FIRST, 3_125_000, 0, -3_125_000);
    let mesh = march(&field.samples(far), &field, far);
    assert!(mesh.triangles().len() > 500, "ground goes on at 1e8 m");
}

#[test]
fn surface_height_is_where_air_ends() {
    for space in [flat(), sphere()] {
        let field = Field::made_by(Generator::OneBiome, 3, space);
        for n in 0..200 {
            let (x, z) = (f64::from(n) * 0.37 - 30.0, f64::from(n) * 0.11 - 9.0);
            let y = field.surface_height(ChartId::FIRST, x, z);
            let at = |y| field.sample(ChartPoint::a(DVec3::new(x, y, z)));
            assert!(at(y + 1e-3) >= 0.0 && at(y - 1e-3) < 0.0, "({x}, {z}): {y}");
        }
    }
}

#[test]
fn content_costs_layers_only_where_ground_can_be() {
    let field = Field::made_by(Generator::OneBiome, 0, flat());
    let at = |y| field.content(chunk(ChartId::FIRST, 7, y, -3));
    assert_eq!(at(-2), Content::Solid);
    assert_eq!(
        at(-1),
        Content::Solid,
        "up to y = 1 by a look at the ground"
    );
    assert_eq!(at(0), Content::Surface);
    assert_eq!(at(2), Content::Air);
    assert!(
        Biome::from_seed(0).max_amplitude_m() * 2.0 > 33.0,
        "layer 1 holds peaks"
    );

    let forest = Field::made_by(Generator::OneBiome, 2, flat());
    let above = chunk(ChartId::FIRST, 7, 1, -3);
    assert_eq!(
        forest.content(above),
        Content::Air,
        "peaks reach 31.5 m, its border 31 m, but not here"
    );

    let field = Field::made_by(Generator::OneBiome, 0, sphere());
    let at = |x, y| field.content(chunk(ChartId::SECOND, x, y, 0));
    assert_eq!(at(0, -1), Content::Solid);
    assert_eq!(at(1, 0), Content::Surface);
    assert_eq!(at(0, 1), Content::Air);
    assert_eq!(at(2, 0), Content::Air, "past the rim and its reach");
}

/// What the chunk's samples are, all of them.
fn truly(field: &Field, coord: ChunkCoord) -> Content {
    let samples = field.samples(coord);
    let solid = samples.values().iter().filter(|&&v| v < 0.0).count();
    if solid == 0 {
        Content::Air
    } else if solid == samples.values().len() {
        Content::Solid
    } else {
        Content::Surface
    }
}

#[test]
fn most_chunks_without_surface_are_known_and_none_is_mistaken() {
    for seed in 0..10 {
        let field = Field::made_by(Generator::OneBiome, seed, flat());
        for layer in [-1, 0, 1] {
            let (mut free, mut known) = (0, 0);
            for n in 0..49 {
                let coord = chunk(ChartId::FIRST, n % 7 * 5 - 300, layer, n / 7 * 9);
                let (found, truth) = (field.content(coord), truly(&field, coord));
                assert!(
                    found == truth || found == Content::Surface,
                    "{seed} {coord:?}"
                );
                free += i32::from(truth != Content::Surface);
                known += i32::from(found != Content::Surface);
            }
            assert!(known * 2 >= free, "{seed} {layer}: {known} of {free}");
        }
    }
}

#[test]
fn content_of_spheres_of_every_size_is_never_mistaken() {
    for radius in [16.0, 20.0, 64.0, 100.0, 256.0] {
        for seed in 0..5 {
            let field = Field::made_by(
                Generator::OneBiome,
                seed,
                strategy(Geometry::Spherical, radius),
            );
            for layer in -1..5 {
                let coord = chunk(ChartId::SECOND, -1, layer, 0);
                let (found, truth) = (field.content(coord), truly(&field, coord));
                assert!(
                    found == truth || found == Content::Surface,
                    "{seed} {coord:?}"
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..ProptestConfig::default() })]
    #[test]
    fn content_is_never_wrong(seed in 0_u64..1000, x in -2_i32..2, y in -2_i32..3, z in -2_i32..2, curved: bool) {
        let field = Field::made_by(Generator::OneBiome, seed, if curved { sphere() } else { flat() });
        let coord = chunk(ChartId::FIRST, x, y, z);
        let samples = field.samples(coord);
        match field.content(coord) {
            Content::Air => {
                prop_assert!(march(&samples, &field, coord).is_empty());
                if !curved {
                    prop_assert!(samples.values().iter().all(|&v| v >= 0.0));
                }
            }
            Content::Solid => prop_assert!(samples.values().iter().all(|&v| v < 0.0)),
            Content::Surface => {}
        }
    }
}

#[test]
fn every_biome_makes_ground_in_its_own_colours() {
    let mut means = Vec::new();
    for seed in 0..5 {
        let field = Field::made_by(Generator::OneBiome, seed, flat());
        let coord = chunk(ChartId::FIRST, 2, 0, 1);
        let mesh = march(&field.samples(coord), &field, coord);
        assert!(!mesh.is_empty(), "{}", Biome::from_seed(seed).name());
        let sum = mesh.vertices.iter().fold(DVec3::ZERO, |sum, v| {
            sum + DVec3::from([v.colour[0], v.colour[1], v.colour[2]].map(f64::from))
        });
        means.push(sum / mesh.vertices.len() as f64);
    }
    for (n, a) in means.iter().enumerate() {
        for b in &means[n + 1..] {
            assert!(a.distance(*b) > 20.0, "{means:?}");
        }
    }
}
