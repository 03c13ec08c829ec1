//! Mesh extractors over a chunk's samples: 32 cells along an edge, the same ground as ours.

use antipode_terrain::{SAMPLES, Samples};
use fast_surface_nets::ndshape::ConstShape3u32;
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use isosurface::MarchingCubes;
use isosurface::distance::Signed;
use isosurface::extractor::IndexedVertices;
use isosurface::math::Vec3;
use isosurface::sampler::Sampler;
use isosurface::source::ScalarSource;
use transvoxel::prelude::{Block, BlockStarView, GenericMeshBuilder, VoxelVecBlock, extract};

use crate::terrain::clock::Rival;

/// Cells along an edge.
const CELLS: usize = 32;
/// Cells of a chunk.
const COUNT: usize = CELLS * CELLS * CELLS;

/// Every extractor over those samples; a run returns its triangles.
pub fn meshers(samples: &Samples) -> Vec<Rival<'_>> {
    vec![
        isosurface_cubes(samples),
        transvoxel_cubes(samples),
        surface_nets_of(samples),
    ]
}

/// Reads our samples at places from 0 to 1 along each axis, as `isosurface` asks for them.
struct Corners<'a>(&'a Samples);

impl ScalarSource for Corners<'_> {
    fn sample_scalar(&self, p: Vec3) -> Signed {
        // Sample 1 stands at the chunk's origin.
        let [i, j, k] = [p.x, p.y, p.z].map(|c| (c * CELLS as f32 + 1.5) as usize);
        Signed(self.0.get(i, j, k))
    }
}

fn isosurface_cubes(samples: &Samples) -> Rival<'_> {
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    let mut cubes = MarchingCubes::<Signed>::new(CELLS + 1);
    // It goes through one layer more than its grid has.
    let cells = CELLS * CELLS * (CELLS + 1);
    Rival::counting("isosurface 0.1.0-alpha.0", cells, move || {
        vertices.clear();
        indices.clear();
        let source = Corners(samples);
        let mut out = IndexedVertices::new(&mut vertices, &mut indices);
        cubes.extract(&Sampler::new(&source), &mut out);
        indices.len() / 3
    })
}

type Voxels = VoxelVecBlock<f32, f32>;

fn transvoxel_cubes<'a>(samples: &Samples) -> Rival<'a> {
    // To it what is over the threshold is inside.
    let density = |x: f32, y: f32, z: f32| {
        let [i, j, k] = [x, y, z].map(|c| (c + 1.5) as usize);
        -samples.get(i, j, k)
    };
    let voxels = Voxels::cache(&density, Block::new([0.0; 3], CELLS as f32, CELLS));
    Rival::counting("transvoxel 2.0", COUNT, move || {
        let view = BlockStarView::<f32, f32, &Voxels, &Voxels>::new_simple(&voxels);
        extract(&view, 0.0, GenericMeshBuilder::new())
            .build()
            .num_tris()
    })
}

fn surface_nets_of(samples: &Samples) -> Rival<'_> {
    type Shape = ConstShape3u32<35, 35, 35>;
    let mut buffer = SurfaceNetsBuffer::default();
    Rival::counting("fast-surface-nets 0.2", COUNT, move || {
        let last = [SAMPLES as u32 - 2; 3];
        surface_nets(samples.values(), &Shape {}, [0; 3], last, &mut buffer);
        buffer.indices.len() / 3
    })
}

#[cfg(test)]
mod tests {
    use antipode_terrain::march;

    use super::*;
    use crate::terrain::engine;

    #[test]
    fn rivals_mesh_the_same_ground_as_ours() {
        let (field, coord) = engine::surface_chunk(antipode_geometry::Geometry::Euclidean);
        let samples = field.samples(coord);
        let ours = march(&samples, &field, coord).triangles().len() as f64;
        for mut rival in meshers(&samples) {
            let found = (rival.work)();
            let share = found as f64 / ours;
            assert!(
                (0.9..1.1).contains(&share),
                "{}: {found} triangles, ours {ours}",
                rival.name
            );
        }
    }
}
