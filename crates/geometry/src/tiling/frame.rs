//! The frame of a tile, fixed once and for all, and the tiles beside it.

use super::{Golden, Isometry, Side, Tile, TilePath, TilingError};

/// A tile with its frame as seen from the root, which is what neighbours are found by.
///
/// **The parent** of a tile is the neighbour nearest to the root; of two that are as near, over sides that follow each
/// other in a quarter turn from x to z, the first. (More than two are so of the root only.) **The frame** has its -x towards
/// the parent. So it depends on nothing but the tile. The root's is that of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frame {
    at: Isometry,
}

/// A neighbour of a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crossed {
    /// The neighbour.
    pub frame: Frame,
    /// The neighbour's side at the edge that both share.
    pub back: Side,
}

impl Frame {
    /// The root's.
    pub const ROOT: Self = Self {
        at: Isometry::IDENTITY,
    };

    /// The frame of the tile that a move takes the root to, however it turns it.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] beyond [`Tile::REACH`].
    pub(super) fn facing_root(at: &Isometry) -> Result<Self, TilingError> {
        Tile::at(at.columns()[2]).in_reach()?;
        Ok(Self {
            at: at.turned(turns_to_face_root(at)),
        })
    }

    /// The tile.
    pub fn tile(&self) -> Tile {
        Tile::at(self.at.columns()[2])
    }

    /// From coordinates in this frame to those in the root's.
    pub fn to_root(&self) -> &Isometry {
        &self.at
    }

    /// The tile over a side, and which of its sides is at the shared edge. From its frame to this one leads
    /// [`Isometry::crossing`] of the two sides. It costs some additions.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] beyond [`Tile::REACH`].
    pub fn neighbour(&self, side: Side) -> Result<Crossed, TilingError> {
        let at = self.at.turned(side.number()).stepped()?;
        Tile::at(at.columns()[2]).in_reach()?;
        let turns = turns_to_face_root(&at);
        Ok(Crossed {
            frame: Self {
                at: at.turned(turns),
            },
            back: Side::PARENT.turned(4 - turns),
        })
    }

    /// The parent, and which of its sides this tile lies over; `None` for the root. It is nearer to the root and so in reach.
    pub fn parent(&self) -> Option<Crossed> {
        if *self == Self::ROOT {
            return None;
        }
        self.neighbour(Side::PARENT).ok()
    }

    /// From coordinates in another tile's frame to those in this one, exactly: cast it once, by [`Isometry::lorentz`]. It
    /// costs about 0.6 microseconds.
    /// Between tiles nearby its numbers are small, however far both are from the root.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] for tiles more than 86 radii from each other.
    pub fn between(&self, other: &Self) -> Result<Isometry, TilingError> {
        self.at.inverse()?.times(&other.at)
    }

    /// The sides to cross from the root to this tile, from parent to child. It walks up all parents, at about
    /// 0.1 microseconds each.
    ///
    /// # Errors
    /// None: every tile has its path.
    pub fn path(&self) -> Result<TilePath, TilingError> {
        let mut sides = Vec::new();
        let mut frame = *self;
        while let Some(up) = frame.parent() {
            sides.push(up.back);
            frame = up.frame;
        }
        sides.reverse();
        TilePath::new(sides)
    }
}

/// How many quarter turns bring a tile's -x towards its parent; the root's own axes to those of the world.
///
/// The neighbour over side k has `w' = phi w + (bottom row of the matrix along that side)`, so that only the first two
/// numbers u, v of the bottom row are compared: sides 0 to 3 have u, v, -u and -v. Side 2 is the parent's if -u is the
/// least, if v is not as little as it, and -v may be: `-u < v <= u`. A quarter turn makes (v, -u) of them.
fn turns_to_face_root(at: &Isometry) -> u8 {
    let [x, z, w] = at.columns();
    let (mut u, mut v) = (x[2], z[2]);
    if w[2] == Golden::ONE {
        // A turn of the root: where x goes tells by how much, and (x, -z) of that column is what it is to become.
        (u, v) = (x[0], x[1].negated());
    }
    for turns in 0..4 {
        if v <= u && u.negated() < v {
            return turns;
        }
        (u, v) = (v, u.negated());
    }
    0
}
