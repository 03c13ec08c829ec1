//! The chunks that updates are about, and the cost of updates for the game.

use std::time::Duration;

use antipode_geometry::ChunkCoord;

use crate::api::{Chunk, Update};

/// What the game itself spends on a byte of a delivered mesh (upload and insertion), nanoseconds,
/// counted against the budget of [`Streamer::poll`](crate::Streamer::poll): about a gigabyte a second.
const GAME_NS_PER_BYTE: usize = 1;

/// What the game itself spends on an update.
pub(crate) fn game_cost(update: &Update) -> Duration {
    let bytes =
        |chunk: &Chunk| size_of_val(&*chunk.mesh.vertices) + size_of_val(&*chunk.mesh.indices);
    let bytes = match update {
        Update::Loaded(chunk) => bytes(chunk),
        Update::Edited(chunks) => chunks.iter().map(bytes).sum(),
        Update::Solid { .. }
        | Update::Unloaded(_)
        | Update::Moved { .. }
        | Update::Undone(_)
        | Update::Saved
        | Update::SaveFailed(_)
        | Update::Problem(_) => 0,
    };
    Duration::from_nanos((bytes * GAME_NS_PER_BYTE) as u64)
}

/// Does the game put or take away a collider for it? That costs as much as a frame's other work.
pub(crate) fn is_solid(update: &Update) -> bool {
    matches!(update, Update::Solid { .. })
}

/// The chunks that an update tells of.
pub(crate) fn coords(update: &Update) -> Vec<ChunkCoord> {
    match update {
        Update::Loaded(chunk) => vec![chunk.coord],
        Update::Edited(chunks) => chunks.iter().map(|chunk| chunk.coord).collect(),
        Update::Solid { coord, .. } | Update::Unloaded(coord) => vec![*coord],
        Update::Moved { .. }
        | Update::Undone(_)
        | Update::Saved
        | Update::SaveFailed(_)
        | Update::Problem(_) => Vec::new(),
    }
}

/// Tells that no body is near a chunk any more.
pub(crate) fn softened(coord: ChunkCoord) -> Update {
    Update::Solid {
        coord,
        collider: None,
        samples: None,
    }
}
