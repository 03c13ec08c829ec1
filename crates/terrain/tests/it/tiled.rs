//! Land in charts without number is the land of one chart: the same samples, the same strokes, the same surface.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Strategy};
use antipode_terrain::{Content, EDIT_STEP, Field, RIM_REACH_M, Stroke, march};
use antipode_testing::tiled::{TILE_M, TiledFlat};
use glam::{DVec2, DVec3, I64Vec2, IVec3};

use crate::common::{Random, World, chunk, flat};

fn tiled() -> Arc<dyn Strategy> {
    Arc::new(TiledFlat)
}

/// A chart of each turn.
fn charts() -> [ChartId; 4] {
    [0, 1, 2, 3].map(|turns| {
        let mut all = (0..400).map(|n| TiledFlat::chart(I64Vec2::new(n - 200, 3 * n - 61)));
        let has = |chart: &ChartId| TiledFlat::frame(*chart).quarter_turns == turns;
        all.find(has).expect("a chart of each turn")
    })
}

/// The samples that a chunk owns, by their places in it.
fn cells() -> impl Iterator<Item = (usize, usize, usize)> {
    (0..32 * 32 * 32).map(|n| (n / 1024, n / 32 % 32, n % 32))
}

/// Whether meshes of a point's chart may look at it: near its domain.
fn is_looked_at(point: ChartPoint) -> bool {
    let at = DVec2::new(point.pos.x, point.pos.z);
    TiledFlat.domain(point.chart).outside_m(at) <= RIM_REACH_M
}

/// The chunks of a chart that reach into its domain, between two layers.
fn chunks(chart: ChartId, layers: std::ops::RangeInclusive<i32>) -> Vec<ChunkCoord> {
    let side = (0.5 * TILE_M) as i32 / CHUNK_CELLS;
    let columns = (-side..side).flat_map(|x| (-side..side).map(move |z| (x, z)));
    columns
        .flat_map(|(x, z)| layers.clone().map(move |y| chunk(chart, x, y, z)))
        .collect()
}

#[test]
fn samples_are_those_of_one_chart_bit_for_bit() {
    let (one, many) = (Field::new(3, flat()), Field::new(3, tiled()));
    let mut solid = [0; 2];
    for chart in charts() {
        for coord in chunks(chart, 0..=1) {
            let samples = many.samples(coord);
            let mut random = Random(7);
            for _ in 0..600 {
                let [i, j, k] = [(); 3].map(|()| (random.unit() * 34.0) as usize);
                let local = DVec3::new(i as f64, j as f64, k as f64) - 1.0;
                let point = ChartPoint::new(chart, coord.origin() + local);
                let expected = one.sample(ChartPoint::a(TiledFlat::common(point)));
                assert_eq!(samples.get(i, j, k), expected, "{point:?}");
                assert_eq!(many.sample(point), expected, "{point:?}");
                solid[usize::from(expected < 0.0)] += 1;
            }
        }
    }
    assert!(solid.iter().all(|count| *count > 1000), "{solid:?}");
}

#[test]
fn what_a_chunk_holds_is_what_its_samples_say() {
    let many = Field::new(5, tiled());
    let mut found = [0; 3];
    for chart in charts() {
        for coord in chunks(chart, -3..=3) {
            let samples = many.samples(coord);
            let all = |solid: bool| samples.values().iter().all(|value| (*value < 0.0) == solid);
            let content = many.content(coord);
            match content {
                Content::Air => assert!(all(false), "{coord:?}"),
                Content::Solid => assert!(all(true), "{coord:?}"),
                Content::Surface => {}
            }
            found[content as usize] += 1;
        }
    }
    assert!(found.iter().all(|count| *count > 0), "{found:?}");
}

/// Strokes on an edge, at a corner where four squares meet, and within a square.
fn strokes() -> Vec<Stroke> {
    let edge_m = 0.5 * TILE_M;
    let places = [
        DVec3::new(edge_m, 6.0, 3.3),
        DVec3::new(edge_m - 1.2, 7.5, edge_m + 0.4),
        DVec3::new(-edge_m + 3.0, 5.0, -edge_m - 2.5),
        DVec3::new(edge_m + TILE_M, 5.5, 2.0 * TILE_M + edge_m),
        DVec3::new(4.0, 6.0, -9.0),
    ];
    let radii = [4.0, 6.0, 9.0, 5.0, 10.0];
    let stroke = |(at, radius_m): (DVec3, f64)| Stroke {
        centre: TiledFlat::at(at),
        radius_m,
        amount: if radius_m > 5.0 { 2.0 } else { -1.5 },
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    };
    places.into_iter().zip(radii).map(stroke).collect()
}

fn in_one_chart(stroke: &Stroke) -> Stroke {
    Stroke {
        centre: ChartPoint::a(TiledFlat::common(stroke.centre)),
        ..*stroke
    }
}

#[test]
fn a_stroke_over_edges_and_corners_changes_what_it_changes_in_one_chart() {
    let (mut one, mut many) = (World::new(3, flat()), World::new(3, tiled()));
    for stroke in strokes() {
        many.apply(&stroke);
        one.apply(&in_one_chart(&stroke));
    }
    let touched: Vec<ChunkCoord> = many.edits.keys().copied().collect();
    let mut changed = 0;
    for coord in touched {
        for (i, j, k) in cells() {
            let local = DVec3::new(i as f64, j as f64, k as f64);
            let point = ChartPoint::new(coord.chart, coord.origin() + local);
            if !is_looked_at(point) {
                continue;
            }
            let common = TiledFlat::common(point);
            let index = common.as_ivec3();
            let owner = index.div_euclid(IVec3::splat(32));
            let at = index - owner * 32;
            let here = many.edits[&coord].delta(i, j, k);
            let there = one.edits.get(&ChunkCoord::new(ChartId::FIRST, owner));
            let there = there.map_or(0.0, |it| {
                it.delta(at.x as usize, at.y as usize, at.z as usize)
            });
            assert!(
                (here - there).abs() <= EDIT_STEP,
                "{coord:?} {common} {here} {there}"
            );
            changed += usize::from(here != 0.0);
        }
    }
    assert!(changed > 10_000, "{changed}");
}

/// Every chart whose land an edit may change is told of it: none is left as it was on one side of an edge.
#[test]
fn each_sample_is_changed_in_every_chart_that_has_it() {
    let mut many = World::new(3, tiled());
    for stroke in strokes() {
        many.apply(&stroke);
    }
    let delta = |point: ChartPoint| {
        let coord = ChunkCoord::containing(point);
        let at = point.pos - coord.origin();
        let edits = many.edits.get(&coord);
        edits.map_or(0.0, |it| {
            it.delta(at.x as usize, at.y as usize, at.z as usize)
        })
    };
    let mut shared = 0;
    for (coord, edits) in &many.edits {
        for (i, j, k) in cells() {
            let local = DVec3::new(i as f64, j as f64, k as f64);
            let point = ChartPoint::new(coord.chart, coord.origin() + local);
            for image in TiledFlat.images(point, RIM_REACH_M) {
                if !is_looked_at(point) {
                    continue;
                }
                let apart = edits.delta(i, j, k) - delta(image.point);
                assert!(apart.abs() <= EDIT_STEP, "{point:?} {apart}");
                shared += usize::from(edits.delta(i, j, k) != 0.0);
            }
        }
    }
    assert!(shared > 2000, "{shared}");
}

/// Vertices of the surface within a few metres of a place of flat space, to a 2048th of a metre.
fn surface(world: &mut World, place: DVec3, coords: &[ChunkCoord]) -> HashMap<IVec3, DVec3> {
    let mut found = HashMap::new();
    for &coord in coords {
        let samples = world.samples(coord);
        let mesh = march(&samples, &world.field, coord);
        for vertex in &mesh.vertices {
            let local = vertex.position().as_dvec3();
            let point = ChartPoint::new(coord.chart, coord.origin() + local);
            let common = TiledFlat::common(point);
            if common.distance(place) < 8.0 {
                found.insert((common * 2048.0).round().as_ivec3(), common);
            }
        }
    }
    found
}

/// Whether each of some vertices is among others, to half a millimetre.
fn holds(others: &HashMap<IVec3, DVec3>, vertices: &HashMap<IVec3, DVec3>) -> bool {
    let around = |key: IVec3| {
        let steps = (-1..=1).flat_map(|x| (-1..=1).map(move |y| (x, y)));
        steps.flat_map(move |(x, y)| (-1..=1).map(move |z| key + IVec3::new(x, y, z)))
    };
    vertices.iter().all(|(key, at)| {
        let mut near = around(*key).filter_map(|key| others.get(&key));
        near.any(|other| other.distance(*at) < 5e-4)
    })
}

#[test]
fn the_surface_over_an_edge_and_a_corner_is_that_of_one_chart() {
    let edge_m = 0.5 * TILE_M;
    for (x, z) in [(edge_m, 3.0), (edge_m, edge_m), (-edge_m, edge_m + TILE_M)] {
        let (mut one, mut many) = (World::new(3, flat()), World::new(3, tiled()));
        let height_m = one.field.surface_height(ChartId::FIRST, x, z);
        let place = DVec3::new(x, height_m, z);
        let stroke = Stroke {
            centre: TiledFlat::at(place),
            radius_m: 4.0,
            amount: 1.0,
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        };
        many.apply(&stroke);
        one.apply(&in_one_chart(&stroke));
        let near = |point: ChartPoint| {
            let low = ChunkCoord::containing(point.moved(DVec3::splat(-9.0))).index;
            let high = ChunkCoord::containing(point.moved(DVec3::splat(9.0))).index;
            let layers = (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| (x, y)));
            let all =
                layers.flat_map(move |(x, y)| (low.z..=high.z).map(move |z| IVec3::new(x, y, z)));
            all.map(|index| ChunkCoord::new(point.chart, index))
                .collect::<Vec<_>>()
        };
        let whole = surface(&mut one, place, &near(ChartPoint::a(place)));
        let at = TiledFlat::at(place);
        let images = TiledFlat.images(at, 8.0);
        let mut parts = HashMap::new();
        for point in std::iter::once(at).chain(images.iter().map(|it| it.point)) {
            let part = surface(&mut many, place, &near(point));
            let domain = TiledFlat.domain(point.chart);
            let own = part.into_iter().filter(|(_, common)| {
                let local = TiledFlat::frame(point.chart).taken(*common);
                domain.outside_m(DVec2::new(local.x, local.z)) <= 1e-3
            });
            parts.extend(own);
        }
        assert!(whole.len() > 100, "{}", whole.len());
        assert!(holds(&whole, &parts) && holds(&parts, &whole), "{place}");
    }
}
