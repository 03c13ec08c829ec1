//! What a chunk can hold, from bounds alone.

use antipode_geometry::ChunkCoord;
use glam::DVec2;

use crate::field::{Field, RIM_REACH_M};

/// What a chunk of untouched ground holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Content {
    /// Only air, or nothing that is ever drawn: no sample of the block is solid, or the
    /// chunk lies past the rim of its hemisphere.
    Air,
    /// Only ground: every sample of the block is solid.
    Solid,
    /// Possibly some surface.
    Surface,
}

/// Room for the rounding of `f32` sums of noise.
const ROUNDING_M: f64 = 1e-3;

impl Field {
    /// What the chunk holds before any edit, its border of one sample included. Decided from
    /// the noise's bounds, without sampling: `Air` and `Solid` are certain, `Surface` is not.
    pub fn content(&self, coord: ChunkCoord) -> Content {
        let (low, high) = self.ground_range_m();
        let bottom = f64::from(coord.index.y) * 32.0;
        if !self.within_rim(coord) || bottom - 1.0 > high + ROUNDING_M {
            Content::Air
        } else if bottom + 33.0 < low - ROUNDING_M {
            Content::Solid
        } else {
            Content::Surface
        }
    }

    /// Whether any cell of the chunk touches the part of its chart that is meshed.
    fn within_rim(&self, coord: ChunkCoord) -> bool {
        let Some(rim_m) = self.rim_m() else {
            return true;
        };
        let low = DVec2::new(f64::from(coord.index.x), f64::from(coord.index.z)) * 32.0;
        DVec2::ZERO.clamp(low, low + 32.0).length() <= rim_m + RIM_REACH_M
    }
}
