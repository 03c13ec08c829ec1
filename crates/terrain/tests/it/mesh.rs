//! Meshes: closed, wound toward the air, and whole at the rim.

use std::collections::HashMap;

use crate::common::{Random, chunk, flat, sphere};
use antipode_geometry::ChartId;
use antipode_terrain::{ChunkMesh, Field, Generator, Level, Samples, march};
use glam::{DVec2, DVec3, Vec3};

/// Asserts that every edge inside the chunk lies in exactly two triangles, which run along it
/// in opposite ways, and every edge on a face of the chunk in one.
fn assert_watertight(mesh: &ChunkMesh) {
    let mut sides = HashMap::new();
    for t in mesh.triangles() {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            *sides.entry((a, b)).or_insert(0) += 1;
        }
    }
    for (&(a, b), &count) in &sides {
        let (p, q) = (
            mesh.vertices[a as usize].position(),
            mesh.vertices[b as usize].position(),
        );
        let on_face = (0..3).any(|n| p[n] == q[n] && (p[n] == 0.0 || p[n] == 32.0));
        assert_eq!(count, 1, "{p:?} {q:?}");
        assert_eq!(sides.contains_key(&(b, a)), !on_face, "{p:?} {q:?}");
    }
}

fn corners(mesh: &ChunkMesh, t: [u32; 3]) -> [Vec3; 3] {
    t.map(|n| mesh.vertices[n as usize].position())
}

fn normal(mesh: &ChunkMesh, index: u32) -> Vec3 {
    mesh.vertices[index as usize].normal()
}

/// Uncorrelated samples bring every case and every ambiguous face.
#[test]
fn meshes_of_random_samples_are_watertight() {
    let field = Field::new(0, flat());
    for seed in 0..3 {
        let random = std::cell::RefCell::new(Random(seed));
        let samples = Samples::from_fn(|_| random.borrow_mut().between(-1.0, 1.0) as f32);
        let mesh = march(&samples, &field, chunk(ChartId::FIRST, 0, 0, 0));
        assert!(mesh.triangles().len() > 50_000);
        assert_watertight(&mesh);
    }
}

/// Samples of exactly zero put vertices on the lattice, where triangles could vanish.
#[test]
fn ground_through_samples_gives_no_empty_triangles() {
    let field = Field::new(0, flat());
    let random = std::cell::RefCell::new(Random(9));
    let samples = Samples::from_fn(|_| random.borrow_mut().between(-2.0, 2.0).round() as f32);
    let flat_ground = Samples::from_fn(|p| (p.y - 16.0) as f32);
    for samples in [samples, flat_ground] {
        let mesh = march(&samples, &field, chunk(ChartId::FIRST, 0, 0, 0));
        assert_watertight(&mesh);
        for &t in mesh.triangles() {
            let [a, b, c] = corners(&mesh, t);
            assert!((b - a).cross(c - a).length() > 1e-7, "{a} {b} {c}");
        }
    }
}

#[test]
fn a_ball_is_closed_round_and_faces_outward() {
    let field = Field::new(0, flat());
    let centre = DVec3::new(15.3, 16.1, 16.7);
    let samples = Samples::from_fn(|p| (p.distance(centre) - 11.0) as f32);
    let mesh = march(&samples, &field, chunk(ChartId::FIRST, 0, 0, 0));
    assert_watertight(&mesh);
    let centre = centre.as_vec3();
    let mut volume = 0.0;
    for &t in mesh.triangles() {
        let [a, b, c] = corners(&mesh, t);
        let face = (b - a).cross(c - a);
        assert!(face.dot(a + b + c - 3.0 * centre) > 0.0, "wound inward");
        volume += (a - centre).dot((b - centre).cross(c - centre)) / 6.0;
        for n in t {
            let outward = (mesh.vertices[n as usize].position() - centre).normalize();
            assert!(normal(&mesh, n).dot(outward) > 0.999);
        }
    }
    let expected = 4.0 / 3.0 * std::f32::consts::PI * 11.0_f32.powi(3);
    assert!(
        (volume / expected - 1.0).abs() < 0.01,
        "{volume} {expected}"
    );
}

/// The area of a mesh, and of that what faces away from where its normals point.
fn turned_away(mesh: &ChunkMesh) -> (f32, f32) {
    let (mut area, mut wrong) = (0.0, 0.0);
    for &t in mesh.triangles() {
        let [a, b, c] = corners(mesh, t);
        let face = (b - a).cross(c - a);
        let smooth = normal(mesh, t[0]) + normal(mesh, t[1]) + normal(mesh, t[2]);
        area += face.length();
        if face.dot(smooth) <= 0.0 {
            wrong += face.length();
        }
    }
    (area, wrong)
}

/// Edges of floors and mouths are sharp, and what lies across one has a normal between.
#[test]
fn walls_of_caves_face_the_air_their_normals_point_to() {
    let field = Field::made_by(Generator::Climates, 41, flat());
    let (mut area, mut wrong) = (0.0, 0.0);
    for n in 0..12 * 12 * 2 {
        let coord = chunk(ChartId::FIRST, n % 12 - 6, n / 144, n / 12 % 12 - 6);
        let of = turned_away(&march(&field.samples(coord), &field, coord));
        (area, wrong) = (area + of.0, wrong + of.1);
    }
    println!("{wrong} of {area}");
    assert!(area > 1e5 && wrong < 1e-3 * area, "{wrong} of {area}");
}

#[test]
fn ground_faces_the_air_its_normals_point_to() {
    for space in [flat(), sphere()] {
        let field = Field::made_by(Generator::OneBiome, 13, space);
        let coord = chunk(ChartId::SECOND, -1, 0, 0);
        let mesh = march(&field.samples(coord), &field, coord);
        let (area, wrong) = turned_away(&mesh);
        assert!(area > 500.0 && wrong < 1e-4 * area, "{wrong} of {area}");
        for (n, vertex) in mesh.vertices.iter().enumerate() {
            assert!((normal(&mesh, n as u32).length() - 1.0).abs() < 1e-3);
            let kind = antipode_terrain::Kind::of_byte(vertex.colour[3] & 0x1f);
            assert!(vertex.parts >> 15 == 0 && kind.is_some_and(|kind| !kind.is_deep()));
        }
    }
}

#[test]
fn the_sphere_is_meshed_to_its_reach_and_no_farther() {
    let space = sphere();
    let reach = space.domain(ChartId::FIRST).radius_m().unwrap() + 8.0;
    let field = Field::new(2, space);
    let mut farthest: f64 = 0.0;
    for (x, z) in [(1, 0), (1, 1), (-2, 0), (0, 1)] {
        let coord = chunk(ChartId::FIRST, x, 0, z);
        let mesh = march(&field.samples(coord), &field, coord);
        for &t in mesh.triangles() {
            let nearest = corners(&mesh, t)
                .map(|p| {
                    let p = coord.origin() + p.as_dvec3();
                    DVec2::new(p.x, p.z).length()
                })
                .into_iter()
                .fold(f64::MAX, f64::min);
            assert!(nearest <= reach + 1.5, "{nearest}");
            farthest = farthest.max(nearest);
        }
    }
    assert!(farthest > reach - 1.0, "{farthest}");
}

#[test]
fn solid_and_empty_blocks_have_no_mesh() {
    let field = Field::new(0, flat());
    for value in [-1.0, 0.0, 1.0, f32::NAN] {
        let mesh = march(
            &Samples::from_fn(|_| value),
            &field,
            chunk(ChartId::FIRST, 0, 0, 0),
        );
        assert!(mesh.is_empty() && mesh.vertices.is_empty());
    }
}

/// A graphics card keeps the last few corners it worked out; in a good order most of a
/// triangle's are among them, and no corner costs much more than one working out.
#[test]
fn triangles_come_where_their_corners_were_just_used() {
    let field = Field::new(10, flat());
    for level in Level::ALL {
        let (mut misses, mut corners) = (0, 0);
        for x in 0..4 {
            let coord = chunk(ChartId::FIRST, x, 0, 1);
            let mesh = march(&field.samples_at(coord, level), &field, coord);
            let mut kept = std::collections::VecDeque::new();
            for &index in mesh.surface_indices() {
                if !kept.contains(&index) {
                    kept.push_front(index);
                    kept.truncate(32);
                    misses += 1;
                }
            }
            corners += mesh
                .surface_indices()
                .iter()
                .max()
                .map_or(0, |&last| last + 1);
        }
        let share = f64::from(misses) / f64::from(corners);
        println!("{level:?}: {share:.3}");
        assert!(share < 1.5, "{level:?}: {share}");
    }
}

/// A number of the shape of meshes: FNV-1a (Fowler, Noll and Vo).
fn number_of(meshes: impl Iterator<Item = ChunkMesh>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |value: u32| {
        for byte in value.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    };
    for mesh in meshes {
        for vertex in &mesh.vertices {
            vertex.place().into_iter().for_each(&mut take);
            let [x, z] = vertex.octahedral.map(|c| u32::from(c.cast_unsigned()));
            take(x << 16 | z);
        }
        mesh.indices.iter().copied().for_each(&mut take);
    }
    hash
}

/// As they were made before ground had kinds: worlds that have been begun keep their shape.
#[test]
fn shapes_are_those_from_before_kinds() {
    let expected = [SHAPES_FLAT, SHAPES_SPHERE];
    for (space, expected) in [flat(), sphere()].into_iter().zip(expected) {
        let meshes = (0..5).flat_map(|seed| {
            let field = Field::made_by(Generator::OneBiome, seed, space.clone());
            let at = [(0, 0, 0), (-1, 0, 1), (0, 1, 0)];
            let chunks = at.map(|(x, y, z)| chunk(ChartId::FIRST, x, y, z));
            let meshes = chunks.map(|coord| {
                Level::ALL.map(|level| march(&field.samples_at(coord, level), &field, coord))
            });
            meshes.into_iter().flatten()
        });
        assert_eq!(number_of(meshes), expected, "{space:?}");
    }
}

const SHAPES_FLAT: u64 = 6_619_755_865_306_741_308;
const SHAPES_SPHERE: u64 = 15_457_065_172_061_456_322;
