//! How long a field sample, a chunk's samples, its mesh and a stroke take.

use std::hint::black_box;

use antipode_geometry::{
    ChartId, ChartPoint, ChunkCoord, DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M,
    Geometry, strategy,
};
use antipode_terrain::{ChunkEdits, Field, Generator, Level, SAMPLES, Stroke, march};
use divan::Bencher;
use divan::counter::ItemsCount;
use glam::{DVec3, IVec3};

type World = (Generator, Geometry);

const WORLDS: [World; 4] = [
    (Generator::OneBiome, Geometry::Euclidean),
    (Generator::OneBiome, Geometry::Spherical),
    (Generator::Climates, Geometry::Euclidean),
    (Generator::Climates, Geometry::Spherical),
];

fn main() {
    divan::main();
}

/// A world of one biome, volcanic, of four octaves, or of several.
fn field((generator, geometry): World) -> Field {
    let radius_m = match geometry {
        Geometry::Spherical => DEFAULT_SPHERE_RADIUS_M,
        _ => DEFAULT_HYPERBOLIC_RADIUS_M,
    };
    Field::made_by(generator, 20, strategy(geometry, radius_m))
}

fn chunk() -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::ZERO,
    }
}

#[divan::bench(args = WORLDS)]
fn sample(bencher: Bencher<'_, '_>, world: World) {
    let field = field(world);
    let point = ChartPoint::a(DVec3::new(3.7, 9.1, -20.4));
    bencher.bench_local(|| field.sample(black_box(point)));
}

/// Chunks under, in and over the ground of a volcanic world.
#[divan::bench(args = [-1, 0, 1, 2], consts = [1, 2])]
fn content<const GENERATOR: u16>(bencher: Bencher<'_, '_>, layer: i32) {
    let generator = Generator::of_number(GENERATOR).unwrap_or_default();
    let field = field((generator, Geometry::Euclidean));
    let coord = ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(0, layer, 0),
    };
    bencher.bench_local(|| field.content(black_box(coord)));
}

#[divan::bench(args = WORLDS)]
fn chunk_samples(bencher: Bencher<'_, '_>, world: World) {
    let field = field(world);
    bencher
        .counter(ItemsCount::new(SAMPLES.pow(3)))
        .bench_local(|| field.samples(black_box(chunk())));
}

#[divan::bench(args = WORLDS, consts = [1, 2, 3])]
fn level_samples<const LEVEL: usize>(bencher: Bencher<'_, '_>, world: World) {
    let field = field(world);
    bencher.bench_local(|| field.samples_at(black_box(chunk()), Level::ALL[LEVEL]));
}

#[divan::bench(args = WORLDS)]
fn chunk_mesh(bencher: Bencher<'_, '_>, world: World) {
    let field = field(world);
    let samples = field.samples(chunk());
    bencher.bench_local(|| march(black_box(&samples), &field, chunk()));
}

/// A chunk below the surface with much of a cave in it.
fn cave(geometry: Geometry) -> (Field, ChunkCoord) {
    let field = field((Generator::Climates, geometry));
    let chunks = (0..4000).map(|n| ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(n % 32 - 16, n / 1024 - 1, n / 32 % 32 - 16),
    });
    let hollow = |coord: &ChunkCoord| {
        let deep = coord.origin() + DVec3::splat(16.0);
        if field.land(ChartPoint::a(deep)) > -6.0 {
            return 0;
        }
        let samples = field.samples(*coord);
        samples.values().iter().filter(|it| **it > 0.0).count()
    };
    let most = chunks.max_by_key(hollow).unwrap_or(chunk());
    (field, most)
}

#[divan::bench(args = [Geometry::Euclidean, Geometry::Spherical])]
fn cave_samples(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (field, coord) = cave(geometry);
    bencher
        .counter(ItemsCount::new(SAMPLES.pow(3)))
        .bench_local(|| field.samples(black_box(coord)));
}

#[divan::bench(args = [Geometry::Euclidean, Geometry::Spherical])]
fn cave_mesh(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (field, coord) = cave(geometry);
    let samples = field.samples(coord);
    bencher.bench_local(|| march(black_box(&samples), &field, coord));
}

#[divan::bench(args = [Geometry::Euclidean, Geometry::Spherical])]
fn cave_content(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (field, coord) = cave(geometry);
    bencher.bench_local(|| field.content(black_box(coord)));
}

#[divan::bench(args = [1.0, 5.0, 10.0])]
fn stroke_into_a_chunk(bencher: Bencher<'_, '_>, radius_m: f64) {
    let strategy = strategy(Geometry::Spherical, DEFAULT_SPHERE_RADIUS_M);
    let stroke = Stroke {
        centre: ChartPoint::a(DVec3::new(14.0, 12.0, 15.0)),
        radius_m,
        amount: 0.05,
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    };
    let mut edits = ChunkEdits::new();
    bencher.bench_local(|| stroke.apply(chunk(), &mut edits, &*strategy));
}
