//! Levels of detail of a chunk's mesh.

use antipode_geometry::CHUNK_CELLS;

/// Resolution of a chunk's mesh: cells of 1, 2, 4 or 8 metres. Coarser levels are greater.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Level(u8);

impl Level {
    /// Cells of one metre, as the ground is sampled, dug and walked on.
    pub const FULL: Self = Self(0);
    /// All levels, the finest first.
    pub const ALL: [Self; 4] = [Self(0), Self(1), Self(2), Self(3)];

    /// Metres along an edge of a cell: 1, 2, 4 or 8.
    pub const fn step_m(self) -> u32 {
        1 << self.0
    }

    /// Cells along an edge of a chunk: 32, 16, 8 or 4.
    pub const fn cells(self) -> usize {
        CHUNK_CELLS as usize >> self.0
    }

    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The level of twice the step, if there is one.
    pub const fn coarser(self) -> Option<Self> {
        match self.0 {
            level @ 0..3 => Some(Self(level + 1)),
            _ => None,
        }
    }

    /// The level of half the step, if there is one.
    pub const fn finer(self) -> Option<Self> {
        match self.0 {
            0 => None,
            level => Some(Self(level - 1)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_halve_cells_and_lead_to_each_other() {
        assert_eq!(Level::ALL.map(Level::step_m), [1, 2, 4, 8]);
        assert_eq!(Level::ALL.map(Level::cells), [32, 16, 8, 4]);
        for (n, level) in Level::ALL.into_iter().enumerate() {
            assert_eq!(level.index(), n);
            assert_eq!(level.coarser(), Level::ALL.get(n + 1).copied());
            assert_eq!(
                level.coarser().and_then(Level::finer).unwrap_or(level),
                level
            );
        }
        assert_eq!(Level::default(), Level::FULL);
        assert_eq!(Level::FULL.finer(), None);
    }
}
