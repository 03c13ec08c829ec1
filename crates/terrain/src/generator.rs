//! Which of the game's ways of making land a world was begun with: it is made so for ever.

/// A way of making land. The numbers are those of saved worlds: none may ever change its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Generator {
    /// One biome a world, chosen by its seed.
    OneBiome = 1,
    /// Biomes by climate, whose shapes and colours go over into each other.
    Climates = 2,
    /// The same land, with plants and stones on it.
    #[default]
    Planted = 3,
}

impl Generator {
    /// All, the oldest first.
    pub const ALL: [Self; 3] = [Self::OneBiome, Self::Climates, Self::Planted];

    /// Whether its worlds have biomes by climate, and caves; else one biome.
    pub const fn has_climates(self) -> bool {
        !matches!(self, Self::OneBiome)
    }

    /// Whether anything grows and stands on its land.
    pub const fn has_things(self) -> bool {
        matches!(self, Self::Planted)
    }

    /// The number that saves have for it.
    pub const fn number(self) -> u16 {
        self as u16
    }

    /// That of a number; `None` for those of later games.
    pub fn of_number(number: u16) -> Option<Self> {
        Self::ALL.into_iter().find(|it| it.number() == number)
    }
}
