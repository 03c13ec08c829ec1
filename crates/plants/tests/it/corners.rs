//! The stones where five squares meet.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use antipode_geometry::tiled::about_corner;
use antipode_geometry::{
    Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Eye, Geometry, HyperbolicWorld, Metric,
    Tiled, strategy,
};
use antipode_plants::{Age, Growth, Size, Species, placed, placed_near, shape, undergrowth};
use antipode_terrain::{Field, Generator, Thing, march};
use antipode_testing::tiled::TiledFlat;
use glam::{DVec2, DVec3, IVec3, Vec3Swizzles};

const SIDE: f64 = CHUNK_CELLS as f64;

fn worlds() -> [Arc<HyperbolicWorld>; 3] {
    HyperbolicWorld::RADII_M.map(|radius_m| Arc::new(HyperbolicWorld::new(radius_m)))
}

fn is_stone(thing: &Thing) -> bool {
    thing.species == Species::CornerStone.byte()
}

/// Where a corner lies in its chart, on the level.
fn place_of(space: &dyn Atlas, (chart, corner): (ChartId, u8)) -> ChartPoint {
    let half_m = space.domain(chart).half_width_m();
    let pos = DVec2::from_angle(f64::from(corner) * FRAC_PI_2).rotate(DVec2::splat(half_m));
    ChartPoint::new(chart, DVec3::new(pos.x, 0.0, pos.y))
}

/// What stands on the chunks that a square has land on, with its root in the square's chart.
fn on_square(field: &Field, chart: ChartId) -> Vec<(ChartPoint, Thing)> {
    let half = (field.strategy().domain(chart).half_width_m() / SIDE).ceil() as i32;
    let [low, high] = <[f64; 2]>::from(field.ground_range_m()).map(|y| (y / SIDE).floor() as i32);
    let columns = (-half..half).flat_map(|x| (-half..half).map(move |z| (x, z)));
    let coords = columns.flat_map(|(x, z)| (low..=high).map(move |y| IVec3::new(x, y, z)));
    let on = |index: IVec3| {
        let coord = ChunkCoord::new(chart, index);
        let root = move |it: &Thing| coord.origin() + it.root.as_dvec3();
        let all = placed(field, coord).into_iter();
        all.map(move |it| (ChartPoint::new(chart, root(&it)), it))
    };
    coords.flat_map(on).collect()
}

/// Whichever of the five squares is asked, there is one stone, on the ground, and nothing else reaches it.
#[test]
fn five_squares_agree_on_one_stone_on_the_ground_that_stands_free() {
    let (mut corners, mut bare) = (0, 0);
    for world in worlds() {
        for seed in [3, 7] {
            let field = Field::new(seed, world.clone());
            let mut known = BTreeMap::new();
            for first in [0, 1, 40, 1 << 70].map(ChartId::new) {
                for corner in 0..4 {
                    let about = about_corner(&*world, first, corner);
                    let mut stones = Vec::new();
                    for at in about {
                        let place = place_of(&*world, at);
                        let here = known.entry(at.0);
                        let here = here.or_insert_with(|| on_square(&field, at.0));
                        for (root, thing) in here {
                            let away_m = root.pos.xz().distance(place.pos.xz());
                            if is_stone(thing) {
                                stones.extend((away_m < 1e-3).then_some((*root, thing.turn_rad)));
                                continue;
                            }
                            let species = Species::of_byte(thing.species).unwrap();
                            let age = Age::of_byte(thing.age).unwrap();
                            let crown_m = species.radius_m(age) * f64::from(thing.scale);
                            assert!(away_m > crown_m + 0.5, "{species:?} {away_m} m from {at:?}");
                        }
                    }
                    corners += 1;
                    assert!(stones.len() < 2, "{first} {corner}: {stones:?}");
                    let Some((root, _)) = stones.first() else {
                        bare += 1;
                        continue;
                    };
                    let [below, over] =
                        [-0.05, 0.05].map(|y| field.sample(root.moved(DVec3::Y * y)));
                    assert!(below < 0.0 && over >= 0.0, "{root:?}: {below} {over}");
                    let near: Vec<_> = placed_near(&field, *root, 0.5).collect();
                    assert_eq!(near.len(), 1, "who begins a world is told: {near:?}");
                }
            }
        }
    }
    println!("{corners} corners, {bare} without ground to stand on");
    assert!(bare * 20 < corners, "{bare} of {corners} are bare");
}

/// Measured in the space, the sign is even, and its rays point along the edges that meet.
#[test]
fn in_the_space_a_stone_has_five_even_sides_and_its_arrises_point_along_the_edges() {
    let world = &worlds()[1];
    let stone = shape(Species::CornerStone, Age::Grown, Size::Near);
    let shoulder = stone
        .corners
        .iter()
        .filter(|it| (it.place.y - 1.36).abs() < 1e-4);
    let shoulder: Vec<_> = shoulder.map(|it| it.place.as_dvec3()).collect();
    for corner in 0..4 {
        let root = place_of(&**world, (ChartId::FIRST, corner));
        let turn = DVec2::from_angle(f64::from(corner) * FRAC_PI_2);
        let in_space = |way: DVec2| {
            let way = DVec3::new(way.x, 0.0, way.y);
            world.in_frame(root, way).xz()
        };
        let edges = [DVec2::NEG_X, DVec2::NEG_Y].map(|edge| in_space(turn.rotate(edge)));
        let between = edges[0].angle_to(edges[1]).abs();
        assert!((between - TAU / 5.0).abs() < 1e-6, "{between}");
        let ways = shoulder.iter().map(|at| in_space(turn.rotate(at.xz())));
        let far_m = ways.clone().map(DVec2::length).fold(0.0, f64::max);
        let arrises: Vec<_> = ways.filter(|it| it.length() > 0.999 * far_m).collect();
        assert!((far_m - 0.28).abs() < 0.003, "{far_m} m");
        let mut met = [0; 5];
        for arris in arrises {
            let fifths = edges[0].angle_to(arris) / (TAU / 5.0);
            assert!((fifths - fifths.round()).abs() < 1e-3, "{corner}: {fifths}");
            met[fifths.round().rem_euclid(5.0) as usize] += 1;
        }
        assert!(met.iter().all(|count| *count > 0), "{corner}: {met:?}");
    }
}

/// The stones that line the edges of a square about one of its corners.
fn cobbles(field: &Field, (chart, corner): (ChartId, u8)) -> Vec<ChartPoint> {
    let at = place_of(&**field.strategy(), (chart, corner)).pos * (1.0 - 1e-6);
    let y = field.surface_height(chart, at.x, at.z);
    let middle = ChunkCoord::containing(ChartPoint::new(chart, at.with_y(y)));
    let on = |up: i32| {
        let index = middle.index + IVec3::Y * up;
        let coord = ChunkCoord { index, ..middle };
        let mesh = march(&field.samples(coord), field, coord);
        let tufts = undergrowth(field, coord, &mesh).into_iter();
        let cobbles = tufts.filter(|it| it.growth == Growth::Cobble.byte());
        cobbles.map(move |it| ChartPoint::new(chart, coord.origin() + it.root.as_dvec3()))
    };
    (-1..=1).flat_map(on).collect()
}

/// Two rows along each edge, one in each of the squares that share it: five ways lead from a corner.
#[test]
fn from_a_corner_five_ways_lead_along_the_edges_between_stones_of_both_squares() {
    for world in worlds() {
        let field = Field::new(12, world.clone());
        let about = about_corner(&*world, ChartId::FIRST, 0);
        let of_each: Vec<_> = about.into_iter().map(|at| cobbles(&field, at)).collect();
        let all: usize = of_each.iter().map(Vec::len).sum();
        let mut partners = 0;
        // Level metres grow with the height, and more so in a small world; stones of a row are twice as far apart.
        let most_m = 0.6 * (35.0 / world.curvature().radius_m).cosh();
        for (n, here) in of_each.iter().enumerate() {
            assert!(here.len() > 10, "{}", here.len());
            for at in here {
                let others = of_each.iter().enumerate().filter(|(m, _)| *m != n);
                let mut others = others.flat_map(|(_, there)| there);
                let is_across = |it: &ChartPoint| {
                    let away_m = world.distance_m(*at, *it, &Eye::default());
                    (0.3..most_m).contains(&away_m)
                };
                partners += usize::from(others.any(is_across));
            }
        }
        println!("{partners} of {all} have one across the edge");
        assert!(20 * partners >= 19 * all, "{partners} of {all}");
    }
}

#[test]
fn where_no_five_squares_meet_there_are_none() {
    let mut spaces: Vec<Arc<dyn antipode_geometry::Strategy>> = vec![Arc::new(TiledFlat)];
    for geometry in Geometry::ALL {
        if geometry != Geometry::HyperbolicWorld {
            spaces.push(strategy(geometry, 64.0));
        }
    }
    for space in spaces {
        let field = Field::new(7, space);
        let coords = (-4..4).flat_map(|x| (-4..4).map(move |z| (x, z)));
        let coords = coords.flat_map(|(x, z)| (-1..4).map(move |y| IVec3::new(x, y, z)));
        let all: Vec<_> = coords
            .flat_map(|index| placed(&field, ChunkCoord::new(ChartId::FIRST, index)))
            .collect();
        assert!(!all.is_empty() && !all.iter().any(is_stone));
    }
    let older = Field::made_by(Generator::Climates, 7, worlds()[1].clone());
    assert!(on_square(&older, ChartId::FIRST).is_empty());
}

/// The level is told by [`Tiled`]; where the world ends no five squares meet.
#[test]
fn at_the_end_of_the_world_corners_stand_bare_and_nothing_fails() {
    let world = &worlds()[1];
    let field = Field::new(7, world.clone());
    let last = ChartId::new(u128::MAX);
    assert!((0..4).any(|corner| about_corner(&**world, last, corner).is_empty()));
    assert!(world.edges_from_first(last).is_none_or(|edges| edges > 90));
    assert!(
        on_square(&field, last)
            .iter()
            .filter(|(_, it)| is_stone(it))
            .count()
            < 4
    );
}
