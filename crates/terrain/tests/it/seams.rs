//! A thousand edits at chunk corners leave no gap between chunks.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::common::{Random, World, flat, sphere};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord};
use antipode_terrain::{ChunkMesh, Generator, RIM_REACH_M, Stroke, march};
use glam::{DVec3, IVec3};

/// A vertex on a chunk's face: its place on the face, normal and colour, to the bit.
type Seen = ([u32; 3], [i16; 2], [u8; 4]);

/// A face of a chunk's cube.
struct Face {
    coord: ChunkCoord,
    axis: usize,
    /// 0 or 32, metres.
    level: f32,
    /// Turns edges round, so that the two sides of a face give equal lists.
    turn: bool,
    /// Past this distance from the pole the sphere's mesh ends, metres.
    reach_m: f64,
}

/// The edges of a mesh in a face, as they run, sorted.
fn face_edges(mesh: &ChunkMesh, face: &Face) -> Vec<(Seen, Seen)> {
    let Face {
        coord,
        axis,
        level,
        turn,
        reach_m,
    } = *face;
    let see = |n: u32| {
        let vertex = &mesh.vertices[n as usize];
        let mut place = vertex.place();
        place[axis] = 0;
        (place, vertex.octahedral, vertex.colour)
    };
    let on_face = |n: u32| {
        let position = mesh.vertices[n as usize].position();
        let place = coord.origin() + position.as_dvec3();
        position[axis] == level && place.x.hypot(place.z) <= reach_m
    };
    let mut edges = Vec::new();
    for t in mesh.triangles() {
        if t.iter().filter(|&&n| on_face(n)).count() < 2 {
            continue;
        }
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            if on_face(a) && on_face(b) {
                edges.push(if turn {
                    (see(b), see(a))
                } else {
                    (see(a), see(b))
                });
            }
        }
    }
    edges.sort_unstable();
    edges
}

/// Compares a chunk's faces with its six neighbours', and says how many edges they have.
fn assert_faces_match(
    meshes: &BTreeMap<ChunkCoord, ChunkMesh>,
    coord: ChunkCoord,
    reach_m: f64,
) -> usize {
    let mut edges = 0;
    for axis in 0..3 {
        for (step, level) in [(-1, 0.0), (1, 32.0)] {
            let mut index = coord.index;
            index[axis] += step;
            let neighbour = ChunkCoord {
                chart: coord.chart,
                index,
            };
            if let Some(other) = meshes.get(&neighbour) {
                let face = |coord, level, turn| Face {
                    coord,
                    axis,
                    level,
                    turn,
                    reach_m,
                };
                let ours = face_edges(&meshes[&coord], &face(coord, level, false));
                let theirs = face_edges(other, &face(neighbour, 32.0 - level, true));
                assert_eq!(ours, theirs, "between {coord:?} and {neighbour:?}");
                edges += ours.len();
            }
        }
    }
    edges
}

/// Digs and builds at random corners of 3 x 3 x 3 chunks, meshing again only the chunks that the
/// strokes name; every face of those must match after every edit, and at the end every
/// mesh must be the one made afresh.
fn edit_corners(mut world: World, chart: ChartId, count: usize, first: IVec3) {
    let space = Arc::clone(world.field.strategy());
    let mut random = Random(23);
    let mut meshes = BTreeMap::new();
    for n in 0..27 {
        let index = first + IVec3::new(n % 3, n / 3 % 3, n / 9);
        let coord = ChunkCoord { chart, index };
        meshes.insert(coord, march(&world.samples(coord), &world.field, coord));
    }
    let reach_m = space
        .domain(ChartId::FIRST)
        .radius_m()
        .map_or(f64::INFINITY, |rim_m| rim_m + RIM_REACH_M);
    let mut edges = 0;
    for _ in 0..count {
        let corner =
            [(); 3].map(|()| 32.0 * (1.0 + random.unit().round()) + random.between(-2.0, 2.0));
        let stroke = Stroke {
            centre: ChartPoint::new(chart, first.as_dvec3() * 32.0 + DVec3::from(corner)),
            radius_m: random.between(1.0, 10.0),
            amount: random.between(-6.0, 6.0) as f32,
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        };
        world.apply(&stroke);
        let again = stroke.remeshed(&*space);
        let again: BTreeSet<_> = again
            .into_iter()
            .filter(|c| meshes.contains_key(c))
            .collect();
        for &coord in &again {
            let mesh = march(&world.samples(coord), &world.field, coord);
            meshes.insert(coord, mesh);
        }
        for &coord in &again {
            edges += assert_faces_match(&meshes, coord, reach_m);
        }
    }
    assert!(edges > count * 50, "only {edges} edges were compared");
    for (&coord, mesh) in &meshes {
        assert!(
            *mesh == march(&world.samples(coord), &world.field, coord),
            "{coord:?} is stale"
        );
    }
}

#[test]
fn a_thousand_edits_at_chunk_corners_leave_no_gap() {
    edit_corners(
        World::new(17, flat()),
        ChartId::FIRST,
        1000,
        IVec3::new(-1, -1, 4),
    );
}

#[test]
fn edits_at_corners_near_the_equator_leave_no_gap() {
    edit_corners(
        World::new(17, sphere()),
        ChartId::SECOND,
        200,
        IVec3::new(0, -1, -2),
    );
}

#[test]
fn edits_at_corners_of_land_with_climates_and_caves_leave_no_gap() {
    for (seed, x) in [(17, 0), (18, 2)] {
        let world = World::made_by(Generator::Climates, seed, flat());
        let y = world
            .field
            .surface_height(ChartId::FIRST, 32.0 * f64::from(x), 0.0);
        let first = IVec3::new(x - 1, (y / 32.0).floor() as i32 - 2, -1);
        edit_corners(world, ChartId::FIRST, 200, first);
    }
}
