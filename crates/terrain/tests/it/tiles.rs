//! Land of the hyperbolic world, which is made tile by tile: of one piece, like flat land, and with all that land has.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use antipode_geometry::tiling::{Frame, rings};
use antipode_geometry::{Atlas, ChartId, ChartPoint, Euclidean, HyperbolicWorld, Metric};
use antipode_terrain::{Content, Field, Generator, Level, march};
use glam::DVec3;

use crate::common::{chunk, flat};

fn world(n: usize) -> Arc<HyperbolicWorld> {
    Arc::new(HyperbolicWorld::new(HyperbolicWorld::RADII_M[n]))
}

/// Charts, nearest to the root first.
fn charts(count: usize) -> Vec<ChartId> {
    let near = rings(&Frame::ROOT, 8, 8000).unwrap();
    let number = |frame: &Frame| ChartId::new(frame.path().unwrap().number());
    near.iter().flatten().map(number).take(count).collect()
}

/// Half the width of a tile, metres.
fn half_m(n: usize) -> f64 {
    [16.0, 32.0, 64.0][n]
}

/// A point, and the same in the other charts that share it; there, too, it lies at quarters of a metre.
fn shared(world: &HyperbolicWorld, point: ChartPoint) -> Vec<ChartPoint> {
    let images = world.images(point, 1e-6).into_iter().map(|it| {
        let pos = (it.point.pos * 4.0).round() / 4.0;
        ChartPoint::new(it.point.chart, pos)
    });
    std::iter::once(point).chain(images).collect()
}

#[test]
fn land_caves_climates_and_colours_are_one_in_all_charts_that_share_a_place() {
    for n in 0..3 {
        let (world, half) = (world(n), half_m(n));
        for seed in [3, 4] {
            let field = Field::new(seed, world.clone());
            let (mut solid, mut asked) = (0, 0);
            for (k, chart) in charts(40).into_iter().enumerate() {
                let along = (3 * k) as f64 % half;
                for [x, z] in [[half, along], [-along, half], [-half, -along], [half, half]] {
                    for y in [-20.0, 10.0, 40.0, 48.0, 56.0, 64.0] {
                        let point = ChartPoint::new(chart, DVec3::new(x, y, z));
                        let first = field.sample(point);
                        for other in shared(&world, point) {
                            assert_eq!(field.sample(other), first, "{point:?} {other:?}");
                            assert_eq!(field.land(other), field.land(point));
                            assert_eq!(field.is_cave(other), field.is_cave(point));
                            let biomes = [point, other].map(|it| field.biome_at(it).name());
                            assert_eq!(biomes[0], biomes[1]);
                            assert_eq!(field.ground_colours(other), field.ground_colours(point));
                            asked += 1;
                        }
                        solid += usize::from(first < 0.0);
                    }
                }
            }
            assert!(asked > 2000 && solid > 100, "{asked} {solid}");
        }
    }
}

#[test]
fn grids_hold_what_single_samples_do_and_past_the_edge_what_the_next_tile_has() {
    let default = Generator::default();
    for (generator, seed, n) in [
        (Generator::OneBiome, 5, 1),
        (default, 5, 1),
        (default, 6, 0),
        (default, 7, 0),
    ] {
        let (field, half) = (Field::made_by(generator, seed, world(n)), half_m(n));
        for chart in charts(if n == 0 { 6 } else { 3 }) {
            for (level, [x, y]) in [
                (Level::FULL, [0, 1]),
                (Level::FULL, [-1, 0]),
                (Level::ALL[2], [0, 1]),
            ] {
                let coord = chunk(chart, x, y, -1);
                let samples = field.samples_at(coord, level);
                let (side, step) = (samples.side(), f64::from(level.step_m()));
                for n in 0..side * side * side {
                    let [i, j, k] = [n / side / side, n / side % side, n % side];
                    let local = (DVec3::new(i as f64, j as f64, k as f64) - 1.0) * step;
                    let point = ChartPoint::new(chart, coord.origin() + local);
                    assert_eq!(samples.get(i, j, k), field.sample(point), "{point:?}");
                    // No chart is written farther out.
                    let is_written = point.pos.abs().with_y(0.0).max_element() <= 1.4 * half;
                    if n % 131 == 0
                        && is_written
                        && let Some(other) = field.strategy().cross(point)
                    {
                        let off = field.sample(other.point) - samples.get(i, j, k);
                        assert!(off.abs() < 1e-4, "{point:?} {other:?} {off}");
                    }
                }
            }
        }
    }
}

/// The share of each biome among places of tiles.
fn shares(field: &Field, places: impl Iterator<Item = ChartPoint>) -> BTreeMap<&'static str, f64> {
    let mut counts = BTreeMap::new();
    let mut all = 0.0;
    for place in places {
        *counts.entry(field.biome_at(place).name()).or_insert(0.0) += 1.0;
        all += 1.0;
    }
    for count in counts.values_mut() {
        *count /= all;
    }
    counts
}

#[test]
fn there_are_all_biomes_and_about_as_much_of_each_as_in_flat_worlds() {
    let (mut tiled, mut plain): (BTreeMap<_, f64>, BTreeMap<_, f64>) = Default::default();
    let charts = charts(2000);
    for seed in 100..104 {
        let field = Field::new(seed, world(1));
        let places = charts
            .iter()
            .map(|chart| ChartPoint::new(*chart, DVec3::ZERO));
        for (name, share) in shares(&field, places) {
            *tiled.entry(name).or_default() += share / 4.0;
        }
        let field = Field::new(seed, flat());
        let place = |n: u32| DVec3::new(f64::from(n % 70), 0.0, f64::from(n / 70)) * 97.0;
        let places = (0..4900).map(|n| ChartPoint::a(place(n)));
        for (name, share) in shares(&field, places) {
            *plain.entry(name).or_default() += share / 4.0;
        }
    }
    println!("{tiled:.3?}\n{plain:.3?}");
    assert!(plain.len() >= 9);
    for (name, share) in plain {
        let here = tiled.get(name).copied().unwrap_or(0.0);
        assert!(
            (0.5..2.0).contains(&(here / share)),
            "{name}: {here} {share}"
        );
    }
}

/// The root mean square of the slopes at points, in metres of the space both ways, and the standard deviation of heights.
fn relief<S: Metric>(field: &Field, space: &S, points: &[ChartPoint]) -> [f64; 2] {
    const STEP_M: f64 = 1.0;
    let height = |chart, at: DVec3| field.surface_height(chart, at.x, at.z);
    let (mut slopes, mut squares, mut sum) = (0.0, 0.0, 0.0);
    for point in points {
        let here = height(point.chart, point.pos);
        for way in [DVec3::X, DVec3::Z] {
            let step = space.in_chart(*point, way * STEP_M);
            slopes += (height(point.chart, point.pos - step) - here).powi(2);
        }
        squares += here * here;
        sum += here;
    }
    let count = points.len() as f64;
    let mean = sum / count;
    [
        (slopes / count).sqrt() / STEP_M,
        (squares / count - mean * mean).sqrt(),
    ]
}

#[test]
fn hills_are_as_high_and_as_steep_as_flat_ones_all_over_a_tile() {
    let (world, half) = (world(1), half_m(1));
    let charts = charts(160);
    let field = Field::new(7, world.clone()).without_caves();
    let kinds = [
        [0.0, 0.0],
        [half, 0.0],
        [half, half],
        [0.6 * half, 0.5 * half],
    ];
    let found = kinds.map(|[x, z]| {
        let at = |chart: &ChartId| ChartPoint::new(*chart, DVec3::new(x, 0.0, z));
        let points: Vec<_> = charts.iter().map(at).collect();
        relief(&field, &*world, &points)
    });
    let plain = Field::new(7, flat()).without_caves();
    let place = |n: u32| DVec3::new(f64::from(n % 16), 0.0, f64::from(n / 16)) * 370.0;
    let points: Vec<_> = (0..256).map(|n| ChartPoint::a(place(n))).collect();
    let flat = relief(&plain, &Euclidean, &points);
    println!("{found:.3?}, flat {flat:.3?}");
    for [slope, height] in found {
        assert!(
            (0.7..1.6).contains(&(slope / flat[0])),
            "{found:?} {flat:?}"
        );
        assert!(
            (0.6..1.6).contains(&(height / flat[1])),
            "{found:?} {flat:?}"
        );
        assert!((0.75..1.35).contains(&(slope / found[0][0])), "{found:?}");
    }
}

#[test]
#[ignore = "prints times"]
fn print_times() {
    let fields = [
        Field::new(7, flat()),
        Field::new(7, world(1)),
        Field::new(7, world(0)),
    ];
    let bare: Vec<_> = fields.iter().map(Field::without_caves).collect();
    for (n, field) in fields.iter().chain(&bare).enumerate() {
        let n = n % 3;
        let charts = if n == 0 {
            vec![ChartId::FIRST]
        } else {
            charts(60)
        };
        let mut coords = Vec::new();
        for (k, chart) in charts.iter().enumerate() {
            let spread = if n == 0 { 60 } else { 1 };
            for m in 0..spread {
                for y in 0..3 {
                    let x = if n == 0 {
                        m * 3
                    } else if n == 1 {
                        -((k % 2) as i32)
                    } else {
                        0
                    };
                    coords.push(chunk(*chart, x, y, 0));
                }
            }
        }
        coords.retain(|coord| field.content(*coord) == Content::Surface);
        let sampled: Vec<_> = coords.iter().map(|coord| field.samples(*coord)).collect();
        let has = |at: usize| {
            let values = sampled[at].values();
            values.iter().any(|it| *it < 0.0) && values.iter().any(|it| *it > 0.0)
        };
        let with: Vec<_> = (0..coords.len()).filter(|at| has(*at)).collect();
        let mut best = [
            vec![f64::INFINITY; with.len()],
            vec![f64::INFINITY; with.len()],
        ];
        for _ in 0..7 {
            for (m, at) in with.iter().enumerate() {
                let start = Instant::now();
                let samples = field.samples(coords[*at]);
                best[0][m] = best[0][m].min(start.elapsed().as_secs_f64());
                let mesh = march(&samples, field, coords[*at]);
                best[1][m] = best[1][m].min(start.elapsed().as_secs_f64());
                assert!(mesh.vertices.len() < 1_000_000);
            }
        }
        let middle = |all: &[f64]| {
            let mut all = all.to_vec();
            all.sort_by(f64::total_cmp);
            [all[all.len() / 4], all[all.len() / 2], all[all.len() - 1]]
        };
        let [samples, meshes] = best.map(|all| middle(&all).map(|it| it * 1e3));
        println!(
            "{n}: {} of {} chunks; samples {samples:.3?} ms, chunk {meshes:.3?} ms",
            with.len(),
            coords.len()
        );
    }
}

#[test]
fn there_are_caves_with_ways_in() {
    let field = Field::new(9, world(1));
    let (mut hollow, mut columns) = (0, 0);
    for chart in charts(60) {
        for n in 0..64 {
            let (x, z) = (f64::from(n % 8) * 8.0 - 28.0, f64::from(n / 8) * 8.0 - 28.0);
            let top = field.without_caves().surface_height(chart, x, z);
            let at = |below: i32| ChartPoint::new(chart, DVec3::new(x, top - f64::from(below), z));
            hollow += usize::from((4..40).any(|below| field.is_cave(at(below))));
            columns += 1;
        }
    }
    let share = hollow as f64 / f64::from(columns);
    println!("caves below {share:.3} of the land");
    assert!((0.01..0.2).contains(&share), "{share}");
}
