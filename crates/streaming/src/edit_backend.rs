//! The save of a world as the workers see it, and the translation between chunk names.

use std::error::Error;

use antipode_geometry::{ChartId, ChunkCoord};
use antipode_storage::{Batch, ChunkKey, StorageError, StoredGround, WorldStore};
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

/// Edits of a chunk and the bytes of its kinds, as stored.
pub(crate) type Stored = StoredGround;

/// Where edited chunks are kept. A trait, so that tests can make it fail.
pub(crate) trait EditBackend: Send + Sync {
    /// The chunks that have edits.
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure>;
    /// The edits of one chunk, and the bytes of the kinds laid there or none; `None` if it has no edits.
    fn chunk(&self, key: &ChunkKey) -> Result<Option<Stored>, ReadFault>;
    /// Writes everything or nothing, and returns once it is durable.
    fn commit(&self, batch: &Batch) -> Result<(), Failure>;
}

impl EditBackend for WorldStore {
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure> {
        Ok(self.edited_chunks()?)
    }

    fn chunk(&self, key: &ChunkKey) -> Result<Option<Stored>, ReadFault> {
        WorldStore::chunk_with_kinds(self, key).map_err(|error| match error {
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
        chart: coord.chart.number(),
        x: coord.index.x,
        y: coord.index.y,
        z: coord.index.z,
    }
}

/// The chunk of a stored name.
pub(crate) fn coord_of(key: &ChunkKey) -> ChunkCoord {
    let index = IVec3::new(key.x, key.y, key.z);
    ChunkCoord::new(ChartId::new(key.chart), index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_translate_both_ways() {
        for number in [0, 1, 2, u128::MAX] {
            let index = IVec3::new(-3, 0, i32::MAX);
            let coord = ChunkCoord::new(ChartId::new(number), index);
            assert_eq!(coord_of(&key_of(coord)), coord);
        }
    }
}
