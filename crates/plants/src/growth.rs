//! The kinds of small growth, and where each grows.

use antipode_terrain::Kind;

use crate::noise::Draw;

/// A kind of small growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Growth {
    /// Grass of the colour of its ground.
    Grass,
    /// A few stiff blades.
    DryGrass,
    /// White flowers.
    Daisy,
    /// Red flowers.
    Poppy,
    /// Blue flowers.
    Bellflower,
    /// Fronds under trees.
    Fern,
    /// Reeds of wet land.
    Reed,
    /// Mushrooms.
    Mushroom,
    /// Crystals of caves.
    Crystal,
    /// Pale stones along the edges of squares, about the corners where five meet.
    Cobble,
}

/// How much of what grows in the open land of a biome, as shares of the places on ground that bears it.
struct Sward {
    biome: &'static str,
    /// Grass, on grass and half as much on moss.
    grass: f32,
    /// Flowers in their meadows, on grass.
    flowers: f32,
    /// Another growth, and its share where groves are dense and where they are not.
    other: Option<(Growth, [f32; 2])>,
}

const SWARDS: [Sward; 9] = [
    sward("forest", 0.62, 0.16, Some((Growth::Fern, [0.09, 0.01]))),
    sward("jungle", 0.70, 0.05, Some((Growth::Fern, [0.20, 0.06]))),
    sward("tundra", 0.22, 0.10, None),
    sward("wetland", 0.55, 0.08, Some((Growth::Reed, [0.14, 0.02]))),
    sward("desert", 0.10, 0.0, None),
    sward("shore", 0.35, 0.08, Some((Growth::Reed, [0.05, 0.0]))),
    sward("volcanic", 0.10, 0.0, None),
    sward("toxic", 0.25, 0.0, Some((Growth::Mushroom, [0.06, 0.02]))),
    sward("crags", 0.28, 0.12, None),
];

const fn sward(
    biome: &'static str,
    grass: f32,
    flowers: f32,
    other: Option<(Growth, [f32; 2])>,
) -> Sward {
    Sward {
        biome,
        grass,
        flowers,
        other,
    }
}

/// The share of places on sand, gravel, ash and clay that have dry grass.
const DRY: f32 = 0.015;
/// The shares of places on the floors of caves that have mushrooms and crystals.
const IN_CAVES: [f32; 2] = [0.02, 0.012];
/// Meadows are where noise is above this.
const MEADOW: f32 = 0.55;

impl Growth {
    /// Each kind, in the order of their numbers.
    pub const ALL: [Self; 10] = [
        Self::Grass,
        Self::DryGrass,
        Self::Daisy,
        Self::Poppy,
        Self::Bellflower,
        Self::Fern,
        Self::Reed,
        Self::Mushroom,
        Self::Crystal,
        Self::Cobble,
    ];

    /// Its number in meshes.
    pub const fn byte(self) -> u8 {
        self as u8
    }

    /// The kind of a number, if it is known.
    pub fn of_byte(byte: u8) -> Option<Self> {
        Self::ALL.get(usize::from(byte)).copied()
    }

    /// What grows at a place under the sky, on a kind of ground and in a biome, where groves are so dense.
    pub(crate) fn in_open(
        kind: Kind,
        biome: &str,
        dense: impl Fn() -> f32,
        draw: &mut Draw,
    ) -> Option<Self> {
        let sward = SWARDS.iter().find(|it| it.biome == biome)?;
        let [chance, which] = [draw.share(), draw.share()];
        let (grass, flowers) = match kind {
            Kind::Grass => (sward.grass, sward.flowers),
            Kind::Moss => (0.5 * sward.grass, 0.0),
            Kind::Sand | Kind::Gravel | Kind::Ash => {
                return (chance < DRY).then_some(Self::DryGrass);
            }
            Kind::Soil | Kind::Clay => (0.0, 0.0),
            _ => return None,
        };
        let most = sward.other.map_or(0.0, |(_, [in_groves, _])| in_groves);
        if chance >= most + flowers + grass {
            return None;
        }
        let dense = dense();
        let flowers = if dense > MEADOW { 0.0 } else { flowers };
        let (other, share) = match sward.other {
            Some((other, [in_groves, out])) => {
                (other, if dense > MEADOW { in_groves } else { out })
            }
            None => (Self::Grass, 0.0),
        };
        if chance < share {
            Some(other)
        } else if chance < share + flowers {
            Some([Self::Daisy, Self::Poppy, Self::Bellflower][((3.0 * which) as usize).min(2)])
        } else {
            (chance < share + flowers + grass).then_some(Self::Grass)
        }
    }

    /// What grows at a place of a cave.
    pub(crate) fn in_cave(kind: Kind, is_level: bool, draw: &mut Draw) -> Option<Self> {
        let [mushrooms, crystals] = IN_CAVES;
        let chance = draw.share();
        if !is_level || kind == Kind::Snow {
            None
        } else if chance < mushrooms {
            Some(Self::Mushroom)
        } else {
            let bears = matches!(
                kind,
                Kind::Rock | Kind::Slate | Kind::Basalt | Kind::Crystal
            );
            (bears && chance < mushrooms + crystals).then_some(Self::Crystal)
        }
    }
}

#[cfg(test)]
mod tests {
    use antipode_terrain::Biome;

    use super::*;

    #[test]
    fn every_biome_has_a_sward_and_every_number_its_kind() {
        for biome in Biome::all() {
            assert!(
                SWARDS.iter().any(|it| it.biome == biome.name()),
                "{}",
                biome.name()
            );
        }
        for growth in Growth::ALL {
            assert_eq!(Growth::of_byte(growth.byte()), Some(growth));
        }
        assert_eq!(Growth::of_byte(99), None);
    }
}
