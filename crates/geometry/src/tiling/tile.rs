//! A tile, known by its centre.

use super::{Frame, Golden, Isometry, Side, TilingError};

/// From the middle of a tile to that of an edge, in radii: half the way to the neighbour's, whose cosine is phi.
pub const APOTHEM: f64 = 0.530_637_530_952_517_8;
/// From the middle of an edge to its end, in radii: `cosh = cos(45 deg)/sin(36 deg)`, of the triangle of centre, edge and
/// corner with the angles 45, 90 and 36 degrees.
pub const HALF_EDGE: f64 = 0.626_869_662_906_177_8;
/// From the middle of a tile to a corner, in radii: `cosh = cot(45 deg) cot(36 deg)`.
pub const CORNER_DISTANCE: f64 = 0.842_482_081_462_007_5;
/// The area of a tile in square radii: what its four angles of 72 degrees lack of whole turns, `0.4 pi`.
pub const TILE_AREA: f64 = 0.4 * std::f64::consts::PI;
/// X/W along the edge of a tile towards +x, the tangent of [`APOTHEM`]: `phi^(-3/2)`.
///
/// The edge is where the centre is as far as the neighbour's: `W = phi W - sqrt(phi) X`, so `X/W = (phi - 1)/sqrt(phi)`.
pub const EDGE_TANH: f64 = 0.485_868_271_756_645_7;

/// A tile: its centre as seen from the root. Equal where it is the same tile, whichever way one came. In order, tiles
/// nearer to the root come first; the root is the least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Tile {
    // First, so that the derived order goes by the distance. It follows from the other two.
    w: Golden,
    x: Golden,
    z: Golden,
}

impl Tile {
    /// The tile that the world begins with.
    pub const ROOT: Self = Self {
        w: Golden::ONE,
        x: Golden::ZERO,
        z: Golden::ZERO,
    };
    /// A tile exists if w of its centre is `a + b phi` with b to `2^110`: to 77.74 radii from the root, which is 2344 m
    /// where tiles are 32 m wide, 4688 m where 64 m. All of these are at most [`MOST_STEPS`](super::MOST_STEPS) tiles from
    /// the root, and their neighbours are far within [`Golden::LIMIT`].
    pub const REACH: i128 = 1 << 110;

    /// The tile with its centre at x and z, in units of `sqrt(phi)` radii, and w: `w^2 = 1 + phi (x^2 + z^2)`.
    ///
    /// # Errors
    /// [`TilingError::NoTile`] where no tile has its centre there, [`TilingError::OutOfReach`] beyond
    /// [`REACH`](Self::REACH).
    pub fn new(x: Golden, z: Golden, w: Golden) -> Result<Self, TilingError> {
        let tile = Self::at([x, z, w]).in_reach()?;
        let back = |part: Golden| Ok(part.times_phi()?.negated());
        let square = Golden::dot([x, z, w], [back(x)?, back(z)?, w])?;
        if square != Golden::ONE || w <= Golden::ZERO {
            return Err(TilingError::NoTile);
        }
        tile.frame()?;
        Ok(tile)
    }

    /// The tile at a centre that is known to be one.
    pub(super) fn at([x, z, w]: [Golden; 3]) -> Self {
        Self { w, x, z }
    }

    /// The tile, if it exists.
    pub(super) fn in_reach(self) -> Result<Self, TilingError> {
        if self.w.parts()[1] > Self::REACH {
            return Err(TilingError::OutOfReach);
        }
        Ok(self)
    }

    /// Its centre (x, z, w) as seen from the root.
    pub fn centre(self) -> [Golden; 3] {
        [self.x, self.z, self.w]
    }

    /// Its frame, from nothing but the centre. It costs about 0.1 microseconds for each radius from the root; whoever has
    /// a frame of a tile nearby goes by [`Frame::neighbour`], which costs less than that at any distance.
    ///
    /// From the root the tile lies over the side that its centre is most in the direction of; so from the neighbour
    /// there; and so on. Each neighbour is nearer to it, since the edge crossed is where both are as near.
    ///
    /// # Errors
    /// [`TilingError::NoTile`] where the steps end beside the centre: never for a tile.
    pub fn frame(self) -> Result<Frame, TilingError> {
        let [mut x, mut z, mut w] = self.centre();
        let mut at = Isometry::IDENTITY;
        while w != Golden::ONE {
            let side = towards(x, z);
            (x, z) = match side.number() {
                0 => (x, z),
                1 => (z, x.negated()),
                2 => (x.negated(), z.negated()),
                _ => (z.negated(), x),
            };
            // The inverse of Isometry::STEP: x' = phi x - w, w' = phi w - phi x.
            let next = w.minus(x)?.times_phi()?;
            x = x.times_phi()?.minus(w)?;
            if next >= w {
                return Err(TilingError::NoTile);
            }
            w = next;
            at = at.turned(side.number()).stepped()?;
        }
        Frame::facing_root(&at)
    }
}

/// The side that a place lies most towards.
fn towards(x: Golden, z: Golden) -> Side {
    let size = |part: Golden| part.max(part.negated());
    let (axis, along) = if size(x) >= size(z) { (0, x) } else { (1, z) };
    if along >= Golden::ZERO {
        Side::new(axis)
    } else {
        Side::new(axis).opposite()
    }
}
