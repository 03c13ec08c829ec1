//! The tiles about a tile.

use std::collections::HashSet;

use super::{Frame, Side, TilingError};

/// The tiles at 0, 1, ... `depth` steps over edges from a tile, one list for each number of steps, always in the same
/// order. There are 1, 4, 12, 28, 64, 148, 340, 780, 1792, 4116, and then 2.297 times as many with each step. Tiles out of
/// reach are left out.
///
/// # Errors
/// [`TilingError::TooMany`] where there would be more than `most` in all: nothing is done past these.
pub fn rings(about: &Frame, depth: usize, most: usize) -> Result<Vec<Vec<Frame>>, TilingError> {
    let mut known = HashSet::from([about.tile()]);
    let mut rings = vec![vec![*about]];
    for _ in 0..depth {
        let mut next = Vec::new();
        for frame in rings.last().into_iter().flatten() {
            for side in Side::ALL {
                let Ok(over) = frame.neighbour(side) else {
                    continue;
                };
                if known.insert(over.frame.tile()) {
                    next.push(over.frame);
                }
            }
            if known.len() > most {
                return Err(TilingError::TooMany { most });
            }
        }
        rings.push(next);
    }
    Ok(rings)
}
