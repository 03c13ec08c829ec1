//! The store of a world as the workers see it, and the translation between chunk names.

use std::error::Error;

use antipode_geometry::{ChartId, ChunkCoord};
use antipode_storage::{Batch, ChunkKey, StorageError, WorldStore};
use glam::IVec3;

/// A failure of the store, already a sentence for the player.
pub(crate) type Failure = Box<dyn Error + Send + Sync>;

/// Why a stored chunk could not be had.
pub(crate) enum ReadFault {
    /// The record cannot be believed and never will be.
    Damaged(Failure),
    /// The disk did not answer; the record may be sound.
    Unreadable(Failure),
}

/// Where edited chunks are kept. A trait, so that tests can make it fail.
pub(crate) trait Vault: Send + Sync {
    /// The chunks that have edits.
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure>;
    /// The edits of one chunk; `None` if it has none.
    fn chunk(&self, key: &ChunkKey) -> Result<Option<Vec<i16>>, ReadFault>;
    /// Writes everything or nothing, and returns once it is durable.
    fn commit(&self, batch: &Batch) -> Result<(), Failure>;
}

impl Vault for WorldStore {
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure> {
        Ok(self.edited_chunks()?)
    }

    fn chunk(&self, key: &ChunkKey) -> Result<Option<Vec<i16>>, ReadFault> {
        WorldStore::chunk(self, key).map_err(|error| match error {
            StorageError::Damaged { .. } => ReadFault::Damaged(error.into()),
            other => ReadFault::Unreadable(other.into()),
        })
    }

    fn commit(&self, batch: &Batch) -> Result<(), Failure> {
        Ok(WorldStore::commit(self, batch)?)
    }
}

/// The stored name of a chunk.
pub(crate) fn key_of(coord: ChunkCoord) -> ChunkKey {
    ChunkKey {
        chart: u8::from(coord.chart == ChartId::SECOND),
        x: coord.index.x,
        y: coord.index.y,
        z: coord.index.z,
    }
}

/// The chunk of a stored name; `None` for a chart that does not exist.
pub(crate) fn coord_of(key: &ChunkKey) -> Option<ChunkCoord> {
    let chart = match key.chart {
        0 => ChartId::FIRST,
        1 => ChartId::SECOND,
        _ => return None,
    };
    Some(ChunkCoord {
        chart,
        index: IVec3::new(key.x, key.y, key.z),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_translate_both_ways_and_strange_ones_are_refused() {
        let coord = ChunkCoord {
            chart: ChartId::SECOND,
            index: IVec3::new(-3, 0, i32::MAX),
        };
        assert_eq!(coord_of(&key_of(coord)), Some(coord));
        assert_eq!(
            coord_of(&ChunkKey {
                chart: 2,
                ..key_of(coord)
            }),
            None
        );
    }
}
