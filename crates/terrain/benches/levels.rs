//! How long a chunk's samples and its mesh take at every level, seams included, in a mesher that
//! is kept from chunk to chunk as a worker keeps it.

use std::hint::black_box;

use antipode_geometry::{ChartId, ChunkCoord, Geometry, strategy};
use antipode_terrain::{Field, Generator, Level, Mesher};
use divan::Bencher;
use glam::IVec3;

/// Cells along an edge of a chunk, by level.
const CELLS: [usize; 4] = [32, 16, 8, 4];

fn main() {
    divan::main();
}

/// A volcanic world, of four octaves, and a chunk that its surface runs through.
fn ground() -> (Field, ChunkCoord) {
    let coord = ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::ZERO,
    };
    (
        Field::made_by(Generator::OneBiome, 20, strategy(Geometry::Euclidean, 20.0)),
        coord,
    )
}

fn level(cells: usize) -> Level {
    let found = Level::ALL.into_iter().find(|level| level.cells() == cells);
    found.unwrap_or_default()
}

#[divan::bench(args = CELLS)]
fn samples(bencher: Bencher<'_, '_>, cells: usize) {
    let (field, coord) = ground();
    bencher.bench_local(|| field.samples_at(black_box(coord), level(cells)));
}

#[divan::bench(args = CELLS)]
fn mesh(bencher: Bencher<'_, '_>, cells: usize) {
    let (field, coord) = ground();
    let samples = field.samples_at(coord, level(cells));
    let mut mesher = Mesher::default();
    bencher.bench_local(|| mesher.march(black_box(&samples), &field, coord));
}
