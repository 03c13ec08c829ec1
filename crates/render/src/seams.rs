//! Chooses the seams to draw: those beside a neighbour that is shown in finer detail.

use antipode_geometry::tiled::beside;
use antipode_geometry::{Atlas, ChunkCoord};
use antipode_terrain::Level;
use glam::IVec3;

use crate::land_mesh::SeamMask;

/// Steps to the neighbours, in the order of a mesh's seams.
pub const FACES: [IVec3; 6] = [
    IVec3::NEG_X,
    IVec3::X,
    IVec3::NEG_Y,
    IVec3::Y,
    IVec3::NEG_Z,
    IVec3::Z,
];

/// The seams of a mesh of a level in a chunk, where `finest` tells the finest level that is shown of another chunk,
/// if any. While a neighbour changes from one level to another both are shown, each by some of the pixels: a seam
/// that stands beside the coarser is a sliver in the plane of a face that the finer one covers.
pub fn mask(
    atlas: &dyn Atlas,
    coord: ChunkCoord,
    level: Level,
    finest: impl Fn(ChunkCoord) -> Option<Level>,
) -> SeamMask {
    let mut mask = 0;
    for (face, step) in FACES.into_iter().enumerate() {
        if finest(beside(atlas, coord, step)).is_some_and(|other| other < level) {
            mask |= 1 << face;
        }
    }
    mask
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Euclidean};

    use super::*;

    #[test]
    fn a_seam_is_drawn_beside_what_is_finer_only() {
        let [full, half, quarter, eighth] = Level::ALL;
        let coord = ChunkCoord {
            chart: ChartId::SECOND,
            index: IVec3::new(3, -2, 7),
        };
        let around = [
            Some(full),
            Some(half),
            Some(quarter),
            Some(eighth),
            None,
            Some(half),
        ];
        let finest = |other: ChunkCoord| {
            assert_eq!(other.chart, ChartId::SECOND);
            let step = other.index - coord.index;
            FACES
                .iter()
                .position(|f| *f == step)
                .and_then(|f| around[f])
        };
        assert_eq!(mask(&Euclidean, coord, full, finest), 0);
        assert_eq!(mask(&Euclidean, coord, half, finest), 0b00_0001);
        assert_eq!(mask(&Euclidean, coord, quarter, finest), 0b10_0011);
        assert_eq!(mask(&Euclidean, coord, eighth, finest), 0b10_0111);
    }
}
