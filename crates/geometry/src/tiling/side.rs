//! The four sides of a tile.

/// A side of a tile, in the order in which a quarter turn from x to z meets them: 0 towards +x of the tile's frame, 1
/// towards +z, 2 towards -x and 3 towards -z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Side(u8);

impl Side {
    /// All four, in order.
    pub const ALL: [Self; 4] = [Self(0), Self(1), Self(2), Self(3)];
    /// The side that a tile's parent lies over, for every tile but the root.
    pub const PARENT: Self = Self(2);

    /// The side so many quarter turns on from +x; whole turns do not count.
    pub const fn new(quarters: u8) -> Self {
        Self(quarters % 4)
    }

    /// Its number, 0 to 3.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// The side so many quarter turns further on.
    #[must_use]
    pub const fn turned(self, quarters: u8) -> Self {
        Self((self.0 + quarters % 4) % 4)
    }

    /// The side opposite.
    #[must_use]
    pub const fn opposite(self) -> Self {
        self.turned(2)
    }

    /// How many quarter turns lead from another side to this one, 0 to 3.
    pub const fn quarters_from(self, other: Self) -> u8 {
        (self.0 + 4 - other.0) % 4
    }
}
