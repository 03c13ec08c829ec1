//! The way from the root to a tile, for saves.

use super::number::{MOST_STEPS, Walker};
use super::{Frame, Side, TilingError};

const STEPS_IN_BYTE: usize = 4;
const BYTES: usize = MOST_STEPS.div_ceil(STEPS_IN_BYTE);

/// The sides to cross from the root to a tile, each in the frame of the tile that it is left by, from parent to child.
/// Every tile in reach has one path, and no two have the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TilePath {
    steps: u8,
    /// Two bits a step, the first steps in the lowest bits of the first byte; 0 behind the last step.
    packed: [u8; BYTES],
}

impl TilePath {
    /// The root's.
    pub const ROOT: Self = Self {
        steps: 0,
        packed: [0; BYTES],
    };

    /// The path over these sides.
    ///
    /// # Errors
    /// [`TilingError::NoPath`] where one of them does not lead to a child, or where they are more than
    /// [`MOST_STEPS`](super::MOST_STEPS).
    pub fn new(sides: impl IntoIterator<Item = Side>) -> Result<Self, TilingError> {
        let mut path = Self::ROOT;
        let mut walker = Walker::ROOT;
        for side in sides {
            walker = walker.over(side).ok_or(TilingError::NoPath)?;
            let at = usize::from(path.steps);
            let byte = path.packed.get_mut(at / STEPS_IN_BYTE);
            *byte.ok_or(TilingError::NoPath)? |= side.number() << shift(at);
            path.steps += 1;
        }
        if path.len() > MOST_STEPS {
            return Err(TilingError::NoPath);
        }
        Ok(path)
    }

    /// How many steps it has: how many edges are between the root and the tile at least.
    pub fn len(&self) -> usize {
        self.steps.into()
    }

    /// Whether it is the root's.
    pub fn is_empty(&self) -> bool {
        self.steps == 0
    }

    /// The sides, beginning at the root.
    pub fn sides(&self) -> impl Iterator<Item = Side> + '_ {
        let step = |at: usize| Side::new(self.packed[at / STEPS_IN_BYTE] >> shift(at) & 3);
        (0..self.len()).map(step)
    }

    /// The tile there, with its frame.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] where it is beyond [`Tile::REACH`](super::Tile::REACH). Each step is looked at, so that a
    /// path that were none would be [`TilingError::NoPath`].
    pub fn frame(&self) -> Result<Frame, TilingError> {
        let mut frame = Frame::ROOT;
        for side in self.sides() {
            let next = frame.neighbour(side)?;
            if next.back != Side::PARENT {
                return Err(TilingError::NoPath);
            }
            frame = next.frame;
        }
        Ok(frame)
    }

    /// The path in at most 28 bytes: the number of steps, then two bits a step, the first in the lowest bits.
    pub fn to_bytes(&self) -> Vec<u8> {
        let used = self.len().div_ceil(STEPS_IN_BYTE);
        let mut bytes = vec![self.steps];
        bytes.extend(self.packed.iter().take(used));
        bytes
    }

    /// What [`to_bytes`](Self::to_bytes) made.
    ///
    /// # Errors
    /// [`TilingError::NoPath`] for any other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, TilingError> {
        let (&steps, packed) = bytes.split_first().ok_or(TilingError::NoPath)?;
        let side = |at: usize| {
            let byte = packed.get(at / STEPS_IN_BYTE).copied().unwrap_or(0);
            Side::new(byte >> shift(at) & 3)
        };
        let path = Self::new((0..steps.into()).map(side))?;
        // Bytes too few or too many, and bits behind the last step.
        if path.to_bytes() == bytes {
            Ok(path)
        } else {
            Err(TilingError::NoPath)
        }
    }
}

fn shift(step: usize) -> usize {
    2 * (step % STEPS_IN_BYTE)
}
