//! Which of the game's ways of making land a world was begun with: it is made so for ever.

/// A way of making land. The numbers are those of saved worlds: none may ever change its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Generator {
    /// One biome a world, chosen by its seed.
    OneBiome = 1,
    /// Biomes by climate, whose shapes and colours go over into each other.
    #[default]
    Climates = 2,
}

impl Generator {
    /// All, the oldest first.
    pub const ALL: [Self; 2] = [Self::OneBiome, Self::Climates];

    /// The number that saves have for it.
    pub const fn number(self) -> u16 {
        self as u16
    }

    /// That of a number; `None` for those of later games.
    pub fn of_number(number: u16) -> Option<Self> {
        Self::ALL.into_iter().find(|it| it.number() == number)
    }
}
