//! Where things stand: how many, on what, and that they are the same whoever asks.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{
    CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Geometry, HyperbolicWorld, Strategy, strategy,
};
use antipode_plants::{Species, placed};
use antipode_terrain::{Field, Generator, Thing};
use antipode_testing::tiled::{TILE_M, TiledFlat};
use glam::{DVec2, DVec3, I64Vec2, IVec3};

const SIDE: f64 = CHUNK_CELLS as f64;

fn flat() -> Arc<dyn Strategy> {
    strategy(Geometry::Euclidean, 0.0)
}

fn is_tree(thing: &Thing) -> bool {
    Species::of_byte(thing.species).is_some_and(|it| it < Species::Bush)
}

/// What stands on the chunks over a square of the plan of a chart, with its places there.
fn in_square(field: &Field, chart: ChartId, low: [i32; 2], across: i32) -> Vec<(DVec3, Thing)> {
    let (least_m, most_m) = field.ground_range_m();
    let heights = (least_m / SIDE).floor() as i32..=(most_m / SIDE).floor() as i32;
    let columns = (0..across).flat_map(|x| (0..across).map(move |z| (low[0] + x, low[1] + z)));
    let coords = columns.flat_map(|(x, z)| heights.clone().map(move |y| IVec3::new(x, y, z)));
    let on = |index: IVec3| {
        let coord = ChunkCoord::new(chart, index);
        let place = move |it: Thing| (coord.origin() + it.root.as_dvec3(), it);
        placed(field, coord).into_iter().map(place)
    };
    coords.flat_map(on).collect()
}

#[test]
fn forests_have_a_tree_on_25_to_40_square_metres_and_other_land_fewer() {
    let mut found: BTreeMap<&str, (u32, u32)> = BTreeMap::new();
    for seed in 1000..1012 {
        let field = Field::new(seed, flat());
        for tile in 0..12 {
            let low = [tile * 9 - 40, tile * tile % 7 * 11 - 30];
            let things = in_square(&field, ChartId::FIRST, low, 2);
            for (x, z) in (0..16).flat_map(|x| (0..16).map(move |z| (x, z))) {
                let at = DVec3::new(f64::from(low[0]), 0.0, f64::from(low[1])) * SIDE
                    + DVec3::new(f64::from(x) + 0.5, 0.0, f64::from(z) + 0.5) * 4.0;
                let biome = field.biome_at(ChartPoint::a(at)).name();
                found.entry(biome).or_default().0 += 16;
            }
            for (place, _) in things.iter().filter(|(_, it)| is_tree(it)) {
                let biome = field.biome_at(ChartPoint::a(*place)).name();
                found.entry(biome).or_default().1 += 1;
            }
        }
    }
    let per_tree = |biome: &str| f64::from(found[biome].0) / f64::from(found[biome].1);
    for biome in found.keys() {
        println!("{biome}: a tree on {:.1} m2", per_tree(biome));
    }
    assert!((25.0..40.0).contains(&per_tree("forest")), "{found:?}");
    assert!(
        per_tree("desert") > 150.0 && per_tree("jungle") < 45.0,
        "{found:?}"
    );
}

#[test]
fn things_stand_on_the_ground_apart_from_each_other_and_on_no_cave() {
    for (geometry, radius_m) in [
        (Geometry::Euclidean, 0.0),
        (Geometry::Hyperbolic, 40.0),
        (Geometry::Spherical, 64.0),
        (Geometry::Spherical, 24.0),
    ] {
        let space = strategy(geometry, radius_m);
        let mut count = 0;
        for seed in 3..9 {
            let field = Field::new(seed, space.clone());
            let low = if geometry == Geometry::Spherical {
                -3
            } else {
                20
            };
            let things = in_square(&field, ChartId::SECOND, [low, low], 6);
            for (place, thing) in &things {
                let value = |up: f64| {
                    field.sample(ChartPoint::new(ChartId::SECOND, *place + DVec3::Y * up))
                };
                assert!(
                    value(-0.02) < 0.0 && value(0.02) >= 0.0,
                    "{place} {thing:?}"
                );
                assert!(value(-2.0) < 0.0, "a cave below {place}");
                let domain = space.domain(ChartId::SECOND);
                assert!(
                    domain.outside_m(DVec2::new(place.x, place.z)) <= 0.0,
                    "{place}"
                );
            }
            for (n, (a, _)) in things.iter().enumerate() {
                let near = things[..n].iter().map(|(b, _)| b.distance(*a));
                let near = near.fold(f64::INFINITY, f64::min);
                assert!(near > 1.2, "{near} m at {a}");
            }
            count += things.len();
        }
        assert!(count > 100, "{geometry:?}: {count}");
    }
}

#[test]
fn what_stands_in_charts_without_number_is_what_stands_in_one() {
    let one = Field::new(5, flat());
    let many = Field::new(5, Arc::new(TiledFlat));
    let in_tile = (TILE_M / SIDE) as i32;
    let mut whole = 0;
    for tile in [[0, 0], [1, 0], [2, 1], [-1, 3], [4, -2]].map(I64Vec2::from) {
        let chart = TiledFlat::chart(tile);
        let here = in_square(&many, chart, [-in_tile / 2; 2], in_tile);
        let middle = TiledFlat::common(ChartPoint::new(chart, DVec3::ZERO));
        let low = ((middle - 0.5 * TILE_M) / SIDE).round();
        let there = in_square(&one, ChartId::FIRST, [low.x as i32, low.z as i32], in_tile);
        assert_eq!(here.len(), there.len(), "{tile}");
        for (place, thing) in &here {
            let common = TiledFlat::common(ChartPoint::new(chart, *place));
            let same = there.iter().find(|(at, _)| at.distance(common) < 1e-3);
            let (_, same) = same.unwrap_or_else(|| panic!("{thing:?} at {common}"));
            assert_eq!((same.species, same.age), (thing.species, thing.age));
            assert_eq!(same.scale, thing.scale);
            let way = |turn_rad: f32| {
                DVec3::new(f64::from(turn_rad.cos()), 0.0, f64::from(turn_rad.sin()))
            };
            let turned = TiledFlat::frame(chart).turned(way(thing.turn_rad));
            assert!(
                turned.distance(way(same.turn_rad)) < 1e-4,
                "{thing:?} {same:?}"
            );
        }
        whole += here.len();
    }
    assert!(whole > 150, "{whole}");
}

#[test]
fn worlds_begun_before_there_were_things_have_none() {
    for generator in [Generator::OneBiome, Generator::Climates] {
        let field = Field::made_by(generator, 2, flat());
        assert!(in_square(&field, ChartId::FIRST, [0, 0], 6).is_empty());
    }
    let field = Field::made_by(Generator::Planted, 2, flat());
    assert!(!in_square(&field, ChartId::FIRST, [0, 0], 6).is_empty());
}

#[test]
fn at_the_ends_of_the_numbers_nothing_grows_and_nothing_fails() {
    let field = Field::new(7, flat());
    for x in [i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX] {
        let coord = ChunkCoord::new(ChartId::FIRST, IVec3::new(x, 0, -x.max(-i32::MAX)));
        assert!(placed(&field, coord).is_empty());
    }
}

/// A world is the same on every machine and for ever: what stood here when this was written.
#[test]
fn what_stands_where_is_told_by_the_seed() {
    let field = Field::new(7, flat());
    let things = in_square(&field, ChartId::FIRST, [0, 0], 2);
    let told: Vec<_> = things
        .iter()
        .take(4)
        .map(|(at, it)| {
            let name = Species::of_byte(it.species).unwrap().name();
            format!("{name} {} {:.2} {:.2} {:.2}", it.age, at.x, at.y, at.z)
        })
        .collect();
    let told: Vec<&str> = told.iter().map(String::as_str).collect();
    assert_eq!(
        (things.len(), &told[..]),
        (
            90,
            &[
                "birch 2 1.05 33.21 16.91",
                "oak 1 8.60 34.41 5.60",
                "spruce 1 6.58 33.85 9.97",
                "oak 2 9.04 33.85 13.11"
            ][..]
        )
    );
}

#[test]
fn as_much_stands_on_the_tiles_of_the_hyperbolic_world_as_on_flat_land() {
    let world = Arc::new(HyperbolicWorld::new(HyperbolicWorld::RADII_M[1]));
    let (mut plain, mut tiled) = (0, 0);
    for seed in 1000..1004 {
        let field = Field::new(seed, world.clone());
        for chart in (0..24).map(|n| ChartId::new(n * 31)) {
            for (place, _) in in_square(&field, chart, [-1, -1], 2) {
                assert!(place.x.abs().max(place.z.abs()) <= SIDE, "{place}");
                tiled += 1;
            }
        }
        let field = Field::new(seed, flat());
        for n in 0..24 {
            let low = [n % 5 * 11 - 20, n / 5 * 11 - 20];
            plain += in_square(&field, ChartId::FIRST, low, 2).len();
        }
    }
    println!("{tiled} in tiles, {plain} on flat land");
    let ratio = f64::from(tiled) / plain as f64;
    assert!((0.6..1.6).contains(&ratio), "{tiled} {plain}");
}

/// Where the most stands within a view distance of 16 chunks: docs/plants.md has what a picture there costs.
#[test]
#[ignore = "prints numbers"]
fn print_where_the_most_stands_all_round() {
    const ACROSS: i32 = 96;
    const ROUND: i32 = 16;
    for seed in 1..13 {
        let field = Field::new(seed, flat());
        let count = |x: i32, z: i32| {
            let things = in_square(&field, ChartId::FIRST, [x - ACROSS / 2, z - ACROSS / 2], 1);
            let trees = things.iter().filter(|(_, it)| is_tree(it)).count();
            (things.len(), trees)
        };
        let counts: Vec<Vec<(usize, usize)>> = (0..ACROSS)
            .map(|x| (0..ACROSS).map(|z| count(x, z)).collect())
            .collect();
        let round = |at: (i32, i32)| {
            let near = (-ROUND..=ROUND).flat_map(|x| (-ROUND..=ROUND).map(move |z| (x, z)));
            let near = near.filter(|(x, z)| x * x + z * z <= ROUND * ROUND);
            near.map(|(x, z)| counts[(at.0 + x) as usize][(at.1 + z) as usize])
                .fold((0, 0), |sum, it| (sum.0 + it.0, sum.1 + it.1))
        };
        let middles = (ROUND..ACROSS - ROUND)
            .step_by(4)
            .flat_map(|x| (ROUND..ACROSS - ROUND).step_by(4).map(move |z| (x, z)));
        let most = middles.max_by_key(|at| round(*at)).unwrap();
        let [x, z] = [most.0, most.1].map(|it| f64::from(it - ACROSS / 2) * SIDE);
        println!("seed {seed}: {:?} about ({x}, {z})", round(most));
    }
}
