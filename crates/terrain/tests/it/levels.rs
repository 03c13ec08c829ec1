//! Levels of detail: the same samples where they meet, and one closed surface whatever levels
//! stand side by side.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use crate::common::{Random, World, chunk, flat, sphere};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{ChunkMesh, Level, Mesher, RIM_REACH_M, Samples, Stroke};
use glam::{DVec3, I64Vec3, IVec3};

/// Units of position along an edge of a chunk.
const CHUNK: i64 = 1 << 20;

/// Chunks and their meshes, at levels of which face neighbours differ by one at most.
struct Block {
    first: IVec3,
    size: i32,
    meshes: BTreeMap<[i32; 3], ChunkMesh>,
}

fn steps() -> impl Iterator<Item = (usize, IVec3)> {
    let axes = [IVec3::X, IVec3::Y, IVec3::Z];
    (0..6).map(move |face| (face, axes[face / 2] * (2 * (face % 2) as i32 - 1)))
}

/// Random levels, lowered until no face has more than one step across it.
fn random_levels(size: i32, random: &mut Random) -> BTreeMap<[i32; 3], usize> {
    let mut levels = BTreeMap::new();
    for n in 0..size.pow(3) {
        let at = [n % size, n / size % size, n / size / size];
        levels.insert(at, random.between(0.0, 4.0) as usize);
    }
    for _ in 0..4 {
        let before = levels.clone();
        for (&at, level) in &mut levels {
            for (_, step) in steps() {
                let beside = (IVec3::from(at) + step).to_array();
                *level = (*level).min(before.get(&beside).map_or(3, |other| other + 1));
            }
        }
    }
    levels
}

impl Block {
    fn new(
        first: IVec3,
        levels: &BTreeMap<[i32; 3], usize>,
        mut mesh: impl FnMut(IVec3, Level) -> ChunkMesh,
    ) -> Self {
        let meshes = levels
            .iter()
            .map(|(&at, &level)| (at, mesh(first + IVec3::from(at), Level::ALL[level])))
            .collect();
        let size = levels.keys().map(|at| at[0] + 1).max().unwrap_or_default();
        Self {
            first,
            size,
            meshes,
        }
    }

    /// All that is drawn: surfaces, and seams where the neighbour is finer. Corners in units from
    /// the chart's origin.
    fn triangles(&self) -> Vec<[I64Vec3; 3]> {
        let mut all = Vec::new();
        for (&at, mesh) in &self.meshes {
            let origin = (self.first + IVec3::from(at)).as_i64vec3() * CHUNK;
            let mut add = |indices: &[u32]| {
                for t in indices.as_chunks::<3>().0 {
                    let corner = |n: u32| mesh.vertices[n as usize].place().map(i64::from);
                    all.push(t.map(|n| origin + I64Vec3::from(corner(n))));
                }
            };
            add(mesh.surface_indices());
            for (face, step) in steps() {
                let beside = self.meshes.get(&(IVec3::from(at) + step).to_array());
                if beside.is_some_and(|other| other.level < mesh.level) {
                    add(mesh.seam_indices(face));
                }
            }
        }
        all
    }

    /// Asserts that every edge runs as often one way as the other, but for edges in the faces of
    /// the whole block and beyond the reach. Gives the number of edges.
    fn assert_watertight(&self, reach_m: f64) -> usize {
        let mut balance: HashMap<(I64Vec3, I64Vec3), i32> = HashMap::new();
        for t in self.triangles() {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                assert_ne!(a, b, "a triangle that is none");
                let forward = a.to_array() < b.to_array();
                let key = if forward { (a, b) } else { (b, a) };
                *balance.entry(key).or_default() += if forward { 1 } else { -1 };
            }
        }
        let low = self.first.as_i64vec3() * CHUNK;
        let high = low + i64::from(self.size) * CHUNK;
        let far = |p: I64Vec3| (p.x as f64).hypot(p.z as f64) > reach_m * 32768.0;
        for (&(a, b), &count) in &balance {
            let outer = (0..3).any(|n| a[n] == b[n] && (a[n] == low[n] || a[n] == high[n]));
            if !outer && !far(a) && !far(b) {
                assert_eq!(count, 0, "{a} {b} from {low}");
            }
        }
        balance.len()
    }
}

/// Digs tunnels along axes through faces, edges and corners of a block's chunks, and builds.
fn tunnel(world: &mut World, chart: ChartId, first: IVec3, size: i32, random: &mut Random) {
    for n in 0..8 {
        let side = f64::from(size) * 32.0;
        // On a plane between chunks, on two of them, or anywhere.
        let mut at = [(); 3].map(|()| random.between(0.0, side));
        for place in at.iter_mut().take(n % 4) {
            *place = (*place / 32.0).round() * 32.0 + random.between(-0.5, 0.5);
        }
        let along = n / 2 % 3;
        let (radius_m, amount) = (random.between(2.0, 6.0), random.between(-6.0, 9.0) as f32);
        for step in 0..16 {
            at[along] = side * f64::from(step) / 16.0;
            world.apply(&Stroke {
                centre: ChartPoint::new(chart, first.as_dvec3() * 32.0 + DVec3::from(at)),
                radius_m,
                amount,
                part: antipode_terrain::Part::Whole,
                kind: None,
                shape: antipode_terrain::Shape::Ball,
                power: None,
            });
        }
    }
}

fn edited_blocks_are_watertight(space: &Arc<dyn Strategy>, seed: u64, first: IVec3, size: i32) {
    let mut random = Random(seed * 77 + 5);
    let chart = ChartId::FIRST;
    let mut world = World::new(seed, Arc::clone(space));
    let mut mesher = Mesher::default();
    let reach_m = space
        .domain(ChartId::FIRST)
        .radius_m()
        .map_or(f64::INFINITY, |rim_m| rim_m + RIM_REACH_M);
    let mut edges = 0;
    for edited in [false, true] {
        if edited {
            tunnel(&mut world, chart, first, size, &mut random);
        }
        for _ in 0..3 {
            let levels = random_levels(size, &mut random);
            let block = Block::new(first, &levels, |index, level| {
                let coord = ChunkCoord { chart, index };
                let samples = world.samples_at(coord, level);
                mesher.march(&samples, &world.field, coord)
            });
            edges += block.assert_watertight(reach_m);
        }
    }
    assert!(edges > 20_000, "only {edges} edges");
}

#[test]
fn flat_ground_of_every_biome_and_mix_of_levels_is_watertight() {
    for seed in 10..15 {
        edited_blocks_are_watertight(&flat(), seed, IVec3::new(-2, -1, 7), 3);
    }
}

#[test]
fn round_ground_of_any_mix_of_levels_is_watertight() {
    edited_blocks_are_watertight(&sphere(), 3, IVec3::new(-2, -1, -1), 3);
}

#[test]
fn hyperbolic_ground_of_any_mix_of_levels_is_watertight() {
    let space = strategy(Geometry::Hyperbolic, 40.0);
    edited_blocks_are_watertight(&space, 4, IVec3::new(5, -1, -3), 4);
}

/// No triangle of a surface is empty, at any level, and but for slivers all face the air that
/// their corners' normals point to.
#[test]
fn coarse_ground_has_no_empty_triangles_and_faces_the_air() {
    for (seed, space) in [(11, flat()), (13, flat()), (14, sphere())] {
        let mut world = World::new(seed, space);
        let first = IVec3::new(-1, 0, -1);
        tunnel(&mut world, ChartId::FIRST, first, 2, &mut Random(seed));
        for level in Level::ALL {
            let (mut area, mut wrong) = (0.0, 0.0);
            for n in 0..8 {
                let index = first + IVec3::new(n % 2, n / 2 % 2, n / 4);
                let coord = chunk(ChartId::FIRST, index.x, index.y, index.z);
                let samples = world.samples_at(coord, level);
                let mesh = antipode_terrain::march(&samples, &world.field, coord);
                assert_eq!(mesh.level, level);
                for &t in mesh.triangles() {
                    let corners = t.map(|n| mesh.vertices[n as usize]);
                    let [a, b, c] = corners.map(|v| I64Vec3::from(v.place().map(i64::from)));
                    let face = (b - a).cross(c - a);
                    assert_ne!(face, I64Vec3::ZERO, "{a} {b} {c}");
                    let face = face.as_dvec3();
                    let smooth = corners.iter().map(|v| v.normal().as_dvec3()).sum::<DVec3>();
                    area += face.length();
                    if face.dot(smooth) <= 0.0 {
                        wrong += face.length();
                    }
                }
            }
            assert!(
                area > 1e12 && wrong < 0.01 * area,
                "{seed} {level:?} {wrong} {area}"
            );
        }
    }
}

/// Uncorrelated samples bring every case of every seam; corners shared by levels are the same.
#[test]
fn noise_at_every_sample_is_watertight_at_any_mix_of_levels() {
    let field = antipode_terrain::Field::new(0, flat());
    let mut random = Random(31);
    for (round, coarseness) in [(0, 1.0), (1, 4.0)] {
        let levels = random_levels(3, &mut random);
        let block = Block::new(IVec3::ZERO, &levels, |index, level| {
            let coord = ChunkCoord {
                chart: ChartId::FIRST,
                index,
            };
            let samples = Samples::from_fn_at(level, |local| {
                let at = coord.origin() + local;
                let seed = (at.x + 1000.0 * at.y + 1e6 * at.z + 1e8) as u64 + round;
                let mut own = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
                own.unit();
                // Now and then exactly zero.
                (own.between(-coarseness, coarseness) as f32).trunc()
                    + if round == 0 {
                        own.between(-1.0, 1.0) as f32
                    } else {
                        0.0
                    }
            });
            antipode_terrain::march(&samples, &field, coord)
        });
        assert!(block.assert_watertight(f64::INFINITY) > 200_000);
    }
}

/// A ball over eight chunks: closed whatever the levels, of the ball's volume, and turned outward.
#[test]
fn a_ball_over_chunks_of_any_levels_is_closed_and_holds_its_volume() {
    let field = antipode_terrain::Field::new(0, flat());
    let (centre, radius) = (DVec3::new(31.0, 33.5, 30.2), 25.0);
    let mut random = Random(3);
    for _ in 0..12 {
        let levels = random_levels(2, &mut random);
        let block = Block::new(IVec3::ZERO, &levels, |index, level| {
            let coord = ChunkCoord {
                chart: ChartId::FIRST,
                index,
            };
            let samples = Samples::from_fn_at(level, |local| {
                ((coord.origin() + local).distance(centre) - radius) as f32
            });
            antipode_terrain::march(&samples, &field, coord)
        });
        block.assert_watertight(f64::INFINITY);
        let mut volume = 0.0;
        for t in block.triangles() {
            let [a, b, c] = t.map(|p| p.as_dvec3() / 32768.0 - centre);
            volume += a.dot(b.cross(c)) / 6.0;
        }
        let expected = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let share = volume / expected;
        assert!((0.93..1.01).contains(&share), "{share} {levels:?}");
    }
}

#[test]
fn samples_at_shared_places_are_the_same_bit_for_bit_at_every_level() {
    let hyperbolic = strategy(Geometry::Hyperbolic, 40.0);
    for (seed, space) in [
        (0, flat()),
        (1, sphere()),
        (2, hyperbolic),
        (3, flat()),
        (4, sphere()),
    ] {
        let mut world = World::new(seed, space);
        let first = IVec3::new(-1, 0, 0);
        tunnel(&mut world, ChartId::FIRST, first, 2, &mut Random(seed));
        let coord = chunk(ChartId::FIRST, -1, 0, 0);
        let full = world.samples_at(coord, Level::FULL);
        assert!(full == world.samples(coord));
        for level in Level::ALL {
            let samples = world.samples_at(coord, level);
            let step = level.step_m() as usize;
            assert_eq!(samples.level(), level);
            // The coarser border lies farther out than the full one.
            for i in 1..samples.side() - 1 {
                for j in 1..samples.side() - 1 {
                    for k in 1..samples.side() - 1 {
                        let [x, y, z] = [i, j, k].map(|c| (c - 1) * step + 1);
                        let (ours, theirs) = (samples.get(i, j, k), full.get(x, y, z));
                        assert_eq!(ours.to_bits(), theirs.to_bits(), "{seed} {x} {y} {z}");
                    }
                }
            }
        }
    }
}

/// Seams lie in their faces, and are slivers: ground is much the same at the next level.
#[test]
fn seams_are_flat_slivers() {
    let world = World::new(4, flat());
    let mut seen = 0;
    for level in &Level::ALL[1..] {
        let coord = chunk(ChartId::FIRST, 3, 0, -2);
        let samples = world.field.samples_at(coord, *level);
        let mesh = antipode_terrain::march(&samples, &world.field, coord);
        for face in 0..6 {
            let mut area_m2 = 0.0;
            for t in mesh.seam_indices(face).as_chunks::<3>().0 {
                let corners = t.map(|n| mesh.vertices[n as usize]);
                let plane = CHUNK as u32 * (face % 2) as u32;
                assert!(corners.iter().all(|v| v.place()[face / 2] == plane));
                let [a, b, c] = corners.map(|v| v.position());
                area_m2 += 0.5 * (b - a).cross(c - a).length();
                seen += 1;
            }
            assert!(
                area_m2 < 8.0 * level.step_m() as f32,
                "{level:?} {face} {area_m2}"
            );
        }
    }
    assert!(seen > 100, "{seen}");
}
