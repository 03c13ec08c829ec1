//! Views that say by rule how fine land is to be.

use super::*;

/// A picture in which a chunk's size goes by its distance from a place along x alone.
#[derive(Debug)]
pub struct Rings {
    pub x: i32,
    /// Chunks to a ring of one level.
    pub width: i32,
}

impl Detail for Rings {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        let ring = (coord.index.x - self.x).abs() / self.width;
        // One pixel is let pass; the levels' errors are a few decimetres.
        [1e3, 1.6, 0.9, 0.1][ring.min(3) as usize]
    }

    fn span_px(&self, _: ChunkCoord) -> f64 {
        100.0
    }

    fn tolerance_px(&self) -> f64 {
        1.0
    }
}

/// [`Rings`] in which chunks up to `gone` along x are too small to be seen.
#[derive(Debug)]
pub struct Vanishing {
    pub rings: Rings,
    pub gone: i32,
}

impl Detail for Vanishing {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        self.rings.pixels_per_metre(coord)
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        f64::from(u8::from(coord.index.x > self.gone)) * 100.0
    }

    fn tolerance_px(&self) -> f64 {
        self.rings.tolerance_px()
    }
}
