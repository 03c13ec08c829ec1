//! Levels of detail of a chunk's mesh, and how far each is off.

use antipode_geometry::CHUNK_CELLS;

use crate::field::Field;
use crate::generator::Generator;

/// On the sphere ground is as much steeper as it is higher, and bolder where it is near the
/// middle of its range: there errors are this many times those of flat ground, per half range
/// of the ground over half of the relief (measured for radii of 16 to 256 m).
const SPHERE_SHARE: f64 = 3.2;
/// Steeper ground errs no more than this many times as much: it soon stands upright.
const SPHERE_MOST: f64 = 3.3;

/// How far ground of biomes by climate is off at 2, 4 and 8 m, metres, as `level_errors_m` of the table says of worlds of one: high
/// rock by so much in any space (measured over four worlds each, flat and of radii of 16 to 256 m), most other ground by half.
const CLIMATES_M: [f64; 3] = [0.42, 0.95, 1.8];

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

impl Field {
    /// How far the ground at a level may be from the full ground, metres: the 99th percentile
    /// of the distances from the full ground's vertices. Upright, vertices are farther off: ground turns
    /// over, and under an edge that moved by little lies nothing for long. Half of the vertices are within
    /// a ninth, a seventh and a sixth to a fifth of this. Untouched land only; of caves, and where players
    /// dug or built, as much as a whole cell may be lost.
    pub fn level_error_m(&self, level: Level) -> f64 {
        let coarse = level.index().checked_sub(1);
        let is_of_one = self.generator() == Generator::OneBiome;
        let errors_m = if is_of_one {
            self.alone().level_errors_m()
        } else {
            CLIMATES_M
        };
        let error_m = coarse.and_then(|coarse| errors_m.get(coarse));
        let error_m = error_m.copied().unwrap_or(0.0);
        if !is_of_one || self.strategy().limits().is_none() {
            return error_m;
        }
        error_m * (SPHERE_SHARE * self.relief().stretch()).min(SPHERE_MOST)
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
