//! What is not, or not to be had, in the tiling.

/// Why there is no such number, tile, path or place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TilingError {
    /// A number too large to be kept exactly, or a tile beyond [`Tile::REACH`](super::Tile::REACH).
    #[error("this is too far from the middle of the world; go back towards it")]
    OutOfReach,
    /// Three numbers that are no tile's centre.
    #[error("no tile has its centre there; the record of this place is damaged")]
    NoTile,
    /// Steps, bytes or a number that are no tile's path from the root.
    #[error("no tile has that path; the record of this place is damaged")]
    NoPath,
    /// A vector that is no point of the space.
    #[error("these four coordinates are no point of the space")]
    NoPoint,
    /// More tiles than were allowed for.
    #[error("there are more than {most} tiles as near as that; ask for fewer rings")]
    TooMany {
        /// How many were allowed.
        most: usize,
    },
}
