//! How far coarse surfaces lie from the full one: the table that levels are chosen by.

use std::sync::Arc;

use crate::common::{Random, flat};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{Biome, ChunkMesh, Field, Generator, Level, Mesher};
use glam::{DVec3, IVec3, Vec3};

/// Metres around a chunk in which nearest places are looked for.
const MARGIN: f32 = 8.0;
const COLUMNS: usize = 32 + 2 * MARGIN as usize;

type Triangle = [Vec3; 3];

/// Triangles by the square metres of a chunk's ground plan, and of the margin around it, that
/// they overlap.
struct Plan(Vec<Vec<Triangle>>);

fn columns(low: f32, high: f32) -> std::ops::RangeInclusive<usize> {
    let place = |c: f32| (c + MARGIN).max(0.0) as usize;
    place(low)..=place(high).min(COLUMNS - 1)
}

impl Plan {
    fn new() -> Self {
        Self(vec![Vec::new(); COLUMNS * COLUMNS])
    }

    fn add(&mut self, mesh: &ChunkMesh, offset_m: Vec3) {
        for t in mesh.triangles() {
            let corners = t.map(|n| mesh.vertices[n as usize].position() + offset_m);
            let low = corners.into_iter().reduce(Vec3::min).unwrap();
            let high = corners.into_iter().reduce(Vec3::max).unwrap();
            for x in columns(low.x, high.x) {
                for z in columns(low.z, high.z) {
                    self.0[x * COLUMNS + z].push(corners);
                }
            }
        }
    }

    fn around(&self, p: Vec3, reach_m: f32) -> impl Iterator<Item = &Triangle> {
        columns(p.x - reach_m, p.x + reach_m)
            .flat_map(move |x| columns(p.z - reach_m, p.z + reach_m).map(move |z| (x, z)))
            .flat_map(|(x, z)| self.0[x * COLUMNS + z].iter())
    }

    /// The distance from a point to the nearest triangle, and to the nearest over or under it;
    /// the margin where there is none.
    fn distances(&self, p: Vec3) -> [f32; 2] {
        let up = |t: &Triangle| height(t, p).map(|y| (y - p.y).abs());
        let upright = self.around(p, 0.0).filter_map(up).fold(MARGIN, f32::min);
        let mut nearest = upright;
        for reach_m in [0.0, 1.0, 3.0, MARGIN] {
            let found = self.around(p, reach_m).map(|t| distance(t, p));
            nearest = found.fold(nearest, f32::min);
            if nearest <= reach_m {
                break;
            }
        }
        [nearest, upright]
    }
}

/// The height of a triangle over the ground plan's point, if it is over it.
fn height(&[a, b, c]: &Triangle, p: Vec3) -> Option<f32> {
    let cross = |u: Vec3, v: Vec3| u.x * v.z - u.z * v.x;
    let whole = cross(b - a, c - a);
    let (s, t) = (cross(p - a, c - a) / whole, cross(b - a, p - a) / whole);
    let inside = s >= -1e-4 && t >= -1e-4 && s + t <= 1.0002;
    (whole.abs() > 1e-4 && inside).then_some(a.y + s * (b.y - a.y) + t * (c.y - a.y))
}

/// The distance from a point to a triangle: to its plane where the point is over it, or to the
/// nearest side.
fn distance(&[a, b, c]: &Triangle, p: Vec3) -> f32 {
    let normal = (b - a).cross(c - a);
    let outside =
        [(a, b), (b, c), (c, a)].map(|(p0, p1)| (p1 - p0).cross(p - p0).dot(normal) < 0.0);
    if outside == [false; 3] {
        return (p - a).dot(normal.normalize_or_zero()).abs();
    }
    let side = |(p0, p1): (Vec3, Vec3)| {
        let along = p1 - p0;
        let share = (p - p0).dot(along) / along.length_squared();
        p.distance(p0 + along * share.clamp(0.0, 1.0))
    };
    [(a, b), (b, c), (c, a)]
        .map(side)
        .into_iter()
        .fold(f32::MAX, f32::min)
}

/// Median, 99th percentile and maximum, metres.
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    median: f32,
    most: f32,
    max: f32,
}

impl Errors {
    fn of(mut distances: Vec<f32>) -> Self {
        distances.sort_by(f32::total_cmp);
        let share = |s: f64| distances[((distances.len() - 1) as f64 * s) as usize];
        Self {
            median: share(0.5),
            most: share(0.99),
            max: share(1.0),
        }
    }
}

/// How far the vertices of full surfaces are from a level's: nearest, and up or down.
fn measure(field: &Field, level: Level, chunks: usize, random: &mut Random) -> [Errors; 2] {
    let reach = field
        .strategy()
        .domain(ChartId::FIRST)
        .radius_m()
        .map_or(4000.0, |rim| rim * 0.6);
    let mut mesher = Mesher::default();
    let mut found = [Vec::new(), Vec::new()];
    for _ in 0..chunks {
        let [x, z] = [(); 2].map(|()| random.between(-reach, reach));
        let y = field.surface_height(ChartId::FIRST, x, z);
        let coord = ChunkCoord::containing(ChartPoint::a(DVec3::new(x, y, z)));
        let full = mesher.march(&field.samples(coord), field, coord);
        // A surface that leaves the chunk at one level only is in the next chunk at the other.
        let mut plan = Plan::new();
        for n in 0..27 {
            let step = IVec3::new(n % 3, n / 3 % 3, n / 9) - 1;
            let coord = ChunkCoord {
                index: coord.index + step,
                ..coord
            };
            let samples = field.samples_at(coord, level);
            plan.add(&mesher.march(&samples, field, coord), step.as_vec3() * 32.0);
        }
        for vertex in &full.vertices {
            let off = plan.distances(vertex.position());
            found[0].push(off[0]);
            found[1].push(off[1]);
        }
    }
    found.map(Errors::of)
}

fn spaces() -> Vec<(String, Arc<dyn Strategy>)> {
    let sphere = |radius: f64| {
        let name = format!("sphere of {radius} m");
        (name, strategy(Geometry::Spherical, radius))
    };
    let mut all = vec![("flat".to_owned(), flat())];
    all.extend([16.0, 32.0, 64.0, 128.0, 256.0].map(sphere));
    all
}

/// The table says no less than a few chunks show, and not much more.
#[test]
fn levels_are_off_by_what_the_table_says() {
    for seed in 0..5 {
        let field = Field::made_by(Generator::OneBiome, seed + 10, flat());
        assert_eq!(field.level_error_m(Level::FULL), 0.0);
        for level in &Level::ALL[1..] {
            let table = field.level_error_m(*level) as f32;
            let [near, _] = measure(&field, *level, 8, &mut Random(seed));
            let name = Biome::from_seed(seed + 10).name();
            assert!(
                near.most <= 1.1 * table,
                "{name} {level:?} {near:?} {table}"
            );
            assert!(
                near.most >= 0.6 * table,
                "{name} {level:?} {near:?} {table}"
            );
            assert!(
                near.median < 0.3 * table,
                "{name} {level:?} {near:?} {table}"
            );
        }
    }
}

#[test]
fn levels_of_spheres_are_off_by_no_more_than_the_table_says() {
    for (seed, radius_m) in [(0, 16.0), (1, 32.0), (2, 64.0), (3, 128.0), (4, 256.0)] {
        let field = Field::made_by(
            Generator::OneBiome,
            seed + 10,
            strategy(Geometry::Spherical, radius_m),
        );
        for level in &Level::ALL[1..] {
            let table = field.level_error_m(*level) as f32;
            let [near, _] = measure(&field, *level, 8, &mut Random(seed));
            let name = Biome::from_seed(seed + 10).name();
            assert!(
                near.most <= 1.1 * table,
                "{name} {radius_m} {near:?} {table}"
            );
            assert!(
                near.most >= 0.25 * table,
                "{name} {radius_m} {near:?} {table}"
            );
        }
    }
}

#[test]
fn levels_of_several_biomes_are_off_by_no_more_than_is_said() {
    for (name, space) in spaces() {
        for seed in [41, 44] {
            // Of caves whole cells may be lost.
            let field = Field::made_by(Generator::Climates, seed, space.clone()).without_caves();
            for level in &Level::ALL[1..] {
                let said = field.level_error_m(*level) as f32;
                let [near, _] = measure(&field, *level, 12, &mut Random(seed));
                assert!(near.most <= 1.1 * said, "{name} {seed} {near:?} {said}");
                assert!(near.most >= 0.05 * said, "{name} {seed} {near:?} {said}");
            }
        }
    }
}

#[test]
#[ignore = "prints what the table was made from; takes a minute"]
fn print_the_errors_of_every_biome_and_level() {
    for (name, space) in spaces() {
        for seed in 0..5 {
            for level in &Level::ALL[1..] {
                // Fields of several seeds: biomes repeat after five.
                let mut random = Random(seed);
                let field = Field::made_by(Generator::OneBiome, seed + 10, space.clone());
                let [near, up] = measure(&field, *level, 40, &mut random);
                let biome = Biome::from_seed(seed).name();
                println!(
                    "{name} {biome} {} m: nearest {:.3} {:.3} {:.3}, upright {:.3} {:.3} {:.3}",
                    level.step_m(),
                    near.median,
                    near.most,
                    near.max,
                    up.median,
                    up.most,
                    up.max,
                );
            }
        }
    }
}
