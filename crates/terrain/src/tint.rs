//! What kinds of ground look like from afar: a colour of their own, and how much of it lies over the biome's.
//!
//! Meshes hold the colour with the tint in it, so that what lies between two vertices is between their colours, wherever
//! an edge is halved. The shaders know the same table, to part two kinds at a pixel.

use glam::Vec4;

use crate::kind::{Kind, SKIN, number_of};

/// `1 - normal.y` where the skin of untouched land begins to show the rock below it, and one by how much more it shows
/// nothing else: 42 and 57 degrees.
pub(crate) const STEEP: f32 = 0.26;
pub(crate) const PER_STEEPER: f32 = 5.0;

/// By numbers of kinds, colours times their shares, and the shares; and the same of what a steep face shows in their place.
static TINTS: [[Vec4; 2]; 32] = tints();

impl Kind {
    /// The kind's colour in linear light, 0 to 1, and the share of that, 0 to 1; the rest is the biome's.
    pub const fn tint(self) -> [f32; 4] {
        match self {
            Self::Grass => [0.125, 0.222, 0.050, 0.36],
            Self::Soil => [0.170, 0.108, 0.068, 0.30],
            Self::Sand => [0.560, 0.400, 0.220, 0.45],
            Self::Gravel => [0.235, 0.215, 0.200, 0.50],
            Self::Rock => [0.225, 0.205, 0.190, 0.35],
            Self::Ash => [0.085, 0.080, 0.085, 0.60],
            Self::Snow => [0.780, 0.830, 0.900, 0.93],
            Self::Moss => [0.090, 0.178, 0.038, 0.45],
            Self::Clay => [0.330, 0.165, 0.095, 0.50],
            Self::Basalt => [0.056, 0.053, 0.060, 0.60],
            Self::Slate => [0.150, 0.170, 0.200, 0.90],
            Self::Coal => [0.005, 0.005, 0.008, 1.0],
            Self::Copper => [0.268, 0.203, 0.131, 1.0],
            Self::Crystal => [0.212, 0.337, 0.720, 1.0],
            Self::Wood => [0.300, 0.178, 0.085, 0.95],
        }
    }
}

const fn tints() -> [[Vec4; 2]; 32] {
    let mut tints = [[Vec4::ZERO; 2]; 32];
    let mut n = 0;
    while n < Kind::ALL.len() {
        let kind = Kind::ALL[n];
        tints[kind.byte() as usize] = [weighted(kind), weighted(kind.where_steep())];
        n += 1;
    }
    tints
}

const fn weighted(kind: Kind) -> Vec4 {
    let [r, g, b, share] = kind.tint();
    Vec4::new(r * share, g * share, b * share, share)
}

/// The tint of a kind as the fourth byte of vertices says it, on ground that is so steep, 0 to 1
/// ([`STEEP`]): its colour times its share, and its share.
#[inline]
pub(crate) fn tint_of(byte: u8, steep: f32) -> Vec4 {
    let [own, rock] = TINTS[usize::from(number_of(byte)) % TINTS.len()];
    if byte < SKIN {
        return own;
    }
    own.lerp(rock, steep)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_ground_has_its_kinds_tint_and_steep_skin_that_of_rock() {
        for kind in Kind::ALL {
            let own = tint_of(kind.byte(), 0.9);
            assert_eq!(own, weighted(kind), "laid: {kind:?}");
            assert_eq!(tint_of(kind.byte() | SKIN, 0.0), own, "level: {kind:?}");
            let steep = tint_of(kind.byte() | SKIN, 1.0);
            assert_eq!(steep, weighted(kind.where_steep()));
        }
        assert_eq!(tint_of(0, 0.0), Vec4::ZERO);
    }
}
