//! Marching cubes beside other extractors, a chunk from field to mesh at every level, and its collider.

use antipode_geometry::{ChunkCoord, Geometry};
use antipode_physics::TerrainCollider;
use antipode_terrain::{ChunkMesh, Field, march};

use super::clock::{Rival, least_ms, race};
use super::engine::{name, surface_chunk};
use super::row::{Bar, Judged, Row, table};
use super::versus::{Least, versus};
use crate::{Effort, Section};

/// Cells of a chunk.
const CELLS: usize = 32 * 32 * 32;
/// Most nanoseconds a cell.
const CELL_NS: f64 = 20.0;
/// Most milliseconds from field to mesh.
const CHUNK_MS: f64 = 2.0;
/// Most nanoseconds a triangle of a collider.
const COLLIDER_NS: f64 = 1000.0;
/// Times that an extractor must take of ours, by the beginning of its name.
const LEAST: [Least<'_>; 2] = [("isosurface", &[6.0]), ("transvoxel", &[2.0])];

/// The section of the meshes' figures.
pub fn mesh_section(effort: Effort) -> Section {
    let (field, coord) = surface_chunk(Geometry::Euclidean);
    let samples = field.samples(coord);
    let ours = || march(&samples, &field, coord);
    let mut rivals = vec![Rival::new("ours", CELLS, ours)];
    #[cfg(feature = "rivals")]
    rivals.extend(super::rivals::meshers(&samples));
    let ns = race(&mut rivals, effort);
    let mut rows = vec![
        Row::new(
            "marching cubes, a cell",
            "Euclidean surface chunk",
            ns[0],
            "ns",
        )
        .bar(Bar::AtMost(CELL_NS), Judged::InFull)
        .note(format!("{} triangles", ours().triangles().len())),
    ];
    for geometry in [Geometry::Euclidean, Geometry::Spherical] {
        rows.extend(chunk_rows(geometry, effort));
    }
    Section::new(
        "terrain-mesh",
        "Meshes",
        METHOD,
        [
            table("Chunks", &rows, effort),
            versus("Meshing, a cell", &rivals, &ns, 1, &LEAST),
        ],
    )
}

fn chunk_rows(geometry: Geometry, effort: Effort) -> Vec<Row> {
    let (field, coord) = surface_chunk(geometry);
    let mesh = chunk(&field, coord);
    let case = format!("{} surface chunk", name(geometry));
    let (positions, triangles) = (mesh.positions(), mesh.triangles());
    let build = || TerrainCollider::build(&positions, triangles);
    let collider = race(&mut [Rival::new("", triangles.len(), build)], effort)[0];
    vec![
        Row::new(
            "chunk, field to mesh",
            &case,
            least_ms(effort, || chunk(&field, coord)),
            "ms",
        )
        .bar(Bar::AtMost(CHUNK_MS), Judged::InFull)
        .note(format!("{} triangles", triangles.len())),
        Row::new("collider, a triangle", &case, collider, "ns")
            .bar(Bar::AtMost(COLLIDER_NS), Judged::InFull),
    ]
}

fn chunk(field: &Field, coord: ChunkCoord) -> ChunkMesh {
    march(&field.samples(coord), field, coord)
}

const METHOD: [&str; 2] = [
    "One chunk of 32 by 32 by 32 cells whose surface runs through it. Every extractor is given the same samples, has its buffers made before where its interface allows that, and makes the same ground; all take turns and the least of each is shown. Ours makes shared vertices with normals from the field and colours by biome, height and slope, quantised for the graphics card; isosurface shared vertices without either; transvoxel vertices with normals; fast-surface-nets one vertex a cell, with normals that are not normalised and without colours, a different and simpler surface that is shown for its speed and not judged.",
    "From field to mesh is what a worker does for a chunk nobody has changed: samples and mesh. A collider is the physics' tree over its triangles.",
];
